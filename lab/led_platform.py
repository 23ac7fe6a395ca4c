"""A platform of any kind that a hand holds fast and leads along a path: geometry without dynamics.

Cables are always taut, motors turn as the lengths change, and no force moves anything: enough to
bring a machine up on its buses, to find its zeros, and to compute forces that nobody feels.
"""

from collections.abc import Callable, Sequence
from math import pi, sin

import numpy as np

from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import MachineError, Problem
from turnbuckle.model.reference.kinematics import cable_lengths

SHARE = 0.6
"""Share of the target that the path covers, and of the rotation that is wanted there."""
RHYTHMS = (0.23, 0.31, 0.41, 0.17, 0.29, 0.37)
"""Frequencies of the coordinates [Hz]; no two poses of a path are the same for long."""


def wandering(machine: Machine, share: float = SHARE) -> Callable[[float], np.ndarray]:
    """A path through a share of the target: pose (d) [m, rad] at a time [s], at rest in the centre
    at 0."""
    target, turns = machine.target, machine.dof - machine.space
    reach = [share / 2 * size for size in target.size]
    reach += [share * (target.rotation or 0.0) / turns**0.5] * turns
    centre = np.array([*target.centre, *[0.0] * turns])

    def at(time: float) -> np.ndarray:
        begun = min(time, 1.0)  # a hand does not jerk
        waves = [
            size * sin(2 * pi * rate * time) for size, rate in zip(reach, RHYTHMS, strict=False)
        ]
        return centre + begun * begun * (3.0 - 2.0 * begun) * np.array(waves)

    return at


class LedPlatform:
    """The world of SimulatedMachine for machines with fixed bases that no plant is known of.

    time [s]; position: pose (d) [m, rad]; tensions [N] are what the motors pull with.
    """

    def __init__(self, machine: Machine) -> None:
        if machine.rails:
            found, allowed = "rails", "fixed bases, for a platform that is led by hand"
            raise MachineError(machine.path, [Problem("cable", found, allowed)])
        self._machine = machine
        self._path = wandering(machine)
        self._period = 1.0 / machine.control.rate
        self._led_since: float | None = None
        self.time = 0.0
        self.rails: list[float] = []
        self.tensions = [0.0] * len(machine.cables)
        self.hand_force = self.cable_force = (0.0,) * machine.dof
        self._look()

    def lead(self) -> None:
        """The hand begins to lead the platform."""
        if self._led_since is None:
            self._led_since = self.time

    def advance(self, torques: Sequence[float], rail_forces: Sequence[float]) -> None:
        """Let one control cycle pass; torques [N m] (n) of the motors."""
        self.time += self._period
        radius = self._machine.drum.radius
        self.tensions = [max(0.0, torque / radius) for torque in torques]
        self.lowest_tension, self.highest_tension = min(self.tensions), max(self.tensions)
        self._look()

    def _look(self) -> None:
        since = 0.0 if self._led_since is None else self.time - self._led_since
        self.position = self._path(since)
        self.lengths = cable_lengths(self._machine, self.position, []).tolist()
