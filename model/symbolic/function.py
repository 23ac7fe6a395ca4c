"""What a function of the model is: inputs and outputs with shapes and units, and its faults."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from enum import IntEnum

import casadi as ca

from turnbuckle.model.symbolic.scalar import Matrix, Scalar, Vector, all_of


class Status(IntEnum):
    """What a generated function answers; the same numbers as `tb_status` in C."""

    OK = 0
    INFEASIBLE = 1
    SINGULAR = 2
    OUT_OF_DOMAIN = 3
    INACCURATE = 4


#: Unit roundoff spacing of real_t; becomes TB_EPSILON in C.
EPSILON = ca.SX.sym("TB_EPSILON")


@dataclass(frozen=True)
class Input:
    """An argument: `shape` entries in `unit` that the function refuses outside their bounds.

    Entry k must lie in [low[k], high[k]]; with `bounds_sum` the sum of all magnitudes must not
    exceed high[0] instead, which takes one comparison. Where `guarded` is false no entry is
    compared: `finite_results` refuses the argument if it leads to results that are not finite.
    """

    name: str
    shape: tuple[int, ...]
    unit: str
    low: tuple[float, ...]
    high: tuple[float, ...]
    symbols: ca.SX = field(repr=False)
    bounds_sum: bool = False
    guarded: bool = True

    @property
    def size(self) -> int:
        """Number of entries."""
        return len(self.low)

    def scalars(self) -> Vector:
        """The entries, row by row."""
        return [self.symbols[i] for i in range(self.size)]

    def rows(self) -> Matrix:
        """The entries of a matrix argument as a list of rows."""
        entries, columns = self.scalars(), self.shape[1]
        return [entries[i : i + columns] for i in range(0, self.size, columns)]


@dataclass(frozen=True)
class Output:
    """A result: `shape` entries in `unit`; `fallback` replaces it when the status is a fault."""

    name: str
    shape: tuple[int, ...]
    unit: str
    values: Vector = field(repr=False)
    fallback: float = 0.0

    @property
    def size(self) -> int:
        """Number of entries."""
        return len(self.values)


Port = Input | Output


@dataclass(frozen=True)
class Verdict:
    """`status` is answered where `condition` holds; a fault also replaces the outputs."""

    condition: Scalar = field(repr=False)
    status: Status
    meaning: str

    @property
    def is_fault(self) -> bool:
        """Whether the outputs must not be used."""
        return self.status is not Status.INFEASIBLE


def not_all_above(values: Vector, least: Scalar, meaning: str) -> Verdict:
    """TB_SINGULAR unless every value is known to exceed a limit; a NaN never is."""
    exceeds = all_of([value > least for value in values])
    return Verdict(ca.logic_not(exceeds), Status.SINGULAR, meaning)


def finite_results(values: Vector, most: float) -> Verdict:
    """TB_OUT_OF_DOMAIN where a result that all arguments reach is not known to be of some size."""
    fine = all_of([ca.fabs(value) <= most for value in values])
    return Verdict(
        ca.logic_not(fine),
        Status.OUT_OF_DOMAIN,
        f"an argument is not finite, or leads beyond {most:g}",
    )


@dataclass(frozen=True)
class Label:
    """A name and a source for an intermediate result, so that the C can be read."""

    name: str
    values: Vector = field(repr=False)
    note: str = ""


@dataclass(frozen=True)
class ModelFunction:
    """One function of the model: what it computes, by which equation, and when it refuses."""

    name: str
    summary: str
    source: str
    inputs: tuple[Input, ...]
    outputs: tuple[Output, ...]
    verdicts: tuple[Verdict, ...] = ()
    labels: tuple[Label, ...] = ()

    @property
    def ports(self) -> tuple[Port, ...]:
        """Arguments and results in order."""
        return (*self.inputs, *self.outputs)


@dataclass(frozen=True)
class Retry:
    """Functions that are tried in turn until one does not fail its own check, by their names.

    The first of `attempts` is asked first. Where it fails, the function `substitute` says whether
    the argument `argument` is feasible and what is served in its place: its outputs, the best one
    first. All attempts are asked with the first, and if they fail, with the next. The answer is
    TB_INFEASIBLE where something else was served.
    """

    name: str
    summary: str
    source: str
    attempts: tuple[str, ...]
    substitute: str
    argument: str


@dataclass(frozen=True)
class Repeat:
    """A loop of bounded length: `begin`, then `step` at most `most` times, then `finish`.

    The outputs of `begin` are the loop's state. A step takes arguments and state entries by name
    (`carried` makes the inputs); its outputs replace the state entries of the same name, and its
    last one, a scalar, is positive where that was the last step. `finish` takes arguments and state
    entries by name, and makes the results. A loop that is not done after its last step answers
    TB_INACCURATE, and a fault of any part ends it.
    """

    name: str
    summary: str
    source: str
    begin: ModelFunction
    step: ModelFunction
    finish: ModelFunction
    most: int


def carried(state: Sequence[Output]) -> tuple[Input, ...]:
    """Inputs that read entries of a loop's state: any numbers, the loop made them itself."""
    return tuple(
        judged_by_results(make_input(entry.name, entry.shape, entry.unit, [0.0], [0.0]))
        for entry in state
    )


def make_input(
    name: str, shape: tuple[int, ...], unit: str, low: Sequence[float], high: Sequence[float]
) -> Input:
    """An argument with one pair of bounds per entry, or one pair for all."""
    size = 1
    for extent in shape:
        size *= extent
    lows = tuple(low) * size if len(low) == 1 else tuple(low)
    highs = tuple(high) * size if len(high) == 1 else tuple(high)
    return Input(name, shape, unit, lows[:size], highs[:size], ca.SX.sym(name, size))


def bounded_input(name: str, shape: tuple[int, ...], unit: str, most: float) -> Input:
    """An argument whose magnitudes add up to at most `most` for every entry it has."""
    entry = make_input(name, shape, unit, [0.0], [0.0])
    bound = (most * entry.size,) * entry.size
    return replace(entry, low=tuple(-x for x in bound), high=bound, bounds_sum=True)


def judged_by_results(entry: Input) -> Input:
    """The argument without a guard of its own."""
    return replace(entry, guarded=False)


def vector_output(name: str, unit: str, values: Vector, fallback: float = 0.0) -> Output:
    """A result that is a plain vector."""
    return Output(name, (len(values),), unit, values, fallback)


def scalar_output(name: str, unit: str, value: Scalar) -> Output:
    """A result that is one number."""
    return Output(name, (), unit, [value])


def matrix_output(name: str, unit: str, rows: Matrix) -> Output:
    """A result that is a matrix, stored row by row."""
    columns = len(rows[0]) if rows else 0
    return Output(name, (len(rows), columns), unit, [entry for row in rows for entry in row])
