"""The bus proof in rows for people, and as plain data."""

from collections.abc import Callable, Sequence
from typing import Any

from turnbuckle.model.bus.plan import BusPlan, Row, bus_plans
from turnbuckle.model.machine import Machine

#: Kinds of frames, told by the end of a message's name.
KINDS = ("SYNC", "emergency", "answer", "command", "SDO answer", "SDO request", "heartbeat")
Cell = Callable[[BusPlan], str]


def table(machine: Machine) -> tuple[list[str], list[list[str]]]:
    """Header and rows: one column a bus; a row of one entry is a heading."""
    plans = bus_plans(machine)
    header = ["", *(plan.load.name for plan in plans)]
    rows = [_row(label, plans, cell) for label, cell in _facts()]
    rows.append(["longest response, us (of)"])
    rows += [_row(f"  {kind}", plans, _worst(kind)) for kind in KINDS]
    if machine.nodes:
        rows.append(_row("  other nodes", plans, _worst_of_others))
    rows.append(_row("  an error adds", plans, lambda plan: _us(plan.recovery)))
    rows.append(["a cycle, us after SYNC"])
    rows += [_row(f"  {label}", plans, cell) for label, cell in _phases()]
    return header, rows


def _row(label: str, plans: Sequence[BusPlan], cell: Cell) -> list[str]:
    return [label, *(cell(plan) for plan in plans)]


def _facts() -> list[tuple[str, Cell]]:
    return [
        ("bit rate, kbit/s", lambda plan: f"{plan.load.bit_rate / 1e3:g}"),
        ("SYNC every, us", lambda plan: _us(_of_kind(plan, "SYNC")[0].period)),
        ("drives", lambda plan: ", ".join(f"{d.name}:{d.node}" for d in plan.load.drives)),
        ("load, SYNC and PDOs", lambda plan: f"{plan.cyclic_share:.1%}"),
        ("load, all at their most", lambda plan: f"{plan.share:.1%}"),
    ]


def _phases() -> list[tuple[str, Cell]]:
    return [
        ("SYNC there", lambda plan: _us(plan.phases.sync)),
        ("every answer there", lambda plan: _us(plan.phases.answers)),
        ("computing begins", lambda plan: _us(plan.phases.compute)),
        ("computing ends", lambda plan: _us(plan.phases.computed)),
        ("every command there", lambda plan: _us(plan.phases.commands)),
        ("left until next SYNC", lambda plan: _us(plan.phases.room)),
    ]


def _worst(kind: str) -> Cell:
    def cell(plan: BusPlan) -> str:
        worst = max(_of_kind(plan, kind), key=lambda row: row.response / row.deadline)
        return f"{_us(worst.response)} ({_us(worst.deadline)})"

    return cell


def _worst_of_others(plan: BusPlan) -> str:
    sent = {frame.id for node in plan.load.nodes for frame in node.frames}
    rows = [row for row in plan.rows if row.message.identifier in sent]
    worst = max(rows, key=lambda row: row.response / row.deadline, default=None)
    return "-" if worst is None else f"{_us(worst.response)} ({_us(worst.deadline)})"


def _of_kind(plan: BusPlan, kind: str) -> list[Row]:
    """The rows of one kind; answers of drives are not those to SDO requests."""
    rows = [row for row in plan.rows if row.message.name.endswith(kind)]
    return [row for row in rows if kind.startswith("SDO") or "SDO" not in row.message.name]


def _us(time: float) -> str:
    return f"{time * 1e6:.0f}"


def as_data(machine: Machine) -> dict[str, Any]:
    """The same as plain data: SI units, every message."""
    return {"machine": machine.name, "buses": [_bus(plan) for plan in bus_plans(machine)]}


def _bus(plan: BusPlan) -> dict[str, Any]:
    phases = plan.phases
    return {
        "name": plan.load.name,
        "bit_rate": plan.load.bit_rate,
        "divider": plan.load.divider,
        "drives": {drive.name: drive.node for drive in plan.load.drives},
        "nodes": {node.name: node.node for node in plan.load.nodes},
        "load": {"cyclic": plan.cyclic_share, "all": plan.share},
        "error_recovery": plan.recovery,
        "phases": {
            "sync": phases.sync,
            "answers": phases.answers,
            "compute": phases.compute,
            "computed": phases.computed,
            "commands": phases.commands,
            "room": phases.room,
        },
        "messages": [_message(row) for row in plan.rows],
    }


def _message(row: Row) -> dict[str, Any]:
    return {
        "name": row.message.name,
        "identifier": row.message.identifier,
        "bytes": row.message.size,
        "length": row.length,
        "period": row.period,
        "deadline": row.deadline,
        "response": row.response,
    }
