"""A whole machine in simulation: its drives on their buses, its physics, and a hand on the handle.

Drives are numbered as in the runtime: cable drives in the order of the cables, then base drives in
that of the rails. Frames move while time passes (`run_until`); drives and physics are integrated a
control cycle at a time.
"""

import random
from collections.abc import Sequence

from turnbuckle.lab.drives.bus import SimulatedBus
from turnbuckle.lab.drives.drive import Drive
from turnbuckle.lab.drives.setup import Identity, Ratings, Setup
from turnbuckle.lab.drives.wire import Conditions, wires
from turnbuckle.lab.hand import Cue, hand_of
from turnbuckle.lab.led_platform import LedPlatform
from turnbuckle.lab.plant import SimulatedPlant
from turnbuckle.lab.plants import simulated_plant
from turnbuckle.lab.task import Task
from turnbuckle.model.base import Coordinates
from turnbuckle.model.bus.axis import Axis, axes
from turnbuckle.model.machine import Machine, Plant
from turnbuckle.model.problem import MachineError, Problem

ORDINARY = Conditions()
ROUNDING = 1e-9
"""By which a sum of cycles may miss a time [s]."""


class SimulatedMachine:
    """Drives, buses and plant of a machine; everything in simulated time.

    The hand holds the handle where the task begins, and follows the task from `begin_task` on. It
    moves the handle about from `wander` on, as the calibration of fixed bases asks. Without a plant
    and a task the hand holds the platform fast, and leads it about from `wander` on.
    """

    def __init__(
        self,
        machine: Machine,
        plant: Plant | None,
        task: Task | None,
        rails: Sequence[float] | None = None,
        conditions: Conditions = ORDINARY,
    ) -> None:
        """Power-on, the handle at the start of the task, the bases at `rails` [m] (m); without
        them anywhere, but always at the same places. conditions: on the wires."""
        self._axes = axes(machine)
        if not self._axes:
            raise MachineError(
                machine.path,
                [Problem("bus", "nothing", "a table [[bus]], which the simulated drives need")],
            )
        self.task = task
        self.period = 1.0 / machine.control.rate
        self._dof = machine.dof
        self._cue: Cue | None = None
        self.world = self._make_world(machine, plant, anywhere(machine) if rails is None else rails)
        self._cables = len(machine.cables)
        self._pinion = machine.rail_drive.pinion_radius if machine.rail_drive else 1.0
        self._radians = [axis.sense / axis.radius for axis in self._axes]
        self.compute_time = machine.supervision.compute_time
        """From reading the drives' answers until commands are ready [s]."""
        self._cycles = 0
        named = zip(machine.buses, wires(machine, conditions), strict=True)
        self.buses = [SimulatedBus(bus.name, [], wire) for bus, wire in named]
        self.drives = [self._mount(axis, machine, plant) for axis in self._axes]
        self._strangers: list[Drive] = []
        self._at_power_on = self.world.lengths
        self._look()

    def _make_world(
        self, machine: Machine, plant: Plant | None, rails: Sequence[float]
    ) -> SimulatedPlant | LedPlatform:
        if plant is None or self.task is None:
            return LedPlatform(machine)
        self._cue = Cue(self.task.path, self.task.round_trip)
        start = self.task.path.at(0.0)[0]
        return simulated_plant(machine, plant, hand_of(machine, plant, self._cue), start, rails)

    @property
    def plant(self) -> SimulatedPlant:
        """The physics of a machine that has a plant."""
        assert not isinstance(self.world, LedPlatform)
        return self.world

    def wander(self) -> None:
        """The hand begins to move the handle about, where no base does."""
        if self.world.rails:
            return
        if isinstance(self.world, LedPlatform):
            self.world.lead()
        elif self._cue is not None:
            self._cue.wander(self.world.time)

    def begin_task(self, repeat: bool = False) -> None:
        """The hand begins to move, once through the task or over and over."""
        if self._cue is not None:
            self._cue.begin(self.world.time, repeat)

    @property
    def task_force(self) -> Coordinates:
        """Force (d) [N, N m] that the application wants now."""
        if self.task is None or self._cue is None:
            return (0.0,) * self._dof
        return self.task.force(self._cue.elapsed(self.world.time))

    @property
    def hand_goal(self) -> Coordinates:
        """Where the hand wants the handle of a machine with a plant now: pose (d) [m, rad]."""
        assert self._cue is not None
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

    @property
    def time(self) -> float:
        """Until when time has passed [s]."""
        return self.buses[0].time

    def run_until(self, time: float) -> None:
        """Let time pass until then [s]."""
        while (end := (self._cycles + 1) * self.period) <= time + ROUNDING:
            self._move_frames(end)
            self._end_cycle()
        self._move_frames(time)

    def advance(self) -> None:
        """Let time pass until the end of the control cycle."""
        self.run_until((self._cycles + 1) * self.period)

    def _move_frames(self, time: float) -> None:
        for bus in self.buses:
            bus.run_until(time)

    def _end_cycle(self) -> None:
        """Let drives and physics catch up with the cycle that is over."""
        self._cycles += 1
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

    def _mount(self, axis: Axis, machine: Machine, plant: Plant | None) -> Drive:
        handle, carriage = (plant.handle_mass, plant.carriage_mass) if plant else (0.0, 0.0)
        mass = handle if axis.rail is None else carriage or 0.0
        rotor = machine.cable_motor.inertia if axis.rail is None else 0.0
        inertia = rotor + mass * axis.radius**2
        return self.buses[axis.bus].add(setup(axis, inertia))


def setup(axis: Axis, inertia: float) -> Setup:
    """The drive of an axis, as it is delivered for a motor that moves `inertia` [kg m^2]."""
    rating, drive, kind = axis.rating, axis.drive, axis.kind
    said = kind.simulated
    return Setup(
        node=drive.node,
        kind=kind,
        ratings=Ratings(
            nominal_current=rating.nominal_current,
            current_limit=rating.current_limit,
            torque_constant=rating.torque_constant,
            encoder_counts=rating.encoder_counts,
            inertia=inertia,
        ),
        identity=Identity(
            vendor=kind.vendor,
            product=said.product if drive.product is None else drive.product,
            revision=said.revision if drive.revision is None else drive.revision,
        ),
    )


def anywhere(machine: Machine) -> list[float]:
    """Rail coordinates [m] (m) in which someone may have left the bases."""
    chance = random.Random(1)
    return [rail.length * chance.uniform(0.2, 0.8) for rail in machine.rails]
