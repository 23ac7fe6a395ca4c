"""What the cables can do over the target: the one place where a design search asks the model.

Poses lie on a grid that spans the target, its border included; every movable base is at its best
place for the pose.
"""

from itertools import product
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from model.machine import Machine
from model.reference.control import base_targets
from model.reference.kinematics import structure_matrix
from model.reference.wrench_set import slabs

Reals = npt.NDArray[np.floating[Any]]

POSES_PER_SIDE = 21


class Pull(NamedTuple):
    """What cables at 1 N give along the normal of every side of the set of wrenches (k, sides).

    Along its normal a side is at T_max `along` - T_min `against` from the origin.
    """

    along: Reals
    """Sum over the cables that pull along the normal."""
    against: Reals
    """Sum over the cables that pull against it, not negative."""


def pull(machine: Machine) -> Pull:
    """The pull of the cables at all k poses of the target."""
    poses = target_poses(machine)
    structure = structure_matrix(machine, poses, base_targets(machine, poses))
    _, middle, half_width = slabs(machine, structure)
    least, most = machine.tension.min, machine.tension.max
    total, size = 2 * middle / (most + least), 2 * half_width / (most - least)
    along, against = (size + total) / 2, (size - total) / 2
    # A cable has no direction where a pose is on its pulley: nothing pulls, everything hinders.
    return Pull(
        np.nan_to_num(np.concatenate([along, against], axis=-1), nan=0.0),
        np.nan_to_num(np.concatenate([against, along], axis=-1), nan=len(machine.cables)),
    )


def isotropic_force(machine: Machine) -> Reals:
    """I_F (k) [N]; where the cables cannot hold the platform below zero, what is missing to it."""
    cables, bounds = pull(machine), machine.tension
    return np.asarray(np.min(bounds.max * cables.along - bounds.min * cables.against, axis=-1))


def needed_tension(machine: Machine) -> Reals:
    """The least T_max (k) [N] that gives the wanted force in every direction; inf for none."""
    cables = pull(machine)
    needed = machine.target.force + machine.tension.min * cables.against
    # A rounding error is no pull.
    rounding = needed.shape[-1] * np.finfo(needed.dtype).eps
    able = cables.along > rounding
    tension = np.where(able, needed / np.where(able, cables.along, 1), np.inf)
    return np.asarray(np.max(tension, axis=-1))


def target_poses(machine: Machine) -> Reals:
    """The grid of poses (k, d) [m]."""
    target = machine.target
    axes = [
        np.linspace(centre - size / 2, centre + size / 2, POSES_PER_SIDE).tolist()
        for centre, size in zip(target.centre, target.size, strict=True)
    ]
    return np.array(list(product(*axes)))
