"""What is mapped: one planar machine, its bases somewhere."""

from dataclasses import dataclass

import numpy as np

from turnbuckle.lab.benchmark.tension_problems import Reals
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import control, kinematics


@dataclass(frozen=True)
class Scene:
    """Bases that stay at `rails` (m) [m], or follow the platform `lag` (d) [m] behind."""

    name: str
    machine: Machine
    rails: tuple[float, ...] | None = None
    lag: tuple[float, ...] | None = None

    def rails_at(self, poses: Reals) -> Reals:
        """Rail coordinates (count, m) [m] at poses (count, d)."""
        if self.rails is not None:
            return np.broadcast_to(np.array(self.rails), (len(poses), len(self.rails)))
        return np.asarray(control.base_targets(self.machine, poses - np.array(self.lag)), float)

    def base_points(self, poses: Reals) -> Reals:
        """Pulley points [m], one array (n, count) for each of the d directions."""
        points = kinematics.base_points(self.machine, self.rails_at(poses))
        return np.ascontiguousarray(np.moveaxis(points, (-1, -2), (0, 1)), float)


def scenes(machine: Machine) -> list[Scene]:
    """Bases at the platform's feet, behind them, and in the corners of the frame as if fixed."""
    width, height = machine.frame.size
    return [
        Scene("bases at their targets", machine, lag=(0.0, 0.0)),
        Scene("bases 36 mm behind", machine, lag=(0.03, 0.02)),
        Scene("bases in the corners", machine, rails=(0.0, 0.0, width, height)),
    ]
