"""A whole machine in simulation: its drives on their buses, its physics, and a hand on the handle.

Drives are numbered as in the runtime: cable drives in the order of the cables, then base drives in
that of the rails. A cycle is: frames to and from the buses, then `advance`.
"""

import random
from collections.abc import Sequence

from lab.drives.bus import SimulatedBus
from lab.drives.drive import Drive
from lab.drives.setup import Identity, Ratings, Setup
from lab.hand import Cue, Hand
from lab.plant import PlanarPlant
from lab.strand import Pair
from lab.task import Task
from model.bus.axis import Axis, axes
from model.machine import Machine, Plant
from model.problem import MachineError, Problem

PRODUCT, REVISION = 0x61500000, 0x01700000
"""What a simulated drive says it is, where the machine file does not care."""
MILLI, MICRO = 1e3, 1e6


class SimulatedMachine:
    """Drives, buses and plant of a machine; everything in simulated time.

    The hand holds the handle where the task begins, and follows the task from `begin_task` on.
    """

    def __init__(
        self, machine: Machine, plant: Plant, task: Task, rails: Sequence[float] | None = None
    ) -> None:
        """Power-on, the handle at the start of the task, the bases at `rails` [m] (m); without
        them anywhere, but always at the same places."""
        self._axes = axes(machine)
        if not self._axes:
            raise MachineError(
                machine.path,
                [Problem("bus", "nothing", "a table [[bus]], which the simulated drives need")],
            )
        self.task = task
        self.period = 1.0 / machine.control.rate
        self._cue = Cue(task.path)
        start = task.path.at(0.0)[0]
        at = anywhere(machine) if rails is None else rails
        self.world = PlanarPlant(machine, plant, Hand(plant, self._cue), start, at)
        self._cables = len(machine.cables)
        self._pinion = machine.rail_drive.pinion_radius if machine.rail_drive else 1.0
        self._radians = [axis.sense / axis.radius for axis in self._axes]
        self.buses = [SimulatedBus(bus.name, []) for bus in machine.buses]
        self.drives = [self._mount(axis, machine, plant) for axis in self._axes]
        self._strangers: list[Drive] = []
        self._at_power_on = self.world.lengths
        self._look()

    @property
    def time(self) -> float:
        """Since power-on [s]."""
        return self.world.time

    def run_until(self, time: float) -> None:
        """Let simulated time pass, in whole control cycles."""
        while self.time + self.period < time + 1e-9:
            self.advance()

    def begin_task(self, repeat: bool = False) -> None:
        """The hand begins to move, once through the task or over and over."""
        self._cue.begin(self.world.time, repeat)

    @property
    def task_force(self) -> Pair:
        """Force [N] that the application wants now."""
        return self.task.force(self._cue.elapsed(self.world.time))

    @property
    def hand_goal(self) -> Pair:
        """Where the hand wants the handle now [m]."""
        return self._cue.at(self.world.time)[0]

    @property
    def positions(self) -> list[float]:
        """Cable wound in since power-on [m] (n), then rail coordinates [m] (m)."""
        wound = [
            start - length
            for start, length in zip(self._at_power_on, self.world.lengths, strict=True)
        ]
        return wound + self.world.rails

    @property
    def zeros(self) -> list[float]:
        """Lengths of the cables at power-on [m] (n): what the calibration has to find."""
        return list(self._at_power_on)

    def advance(self) -> None:
        """Let one control cycle pass."""
        period = self.period
        torques = [
            drive.step(period) * axis.sense
            for drive, axis in zip(self.drives, self._axes, strict=True)
        ]
        cables = self._cables
        self.world.advance(torques[:cables], [torque / self._pinion for torque in torques[cables:]])
        self._look()
        for stranger in self._strangers:
            stranger.step(period)
        for bus in self.buses:
            bus.next_cycle()

    def add_stranger(self, bus: int, setup: Setup) -> Drive:
        """Fault: another drive on a bus, which moves nothing; its number may be taken already."""
        self._strangers.append(self.buses[bus].add(setup))
        return self._strangers[-1]

    def _look(self) -> None:
        """Let every encoder see its motor."""
        for drive, turns, position in zip(self.drives, self._radians, self.positions, strict=True):
            drive.turn(position * turns, self.period)

    def _mount(self, axis: Axis, machine: Machine, plant: Plant) -> Drive:
        mass = plant.handle_mass if axis.rail is None else plant.carriage_mass or 0.0
        rotor = machine.cable_motor.inertia if axis.rail is None else 0.0
        inertia = rotor + mass * axis.radius**2
        return self.buses[axis.bus].add(setup(axis, inertia))


def setup(axis: Axis, inertia: float) -> Setup:
    """The drive of an axis, as it is delivered for a motor that moves `inertia` [kg m^2]."""
    rating, drive = axis.rating, axis.drive
    return Setup(
        node=drive.node,
        ratings=Ratings(
            nominal_current=round(rating.nominal_current * MILLI),
            current_limit=round(rating.current_limit * MILLI),
            torque_constant=round(rating.torque_constant * MICRO),
            encoder_pulses=rating.encoder_counts // 4,
            inertia=inertia,
        ),
        identity=Identity(
            product=PRODUCT if drive.product is None else drive.product,
            revision=REVISION if drive.revision is None else drive.revision,
        ),
    )


def anywhere(machine: Machine) -> list[float]:
    """Rail coordinates [m] (m) in which someone may have left the bases."""
    chance = random.Random(1)
    return [rail.length * chance.uniform(0.2, 0.8) for rail in machine.rails]
