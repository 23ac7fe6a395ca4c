"""Functions that go through a fixed table of subsets of the cables."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

from model.symbolic.function import Input, ModelFunction, judged_by_results, make_input

#: What a visit may read of its subset: those columns of the matrix, and their numbers from 0.
CHOSEN, NUMBERS = "chosen", "numbers"


@dataclass(frozen=True)
class Sweep:
    """`begin`, then `visit` for every subset of the columns of a matrix, then `finish`.

    The outputs of `begin` are the sweep's state. A visit takes arguments and state entries by name
    (`carried` makes the inputs), and what it wants of its subset (see `of_the_subset`); its outputs
    replace the state entries of the same name, and it cannot fail. `finish` takes arguments and
    state entries by name, and makes the results. `subsets` are rows of column numbers of the
    argument `matrix`.
    """

    name: str
    summary: str
    source: str
    begin: ModelFunction
    visit: ModelFunction
    finish: ModelFunction
    matrix: str
    subsets: tuple[tuple[int, ...], ...]


def subsets(count: int, size: int) -> tuple[tuple[int, ...], ...]:
    """All subsets of `size` of the numbers below `count`, in lexical order."""
    return tuple(combinations(range(count), size))


def of_the_subset(rows: int, size: int) -> tuple[Input, Input]:
    """Inputs of a visit: the chosen columns (rows x size) and their numbers (size)."""
    columns = make_input(CHOSEN, (rows, size), "1", [0.0], [0.0])
    numbers = make_input(NUMBERS, (size,), "1", [0.0], [0.0])
    return judged_by_results(columns), judged_by_results(numbers)


def scattered(numbers: Sequence[object], size: int) -> list[list[object]]:
    """Whether entry j of a subset is cable i: rows i below `size`."""
    return [[number == i for number in numbers] for i in range(size)]
