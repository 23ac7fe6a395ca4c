"""How far tensions must leave their least-norm values T0 to respect their bounds.

T = T0 + t keeps the wrench when t is in the null space of S, and |T| is least where |t| is: t is
the point nearest the origin of a polytope of dimension r = n - d, bounded by one slab
low_i <= t_i <= high_i a cable.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from turnbuckle.model.symbolic.function import EPSILON
from turnbuckle.model.symbolic.linear import cross, dot, factorise, multiply, subtract, transpose
from turnbuckle.model.symbolic.scalar import Matrix, Scalar, Vector, clamp, largest, smallest, where

#: Stands for an interval end that is not there; far beyond any tension, safe in single precision.
UNBOUNDED = 1e12
#: Lines whose normals differ by no more than this many EPSILON count as parallel.
PARALLEL = 16.0


#: A slab that is missed by less than so many times the slack is missed by rounding, in a corner of
#: more slabs than it takes: the multipliers there are not unique, and one of them says nothing.
BY_ROUNDING = 1024.0


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

    def seen_from(self, shift: Vector) -> "Slabs":
        """The same slabs for what is still to be added to a shift."""
        return Slabs(subtract(self.low, shift), subtract(self.high, shift), self.slack)

    def side(self, level: Scalar, number: int) -> Scalar:
        """The side of a slab that t_number = level is beyond, or `level` between them."""
        return clamp(level, self.low[number], self.high[number])

    def first_side(self, number: int) -> Scalar:
        """The side of a slab that zero is beyond by more than the slack, or zero."""
        side = self.side(ca.SX(0), number)
        return where(ca.fabs(side) > self.slack, side, 0)

    def excess(self, number: int, level: Scalar) -> Scalar:
        """By how much more than the slack t_number = level misses its slab."""
        low, high = self.relaxed()[number]
        return ca.fmax(low - level, level - high)


@dataclass(frozen=True)
class Nearest:
    """The least shift t, and how negative a multiplier of it is (0 at the optimum)."""

    shift: Vector
    misfit: Scalar


def reach(side: Scalar, share: Scalar) -> Scalar:
    """Multiple of a normal of squared length `share` that reaches a side.

    A tension that nothing can shift has a normal of rounding size; it is not reached, and the
    others are not shifted for it.
    """
    return side / ca.fmax(share, EPSILON)


@dataclass(frozen=True)
class Interval:
    """All x with low <= x <= high, and the reciprocal of the slope that it came from.

    `margin` is what the slack of the slab adds to either end, twice.
    """

    low: Scalar
    high: Scalar
    inverse: Scalar
    margin: Scalar


def interval(slope: Scalar, below: Scalar, above: Scalar, slack: Scalar) -> Interval:
    """All x with below <= slope x <= above, for bounds that are relaxed by `slack`."""
    flat = ca.fabs(slope) <= PARALLEL * EPSILON
    inverse = 1 / slope
    ends = below * inverse, above * inverse
    return Interval(
        where(flat, -UNBOUNDED, ca.fmin(*ends)),
        where(flat, UNBOUNDED, ca.fmax(*ends)),
        inverse,
        where(flat, 0, 2 * slack * ca.fabs(inverse)),
    )


@dataclass(frozen=True)
class Line:
    """A null space of dimension r = 1, spanned by `direction`."""

    direction: Vector

    def nearest(self, slabs: Slabs, count: int) -> Nearest:
        """The least shift; its multiplier has the right sign by construction."""
        if count == 0:
            return at_rest(len(self.direction))
        parts = [
            interval(slope, *bounds, slabs.slack)
            for slope, bounds in zip(self.direction[:count], slabs.relaxed()[:count], strict=True)
        ]
        low, high = largest([part.low for part in parts]), smallest([part.high for part in parts])
        position = ca.fmin(ca.fmax(0, low), high)
        return Nearest([position * x for x in self.direction], ca.SX(0))


@dataclass(frozen=True)
class Plane:
    """A null space of dimension r = 2, known by the products of the rows n_i of a basis of it.

    For an orthonormal basis `shares[i][k]` is n_i . n_k times `weight`, `slopes[i][k]` is n_i x n_k
    times the square root of `weight`.
    """

    shares: Matrix
    slopes: Matrix
    weight: Scalar

    def nearest(self, slabs: Slabs, count: int) -> Nearest:
        """The least shift, by Seidel's incremental scheme: see `incremental`."""
        return incremental(self, slabs, count, len(self.shares))

    def moved(self, slabs: Slabs, number: int, level: Scalar) -> Nearest:
        """Least-norm point on the side of slab `number` that `level` is beyond, among earlier."""
        side = slabs.side(level, number) if number else slabs.first_side(0)
        height = reach(side, self.shares[number][number])
        position, multiplier, free = self.slide(slabs, number, height)
        shift = [
            share * height + slope * position
            for share, slope in zip(self.shares[number], self.slopes[number], strict=True)
        ]
        shift[number] = side
        wrong = where(level < side, -multiplier, multiplier)
        counts = ca.logic_and(free, slabs.excess(number, level) > BY_ROUNDING * slabs.slack)
        return Nearest(shift, where(wrong > 0, where(counts, wrong, 0), 0))

    def nearest_from_farthest(self, slabs: Slabs) -> Nearest:
        """The least shift, from the line that is farthest from the origin; not always there.

        Every point within the slabs is at least as far as the farthest of their lines. So where
        that line meets them all, the optimum is on it: at its foot, or at the slab j that cuts the
        foot off. Were its multiplier negative there, the foot on j would lie beyond the farthest
        line and yet be nearer. Where the line meets no point of the others, the answer misses one
        of them: the caller must check.
        """
        count = len(self.shares)
        distances = []
        for i in range(count):
            side = slabs.side(ca.SX(0), i)
            distances.append(side * reach(side, self.shares[i][i]))
        return Nearest(
            knock_out(distances, [self.along_line(slabs, i) for i in range(count)]), ca.SX(0)
        )

    def along_line(self, slabs: Slabs, number: int) -> Vector:
        """The point of one slab's line that is nearest its foot within all other slabs."""
        height = reach(slabs.first_side(number), self.shares[number][number])
        others = [k for k in range(len(self.shares)) if k != number]
        shares, slopes, relaxed = self.shares[number], self.slopes[number], slabs.relaxed()
        feet = {k: shares[k] * height for k in others}
        parts = [
            interval(slopes[k], relaxed[k][0] - feet[k], relaxed[k][1] - feet[k], slabs.slack)
            for k in others
        ]
        low, high = largest([part.low for part in parts]), smallest([part.high for part in parts])
        position = ca.fmin(ca.fmax(0, low), high)
        shift = {k: feet[k] + slopes[k] * position for k in others}
        shift[number] = shares[number] * height
        return [shift[k] for k in range(len(self.shares))]

    def slide(self, slabs: Slabs, number: int, height: Scalar) -> tuple[Scalar, Scalar, Scalar]:
        """How far along its line, from its foot, the earlier slabs push the point of a slab.

        Returns (position along the line, multiplier of the slab, whether there is another point on
        the line: on a single one multipliers of either sign will do).
        """
        if number == 0:
            return ca.SX(0), self.weight * height, ca.SX(1)
        parts: list[tuple[Interval, Scalar]] = []
        for other, (low, high) in enumerate(slabs.relaxed()[:number]):
            share, slope = self.shares[number][other], self.slopes[number][other]
            part = interval(slope, low - share * height, high - share * height, slabs.slack)
            parts.append((part, share * part.inverse))
        position, tilt = innermost(parts)
        pushed = ca.fabs(position) > 0
        multiplier = self.weight * height - where(pushed, position * tilt, 0)
        return position, multiplier, has_room([part for part, _ in parts])


