"""What every drive's object dictionary must hold: read as its identity, written as its contract.

Index and subindex are those of CiA 301, CiA 402 and the drive's kind; the order of writing is that
of CiA 301 fig. 66 for PDOs: a PDO is made invalid, described, and only then made valid.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from turnbuckle.model.bus.axis import Axis
from turnbuckle.model.bus.drive_kinds.kind import HomingObjects, Option, Place
from turnbuckle.model.bus.frames import RPDO, TPDO, Mapped, rpdo_map, tpdo_map
from turnbuckle.model.bus.tables import MASTER_NODE, RailHoming
from turnbuckle.model.machine import Machine

EVERY_SYNC = 1
#: PDOs either way that CiA 301 gives identifiers to.
DEFAULT_PDOS = 4
INVALID, NO_REMOTE = 0x8000_0000, 0x4000_0000
STAY_OPERATIONAL = 1
COAST = 0


@dataclass(frozen=True)
class Object:
    """An entry of a drive's dictionary and what it must hold; size [bytes].

    of_node: the drive's number is a part of the value.
    """

    index: int
    subindex: int
    size: int
    value: int
    meaning: str
    of_node: bool = False

    @property
    def unsigned(self) -> int:
        """The value, a negative one in two's complement of its size."""
        return self.value % (1 << 8 * self.size)


def identity(axis: Axis) -> list[Object]:
    """What tells that this is the drive, with the motor, of the machine file."""
    drive = axis.drive
    entries = [Object(0x1018, 1, 4, axis.kind.vendor, "vendor")]
    if drive.product is not None:
        entries.append(Object(0x1018, 2, 4, drive.product, "product"))
    if drive.revision is not None:
        entries.append(Object(0x1018, 3, 4, drive.revision, "revision"))
    motor = axis.kind.motor.read
    held = (_held(axis, place, quantity(axis.rating)) for place, quantity in motor)
    return [*entries, *held]


def _held(axis: Axis, place: Place, quantity: float) -> Object:
    """An object that holds a quantity."""
    number = place.number(quantity, axis.rating)
    return Object(place.index, place.subindex, place.size, number, place.meaning)


def contract(machine: Machine, axis: Axis) -> list[Object]:
    """What the drive is configured to, in the order of writing."""
    written = [
        *_supervision(machine, axis),
        _held(axis, axis.kind.motor.current_limit, axis.rating.current_limit),
        *(Object(s.index, s.subindex, s.size, s.value, s.meaning) for s in axis.kind.settings),
        *_pdos(axis),
        *_work(machine, axis),
    ]
    return [entry for entry in written if entry.index not in axis.kind.lacks]


def _supervision(machine: Machine, axis: Axis) -> list[Object]:
    limits = machine.supervision
    timeout, beat = milliseconds(limits.heartbeat_timeout), milliseconds(limits.drive_heartbeat)
    return [
        Object(0x1016, 1, 4, MASTER_NODE << 16 | timeout, "heartbeat of the master: node, ms"),
        Object(0x1017, 0, 2, beat, "heartbeat of the drive: ms"),
        Object(0x1029, 1, 1, STAY_OPERATIONAL, "after an error: stays operational"),
        _chosen(axis.kind.connection_loss, limits.connection_loss),
        _chosen(axis.kind.quick_stop, limits.quick_stop),
        Object(0x605B, 0, 2, COAST, "shutdown: coast"),
        Object(0x605C, 0, 2, COAST, "disable operation: coast"),
        Object(0x605E, 0, 2, COAST, "fault: coast"),
    ]


def _chosen(option: Option, word: str) -> Object:
    meaning = f"{option.meaning}: {word}"
    return Object(option.index, option.subindex, option.size, option.codes[word], meaning)


def _pdos(axis: Axis) -> Iterator[Object]:
    """One PDO either way with every SYNC; the others explicitly invalid."""
    node = axis.drive.node
    yield from _pdo(0x1400, 0x1600, "RPDO1", RPDO + node, rpdo_map(axis.drive))
    yield from _off(axis, 0x1400, "RPDO", INVALID, RPDO)
    first = NO_REMOTE | TPDO + node
    yield from _pdo(0x1800, 0x1A00, "TPDO1", first, tpdo_map(axis.drive))
    yield from _off(axis, 0x1800, "TPDO", INVALID | NO_REMOTE, TPDO)


def _off(axis: Axis, parameters: int, name: str, bits: int, first: int) -> Iterator[Object]:
    """All PDOs but the first; those beyond the fourth have no identifier by default."""
    for other in range(1, axis.kind.pdos):
        has_default = other < DEFAULT_PDOS
        cob = first + 0x100 * other + axis.drive.node if has_default else 0
        meaning = f"{name}{other + 1}: off"
        yield Object(parameters + other, 1, 4, bits | cob, meaning, of_node=has_default)


def _pdo(
    parameters: int, mapping: int, name: str, cob: int, mapped: tuple[Mapped, ...]
) -> Iterator[Object]:
    yield Object(parameters, 1, 4, INVALID | cob, f"{name}: off while it changes", of_node=True)
    yield Object(parameters, 2, 1, EVERY_SYNC, f"{name}: with every SYNC")
    if parameters >= 0x1800:
        yield Object(parameters, 3, 2, 0, f"{name}: no inhibit time")
    yield Object(mapping, 0, 1, 0, f"{name}: no map while it changes")
    for number, entry in enumerate(mapped, start=1):
        yield Object(mapping, number, 4, entry.code, f"{name}: {entry.name}")
    yield Object(mapping, 0, 1, len(mapped), f"{name}: entries of the map")
    yield Object(parameters, 1, 4, cob, f"{name}: on", of_node=True)


def _work(machine: Machine, axis: Axis) -> list[Object]:
    """The first mode of operation, and what it needs."""
    modes = axis.kind.modes
    if axis.rail is None:
        return [Object(0x6060, 0, 1, modes["torque"], "mode: torque")]
    assert machine.rail_drive is not None and machine.rail_drive.homing is not None
    length = machine.rails[axis.rail].length
    return [
        *homing(axis, machine.rail_drive.homing, length),
        Object(0x6060, 0, 1, modes["homing"], "mode: homing"),
    ]


def homing(axis: Axis, way: RailHoming, length: float) -> list[Object]:
    """How a base on a rail of `length` [m] finds its zero."""
    objects = axis.kind.homing
    assert objects is not None  # load_machine has seen to it
    outwards = 1 if way.end == "end" else -1
    method = objects.forward if outwards * axis.sense > 0 else objects.backward
    stop = length + way.beyond if way.end == "end" else -way.beyond
    return [
        Object(0x6098, 0, 1, method, "homing method: to the stop"),
        *(_homing_object(axis, objects, place, way, stop) for place in objects.places),
    ]


def _homing_object(
    axis: Axis, objects: HomingObjects, place: Place, way: RailHoming, stop: float
) -> Object:
    if place is objects.threshold:
        return _held(axis, place, way.current)
    if place is objects.acceleration:
        return _held(axis, place, way.acceleration / axis.radius)
    if place is objects.home:
        return _held(axis, place, axis.increments(stop))
    if place is objects.offset:
        return _held(axis, place, 0.0)
    return _held(axis, place, way.speed / axis.radius)


def milliseconds(time: float) -> int:
    """A time [s] in whole ms."""
    return round(time * 1e3)
