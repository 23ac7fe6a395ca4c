"""How good a pose is: zero-wrench tension, tension factor and isotropic force (Yoon section III).

pose (..., d) [m, rad], rails (..., m) [m]. Outside the zero-wrench feasible workspace the paper
does not define the tensions, so they and what follows from them are NaN; the true isotropic force
is 0.
"""

import numpy as np
import numpy.typing as npt

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.arrays import Array, norm
from turnbuckle.model.reference.kinematics import structure_matrix
from turnbuckle.model.reference.planar import cross
from turnbuckle.model.reference.tension import distribute_tension
from turnbuckle.model.reference.wrench_set import by_slabs, slabs


def zero_wrench_tension(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """T0 (..., n) [N]: the bounded tensions of least norm that give no wrench (Yoon eq. 12)."""
    return _zero_wrench_tension(machine, structure_matrix(machine, pose, rails))


def tension_factor(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """TF = min T0 / max T0 (...), between T_min / T_max and 1 (Yoon eq. 13)."""
    return factor(zero_wrench_tension(machine, pose, rails))


def factor(tension: Array) -> Array:
    """min T / max T (...) of tensions (..., n)."""
    return np.asarray(np.min(tension, axis=-1) / np.max(tension, axis=-1))


def capacity_margin(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """Signed least distance (...) [N] of the zero wrench from a facet of the feasible wrenches.

    Inside it is the isotropic force; outside it is negative: how far beyond the worst facet the
    zero wrench lies (Guay et al. 2014). Every force up to F is feasible where it is at least F.
    """
    structure = structure_matrix(machine, pose, rails)
    cables = structure.shape[-1]
    _, middle, half_width = slabs(machine, structure)
    # the slabs along the cables bound no facet
    room = (half_width - np.abs(middle))[..., :cables]
    return np.asarray(np.min(room, axis=-1))


def isotropic_force(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """I_F (...) [N]: the largest force that bounded tensions can give in every direction.

    The radius of the largest ball about the origin in the set of wrenches, for rigid platforms in
    the part of it that has no moment: the least distance of its facets. 0 outside the zero-wrench
    feasible workspace.
    """

    def radius(structure: Array) -> tuple[Array]:
        normals, middle, half_width = slabs(machine, structure)
        room = half_width - np.abs(middle)
        across = norm(normals[..., : machine.space])
        # a facet that no force comes nearer to says only whether zero is on its inner side
        reach = np.where(room >= 0, np.inf, np.where(np.isnan(room), room, 0)).astype(room.dtype)
        return (np.min(np.divide(room, across, out=reach, where=across > 0), axis=-1),)

    structure = structure_matrix(machine, pose, rails)
    (force,) = by_slabs(machine, radius, structure)
    return np.asarray(np.maximum(force, 0))


def isotropic_force_eq17(machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """I_F (...) [N] as in Yoon eq. 17, for any number of cables: a lower bound of the true one.

    Each pair of cables adjacent counter-clockwise spans a parallelogram with its tension gains
    t_i = T_max - T0_i; the result is the smallest radius that fits them all. ValueError for kinds
    other than planar-point, whose cables have no such order.
    """
    if machine.is_rigid or machine.space != 2:
        raise ValueError(f"Yoon eq. 17 is for planar-point; {machine.name} is {machine.kind}")
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
    nothing = np.zeros((*structure.shape[:-2], machine.dof), structure.dtype)
    tension, _, feasible = distribute_tension(machine, structure, nothing, "closest")
    return np.where(feasible[..., None], tension, np.asarray(np.nan, tension.dtype))
