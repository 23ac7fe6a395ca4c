"""Arguments where generated functions are likeliest to fail, beside those of ordinary operation.

Platforms at and beside a pulley, bases a hair from their targets, cables along one line or nearly
so, wrenches of nothing, on a vertex, on an edge, on a kink of the least-norm tensions.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.samples import Sampler
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import kinematic_functions
from turnbuckle.model.symbolic.function import ModelFunction

Array = NDArray[np.float64]

#: Every so many points are one hard case of each kind; the others are as in operation.
POSE_CYCLE, STRUCTURE_CYCLE, WRENCH_CYCLE = 16, 12, 8


class HardSampler(Sampler):
    """Draws consistent arguments by name, a good part of them hard."""

    def __init__(self, machine: Machine, seed: int, count: int) -> None:
        super().__init__(machine, seed, count)
        self.shift_rails_a_little(self.every(POSE_CYCLE, 1))
        self.move_to_a_pulley(self.every(POSE_CYCLE, 0))
        self.look()
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
        """The platform, or one of its anchors, at a pulley, within the frame."""
        anchors = np.array(self.machine.anchors)
        arms = self.modelled_points(
            kinematic_functions.base_points_function(self.machine), [self.rails]
        )
        points = (arms - anchors)[rows]
        space = self.machine.space
        chosen = points[
            np.arange(len(points)), self.random.integers(0, points.shape[1], len(points))
        ]
        away = self.random.standard_normal(chosen.shape) * self.small(len(points))
        self.pose[rows, :space] = np.clip(chosen + away, 0.0, self.machine.frame.size)
        self.pose[rows, space:] = 0.0

    def modelled_points(self, function: ModelFunction, arguments: Sequence[Array]) -> Array:
        """A function of the model whose result is a point for every cable (count, n, space)."""
        shape = (self.count, len(self.machine.cables), self.machine.space)
        return self.modelled(function, arguments).reshape(shape)

    def bend_structure(self) -> None:
        """Structures that no pose of this machine has: any directions, one line or nearly, axes."""
        shape = (self.count, len(self.machine.cables), self.machine.dof)
        anywhere, line, axes = (self.every(STRUCTURE_CYCLE, k) for k in range(3))
        common = self.random.standard_normal((self.count, 1, shape[2]))
        turned = self.random.choice([-1.0, 1.0], (*shape[:2], 1))
        spread = self.random.standard_normal(shape) * self.small(self.count)[:, :, None]
        along = turned * common + spread * np.sqrt(np.sum(common**2, axis=2, keepdims=True))
        signs = self.random.choice([-1.0, 1.0], shape)
        axis = self.random.integers(0, shape[2], shape[:2])[:, :, None] == np.arange(shape[2])
        self.structure[anywhere] = self.columns(self.random.standard_normal(shape))[anywhere]
        self.structure[line] = self.columns(along)[line]
        self.structure[axes] = self.columns(np.where(axis, signs, 0.0))[axes]

    def columns(self, directions: Array) -> Array:
        """Structures (count, d, n) whose columns point in these directions (count, n, d).

        Moments count by the lever.
        """
        length = np.sqrt(np.sum(directions**2, axis=2, keepdims=True))
        return np.swapaxes(directions / length * self.levers(), 1, 2)

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
        multiplier = multiplier / self.levers()
        kink = np.clip(np.einsum("kdn,kd->kn", self.structure, multiplier), low, high)
        cases = [np.einsum("kdn,kn->kd", self.structure, t) for t in (vertex, edge, kink)]
        axis = np.where(np.arange(self.machine.dof) == 0, wrench, 0.0)
        for place, case in enumerate([np.zeros_like(wrench), axis, *cases]):
            rows = self.every(WRENCH_CYCLE, place)
            wrench[rows] = case[rows]
        return wrench
