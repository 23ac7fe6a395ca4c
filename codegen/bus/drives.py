"""tb_drives.h and tb_drives.c: what the runtime knows of the machine's buses and drives."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from math import inf

from turnbuckle.codegen.bus.process_data import process_data
from turnbuckle.codegen.constants import Constant, real
from turnbuckle.codegen.print_c import literal
from turnbuckle.model.bus.axis import Axis, axes
from turnbuckle.model.bus.contract import Object, contract, identity
from turnbuckle.model.bus.drive_kinds.kind import DriveError
from turnbuckle.model.bus.plan import compute_phase, loads, timing
from turnbuckle.model.machine import Machine

MODES = {"torque": 0, "position": 1}
#: By tb_mode: what a drive follows; nothing at first.
MODES_OF_RUNTIME = ("none", "torque", "position", "homing")
NO_FRAME = "{0x800, 0}"
"""An identifier has 11 bits."""


def drive_fields(machine: Machine) -> dict[str, object]:
    """What the two templates ask for."""
    identities, contracts = object_tables(machine)
    return {
        "groups": groups(machine),
        "buses": [bus_row(machine, number) for number in range(len(machine.buses))],
        "kinds": kind_rows(machine),
        "objects": [*identities, *contracts],
        "drives": [drive_row(axis, identities, contracts) for axis in axes(machine)],
        "node_frames": node_frames(machine),
    }


def groups(machine: Machine) -> list[tuple[str, list[Constant]]]:
    """All constants, in groups under a heading."""
    return [
        ("", sizes(machine)),
        ("Times", times(machine)),
        ("Supervision", supervision(machine)),
        ("Process data", process_data()),
        ("Base drives", base_drives(machine)),
        ("Calibration of the cables' zeros", calibration(machine)),
    ]


def sizes(machine: Machine) -> list[Constant]:
    """How many of what."""
    meaning = "cable drives in the order of the cables, then base drives in that of the rails"
    return [
        Constant("TB_BUSES", str(len(machine.buses))),
        Constant("TB_DRIVES", str(len(machine.drives)), meaning),
        Constant("TB_NODE_FRAMES", str(len(node_frames(machine))), "of nodes that are no drives"),
    ]


def times(machine: Machine) -> list[Constant]:
    """When things happen, and how long they may take."""
    limits = machine.supervision
    return [
        Constant(
            "TB_COMPUTE_PHASE",
            str(round(compute_phase(loads(machine), timing(machine)) * 1e6)),
            "us from SYNC until every answer is there: turnbuckle bus",
        ),
        count(machine, "HEARTBEAT_CYCLES", limits.heartbeat, "between heartbeats of the master"),
        count(
            machine,
            "HEARTBEAT_TIMEOUT",
            limits.drive_timeout,
            "without a heartbeat of a drive until it counts as silent",
        ),
        count(machine, "ANSWER_TIMEOUT", limits.answer_timeout, "until an SDO request has failed"),
        count(
            machine,
            "STATE_TIMEOUT",
            limits.state_timeout,
            "that a drive may take to an ordered power state or mode",
        ),
        count(machine, "HOMING_TIMEOUT", limits.homing_timeout, "of one homing run"),
        count(machine, "STOP_CYCLES", limits.stop_time, "of a soft stop, from work to no torque"),
    ]


def supervision(machine: Machine) -> list[Constant]:
    """Limits beyond which the machine stops."""
    limits = machine.supervision
    return [
        Constant(
            "TB_MISSED_LIMIT",
            str(limits.missed_syncs),
            "SYNCs in a row without an answer that are bridged",
        ),
        Constant(
            "TB_SKIPPED_LIMIT",
            str(limits.skipped_cycles),
            "control cycles skipped at once that are bridged",
        ),
        Constant(
            "TB_FAILED_LIMIT",
            str(limits.failed_steps),
            "controller steps failed in a row that are bridged",
        ),
        real(
            "TB_CLOSURE_LIMIT", limits.closure_limit, "m, largest residual of the measured lengths"
        ),
        count(machine, "CLOSURE_CYCLES", limits.closure_time, "beyond it that are bridged"),
        real("TB_CABLE_SPEED_LIMIT", limits.cable_speed, "m/s"),
        real("TB_RAIL_SPEED_LIMIT", limits.rail_speed, "m/s"),
        real("TB_RAIL_LAG_LIMIT", limits.rail_lag, "m, between a base and its target"),
        count(machine, "RAIL_LAG_CYCLES", limits.rail_lag_time, "beyond it that are bridged"),
        count(
            machine,
            "BLOCKED_CYCLES",
            limits.blocked_time,
            "that a carriage may stand still while it is pushed at its limit",
        ),
        real("TB_BLOCKED_TRAVEL", limits.blocked_travel, "m, motion that is none yet"),
    ]


def base_drives(machine: Machine) -> list[Constant]:
    """Rails and limits of their motors; zero where there is none."""
    drive = machine.rail_drive
    limit = drive.force_limit * drive.pinion_radius if drive else 0.0
    step = machine.supervision.rail_torque_rate / machine.control.rate if drive else 0.0
    lengths = [rail.length for rail in machine.rails] or [0.0]
    return [
        Constant(
            "TB_RAIL_LENGTHS",
            f"{{{', '.join(literal(length) for length in lengths)}}}",
            "m (TB_RAIL_SLOTS)",
        ),
        real("TB_RAIL_TORQUE_LIMIT", limit, "N m"),
        real("TB_RAIL_TORQUE_STEP", step, "N m, largest change of a torque in one cycle"),
    ]


def calibration(machine: Machine) -> list[Constant]:
    """How the cables' zeros are found."""
    way = machine.calibration
    shortest = min((rail.length for rail in machine.rails), default=inf)
    return [
        Constant("TB_CALIBRATION_SAMPLES", str(way.samples), "poses that are measured"),
        count(machine, "CALIBRATION_CYCLES", way.interval, "between two of them"),
        real(
            "TB_CALIBRATION_TRAVEL",
            way.travel_on(shortest),
            "m, sweep of each base to either side of the middle of its rail"
            if machine.rails
            else "m, a fifth of it makes another pose",
        ),
    ]


