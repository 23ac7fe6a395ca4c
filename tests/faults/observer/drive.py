"""One drive on the wire: what it is told and what it says, and the causes that show in it."""

from collections.abc import Callable
from struct import Struct

from observer.causes import HEARTBEAT_LOST, WARNINGS, Cause
from observer.contract import HOMING_MODE, Contract
from observer.limits import Bounds, Times, bounds
from observer.motion import Motion
from observer.power import (
    COMMAND,
    ENABLE,
    FAULT_RESET,
    HOMING_ERROR,
    ORDERED,
    POWERS,
    REFERENCED,
    START_HOMING,
    Power,
)
from observer.promises import Promise
from observer.wire import Wire
from turnbuckle.model.bus.axis import Axis
from turnbuckle.model.machine import Machine

ANSWER, EMERGENCY = Struct("<Hih"), Struct("<HB5x")
TORQUE_SETPOINT, POSITION_SETPOINT = Struct("<Hh"), Struct("<Hi")
OPERATIONAL, BOOT_UP = 0x05, 0x00
KEPT = 16
"""Cycles whose setpoints are remembered; a power of two."""
LATENCY = 3
"""Words until the drive's answer must show the first: ordered, followed, told."""

Blame = Callable[[Cause, str, int, float], None]
"""Told of a cause, its culprit, the cycle in which the reaction must begin, and the time [s]."""
Find = Callable[[float, str, Promise, str], None]
"""Told of a time [s], whom a broken promise concerns, the promise, and how it was broken."""


