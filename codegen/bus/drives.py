"""tb_drives.h and tb_drives.c: what the runtime knows of the machine's buses and drives."""

from math import inf

from turnbuckle.codegen.bus.contract import Object, contract, identity
from turnbuckle.codegen.bus.process_data import process_data
from turnbuckle.codegen.constants import Constant, real
from turnbuckle.codegen.print_c import literal
from turnbuckle.model.bus.axis import Axis, axes
from turnbuckle.model.bus.plan import compute_phase, loads, timing
from turnbuckle.model.machine import Machine

MODES = {"torque": 0, "position": 1}
NO_FRAME = "{0x800, 0}"
"""An identifier has 11 bits."""


def drive_fields(machine: Machine) -> dict[str, object]:
    """What the two templates ask for."""
    return {
        "groups": groups(machine),
        "buses": [bus_row(machine, number) for number in range(len(machine.buses))],
        "drives": [drive_row(machine, axis) for axis in axes(machine)],
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


def drive_row(machine: Machine, axis: Axis) -> dict[str, object]:
    """What a drive's tables are printed from."""
    increment, permille = axis.metres_per_increment, axis.torque_per_permille
    return {
        "name": axis.drive.name,
        "bus": axis.bus,
        "node": axis.drive.node,
        "mode": MODES[axis.drive.mode],
        "scales": [literal(x) for x in (increment, 1 / increment, permille, 1 / permille)],
        "permille_limit": axis.permille_limit,
        "identity": [c_object(entry, "CHECK") for entry in identity(axis)],
        "contract": [c_object(entry, "WRITE") for entry in contract(machine, axis)],
    }


def c_object(entry: Object, action: str) -> str:
    """A tb_object."""
    where = f"0x{entry.index:04X}, {entry.subindex}, {entry.size}"
    return f"{{{where}, TB_OBJECT_{action}, 0x{entry.unsigned:X}U}}"