def count(machine: Machine, name: str, time: float, meaning: str) -> Constant:
    """A time [s] in control cycles, at least one."""
    cycles = max(1, round(time * machine.control.rate))
    return Constant(f"TB_{name}", str(cycles), f"cycles {meaning}")


def bus_row(machine: Machine, number: int) -> str:
    """A tb_bus_table."""
    bus = loads(machine)[number]
    return f'{{"{bus.name}", {round(bus.bit_rate)}U, {bus.divider}}}'


def node_frames(machine: Machine) -> list[str]:
    """Rows of tb_node_frame; one that nobody sends where there are none: C has no empty arrays."""
    buses = [bus.name for bus in machine.buses]
    rows = [
        f"{{0x{identifier:03X}, {buses.index(node.bus)}}}"
        for node in machine.nodes
        for identifier in node.identifiers
    ]
    return rows or [NO_FRAME]


@dataclass(frozen=True)
class Row:
    """A row of a table in C, and what it is about."""

    text: str
    meaning: str = field(default="", repr=False)


@dataclass(frozen=True)
class Rows:
    """A table in C, and the drives that share it."""

    name: str
    rows: tuple[Row, ...]
    drives: tuple[str, ...] = field(repr=False)


def drive_row(
    axis: Axis, identities: Sequence[Rows], contracts: Sequence[Rows]
) -> dict[str, object]:
    """What a drive's table is printed from."""
    increment, torque = axis.metres_per_increment, axis.torque_per_unit
    return {
        "name": axis.drive.name,
        "bus": axis.bus,
        "node": axis.drive.node,
        "mode": MODES[axis.drive.mode],
        "scales": [literal(x) for x in (increment, 1 / increment, torque, 1 / torque)],
        "most_torque_units": axis.most_torque_units,
        "kind": axis.kind.name,
        "identity": _shared_by(axis, identities),
        "contract": _shared_by(axis, contracts),
    }


def _shared_by(axis: Axis, tables: Sequence[Rows]) -> Rows:
    return next(table for table in tables if axis.drive.name in table.drives)


def object_tables(machine: Machine) -> tuple[list[Rows], list[Rows]]:
    """Identities and contracts, each once however many drives have the same."""
    drives = axes(machine)
    identities = [(axis, [c_object(e, axis, "CHECK") for e in identity(axis)]) for axis in drives]
    contracts = [
        (axis, [c_object(e, axis, "WRITE") for e in contract(machine, axis)]) for axis in drives
    ]
    return _once("identity", identities), _once("contract", contracts)


def _once(name: str, tables: Iterable[tuple[Axis, list[Row]]]) -> list[Rows]:
    sharing: dict[tuple[Row, ...], list[str]] = {}
    for axis, rows in tables:
        sharing.setdefault(tuple(rows), []).append(axis.drive.name)
    return [
        Rows(f"{name}_{number}", rows, tuple(drives))
        for number, (rows, drives) in enumerate(sharing.items(), start=1)
    ]


def c_object(entry: Object, axis: Axis, action: str) -> Row:
    """A tb_object."""
    where = f"0x{entry.index:04X}, {entry.subindex}, {entry.size}"
    value = entry.unsigned - (axis.drive.node if entry.of_node else 0)
    adds = "_OF_NODE" if entry.of_node else ""
    return Row(f"{{{where}, TB_OBJECT_{action}{adds}, 0x{value:X}U}}", entry.meaning)


def kind_rows(machine: Machine) -> list[dict[str, object]]:
    """What the tables of the machine's kinds of drives are printed from."""
    kinds = {axis.kind.name: axis.kind for axis in axes(machine)}
    return [
        {
            "name": kind.name,
            "heading": Row(kind.name, kind.meaning),
            "modes": [f"0x{kind.modes.get(mode, 0) % 0x100:02X}" for mode in MODES_OF_RUNTIME],
            "errors": [c_error(error) for error in kind.errors],
            "aborts": [f"{{0x{code:08X}U, {c_text(text)}}}" for code, text in kind.aborts.items()],
        }
        for kind in kinds.values()
    ]


def c_error(error: DriveError) -> str:
    """A tb_error_text."""
    codes = f"0x{error.first:04X}, 0x{error.last:04X}"
    return f"{{{codes}, TB_ERROR_{error.severity.name}, {c_text(error.text)}}}"


def c_text(text: str) -> str:
    """A string of C: printable ASCII, as a drive's maker words it."""
    if not (text.isascii() and text.isprintable()) or any(x in text for x in ('"', "\\", "??")):
        allowed = "printable ASCII without double quotes, backslash and ??"
        raise ValueError(f"{text!r}: allowed: {allowed}")
    return f'"{text}"'
