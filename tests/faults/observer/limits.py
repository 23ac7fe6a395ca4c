"""The numbers of a machine file in the units of the wire: cycles, per mille, encoder counts."""

from dataclasses import dataclass
from math import ceil, floor

from turnbuckle.model.bus.axis import Axis
from turnbuckle.model.bus.plan import compute_phase, loads, timing
from turnbuckle.model.machine import Machine

ROUNDING = 1e-9


@dataclass(frozen=True)
class Times:
    """Of the whole machine, in control cycles where nothing else is said."""

    period: float
    """A control cycle [s]."""
    phase: float
    """From a cycle's begin until the master has read the answers [s]."""
    heartbeat: int
    drive_timeout: int
    heartbeat_timeout: float
    """Without the master's heartbeat until a drive lets go [s]."""
    state_timeout: int
    stop: int
    slacken: int
    """From any torque to none at the gate's rate."""
    missed: int
    skipped: int
    blocked: int

    @property
    def half_stop(self) -> int:
        """Of a soft stop."""
        return self.stop // 2

    def seen(self, time: float) -> int:
        """The cycle in which the master sees what arrives at a time [s]."""
        cycle = self.cycle(time)
        return cycle + (time - cycle * self.period > self.phase + ROUNDING)

    def cycle(self, time: float) -> int:
        """The cycle that a time [s] is in."""
        return floor(time / self.period + ROUNDING)


def times(machine: Machine) -> Times:
    """The times of a machine file."""
    limits, period = machine.supervision, 1.0 / machine.control.rate
    motor = machine.cable_motor

    def cycles(time: float) -> int:
        return ceil(time / period - ROUNDING)

    return Times(
        period=period,
        phase=compute_phase(loads(machine), timing(machine)),
        heartbeat=cycles(limits.heartbeat),
        drive_timeout=cycles(limits.drive_timeout),
        heartbeat_timeout=limits.heartbeat_timeout,
        state_timeout=cycles(limits.state_timeout),
        stop=cycles(limits.stop_time),
        slacken=ceil(motor.torque_limit / (motor.torque_rate_limit * period) - ROUNDING),
        missed=limits.missed_syncs,
        skipped=limits.skipped_cycles,
        blocked=cycles(limits.blocked_time),
    )


@dataclass(frozen=True)
class Bounds:
    """Of one drive: setpoints in its units, pulls (> 0) in per mille, moves in counts a SYNC."""

    lowest: int
    highest: int
    step: int
    """Largest change of a setpoint from one SYNC to the next."""
    weakest: int
    """The torque of tension.min."""
    soft_step: int
    """Most that a soft stop takes off a cable in one SYNC."""
    deaf: float
    """An eighth of the torque limit."""
    move: float
    """At the speed limit."""
    travel: float
    """Motion of a blocked carriage that is none yet [counts]."""


def bounds(machine: Machine, axis: Axis) -> Bounds:
    """The bounds of a drive."""
    limits, period = machine.supervision, 1.0 / machine.buses[axis.bus].rate
    unit, count = abs(axis.torque_per_unit), abs(axis.metres_per_increment)
    is_cable, most = axis.rail is None, axis.most_torque_units
    rate = machine.cable_motor.torque_rate_limit if is_cable else limits.rail_torque_rate
    speed = limits.cable_speed if is_cable else limits.rail_speed
    lowest, highest = sorted((0, axis.sense * most)) if is_cable else (-most, most)
    step = floor(rate * period / unit + ROUNDING) + 1
    if axis.drive.mode == "position":
        lowest, highest = -0x80000000, 0x7FFFFFFF
        step = ceil(speed * period / count) + 1
    return Bounds(
        lowest=lowest,
        highest=highest,
        step=step,
        weakest=round(machine.tension.min * axis.radius / unit),
        soft_step=ceil(most / (limits.stop_time / period / 2)) + 1,
        deaf=axis.torque_limit / unit / 8,
        move=speed * period / count,
        travel=limits.blocked_travel / count,
    )
