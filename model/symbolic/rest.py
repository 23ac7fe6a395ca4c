"""Zero-wrench tensions T0 of planar cables by duality: guessed, and proven by their residual.

min |T| subject to S T = 0 within the bounds is solved by T = clip(S' m, T_min, T_max) for the
multiplier m with S T = 0. So whatever m a guess gives, a residual S T of rounding size proves it.
"""

from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from turnbuckle.model.symbolic.linear import (
    add_scaled,
    cross,
    dot,
    multiply,
    solve_positive,
    transpose,
)
from turnbuckle.model.symbolic.scalar import Matrix, Scalar, Vector, clamp, largest, where
from turnbuckle.model.symbolic.wrench_set import WrenchSet

#: Less than any product of forces and directions, in N; safe in single precision.
NEVER = -1e30


@dataclass(frozen=True)
class Guess:
    """Tensions that a multiplier m [N] stands for, of cables with the directions `columns`."""

    columns: Matrix
    multiplier: Vector
    low: float
    high: float

    @cached_property
    def wanted(self) -> Vector:
        """S' m: the tensions, were there no bounds."""
        return multiply(self.columns, self.multiplier)

    @cached_property
    def tension(self) -> Vector:
        """Tensions within their bounds [N]."""
        return [clamp(value, self.low, self.high) for value in self.wanted]

    @cached_property
    def residual(self) -> Vector:
        """S T, the wrench that should be zero [N]."""
        return multiply(transpose(self.columns), self.tension)

    @property
    def miss(self) -> Scalar:
        """Largest entry of the residual [N]."""
        return largest([ca.fabs(entry) for entry in self.residual])

    def improved(self) -> "Guess":
        """One Newton step on S clip(S' m) = 0, which only the cables off their bounds answer."""
        free = [
            where(ca.logic_and(value > self.low, value < self.high), 1, 0) for value in self.wanted
        ]
        weighted = [
            [weight * entry for entry in column]
            for weight, column in zip(free, self.columns, strict=True)
        ]
        normal = [[dot(a, b) for b in transpose(self.columns)] for a in transpose(weighted)]
        step, _ = solve_positive(normal, self.residual)
        return Guess(self.columns, add_scaled(self.multiplier, -1, step), self.low, self.high)


def from_neighbours(feasible: WrenchSet, rounding: Scalar) -> Guess:
    """The guess that at most two cables exceed T_min.

    With all at T_min the wrench -share times `middle` is left to be exerted. Were a third cable
    between the two that exceed T_min, s_k . m would exceed it as well: so the two are the
    neighbours of that wrench. Where it is nothing but `rounding` [N], none exceeds T_min.
    """
    columns, middle, low, high = feasible.columns, feasible.middle, feasible.low, feasible.high
    share = low / ((low + high) / 2)
    beside = feasible.heights(middle)
    along = [-dot(column, middle) for column in columns]
    left, right = (
        nearest([where(side, key, NEVER) for side, key in zip(sides, along, strict=True)], columns)
        for sides in ([x >= 0 for x in beside], [x < 0 for x in beside])
    )
    sine = cross(right, left)
    tensions = [
        low + share * cross(left, middle) / sine,
        low - share * cross(right, middle) / sine,
    ]
    inverse = [
        (tensions[0] * left[1] - tensions[1] * right[1]) / sine,
        (tensions[1] * right[0] - tensions[0] * left[0]) / sine,
    ]
    balanced = share * largest([ca.fabs(entry) for entry in middle]) <= rounding
    return Guess(columns, [where(balanced, 0, entry) for entry in inverse], low, high)


def nearest(keys: Vector, columns: Matrix) -> Vector:
    """The column with the largest key."""
    best, key = columns[0], keys[0]
    for other, column in zip(keys[1:], columns[1:], strict=True):
        ahead = other > key
        best = [where(ahead, a, b) for a, b in zip(column, best, strict=True)]
        key = ca.fmax(key, other)
    return best
