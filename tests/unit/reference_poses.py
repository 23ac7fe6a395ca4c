"""Machines of every kind and poses they can take, in long double."""

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

Wide = npt.NDArray[np.floating[Any]]
NAMES = [
    "mixed_bases",
    "planar_rigid_pulleys",
    "spatial_point_straight",
    "spatial_point_planes",
    "spatial_rigid_eight",
    "spatial_rigid_pulleys",
]
WIDE_EPS = float(np.finfo(np.longdouble).eps)


def machine_of(name: str) -> Machine:
    return load_machine(Path("tests/machines") / f"{name}.toml")


def random_poses(machine: Machine, count: int) -> tuple[Wide, Wide]:
    """Poses (count, d) in the target, turned as far as the platform can; rails (count, m)."""
    rng = np.random.default_rng(count)
    centre, size = np.array(machine.target.centre), np.array(machine.target.size)
    pose = np.zeros((count, machine.dof), np.longdouble)
    pose[:, : machine.space] = centre + rng.uniform(-0.5, 0.5, (count, machine.space)) * size
    turns = rng.uniform(-1, 1, (count, machine.dof - machine.space))
    pose[:, machine.space :] = machine.rotation * turns / np.sqrt(max(turns.shape[1], 1))
    lengths = np.array([rail.length for rail in machine.rails])
    rails = rng.uniform(0, 1, (count, len(lengths))) * lengths
    return pose, rails.astype(np.longdouble)
