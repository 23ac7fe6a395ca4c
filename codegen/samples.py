"""Points of a machine's working domain at which generated functions are tried.

A share of all coordinates sits on a border or in the middle, where kinematics are singular and
tensions meet their bounds. The same seed gives the same points everywhere.
"""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.evaluate import DOUBLE, evaluate
from turnbuckle.codegen.lower import lower
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import base_targets, kinematic_functions
from turnbuckle.model.symbolic.function import ModelFunction

Array = NDArray[np.float64]

#: Share of the coordinates that is put on a border, and in the middle.
BORDER_SHARE, MIDDLE_SHARE = 0.1, 0.05
#: Fraction of the samples whose bases are at their targets, as in operation.
TRACKING_SHARE = 0.5
#: How far a guess is from the pose: in position, as a part of the frame, and in rotation [rad].
GUESS_SHARE, GUESS_ROTATION = 0.05, 0.1


class Sampler:
    """Draws consistent arguments by name.

    What follows from a pose comes from the model itself, run with the operations of the C alone, so
    that samples, and what is found with them, are the same on every machine.
    """

    def __init__(self, machine: Machine, seed: int, count: int) -> None:
        self.machine = machine
        self.random = np.random.default_rng(seed)
        self.count = count
        self.pose = self.draw_pose()
        self.rails = self.draw_rails()
        self.look()

    def look(self) -> None:
        """Lengths and structure at the poses; zero where the platform is at a pulley."""
        at = [self.pose, self.rails]
        shape = (self.count, self.machine.dof, len(self.machine.cables))
        self.lengths = self.modelled(kinematic_functions.cable_lengths_function(self.machine), at)
        structure = self.modelled(kinematic_functions.structure_matrix_function(self.machine), at)
        self.structure = structure.reshape(shape)

    def modelled(self, function: ModelFunction, arguments: Sequence[Array]) -> Array:
        """The first output of a function of the model (count, size), 0 where it has none."""
        result = evaluate(lower(function), list(arguments), DOUBLE).outputs[0]
        columns = [np.broadcast_to(entry, (self.count,)) for entry in result]
        values = np.stack(columns, axis=1) if columns else np.zeros((self.count, 0))
        return np.where(np.isfinite(values), values, 0.0)

    def draw_pose(self) -> Array:
        """Poses in the frame, turned as far as the machine file allows."""
        turns = self.machine.dof - self.machine.space
        position = self.box([0.0] * self.machine.space, self.machine.frame.size)
        if not self.machine.is_rigid:
            return position
        rotation = self.symmetric(turns, self.machine.rotation)
        angle = np.sqrt(np.sum(rotation**2, axis=1, keepdims=True))
        excess = np.maximum(angle / self.machine.rotation, 1.0)
        return np.concatenate([position, rotation / excess], axis=1)

    def box(self, low: Sequence[float], high: Sequence[float]) -> Array:
        """Points of a box, with the shares on its borders and in its middle."""
        lows, highs = np.asarray(low, dtype=float), np.asarray(high, dtype=float)
        shape = (self.count, len(lows))
        fraction = self.random.random(shape)
        kind = self.random.random(shape)
        side = self.random.integers(0, 2, shape).astype(float)
        fraction = np.where(kind < BORDER_SHARE, side, fraction)
        fraction = np.where(kind > 1 - MIDDLE_SHARE, 0.5, fraction)
        points: Array = lows + fraction * (highs - lows)
        return points

    def draw_rails(self) -> Array:
        """Rail coordinates: half of them where the bases would follow the platform."""
        lengths = [rail.length for rail in self.machine.rails]
        anywhere = self.box([0.0] * len(lengths), lengths)
        if not lengths:
            return anywhere
        tracking = self.modelled(base_targets.base_targets_function(self.machine), [self.pose])
        follows = self.random.random((self.count, 1)) < TRACKING_SHARE
        return np.where(follows, tracking, anywhere)

    def symmetric(self, size: int, bound: float) -> Array:
        """Entries within +-bound."""
        return self.box([-bound] * size, [bound] * size)

    def tensions(self) -> Array:
        """Cable tensions from T_min to T_max, some on the bounds."""
        low, high = self.machine.tension.min, self.machine.tension.max
        count = len(self.machine.cables)
        return self.box([low] * count, [high] * count)

    def wrenches(self) -> Array:
        """Wrenches of admissible tensions, scaled to lie inside, on or beyond the border."""
        exerted = np.einsum("kdn,kn->kd", self.structure, self.tensions())
        scale = self.random.choice([0.0, 0.5, 1.0, 1.0, 1.5], (self.count, 1))
        anything = self.symmetric(self.machine.dof, 2 * self.machine.tension.max) * self.levers()
        return np.where(self.random.random((self.count, 1)) < 0.7, scale * exerted, anything)

    def levers(self) -> Array:
        """What turns forces into wrenches of the same effect: 1 a force, the lever [m] a moment."""
        moments = np.arange(self.machine.dof) >= self.machine.space
        return np.where(moments, self.machine.lever, 1.0)

    def guesses(self) -> Array:
        """Poses beside the true ones: what the last cycle found, and much farther off."""
        reach = GUESS_SHARE * max(self.machine.frame.size)
        moments = np.arange(self.machine.dof) >= self.machine.space
        return self.pose + self.symmetric(self.machine.dof, 1.0) * np.where(
            moments, GUESS_ROTATION, reach
        )

    def forces(self, size: int) -> Array:
        """Sizes of forces, from a hundredth of T_max to twice that."""
        most = self.machine.tension.max
        return self.box([0.01 * most] * size, [2 * most] * size)

    def memory(self, columns: Sequence[float], count: int) -> Array:
        """Remembered quantities, each column within its own bound."""
        return np.stack([self.symmetric(count, bound) for bound in columns], axis=2).reshape(
            self.count, -1
        )

    def argument(self, function: str, name: str, size: int) -> Array:
        """Values of one argument (count, size)."""
        special = _SPECIAL.get((function, name)) or _BY_NAME[name]
        return special(self, size).reshape(self.count, size)


