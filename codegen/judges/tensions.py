"""What is expected of tensions, and of the wrenches that policies serve."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from turnbuckle.codegen.judges.conditioning import (
    NOTHING,
    least_pivot,
    narrowest,
    smallest_singular_value,
)
from turnbuckle.codegen.judges.problem import (
    ROUNDINGS,
    Bools,
    Expected,
    Problem,
    Wide,
    levers,
    statuses,
)
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import tension
from turnbuckle.model.reference.arrays import norm
from turnbuckle.model.reference.planar import minors
from turnbuckle.model.reference.wrench_set import by_slabs, slabs
from turnbuckle.model.symbolic import rank as limits
from turnbuckle.model.symbolic.function import Status
from turnbuckle.model.symbolic.nearest_wrench import BEYOND
from turnbuckle.model.symbolic.tension import INWARDS, KKT_TOLERANCE, LARGEST_MISS

Judge = Callable[[Problem], Expected]

#: As ROUNDINGS, for tensions: 5.7e-14 of T_max in double precision, 3.1e-5 in single.
TENSION_ROUNDINGS = 256.0
#: How far from the limit of singularity a pivot must be to be decided whatever the rounding.
RANK_FACTOR = 4.0


@dataclass(frozen=True)
class Bounded:
    """Tensions with the machine's bounds; how much they, and what they deliver, may differ."""

    tension: Wide
    delivered: Wide
    tension_slack: Wide
    delivered_slack: Wide
    feasible: Bools
    infeasible: Bools
    gain: Wide


def with_bounds(machine: Machine, relative: float) -> Machine:
    """The machine with its range of tensions wider by a fraction of T_max at either end."""
    shift = relative * machine.tension.max
    low, high = machine.tension.min - shift, machine.tension.max + shift
    bounds = machine.tension.model_copy(update={"min": low, "max": high})
    return machine.model_copy(update={"tension": bounds})


def amplification(structure: Wide, tension: Wide, low: float, high: float) -> Wide:
    """How much a rounding of the wrench moves the tensions (count).

    The free cables take it up: one over the smallest singular value of their part of S. On the
    border fewer than d are free, and a rounding inwards frees others: one over the least that d
    cables, with the free ones, make.
    """
    off = 1e-9 * (high if np.isfinite(high) else max(low, 1e-9))
    free = (tension > low + off) & (tension < high - off)
    count = np.sum(free, axis=-1)
    columns = np.swapaxes(structure, -1, -2)
    least = smallest_singular_value(columns * free[..., None])
    enough = (count >= structure.shape[-2]) & (least > NOTHING)
    gain = np.empty(len(least), np.longdouble)
    gain[enough] = 1 / least[enough]
    gain[~enough] = 1 / narrowest_share(columns[~enough], free[~enough])
    return gain


def narrowest_share(columns: Wide, free: Bools) -> Wide:
    """The least that d cables with the free ones make; in the plane the sine of their angle."""
    if columns.shape[-1] > 2:
        return narrowest(columns, free)
    sine = np.abs(minors(columns))
    first = free | (np.sum(free, axis=-1) == 0)[:, None]
    counts = first[:, :, None] & (sine > np.finfo(sine.dtype).eps * ROUNDINGS)
    return np.asarray(np.min(np.where(counts, sine, 1), axis=(-2, -1)))


