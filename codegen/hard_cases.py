"""Arguments where generated functions are likeliest to fail, beside those of ordinary operation.

Platforms at and beside a pulley, bases a hair from their targets, cables along one line or nearly
so, wrenches of nothing, on a vertex, on an edge, on a kink of the least-norm tensions.
"""

import numpy as np
from numpy.typing import NDArray

from codegen.samples import Sampler
from model.machine import Machine

Array = NDArray[np.float64]

#: Every so many points are one hard case of each kind; the others are as in operation.
POSE_CYCLE, STRUCTURE_CYCLE, WRENCH_CYCLE = 16, 12, 8


class HardSampler(Sampler):
    """Draws consistent arguments by name, a good part of them hard."""

    def __init__(self, machine: Machine, seed: int, count: int) -> None:
        super().__init__(machine, seed, count)
        self.shift_rails_a_little(self.every(POSE_CYCLE, 1))
        self.move_to_a_pulley(self.every(POSE_CYCLE, 0))
        self.vectors = self.base_points() - self.pose[:, None, :]
        self.lengths = np.sqrt((self.vectors**2).sum(axis=2))
        safe = np.where(self.lengths > 0, self.lengths, 1.0)
        self.structure = np.swapaxes(self.vectors / safe[:, :, None], 1, 2)
        if machine.dof == 2:
            self.bend_structure()

    def every(self, cycle: int, place: int) -> slice:
        """The rows of one kind of case."""
        return slice(place, self.count, cycle)

    def small(self, count: int) -> Array:
        """Magnitudes from 1e-9 to 1e-2, evenly over the decades."""
        drawn: Array = 10.0 ** self.random.uniform(-9, -2, (count, 1))
        return drawn

    def shift_rails_a_little(self, rows: slice) -> None:
        """Bases beside where they were: nearly on a border, nearly at their targets."""
        rails = self.rails[rows]
        noise = self.random.standard_normal(rails.shape) * self.small(len(rails))
        ends = [rail.length for rail in self.machine.rails]
        self.rails[rows] = np.clip(rails + noise, 0.0, ends) if ends else rails

    def move_to_a_pulley(self, rows: slice) -> None:
        """The platform at a pulley, within the frame."""
        points = self.base_points()[rows]
        chosen = points[
            np.arange(len(points)), self.random.integers(0, points.shape[1], len(points))
        ]
        away = self.random.standard_normal(chosen.shape) * self.small(len(points))
        self.pose[rows] = np.clip(chosen + away, 0.0, self.machine.frame.size)

    def bend_structure(self) -> None:
        """Structures that no pose of this machine has: any angles, one line or nearly, axes."""
        count = len(self.machine.cables)
        anywhere, line, axes = (self.every(STRUCTURE_CYCLE, k) for k in range(3))
        angles = self.random.uniform(0, 2 * np.pi, (self.count, count))
        common = self.random.uniform(0, 2 * np.pi, (self.count, 1))
        turned = np.pi * self.random.integers(0, 2, (self.count, count))
        spread = self.random.standard_normal((self.count, count)) * self.small(self.count)
        self.structure[anywhere] = directions(angles[anywhere])
        self.structure[line] = directions((common + turned + spread)[line])
        quarters = self.random.integers(0, 4, (self.count, count)) * np.pi / 2
        self.structure[axes] = np.round(directions(quarters[axes]))

    def wrenches(self) -> Array:
        """Those of operation, and: nothing, one axis, vertices, edges, kinks of the tensions."""
        wrench = super().wrenches()
        low, high = self.machine.tension.min, self.machine.tension.max
        shape = (self.count, len(self.machine.cables))
        vertex = np.where(self.random.random(shape) < 0.5, low, high)
        edge = vertex.copy()
        edge[np.arange(self.count), self.random.integers(0, shape[1], self.count)] = (
            self.random.uniform(low, high, self.count)
        )
        multiplier = self.random.standard_normal((self.count, self.machine.dof)) * high
        kink = np.clip(np.einsum("kdn,kd->kn", self.structure, multiplier), low, high)
        cases = [np.einsum("kdn,kn->kd", self.structure, t) for t in (vertex, edge, kink)]
        axis = np.where(np.arange(self.machine.dof) == 0, wrench, 0.0)
        for place, case in enumerate([np.zeros_like(wrench), axis, *cases]):
            rows = self.every(WRENCH_CYCLE, place)
            wrench[rows] = case[rows]
        return wrench


def directions(angles: Array) -> Array:
    """Structures (count, 2, n) of cables at some angles."""
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)