def _observer_memory(sampler: Sampler, size: int) -> Array:
    torque = sampler.machine.tension.max * sampler.machine.drum.radius
    count = len(sampler.machine.cables)
    rest = sampler.memory([300.0, torque, torque, torque], count).reshape(sampler.count, count, 4)
    step = sampler.symmetric(count, 1e-3)
    return np.concatenate([(sampler.lengths + step)[:, :, None], rest], axis=2)


def _pid_memory(sampler: Sampler, size: int) -> Array:
    drive = sampler.machine.rail_drive
    assert drive is not None
    count = len(sampler.machine.rails)
    rest = sampler.memory([drive.force_limit, 1.0], count).reshape(sampler.count, count, 2)
    measured = sampler.rails + sampler.symmetric(count, 1e-3)
    return np.stack([rest[:, :, 0], measured, rest[:, :, 1]], axis=2)


_BY_NAME: dict[str, Callable[[Sampler, int], Array]] = {
    "pose": lambda s, _: s.pose,
    "rails": lambda s, _: s.rails,
    "target": lambda s, _: s.rails,
    "measured": lambda s, _: s.rails + s.symmetric(s.rails.shape[1], 0.01),
    "lengths": lambda s, _: s.lengths,
    "length": lambda s, _: s.lengths,
    "structure": lambda s, _: s.structure,
    "tension": lambda s, _: s.tensions(),
    "load": lambda s, _: s.tensions(),
    "wrench": lambda s, _: s.wrenches(),
    "hand_force": lambda s, size: s.symmetric(size, s.machine.tension.max) * s.levers(),
    "guess": lambda s, _: s.guesses(),
    "force": lambda s, size: s.forces(size),
    "velocity": lambda s, size: s.symmetric(size, 1.0),
    "length_rates": lambda s, size: s.symmetric(size, 1.0),
    "rail_rates": lambda s, size: s.symmetric(size, 1.0),
    "applied": lambda s, size: s.symmetric(size, s.machine.cable_motor.torque_limit),
}
_SPECIAL: dict[tuple[str, str], Callable[[Sampler, int], Array]] = {
    ("observe_disturbance", "memory"): _observer_memory,
    ("base_pid", "memory"): _pid_memory,
}
