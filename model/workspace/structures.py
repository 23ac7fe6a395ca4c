"""What the analyses need to know of a machine: its structure matrices and what it shall give."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.kinematics import structure_matrix
from turnbuckle.model.workspace.rows import Array


class Demand(NamedTuple):
    """Forces up to `force` [N] together with moments up to `moment` [N], divided by the lever.

    `space` is the number of forces in a wrench. To be unpacked after tension bounds.
    """

    force: float
    moment: float
    space: int


def structures(machine: Machine, poses: npt.ArrayLike, rails: npt.ArrayLike) -> Array:
    """Structure matrices (..., d, n) for poses (..., dim) and rail coordinates (..., m) [m].

    All rows in newtons: moments are divided by the machine's lever. NaN where the platform touches
    a pulley.
    """
    s = np.array(structure_matrix(machine, poses, rails), np.float64)
    s[..., machine.space :, :] /= machine.lever
    return s


def target_demand(machine: Machine) -> Demand:
    """What the machine file wants everywhere in its target."""
    target = machine.target
    return Demand(target.force, target.moment / machine.lever, machine.space)
