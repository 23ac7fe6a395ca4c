"""What the reference expects of the methods to compare with, and how nearly.

Which set of cables qualifies, or which one is adjacent, is decided by a comparison, and rounding
may choose either side of it. So the reference is asked again with bounds, columns of S and wrench a
hair off, either way: what that moves is allowed, and where it turns an answer into none, or back,
either status is.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

import numpy as np

from turnbuckle.codegen.judges.conditioning import smallest_singular_value
from turnbuckle.codegen.judges.problem import (
    ROUNDINGS,
    Bools,
    Expected,
    Judge,
    Problem,
    Wide,
    always,
    broadcast,
    levers,
    statuses,
)
from turnbuckle.codegen.judges.tensions import (
    RANK_FACTOR,
    TENSION_ROUNDINGS,
    nearly_parallel,
    rank,
    rank_limit,
    with_bounds,
)
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import brau
from turnbuckle.model.reference.arrays import norm
from turnbuckle.model.symbolic import active_set, comparison
from turnbuckle.model.symbolic.function import Status
from turnbuckle.model.symbolic.tension import KKT_TOLERANCE, LARGEST_MISS, is_unrolled

#: What is moved in so many random directions, either way, may in truth move by so much more.
DIRECTIONS, MARGIN = 2, 4.0

Method = Callable[[Machine, Wide, Wide], Wide]


@dataclass(frozen=True)
class Moved:
    """A result (count, *shape), NaN or infinite where there is none; how much rounding moves it.

    `some` and `none`: where there may be a result, and where there may be none.
    """

    value: Wide
    slack: Wide
    some: Bools
    none: Bools


def moved(p: Problem, other: Wide, method: Method, gain: Wide | float = 1.0) -> Moved:
    """A method of S and a second argument, with all as it is and, closely, a hair off.

    gain (count): what rounding of the method's own grows by.
    """
    results = [method(p.machine, p["structure"], other)]
    if p.closely:
        results += a_hair_off(p, other, method)
    rows = [np.isfinite(r).reshape(p.count, -1).all(axis=1) for r in results]
    value = results[0]
    with np.errstate(invalid="ignore"):
        gaps = [np.abs(r - value) for r in results[1:]]
    gaps = [np.where(np.isnan(gap), np.inf, gap) for gap in gaps]
    largest = np.max(gaps, axis=0) if gaps else np.zeros_like(value)
    own = gain * ROUNDINGS * p.epsilon * np.max(np.abs(value).reshape(p.count, -1), axis=1)
    slack = MARGIN * largest + broadcast(own, value)
    some, every = np.logical_or.reduce(rows), np.logical_and.reduce(rows)
    return Moved(value, np.where(np.isnan(slack), np.inf, slack), some, ~every)


def a_hair_off(p: Problem, other: Wide, method: Method) -> list[Wide]:
    """Results with bounds, S and the second argument moved, either way."""
    random = np.random.default_rng(1)
    structure, hair = p["structure"], TENSION_ROUNDINGS * p.epsilon
    size = norm(other)[:, None] if other.ndim > 1 else np.abs(other)
    results = []
    for move in (hair, -hair):
        results.append(method(with_bounds(p.machine, move), structure, other))
    for _ in range(DIRECTIONS):
        turn = random.standard_normal(structure.shape)
        stretch = random.uniform(0, 1, structure.shape[-1])
        push = size * random.standard_normal(other.shape)
        for move in (hair, -hair):
            stretched = structure * (1 + move * stretch)
            results.append(method(p.machine, stretched, other + move * push))
            results.append(method(p.machine, structure + move * turn, other))
    return results


def told(
    p: Problem, found: Moved, instead: float, faults: dict[Status, tuple[Bools, Bools]]
) -> Expected:
    """Tensions, or a number instead where there are none."""
    lacking = ~np.isfinite(found.value)
    whole = lacking.reshape(p.count, -1).any(axis=1)
    value = np.where(spread(whole, found.value), np.longdouble(instead), found.value)
    normal = {Status.OK: found.some, Status.INFEASIBLE: found.none}
    # where either is right, neither value is wrong
    doubtful = spread(found.some & found.none, value)
    slack = np.where(doubtful, np.inf, np.where(lacking, 0, found.slack))
    allowed = statuses(p.count, normal, faults)
    return Expected({"tension": value}, {"tension": slack}, allowed, beside_header=False)


def spread(holds: Any, like: Wide) -> Bools:
    """What holds at a point (count), in the shape of a result."""
    points: Bools = np.asarray(holds, dtype=bool).reshape(-1, *[1] * (like.ndim - 1))
    return np.broadcast_to(points, like.shape)


def out_of_reach(p: Problem, found: Moved) -> Moved:
    """Where the reference needs tensions so large that rounding may find none at all."""
    limit = p["force"] / (RANK_FACTOR**2 * comparison.PARALLEL * p.epsilon)
    largest = np.max(np.nan_to_num(found.value).reshape(p.count, -1), axis=1)
    return replace(found, none=found.none | (largest > limit))


def columns(p: Problem) -> Wide:
    """Columns of S (count, n, d) with moments over the lever."""
    return np.swapaxes(p["structure"] / levers(p.machine)[:, None], -1, -2)


def kernel_tension(p: Problem) -> Expected:
    """More redundant cables are solved like Yoon's eq. 22: up to a residual of its own."""
    machine = p.machine
    found = moved(p, p["wrench"], brau.kernel_tension)
    weakest, singular = rank(p, p["structure"])
    largest = np.max(np.where(np.isfinite(found.value), found.value, 0), axis=-1)
    least = np.maximum(weakest, rank_limit(p.epsilon))
    rounding = RANK_FACTOR * KKT_TOLERANCE * p.epsilon * np.maximum(largest, machine.tension.max)
    doubtful = singular[1] | (rounding > LARGEST_MISS * machine.tension.max * least)
    # the loop moves no cable by less than this over a pivot; such tensions go with one over both
    reach = machine.tension.max / np.sqrt(active_set.PARALLEL * p.epsilon)
    beyond = (largest > reach) & (not is_unrolled(machine))
    none = found.none | doubtful | beyond
    unsure = replace(found, some=found.some | doubtful, none=none)
    gives_up = ~always(p.count), doubtful | nearly_parallel(p, p["structure"])
    faults = {Status.SINGULAR: singular, Status.INACCURATE: gives_up}
    return told(p, unsure, machine.tension.min, faults)


