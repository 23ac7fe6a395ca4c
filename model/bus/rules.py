"""What must hold between the tables of buses, drives and motors, and the rest of the machine."""

import math
from collections.abc import Iterator
from typing import Any

from turnbuckle.model.bus.alternatives import alternatives, counted
from turnbuckle.model.bus.axis import base_drive, drive_names
from turnbuckle.model.bus.plan import BusPlan, Load, loads, plans, timing
from turnbuckle.model.bus.tables import (
    BIT_RATES,
    ERROR_CONTROL,
    MASTER,
    MASTER_NODE,
    Rating,
)
from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import (
    FOUND_NOTHING,
    Problem,
    key_path,
    nearest,
    problem_at,
    shown,
)

# A quotient of two rounded numbers may miss a whole number by this much.
ROUNDING = 1e-9
# A rate such as 1 kHz / 3 is written with some digits only.
WRITTEN = 1e-5
MOST_DIVIDER = 255
LONGEST_HEARTBEAT = 65.535
MILLISECOND = 1e-3
# Identifiers that only the master sends: NMT, SYNC, TIME, its heartbeat.
MASTERS = (0x000, 0x080, 0x100, ERROR_CONTROL + MASTER_NODE)

Found = Iterator[Problem]
Tables = dict[str, Any]


def buses_first(machine: Machine, tables: Tables) -> Found:
    """Tables that mean nothing without a bus."""
    if machine.buses:
        return
    for table in ("drive", "node", "supervision", "calibration"):
        if table in tables:
            yield Problem(table, "a table", "no such table without a [[bus]]")


def bit_rates(machine: Machine, tables: Tables) -> Found:
    """Bit rates are those that every CAN controller and drive knows."""
    for i, bus in enumerate(machine.buses):
        if bus.bit_rate not in BIT_RATES:
            known = ", ".join(f"{rate / 1e3:g}" for rate in BIT_RATES)
            yield problem_at(tables, ("bus", i, "bit_rate"), f"one of {known} kbit/s")


def sync_rates(machine: Machine, tables: Tables) -> Found:
    """SYNC comes with every control cycle, or every second, third ..."""
    for i, bus in enumerate(machine.buses):
        divider = machine.control.rate / bus.rate
        whole = abs(divider - round(divider)) <= WRITTEN * divider
        if not whole or not 1 <= round(divider) <= MOST_DIVIDER:
            rate = shown(tables["control"]["rate"])
            allowed = f"control.rate = {rate}, or this divided by 2, 3 ... {MOST_DIVIDER}"
            yield problem_at(tables, ("bus", i, "rate"), allowed)


def names_and_nodes(machine: Machine, tables: Tables) -> Found:
    """Buses and drives have names of their own; a number is given once on a bus."""
    buses = [bus.name for bus in machine.buses]
    drives = [drive.name for drive in machine.drives]
    nodes = [(drive.bus, drive.node) for drive in machine.drives]
    lists: dict[tuple[str, str], list[Any]] = {
        ("bus", "name"): buses,
        ("drive", "name"): drives,
        ("drive", "node"): nodes,
    }
    for (table, key), values in lists.items():
        for i, value in enumerate(values):
            if value in values[:i]:
                first = key_path((table, values.index(value), key))
                what = "number" if key == "node" else "name"
                yield problem_at(tables, (table, i, key), f"a {what} that differs from {first}")
    if MASTER in drives:
        location = ("drive", drives.index(MASTER), "name")
        yield problem_at(tables, location, f"a name other than {MASTER}, which is on every bus")


def drives_on_buses(machine: Machine, tables: Tables) -> Found:
    """Every drive is on a bus of the file, and every bus has a drive."""
    names = [bus.name for bus in machine.buses]
    for i, drive in enumerate(machine.drives):
        if drive.bus not in names:
            allowed = f"the buses {', '.join(names)}{nearest(drive.bus, names)}"
            yield problem_at(tables, ("drive", i, "bus"), allowed)
    for i, name in enumerate(names):
        if name not in [drive.bus for drive in machine.drives]:
            found = f"{shown(name)}, a bus without drives"
            yield Problem(key_path(("bus", i)), found, "a bus that some [[drive]] names")


