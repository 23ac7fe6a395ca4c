"""One simulated drive: a CANopen node with a servo behind it.

The owner hands in frames (receive), time (step, which gives the motor's torque) and the motor's
angle (turn); what the drive sends goes to `send`. Nothing here waits or reads a clock.
"""

from collections.abc import Callable
from enum import IntEnum
from functools import partial
from math import inf
from struct import Struct

from canopen.sdo.exceptions import SdoAbortedError

from turnbuckle.lab.drives import errors, pdo
from turnbuckle.lab.drives.node import NOT_ALLOWED, WRONG_STATE, Frame, Objects, SdoNode, Send
from turnbuckle.lab.drives.objects import HISTORY, dictionary
from turnbuckle.lab.drives.pdo import SYNCHRONOUS, ProcessData, ReceivePdo
from turnbuckle.lab.drives.power import Power
from turnbuckle.lab.drives.servo import Servo
from turnbuckle.lab.drives.setup import Setup
from turnbuckle.model.bus.drive_kinds.entry import Entry, Key

SYNC = 0x080
EMERGENCY = 0x080
HEARTBEAT = 0x700
EMERGENCY_LAYOUT = Struct("<HB5x")

SIGNATURES = {0x1010: 0x65766173, 0x1011: 0x64616F6C}
"""What has to be written to store ("save") and to restore ("load") parameters."""
CANNOT_STORE = 0x08000020
POWER_OFF = (Power.NOT_READY, Power.OFF, Power.READY, Power.FAULT)
"""States in which the power stage carries nothing."""


class Nmt(IntEnum):
    """NMT states, as the heartbeat tells them."""

    BOOTING = 0x00
    STOPPED = 0x04
    OPERATIONAL = 0x05
    PRE_OPERATIONAL = 0x7F


class NmtCommand(IntEnum):
    """What an NMT frame commands."""

    START = 0x01
    STOP = 0x02
    ENTER_PRE_OPERATIONAL = 0x80
    RESET_NODE = 0x81
    RESET_COMMUNICATION = 0x82


AFTER_HEARTBEAT_LOSS = {0: Nmt.PRE_OPERATIONAL, 2: Nmt.STOPPED}
"""By object 1029:1; 1 changes nothing."""


