"""How far the generated C can be from the exact result: measured, at generation time.

Every routine is run over the working domain in each precision exactly as the C will run, and again
with more bits. The largest difference found, where it was found, and a bound of four times that go
into the header. A test holds the compiled C to the bound on fresh points.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.double_double import DoubleDouble
from turnbuckle.codegen.evaluate import (
    DOUBLE,
    FLOAT,
    Arithmetic,
    Result,
    double_for,
    evaluate,
    extended,
)
from turnbuckle.codegen.item import Item, cost
from turnbuckle.codegen.samples import Sampler
from turnbuckle.model.machine import Machine

Array = NDArray[np.float64]

#: Points tried at first, and again around the worst ones in every round of the search.
FIRST_POINTS, ROUND_POINTS, ROUNDS = 8192, 2048, 3
#: New points around each of the worst.
NEIGHBOURS = 16
#: Operations times points that one search may take at first; costly functions get fewer ...
MOST_WORK = 4e7
#: ... but no fewer than these.
FEWEST_POINTS = 128
#: The stated bound over the worst error found.
MARGIN = 4.0


@dataclass(frozen=True)
class WorstCase:
    """Largest error found for one output, in its unit, and the arguments it was found at."""

    error: float
    unit: str
    place: tuple[tuple[str, tuple[float, ...]], ...]

    @property
    def bound(self) -> float:
        """What the header promises."""
        return MARGIN * self.error


@dataclass(frozen=True)
class Accuracy:
    """Worst cases of a routine: by output, then by precision."""

    results: dict[str, dict[str, WorstCase]] = field(default_factory=dict)
    key: str = ""
    """Names the measurement: the same method, machine and operations have the same key."""


def measure(machine: Machine, routine: Item, seed: int = 1) -> Accuracy:
    """Search the working domain for the largest errors of a routine."""
    sampler = Sampler(machine, seed, affordable(routine, FIRST_POINTS))
    function = routine.function
    points = [sampler.argument(function.name, a.name, a.size) for a in function.inputs]
    results: dict[str, dict[str, WorstCase]] = {output.name: {} for output in function.outputs}
    for arithmetic in (DOUBLE, FLOAT):
        worst = Search(routine, arithmetic, seed).run(points)
        for output, case in zip(function.outputs, worst, strict=True):
            results[output.name][arithmetic.name] = case
    return Accuracy(results)


def affordable(routine: Item, points: int) -> int:
    """How many of some points a function is tried at: fewer where it is costly."""
    operations = sum(cost(routine).values())
    share = min(1.0, MOST_WORK / max(operations * FIRST_POINTS, 1))
    return max(int(share * points), min(points, FEWEST_POINTS))


class Search:
    """Random search with refinement around the worst points."""

    def __init__(self, routine: Item, arithmetic: Arithmetic, seed: int) -> None:
        self.routine = routine
        self.arithmetic = arithmetic
        self.random = np.random.default_rng(seed)
        outputs = routine.function.outputs
        self.worst = [WorstCase(0.0, output.unit, ()) for output in outputs]

    def run(self, points: list[Array]) -> list[WorstCase]:
        """Worst case of every output."""
        points = self.representable(points)
        spread = [np.ptp(p, axis=0) for p in points]
        errors = self.errors(points)
        self.keep(points, errors)
        for round_number in range(ROUNDS):
            points = self.near_the_worst(points, errors, spread, 0.1 ** (round_number + 1))
            errors = self.errors(points)
            self.keep(points, errors)
        return self.worst

    def representable(self, points: list[Array]) -> list[Array]:
        """Points as the precision can hold them, so that reading them is no error."""
        return [np.asarray(self.arithmetic.number(p), dtype=float) for p in points]

    def near_the_worst(
        self, points: list[Array], errors: Array, spread: list[Array], scale: float
    ) -> list[Array]:
        """New points around those with the largest errors."""
        count = affordable(self.routine, ROUND_POINTS) // NEIGHBOURS
        leaders = np.argsort(-errors.max(axis=1), kind="stable")[:count]
        chosen = np.repeat(leaders, NEIGHBOURS)
        moved = []
        for p, width in zip(points, spread, strict=True):
            noise = self.random.standard_normal((len(chosen), p.shape[1]))
            keep = self.random.random((len(chosen), p.shape[1])) < 0.5
            low, high = (p.min(axis=0), p.max(axis=0)) if p.size else (0.0, 0.0)
            candidate = np.clip(p[chosen] + scale * width * noise, low, high)
            moved.append(np.where(keep, p[chosen], candidate))
        return self.representable(moved)

    def errors(self, points: list[Array]) -> Array:
        """Error of every output at every point (count, outputs), 0 where the function refuses."""
        typed = [np.asarray(self.arithmetic.number(p)) for p in points]
        computed = evaluate(self.routine, typed, self.arithmetic)
        exact = self.exact(points)
        usable = accepted(self.routine, computed) & agreed(computed, exact)
        columns = []
        for got, wanted in zip(computed.outputs, exact.outputs, strict=True):
            gap = np.zeros(len(points[0]))
            for a, b in zip(got, wanted, strict=True):
                gap = np.maximum(gap, difference(a, b))
            columns.append(np.where(usable & np.isfinite(gap), gap, 0.0))
        return np.stack(columns, axis=1)

    def exact(self, points: list[Array]) -> Result:
        """The same with so many more bits that its own error does not count."""
        epsilon = self.arithmetic.epsilon
        more = extended(epsilon) if self.arithmetic is DOUBLE else double_for(epsilon)
        return evaluate(self.routine, points, more)

    def keep(self, points: list[Array], errors: Array) -> None:
        """Remember where each output was worst."""
        names = [argument.name for argument in self.routine.function.inputs]
        for output, column in enumerate(errors.T):
            k = int(column.argmax())
            if column[k] > self.worst[output].error:
                place = tuple(
                    (name, tuple(float(x) for x in p[k]))
                    for name, p in zip(names, points, strict=True)
                )
                self.worst[output] = WorstCase(float(column[k]), self.worst[output].unit, place)


def accepted(routine: Item, result: Result) -> NDArray[np.bool_]:
    """Points at which no fault is reported."""
    fine = np.ones(1, dtype=bool)
    for verdict, holds in zip(routine.function.verdicts, result.verdicts, strict=True):
        if verdict.is_fault:
            fine = fine & ~holds
    return fine


def agreed(computed: Result, exact: Result) -> NDArray[np.bool_]:
    """Points at which both report the same; where they do not, a border runs through the error."""
    same = np.ones(1, dtype=bool)
    for got, wanted in zip(computed.verdicts, exact.verdicts, strict=True):
        same = same & (got == wanted)
    return same


def difference(computed: Array, exact: Array | DoubleDouble) -> Array:
    """|computed - exact| in double precision."""
    value = DoubleDouble(np.asarray(computed, dtype=np.float64))
    reference = exact if isinstance(exact, DoubleDouble) else DoubleDouble(exact)
    with np.errstate(invalid="ignore"):
        return np.abs((value - reference).high)
