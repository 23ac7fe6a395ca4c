"""The frames on a bus: who sends them, what is in them, how often they come at most."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from turnbuckle.model.bus.response import Message
from turnbuckle.model.bus.tables import ERROR_CONTROL, MASTER_NODE, Drive, OtherNode

# CiA 301 tables 33, 34: COB-IDs, to which a node adds its number.
SYNC = 0x080
EMERGENCY = 0x080
TPDO = 0x180
RPDO = 0x200
SDO_ANSWER = 0x580
SDO_REQUEST = 0x600
HEARTBEAT = ERROR_CONTROL

SDO_BYTES = EMERGENCY_BYTES = 8
# A drive reports an event once; more than this many events are a broken drive [s].
EMERGENCY_INTERVAL = 0.1
# A product of rounded numbers may miss a whole number of bits by this much.
ROUNDING = 1e-6


@dataclass(frozen=True)
class Mapped:
    """An object in a PDO; size [bits]."""

    name: str
    index: int
    size: int
    signed: bool

    @property
    def code(self) -> int:
        """The entry of the mapping object (CiA 301 section 9.5)."""
        return self.index << 16 | self.size


CONTROLWORD = Mapped("controlword", 0x6040, 16, False)
STATUSWORD = Mapped("statusword", 0x6041, 16, False)
TARGET_TORQUE = Mapped("torque", 0x6071, 16, True)
TARGET_POSITION = Mapped("position", 0x607A, 32, True)
POSITION = Mapped("position", 0x6064, 32, True)
TORQUE = Mapped("torque", 0x6077, 16, True)


#: RPDO1, by what a drive follows at work: what the master sends to the drive with every SYNC.
COMMANDS: dict[str, tuple[Mapped, ...]] = {
    "torque": (CONTROLWORD, TARGET_TORQUE),
    "position": (CONTROLWORD, TARGET_POSITION),
}
#: TPDO1: what a drive answers to every SYNC.
STATUS: tuple[Mapped, ...] = (STATUSWORD, POSITION, TORQUE)


def rpdo_map(drive: Drive) -> tuple[Mapped, ...]:
    """RPDO1 of a drive."""
    return COMMANDS[drive.mode]


def tpdo_map(drive: Drive) -> tuple[Mapped, ...]:
    """TPDO1 of a drive."""
    return STATUS


def pdo_bytes(mapped: Sequence[Mapped]) -> int:
    """Bytes of a PDO."""
    return sum(entry.size for entry in mapped) // 8


@dataclass(frozen=True)
class Pace:
    """How often frames come on a bus [s], and its bit rate [bit/s].

    cycle: the control cycle, in which at most one SDO request is sent a bus; delay: most from SYNC
    until a drive's answer is ready.
    """

    bit_rate: float
    sync: float
    cycle: float
    heartbeat: float
    drive_heartbeat: float
    sdo_timeout: float
    delay: float = 0.0
    emergency: float = EMERGENCY_INTERVAL

    def bits(self, time: float) -> int:
        """Whole bit times in a time: at most as long, so that no period is taken too long."""
        return math.floor(time * self.bit_rate + ROUNDING)

    def bits_over(self, time: float) -> int:
        """Whole bit times that cover a time."""
        return math.ceil(time * self.bit_rate - ROUNDING)


def cyclic(drives: Sequence[Drive], pace: Pace) -> list[Message]:
    """SYNC, and a PDO either way for every drive."""
    period = pace.bits(pace.sync)
    messages = [Message("SYNC", SYNC, 0, period, period)]
    for drive in drives:
        size = pdo_bytes(tpdo_map(drive))
        delay = pace.bits_over(pace.delay)
        name = f"{drive.name} answer"
        messages.append(Message(name, TPDO + drive.node, size, period, period, delay))
    for drive in drives:
        size = pdo_bytes(rpdo_map(drive))
        messages.append(Message(f"{drive.name} command", RPDO + drive.node, size, period, period))
    return messages


def acyclic(drives: Sequence[Drive], pace: Pace) -> Iterator[Message]:
    """Emergencies, SDO (one drive at a time) and heartbeats."""
    emergency, timeout = pace.bits(pace.emergency), pace.bits(pace.sdo_timeout)
    beat, drive_beat = pace.bits(pace.heartbeat), pace.bits(pace.drive_heartbeat)
    for drive in drives:
        identifier = EMERGENCY + drive.node
        yield Message(f"{drive.name} emergency", identifier, EMERGENCY_BYTES, emergency, emergency)
    last = max(drive.node for drive in drives)
    cycle = pace.bits(pace.cycle)
    # The answer to one request may come just before that to the next, hence the jitter.
    yield Message("SDO answer", SDO_ANSWER + last, SDO_BYTES, cycle, timeout, cycle)
    yield Message("SDO request", SDO_REQUEST + last, SDO_BYTES, cycle, timeout)
    for drive in drives:
        identifier = HEARTBEAT + drive.node
        yield Message(f"{drive.name} heartbeat", identifier, 1, drive_beat, drive_beat)
    yield Message("master heartbeat", HEARTBEAT + MASTER_NODE, 1, beat, beat)


def of_other_nodes(nodes: Sequence[OtherNode], pace: Pace) -> Iterator[Message]:
    """The frames of nodes that are no drives, as the machine file has them."""
    for node in nodes:
        for frame in node.frames:
            period = pace.bits(frame.period)
            yield Message(f"{node.name} {frame.id:03X}", frame.id, frame.length, period, period)


def beats_of_other_nodes(nodes: Sequence[OtherNode], pace: Pace) -> Iterator[Message]:
    """Their heartbeats; without one, boot-up messages as often as a drive has emergencies."""
    for node in nodes:
        beat = pace.bits(node.heartbeat or pace.emergency)
        yield Message(f"{node.name} heartbeat", node.error_control, 1, beat, beat)


def messages(drives: Sequence[Drive], pace: Pace, nodes: Sequence[OtherNode] = ()) -> list[Message]:
    """All frames, the most urgent first."""
    found = [
        *cyclic(drives, pace),
        *acyclic(drives, pace),
        *of_other_nodes(nodes, pace),
        *beats_of_other_nodes(nodes, pace),
    ]
    return sorted(found, key=lambda message: message.identifier)
