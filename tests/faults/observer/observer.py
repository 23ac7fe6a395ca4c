"""The ears: hands every frame on every bus to whom it concerns, by its identifier alone."""

from collections.abc import Callable, Sequence

from observer.causes import Cause
from observer.drive import WatchedDrive
from observer.watch import MachineWatch
from observer.wire import Wire
from turnbuckle.lab.drives.bus import Listener, SimulatedBus
from turnbuckle.lab.drives.node import Frame
from turnbuckle.model.bus.frames import (
    EMERGENCY,
    HEARTBEAT,
    RPDO,
    SDO_ANSWER,
    SDO_REQUEST,
    SYNC,
    TPDO,
)
from turnbuckle.model.bus.tables import MASTER_NODE
from turnbuckle.model.machine import Machine

NMT, NODE = 0x000, 0x07F
RESETS = (0x81, 0x82)
SAID_BY_DRIVES = {EMERGENCY, SDO_ANSWER, HEARTBEAT, *range(TPDO, TPDO + 0x400, 0x100)}

Hear = Callable[[bytes, float], None]
"""Takes the data of a frame, and when it had arrived [s]."""
Tap = Callable[[int, Frame], None]


class Observer:
    """Listens to the buses of a machine; `findings` has what broke a promise, in words.

    taps: where what the master sends is told before anything can happen to it (Lockstep.taps).
    Without them the frames on the wire are taken for what it sent, which is right while no frame of
    the master is lost, changed, doubled or delayed.
    """

    def __init__(
        self,
        machine: Machine,
        buses: Sequence[SimulatedBus],
        taps: list[Tap] | None = None,
    ) -> None:
        self._watch = MachineWatch(machine)
        self.findings: list[str] = self._watch.findings
        self._of_master = [self._masters(wire) for wire in self._watch.wires]
        self._of_drives = [self._said(wire) for wire in self._watch.wires]
        for number, bus in enumerate(buses):
            bus.listeners.append(self._listener(number, bus, taps is None))
        if taps is not None:
            taps.append(self._tap(buses))

    def hear(self, bus: int, frame: Frame, time: float) -> None:
        """A frame had arrived on a bus at that time [s]."""
        if frame.cob in self._of_master[bus]:
            self.hear_master(bus, frame, time)
        else:
            self.hear_drive(bus, frame, time)

    def hear_master(self, bus: int, frame: Frame, time: float) -> None:
        """The master sent a frame."""
        hear = self._of_master[bus].get(frame.cob)
        if hear is not None:
            hear(frame.data, time)

    def hear_drive(self, bus: int, frame: Frame, time: float) -> None:
        """A drive sent a frame, or somebody whom the machine file does not have."""
        hear = self._of_drives[bus].get(frame.cob)
        if hear is not None:
            hear(frame.data, time)
        elif self._is_strange(bus, frame.cob):
            watch = self._watch
            watch.blame(Cause.STRANGER, watch.wires[bus].name, watch.times.seen(time), time)

    def _is_strange(self, bus: int, cob: int) -> bool:
        drives = self._watch.drives_on(self._watch.wires[bus])
        known = {0, MASTER_NODE, *(drive.axis.drive.node for drive in drives)}
        return cob & ~NODE in SAID_BY_DRIVES and cob & NODE not in known

    def _listener(self, number: int, bus: SimulatedBus, is_all: bool) -> Listener:
        masters = self._of_master[number]
        known = self._of_drives[number] | (masters if is_all else {})

        def listen(frame: Frame, from_drive: bool) -> None:
            cob, data = frame
            hear = known.get(cob)
            if hear is not None:
                hear(data, bus.time)
            elif cob not in masters:
                self.hear_drive(number, frame, bus.time)

        return listen

    def _tap(self, buses: Sequence[SimulatedBus]) -> Tap:
        masters = self._of_master

        def tap(number: int, frame: Frame) -> None:
            cob, data = frame
            hear = masters[number].get(cob)
            if hear is not None:
                hear(data, buses[number].time)

        return tap

    def _masters(self, wire: Wire) -> dict[int, Hear]:
        """What the master says on a bus."""
        watch = self._watch
        drives = watch.drives_on(wire)

        def sync(data: bytes, time: float) -> None:
            cycle = watch.times.cycle(time)
            for drive in drives:
                drive.end_interval(cycle, time)
            wire.synchronise(cycle)
            watch.synchronise(cycle, time)

        def nmt(data: bytes, time: float) -> None:
            for drive in drives:
                if len(data) == 2 and data[0] in RESETS and data[1] in (0, drive.axis.drive.node):
                    watch.reset(drive)

        def beat(data: bytes, time: float) -> None:
            watch.beats_withheld(wire, time)

        hear: dict[int, Hear] = {SYNC: sync, NMT: nmt, HEARTBEAT + MASTER_NODE: beat}
        for drive in drives:
            hear[RPDO + drive.axis.drive.node] = drive.setpoint
            hear[SDO_REQUEST + drive.axis.drive.node] = drive.contract.ask
        return hear

    def _said(self, wire: Wire) -> dict[int, Hear]:
        """What the drives of a bus say."""
        hear: dict[int, Hear] = {}
        for drive in self._watch.drives_on(wire):
            node = drive.axis.drive.node
            hear[TPDO + node] = drive.answer
            hear[EMERGENCY + node] = drive.emergency
            hear[HEARTBEAT + node] = drive.heartbeat
            hear[SDO_ANSWER + node] = self._reply(drive)
        return hear

    def _reply(self, drive: WatchedDrive) -> Hear:
        watch = self._watch

        def reply(data: bytes, time: float) -> None:
            cause = drive.contract.answer(data)
            if cause is not None:
                watch.blame(cause, drive.name, watch.times.seen(time), time)

        return reply
