"""Object dictionary of a simulated drive: EPOS4-class, CiA 301 and CiA 402.

Indices, types, access and defaults as a drive of this class has them; the ranges are those of one
variant, and a real drive's may differ. Objects that change at every SYNC are not kept as bytes but
as attributes of `Signals`, named in the column `signal`.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from struct import Struct

import canopen.objectdictionary as od

WIDEST = {"B": 0xFF, "H": 0xFFFF, "I": 0xFFFFFFFF}
SIGNED = {"b": 7, "h": 15, "i": 31}
DATA_TYPES = {
    "B": od.UNSIGNED8,
    "H": od.UNSIGNED16,
    "I": od.UNSIGNED32,
    "b": od.INTEGER8,
    "h": od.INTEGER16,
    "i": od.INTEGER32,
    "s": od.VISIBLE_STRING,
}
DEVICE_NAME = b"Turnbuckle simulated drive"

PDOS = 4
"""PDOs in each direction."""
MAPPED = 12
"""Objects that one PDO can map at most."""
HISTORY = 5
"""Errors that are remembered."""
HOMING_METHODS = (-4, -3, 37)
HOMING, POSITION, TORQUE = 6, 8, 10
MODES = (HOMING, POSITION, TORQUE)
"""Values of 6060 this drive can follow: HMM, CSP, CST."""

Key = tuple[int, int]
"""Index and subindex."""


@dataclass(frozen=True)
class Entry:
    """One object: `kind` is its type as a letter of `struct`, "s" for a string."""

    index: int
    subindex: int
    name: str
    kind: str
    access: str  # ro, rw, const
    default: int | bytes = 0
    lowest: int | None = None
    highest: int | None = None
    choices: tuple[int, ...] | None = None
    taken: bool = False  # an RPDO may map it, and a TPDO
    sent: bool = False  # a TPDO may map it
    power_off: bool = False  # written only while the power stage is off
    signal: str | None = None  # attribute of Signals

    @property
    def key(self) -> Key:
        """Index and subindex."""
        return self.index, self.subindex

    @property
    def size(self) -> int:
        """Bytes; 0 for a string."""
        return 0 if self.kind == "s" else Struct("<" + self.kind).size

    def encode(self, value: int | bytes) -> bytes:
        """The value as it goes over the bus."""
        return value if isinstance(value, bytes) else Struct("<" + self.kind).pack(value)

    def decode(self, data: bytes) -> int:
        """The number that came over the bus."""
        return int(Struct("<" + self.kind).unpack(data)[0])

    def bounds(self) -> tuple[int, int]:
        """Smallest and largest value that may be written."""
        bits = SIGNED.get(self.kind)
        low, high = (0, WIDEST[self.kind]) if bits is None else (-(1 << bits), (1 << bits) - 1)
        return (
            low if self.lowest is None else self.lowest,
            high if self.highest is None else self.highest,
        )


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


def _communication() -> Iterator[Entry]:
    yield Entry(0x1000, 0, "device type", "I", "ro", 0x00020192)
    yield Entry(0x1001, 0, "error register", "B", "ro", sent=True)
    yield from _list(0x1003, "error history", "I", "ro", [0] * HISTORY, count_access="rw", count=0)
    yield Entry(0x1005, 0, "COB-ID SYNC", "I", "const", 0x80)
    yield Entry(0x1008, 0, "device name", "s", "const", DEVICE_NAME)
    yield from _list(0x1010, "store parameters", "I", "rw", [1])
    yield from _list(0x1011, "restore default parameters", "I", "rw", [1])
    yield Entry(0x1014, 0, "COB-ID EMCY", "I", "ro")
    yield from _list(0x1016, "consumer heartbeat time", "I", "rw", [0, 0], highest=0x007FFFFF)
    yield Entry(0x1017, 0, "producer heartbeat time", "H", "rw")
    yield from _list(0x1018, "identity", "I", "ro", [0, 0, 0, 0])
    yield from _list(0x1029, "error behaviour", "B", "rw", [0], highest=2)
    yield from _list(0x1200, "SDO server parameter", "I", "ro", [0, 0])
    for number in range(PDOS):
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


def _list(
    index: int,
    name: str,
    kind: str,
    access: str,
    defaults: list[int],
    *,
    count_access: str = "const",
    count: int | None = None,
    lowest: int | None = None,
    highest: int | None = None,
) -> Iterator[Entry]:
    size = len(defaults) if count is None else count
    yield Entry(index, 0, "number of entries", "B", count_access, size)
    for sub, default in enumerate(defaults, start=1):
        yield Entry(index, sub, f"{name} {sub}", kind, access, default, lowest, highest)


def _vendor() -> Iterator[Entry]:
    yield Entry(0x2000, 0, "node-ID", "B", "rw", 1, lowest=1, highest=127)
    yield Entry(0x2001, 0, "CAN bit rate", "B", "rw", 0, highest=9)
    yield from _list(0x2200, "power supply voltage [0.1 V]", "H", "ro", [240])
    yield from _list(0x3000, "axis configuration", "I", "rw", [1, 0x00000101, 1])
    yield Entry(0x3001, 0, "number of entries", "B", "const", 5)
    yield Entry(0x3001, 1, "nominal current [mA]", "I", "rw", highest=50_000, power_off=True)
    yield Entry(0x3001, 2, "output current limit [mA]", "I", "rw", highest=150_000, power_off=True)
    yield Entry(0x3001, 3, "pole pairs", "B", "rw", 1, lowest=1, highest=255, power_off=True)
    yield Entry(0x3001, 4, "thermal time constant [0.1 s]", "H", "rw", 40, lowest=1, power_off=True)
    yield Entry(0x3001, 5, "torque constant [uN m/A]", "I", "rw", highest=10**7, power_off=True)
    yield from _list(0x3002, "electrical data", "I", "rw", [500, 100])
    yield Entry(0x3010, 0, "number of entries", "B", "const", 1)
    yield Entry(
        0x3010, 1, "encoder pulses/turn", "I", "rw", 1024, lowest=16, highest=10**6, power_off=True
    )
    yield Entry(0x30B0, 0, "home position", "i", "rw", taken=True)
    yield Entry(0x30B1, 0, "home offset move distance", "i", "rw")
    yield Entry(0x30B2, 0, "current threshold for homing [mA]", "H", "rw", 500, taken=True)
    yield Entry(0x30D1, 0, "number of entries", "B", "const", 2)
    yield Entry(0x30D1, 1, "current averaged [mA]", "i", "ro", sent=True)
    yield Entry(0x30D1, 2, "current [mA]", "i", "ro", sent=True)
    yield from (_mapped(e) for e in _list(0x3200, "I2t level [%]", "H", "ro", [0, 0]))
    yield from _list(0x3201, "temperature power stage [0.1 degC]", "h", "ro", [350])
    yield from _list(0x3202, "STO input states", "B", "ro", [3])


def _mapped(entry: Entry) -> Entry:
    return Entry(**{**entry.__dict__, "sent": entry.subindex > 0})


def _profile() -> Iterator[Entry]:
    yield Entry(0x6007, 0, "abort connection option code", "h", "rw", 3, lowest=0, highest=3)
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
        choices=MODES,
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
    yield Entry(0x6076, 0, "motor rated torque [uN m]", "I", "ro")
    yield Entry(0x6077, 0, "torque actual [permille]", "h", "ro", sent=True, signal="torque")
    yield Entry(0x607A, 0, "target position", "i", "rw", taken=True, signal="target_position")
    yield from _list(0x607D, "software position limit", "i", "rw", [0, 0])
    yield Entry(0x607F, 0, "max profile velocity [rpm]", "I", "rw", 50_000, lowest=1)
    yield Entry(0x6080, 0, "max motor speed [rpm]", "I", "rw", 50_000, lowest=1)
    yield Entry(0x6084, 0, "profile deceleration [rpm/s]", "I", "rw", 10_000, lowest=1)
    yield Entry(0x6085, 0, "quick stop deceleration [rpm/s]", "I", "rw", 10_000, lowest=1)
    yield Entry(0x6098, 0, "homing method", "b", "rw", 37, choices=HOMING_METHODS)
    yield from _list(0x6099, "homing speed [rpm]", "I", "rw", [100, 10], lowest=1)
    yield Entry(0x609A, 0, "homing acceleration [rpm/s]", "I", "rw", 1000, lowest=1)
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
    yield from _list(0x60E3, "supported homing method", "b", "ro", list(HOMING_METHODS))
    yield Entry(0x6502, 0, "supported drive modes", "I", "ro", sum(1 << (m - 1) for m in MODES))


@cache
def entries() -> dict[Key, Entry]:
    """Every object of a drive."""
    found: Iterable[Entry] = [*_communication(), *_vendor(), *_profile()]
    return {entry.key: entry for entry in found}


@cache
def indices() -> frozenset[int]:
    """Every index there is."""
    return frozenset(index for index, _ in entries())


@cache
def object_dictionary() -> od.ObjectDictionary:
    """The same for python `canopen`."""
    dictionary = od.ObjectDictionary()
    for index in sorted(indices()):
        members = [entry for entry in entries().values() if entry.index == index]
        variables = [_variable(entry) for entry in members]
        if len(variables) == 1:
            dictionary.add_object(variables[0])
            continue
        record = od.ODRecord(f"object {index:04X}", index)
        for variable in variables:
            record.add_member(variable)
        dictionary.add_object(record)
    return dictionary


def _variable(entry: Entry) -> od.ODVariable:
    variable = od.ODVariable(entry.name, entry.index, entry.subindex)
    variable.data_type = DATA_TYPES[entry.kind]
    variable.access_type = entry.access
    variable.pdo_mappable = entry.taken or entry.sent
    return variable
