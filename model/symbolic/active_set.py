"""Least-norm tensions within bounds by a loop over active sets, for any number of cables.

Dual active set method of Goldfarb and Idnani (Mathematical Programming 27, 1983). Some cables are
held at a bound, and the others, free, take the least-norm tensions that the wrench leaves them:
S_F S_F' y = W - S_H T_H, T_F = S_F' y. To begin with all are free. A step moves the free cable that
violates its bounds most towards them, by the multiplier `push` on that cable alone, until it
arrives and is held, or until the multiplier of a held cable vanishes, which is then freed. Every
step takes its tensions anew from an orthogonal factorisation, so errors do not add up.
"""

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from turnbuckle.model.symbolic.function import (
    EPSILON,
    Input,
    ModelFunction,
    Output,
    Repeat,
    Verdict,
    carried,
    scalar_output,
    vector_output,
)
from turnbuckle.model.symbolic.linear import (
    Factorisation,
    dot,
    factorise,
    multiply,
    subtract,
    transpose,
)
from turnbuckle.model.symbolic.polytope import knock_out
from turnbuckle.model.symbolic.scalar import (
    Matrix,
    Scalar,
    Vector,
    clamp,
    largest,
    smallest,
    total,
    where,
)

#: Bounds that are missed by less are met: EPSILON of the tensions over the smallest pivot of S_F.
SLACK = 8.0
#: Lengths of projected unit vectors below this many EPSILON over the smallest pivot are rounding.
PARALLEL = 64.0
#: Farther than any step.
FAR = 1e30
#: The number of no cable.
NONE = -1.0
#: Steps a cable, twice what a hundred thousand problems around the border of the feasible wrenches
#: take: 2.2 were the most seen, with 16 planar cables (tests/equivalence/test_many_cables.py).
STEPS_PER_CABLE = 5


@dataclass(frozen=True)
class Bounded:
    """min |T| subject to matrix T = wrench, low <= T <= high; `scale` is the size of tensions."""

    matrix: Matrix
    wrench: Vector
    low: float
    high: float
    scale: Scalar

    @property
    def count(self) -> int:
        """Number of cables."""
        return len(self.matrix[0])


@dataclass(frozen=True)
class Face:
    """The tensions with some cables held: side -1 at the lower bound, 1 at the upper, 0 free."""

    problem: Bounded
    side: Vector
    free: Vector
    held: Vector
    factors: Factorisation

    @property
    def left(self) -> Vector:
        """What of the wrench is left to the free cables."""
        exerted = multiply(self.problem.matrix, self.held)
        return subtract(self.problem.wrench, exerted)

    @property
    def smallest_pivot(self) -> Scalar:
        """How far the free cables are from losing rank, 1 at most."""
        return ca.fmin(1, smallest(self.factors.pivots()))

    @property
    def blur(self) -> Scalar:
        """Lengths of projected unit vectors below this are rounding."""
        return PARALLEL * EPSILON / self.smallest_pivot

    def pulled(self, multiplier: Vector) -> Vector:
        """S' y."""
        return [dot(column, multiplier) for column in transpose(self.problem.matrix)]

    def correction(self, level: Vector) -> Vector:
        """The multiplier of what the free tensions lack to exert the rest of the wrench."""
        tension = [free * x for free, x in zip(self.free, level, strict=True)]
        return self.factors.solve_gram(subtract(self.left, multiply(self.problem.matrix, tension)))


def face(problem: Bounded, side: Vector) -> Face:
    """What the free cables can do."""
    free = [where(x == 0, 1, 0) for x in side]
    held = [where(x > 0, problem.high, where(x < 0, problem.low, 0)) for x in side]
    masked = [[x * y for x, y in zip(row, free, strict=True)] for row in problem.matrix]
    return Face(problem, side, free, held, factorise(masked))


@dataclass(frozen=True)
class Mover:
    """The cable that moves towards its bounds: its number, its tension, its column of S."""

    cable: Scalar
    tension: Scalar
    column: Vector
    solved: Scalar


def mover(now: Face, level: Vector, moving: Scalar) -> Mover:
    """The cable under way, or the one that violates its bounds most, if any does."""
    problem = now.problem
    under_way = moving >= 0
    excess = [
        where(free > 0, ca.fmax(problem.low - x, x - problem.high), NONE)
        for free, x in zip(now.free, level, strict=True)
    ]
    slack = SLACK * EPSILON * problem.scale / now.smallest_pivot
    scores = [where(under_way, where(moving == i, 1, 0), x) for i, x in enumerate(excess)]
    columns = transpose(problem.matrix)
    prizes = [[ca.SX(i), level[i], *columns[i]] for i in range(problem.count)]
    cable, tension, *column = knock_out(scores, prizes)
    solved = ca.logic_and(ca.logic_not(under_way), largest(excess) <= slack)
    return Mover(cable, tension, column, solved)


@dataclass(frozen=True)
class Move:
    """One step: whether the cable arrives, which way it went, who is freed, and its multiplier."""

    cable: Scalar
    direction: Scalar
    arrives: Scalar
    freed: Scalar
    push: Scalar
    done: Scalar