def bounded(p: Problem, structure: Wide, wrench: Wide, policy: str) -> Bounded:
    """The reference's distribution and, closely, those of problems a hair off.

    They show what rounding does at borders; twice that is allowed.
    """
    machine, relative = p.machine, TENSION_ROUNDINGS * p.epsilon
    bounds = machine.tension
    answer = tension.distribute_tension(machine, structure, wrench, policy)
    near = a_hair_off(p, structure, wrench, policy) if p.closely else []
    judge = paper_verdicts if policy == "paper" else verdicts
    feasible, infeasible = judge(p, structure, wrench)
    lever = levers(machine)
    levered = structure / lever[:, None]
    gain = amplification(levered, answer.tension, bounds.min, bounds.max)
    moved = (
        furthest(answer.tension, [other.tension for other in near]),
        furthest(answer.delivered, [other.delivered for other in near]),
    )
    size = norm(wrench / lever) + np.sum(answer.tension, axis=-1)
    served = ROUNDINGS * p.epsilon * size
    if policy != "paper":
        nearest = infeasible if policy == "closest" else infeasible & off_the_ray(p, wrench, answer)
        served = served + nearest * beside_the_nearest(p, wrench, answer)
    if policy == "scale":
        # the ray meets the border of a flat set at a small angle
        served = served + 2 * infeasible * tolerated(machine, p.epsilon, structure)
    if policy != "paper" and machine.dof > 2:
        # the normal of a facet loses what the cables along it do; in the plane there is one. A ray
        # that meets the facet at a small angle feels that more: as it feels the bounds, by which a
        # facet with the normal m is shifted by |S'm| at least
        least = smallest_singular_value(np.swapaxes(levered, -1, -2))
        shift = relative * bounds.max * np.maximum(least, rank_limit(p.epsilon))
        steep = np.maximum(1, norm(moved[1] / lever) / shift)
        served = served + infeasible * ROUNDINGS * p.epsilon * size * gain * steep
    own = relative * bounds.max * gain
    if policy == "paper":
        # what is clipped no longer cancels: the wrench is off by what the tensions are
        served = served + infeasible * own
    lost = np.zeros(p.count, dtype=bool)
    if policy != "paper":
        # in a corner of nearly parallel cables the C serves a wrench a little further in
        lost = infeasible & nearly_parallel(p, structure)
        middle = (bounds.min + bounds.max) / 2 * np.sum(structure, axis=-1)
        # and so it does on the border, where the wrench itself cannot be served
        inwards = lost | (feasible & infeasible & p.closely)
        served = served + np.where(inwards, INWARDS * norm((answer.delivered - middle) / lever), 0)
    if policy != "paper":
        served = served + (feasible & infeasible) * tolerated(machine, p.epsilon, structure)
    return Bounded(
        answer.tension,
        answer.delivered,
        np.where(lost[:, None], np.inf, (own + served * gain)[:, None] + 2 * moved[0]),
        served[:, None] * lever + np.where(infeasible[:, None], 2 * moved[1], 0),
        feasible,
        infeasible,
        gain,
    )


def a_hair_off(p: Problem, structure: Wide, wrench: Wide, policy: str) -> list[Any]:
    """Distributions with bounds a hair wider and tighter, and with S turned a little.

    A ray along a facet meets it with bounds that are moved by one rounding, and misses it with
    bounds moved by many; a flat set is moved by S rather than by its bounds.
    """
    machine, relative = p.machine, TENSION_ROUNDINGS * p.epsilon
    shifts = [sign * relative * share for share in (1, 1 / TENSION_ROUNDINGS) for sign in (1, -1)]
    turn = np.random.default_rng(1).standard_normal(structure.shape) * levers(machine)[:, None]
    turn = ROUNDINGS * p.epsilon * turn
    return [
        *(
            tension.distribute_tension(with_bounds(machine, shift), structure, wrench, policy)
            for shift in shifts
        ),
        *(
            tension.distribute_tension(machine, structure + sign * turn, wrench, policy)
            for sign in (1, -1)
        ),
    ]


def furthest(value: Wide, others: list[Wide]) -> Wide:
    """How far any of the others is off, entry by entry; 0 without others."""
    return np.asarray(np.max([np.abs(other - value) for other in [value, *others]], axis=0))


def nearly_parallel(p: Problem, structure: Wide) -> Bools:
    """Where d cables, not quite dependent, are so near it that a corner of them may close.

    Found once for all functions that take these arguments: they have one structure.
    """
    if "narrowest" not in p.solved:
        columns = np.swapaxes(structure / levers(p.machine)[:, None], -1, -2)
        none = np.zeros(columns.shape[:2], dtype=bool)
        p.solved["narrowest"] = narrowest_share(columns, none)
    return np.asarray(p.solved["narrowest"] < 8 * p.epsilon**0.25)


