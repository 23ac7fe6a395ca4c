"""How good a pose is: zero-wrench tension, tension factor and isotropic force (Yoon section III).

pose (..., 2) [m], rails (..., m) [m]. Outside the zero-wrench feasible workspace the paper does
not define the tensions, so they and what follows from them are NaN; the true isotropic force is 0.
"""

import numpy as np
import numpy.typing as npt

from model.machine import Machine
from model.reference.arrays import Array
from model.reference.kinematics import structure_matrix
from model.reference.planar import cross
from model.reference.tension import minimum_norm_tension, wrench_feasible
from model.reference.wrench_set import slabs


def zero_wrench_tension(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """T0 (..., n) [N]: the bounded tensions of least norm that give no wrench (Yoon eq. 12)."""
    return _zero_wrench_tension(machine, structure_matrix(machine, pose, rails))


def tension_factor(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """TF = min T0 / max T0 (...), between T_min / T_max and 1 (Yoon eq. 13)."""
    tension = zero_wrench_tension(machine, pose, rails)
    return np.asarray(np.min(tension, axis=-1) / np.max(tension, axis=-1))


def isotropic_force(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """I_F (...) [N]: the largest force that bounded tensions can give in every direction.

    The radius of the largest disc about the origin in the set of wrenches: the least distance of
    its facets. 0 outside the zero-wrench feasible workspace.
    """
    _, middle, half_width = slabs(machine, structure_matrix(machine, pose, rails))
    return np.asarray(np.maximum(np.min(half_width - np.abs(middle), axis=-1), 0))


def isotropic_force_eq17(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """I_F (...) [N] as in Yoon eq. 17, for any number of cables: a lower bound of the true one.

    Each pair of cables adjacent counter-clockwise spans a parallelogram with its tension gains
    t_i = T_max - T0_i; the result is the smallest radius that fits them all.
    """
    structure = structure_matrix(machine, pose, rails)
    gain = machine.tension.max - _zero_wrench_tension(machine, structure)
    order = np.argsort(np.arctan2(structure[..., 1, :], structure[..., 0, :]), axis=-1)
    cables = np.take_along_axis(np.swapaxes(structure, -1, -2), order[..., None], axis=-2)
    following = np.roll(cables, -1, axis=-2)
    gain = np.take_along_axis(gain, order, axis=-1)
    shorter = np.minimum(gain, np.roll(gain, -1, axis=-1))
    # |u x v| / |u| = |v| sin(angle), also where a gain is zero
    height = np.maximum(cross(cables, following), 0) * shorter
    obtuse = np.sum(cables * following, axis=-1) < 0
    return np.asarray(np.min(np.where(obtuse, height, shorter), axis=-1))


def _zero_wrench_tension(machine: Machine, structure: Array) -> Array:
    nothing = np.zeros((*structure.shape[:-2], 2), structure.dtype)
    bounds = machine.tension
    tension = minimum_norm_tension(structure, nothing, bounds.min, bounds.max).tension
    feasible = wrench_feasible(machine, structure, nothing)
    return np.where(feasible[..., None], tension, np.asarray(np.nan, tension.dtype))
