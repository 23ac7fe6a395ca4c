"""Runs things in forks of this process, so that what they do to the machine is gone afterwards."""

import gc
import os
import pickle
import traceback
from collections.abc import Callable
from typing import TypeVar

T = TypeVar("T")


class ForkError(Exception):
    """What was done in a fork failed; the text is its traceback."""


def in_a_fork(act: Callable[[], T]) -> T:
    """What `act` returns, done in a copy of this process."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        gc.disable()  # it would touch, and so copy, all memory that is shared
        os.close(reader)
        with open(writer, "wb") as pipe:
            pickle.dump(attempt(act), pipe)
        os._exit(0)
    os.close(writer)
    with open(reader, "rb") as pipe:
        answer = pipe.read()
    os.waitpid(child, 0)
    done, result = pickle.loads(answer)
    if not done:
        raise ForkError(result)
    return result  # type: ignore[no-any-return]


def attempt(act: Callable[[], T]) -> tuple[bool, T | str]:
    """Whether it was done, and its result or what went wrong."""
    try:
        return True, act()
    except Exception:
        return False, traceback.format_exc()