def off_the_ray(p: Problem, wrench: Wide, answer: Any) -> Bools:
    """Where no fraction of the wrench is served, but the nearest feasible one."""
    lever = levers(p.machine)
    wanted, served = wrench / lever, answer.delivered / lever
    square = np.sum(wanted**2, axis=-1)
    share = np.sum(wanted * served, axis=-1) / np.where(square > 0, square, 1)
    beside = norm(served - share[:, None] * wanted)
    return np.asarray(beside > ROUNDINGS * p.epsilon * p.machine.tension.max)


def beside_the_nearest(p: Problem, wrench: Wide, answer: Any) -> Wide:
    """How far beside the nearest feasible wrench the C may find one that is as near (count) [N].

    A loop ends at a point c when none is nearer by more than a gap, |c - w|^2 - (c - w)(v - w) for
    all v, and then the square of its distance from the nearest is at most that gap.
    """
    bounds, wanted = p.machine.tension, wrench / levers(p.machine)
    away = norm(answer.delivered / levers(p.machine) - wanted)
    if p.machine.dof == 2:
        return near_a_corner(p, answer, away)
    scale = bounds.max * len(p.machine.cables) + np.sum(np.abs(wanted), axis=-1)
    return np.asarray(p.closely * np.sqrt(BEYOND * p.epsilon * scale * away))


def near_a_corner(p: Problem, answer: Any, away: Wide) -> Wide:
    """The same for a polygon, whose sides are known: beside a corner that is as near as a side.

    Two points of it that are sqrt(epsilon) of the distance apart are equally near up to rounding.
    """
    bounds = p.machine.tension
    reach = 8 * np.sqrt(p.epsilon) * away
    room = np.minimum(answer.tension - bounds.min, bounds.max - answer.tension)
    return np.asarray(np.where(np.max(room, axis=-1) <= reach, reach, 0))


def tolerated(machine: Machine, epsilon: float, structure: Wide) -> Wide:
    """How far outside the set a wrench (count) [N] may be that the C's own check lets pass."""
    least = smallest_singular_value(np.swapaxes(structure / levers(machine)[:, None], -1, -2))
    most = RANK_FACTOR * KKT_TOLERANCE * epsilon * machine.tension.max
    return np.asarray(most / np.maximum(np.minimum(least, 1), rank_limit(epsilon)))


def verdicts(p: Problem, structure: Wide, wrench: Wide) -> tuple[Bools, Bools]:
    """Where a wrench may count as feasible, and where as infeasible."""
    inside = depth(p.machine, structure, wrench)
    slack = tolerated(p.machine, p.epsilon, structure)
    return inside >= -slack, inside <= ROUNDINGS * p.epsilon * p.machine.tension.max


def depth(machine: Machine, structure: Wide, wrench: Wide) -> Wide:
    """How far inside the feasible wrenches a wrench is (count) [N]; negative outside."""

    def distance(structure: Wide, wrench: Wide) -> tuple[Wide]:
        normals, middle, half_width = slabs(machine, structure)
        along = np.sum(normals * wrench[:, None, :], axis=-1)
        # a facet's distance counts in wrenches whose moments are over the lever
        steep = norm(normals * levers(machine))
        return (np.min((half_width - np.abs(along - middle)) / steep, axis=-1),)

    (inside,) = by_slabs(machine, distance, structure, wrench)
    return inside


