"""The feasible wrench nearest to a wanted one, in any dimension, by a loop.

Wolfe's algorithm for the point of least norm of a polytope (Mathematical Programming 11, 1976) on
{S T - W : T_min <= T <= T_max}. It holds at most d + 1 vertices. A step finds the point of least
norm of the flat through them. Where that lies between them, a plane through it, across the way from
the origin, bounds the polytope, and it is found, or there are vertices on the near side of the
plane: the one farthest from it joins. Where it lies beside them, one of them is dropped.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import casadi as ca

from turnbuckle.model.symbolic.function import (
    EPSILON,
    Input,
    ModelFunction,
    Output,
    Repeat,
    Status,
    Verdict,
    carried,
    matrix_output,
    scalar_output,
    vector_output,
)
from turnbuckle.model.symbolic.linear import add_scaled, dot, multiply, norm, subtract, transpose
from turnbuckle.model.symbolic.polytope import knock_out
from turnbuckle.model.symbolic.scalar import (
    Matrix,
    Scalar,
    Vector,
    all_of,
    smallest,
    sqrt,
    total,
    where,
)

#: A vertex is beyond the plane by more than so many EPSILON of the numbers it is made of.
BEYOND = 64.0
#: A wrench is infeasible when it misses the feasible ones by this many EPSILON of what all cables
#: can exert: half of what the tensions of least norm may miss it by.
OUTSIDE = 16.0
FAR = 1e30
#: Steps a vertex: half of them must solve what all solve, of a hundred thousand wrenches around the
#: border (tests/equivalence/test_many_cables.py). 10 are not enough for 16 cables in six dimensions
#: in single precision.
STEPS_PER_VERTEX = 40


@dataclass(frozen=True)
class Reach:
    """The wrenches matrix T with low <= T <= high, seen from a wanted one."""

    matrix: Matrix
    wanted: Vector
    low: float
    high: float

    @property
    def slots(self) -> int:
        """How many vertices are held at most."""
        return len(self.wanted) + 1

    @property
    def whole(self) -> float:
        """What all cables can exert, if their columns have length 1."""
        return self.high * len(self.matrix[0])

    @property
    def scale(self) -> Scalar:
        """Size of the numbers that a vertex is the difference of."""
        return self.whole + total([ca.fabs(x) for x in self.wanted])

    def middle(self) -> Vector:
        """The wrench of the mean tension on every cable."""
        return [(self.low + self.high) / 2 * total(row) for row in self.matrix]

    def vertex(self, direction: Sequence[Scalar]) -> Vector:
        """The vertex farthest against a direction, less the wanted wrench."""
        tension = [
            where(dot(column, direction) < 0, self.high, self.low)
            for column in transpose(self.matrix)
        ]
        return subtract(multiply(self.matrix, tension), self.wanted)

    def gap(self, offset: Vector) -> Scalar:
        """How much nearer than a point the polytope comes, in the direction of that point."""
        return dot(offset, subtract(offset, self.vertex(offset)))

    def is_nearest(self, offset: Vector, gap: Scalar) -> Scalar:
        """Whether no point of the polytope is nearer than one of its points, up to rounding."""
        length = norm(offset)
        return ca.logic_or(gap <= BEYOND * EPSILON * self.scale * length, self.is_inside(length))

    def is_inside(self, length: Scalar) -> Scalar:
        """Whether a way of this length to the nearest feasible wrench is rounding."""
        return length <= OUTSIDE * EPSILON * self.whole


@dataclass(frozen=True)
class Corral:
    """The vertices that are held: points, their weights, and which slots are in use (1 or 0)."""

    points: Matrix
    weight: Vector
    used: Vector

    def flat(self) -> tuple[Vector, Vector]:
        """Least-norm point of the flat through the points, and its weights."""
        numbers = [[ca.SX(k), *point] for k, point in enumerate(self.points)]
        heaviest = [where(u > 0, w, -1) for u, w in zip(self.used, self.weight, strict=True)]
        base, *origin = knock_out(heaviest, numbers)
        others = [where(base == k, 0, used) for k, used in enumerate(self.used)]
        edges = [
            [other * x for x in subtract(point, origin)]
            for other, point in zip(others, self.points, strict=True)
        ]
        axes, triangle = orthonormalised(edges)
        offset = origin
        # The second time, what is left across the flat is exact to its own rounding.
        for axis in (*axes, *axes):
            offset = add_scaled(offset, -dot(axis, offset), axis)
        shares = backward(triangle, [-dot(axis, origin) for axis in axes])
        shares = [other * share for other, share in zip(others, shares, strict=True)]
        rest = 1 - total(shares)
        return offset, [where(base == k, rest, share) for k, share in enumerate(shares)]


def orthonormalised(vectors: Matrix) -> tuple[Matrix, Matrix]:
    """Gram-Schmidt, modified: unit vectors q_k and R with vectors = sum_j R_jk q_j; zeros stay."""
    axes: Matrix = []
    triangle: Matrix = [[ca.SX(0)] * len(vectors) for _ in vectors]
    for k, vector in enumerate(vectors):
        rest = vector
        for j, axis in enumerate(axes):
            triangle[j][k] = dot(axis, rest)
            rest = add_scaled(rest, -triangle[j][k], axis)
        square = dot(rest, rest)
        length = sqrt(square)
        triangle[k][k] = where(square > 0, length, 1)
        inverse = where(square > 0, 1 / length, 0)
        axes.append([inverse * x for x in rest])
    return axes, triangle


def backward(triangle: Matrix, right: Vector) -> Vector:
    """Solves R x = right."""
    solution = list(right)
    for i in reversed(range(len(right))):
        for k in range(i + 1, len(right)):
            solution[i] = solution[i] - triangle[i][k] * solution[k]
        solution[i] = solution[i] / triangle[i][i]
    return solution


def step_outputs(reach: Reach, now: Corral) -> tuple[Output, ...]:
    """The vertices after a step, the nearest point found so far, and whether it is the nearest."""
    offset, shares = now.flat()
    # Towards these weights as far as all are positive; the one that ends is dropped.
    limits = [
        where(ca.logic_and(used > 0, share <= 0), weight / (weight - share), FAR)
        for used, weight, share in zip(now.used, now.weight, shares, strict=True)
    ]
    part = smallest(limits)
    blocked = part < FAR
    slots = range(reach.slots)
    (ended,) = knock_out([-limit for limit in limits], [[ca.SX(k)] for k in slots])
    dropped = where(blocked, ended, -1)
    vertex = reach.vertex(offset)
    full = all_of([used > 0 for used in now.used])
    nearest = reach.is_nearest(offset, dot(offset, subtract(offset, vertex)))
    done = ca.logic_and(ca.logic_not(blocked), ca.logic_or(nearest, full))
    (empty,) = knock_out(
        [where(used > 0, -1, reach.slots - k) for k, used in zip(slots, now.used, strict=True)],
        [[ca.SX(k)] for k in slots],
    )
    joined = where(ca.logic_or(blocked, done), -1, empty)
    weight = [
        where(blocked, where(dropped == k, 0, old + part * (share - old)), share)
        for k, old, share in zip(slots, now.weight, shares, strict=True)
    ]
    used = [where(joined == k, 1, where(dropped == k, 0, u)) for k, u in enumerate(now.used)]
    points = [
        [where(joined == k, new, old) for new, old in zip(vertex, point, strict=True)]
        for k, point in enumerate(now.points)
    ]
    return (
        matrix_output("points", "N", points),
        vector_output("weight", "1", weight),
        vector_output("used", "1", used),
        vector_output("offset", "N", offset),
        scalar_output("done", "1", where(done, 1, 0)),
    )


def start_outputs(reach: Reach) -> tuple[Output, ...]:
    """One vertex, the farthest in the direction of the wanted wrench."""
    vertex = reach.vertex(subtract(reach.middle(), reach.wanted))
    none = [[ca.SX(0)] * len(vertex) for _ in range(reach.slots - 1)]
    first = [ca.SX(int(k == 0)) for k in range(reach.slots)]
    return (
        matrix_output("points", "N", [vertex, *none]),
        vector_output("weight", "1", first),
        vector_output("used", "1", first),
        vector_output("offset", "N", vertex),
    )


@dataclass(frozen=True)
class Nearest:
    """What the loop finds: the way from the wanted to the nearest feasible wrench, and whether."""

    offset: Vector
    inside: Scalar
    inaccurate: Verdict


def nearest(reach: Reach, offset: Vector) -> Nearest:
    """The loop's result with its own check: the support function of the feasible wrenches."""
    return Nearest(
        offset,
        reach.is_inside(norm(offset)),
        Verdict(
            ca.logic_not(reach.is_nearest(offset, reach.gap(offset))),
            Status.INACCURATE,
            "a feasible wrench is nearer than the one found",
        ),
    )


#: What the caller makes of the nearest wrench: results and verdicts.
Answer = Callable[[Nearest], tuple[tuple[Output, ...], tuple[Verdict, ...]]]


def nearest_loop(
    names: tuple[str, str, str],
    inputs: tuple[Input, ...],
    reach: Reach,
    answer: Answer,
) -> Repeat:
    """The whole function: name, summary and source, and what is made of the nearest wrench."""
    name, summary, source = names
    start = start_outputs(reach)
    points, weight, used, offset = carried(start)
    now = Corral(points.rows(), weight.scalars(), used.scalars())
    outputs, verdicts = answer(nearest(reach, offset.scalars()))
    return Repeat(
        name,
        summary,
        source,
        ModelFunction(
            f"{name}_begin", "One vertex of the feasible wrenches", source, inputs, start
        ),
        ModelFunction(
            f"{name}_step",
            "A vertex of the feasible wrenches joins or is dropped",
            source,
            (*inputs, points, weight, used),
            step_outputs(reach, now),
        ),
        ModelFunction(
            f"{name}_finish",
            "The nearest feasible wrench, judged",
            source,
            (*inputs, offset),
            outputs,
            verdicts,
        ),
        STEPS_PER_VERTEX * reach.slots,
    )