def reduced_matrix_tension(p: Problem) -> Expected:
    """A set that is nearly dependent may be passed over: where only such are best, anything is
    right.

    Of two sets with the same sum of tensions, up to rounding, either is.
    """
    machine = p.machine
    found = moved(p, p["wrench"], brau.reduced_matrix_tension)
    # as in the C
    told_by = determinant if machine.dof <= 3 else smallest_singular_value
    each = of_sets(p, told_by)
    doubtful = best_is_dependent(p, each) | rank(p, p["structure"])[1][1]
    unsure = replace(found, some=found.some | doubtful, none=found.none | doubtful)
    if p.closely:
        share = TENSION_ROUNDINGS * p.epsilon / np.maximum(np.min(each, axis=-1), 1e-30)
        either = sums_alike(p, share)
        unsure = replace(unsure, slack=np.where(either[:, None], np.inf, unsure.slack))
    return told(p, unsure, machine.tension.min, {})


def best_is_dependent(p: Problem, each: Wide) -> Bools:
    """Where (count) no set that is clearly regular has as low a sum of tensions as one that is not.

    each (count, k): how nearly dependent every set is.
    """
    clear = each >= RANK_FACTOR * rank_limit(p.epsilon)
    doubtful: Bools = ~np.all(clear, axis=-1)
    rows = np.flatnonzero(doubtful)
    if rows.size:
        sums = least_sums(p.among(rows))
        best = np.min(np.where(clear[rows], sums, np.inf), axis=-1)
        doubtful[rows] = best > np.min(sums, axis=-1)
    return doubtful