class Drive:
    """The drive.

    Faults to be set by a test: raise_error, refuse, shut_down, silent here; false_statusword,
    given, encoder.distort, encoder.jump and homing.fail in `servo`. A wrong identity is the
    setup's.
    """

    def __init__(self, setup: Setup, send: Send) -> None:
        self.setup, self.node = setup, setup.node
        self.nmt = Nmt.BOOTING
        self.time = 0.0  # s
        self.silent = False
        """Fault: nothing that the drive sends reaches the bus."""
        self._send = send
        self._objects = Objects(dictionary(setup.kind))
        self.describe()
        self.servo = Servo(self._objects, setup.ratings, setup.start_count)
        self._pdos = ProcessData(self._objects)
        self._handlers: dict[int, Callable[[bytes], None]] = {}
        self._sdo = SdoNode(
            setup.node,
            self._objects,
            self._transmit,
            check=self._check_write,
            written=self._take_over,
            refresh=self._refresh,
        )
        self._restart(setup.boot_time)

    def receive(self, cob: int, data: bytes, since: float = 0.0) -> None:
        """A frame on the bus, from anyone but this drive; since: the last turn [s]."""
        if cob == SYNC:
            if self.nmt is Nmt.OPERATIONAL:
                self.servo.encoder.look(since)
                self._synchronise()
            return
        handler = self._handlers.get(cob)
        if handler is not None and self.nmt is not Nmt.BOOTING:
            handler(data)

    def step(self, seconds: float) -> float:
        """Let time pass; the motor's torque [N m] during it."""
        self.time += seconds
        if self.time >= self._due:
            self._run_timers()
        if self.servo.following_error():
            self.raise_error(errors.FOLLOWING_ERROR)
        torque = self.servo.drive(seconds)
        if self._pdos.events and self.nmt is Nmt.OPERATIONAL:
            self._send_events()
        return torque

    def turn(self, angle: float, seconds: float) -> None:
        """The motor's angle [rad], so long after it was last told."""
        self.servo.encoder.turn(angle, seconds)

    def read(self, index: int, subindex: int = 0) -> int:
        """A number of the object dictionary, as an SDO upload would give it."""
        self._refresh()
        return self._objects[index, subindex]

    def refuse(self, key: Key, code: int) -> None:
        """Fault: every SDO access to an object is aborted with this code."""
        self._sdo.refusals[key] = code

    def raise_error(self, code: int) -> None:
        """An error occurs: emergency message, error history, and the reaction to this code."""
        register = self._objects[0x1001, 0] | errors.register_bits(code)
        self._objects.put((0x1001, 0), register)
        self._remember_error(code)
        self._send_emergency(code, register)
        self.servo.react(code)

    def shut_down(self) -> None:
        """The supply fails: no torque, no frames."""
        self.nmt, self._due = Nmt.BOOTING, inf
        self.servo.restart()

    def switch_on(self) -> None:
        """The supply comes back: everything as after power-on."""
        self._objects.restore(lambda index: True)
        self.describe()
        self.servo.switch_on()
        self._restart(self.setup.boot_time)

    # -- what a drive is ----------------------------------------------------------------------

    def describe(self) -> None:
        """Tell by objects what the setup says: identity, number, ratings."""
        put, ratings, identity = self._objects.put, self.setup.ratings, self.setup.identity
        numbers = identity.vendor, identity.product, identity.revision, identity.serial
        for sub, number in enumerate(numbers, start=1):
            put((0x1018, sub), number)
        put((0x1014, 0), EMERGENCY + self.node)
        put((0x1200, 1), 0x600 + self.node)
        put((0x1200, 2), 0x580 + self.node)
        motor = self.setup.kind.motor
        for place, quantity in motor.read:
            put(place.key, place.number(quantity(ratings), ratings))
        put(motor.current_limit.key, motor.current_limit.number(ratings.current_limit, ratings))

    # -- network management -------------------------------------------------------------------

    def _restart(self, seconds: float) -> None:
        """Communication as delivered; boots for so long, without torque."""
        self._objects.restore(lambda index: index in (0x1016, 0x1017, 0x1029))
        pdo.set_defaults(self._objects, self.node)
        self.nmt = Nmt.BOOTING
        self.servo.restart()
        self._booted = self.time + seconds
        self._next_beat = inf
        self._deadlines: dict[int, float] = {}
        self._connect()
        self._plan_timers()

    def _connect(self) -> None:
        """Listen to what concerns this drive."""
        self._pdos.compile()
        self._handlers = {0x000: self._obey_nmt, 0x600 + self.node: self._take_request}
        for node, _ in self._consumers():
            self._handlers[HEARTBEAT + node] = partial(self._hear_heartbeat, node)
        for cob, receive in self._pdos.receive.items():
            self._handlers[cob] = partial(self._take_pdo, receive)

    def _obey_nmt(self, data: bytes) -> None:
        if len(data) != 2 or data[1] not in (0, self.node):
            return
        match data[0]:
            case NmtCommand.START:
                self._connect()
                self._enter(Nmt.OPERATIONAL)
            case NmtCommand.STOP:
                self._enter(Nmt.STOPPED)
                self.servo.abort_connection()
            case NmtCommand.ENTER_PRE_OPERATIONAL:
                self._enter(Nmt.PRE_OPERATIONAL)
            case NmtCommand.RESET_NODE:
                self.switch_on()
            case NmtCommand.RESET_COMMUNICATION:
                self._restart(self.setup.restart_time)

    def _enter(self, state: Nmt) -> None:
        self.nmt = state

    def _take_request(self, data: bytes) -> None:
        if self.nmt is not Nmt.STOPPED:
            self._sdo.request(data)

    # -- time ---------------------------------------------------------------------------------

    def _plan_timers(self) -> None:
        waiting = self._booted if self.nmt is Nmt.BOOTING else self._next_beat
        self._due = min(waiting, *self._deadlines.values(), inf)

    def _run_timers(self) -> None:
        if self.nmt is Nmt.BOOTING:
            self._finish_booting()
        if self.time >= self._next_beat:
            self._next_beat += self._objects[0x1017, 0] * 1e-3
            self._transmit(Frame(HEARTBEAT + self.node, bytes([self.nmt])))
        for node, deadline in list(self._deadlines.items()):
            if self.time >= deadline:
                del self._deadlines[node]
                self._lose_heartbeat()
        self._plan_timers()

    def _finish_booting(self) -> None:
        self.nmt = Nmt.PRE_OPERATIONAL
        self.servo.get_ready()
        self._transmit(Frame(HEARTBEAT + self.node, bytes([Nmt.BOOTING])))

    def _consumers(self) -> list[tuple[int, float]]:
        """Nodes whose heartbeat is watched, and the time [s] it may take."""
        values = (self._objects[0x1016, sub] for sub in (1, 2))
        pairs = [(value >> 16 & 0x7F, (value & 0xFFFF) * 1e-3) for value in values]
        return [(node, time) for node, time in pairs if node and time]

    def _hear_heartbeat(self, node: int, data: bytes) -> None:
        """Watching begins with the first heartbeat."""
        self._deadlines[node] = self.time + dict(self._consumers())[node]
        self._plan_timers()

    def _lose_heartbeat(self) -> None:
        self.raise_error(errors.HEARTBEAT_LOST)
        self._enter(AFTER_HEARTBEAT_LOSS.get(self._after_error, self.nmt))

    @property
    def _after_error(self) -> int:
        """Object 1029:1, where the drive has it; else what CiA 301 says."""
        key = 0x1029, 1
        return self._objects[key] if key in self._objects.entries else 0

    # -- process data -------------------------------------------------------------------------

    def _synchronise(self) -> None:
        """Sample first, then apply: what came since the last SYNC shows at the next one."""
        self._refresh()
        for frame in self._pdos.sample():
            self._transmit(frame)
        if self._pdos.apply():
            self._obey()

    def _take_pdo(self, receive: ReceivePdo, data: bytes) -> None:
        if self.nmt is not Nmt.OPERATIONAL:
            return
        if not receive.take(data):
            self.raise_error(errors.RECEIVE_LENGTH)
        elif receive.type not in SYNCHRONOUS:
            receive.apply()
            self._obey()

    def _send_events(self) -> None:
        self._refresh()
        for event in self._pdos.events:
            frame = event.event(self.time)
            if frame is not None:
                self._transmit(frame)

    def _obey(self) -> None:
        if self.servo.obey():
            self._objects.put((0x1001, 0), 0)
            self._send_emergency(errors.NO_ERROR, 0)

    def _refresh(self) -> None:
        self._objects.signals.statusword = self.servo.statusword(self.nmt is Nmt.OPERATIONAL)
        self.servo.refresh()

    # -- objects ------------------------------------------------------------------------------

    def _check_write(self, entry: Entry, value: int) -> None:
        """Refuse what this drive does not take in its state."""
        if entry.power_off and self.servo.power not in POWER_OFF:
            raise SdoAbortedError(WRONG_STATE)
        if entry.key == (0x1003, 0) and value != 0:
            raise SdoAbortedError(NOT_ALLOWED)
        if value != SIGNATURES.get(entry.index, value):
            raise SdoAbortedError(CANNOT_STORE)
        if pdo.is_pdo_object(entry.index):
            pre_operational = self.nmt is Nmt.PRE_OPERATIONAL
            pdo.check_write(self._objects, entry, value, pre_operational)

    def _take_over(self, entry: Entry, value: int) -> None:
        """An object was written by SDO."""
        if entry.key in [place.key for place in self.setup.kind.motor.places]:
            self.servo.read_ratings()
        match entry.index:
            case 0x1003:
                for sub in range(1, HISTORY + 1):
                    self._objects.put((0x1003, sub), 0)
            case 0x1016:
                self._deadlines.clear()
                self._connect()
                self._plan_timers()
            case 0x1017:
                self._next_beat = self.time + value * 1e-3 if value else inf
                self._plan_timers()
            case 0x6040 | 0x607A:
                self._obey()

    # -- errors -------------------------------------------------------------------------------

    def _remember_error(self, code: int) -> None:
        """The newest error comes first."""
        objects = self._objects
        for sub in range(HISTORY, 1, -1):
            objects.put((0x1003, sub), objects[0x1003, sub - 1])
        objects.put((0x1003, 1), code)
        objects.put((0x1003, 0), min(HISTORY, objects[0x1003, 0] + 1))

    def _send_emergency(self, code: int, register: int) -> None:
        if self.nmt in (Nmt.PRE_OPERATIONAL, Nmt.OPERATIONAL):
            data = EMERGENCY_LAYOUT.pack(code, register)
            self._transmit(Frame(EMERGENCY + self.node, data))

    def _transmit(self, frame: Frame) -> None:
        if not self.silent:
            self._send(frame)
