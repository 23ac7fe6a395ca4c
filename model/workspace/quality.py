"""What a machine can do at a pose: the measures of the workspace, for a whole batch of poses.

Movable bases are where `base_targets` puts them, unless rail coordinates are given.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.workspace.facets import ROUNDINGS, rounding
from turnbuckle.model.workspace.feasible import (
    Verdict,
    ball_margin,
    smallest_singular_value,
    wrench_closure,
)
from turnbuckle.model.workspace.force import isotropic_force, served_share, tension_factor
from turnbuckle.model.workspace.max_tension import needed_tension
from turnbuckle.model.workspace.rows import Array
from turnbuckle.model.workspace.structures import Demand, structures, target_demand

NOTHING = Demand(0.0, 0.0, 0)


class PoseQuality(NamedTuple):
    """Arrays (...), one entry a pose; NaN (closure: False) where the platform touches a pulley."""

    margin: Array
    """Of all wanted forces and moments [N]; negative only where one of them is infeasible."""
    zero_margin: Array
    """Of the zero wrench [N]; negative only where the cables cannot hold the platform at rest."""
    force: Array
    """Isotropic force I_F [N]."""
    tension_factor: Array
    """TF; NaN also where the zero wrench is infeasible, and where T_min = 0."""
    needed_tension: Array
    """Least T_max [N] for all wanted forces and moments; inf where none is enough."""
    closure: Verdict
    """Whether the pose is in the theoretical workspace."""
    conditioning: Array
    """Smallest singular value of S: 0 in the singular set."""


def pose_quality(
    machine: Machine, poses: npt.ArrayLike, rails: npt.ArrayLike | None = None
) -> PoseQuality:
    """All measures of poses (..., d) with rail coordinates (..., m) [m]."""
    s, lower, upper = _situation(machine, poses, rails)
    demand = target_demand(machine)
    return PoseQuality(
        margin=_margin(s, lower, upper, demand),
        zero_margin=_margin(s, lower, upper, NOTHING),
        force=isotropic_force(s, lower, upper, machine.space),
        tension_factor=tension_factor(s, lower, upper),
        needed_tension=needed_tension(s, demand.force, lower, demand.moment, demand.space),
        closure=wrench_closure(s),
        conditioning=smallest_singular_value(s),
    )


def wanted_margin(
    machine: Machine, poses: npt.ArrayLike, rails: npt.ArrayLike | None = None
) -> Array:
    """Margin (...) [N] of all wanted forces and moments: negative only where one is infeasible."""
    return _margin(*_situation(machine, poses, rails), target_demand(machine))


def possible_share(machine: Machine, poses: npt.ArrayLike) -> Array:
    """The share (...) of all wanted forces and moments that is feasible at once; may exceed 1."""
    return served_share(*_situation(machine, poses, None), *target_demand(machine))


def _situation(
    machine: Machine, poses: npt.ArrayLike, rails: npt.ArrayLike | None
) -> tuple[Array, float, float]:
    """Structure matrices (..., d, n) and the bounds of the tensions [N]."""
    where = base_targets(machine, poses) if rails is None else rails
    return structures(machine, poses, where), machine.tension.min, machine.tension.max


def _margin(s: Array, lower: float, upper: float, demand: Demand) -> Array:
    """The margin, what rounding may have cost given back: the boundary is feasible."""
    largest = max(demand.force, demand.moment)
    slack = rounding(s, upper) + ROUNDINGS * np.finfo(np.float64).eps * largest
    return np.asarray(ball_margin(s, lower, upper, *demand) + slack)
