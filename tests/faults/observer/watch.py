"""All drives and buses of a machine together: what one shows, and what the others are told."""

from collections.abc import Sequence
from dataclasses import replace

from observer.causes import Cause
from observer.drive import WatchedDrive
from observer.limits import times
from observer.power import Power
from observer.promises import Findings, Promise
from observer.stops import Stop
from observer.wire import Wire
from turnbuckle.model.bus.axis import axes
from turnbuckle.model.machine import Machine

IN_FLIGHT = 2
"""Cycles that a frame of the master may be under way."""


class MachineWatch:
    """Judges cycle by cycle; a cycle is closed two cycles later, when all its frames have come."""

    def __init__(self, machine: Machine) -> None:
        self.findings = Findings()
        self.times = times(machine)
        rate = machine.control.rate
        self.wires = [Wire(bus.name, round(rate / bus.rate), self.times) for bus in machine.buses]
        self.drives = [
            WatchedDrive(
                machine, axis, self.wires[axis.bus], self.times, self.blame, self.findings.add
            )
            for axis in axes(machine)
        ]
        for drive in self.drives:
            drive.on_changed = self._count
        self._cables = [drive for drive in self.drives if drive.is_cable]
        self._cycle = self._closed = -1
        self._pulling = 0
        self._is_armed = self._is_fault = False
        self._faulted_by: int | None = None
        """Cycle from which on the machine is in FAULT whatever its drives do."""
        self._barred: tuple[int, str] | None = None
        """Since which cycle, and why, nothing may be switched on before a reset."""
        self._not_reset: set[str] = set()
        self._stop: Stop | None = None

    def drives_on(self, wire: Wire) -> Sequence[WatchedDrive]:
        """The drives of a bus."""
        return [drive for drive in self.drives if drive.wire is wire]

    # -- what is heard ------------------------------------------------------------------------

    def synchronise(self, cycle: int, time: float) -> None:
        """A SYNC came in a cycle, maybe the first of several."""
        if cycle == self._cycle:
            return
        if cycle > self._cycle + 1 and self._cycle >= 0:
            self._miss_cycles(cycle, time)
        if not cycle & 7:
            self._look_at_clocks(self._cycle, time)
        self._cycle = cycle
        for past in range(self._closed + 1, cycle - 1):
            self._close(past)
        self._closed = max(self._closed, cycle - 2)

    def _miss_cycles(self, cycle: int, time: float) -> None:
        """The master did nothing; what arrived meanwhile it sees now."""
        if self._stop is not None and self._stop.begin > self._cycle:
            self._stop = replace(self._stop, begin=cycle)
        if self._is_armed and cycle - self._cycle - 1 > self.times.skipped:
            self.blame(Cause.CYCLES_MISSED, "master", cycle, time)

    def reset(self, drive: WatchedDrive) -> None:
        """Communication of a drive begins anew."""
        drive.reset()
        self._not_reset.discard(drive.name)
        if not self._not_reset:
            self._barred, self._is_fault, self._faulted_by = None, False, None
        self._count()

    def blame(self, cause: Cause, culprit: str, cycle: int, time: float) -> None:
        """A cause has shown; the reaction must begin in a cycle."""
        if not self._is_armed:
            self._bar(cycle, f"{cause.name} of {culprit} in cycle {cycle}")
            return
        stop, drives = self._stop, self.drives
        if stop is None or stop.yields_to(cause, cycle):
            find, times = self.findings.add, self.times
            self._stop = Stop(cause, culprit, cycle, drives, times, find)

    def beats_withheld(self, wire: Wire, time: float) -> None:
        """The master's heartbeat, which is withheld in HARD_STOP and FAULT until all are off."""
        wire.beat = self.times.cycle(time)
        stop = self._stop
        is_hard = stop is not None and stop.is_hard and self._cycle >= stop.begin + IN_FLIGHT
        if not is_hard and not self._is_fault:
            return
        for drive in self.drives:
            if drive.power.may_pull and drive.is_known:
                what = f"heartbeat on {wire.name} while it shows {drive.power.words}"
                self.findings.add(time, drive.name, Promise.BEATS_WITHHELD, what)

    # -- cycle by cycle -----------------------------------------------------------------------

    def _close(self, cycle: int) -> None:
        if self._stop is not None:
            self._stop.judge(cycle)
        if 0 < self._pulling < len(self._cables):
            self.together(cycle)
        if self._is_armed:
            self.switched_off_loose(cycle)
            self._disarm(cycle)
        elif self._barred is not None:
            self.stays_in_fault(cycle)
        self._is_fault = self._is_fault or cycle == self._faulted_by

    def together(self, cycle: int) -> None:
        """What stops one drive stops all: no cable pulls long while another one is switched off."""
        first = cycle - self.times.slacken - 1
        cables = [drive for drive in self._cables if drive.wire.cycle > cycle]
        off = [drive for drive in cables if not drive.is_enabled and drive.disabled_in <= first]
        for drive in cables if off else ():
            if all(drive.pull(at) > 0 for at in range(first, cycle + 1)):
                what = f"pulls on while {off[0].name} is switched off"
                self._found(cycle, drive, Promise.TOGETHER, what)

    def switched_off_loose(self, cycle: int) -> None:
        """Cable drives are switched off when no cable pulls."""
        for drive in self._cables:
            if drive.disabled_in != cycle or drive.power_when_disabled is not Power.ENABLED:
                continue
            for other in self._cables:
                if other.wire.cycle > cycle and other.pull(cycle) > 0:
                    what = f"switched off while {other.name} pulls"
                    self._found(cycle, drive, Promise.HARD_BASES, what)

    def stays_in_fault(self, cycle: int) -> None:
        """In FAULT nothing has torque until a reset."""
        assert self._barred is not None
        since, why = self._barred
        for drive in self.drives:
            if max(drive.last_enabling, drive.arming_since) > since + IN_FLIGHT:
                what = f"is switched on again after {why}"
                self._found(cycle, drive, Promise.STAYS_IN_FAULT, what)

    def _disarm(self, cycle: int) -> None:
        """Everything that hears the master is switched off: the stop is over."""
        heard = [drive for drive in self.drives if drive.wire.is_served(cycle)]
        if any(drive.is_armed for drive in heard):
            return
        stop, self._stop, self._is_armed = self._stop, None, False
        if stop is not None:
            self._bar(cycle, stop.name)
        self._count()

    def _bar(self, cycle: int, why: str) -> None:
        if self._barred is None:
            self._barred = cycle, why
            self._faulted_by = cycle + self.times.drive_timeout
            self._not_reset = {drive.name for drive in self.drives}

    # -- time ---------------------------------------------------------------------------------

    def _look_at_clocks(self, cycle: int, time: float) -> None:
        # A bus that misses a SYNC may be off, which stops hard: heartbeats may be withheld then.
        is_whole = all(cycle - wire.cycle < wire.divider for wire in self.wires)
        for wire in self.wires:
            if is_whole:
                self.beats_at_work(wire, cycle, time)
            elif wire.cycle >= 0 and not wire.is_served(cycle):
                due = wire.lost_in + wire.divider - 1
                self.blame(Cause.BUS_FULL, wire.name, due, time)
        for drive in self.drives:
            drive.look_at_clock(cycle, time)
            if self._barred is None and drive.stands_in_fault(cycle):
                self._found(cycle, drive, Promise.FAULTS_RESET, "no reset of its fault was tried")
            if drive.power.may_pull:
                self.lets_go_alone(drive, time)

    def beats_at_work(self, wire: Wire, cycle: int, time: float) -> None:
        """While cables may pull, the master's heartbeat is there in time."""
        cause = self._stop.cause if self._stop is not None else None
        is_soft = cause is None or not (cause.is_hard or cause.may_be_hard)
        most = self.times.heartbeat + self.times.skipped + IN_FLIGHT + wire.divider
        if self._is_armed and is_soft and cycle - wire.beat > most:
            what = f"none for {cycle - wire.beat} cycles"
            self.findings.add(time, wire.name, Promise.BEATS_AT_WORK, what)

    def lets_go_alone(self, drive: WatchedDrive, time: float) -> None:
        """Without the master's heartbeat a drive switches off by itself."""
        times = self.times
        alone = drive.answered_at - drive.wire.beat * times.period
        most = times.heartbeat_timeout + (drive.wire.divider + IN_FLIGHT + 1) * times.period
        if drive.is_known and not drive.is_let_go and alone > most:
            what = f"still shows {drive.power.words} {alone * 1e3:.0f} ms without it"
            self.findings.add(time, drive.name, Promise.LETS_GO_ALONE, what)

    # -- beginnings ---------------------------------------------------------------------------

    def _count(self) -> None:
        """A drive's power state, its orders, or whether it is told to pull, have changed."""
        pulling = sum(drive.value != 0 and drive.is_enabled for drive in self._cables)
        if pulling > self._pulling and self._stop is None:
            self.none_alone()
        self._pulling = pulling
        is_on = any(drive.is_armed for drive in self.drives)
        if is_on and not self._is_armed and self._barred is None:
            self._is_armed = True
            self.findings.forget()
            self.set_up_first()
        for drive in self.drives:
            drive.is_watched = self._is_armed

    def none_alone(self) -> None:
        """No cable begins to pull before all can."""
        for drive in self._cables:
            if drive.power is not Power.ENABLED:
                what = f"shows {drive.power.words} while another cable is told to pull"
                self._found(self._cycle, drive, Promise.NONE_ALONE, what)

    def set_up_first(self) -> None:
        """Identity and contract of all drives were seen to before the first is switched on."""
        for drive in self.drives:
            for promise, wrong in (
                (Promise.IDENTITY_FIRST, drive.contract.missing_identity()),
                (Promise.SET_UP_FIRST, drive.contract.missing()),
            ):
                if wrong:
                    self._found(self._cycle, drive, promise, f"{', '.join(wrong[:4])}: not as due")
            if drive.power in (Power.FAULT, Power.REACTING):
                self._found(self._cycle, drive, Promise.NO_TORQUE_BEFORE, "armed, in fault")

    def _found(self, cycle: int, drive: WatchedDrive, promise: Promise, what: str) -> None:
        time = cycle * self.times.period
        self.findings.add(time, drive.name, promise, f"cycle {cycle}: {what}")