def paper_verdicts(p: Problem, structure: Wide, wrench: Wide) -> tuple[Bools, Bools]:
    """The same for Yoon eqs 22 and 23: it has no solution, or one that is clipped."""
    machine, high, relative = p.machine, p.machine.tension.max, TENSION_ROUNDINGS * p.epsilon
    levered, forces = structure / levers(machine)[:, None], wrench / levers(machine)
    size = norm(forces)
    changes: list[tuple[float, Any]] = [(0.0, 0.0)]
    if p.closely:
        moves = [sign * step for step in np.eye(machine.dof) for sign in (1, -1)]
        changes += [(relative, 0.0), (-relative, 0.0), *((0.0, move) for move in moves)]
    solved = [
        tension.minimum_norm_tension(
            levered,
            forces + relative * size[:, None] * move,
            machine.tension.min - shift * high,
            np.inf,
        )
        for shift, move in changes
    ]
    gain = amplification(levered, solved[0].tension, machine.tension.min, np.inf)
    slack = (relative * (high + size) * gain)[:, None]
    fits = [s.solved & np.all(s.tension <= high + slack, axis=-1) for s in solved]
    exceeds = np.any(solved[0].tension >= high - slack, axis=-1)
    always_solved = np.logical_and.reduce([s.solved for s in solved])
    return np.logical_or.reduce(fits), ~always_solved | exceeds


def rank_limit(epsilon: float) -> float:
    """Below this a pivot of S counts as zero."""
    return max(limits.SMALLEST_PIVOT, limits.RANK_TOLERANCE * epsilon)


def rank(p: Problem, structure: Wide) -> tuple[Wide, tuple[Bools, Bools]]:
    """Smallest singular value of S, and where S must, and may, count as singular.

    The C looks at the pivots of a factorisation without exchanges, which are never smaller than
    the smallest singular value, but may be larger.
    """
    columns = np.swapaxes(structure / levers(p.machine)[:, None], -1, -2)
    least = smallest_singular_value(columns)
    limit = rank_limit(p.epsilon)
    pivot = np.sqrt(least_pivot(columns))
    return least, (pivot < limit / RANK_FACTOR, least < limit * RANK_FACTOR)


def distribution(policy: str) -> Judge:
    """Judges tb_distribute_tension_<policy>."""

    def judge(p: Problem) -> Expected:
        found = solved(p, policy)
        least, singular = rank(p, p["structure"])
        normal = {Status.OK: found.feasible, Status.INFEASIBLE: found.infeasible}
        # where S is nearly singular its own check may fail as well
        doubtful = singular[1] | too_near_singular(p, least, found)
        if policy == "paper" or p.machine.dof > 2:
            # no answer within rounding is told as no answer at all, or the loop for it gives up
            doubtful = doubtful | nearly_parallel(p, p["structure"])
        faults = {
            Status.SINGULAR: singular,
            Status.INACCURATE: (np.zeros(p.count, dtype=bool), doubtful),
        }
        if policy == "paper":
            normal[Status.INFEASIBLE] = found.infeasible | doubtful
            normal[Status.OK] = found.feasible | doubtful
        allowed = statuses(p.count, normal, faults)
        answer = tension_expected(p, found, least, allowed)
        if policy == "paper":
            forget_doubtful(p, answer, doubtful)
        return answer

    return judge


def forget_doubtful(p: Problem, answer: Expected, doubtful: Bools) -> None:
    """Without an upper bound tensions may be huge, and what they miss the wrench by as well."""
    answer.tolerance["kkt_residual"] += LARGEST_MISS * p.machine.tension.max
    for name in ("tension", "delivered"):
        answer.tolerance[name][doubtful] = np.inf


def too_near_singular(p: Problem, least: Wide, found: Bounded) -> Bools:
    """Where rounding alone may miss the wrench by more than the C lets pass."""
    high = p.machine.tension.max
    largest = np.maximum(np.max(found.tension, axis=-1), high) * np.maximum(1, found.gain)
    rounding = RANK_FACTOR * KKT_TOLERANCE * p.epsilon * largest
    return np.asarray(rounding > LARGEST_MISS * high * least)


