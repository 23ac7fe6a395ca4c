"""How far tensions must leave their least-norm values T0 to respect their bounds.

T = T0 + t keeps the wrench when t is in the null space of S, and |T| is least where |t| is: t is
the point nearest the origin of a polytope of dimension r = n - d, bounded by one slab
low_i <= t_i <= high_i a cable.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from model.symbolic.function import EPSILON
from model.symbolic.scalar import Matrix, Scalar, Vector, clamp, largest, smallest, where

#: Stands for an interval end that is not there; far beyond any tension, safe in single precision.
UNBOUNDED = 1e12
#: Lines whose normals differ by no more than this many EPSILON count as parallel.
PARALLEL = 16.0


@dataclass(frozen=True)
class Slabs:
    """low_i <= t_i <= high_i, each met up to `slack`.

    The slack keeps slabs that touch, or coincide, from pushing the point along their common line by
    the ratio of two roundings.
    """

    low: Vector
    high: Vector
    slack: Scalar

    def relaxed(self) -> list[tuple[Scalar, Scalar]]:
        """The bounds as far as they may be missed."""
        return [
            (low - self.slack, high + self.slack)
            for low, high in zip(self.low, self.high, strict=True)
        ]


@dataclass(frozen=True)
class Nearest:
    """The least shift t, and how negative a multiplier of it is (0 at the optimum)."""

    shift: Vector
    misfit: Scalar


@dataclass(frozen=True)
class Interval:
    """All x with low <= x <= high, and the reciprocal of the slope that it came from."""

    low: Scalar
    high: Scalar
    inverse: Scalar


def interval(slope: Scalar, below: Scalar, above: Scalar) -> Interval:
    """All x with below <= slope x <= above."""
    flat = ca.fabs(slope) <= PARALLEL * EPSILON
    inverse = 1 / slope
    ends = below * inverse, above * inverse
    return Interval(
        where(flat, -UNBOUNDED, ca.fmin(*ends)), where(flat, UNBOUNDED, ca.fmax(*ends)), inverse
    )


@dataclass(frozen=True)
class Line:
    """A null space of dimension r = 1, spanned by `direction`."""

    direction: Vector

    def nearest(self, slabs: Slabs) -> Nearest:
        """The least shift; its multiplier has the right sign by construction."""
        parts = [
            interval(slope, *bounds)
            for slope, bounds in zip(self.direction, slabs.relaxed(), strict=True)
        ]
        low, high = largest([part.low for part in parts]), smallest([part.high for part in parts])
        position = ca.fmin(ca.fmax(0, low), high)
        return Nearest([position * x for x in self.direction], ca.SX(0))


@dataclass(frozen=True)
class Plane:
    """A null space of dimension r = 2, known by the products of the rows n_i of a basis of it.

    For an orthonormal basis shares[i][k] is n_i . n_k times `weight`, and slopes[i][k] is n_i x n_k
    times the square root of `weight`.
    """

    shares: Matrix
    slopes: Matrix
    weight: Scalar

    def nearest(self, slabs: Slabs) -> Nearest:
        """The least shift, by Seidel's incremental scheme: every slab is taken once.

        A slab that the point so far violates must hold the optimum: it moves onto that slab's line,
        to the least-norm point that the earlier slabs leave.
        """
        # Without earlier slabs the foot is the least-norm point, violated or not.
        shift = self.moved(slabs, 0, ca.SX(0)).shift
        misfit = ca.SX(0)
        for number in range(1, len(shift)):
            low, high = slabs.relaxed()[number]
            level = shift[number]
            outside = ca.fmax(low - level, level - high) > 0
            moved = self.moved(slabs, number, level)
            shift = [where(outside, a, b) for a, b in zip(moved.shift, shift, strict=True)]
            misfit = where(outside, moved.misfit, misfit)
        return Nearest(shift, misfit)

    def moved(self, slabs: Slabs, number: int, level: Scalar) -> Nearest:
        """Least-norm point on the side of slab `number` that `level` is beyond, among earlier."""
        side = clamp(level, slabs.low[number], slabs.high[number])
        height = side / self.shares[number][number]
        position, multiplier = self.slide(slabs, number, height)
        shift = [
            share * height + slope * position
            for share, slope in zip(self.shares[number], self.slopes[number], strict=True)
        ]
        shift[number] = side
        return Nearest(shift, ca.fmax(0, where(level < side, -multiplier, multiplier)))

    def slide(self, slabs: Slabs, number: int, height: Scalar) -> tuple[Scalar, Scalar]:
        """How far along its line, from its foot, the earlier slabs push the point of a slab.

        Returns (position along the line, multiplier of the slab).
        """
        if number == 0:
            return ca.SX(0), self.weight * height
        parts: list[tuple[Interval, Scalar]] = []
        for other, (low, high) in enumerate(slabs.relaxed()[:number]):
            share, slope = self.shares[number][other], self.slopes[number][other]
            part = interval(slope, low - share * height, high - share * height)
            parts.append((part, share * part.inverse))
        position, tilt = innermost(parts)
        pushed = ca.fabs(position) > 0
        return position, self.weight * height - where(pushed, position * tilt, 0)


def innermost(parts: Sequence[tuple[Interval, Scalar]]) -> tuple[Scalar, Scalar]:
    """Point nearest zero of some intervals, and the tilt of the one that holds it there."""
    (first, tilt), *others = parts
    low, high, low_tilt, high_tilt = first.low, first.high, tilt, tilt
    for part, tilt in others:
        low_tilt, low = where(part.low > low, tilt, low_tilt), ca.fmax(part.low, low)
        high_tilt, high = where(part.high < high, tilt, high_tilt), ca.fmin(part.high, high)
    position = ca.fmin(ca.fmax(0, low), high)
    return position, where(position > 0, low_tilt, high_tilt) if others else low_tilt