@dataclass(frozen=True)
class QuickPlane(Plane):
    """A plane whose nearest point is sought on the farthest line alone."""

    def nearest(self, slabs: Slabs, count: int) -> Nearest:
        """The least shift where it is on the farthest line; see `nearest_from_farthest`."""
        return self.nearest_from_farthest(slabs)


@dataclass(frozen=True)
class Polyhedron:
    """A null space of dimension r > 2, by the rows n_i of an orthonormal basis of it (n x r)."""

    rows: Matrix

    def nearest(self, slabs: Slabs, count: int) -> Nearest:
        """The least shift, by Seidel's incremental scheme: see `incremental`."""
        return incremental(self, slabs, count, len(self.rows))

    def moved(self, slabs: Slabs, number: int, level: Scalar) -> Nearest:
        """Least-norm point on the side of slab `number` that `level` is beyond, among earlier."""
        normal = self.rows[number]
        side = slabs.side(level, number) if number else slabs.first_side(0)
        height = reach(side, dot(normal, normal))
        foot = [dot(row, normal) * height for row in self.rows]
        across = factorise([normal]).null_space()
        rest = space_of([multiply(transpose(across), row) for row in self.rows])
        inner = rest.nearest(slabs.seen_from(foot), number)
        shift = [a + b for a, b in zip(foot, inner.shift, strict=True)]
        shift[number] = side
        return Nearest(shift, inner.misfit)


