"""The point nearest the origin that satisfies a list of slabs low_i <= n_i . z <= high_i.

With T = T0 + N z, T0 of least norm and N an orthonormal basis of the null space of S, the tension of
least norm within its bounds is where z is least: a polytope of dimension r = n - d.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from model.symbolic.function import EPSILON
from model.symbolic.linear import cross, dot
from model.symbolic.scalar import Matrix, Scalar, Vector, largest, sqrt, where

#: Stands for an interval end that is not there; far beyond any tension, safe in single precision.
UNBOUNDED = 1e12


@dataclass(frozen=True)
class Slabs:
    """low_i <= normals_i . z <= high_i, each met up to `slack`."""

    normals: Matrix
    low: Vector
    high: Vector
    slack: Scalar


@dataclass(frozen=True)
class Nearest:
    """The nearest point and by how much it fails the optimality conditions (0 when it does not)."""

    point: Vector
    misfit: Scalar


def nearest(slabs: Slabs) -> Nearest:
    """The point of least norm; the slabs must have a common point up to their slack."""
    dimension = len(slabs.normals[0])
    if dimension not in SOLVERS:
        raise KeyError(dimension)
    return SOLVERS[dimension](slabs)


def nearest_on_line(slabs: Slabs) -> Nearest:
    """r = 1: the slabs are intervals; optimal by construction."""
    low, high = ca.SX(-UNBOUNDED), ca.SX(UNBOUNDED)
    for (slope,), below, above in zip(slabs.normals, slabs.low, slabs.high, strict=True):
        end_low, end_high = interval(slope, below, above, slabs.slack)
        low, high = ca.fmax(low, end_low), ca.fmin(high, end_high)
    return Nearest([ca.fmin(ca.fmax(0, low), high)], ca.SX(0))


def interval(slope: Scalar, below: Scalar, above: Scalar, slack: Scalar) -> tuple[Scalar, Scalar]:
    """All t with below <= slope t <= above.

    Where t = 0 meets the slab up to its slack it is never excluded, so that slabs which touch, or
    coincide, do not push the point along the line by the ratio of two roundings.
    """
    met = ca.logic_and(below <= slack, above >= -slack)
    flat = ca.fabs(slope) <= EPSILON
    inverse = 1 / slope
    ends = below * inverse, above * inverse
    low, high = ca.fmin(*ends), ca.fmax(*ends)
    return (
        where(flat, -UNBOUNDED, where(met, ca.fmin(low, 0), low)),
        where(flat, UNBOUNDED, where(met, ca.fmax(high, 0), high)),
    )


@dataclass(frozen=True)
class Support:
    """The oriented normals of the at most two slabs that hold the point where it is."""

    first: Vector
    second: Vector


def nearest_in_polygon(slabs: Slabs) -> Nearest:
    """r = 2: Seidel's incremental scheme, the slabs taken once in their order.

    A slab that the point so far violates must hold the optimum: it moves onto that slab's line, to
    the least-norm point that the earlier slabs leave.
    """
    point: Vector = [ca.SX(0), ca.SX(0)]
    support = Support([ca.SX(0), ca.SX(0)], [ca.SX(0), ca.SX(0)])
    for number, normal in enumerate(slabs.normals):
        level = dot(normal, point)
        below = level < slabs.low[number] - slabs.slack
        above = level > slabs.high[number] + slabs.slack
        moved, held = move_to_line(slabs, number, below)
        outside = ca.logic_or(below, above)
        point = [where(outside, new, old) for new, old in zip(moved, point, strict=True)]
        support = Support(
            [where(outside, a, b) for a, b in zip(held.first, support.first, strict=True)],
            [where(outside, a, b) for a, b in zip(held.second, support.second, strict=True)],
        )
    return Nearest(point, cone_misfit(point, support))


def move_to_line(slabs: Slabs, number: int, below: Scalar) -> tuple[Vector, Support]:
    """Least-norm point on the violated side of slab `number` within the earlier slabs."""
    normal = slabs.normals[number]
    along = [-normal[1], normal[0]]
    side = where(below, slabs.low[number], slabs.high[number])
    height = side / dot(normal, normal)
    low, high = ca.SX(-UNBOUNDED), ca.SX(UNBOUNDED)
    holds_low: Vector = [ca.SX(0), ca.SX(0)]
    holds_high: Vector = [ca.SX(0), ca.SX(0)]
    for other in range(number):
        earlier = slabs.normals[other]
        at_foot = dot(earlier, normal) * height
        slope = dot(earlier, along)
        end_low, end_high = interval(
            slope, slabs.low[other] - at_foot, slabs.high[other] - at_foot, slabs.slack
        )
        uphill = [where(slope > 0, x, -x) for x in earlier]
        raises, lowers = end_low > low, end_high < high
        holds_low = [where(raises, a, b) for a, b in zip(uphill, holds_low, strict=True)]
        holds_high = [where(lowers, -a, b) for a, b in zip(uphill, holds_high, strict=True)]
        low, high = where(raises, end_low, low), where(lowers, end_high, high)
    position = ca.fmin(ca.fmax(0, low), high)
    point = [height * n + position * a for n, a in zip(normal, along, strict=True)]
    second = [
        where(position > 0, a, where(position < 0, b, 0))
        for a, b in zip(holds_low, holds_high, strict=True)
    ]
    return point, Support([where(below, x, -x) for x in normal], second)


def cone_misfit(point: Vector, support: Support) -> Scalar:
    """Distance of `point` from the cone of the supporting normals: zero at the optimum."""
    first, second = support.first, support.second
    turn = cross(first, second)
    swing = where(turn < 0, -1, 1)
    beyond_second = -swing * cross(point, second)
    beyond_first = -swing * cross(first, point)
    between = largest([distance(beyond_first, first), distance(beyond_second, second)])
    beside = largest([ca.fabs(cross(point, first)), -dot(point, first)])
    return where(dot(second, second) <= 0, distance(beside, first), between)


def distance(beyond: Scalar, normal: Sequence[Scalar]) -> Scalar:
    """Distance of a point beyond a line, from its product with the normal; 0 on the near side."""
    square = dot(normal, normal)
    return where(ca.logic_and(beyond > 0, square > 0), beyond / sqrt(square), 0)


SOLVERS = {1: nearest_on_line, 2: nearest_in_polygon}
