"""Functions outside a machine's model, printed, compiled and loaded like the model's own."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import turnbuckle.codegen.compile
from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.bind import REALS, Generated, folder_of
from turnbuckle.codegen.composite import Item
from turnbuckle.codegen.evaluate import DOUBLE, FLOAT, evaluate, statuses
from turnbuckle.codegen.generate import render
from turnbuckle.codegen.model import Model
from turnbuckle.codegen.verify import call
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import Status

ARITHMETIC = {"double": DOUBLE, "float": FLOAT}


class OnlyItems(Model):
    """Functions that no other name stands for."""

    def aliases(self) -> dict[str, str]:
        return {}


@contextmanager
def optimised(level: str) -> Iterator[None]:
    """The compiler optimises less meanwhile: it is quicker, and no bit of a result changes."""
    flags = turnbuckle.codegen.compile.FLAGS
    turnbuckle.codegen.compile.FLAGS = (*flags, level)
    try:
        yield
    finally:
        turnbuckle.codegen.compile.FLAGS = flags


def printed(machine: Machine, items: list[Item]) -> Path:
    """The folder of the C of some functions, without a measured accuracy."""
    model = OnlyItems(machine, {"tension": items})
    files = render(model, {item.function.name: Accuracy() for item in items})
    return folder_of(machine, files)


def built(machine: Machine, items: list[Item], precision: str) -> Generated:
    """The same in one precision."""
    folder = printed(machine, items)
    with optimised("-O1"):
        return Generated(machine, folder, precision)


def answered(item: Item, generated: Generated, arguments: list[NDArray[Any]]) -> None:
    """The C answers what the evaluation says, to the bit, statuses included."""
    real = REALS[generated.precision]
    typed = [argument.astype(real) for argument in arguments]
    flat = [argument.reshape(len(argument), -1) for argument in typed]
    computed = evaluate(item, flat, ARITHMETIC[generated.precision])
    answer = call(generated.functions[item.function.name], typed)
    wanted = statuses(item, computed)
    assert np.all(answer["status"] == wanted)
    usable = (wanted <= Status.INFEASIBLE)[:, None]
    for output, entries in zip(item.function.outputs, computed.outputs, strict=True):
        values = np.where(usable, np.stack(entries, -1), output.fallback).astype(real)
        assert values.tobytes() == answer[output.name].tobytes()
