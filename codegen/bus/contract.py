"""What every drive's object dictionary must hold: read as its identity, written as its contract.

Index and subindex are those of CiA 301, CiA 402 and the EPOS4; the order of writing is that of
CiA 301 fig. 66 for PDOs: a PDO is made invalid, described, and only then made valid.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from turnbuckle.model.bus.axis import Axis
from turnbuckle.model.bus.frames import RPDO, TPDO, Mapped, rpdo_map, tpdo_map
from turnbuckle.model.bus.tables import MASTER_NODE, RailHoming, Rating
from turnbuckle.model.machine import Machine

MAXON = 0xFB
PDOS = 4
EVERY_SYNC = 1
INVALID, NO_REMOTE = 0x8000_0000, 0x4000_0000
TORQUE_MODE, HOMING_MODE = 10, 6
ON_CONNECTION_LOSS = {"disable": 2, "quick_stop": 3}
AFTER_QUICK_STOP = {"off": 2, "hold": 6}
STAY_OPERATIONAL = 1
COAST = 0
# Homing against a mechanical stop, told by the current; by the direction of the motor.
STOP_FORWARD, STOP_BACKWARD = -3, -4


@dataclass(frozen=True)
class Object:
    """An entry of a drive's dictionary and what it must hold; size [bytes]."""

    index: int
    subindex: int
    size: int
    value: int

    @property
    def unsigned(self) -> int:
        """The value, a negative one in two's complement of its size."""
        return self.value % (1 << 8 * self.size)


def identity(axis: Axis) -> list[Object]:
    """What tells that this is the drive, with the motor, of the machine file."""
    drive, rating = axis.drive, axis.rating
    entries = [Object(0x1018, 1, 4, MAXON)]
    if drive.product is not None:
        entries.append(Object(0x1018, 2, 4, drive.product))
    if drive.revision is not None:
        entries.append(Object(0x1018, 3, 4, drive.revision))
    return entries + _motor(rating)


def _motor(rating: Rating) -> list[Object]:
    return [
        Object(0x6076, 0, 4, round(rating.rated_torque * 1e6)),  # uN m
        Object(0x3001, 1, 4, milliampere(rating.nominal_current)),
        Object(0x3001, 5, 4, round(rating.torque_constant * 1e6)),  # uN m/A
        Object(0x3010, 1, 4, rating.encoder_counts // 4),
    ]


def contract(machine: Machine, axis: Axis) -> list[Object]:
    """What the drive is configured to, in the order of writing."""
    return [
        *_supervision(machine),
        Object(0x3001, 2, 4, milliampere(axis.rating.current_limit)),
        *_pdos(axis),
        *_work(machine, axis),
    ]


def _supervision(machine: Machine) -> list[Object]:
    limits = machine.supervision
    timeout = milliseconds(limits.heartbeat_timeout)
    return [
        Object(0x1016, 1, 4, MASTER_NODE << 16 | timeout),
        Object(0x1017, 0, 2, milliseconds(limits.drive_heartbeat)),
        Object(0x1029, 1, 1, STAY_OPERATIONAL),
        Object(0x6007, 0, 2, ON_CONNECTION_LOSS[limits.connection_loss]),
        Object(0x605A, 0, 2, AFTER_QUICK_STOP[limits.quick_stop]),
        Object(0x605B, 0, 2, COAST),  # shutdown
        Object(0x605C, 0, 2, COAST),  # disable operation
        Object(0x605E, 0, 2, COAST),  # fault
    ]


def _pdos(axis: Axis) -> Iterator[Object]:
    """One PDO either way with every SYNC; the others explicitly invalid."""
    node = axis.drive.node
    yield from _pdo(0x1400, 0x1600, RPDO + node, rpdo_map(axis.drive), inhibit=False)
    for other in range(1, PDOS):
        yield Object(0x1400 + other, 1, 4, INVALID | RPDO + 0x100 * other + node)
    cob = NO_REMOTE | TPDO + node
    yield from _pdo(0x1800, 0x1A00, cob, tpdo_map(axis.drive), inhibit=True)
    for other in range(1, PDOS):
        yield Object(0x1800 + other, 1, 4, INVALID | cob + 0x100 * other)


def _pdo(
    parameters: int, mapping: int, cob: int, mapped: tuple[Mapped, ...], inhibit: bool
) -> Iterator[Object]:
    yield Object(parameters, 1, 4, INVALID | cob)
    yield Object(parameters, 2, 1, EVERY_SYNC)
    if inhibit:
        yield Object(parameters, 3, 2, 0)
    yield Object(mapping, 0, 1, 0)
    for number, entry in enumerate(mapped, start=1):
        yield Object(mapping, number, 4, entry.code)
    yield Object(mapping, 0, 1, len(mapped))
    yield Object(parameters, 1, 4, cob)


def _work(machine: Machine, axis: Axis) -> list[Object]:
    """The first mode of operation, and what it needs."""
    if axis.rail is None:
        return [Object(0x6060, 0, 1, TORQUE_MODE)]
    assert machine.rail_drive is not None and machine.rail_drive.homing is not None
    length = machine.rails[axis.rail].length
    return [*homing(axis, machine.rail_drive.homing, length), Object(0x6060, 0, 1, HOMING_MODE)]


def homing(axis: Axis, way: RailHoming, length: float) -> list[Object]:
    """How a base on a rail of `length` [m] finds its zero."""
    outwards = 1 if way.end == "end" else -1
    stop = length + way.beyond if way.end == "end" else -way.beyond
    speed = round(axis.turning_speed(way.speed))
    method = STOP_FORWARD if outwards * axis.sense > 0 else STOP_BACKWARD
    return [
        Object(0x6098, 0, 1, method),
        Object(0x30B2, 0, 2, milliampere(way.current)),
        Object(0x6099, 1, 4, speed),  # rpm, towards the stop
        Object(0x6099, 2, 4, speed),  # rpm, of the second search: the same
        Object(0x609A, 0, 4, round(axis.turning_speed(way.acceleration))),  # rpm/s
        Object(0x30B1, 0, 4, 0),  # stays where it met the stop
        Object(0x30B0, 0, 4, axis.increments(stop)),  # position it then has
    ]


def milliampere(current: float) -> int:
    """A current [A] in whole mA."""
    return round(current * 1e3)


def milliseconds(time: float) -> int:
    """A time [s] in whole ms."""
    return round(time * 1e3)
