"""A DBC for every bus: the frames by name, in newton metres and metres, for the user's own tools.

Node numbers repeat from bus to bus, so each bus has a file of its own.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from turnbuckle.codegen.origin import command
from turnbuckle.model.bus.axis import Axis, axes
from turnbuckle.model.bus.drive_kinds.kind import DriveKind
from turnbuckle.model.bus.frames import (
    EMERGENCY,
    HEARTBEAT,
    POSITION,
    RPDO,
    SYNC,
    TARGET_POSITION,
    TPDO,
    Mapped,
    pdo_bytes,
    rpdo_map,
    tpdo_map,
)
from turnbuckle.model.bus.plan import Load, loads
from turnbuckle.model.bus.tables import MASTER, MASTER_NODE, OtherNode
from turnbuckle.model.machine import Machine

EVERYONE = "Vector__XXX"
POSITIONS = (POSITION, TARGET_POSITION)
Words = tuple[tuple[int, str], ...]

NMT_STATES: Words = ((0, "boot_up"), (4, "stopped"), (5, "operational"), (127, "pre_operational"))
COMMANDS: Words = (
    (0, "disable_voltage"),
    (2, "quick_stop"),
    (6, "shutdown"),
    (7, "switch_on"),
    (15, "enable_operation"),
)
# CiA 402 table of states: mask and value of a statusword.
POWER_STATES = (
    (0x4F, 0x00, "not_ready"),
    (0x4F, 0x40, "switch_on_disabled"),
    (0x6F, 0x21, "ready_to_switch_on"),
    (0x6F, 0x23, "switched_on"),
    (0x6F, 0x27, "operation_enabled"),
    (0x6F, 0x07, "quick_stop_active"),
    (0x4F, 0x0F, "fault_reaction_active"),
    (0x4F, 0x08, "fault"),
)
POWER_BITS = 7
#: Error codes of CiA 301 and CiA 402.
EMERGENCIES: Words = (
    (0x0000, "none"),
    (0x1000, "generic"),
    (0x2310, "overcurrent"),
    (0x3210, "overvoltage"),
    (0x3220, "undervoltage"),
    (0x4210, "too_hot"),
    (0x7320, "position_sensor"),
    (0x8110, "frames_lost"),
    (0x8120, "error_passive"),
    (0x8130, "heartbeat_missed"),
    (0x8150, "identifier_twice"),
    (0x8210, "pdo_length"),
    (0x8611, "following_error"),
)


@dataclass(frozen=True)
class Signal:
    """Bits of a frame, the least significant first: value = factor x raw."""

    name: str
    start: int
    size: int
    signed: bool = False
    factor: float = 1.0
    unit: str = ""
    words: Words = ()

    def line(self, receiver: str) -> str:
        """SG_ of a DBC."""
        sign = "-" if self.signed else "+"
        low, high = map(_number, self._bounds())
        return (
            f" SG_ {self.name} : {self.start}|{self.size}@1{sign} ({_number(self.factor)},0)"
            f' [{low}|{high}] "{self.unit}" {receiver}'
        )

    def _bounds(self) -> tuple[float, float]:
        span = 1 << self.size
        raw = (-span // 2, span // 2 - 1) if self.signed else (0, span - 1)
        ends = sorted(self.factor * value for value in raw)
        return ends[0], ends[1]


def _number(value: float) -> str:
    return str(int(value)) if value == int(value) else repr(value)


@dataclass(frozen=True)
class Frame:
    """A message of a DBC; cycle [ms], 0 where it has none."""

    identifier: int
    name: str
    size: int
    sender: str
    receiver: str
    signals: tuple[Signal, ...]
    meaning: str
    cycle: int = 0


def dbc_files(machine: Machine) -> dict[str, str]:
    """The DBC of every bus, by file name."""
    drives = axes(machine)
    return {
        f"{machine.name}_{load.name}.dbc": dbc(
            machine, load, [axis for axis in drives if axis.bus == number]
        )
        for number, load in enumerate(loads(machine))
    }


def dbc(machine: Machine, load: Load, drives: Sequence[Axis]) -> str:
    """The DBC of one bus."""
    frames = sorted(_frames(machine, load, drives), key=lambda frame: frame.identifier)
    others = [node.name for node in load.nodes]
    nodes = " ".join([MASTER, *(axis.drive.name for axis in drives), *others])
    title = f"Bus {load.name} of {machine.name}"
    lines = [
        'VERSION ""',
        "",
        "NS_ :",
        "",
        "BS_:",
        "",
        f"BU_: {nodes}",
        "",
        *(line for frame in frames for line in _message(frame)),
        f'CM_ "{title}. Regenerate: {command(machine)}.";',
        *(f'CM_ BO_ {frame.identifier} "{frame.meaning}";' for frame in frames),
        'BA_DEF_ BO_ "GenMsgCycleTime" INT 0 65535;',
        'BA_DEF_DEF_ "GenMsgCycleTime" 0;',
        *_cycles(frames),
        *_words(frames),
    ]
    return "\n".join(lines) + "\n"


def _message(frame: Frame) -> Iterator[str]:
    yield f"BO_ {frame.identifier} {frame.name}: {frame.size} {frame.sender}"
    yield from (signal.line(frame.receiver) for signal in frame.signals)
    yield ""


def _cycles(frames: Iterable[Frame]) -> Iterator[str]:
    for frame in frames:
        if frame.cycle:
            yield f'BA_ "GenMsgCycleTime" BO_ {frame.identifier} {frame.cycle};'


def _words(frames: Iterable[Frame]) -> Iterator[str]:
    for frame in frames:
        for signal in frame.signals:
            if signal.words:
                entries = " ".join(f'{value} "{word}"' for value, word in signal.words)
                yield f"VAL_ {frame.identifier} {signal.name} {entries} ;"


def _frames(machine: Machine, load: Load, drives: Sequence[Axis]) -> Iterator[Frame]:
    limits = machine.supervision
    cycle = round(1e3 * load.divider / machine.control.rate)
    yield Frame(
        SYNC,
        "sync",
        0,
        MASTER,
        EVERYONE,
        (),
        "SYNC: drives answer, and follow their commands",
        cycle,
    )
    yield _heartbeat(MASTER, MASTER_NODE, EVERYONE, round(limits.heartbeat * 1e3))
    for axis in drives:
        name, node = axis.drive.name, axis.drive.node
        yield _heartbeat(name, node, MASTER, round(limits.drive_heartbeat * 1e3))
        yield _emergency(axis)
        yield _command(axis, cycle)
        yield _answer(axis, cycle)
    for other in load.nodes:
        yield from _frames_of_node(other)


def _frames_of_node(node: OtherNode) -> Iterator[Frame]:
    """What is in them nobody but the node knows."""
    name = node.name
    yield _heartbeat(name, node.node, EVERYONE, round((node.heartbeat or 0.0) * 1e3))
    for frame in node.frames:
        meaning = f"Frame {frame.id:03X} of {name}"
        title, cycle = f"{name}_{frame.id:03x}", round(frame.period * 1e3)
        yield Frame(frame.id, title, frame.length, name, EVERYONE, (), meaning, cycle)


def _heartbeat(name: str, node: int, receiver: str, cycle: int) -> Frame:
    state = Signal("state", 0, 7, words=NMT_STATES)
    meaning = f"Heartbeat of {name}"
    return Frame(HEARTBEAT + node, f"{name}_heartbeat", 1, name, receiver, (state,), meaning, cycle)


def _emergency(axis: Axis) -> Frame:
    name, node = axis.drive.name, axis.drive.node
    signals = (
        Signal("code", 0, 16, words=emergency_words(axis.kind)),
        Signal("error_register", 16, 8),
        Signal("detail", 24, 40),
    )
    meaning = f"Emergency of {name}"
    return Frame(EMERGENCY + node, f"{name}_emergency", 8, name, MASTER, signals, meaning)


def emergency_words(kind: DriveKind) -> Words:
    """The error codes that a drive of this kind tells."""
    own = {
        error.first: re.sub(r"\W+", "_", re.split("[:;(]", error.text)[0].strip().lower())
        for error in kind.errors
        if error.first == error.last
    }
    return tuple(sorted({**dict(EMERGENCIES), **own}.items()))


def _command(axis: Axis, cycle: int) -> Frame:
    mapped = rpdo_map(axis.drive)
    controlword = (
        Signal("command", 0, 4, words=COMMANDS),
        Signal("mode_bits", 4, 3),
        Signal("fault_reset", 7, 1),
        Signal("halt", 8, 1),
    )
    signals = (*controlword, *_quantities(axis, mapped))
    name = axis.drive.name
    meaning = f"RPDO1 of {name}: followed from the next SYNC on"
    identifier, size = RPDO + axis.drive.node, pdo_bytes(mapped)
    return Frame(identifier, f"{name}_command", size, MASTER, name, signals, meaning, cycle)


def _answer(axis: Axis, cycle: int) -> Frame:
    mapped = tpdo_map(axis.drive)
    statusword = (
        Signal("power", 0, POWER_BITS, words=power_words()),
        Signal("warning", 7, 1),
        Signal("remote", 9, 1),
        Signal("target_reached", 10, 1),
        Signal("limited", 11, 1),
        Signal("follows", 12, 1),
        Signal("error", 13, 1),
        Signal("referenced", 15, 1),
    )
    signals = (*statusword, *_quantities(axis, mapped))
    name = axis.drive.name
    meaning = f"TPDO1 of {name}: its answer to SYNC"
    identifier, size = TPDO + axis.drive.node, pdo_bytes(mapped)
    return Frame(identifier, f"{name}_answer", size, name, MASTER, signals, meaning, cycle)


def power_words() -> Words:
    """The power state in every pattern of a statusword's lower bits (CiA 402)."""
    return tuple(
        (bits, name)
        for bits in range(1 << POWER_BITS)
        for mask, value, name in POWER_STATES
        if bits & mask == value
    )


def _quantities(axis: Axis, mapped: Sequence[Mapped]) -> Iterator[Signal]:
    """Positions and torques of a PDO; its first entry is a control- or statusword."""
    start = mapped[0].size
    for entry in mapped[1:]:
        if entry in POSITIONS:
            factor, unit = axis.metres_per_increment, "m"
        else:
            factor, unit = axis.torque_per_unit, "N m"
        yield Signal(entry.name, start, entry.size, entry.signed, factor, unit)
        start += entry.size
