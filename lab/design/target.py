"""What a machine can do over its target: the one place where a design search asks the model.

Poses lie on a grid that spans the target, its border and its rotations included; every movable base
is at its target for the pose.
"""

import numpy as np

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.workspace import max_tension
from turnbuckle.model.workspace.force import isotropic_limits
from turnbuckle.model.workspace.grid import target_grid
from turnbuckle.model.workspace.rows import Array
from turnbuckle.model.workspace.structures import structures, target_demand

POSES_PER_SIDE = {(2, False): 21, (2, True): 21, (3, False): 9, (3, True): 5}
"""By the dimension of the space and whether the platform turns, so that a machine takes
milliseconds; some 0.1 s where it turns in space."""
ROTATIONS = 3
"""About every axis, where the target asks for rotation: least, none and largest."""


def isotropic_force(machine: Machine) -> Array:
    """I_F (k) [N]; where the cables cannot hold the platform below zero, what is missing to it."""
    bounds = machine.tension
    limits = isotropic_limits(_structures(machine), bounds.min, bounds.max, machine.space)
    # No cable has a direction on its pulley: the least force that there can be.
    least = -len(machine.cables) * bounds.max
    return np.asarray(np.nan_to_num(limits.min(axis=-1), nan=least))


def needed_tension(machine: Machine) -> Array:
    """The least T_max (k) [N] that gives the wanted forces and moments; inf where none does."""
    wanted = target_demand(machine)._asdict()
    needed = max_tension.needed_tension(_structures(machine), machine.tension.min, **wanted)
    return np.nan_to_num(needed, nan=np.inf, posinf=np.inf)


def target_poses(machine: Machine) -> Array:
    """The grid of poses (k, d), positions [m] then rotations [rad]."""
    counts = [POSES_PER_SIDE[machine.space, machine.is_rigid]] * machine.space
    return target_grid(machine, counts, ROTATIONS if machine.target.rotation else 1).poses()


def _structures(machine: Machine) -> Array:
    """Structure matrices (k, d, n) at the poses of the target."""
    poses = target_poses(machine)
    return structures(machine, poses, base_targets(machine, poses))