def least_norm(p: Problem) -> Expected:
    """Judges the exact solver: it reports, by its own check, a wrench that is infeasible."""
    found = solved(p, "closest")
    least, singular = rank(p, p["structure"])
    nowhere = np.zeros(p.count, dtype=bool)
    doubtful = found.infeasible | too_near_singular(p, least, found) | near_border(p, found)
    faults = {Status.SINGULAR: singular, Status.INACCURATE: (nowhere, doubtful)}
    allowed = statuses(p.count, {Status.OK: found.feasible}, faults)
    return tension_expected(p, found, least, allowed)


def near_border(p: Problem, found: Bounded) -> Bools:
    """Where rounding, as much as it moves the tensions, leaves none within their bounds."""
    if not p.closely:
        return np.zeros(p.count, dtype=bool)
    rounding = ROUNDINGS * p.epsilon * p.machine.tension.max * np.maximum(1, found.gain)
    return np.asarray(depth(p.machine, p["structure"], p["wrench"]) <= rounding)


def least_norm_quick(p: Problem) -> Expected:
    """Judges the quick solver: it may give up anywhere, but must not answer wrongly."""
    answer = least_norm(p)
    answer.allowed[:, Status.INACCURATE] = True
    return answer


def tension_expected(p: Problem, found: Bounded, least: Wide, allowed: Bools) -> Expected:
    """Tensions, what they deliver, and no more than the stated residual."""
    scale = p.machine.tension.max + np.sum(np.abs(p["wrench"]) / levers(p.machine), axis=-1)
    limit = RANK_FACTOR * KKT_TOLERANCE * p.epsilon * scale
    residual = np.divide(limit, least, out=np.full(p.count, np.inf, limit.dtype), where=least > 0)
    values = {
        "tension": found.tension,
        "delivered": found.delivered,
        "kkt_residual": np.zeros(p.count, np.longdouble),
    }
    tolerance = {
        "tension": found.tension_slack,
        "delivered": np.maximum(found.delivered_slack, residual[:, None] * levers(p.machine)),
        "kkt_residual": residual,
    }
    return Expected(values, tolerance, allowed, beside_header=False)


def solved(p: Problem, policy: str) -> Bounded:
    """The distribution of this problem, computed once for all functions that need it."""
    if policy not in p.solved:
        p.solved[policy] = bounded(p, p["structure"], p["wrench"], policy)
    found: Bounded = p.solved[policy]
    return found


def served_wrench(policy: str) -> Judge:
    """Judges tb_served_wrench_<policy>."""

    def judge(p: Problem) -> Expected:
        found = solved(p, policy)
        normal = {Status.OK: found.feasible, Status.INFEASIBLE: found.infeasible}
        allowed = statuses(p.count, normal, {})
        # parallel cables are refused by the distribution before a wrench is served
        _, (_, singular) = rank(p, p["structure"])
        allowed |= singular[:, None]
        if p.machine.dof > 2:
            # the loop for the nearest wrench may give up where cables are nearly dependent
            allowed[:, Status.INACCURATE] |= nearly_parallel(p, p["structure"])
        limits = p.machine.tension
        least = ROUNDINGS * p.epsilon * limits.max
        slack = found.delivered_slack + least * levers(p.machine)
        slack = np.where(singular[:, None], np.longdouble(np.inf), slack)
        middle = (limits.min + limits.max) / 2 * np.sum(p["structure"], axis=-1)
        inner = found.delivered
        inner = inner + INWARDS * (middle - inner)
        values = {"served": found.delivered, "inner": inner}
        return Expected(values, dict.fromkeys(values, slack), allowed, beside_header=False)

    return judge


JUDGES: dict[str, Judge] = {
    "least_norm_tension": least_norm,
    "least_norm_tension_quick": least_norm_quick,
    "served_wrench_scale": served_wrench("scale"),
    "served_wrench_closest": served_wrench("closest"),
    "distribute_tension_scale": distribution("scale"),
    "distribute_tension_closest": distribution("closest"),
    "distribute_tension_paper": distribution("paper"),
}