Space = Line | Plane | Polyhedron


def space_of(rows: Matrix) -> Space:
    """The null space with the rows n_i of an orthonormal basis (n x r)."""
    dimension = len(rows[0])
    if dimension == 1:
        return Line([row[0] for row in rows])
    if dimension == 2:
        shares = [[dot(a, b) for b in rows] for a in rows]
        return Plane(shares, [[cross(a, b) for b in rows] for a in rows], ca.SX(1))
    return Polyhedron(rows)


def incremental(space: Plane | Polyhedron, slabs: Slabs, count: int, size: int) -> Nearest:
    """The least shift within the first `count` of `size` slabs, each taken once.

    A slab that the point so far violates must hold the optimum: it moves onto that slab's side, to
    the least-norm point that the earlier slabs leave (Seidel's scheme).
    """
    if count == 0:
        return at_rest(size)
    # Without earlier slabs the foot is the least-norm point, violated or not.
    best = Nearest(space.moved(slabs, 0, ca.SX(0)).shift, ca.SX(0))
    for number in range(1, count):
        level = best.shift[number]
        moved = space.moved(slabs, number, level)
        outside = slabs.excess(number, level) > 0
        best = Nearest(
            [where(outside, a, b) for a, b in zip(moved.shift, best.shift, strict=True)],
            where(outside, moved.misfit, best.misfit),
        )
    return best


def knock_out(scores: Vector, prizes: list[Vector]) -> Vector:
    """The prize of the largest score, by a tournament: few comparisons that wait for another."""
    if len(scores) == 1:
        return prizes[0]
    half = (len(scores) + 1) // 2
    first, second = (
        knock_out(scores[part], prizes[part]) for part in (slice(half), slice(half, None))
    )
    ahead = largest(scores[:half]) >= largest(scores[half:])
    return [where(ahead, a, b) for a, b in zip(first, second, strict=True)]


def at_rest(size: int) -> Nearest:
    """No slab, no shift."""
    return Nearest([ca.SX(0)] * size, ca.SX(0))


def has_room(parts: Sequence[Interval]) -> Scalar:
    """Whether some intervals have more than one point in common, rounding apart."""
    low = largest([part.low + part.margin for part in parts])
    return low < smallest([part.high - part.margin for part in parts])


def innermost(parts: Sequence[tuple[Interval, Scalar]]) -> tuple[Scalar, Scalar]:
    """Point nearest zero of some intervals, and the tilt of the one that holds it there."""
    (first, tilt), *others = parts
    low, high, low_tilt, high_tilt = first.low, first.high, tilt, tilt
    for part, tilt in others:
        low_tilt, low = where(part.low > low, tilt, low_tilt), ca.fmax(part.low, low)
        high_tilt, high = where(part.high < high, tilt, high_tilt), ca.fmin(part.high, high)
    position = ca.fmin(ca.fmax(0, low), high)
    return position, where(position > 0, low_tilt, high_tilt) if others else low_tilt
