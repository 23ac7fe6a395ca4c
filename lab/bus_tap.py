"""Listens to the buses of a simulated machine: setpoints that must not be, a log, a fingerprint."""

import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from math import ceil
from struct import Struct
from typing import TextIO

from turnbuckle.lab.drives.bus import Listener, SimulatedBus
from turnbuckle.lab.drives.node import Frame
from turnbuckle.model.bus.axis import Axis, axes
from turnbuckle.model.machine import Machine

NMT, SYNC, RPDO = 0x000, 0x080, 0x200
START = 0x01
ENABLED = 0x0F
TORQUE_SETPOINT, POSITION_SETPOINT = Struct("<Hh"), Struct("<Hi")
MOST_KEPT = 100
"""Findings that are kept; more are counted."""


@dataclass
class _Setpoints:
    """What is known of one drive's setpoints."""

    axis: Axis
    lowest: int
    highest: int
    step: int  # largest change from one SYNC to the next
    layout: Struct
    last: int | None = None
    begun: bool = False
    since_sync: int = 0

    @property
    def follows_torque(self) -> bool:
        return self.layout is TORQUE_SETPOINT


class SetpointWatch:
    """Checks every setpoint: within limits and rate, one for each SYNC.

    Give it to Lockstep.taps for what the master sends, or let it listen to what arrives. findings:
    what was wrong, in words; count: how often; seen: setpoints.
    """

    def __init__(self, machine: Machine) -> None:
        self.findings: list[str] = []
        self.count = 0
        self.seen = 0
        self._syncs = 0
        self._watched = {
            (axis.bus, RPDO + axis.drive.node): _watched(machine, axis) for axis in axes(machine)
        }
        self._of_bus: list[list[_Setpoints]] = [[] for _ in machine.buses]
        for (bus, _), setpoints in self._watched.items():
            self._of_bus[bus].append(setpoints)

    def listen(self, buses: list[SimulatedBus]) -> None:
        """Check what arrives on the buses from here on."""
        for number, bus in enumerate(buses):
            bus.listeners.append(heard_from_master(number, self))

    def __call__(self, bus: int, frame: Frame) -> None:
        """A frame of the master, on a bus."""
        cob, data = frame
        if cob == SYNC:
            self._end_interval(bus)
        elif cob == NMT:
            self._hear_nmt(bus, data)
        else:
            setpoints = self._watched.get((bus, cob))
            if setpoints is not None:
                self._check(setpoints, data)

    def _end_interval(self, bus: int) -> None:
        """A SYNC takes over the setpoints before it: one of every drive."""
        self._syncs += bus == 0
        for setpoints in self._of_bus[bus]:
            if setpoints.begun and setpoints.since_sync != 1:
                self._find(setpoints, f"{setpoints.since_sync} setpoints before a SYNC, not one")
            setpoints.since_sync = 0

    def _hear_nmt(self, bus: int, data: bytes) -> None:
        """A drive that is reset or stopped is not served any more."""
        for setpoints in self._of_bus[bus]:
            if data[0] != START and data[1] in (0, setpoints.axis.drive.node):
                setpoints.begun, setpoints.last = False, None

    def _check(self, setpoints: _Setpoints, data: bytes) -> None:
        self.seen += 1
        setpoints.begun = True
        setpoints.since_sync += 1
        if len(data) != setpoints.layout.size:
            self._find(setpoints, f"{len(data)} bytes, not {setpoints.layout.size}")
            return
        word, value = setpoints.layout.unpack(data)
        if not setpoints.lowest <= value <= setpoints.highest:
            self._find(setpoints, f"{value} is outside {setpoints.lowest} .. {setpoints.highest}")
        last = setpoints.last
        if word & ENABLED != ENABLED:  # the drive gives no torque whatever the setpoint is
            value = 0 if setpoints.follows_torque else value
        elif last is not None and abs(value - last) > setpoints.step:
            self._find(setpoints, f"from {last} to {value}: more than {setpoints.step} at once")
        setpoints.last = value

    def _find(self, setpoints: _Setpoints, what: str) -> None:
        self.count += 1
        if len(self.findings) < MOST_KEPT:
            self.findings.append(f"SYNC {self._syncs}: {setpoints.axis.drive.name}: {what}")


def heard_from_master(bus: int, tell: Callable[[int, Frame], None]) -> Listener:
    """Tells of every frame on a bus that no drive sent."""

    def listen(frame: Frame, from_drive: bool) -> None:
        if not from_drive:
            tell(bus, frame)

    return listen


def _watched(machine: Machine, axis: Axis) -> _Setpoints:
    """The limits of a drive's setpoints, in its units."""
    period = 1.0 / machine.buses[axis.bus].rate
    if axis.drive.mode == "position":
        assert axis.rail is not None
        ends = axis.increments(0.0), axis.increments(machine.rails[axis.rail].length)
        step = machine.supervision.rail_speed * period / abs(axis.metres_per_increment)
        return _Setpoints(axis, min(ends) - 1, max(ends) + 1, ceil(step) + 1, POSITION_SETPOINT)
    limit = axis.most_torque_units
    lowest, highest = (-limit, limit) if axis.rail is not None else sorted((0, axis.sense * limit))
    rate = (
        machine.cable_motor.torque_rate_limit
        if axis.rail is None
        else machine.supervision.rail_torque_rate
    )
    step = rate * period / abs(axis.torque_per_unit)
    return _Setpoints(axis, lowest, highest, ceil(step) + 1, TORQUE_SETPOINT)


class Fingerprint:
    """A hash of every frame on a set of buses, in their order."""

    def __init__(self, buses: list[SimulatedBus]) -> None:
        self.frames = 0
        self._hash = hashlib.blake2b(digest_size=16)
        for number, bus in enumerate(buses):
            bus.listeners.append(self._listener(number))

    def hexdigest(self) -> str:
        """The hash so far."""
        return self._hash.hexdigest()

    def _listener(self, number: int) -> Listener:
        head = Struct("<BHB")

        def listen(frame: Frame, from_drive: bool) -> None:
            self.frames += 1
            self._hash.update(head.pack(number, frame.cob, len(frame.data)) + frame.data)

        return listen


class CandumpLog:
    """Writes what is on the buses as candump -l does; cantools, canplayer and SavvyCAN read it."""

    def __init__(self, buses: list[SimulatedBus], file: TextIO) -> None:
        self.time = 0.0
        """Seconds; whoever runs the cycles sets it."""
        self._file = file
        for bus in buses:
            bus.listeners.append(self._listener(bus.name))

    def _listener(self, name: str) -> Listener:
        def listen(frame: Frame, from_drive: bool) -> None:
            data = frame.data.hex().upper()
            self._file.write(f"({self.time:017.6f}) {name} {frame.cob:03X}#{data}\n")

        return listen
