"""Statics with movable bases (Yoon section II-B, eqs 7 to 10), for every kind."""

import numpy as np
import numpy.typing as npt

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.arrays import Array, as_floating, norm
from turnbuckle.model.reference.kinematics import (
    cable_vectors,
    moment_lever,
    rail_jacobian,
    structure_matrix,
)
from turnbuckle.model.reference.linear import least_norm


def wrench(machine: Machine, structure: npt.ArrayLike, tension: npt.ArrayLike) -> Array:
    """Wrench S T (..., d) [N, N m] of the cables on the platform (Yoon eq. 7).

    structure (..., d, n), tension (..., n) [N]. `machine` is there for uniformity and not read.
    """
    structure, tension = as_floating(structure, tension)
    return np.asarray(np.sum(structure * tension[..., None, :], axis=-1))


def rail_forces(
    machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike, tension: npt.ArrayLike
) -> Array:
    """Force (..., m) [N] of the cables on the bases along each rail coordinate, in its direction.

    It is -T_i times the cable's direction along the rail (Yoon eq. 8, second part of F), summed
    over the cables whose bases the coordinate moves: a cable pulls its base towards the platform.
    The rail's drive has to supply the opposite.
    """
    pose, rails, tension = as_floating(pose, rails, tension)
    along = rail_jacobian(machine, pose, rails)
    return np.asarray(-np.sum(along * tension[..., :, None], axis=-2))


def wrench_share_eq10(
    machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike, wrench: npt.ArrayLike
) -> Array:
    """How Yoon eq. 10 shares a wrench (..., d) [N, N m] among the cables (..., n) [N]; planar.

    L^2 S^T (S L^2 S^T)^-1 W, L = diag of the straight lengths |l_i|: of all that give the wrench
    the one with the least sum of (T_i / l_i)^2. It is not the tension, although Yoon calls it so:
    the derivation cancels velocities that are not free, so the internal tension (the null space
    of S) is lost. Entries can be negative, and no wrench gives no tension at all where T_min > 0.

    NaN where the cables do not span. ValueError for kinds in space, which the equation leaves out.
    """
    if machine.space != 2:
        raise ValueError(f"Yoon eq. 10 is for planar machines; {machine.name} is {machine.kind}")
    pose, rails, wrench = as_floating(pose, rails, wrench)
    lengths = norm(cable_vectors(machine, pose, rails))
    lever = moment_lever(machine, lengths.dtype)
    rows = np.swapaxes(structure_matrix(machine, pose, rails), -1, -2) / lever
    return np.asarray(lengths * least_norm(lengths[..., None] * rows, wrench / lever))
