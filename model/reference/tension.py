"""Tension distribution: min ||T|| subject to S T = W, T_min <= T <= T_max (Yoon eq. 12), exactly.

structure (..., d, n), wrench (..., d) [N, N m], tension (..., n) [N].

Feasibility and the policies for infeasible wrenches are decided on the set of wrenches that can
be given (wrench_set), where distances are those of [F; M / lever]. The tensions come from trying
every set of cables that can be at a bound (active_sets), in space and with many cables from a
search for it (bounded).
"""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import active_sets, bounded
from turnbuckle.model.reference.arrays import Array, as_floating, in_chunks
from turnbuckle.model.reference.kinematics import moment_lever
from turnbuckle.model.reference.wrench_set import by_slabs, closest_wrench, contains, largest_share

MOST_TRIED = 6  # cables of which every active set is tried, 3^n of them

POLICIES = ("scale", "closest", "paper")
Verdict = npt.NDArray[np.bool_]


class Distribution(NamedTuple):
    """tension (..., n) [N]; delivered (..., d) [N, N m] = S T; feasible (...): verdict on W."""

    tension: Array
    delivered: Array
    feasible: Verdict


class MinimumNorm(NamedTuple):
    """tension (..., n) [N]; solved (...): the tension gives the wrench, up to rounding."""

    tension: Array
    solved: Verdict


def wrench_feasible(machine: Machine, structure: npt.ArrayLike, wrench: npt.ArrayLike) -> Verdict:
    """Whether bounded tensions exist that give the wrench (Yoon eq. 11): facet test, no solver.

    A wrench on the boundary is feasible. False where anything is NaN.
    """
    structure, wrench = as_floating(structure, wrench)
    (feasible,) = by_slabs(machine, lambda s, w: (contains(machine, s, w),), structure, wrench)
    return feasible.astype(np.bool_)


def distribute_tension(
    machine: Machine,
    structure: npt.ArrayLike,
    wrench: npt.ArrayLike,
    policy: str | None = None,
) -> Distribution:
    """Tensions for a wrench, with the machine's policy (or the one named) where it is infeasible.

    scale    the largest s <= 1 with s W feasible, 0 <= s. Where there is none (the zero
             wrench is infeasible and [0, W] misses the set): as closest.
    closest  the feasible wrench nearest to W in the Euclidean norm of [F; M / lever].
    paper    Yoon eq. 22, T >= T_min only, then eq. 23, clipped to T_max. Where eq. 22 has no
             solution: T_min in every cable. The clip can change the wrench even where a bounded
             solution exists, so compare `delivered` with W; `feasible` judges W itself (eq. 11).

    NaN tensions for NaN input. ValueError for an unknown policy.
    """
    policy = machine.tension.when_infeasible if policy is None else policy
    if policy not in POLICIES:
        raise ValueError(f"policy {policy!r} is not one of {', '.join(POLICIES)}")
    structure, wrench = as_floating(structure, wrench)

    def distribute(s: Array, w: Array) -> tuple[npt.NDArray[Any], ...]:
        feasible = contains(machine, s, w)
        tension = _TENSIONS[policy](machine, s, w, feasible)
        return tension, np.sum(s * tension[:, None, :], axis=-1), feasible

    tension, delivered, feasible = by_slabs(machine, distribute, structure, wrench)
    return Distribution(tension, delivered, feasible.astype(np.bool_))


def minimum_norm_tension(
    structure: npt.ArrayLike, wrench: npt.ArrayLike, lower: float, upper: float
) -> MinimumNorm:
    """The tensions of least norm in [lower, upper] that give the wrench; `upper` may be infinite.

    Where none do, `solved` is False, and the tensions are of small error: the least in space.
    Errors and rounding are judged by the entries as they are, so moments should be given in units
    of a length that makes them comparable with forces.
    """
    structure, wrench = as_floating(structure, wrench)
    tension, solved = in_chunks(
        lambda s, w: _least_norm(s, w, lower, upper), (structure, 2), (wrench, 1)
    )
    return MinimumNorm(tension, solved.astype(np.bool_))


def _scaled_tension(machine: Machine, s: Array, w: Array, feasible: Verdict) -> Array:
    target = w.copy()
    beyond = np.flatnonzero(~feasible)
    share = largest_share(machine, s[beyond], w[beyond])
    target[beyond] *= share[:, None]
    astray = beyond[np.isnan(share)]
    target[astray] = closest_wrench(machine, s[astray], w[astray])
    return _bounded(machine, s, target)


def _closest_tension(machine: Machine, s: Array, w: Array, feasible: Verdict) -> Array:
    target = w.copy()
    target[~feasible] = closest_wrench(machine, s[~feasible], w[~feasible])
    return _bounded(machine, s, target)


def _paper_tension(machine: Machine, s: Array, w: Array, feasible: Verdict) -> Array:
    lower, upper = machine.tension.min, machine.tension.max
    tension, solved = _least_norm(*_as_forces(machine, s, w), lower, np.inf)
    unsolved = np.where(np.isnan(tension), tension, np.asarray(lower, tension.dtype))
    return np.minimum(np.where(solved[:, None], tension, unsolved), upper)


_TENSIONS = {"scale": _scaled_tension, "closest": _closest_tension, "paper": _paper_tension}


def _bounded(machine: Machine, structure: Array, wrench: Array) -> Array:
    bounds = machine.tension
    return _least_norm(*_as_forces(machine, structure, wrench), bounds.min, bounds.max)[0]


def _as_forces(machine: Machine, structure: Array, wrench: Array) -> tuple[Array, Array]:
    """Both with moments over the lever."""
    lever = moment_lever(machine, structure.dtype)
    return structure / lever[:, None], wrench / lever


def _least_norm(
    structure: Array, wrench: Array, lower: float, upper: float
) -> tuple[Array, Verdict]:
    d, cables = structure.shape[-2:]
    if d == 2 and cables <= MOST_TRIED:
        return active_sets.least_norm(structure, wrench, lower, upper)
    return bounded.least_norm(structure, wrench, lower, upper)
