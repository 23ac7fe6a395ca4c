"""What every drive must hold before the machine is armed, seen in the SDO that sets it up."""

from struct import Struct

from observer.causes import Cause
from turnbuckle.model.bus.axis import Axis
from turnbuckle.model.bus.frames import RPDO, TPDO, Mapped, rpdo_map, tpdo_map
from turnbuckle.model.bus.tables import MASTER_NODE
from turnbuckle.model.machine import Machine

Key = tuple[int, int]
EXPEDITED = Struct("<BHBI")
UPLOAD, ABORT = 0x40, 0x80
INVALID = 1 << 31
COB = 0x7FF
VENDOR = 0xFB
MODES = {"torque": 10, "position": 8}
HOMING_MODE = 6
PDOS = 4


class Contract:
    """What the SDO of one drive has shown since its last reset."""

    def __init__(self, machine: Machine, axis: Axis) -> None:
        self._identity = identity(axis)
        self._written_due = contract(machine, axis)
        self._invalid_due = [
            (first + number, 1) for first in (0x1400, 0x1800) for number in range(1, PDOS)
        ]
        self.mode: int | None = None
        """The mode of work that was read back last: object 6060."""
        self.reset()

    def reset(self) -> None:
        """The drive's communication begins anew."""
        self._asked: tuple[bool, Key, int] | None = None
        self._read: dict[Key, int] = {}
        self._written: dict[Key, int] = {}
        self._confirmed: dict[Key, int] = {}
        self._read_back: dict[Key, int] = {}

    def ask(self, data: bytes, time: float = 0.0) -> None:
        """The master's request."""
        if len(data) != EXPEDITED.size:
            return
        command, index, sub, value = EXPEDITED.unpack(data)
        is_read = command == UPLOAD
        size = 4 - (command >> 2 & 3)
        self._asked = is_read, (index, sub), value & (1 << 8 * size) - 1
        if not is_read:
            self._written[index, sub] = self._asked[2]

    def answer(self, data: bytes) -> Cause | None:
        """The drive's answer, and the cause that shows in it."""
        if len(data) != EXPEDITED.size or self._asked is None:
            return None
        command, index, sub, value = EXPEDITED.unpack(data)
        is_read, key, told = self._asked
        if (index, sub) != key:
            return None
        self._asked = None
        if command == ABORT:
            return Cause.DRIVE_SETUP
        if not is_read:
            self._confirmed[key] = told
            return None
        return self._take(key, value & (1 << 8 * (4 - (command >> 2 & 3))) - 1)

    def _take(self, key: Key, value: int) -> Cause | None:
        if key in self._confirmed:
            self._read_back[key] = value
            if key == (0x6060, 0):
                self.mode = value
            return None if value == self._confirmed[key] else Cause.DRIVE_SETUP
        self._read[key] = value
        due = self._identity.get(key)
        return Cause.DRIVE_DIFFERENT if due is not None and value != due else None

    def missing_identity(self) -> list[str]:
        """Objects of the identity that were not read, or hold another value."""
        return [name(key) for key, due in self._identity.items() if self._read.get(key) != due]

    def missing(self) -> list[str]:
        """Objects of the contract that were not written and read back as they must be."""
        held = self._read_back
        wrong = [name(key) for key, due in self._written_due.items() if held.get(key) != due]
        wrong += [name(key) for key in self._invalid_due if not held.get(key, 0) & INVALID]
        if (0x6060, 0) not in held:
            wrong.append(name((0x6060, 0)))
        return wrong


def name(key: Key) -> str:
    """An object as the manuals write it."""
    return f"{key[0]:04X}:{key[1]}"


def identity(axis: Axis) -> dict[Key, int]:
    """What a drive must say that it is."""
    rating, drive = axis.rating, axis.drive
    due = {
        (0x1018, 1): VENDOR,
        (0x6076, 0): round(rating.nominal_current * rating.torque_constant * 1e6),
        (0x3001, 1): round(rating.nominal_current * 1e3),
        (0x3001, 5): round(rating.torque_constant * 1e6),
        (0x3010, 1): rating.encoder_counts // 4,
    }
    given = (((0x1018, 2), drive.product), ((0x1018, 3), drive.revision))
    return due | {key: value for key, value in given if value is not None}


def contract(machine: Machine, axis: Axis) -> dict[Key, int]:
    """What a drive must hold."""
    limits, node = machine.supervision, axis.drive.node
    due = {
        (0x1016, 1): MASTER_NODE << 16 | round(limits.heartbeat_timeout * 1e3),
        (0x1017, 0): round(limits.drive_heartbeat * 1e3),
        (0x6007, 0): {"disable": 2, "quick_stop": 3}[limits.connection_loss],
        (0x3001, 2): round(axis.rating.current_limit * 1e3),
        (0x1400, 2): 1,
        (0x1800, 2): 1,
        (0x1800, 3): 0,
        (0x1400, 1): RPDO + node,
        (0x1800, 1): 1 << 30 | TPDO + node,
    }
    return due | _mapped(0x1600, rpdo_map(axis.drive)) | _mapped(0x1A00, tpdo_map(axis.drive))


def _mapped(index: int, objects: tuple[Mapped, ...]) -> dict[Key, int]:
    entries = {(index, sub): mapped.code for sub, mapped in enumerate(objects, start=1)}
    return entries | {(index, 0): len(objects)}
