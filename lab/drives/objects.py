"""Object dictionary of a simulated drive: CiA 301, CiA 402, and what its kind has of its own.

Objects that change at every SYNC are not kept as bytes but as attributes of `Signals`, named in the
column `signal`.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

import canopen.objectdictionary as od

from turnbuckle.model.bus.drive_kinds.entry import Entry, Key, array
from turnbuckle.model.bus.drive_kinds.kind import DriveKind, Place

DATA_TYPES = {
    "B": od.UNSIGNED8,
    "H": od.UNSIGNED16,
    "I": od.UNSIGNED32,
    "b": od.INTEGER8,
    "h": od.INTEGER16,
    "i": od.INTEGER32,
    "s": od.VISIBLE_STRING,
}
LETTERS = {
    (entry_size, is_signed): letter
    for is_signed, letters in ((False, "BHI"), (True, "bhi"))
    for entry_size, letter in zip((1, 2, 4), letters, strict=True)
}
"""By bytes and sign, the letter of a type."""
DEVICE_NAME = b"Turnbuckle simulated drive"

MAPPED = 12
"""Objects that one PDO can map at most."""
HISTORY = 5
"""Errors that are remembered."""


@dataclass(slots=True)
class Signals:
    """Objects that change while the drive runs, by name; units as in the dictionary."""

    controlword: int = 0
    statusword: int = 0
    error_code: int = 0
    mode: int = 0
    mode_display: int = 0
    position: int = 0
    position_demand: int = 0
    velocity: int = 0
    torque: int = 0
    target_position: int = 0
    target_torque: int = 0
    torque_offset: int = 0
    current: int = 0


def _communication(kind: DriveKind) -> Iterator[Entry]:
    yield Entry(0x1000, 0, "device type", "I", "ro", 0x00020192)
    yield Entry(0x1001, 0, "error register", "B", "ro", sent=True)
    yield from array(0x1003, "error history", "I", "ro", [0] * HISTORY, count_access="rw", count=0)
    yield Entry(0x1005, 0, "COB-ID SYNC", "I", "const", 0x80)
    yield Entry(0x1008, 0, "device name", "s", "const", DEVICE_NAME)
    yield from array(0x1010, "store parameters", "I", "rw", [1])
    yield from array(0x1011, "restore default parameters", "I", "rw", [1])
    yield Entry(0x1014, 0, "COB-ID EMCY", "I", "ro")
    yield from array(0x1016, "consumer heartbeat time", "I", "rw", [0, 0], highest=0x007FFFFF)
    yield Entry(0x1017, 0, "producer heartbeat time", "H", "rw")
    yield from array(0x1018, "identity", "I", "ro", [0, 0, 0, 0])
    yield from array(0x1029, "error behaviour", "B", "rw", [0], highest=2)
    yield from array(0x1200, "SDO server parameter", "I", "ro", [0, 0])
    for number in range(kind.pdos):
        yield from _pdo(number)


def _pdo(number: int) -> Iterator[Entry]:
    yield Entry(0x1400 + number, 0, "number of entries", "B", "const", 2)
    yield Entry(0x1400 + number, 1, "COB-ID RPDO", "I", "rw")
    yield Entry(0x1400 + number, 2, "transmission type RPDO", "B", "rw", 255)
    yield Entry(0x1800 + number, 0, "number of entries", "B", "const", 3)
    yield Entry(0x1800 + number, 1, "COB-ID TPDO", "I", "rw")
    yield Entry(0x1800 + number, 2, "transmission type TPDO", "B", "rw", 255)
    yield Entry(0x1800 + number, 3, "inhibit time TPDO", "H", "rw", 10)
    for base, name in ((0x1600, "RPDO mapping"), (0x1A00, "TPDO mapping")):
        yield Entry(base + number, 0, "number of mapped objects", "B", "rw")
        for sub in range(1, MAPPED + 1):
            yield Entry(base + number, sub, f"{name} {sub}", "I", "rw")


def _profile(kind: DriveKind) -> Iterator[Entry]:
    modes = tuple(kind.modes.values())
    yield Entry(0x603F, 0, "error code", "H", "ro", sent=True, signal="error_code")
    yield Entry(0x6040, 0, "controlword", "H", "rw", taken=True, signal="controlword")
    yield Entry(0x6041, 0, "statusword", "H", "ro", sent=True, signal="statusword")
    yield Entry(0x605A, 0, "quick stop option code", "h", "rw", 6, choices=(0, 1, 2, 5, 6))
    yield Entry(0x605B, 0, "shutdown option code", "h", "rw", 0, lowest=0, highest=1)
    yield Entry(0x605C, 0, "disable operation option code", "h", "rw", 1, lowest=0, highest=1)
    yield Entry(0x605E, 0, "fault reaction option code", "h", "rw", 2, lowest=0, highest=2)
    yield Entry(
        0x6060,
        0,
        "modes of operation",
        "b",
        "rw",
        1,
        choices=modes,
        taken=True,
        sent=True,
        signal="mode",
    )
    yield Entry(0x6061, 0, "mode display", "b", "ro", 1, sent=True, signal="mode_display")
    yield Entry(0x6062, 0, "position demand", "i", "ro", sent=True, signal="position_demand")
    yield Entry(0x6064, 0, "position actual", "i", "ro", sent=True, signal="position")
    yield Entry(0x6065, 0, "following error window", "I", "rw", 2000, taken=True)
    yield Entry(0x6066, 0, "following error timeout", "H", "rw", 0, highest=0)
    yield Entry(0x6067, 0, "position window", "I", "rw", 0xFFFFFFFF, taken=True)
    yield Entry(0x6068, 0, "position window time", "H", "rw", 0, taken=True)
    yield Entry(0x606C, 0, "velocity actual [rpm]", "i", "ro", sent=True, signal="velocity")
    yield Entry(
        0x6071,
        0,
        "target torque [permille]",
        "h",
        "rw",
        taken=True,
        sent=True,
        signal="target_torque",
    )
    yield Entry(0x6077, 0, "torque actual [permille]", "h", "ro", sent=True, signal="torque")
    yield Entry(0x607A, 0, "target position", "i", "rw", taken=True, signal="target_position")
    yield from array(0x607D, "software position limit", "i", "rw", [0, 0])
    yield Entry(0x607F, 0, "max profile velocity [rpm]", "I", "rw", 50_000, lowest=1)
    yield Entry(0x6080, 0, "max motor speed [rpm]", "I", "rw", 50_000, lowest=1)
    yield Entry(0x6084, 0, "profile deceleration [rpm/s]", "I", "rw", 10_000, lowest=1)
    yield Entry(0x6085, 0, "quick stop deceleration [rpm/s]", "I", "rw", 10_000, lowest=1)
    yield Entry(
        0x60B2,
        0,
        "torque offset [permille]",
        "h",
        "rw",
        taken=True,
        sent=True,
        signal="torque_offset",
    )
    yield Entry(0x60C2, 0, "number of entries", "B", "const", 2)
    yield Entry(0x60C2, 1, "interpolation time", "B", "rw", 0, highest=100)
    yield Entry(0x60C2, 2, "interpolation time exponent", "b", "rw", -3, lowest=-3, highest=-3)
    supported = sum(1 << (mode - 1) for mode in modes if mode > 0)
    yield Entry(0x6502, 0, "supported drive modes", "I", "ro", supported)
    if kind.homing is not None:
        methods = kind.homing.methods
        yield Entry(0x6098, 0, "homing method", "b", "rw", methods[-1], choices=methods)
        yield from array(0x60E3, "supported homing method", "b", "ro", list(methods))


def _of_kind(kind: DriveKind) -> Iterator[Entry]:
    """The objects that hold what the kind says, of any value that they can hold."""
    for place in kind.motor.places:
        access = "ro" if place is kind.motor.rated_torque else "rw"
        yield _entry(place, access, power_off=True)
    for place in kind.homing.places if kind.homing else ():
        yield _entry(place, "rw", power_off=False)
    for option in (kind.connection_loss, kind.quick_stop):
        letter = LETTERS[option.size, True]
        yield Entry(option.index, option.subindex, option.meaning, letter, "rw")
    for setting in kind.settings:
        letter = LETTERS[setting.size, setting.value < 0]
        yield Entry(setting.index, setting.subindex, setting.meaning, letter, "rw")


def _entry(place: Place, access: str, power_off: bool) -> Entry:
    low, high = place.bounds
    letter = LETTERS[place.size, place.signed]
    return Entry(
        *place.key, place.meaning, letter, access, max(low, 0), low, high, power_off=power_off
    )


class Dictionary:
    """Every object of a kind of drive."""

    def __init__(self, kind: DriveKind) -> None:
        shared = [*_of_kind(kind), *_communication(kind), *_profile(kind)]
        found = {entry.key: entry for entry in shared if entry.index not in kind.lacks}
        found |= {entry.key: entry for entry in kind.simulated.objects}
        for index in {index for index, subindex in found if subindex > 0}:
            most = max(subindex for other, subindex in found if other == index)
            count = Entry(index, 0, "number of entries", "B", "const", most)
            found.setdefault(count.key, count)
        self.kind = kind
        self.entries: dict[Key, Entry] = dict(sorted(found.items()))
        self.indices = frozenset(index for index, _ in found)
        self.canopen = self._for_canopen()

    def _for_canopen(self) -> od.ObjectDictionary:
        """The same for python `canopen`."""
        dictionary = od.ObjectDictionary()
        for index in sorted(self.indices):
            members = [entry for entry in self.entries.values() if entry.index == index]
            variables = [_variable(entry) for entry in members]
            if len(variables) == 1:
                dictionary.add_object(variables[0])
                continue
            record = od.ODRecord(f"object {index:04X}", index)
            for variable in variables:
                record.add_member(variable)
            dictionary.add_object(record)
        return dictionary


@cache
def dictionary(kind: DriveKind) -> Dictionary:
    """The objects of a kind of drive."""
    return Dictionary(kind)


def _variable(entry: Entry) -> od.ODVariable:
    variable = od.ODVariable(entry.name, entry.index, entry.subindex)
    variable.data_type = DATA_TYPES[entry.kind]
    variable.access_type = entry.access
    variable.pdo_mappable = entry.taken or entry.sent
    return variable