def least_sums(p: Problem) -> Wide:
    """Sum of tensions above T_min of every set (count, k) [N]; infinite where it will not do."""
    sums = brau.reduced_matrix_sums(p.machine, p["structure"], p["wrench"])
    return np.asarray(np.where(np.isnan(sums), np.inf, sums))


def sums_alike(p: Problem, share: Wide) -> Bools:
    """Where two sets of cables have the least sum of tensions, up to a share (count) of it."""
    first, second = np.sort(least_sums(p), axis=-1)[:, :2].T
    lowest = len(p.machine.cables) * p.machine.tension.min
    return np.asarray(second - first <= share * (first + lowest))


def of_sets(p: Problem, measure: Callable[[Wide], Wide]) -> Wide:
    """How nearly dependent every set of d cables is (count, k), by a measure of square matrices."""
    rays = columns(p)
    sets = combinations(range(rays.shape[-2]), rays.shape[-1])
    return np.stack([measure(rays[:, list(chosen)]) for chosen in sets], axis=-1)


def determinant(matrix: Wide) -> Wide:
    """Its magnitude, of matrices (..., d, d)."""
    return np.asarray(np.abs(np.linalg.det(matrix.astype(float))))


def in_proportion(method: Callable[[Machine, Wide, float], Wide]) -> Method:
    """Tensions that grow with the force: no force asks for none, even where a unit has no limit."""

    def tensions(machine: Machine, structure: Wide, force: Wide) -> Wide:
        return np.asarray(method(machine, structure, 1.0) * force[:, None])

    return tensions


def largest_tensions_eq12(p: Problem) -> Expected:
    """A set of dependent cables is a fault; it counts as that by pivots of all its facets."""
    least = np.min(of_sets(p, smallest_singular_value), axis=-1)
    limit = rank_limit(p.epsilon)
    gain = 1 / np.maximum(least, limit)
    found = moved(p, p["force"], in_proportion(brau.largest_tensions_eq12), gain)
    singular = (least < limit / RANK_FACTOR / p.machine.dof, least < limit * RANK_FACTOR)
    some = Moved(
        np.where(np.isfinite(found.value), found.value, 0),
        np.where(np.isfinite(found.value), found.slack, np.inf),
        np.ones(p.count, dtype=bool),
        np.zeros(p.count, dtype=bool),
    )
    return told(p, some, 0.0, {Status.SINGULAR: singular})


def largest_tensions_eq17(p: Problem) -> Expected:
    """Of cables in one direction either is the adjacent one."""
    found = moved(p, p["force"], in_proportion(brau.largest_tensions_eq17))
    rays = np.swapaxes(p["structure"], -1, -2)
    along = np.einsum("kid,kjd->kij", rays, rays)
    sine = rays[:, :, None, 0] * rays[:, None, :, 1] - rays[:, :, None, 1] * rays[:, None, :, 0]
    hair = TENSION_ROUNDINGS * p.epsilon
    same = (np.abs(sine) < hair) & (along > 0) & ~np.eye(rays.shape[1], dtype=bool)
    doubtful = np.any(same, axis=(1, 2))
    slack = np.where(doubtful[:, None], np.inf, found.slack)
    return told(p, out_of_reach(p, replace(found, slack=slack)), 0.0, {})


def largest_tension(p: Problem) -> Expected:
    """The reference takes one force: S over it makes that 1; no force is a case of its own."""

    def least(machine: Machine, structure: Wide, force: Wide) -> Wide:
        without = force <= 0
        size = np.where(without, 1, force)
        result = brau.largest_tension(machine, structure / size[:, None, None], 1.0)
        result[without] = brau.largest_tension(machine, structure[without], 0.0)
        return result

    found = out_of_reach(p, moved(p, p["force"], least))
    return told(p, found, 0.0, {Status.SINGULAR: rank(p, p["structure"])[1]})


JUDGES: dict[str, Judge] = {
    "kernel_tension": kernel_tension,
    "reduced_matrix_tension": reduced_matrix_tension,
    "largest_tensions_eq12": largest_tensions_eq12,
    "largest_tensions_eq17": largest_tensions_eq17,
    "largest_tension": largest_tension,
}
