"""Bases that are late: the hand has moved on, and they are still where it was best before.

The bases stand at the targets of another pose, a `lag` [m] away in any direction; the worst of all
directions tried counts.
"""

from itertools import product
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from model.machine import Machine
from model.reference.control import base_targets
from model.workspace.quality import isotropic_forces, wanted_margin
from model.workspace.rows import Array

PLANAR_DIRECTIONS = 16


class LaggingQuality(NamedTuple):
    """Arrays (...): margin [N] of what is wanted, and I_F [N]; NaN on a pulley."""

    margin: Array
    force: Array


def directions(space: int) -> Array:
    """Unit vectors (k, space): 16 around in the plane; in space to the 26 neighbours in a cube."""
    if space == 2:
        angle = 2 * np.pi * np.arange(PLANAR_DIRECTIONS) / PLANAR_DIRECTIONS
        return np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    neighbours = np.array([d for d in product((-1.0, 0.0, 1.0), repeat=space) if any(d)])
    return np.asarray(neighbours / np.linalg.norm(neighbours, axis=-1, keepdims=True))


def lagging_quality(machine: Machine, poses: npt.ArrayLike, lag: float) -> LaggingQuality:
    """The least margin and the least I_F of poses (..., d) with bases up to `lag` [m] behind."""
    places = np.asarray(poses, np.float64)
    margin = wanted_margin(machine, places)
    force = isotropic_forces(machine, places)
    for direction in directions(machine.space):
        before = places.copy()
        before[..., : machine.space] -= lag * direction
        rails = base_targets(machine, before)
        margin = np.minimum(margin, wanted_margin(machine, places, rails))
        force = np.minimum(force, isotropic_forces(machine, places, rails))
    return LaggingQuality(margin, force)
