"""A recording as a table: a row a cycle, columns with their units, states and causes in words."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from io import BytesIO
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray
from pyarrow import csv, parquet

from turnbuckle.codegen.struct_layout import Layouts
from turnbuckle.lab.flight import FlightError
from turnbuckle.lab.flight.recording import Recording
from turnbuckle.model.bus.axis import drive_names
from turnbuckle.model.files import refuse_foreign_file, write_whole
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import Status


class Writer(NamedTuple):
    """How a table is written, and what of it tells that it is ours."""

    write: Callable[[pa.Table, BytesIO], None]
    mark: bytes


METADATA = {"turnbuckle": "a flight recording"}
WRITERS = {
    ".csv": Writer(csv.write_csv, b'"cycle","time_s","state"'),
    ".parquet": Writer(parquet.write_table, b"a flight recording"),
}
Column = NDArray[Any]
Columns = Iterator[tuple[str, Column]]


def write_table(recording: Recording, path: Path) -> None:
    """Write the table as CSV or Parquet, as its name ends; FileError where it cannot."""
    refuse_foreign_table(path)
    content = {name: pa.array(column) for name, column in columns(recording)}
    stream = BytesIO()
    WRITERS[path.suffix].write(pa.table(content).replace_schema_metadata(METADATA), stream)
    write_whole(path, stream.getvalue())


def refuse_foreign_table(path: Path) -> None:
    """Refuse a name that ends otherwise, and to replace what is no such table."""
    if path.suffix not in WRITERS:
        raise FlightError(f"{path}: ends in {path.suffix!r}; allowed: {', '.join(WRITERS)}")
    refuse_foreign_file(path, WRITERS[path.suffix].mark)


def columns(recording: Recording) -> Columns:
    """Names and values of all columns, each as long as the recording."""
    machine, cycles = recording.machine, recording.cycles
    seen, orders = cycles["seen"], cycles["orders"]
    yield "cycle", recording.numbers
    yield "time_s", times(recording)
    yield from states(recording.layouts, seen, orders)
    yield from platform(machine, seen, orders)
    yield from cables(machine, orders)
    yield from rails(machine, orders["controller"])
    yield from drives(recording, seen["drives"], orders["drives"])
    for number, bus in enumerate(machine.buses):
        yield from bus_columns(recording.layouts, bus.name, seen["buses"][:, number])


def times(recording: Recording) -> NDArray[np.float64]:
    """Time [s] of every cycle since the first, with the cycles that were skipped."""
    passed = np.diff(recording.numbers, prepend=recording.numbers[:1])
    skipped = recording.cycles["seen"]["missed"].astype(np.int64)
    if len(skipped):
        skipped[0] = 0
    return np.asarray(np.cumsum(passed + skipped) / recording.machine.control.rate)


def states(layouts: Layouts, seen: Column, orders: Column) -> Columns:
    """What the machine does, and why."""
    yield "state", in_words(orders["state"], layouts, "state")
    yield "phase", orders["phase"]
    yield "cause", in_words(orders["cause"], layouts, "cause")
    for name in ("culprit", "index", "subindex"):
        yield name, orders[name]
    yield "failure", in_words(orders["failure"], layouts, "failure")
    yield "detail", orders["detail"]
    yield "requests", texts(seen["requests"], partial(requests, layouts))
    yield "beat", orders["beat"]
    yield "cycles_skipped", seen["missed"]
    status = tuple(one.name.lower().replace("_", " ") for one in Status)
    yield "controller", texts(orders["controller"]["status"], partial(listed, status))


def requests(layouts: Layouts, bits: int) -> str:
    """The requests that stand, joined by +."""
    known = layouts.enumerations.get("request", {})
    return "+".join(name.lower() for name, bit in known.items() if bits & bit)


def platform(machine: Machine, seen: Column, orders: Column) -> Columns:
    """Where the platform is, and what acts on it."""
    out = orders["controller"]
    yield from along(machine, "pose", out["pose"], "m", "rad")
    yield from along(machine, "velocity", out["velocity"], "m_per_s", "rad_per_s")
    yield "residual_m", out["residual"]
    yield from along(machine, "application_force", seen["force"], "N", "N_m")
    yield from along(machine, "hand_force", seen["hand_force"], "N", "N_m")
    yield "hand_force_fresh", seen["hand_force_fresh"]
    yield from along(machine, "wanted_force", out["wanted_force"], "N", "N_m")
    yield from along(machine, "delivered_force", out["delivered_force"], "N", "N_m")


def along(machine: Machine, name: str, values: Column, unit: str, turning_unit: str) -> Columns:
    """A column for every degree of freedom: x y z, then the turns about the axes."""
    turns = ("turn",) if machine.dof == 3 else ("turn_x", "turn_y", "turn_z")
    for i in range(machine.dof):
        if i < machine.space:
            yield f"{name}_{'xyz'[i]}_{unit}", values[:, i]
        else:
            yield f"{name}_{turns[i - machine.space]}_{turning_unit}", values[:, i]


def cables(machine: Machine, orders: Column) -> Columns:
    """What the controller wants of every cable, and what the watch and the gate say of it."""
    out = orders["controller"]
    for i, cable in enumerate(machine.cables):
        yield f"{cable.drive}_tension_N", out["tension"][:, i]
        yield f"{cable.drive}_disturbance_N_m", out["disturbance"][:, i]
        yield f"{cable.drive}_slack_m", orders["slack"][:, i]
        yield f"{cable.drive}_gate", out["gate"][:, i]


def rails(machine: Machine, out: Column) -> Columns:
    """What the controller wants of every base."""
    for i, name in enumerate(drive_names(machine)[len(machine.cables) :]):
        yield f"{name}_target_m", out["rail_target"][:, i]
        yield f"{name}_force_N", out["rail_force"][:, i]


def drives(recording: Recording, reports: Column, orders: Column) -> Columns:
    """What every drive reported and was ordered."""
    layouts = recording.layouts
    for i, name in enumerate(drive_names(recording.machine)):
        report, order = reports[:, i], orders[:, i]
        yield f"{name}_position_m", report["position"]
        yield f"{name}_torque_N_m", report["torque"]
        yield f"{name}_ordered_torque_N_m", order["torque"]
        yield f"{name}_ordered_position_m", order["position"]
        yield f"{name}_power", in_words(report["power"], layouts, "power")
        yield f"{name}_goal", in_words(order["goal"], layouts, "goal")
        yield f"{name}_mode", in_words(report["mode"], layouts, "mode")
        yield f"{name}_homing", in_words(report["homing"], layouts, "homing")
        yield f"{name}_task", in_words(report["task"], layouts, "task")
        yield f"{name}_progress", in_words(report["progress"], layouts, "progress")
        yield f"{name}_failure", in_words(report["failure"], layouts, "failure")
        for field in ("index", "subindex", "detail", "statusword", "error_code"):
            yield f"{name}_{field}", report[field]
        for field in ("fresh", "missed", "late", "silent"):
            yield f"{name}_{field}", report[field]


def bus_columns(layouts: Layouts, name: str, bus: Column) -> Columns:
    """What a bus reported."""
    yield f"bus_{name}_state", in_words(bus["state"], layouts, "bus_state")
    for field in ("refused", "stranger", "malformed"):
        yield f"bus_{name}_{field}", bus[field]


def in_words(numbers: Column, layouts: Layouts, enumeration: str) -> Column:
    """Values of an enumeration as words; one without a word as it is."""
    return texts(numbers, partial(layouts.word, enumeration))


def listed(words: Sequence[str], number: int) -> str:
    """The word of a number that counts from 0; the number itself where there is none."""
    return words[number] if 0 <= number < len(words) else str(number)


def texts(numbers: Column, text: Callable[[int], str]) -> Column:
    """The text of every number."""
    found, inverse = np.unique(numbers, return_inverse=True)
    return np.array([text(number) for number in found.tolist()], object)[inverse]