class WatchedDrive:
    """Everything known of one drive."""

    def __init__(
        self, machine: Machine, axis: Axis, wire: Wire, times: Times, blame: Blame, find: Find
    ) -> None:
        self.axis, self.name, self.wire, self.times = axis, axis.drive.name, wire, times
        self.is_cable = axis.rail is None
        self.follows_torque = axis.drive.mode == "torque"
        self.bounds: Bounds = bounds(machine, axis)
        self.contract = Contract(machine, axis)
        self._blame, self._find = blame, find
        self._motion = Motion(self.is_cable, self.bounds, times, self._accuse)
        self._layout = TORQUE_SETPOINT if self.follows_torque else POSITION_SETPOINT
        self.on_changed: Callable[[], None] = lambda: None
        """Told when its power state, its orders, or whether it is told to pull, have changed."""
        self.is_watched = False
        """Some drive of the machine is ordered to power."""
        self.reset()

    def reset(self) -> None:
        """Its communication begins anew: nothing is known."""
        self.contract.reset()
        self._motion.reset()
        self.word = self.value = self._applied = self._pending = self._enabling = 0
        self.arming_since = self.last_enabling = self.disabled_in = self._told = -1
        self._cycles, self._values = [-1] * KEPT, [0] * KEPT
        self.served_since: int | None = None
        """Cycle of the first setpoint."""
        self._status, self.power, self.answered_at = -1, Power.NOT_READY, 0.0
        self.is_known = True
        """Its statusword is one of CiA 402."""
        self.powerless_since: int | None = -1
        """Cycle since which it shows that it cannot pull."""
        self.power_when_disabled: Power | None = None
        self.is_let_go = False
        """It says that it misses the master's heartbeat."""
        self._came_up_in_fault = self._was_asked_to_recover = False
        self._answers = self._unanswered = self._late = self._booted = 0
        self._beat_at: float | None = None
        self._waits_since: int | None = None
        """Cycle since which it has not reached the power state that it was ordered to."""

    # -- what the master tells it -------------------------------------------------------------

    def setpoint(self, data: bytes, time: float) -> None:
        """RPDO1."""
        if len(data) != self._layout.size:
            self._find(time, self.name, Promise.WITHIN_LIMITS, f"setpoint of {len(data)} bytes")
            return
        word, value = self._layout.unpack(data)
        cycle = self.wire.cycle
        if self._told == cycle:
            self._find(time, self.name, Promise.ONE_A_SYNC, "a second setpoint before the SYNC")
        self._told = cycle
        if word != self.word:
            self._change_word(word, cycle)
        if word & COMMAND == ENABLE:
            self.last_enabling = cycle
            self._enabling += 1
            bounds, change = self.bounds, value - self.value
            if not bounds.lowest <= value <= bounds.highest or abs(change) > bounds.step:
                self._judge(value, change, time)
        pulled, self.value = self.value, value
        place = cycle & KEPT - 1
        self._cycles[place] = cycle
        self._values[place] = value if word & COMMAND == ENABLE else 0
        self._applied, self._pending = self._pending, value
        if self.served_since is None:
            self.served_since = cycle
        if (value == 0) != (pulled == 0):
            self.on_changed()

    def _change_word(self, word: int, cycle: int) -> None:
        before, self.word = self.word, word
        self._was_asked_to_recover = self._was_asked_to_recover or bool(word & FAULT_RESET)
        if word & COMMAND == before & COMMAND:
            return
        if self.is_armed and before & COMMAND not in ORDERED:
            self.arming_since = cycle
        if before & COMMAND == ENABLE:
            self.disabled_in = cycle
            self.power_when_disabled = self.power if self.is_known else None
        if self.follows_torque and not self.is_enabled:
            self.value = 0
        self._enabling = 0
        self._motion.forget_torque()
        self._await_power(cycle)
        self.on_changed()

    def _judge(self, value: int, change: int, time: float) -> None:
        bounds = self.bounds
        if not bounds.lowest <= value <= bounds.highest:
            what = f"{value} is not within {bounds.lowest} .. {bounds.highest}"
            self._find(time, self.name, Promise.WITHIN_LIMITS, what)
        # From zero to a first position there is no rate.
        if abs(change) > bounds.step and (self.follows_torque or self._enabling > 1):
            what = f"changed by {change}, at most {bounds.step} are allowed"
            self._find(time, self.name, Promise.WITHIN_RATE, what)

    def stands_in_fault(self, cycle: int) -> bool:
        """Whether it came up in fault, and nothing was done about that for too long."""
        if self.served_since is None or self._was_asked_to_recover:
            return False
        return self._came_up_in_fault and cycle - self.served_since > self.times.state_timeout

    @property
    def is_enabled(self) -> bool:
        """Whether its last word lets it have torque."""
        return self.word & COMMAND == ENABLE

    @property
    def is_armed(self) -> bool:
        """Whether its last word orders a power state other than off."""
        return self.word & COMMAND in ORDERED

    def pull(self, cycle: int) -> int:
        """What it was told to pull in a cycle, or last before it [per mille]; 0 when it was to be
        without torque."""
        for back in range(KEPT):
            place = cycle - back & KEPT - 1
            if self._cycles[place] == cycle - back:
                return self._values[place] * self.axis.sense
        return self.value * self.axis.sense

    # -- what it says -------------------------------------------------------------------------

    def answer(self, data: bytes, time: float) -> None:
        """TPDO1."""
        if len(data) != ANSWER.size:
            return
        status, position, torque = ANSWER.unpack(data)
        self._answers += 1
        self.answered_at = time
        if time > self.wire.due:
            self._come_late(time)
        elif self._late or self._unanswered:
            self._late = self._unanswered = 0
        if status != self._status:
            self._change_status(status, time)
        motion = self._motion
        if motion.is_fast(position) and self.served_since is not None:
            motion.judge_move(self._is_referenced, time)
        if self._enabling < LATENCY or self.power is not Power.ENABLED:
            return
        if self.follows_torque and self.contract.mode != HOMING_MODE:
            motion.compare(self._applied, torque, time)
            if not self.is_cable:
                motion.push(self._applied, torque, time)

    @property
    def _is_referenced(self) -> bool:
        """Whether its position is one that may not jump."""
        if self.is_cable:
            return True
        return self.contract.mode != HOMING_MODE and bool(self._status & REFERENCED)

    def _change_status(self, status: int, time: float) -> None:
        is_first, self._status = self._status < 0, status
        power, seen = POWERS[status & 0x7F], self.times.seen(time)
        self.is_known = power is not None
        if power is None:
            if self.served_since is not None:
                self._accuse(Cause.DRIVE_STATE, seen, time)
            return
        if is_first:
            self._came_up_in_fault = power is Power.FAULT
        if status & HOMING_ERROR and self._is_homing:
            self._accuse(Cause.HOMING, seen, time)
        if power is not self.power:
            self._change_power(power, seen, time)

    def _change_power(self, power: Power, seen: int, time: float) -> None:
        before, self.power = self.power, power
        if power is Power.ENABLED:
            self.powerless_since = None
        elif self.powerless_since is None:
            self.powerless_since = seen
        self._await_power(seen)
        if power in (Power.FAULT, Power.REACTING):
            if self.is_watched:
                self._accuse(Cause.DRIVE_FAULT, seen, time)
        elif before is Power.ENABLED and self._enabling >= LATENCY:
            self._accuse(Cause.DRIVE_STATE, seen, time)
        self.on_changed()

    @property
    def _is_homing(self) -> bool:
        is_asked = self.word & START_HOMING != 0 and self._enabling > LATENCY
        return is_asked and self.contract.mode == HOMING_MODE

    def emergency(self, data: bytes, time: float) -> None:
        """An emergency message."""
        if len(data) != EMERGENCY.size:
            return
        (code, _) = EMERGENCY.unpack(data)
        self.is_let_go = self.is_let_go or code == HEARTBEAT_LOST
        if code not in WARNINGS and self.is_watched:
            self._accuse(Cause.DRIVE_FAULT, self.times.seen(time), time)

    def heartbeat(self, data: bytes, time: float) -> None:
        """A heartbeat or boot-up message."""
        if len(data) != 1:
            return
        state, seen = data[0] & 0x7F, self.times.seen(time)
        if state == OPERATIONAL:
            self._beat_at = time
        elif self.served_since is not None:
            self._accuse(Cause.DRIVE_SILENT, seen, time)
        if state == BOOT_UP:
            self._booted += 1
            if self._booted > 1 and not self.is_watched:
                self._accuse(Cause.DRIVE_TWICE, seen, time)
            self.power = Power.NOT_READY
            self.on_changed()

    def _come_late(self, time: float) -> None:
        """An answer after its turn; a second one is that to an earlier SYNC."""
        if self._answers > 1:
            return
        self._late, self._unanswered = self._late + 1, 0
        if self._late > self.times.missed and self.served_since is not None:
            self._accuse(Cause.DRIVE_LATE, self.times.seen(time), time)

    # -- what does not happen -----------------------------------------------------------------

    def end_interval(self, cycle: int, time: float) -> None:
        """The next SYNC has come, in this cycle."""
        if self._answers == 0 and self.served_since is not None:
            self._unanswered, self._late = self._unanswered + 1, 0
            self._motion.is_known = False
            if self._unanswered > self.times.missed:
                self._accuse(Cause.DRIVE_SILENT, cycle - 1, time)
        self._answers = 0

    def look_at_clock(self, cycle: int, time: float) -> None:
        """What shows in nothing happening, up to a cycle."""
        since = self._waits_since
        if since is not None and self.is_watched and cycle - since > self.times.state_timeout:
            self._accuse(Cause.DRIVE_STUCK, since + self.times.state_timeout + 1, time)
        if self.served_since is not None and self._beat_at is not None:
            due = self.times.seen(self._beat_at) + self.times.drive_timeout + 1
            if cycle > due:
                self._accuse(Cause.DRIVE_SILENT, due, time)

    def _await_power(self, cycle: int) -> None:
        due = ORDERED.get(self.word & COMMAND)
        if due is None or due is self.power:
            self._waits_since = None
        elif self._waits_since is None:
            self._waits_since = cycle

    def _accuse(self, cause: Cause, cycle: int, time: float) -> None:
        self._blame(cause, self.name, cycle, time)