def move(now: Face, moving: Scalar, push: Scalar) -> Move:
    """The step from here; a cable on its way to a bound is `moving`, its multiplier is `push`."""
    problem = now.problem
    level = now.pulled(now.factors.solve_gram(now.left))
    chosen = mover(now, level, moving)
    # A unit of push moves the free cables by `shift`, and S' y of all cables by -`pull`.
    pull = now.pulled(now.factors.solve_gram(chosen.column))
    shift = [free * (where(chosen.cable == i, 1, 0) - pull[i]) for i, free in enumerate(now.free)]
    share = dot(shift, shift)
    tension = chosen.tension + push * share
    below = tension < (problem.low + problem.high) / 2
    direction = where(below, 1, -1)
    room = ca.fmax(where(below, problem.low - tension, tension - problem.high), 0)
    # No more free cables than dimensions: they determine each other, and any share is rounding.
    movable = ca.logic_and(total(now.free) > len(problem.wrench), share > now.blur**2)
    whole = where(movable, room / share, FAR)
    limits = [
        freeing(side, level[i] - push * pull[i] - held, direction * pull[i], now.blur)
        for i, (side, held) in enumerate(zip(now.side, now.held, strict=True))
    ]
    nearest = smallest(limits)
    (freed,) = knock_out([-limit for limit in limits], [[ca.SX(i)] for i in range(problem.count)])
    # Where nothing limits the step, no admissible tension exerts the wrench.
    stuck = ca.logic_not(ca.fmin(whole, nearest) < FAR)
    done = ca.logic_or(chosen.solved, stuck)
    return Move(chosen.cable, direction, whole <= nearest, freed, push + direction * nearest, done)


def freeing(side: Scalar, margin: Scalar, rate: Scalar, blur: Scalar) -> Scalar:
    """The step after which the multiplier of a held cable has the wrong sign."""
    closing = side * rate
    return where(closing > blur, ca.fmax(side * margin, 0) / closing, FAR)


@dataclass(frozen=True)
class Optimum:
    """The tensions where the loop ends, and the residual of their optimality conditions [N]."""

    tension: Vector
    residual: Scalar


def optimum(now: Face) -> Optimum:
    """The tensions of a face, refined, clipped and judged."""
    problem = now.problem
    multiplier = now.factors.solve_gram(now.left)
    level = now.pulled(multiplier)
    # Refined as tensions: what they miss is then a rounding of them, not of the multiplier.
    level = [a + b for a, b in zip(level, now.pulled(now.correction(level)), strict=True)]
    tension = [
        clamp(where(side == 0, x, held), problem.low, problem.high)
        for side, x, held in zip(now.side, level, now.held, strict=True)
    ]
    wrong = [side * (held - x) for side, x, held in zip(now.side, level, now.held, strict=True)]
    # Multipliers are exact to roundings of the largest of them, which has no bound, and more where
    # the free cables are nearly dependent.
    most = ca.fmax(problem.scale, largest([ca.fabs(x) for x in multiplier]))
    misfit = ca.fmax(0, largest(wrong)) * now.smallest_pivot * problem.scale / most
    gaps = subtract(multiply(problem.matrix, tension), problem.wrench)
    return Optimum(tension, largest([misfit, *map(ca.fabs, gaps)]))


#: What the caller makes of the optimum: results and verdicts.
Answer = tuple[tuple[Output, ...], tuple[Verdict, ...]]


@dataclass(frozen=True)
class Start:
    """Where a loop begins: its arguments, what it makes of them, the pivots of S, its refusals."""

    inputs: tuple[Input, ...]
    made: tuple[Output, ...]
    pivots: Vector
    verdicts: tuple[Verdict, ...]

    def outputs(self, count: int) -> tuple[Output, ...]:
        """What is made, with the smallest pivot of S; then all cables free, none moving."""
        return (
            *self.made,
            scalar_output("pivot", "1", smallest(self.pivots)),
            vector_output("side", "1", [ca.SX(0)] * count),
            scalar_output("moving", "1", ca.SX(NONE)),
            scalar_output("push", "N", ca.SX(0)),
        )


@dataclass(frozen=True)
class ActiveSet:
    """The loop that solves a problem, which is stated in `inputs`: arguments, or what is made."""

    problem: Bounded
    inputs: tuple[Input, ...]
    start: Start

    def repeat(
        self, name: str, summary: str, source: str, answer: Callable[[Optimum, Scalar], Answer]
    ) -> Repeat:
        """The function; `answer` makes of the optimum, with the smallest pivot, what it gives."""
        outputs = self.start.outputs(self.problem.count)
        pivot, side, moving, push = carried(outputs[-4:])
        now = face(self.problem, side.scalars())
        results, verdicts = answer(optimum(now), pivot.scalars()[0])
        begin = ModelFunction(
            f"{name}_begin",
            "All cables are free",
            source,
            self.start.inputs,
            outputs,
            self.start.verdicts,
        )
        step = ModelFunction(
            f"{name}_step",
            "Moves a cable towards its bounds, until it is held or another one is freed",
            source,
            (*self.inputs, side, moving, push),
            step_outputs(now, moving.scalars()[0], push.scalars()[0]),
        )
        finish = ModelFunction(
            f"{name}_finish",
            "The tensions, refined and judged",
            source,
            (*self.inputs, pivot, side),
            results,
            verdicts,
        )
        most = STEPS_PER_CABLE * self.problem.count
        return Repeat(name, summary, source, begin, step, finish, most)


def step_outputs(now: Face, moving: Scalar, push: Scalar) -> tuple[Output, ...]:
    """The state after a step."""
    step = move(now, moving, push)
    held = where(ca.logic_and(step.arrives, ca.logic_not(step.done)), step.cable, NONE)
    freed = where(ca.logic_or(step.arrives, step.done), NONE, step.freed)
    side = [
        where(held == i, -step.direction, where(freed == i, 0, x)) for i, x in enumerate(now.side)
    ]
    return (
        vector_output("side", "1", side),
        scalar_output("moving", "1", where(step.arrives, NONE, step.cable)),
        scalar_output("push", "N", where(step.arrives, 0, step.push)),
        scalar_output("done", "1", where(step.done, 1, 0)),
    )
