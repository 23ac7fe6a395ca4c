"""Processes that share the work of one command, and end with it, however that ends."""

import ctypes
import multiprocessing
import os
import signal
from concurrent.futures import ProcessPoolExecutor

_LIBC = ctypes.CDLL(None)
SET_DEATH_SIGNAL = 1
"""PR_SET_PDEATHSIG of prctl(2)"""


def forked_workers(count: int | None) -> ProcessPoolExecutor:
    """A pool of forks of this process, one for each of so many processors; None for all of them."""
    return ProcessPoolExecutor(
        count,
        mp_context=multiprocessing.get_context("fork"),
        initializer=end_with_parent,
        initargs=(os.getpid(),),
    )


def end_with_parent(parent: int) -> None:
    """End this process when its parent does, by SIGKILL as well; at once if it has already."""
    hear_of_death(signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)


def hear_of_death(number: int) -> None:
    """Get a signal when the thread ends that has started this process."""
    _LIBC.prctl(SET_DEATH_SIGNAL, number)
