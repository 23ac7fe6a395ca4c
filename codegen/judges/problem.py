"""What a judge is asked, what it answers, and how answers are put together."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.arrays import Array
from turnbuckle.model.symbolic.function import Status

Bools = NDArray[np.bool_]
Wide: TypeAlias = Array

#: Where a search may fail, it may at one point in a hundred; the worst measured is one in 800.
GIVES_UP = 0.01
#: Units in the last place that a short chain of operations may lose, before conditioning.
ROUNDINGS = 64.0


@dataclass(frozen=True)
class Problem:
    """Arguments by name (count, *shape), wide, and the spacing of the precision that is judged.

    `closely`: whether to ask as well what a problem a hair off would answer, which takes many times
    as long and only ever allows more.
    """

    machine: Machine
    epsilon: float
    arguments: dict[str, Wide]
    solved: dict[str, Any] = field(default_factory=dict)
    closely: bool = True

    def __getitem__(self, name: str) -> Wide:
        return self.arguments[name]

    @property
    def count(self) -> int:
        """Number of points."""
        return len(next(iter(self.arguments.values())))

    def at_first(self) -> "Problem":
        """The same, not looked at closely."""
        return replace(self, closely=False)

    def among(self, rows: NDArray[np.intp]) -> "Problem":
        """Some of the points, looked at closely."""
        arguments = {name: values[rows] for name, values in self.arguments.items()}
        return Problem(self.machine, self.epsilon, arguments)


@dataclass(frozen=True)
class Expected:
    """Values by output; tolerance of each at every point; which statuses are right (count, 5).

    `beside_header`: whether the header's bound is added to the tolerance. `gives_up`: the share of
    points that may be reported as inaccurate where that is allowed.
    """

    values: dict[str, Wide]
    tolerance: dict[str, Wide]
    allowed: Bools
    beside_header: bool = True
    gives_up: float = 1.0

    def corrected(self, rows: NDArray[np.intp], closer: "Expected") -> "Expected":
        """What a closer look at some of the points expects there."""

        def patched(whole: Any, part: Any) -> Any:
            result = np.array(whole)
            result[rows] = part
            return result

        return replace(
            self,
            values={k: patched(v, closer.values[k]) for k, v in self.values.items()},
            tolerance={k: patched(v, closer.tolerance[k]) for k, v in self.tolerance.items()},
            allowed=patched(self.allowed, closer.allowed),
        )


Judge = Callable[[Problem], Expected]


def statuses(
    count: int, normal: dict[Status, Bools], faults: dict[Status, tuple[Bools, Bools]]
) -> Bools:
    """Right answers from where normal ones are possible and faults (must, may) be reported."""
    allowed = np.zeros((count, len(Status)), dtype=bool)
    forced = np.zeros(count, dtype=bool)
    for status, (must, may) in faults.items():
        allowed[:, status] |= may
        forced |= must
    for status, possible in normal.items():
        allowed[:, status] |= possible & ~forced
    return allowed


def always(count: int) -> Bools:
    """True everywhere."""
    return np.ones(count, dtype=bool)


def below(value: Wide, limit: float, slack: Wide | float) -> tuple[Bools, Bools]:
    """Where a value must, and where it may, be found below a limit; zero must in any case."""
    return value < limit - np.minimum(slack, limit * 3 / 4), value < limit + slack


def union(*pairs: tuple[Bools, Bools]) -> tuple[Bools, Bools]:
    """Where one of several faults must, and may, be reported."""
    return (
        np.logical_or.reduce([must for must, _ in pairs]),
        np.logical_or.reduce([may for _, may in pairs]),
    )


def extent(machine: Machine) -> float:
    """Largest coordinate [m]."""
    return float(max(machine.frame.size))


def levers(machine: Machine) -> Wide:
    """(d): 1 for a force or a translation, the platform's lever [m] for a moment or a rotation."""
    result = np.ones(machine.dof, np.longdouble)
    result[machine.space :] = machine.lever
    return result


def broadcast(value: Wide | float, like: Wide) -> Wide:
    """A tolerance per point, or for all, in the shape of a result."""
    per_point = np.asarray(value, dtype=np.longdouble)
    if per_point.ndim == like.ndim:
        return np.broadcast_to(per_point, like.shape)
    shape = per_point.shape + (1,) * (like.ndim - per_point.ndim if per_point.ndim else 0)
    return np.broadcast_to(per_point.reshape(shape), like.shape)


def expected(
    p: Problem, values: dict[str, Wide], slack: dict[str, Wide | float], allowed: Bools
) -> Expected:
    """Values with the given tolerances beside the header's, 0 where none is given."""
    tolerance = {name: broadcast(slack.get(name, 0.0), value) for name, value in values.items()}
    return Expected(values, tolerance, allowed)


def everywhere(p: Problem, **values: Wide) -> Expected:
    """A function that never refuses; constants that the generator folds are rounded once more."""
    slack = {
        name: 4 * p.epsilon * float(np.max(np.abs(v), initial=0)) for name, v in values.items()
    }
    ok = {Status.OK: always(p.count)}
    return expected(p, values, {**slack}, statuses(p.count, ok, {}))
