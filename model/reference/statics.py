"""Statics of a point platform with movable bases (Yoon section II-B, eqs 7 to 9)."""

import numpy as np
import numpy.typing as npt

from model.machine import Machine
from model.reference.arrays import Array, as_floating
from model.reference.kinematics import rail_jacobian


def wrench(machine: Machine, structure: npt.ArrayLike, tension: npt.ArrayLike) -> Array:
    """Wrench S T (..., d) [N] of the cables on the platform (Yoon eq. 7).

    structure (..., d, n), tension (..., n) [N]. `machine` is there for uniformity and not read.
    """
    structure, tension = as_floating(structure, tension)
    return np.asarray(np.sum(structure * tension[..., None, :], axis=-1))


def rail_forces(
    machine: Machine, pose: npt.ArrayLike, rails: npt.ArrayLike, tension: npt.ArrayLike
) -> Array:
    """Force (..., m) [N] of each cable on its base along the rail, positive towards its end.

    It is -T_i times the cable's direction along the rail (Yoon eq. 8, second part of F): the
    cable pulls the base towards the platform. The rail's drive has to supply the opposite.
    """
    pose, rails, tension = as_floating(pose, rails, tension)
    along = rail_jacobian(machine, pose, rails)
    return np.asarray(-np.sum(along * tension[..., :, None], axis=-2))