def other_nodes(machine: Machine, tables: Tables) -> Found:
    """Other nodes are on a bus of the file, with names and numbers of their own."""
    buses = [bus.name for bus in machine.buses]
    drives = [(drive.name, drive.bus, drive.node) for drive in machine.drives]
    others = [(node.name, node.bus, node.node) for node in machine.nodes]
    for i, (name, bus, number) in enumerate(others):
        before = [*drives, *others[:i]]
        if bus not in buses:
            allowed = f"the buses {', '.join(buses)}{nearest(bus, buses)}"
            yield problem_at(tables, ("node", i, "bus"), allowed)
        if name in [MASTER, *(other[0] for other in before)]:
            allowed = f"a name that no drive and no other node has, nor {MASTER}"
            yield problem_at(tables, ("node", i, "name"), allowed)
        taken = [other[0] for other in before if other[1:] == (bus, number)]
        if taken:
            allowed = f"a number that nobody has on bus {bus}; {taken[0]} has this one"
            yield problem_at(tables, ("node", i, "node"), allowed)


def frames_of_other_nodes(machine: Machine, tables: Tables) -> Found:
    """An identifier on a bus is sent by one node only: not by the master, a drive, another node."""
    taken = {
        (drive.bus, function | drive.node): drive.name
        for drive in machine.drives
        for function in range(0x080, 0x780, 0x080)
    }
    taken |= {(node.bus, node.error_control): node.name for node in machine.nodes}
    for i, node in enumerate(machine.nodes):
        for j, frame in enumerate(node.frames):
            owner = MASTER if frame.id in MASTERS else taken.get((node.bus, frame.id))
            if owner is not None:
                allowed = f"an identifier that nobody has on bus {node.bus}; {owner} has this one"
                yield problem_at(tables, ("node", i, "frames", j, "id"), allowed)
            taken[node.bus, frame.id] = node.name


def drives_of_the_machine(machine: Machine, tables: Tables) -> Found:
    """One drive for each cable and each rail coordinate, and no other."""
    if not machine.buses:
        return
    due = drive_names(machine)
    named = [drive.name for drive in machine.drives]
    for i, name in enumerate(named):
        if name not in due:
            allowed = f"the drives {', '.join(due)}{nearest(name, due)}"
            yield problem_at(tables, ("drive", i, "name"), allowed)
    missing = [name for name in due if name not in named]
    if missing:
        found = f"no drive {', '.join(missing)}"
        yield Problem("drive", found, "one [[drive]] for each cable and each rail coordinate")
    for rail in range(len(machine.rails)):
        for i, cable in enumerate(machine.cables):
            if cable.drive == base_drive(rail):
                allowed = f"a name that is not that of the drive of rail coordinate {rail + 1}"
                yield Problem(key_path(("cable", i, "drive")), shown(cable.drive), allowed)


def positions_of_bases(machine: Machine, tables: Tables) -> Found:
    """A cable's drive follows a torque: it would slacken or break the cable otherwise."""
    cables = [cable.drive for cable in machine.cables]
    for i, drive in enumerate(machine.drives):
        if drive.mode == "position" and drive.name in cables:
            allowed = '"torque" for the drive of a cable'
            yield problem_at(tables, ("drive", i, "mode"), allowed)


def ratings_given(machine: Machine, tables: Tables) -> Found:
    """With buses, motors and the homing of bases are described."""
    if not machine.buses:
        return
    due: list[tuple[str, object]] = [("cable_motor.rating", machine.cable_motor.rating)]
    if machine.rail_drive:
        due.append(("rail_drive.rating", machine.rail_drive.rating))
        due.append(("rail_drive.homing", machine.rail_drive.homing))
    for key, table in due:
        if table is None:
            yield Problem(key, FOUND_NOTHING, "a table, because of bus[1]")


def currents(machine: Machine, tables: Tables) -> Found:
    """A motor's limits are within each other."""
    if not machine.buses:
        return
    motor, rail_drive = machine.cable_motor, machine.rail_drive
    if motor.rating:
        needed = motor.torque_limit / motor.rating.torque_constant
        yield from _current(tables, "cable_motor", motor.rating, needed, "torque_limit")
    if rail_drive and rail_drive.rating:
        torque = rail_drive.force_limit * rail_drive.pinion_radius
        needed = torque / rail_drive.rating.torque_constant
        yield from _current(tables, "rail_drive", rail_drive.rating, needed, "force_limit")
    if rail_drive and rail_drive.rating and rail_drive.homing:
        limit = rail_drive.rating.current_limit
        if rail_drive.homing.current > limit:
            allowed = f"at most rail_drive.rating.current_limit = {limit:g} A"
            yield problem_at(tables, ("rail_drive", "homing", "current"), allowed)


