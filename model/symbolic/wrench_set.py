"""The wrenches that cables within their bounds can exert: a zonotope, here of planar forces.

Each cable i gives the pair of facets parallel to it. Seen from the middle V of the set, the wrench
of the mean tension on every cable, the pair reads |s_i x (W - V)| <= half_i, where half_i is half
the tension range times sum_j |s_i x s_j|.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from turnbuckle.model.symbolic.function import EPSILON
from turnbuckle.model.symbolic.linear import add_scaled, cross, dot, subtract
from turnbuckle.model.symbolic.polytope import PARALLEL
from turnbuckle.model.symbolic.scalar import (
    Matrix,
    Scalar,
    Vector,
    all_of,
    clamp,
    largest,
    smallest,
    total,
    where,
)

#: Larger than any squared distance in the wrench space, N^2; safe in single precision.
FAR = 1e30
#: A ray misses a facet by rounding within this many EPSILON of T_max.
RAY_SLACK = 16.0


@dataclass(frozen=True)
class WrenchSet:
    """Facets of the set {S T : low <= T <= high} for columns s_i in the plane."""

    columns: Matrix
    low: float
    high: float
    crosses: Matrix
    middle: Vector
    halves: Vector

    def heights(self, wrench: Sequence[Scalar]) -> Vector:
        """s_i x W: how far a wrench lies along the normal of each pair of facets."""
        return [cross(column, wrench) for column in self.columns]

    def contains(self, wrench: Sequence[Scalar]) -> Scalar:
        """Whether the wrench is feasible."""
        offsets = self.heights(subtract(wrench, self.middle))
        return all_of(
            [ca.fabs(offset) <= half for offset, half in zip(offsets, self.halves, strict=True)]
        )

    def contains_zero(self) -> Scalar:
        """Whether the cables can hold the platform without any force on it."""
        return self.inner_radius() >= 0

    def inner_radius(self) -> Scalar:
        """Largest r such that every force up to r is feasible (the true I_F); negative if none.

        The columns must have length 1.
        """
        centres = self.heights(self.middle)
        return smallest(
            [half - ca.fabs(centre) for centre, half in zip(centres, self.halves, strict=True)]
        )

    def fraction(self, wrench: Sequence[Scalar]) -> tuple[Scalar, Scalar]:
        """Largest s <= 1 such that s W is feasible, and whether there is none with s >= 0.

        A ray that misses the set by no more than rounding does not, nor does it cross a facet that
        it leaves by no more: with T_min = 0, say, it starts on the border, or runs along it.
        """
        largest_s, ends = ca.SX(1), []
        slack = RAY_SLACK * EPSILON * self.high
        for height, centre, half in zip(
            self.heights(wrench), self.heights(self.middle), self.halves, strict=True
        ):
            crosses_it = ca.fabs(height) > slack
            inverse = 1 / height
            top = (centre + ca.copysign(half, height)) * inverse
            largest_s = ca.fmin(largest_s, where(crosses_it, top, 1))
            sides = (centre - half - slack) * inverse, (centre + half + slack) * inverse
            beside = ca.fabs(centre) > half + slack
            ends.append(
                (
                    where(crosses_it, ca.fmin(*sides), where(beside, FAR, 0)),
                    where(crosses_it, ca.fmax(*sides), 1),
                )
            )
        first = largest([ca.SX(0), *(low for low, _ in ends)])
        missed = first > smallest([ca.SX(1), *(high for _, high in ends)])
        return ca.fmax(largest_s, 0), missed

    def closest(self, wrench: Sequence[Scalar]) -> Vector:
        """Nearest point of the boundary to a wrench outside the set."""
        best: Vector = [ca.SX(0), ca.SX(0)]
        least = ca.SX(FAR)
        offsets = self.heights(subtract(wrench, self.middle))
        for number, offset in enumerate(offsets):
            candidate = self.closest_on_edge(number, offset > 0, wrench)
            gap = [a - b for a, b in zip(candidate, wrench, strict=True)]
            distance = where(ca.fabs(offset) > self.halves[number], dot(gap, gap), FAR)
            nearer = distance < least
            best = [where(nearer, a, b) for a, b in zip(candidate, best, strict=True)]
            least = where(nearer, distance, least)
        return best

    def closest_on_edge(self, number: int, upper: Scalar, wrench: Sequence[Scalar]) -> Vector:
        """Nearest point on the upper or lower of the two edges along cable `number`."""
        corner: Vector = [ca.SX(0), ca.SX(0)]
        for other, column in enumerate(self.columns):
            if other == number:
                continue
            leans = self.leans_up(number, other)
            agree = ca.logic_or(
                ca.logic_and(upper, leans), ca.logic_and(ca.logic_not(upper), ca.logic_not(leans))
            )
            tension = where(agree, self.high, self.low)
            corner = add_scaled(corner, tension, column)
        edge = self.columns[number]
        rest = [a - b for a, b in zip(wrench, corner, strict=True)]
        tension = clamp(dot(rest, edge) / dot(edge, edge), self.low, self.high)
        return add_scaled(corner, tension, edge)

    def leans_up(self, number: int, other: int) -> Scalar:
        """Whether tension in `other` raises s_number x W; order tells parallel cables apart."""
        slant = self.crosses[number][other]
        same_way = dot(self.columns[number], self.columns[other]) > 0
        in_order = same_way if number < other else ca.logic_not(same_way)
        parallel = ca.fabs(slant) <= PARALLEL * EPSILON
        return ca.logic_or(
            ca.logic_and(parallel, in_order), ca.logic_and(ca.logic_not(parallel), slant > 0)
        )


def wrench_set(columns: Matrix, low: float, high: float) -> WrenchSet:
    """Facets of the feasible wrenches, for columns s_i and tensions in [low, high]."""
    count = len(columns)
    crosses: Matrix = [[ca.SX(0)] * count for _ in range(count)]
    for i in range(count):
        for j in range(i + 1, count):
            crosses[i][j] = cross(columns[i], columns[j])
            crosses[j][i] = -crosses[i][j]
    mean, half = (low + high) / 2, (high - low) / 2
    others = [[j for j in range(count) if j != i] for i in range(count)]
    return WrenchSet(
        columns,
        low,
        high,
        crosses,
        [mean * total(list(row)) for row in zip(*columns, strict=True)],
        [half * total([ca.fabs(crosses[i][j]) for j in others[i]]) for i in range(count)],
    )
