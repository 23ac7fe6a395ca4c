"""Random tension problems: structure matrices and wrenches of one machine."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import kinematics

Reals = NDArray[np.float64]


@dataclass(frozen=True)
class TensionProblems:
    """Problems min |T|, S T = W, T_min <= T <= T_max, as contiguous arrays."""

    name: str
    machine: Machine
    structure: Reals  # (count, d, n), 1
    wrench: Reals  # (count, d), N

    @property
    def count(self) -> int:
        """Number of problems."""
        return len(self.wrench)


def tension_problems(machine: Machine, count: int, seed: int) -> list[TensionProblems]:
    """Moving and corner bases, each with feasible wrenches and with a mix."""
    random = np.random.default_rng(seed)
    poses = random_poses(machine, count, random)
    rails = random_rails(machine, count, random)
    structures = {
        "movable bases": kinematics.structure_matrix(machine, poses, rails),
        "corner bases": corner_structure(machine, poses),
    }
    return [
        TensionProblems(f"{bases}, {wrenches.__name__} wrenches", machine, *arrays)
        for bases, structure in structures.items()
        for wrenches in (feasible, mixed)
        for arrays in [wrenches(machine, np.ascontiguousarray(structure, np.float64), random)]
    ]


def random_poses(machine: Machine, count: int, random: np.random.Generator) -> Reals:
    """Poses (count, d) [m] spread evenly over the target area."""
    centre, half = np.array(machine.target.centre), np.array(machine.target.size) / 2
    return random.uniform(centre - half, centre + half, (count, machine.dof))


def random_rails(machine: Machine, count: int, random: np.random.Generator) -> Reals:
    """Rail coordinates (count, m) [m] anywhere on the rails."""
    lengths = [rail.length for rail in machine.rails]
    return random.uniform(0.0, lengths, (count, len(lengths)))


def corner_structure(machine: Machine, poses: Reals) -> Reals:
    """Structure matrices (count, d, 4) with a base in each corner of the frame."""
    width, height = machine.frame.size
    corners = np.array([[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]])
    vectors = corners - poses[:, None, :]
    return np.swapaxes(vectors / np.linalg.norm(vectors, axis=2, keepdims=True), 1, 2)


def feasible(
    machine: Machine, structure: Reals, random: np.random.Generator
) -> tuple[Reals, Reals]:
    """Wrenches that random admissible tensions exert."""
    shape = structure.shape[0], structure.shape[2]
    tension = random.uniform(machine.tension.min, machine.tension.max, shape)
    return structure, np.einsum("kij,kj->ki", structure, tension)


def mixed(machine: Machine, structure: Reals, random: np.random.Generator) -> tuple[Reals, Reals]:
    """Wrenches of any direction up to T_max along each axis: many of them infeasible."""
    bound = machine.tension.max
    return structure, random.uniform(-bound, bound, structure.shape[:2])