def _current(tables: Tables, table: str, rating: Rating, needed: float, why: str) -> Found:
    location = (table, "rating", "current_limit")
    if rating.current_limit < needed * (1 - ROUNDING):
        allowed = f"at least {needed:.4g} A, which {table}.{why} takes"
        yield problem_at(tables, location, allowed)


def heartbeats(machine: Machine, tables: Tables) -> Found:
    """Heartbeats come several times before their absence counts."""
    limits, cycle = machine.supervision, 1 / machine.control.rate
    pairs = (("heartbeat", "heartbeat_timeout"), ("drive_heartbeat", "drive_timeout"))
    for beat, timeout in pairs:
        if getattr(limits, timeout) < 2 * getattr(limits, beat) * (1 - ROUNDING):
            allowed = f"at least twice supervision.{beat} = {getattr(limits, beat) * 1e3:g} ms"
            yield supervision_problem(machine, tables, timeout, allowed)
    for key in ("heartbeat_timeout", "drive_heartbeat"):
        time = getattr(limits, key)
        if not MILLISECOND * (1 - ROUNDING) <= time <= LONGEST_HEARTBEAT:
            yield supervision_problem(machine, tables, key, "1 ms to 65.535 s")
    if limits.heartbeat < cycle * (1 - ROUNDING):
        allowed = f"at least a control cycle, {cycle * 1e3:g} ms"
        yield supervision_problem(machine, tables, "heartbeat", allowed)


def supervision_problem(machine: Machine, tables: Tables, key: str, allowed: str) -> Problem:
    """A problem with a time or word that the file need not give."""
    location = ("supervision", key)
    if key in tables.get("supervision", ()):
        return problem_at(tables, location, allowed)
    value = getattr(machine.supervision, key)
    text = shown(value) if isinstance(value, str) else f"{value * 1e3:g} ms"
    return Problem(key_path(location), f"{text}, the default", allowed)


def sweeps(machine: Machine, tables: Tables) -> Found:
    """Bases sweep within their rails."""
    travel = machine.calibration.travel
    if machine.buses and machine.rails and travel is not None:
        half = min(rail.length for rail in machine.rails) / 2
        if travel > half * (1 + ROUNDING):
            allowed = f"at most half of the shortest rail, {half * 1e3:g} mm"
            yield problem_at(tables, ("calibration", "travel"), allowed)


def schedulable(machine: Machine, tables: Tables) -> Found:
    """Every frame arrives in time: the bus proof."""
    common, buses = timing(machine), loads(machine)
    alone = [plans([load], common)[0] for load in buses]
    together = plans(buses, common)
    # Where each fits alone, those that do not fit beside the slowest answers are to blame.
    judged = together if all(plan.fits for plan in alone) else alone
    good = [plan.load for plan in judged if plan.fits]
    for i, plan in enumerate(judged):
        if not plan.fits:
            ways = alternatives(plan.load, good, common)
            allowed = ", or ".join(ways) or "another way to spread the drives over buses"
            yield Problem(key_path(("bus", i)), _in_words(plan), allowed)


def _others(load: Load) -> str:
    return f" and {', '.join(node.name for node in load.nodes)}" if load.nodes else ""


def _in_words(plan: BusPlan) -> str:
    """What is too much for a bus."""
    load, phases = plan.load, plan.phases
    text = (
        f"{shown(load.name)} with {counted(load.drives)}{_others(load)}, too much for"
        f" {load.bit_rate / 1e3:g} kbit/s: SYNC and PDOs take {plan.cyclic_share:.1%} of its time,"
        f" all frames {plan.share:.1%}"
    )
    if not plan.late:
        return f"{text}, and a cycle {-phases.room * 1e6:.0f} us more than there are"
    worst = plan.late[0]
    taken = "for ever" if worst.response == math.inf else f"{worst.response * 1e6:.0f} us"
    allowed = f"{worst.deadline * 1e6:.0f} us are allowed"
    return f"{text}; {worst.message.name} may take {taken}, {allowed}"
