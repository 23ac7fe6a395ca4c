"""What the monitor shows: one reading of the telemetry as text."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from rich.columns import Columns
from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from turnbuckle.codegen.struct_layout import Layouts
from turnbuckle.lab.live.plane import draw_plane, has_plane
from turnbuckle.lab.live.telemetry import Record, Telemetry, rates
from turnbuckle.model.machine import Machine

BAR = 20
"""Characters of a bar."""
LOCATED = ("TENSION", "RUN", "SOFT_STOP", "HARD_STOP")
"""States in which the controller knows the pose."""
STYLES = {"RUN": "bold green", "FAULT": "bold red", "HARD_STOP": "bold red", "SOFT_STOP": "yellow"}
SILENCES = {"UNHEARD": "silent", "LOCAL": "under local control"}
US, MM = 1e3, 1e3  # ns in us, mm in m


@dataclass(frozen=True)
class Reading:
    """What was read at one moment; `before` is the status some time earlier."""

    ended: bool
    cycle: Record | None
    status: Record
    before: Record


def show(telemetry: Telemetry, reading: Reading, machine: Machine | None) -> RenderableType:
    """Everything, for a terminal."""
    parts: list[RenderableType] = [headline(telemetry, reading)]
    if reading.cycle is not None:
        parts.append(body(telemetry, reading.cycle, machine))
    parts.append(buses(telemetry, reading))
    parts.append(cycles(reading.status))
    if not telemetry.counts["simulated"]:
        parts.append(times(telemetry, reading.status["times"]))
    return Group(*parts)


def headline(telemetry: Telemetry, reading: Reading) -> Text:
    """Machine, state and, where it stopped, why."""
    text = Text(f"{telemetry.machine} {telemetry.hash}", style="bold")
    text.append(f"  program {telemetry.counts['pid']}", style="dim")
    if telemetry.counts["simulated"]:
        text.append("  in simulated time", style="dim")
    if reading.ended:
        text.append("\nthe program has ended: this is its last cycle", style="bold red")
    cycle = reading.cycle
    if cycle is None:
        text.append("\nno cycle yet")
        return text
    state = telemetry.layouts.name("state", cycle["state"])
    text.append("\n")
    text.append(state, style=STYLES.get(state, "bold cyan"))
    text.append(f"  {reading.status['doing'].decode(errors='replace')}")
    text.append(f"  cycle {cycle['number']}", style="dim")
    if cause := reading.status["cause"].decode(errors="replace"):
        text.append(f"\n{cause}", style="red" if state == "FAULT" else "yellow")
    return text


def body(telemetry: Telemetry, cycle: Record, machine: Machine | None) -> RenderableType:
    """Pose, cables and drives; beside them the picture, where there is one."""
    located = telemetry.layouts.name("state", cycle["state"]) in LOCATED
    numbers = Group(pose(cycle, located), cables(telemetry, cycle), drives(telemetry, cycle))
    if machine is None or not has_plane(machine):
        return numbers
    first = int(telemetry.counts["cables"])
    rails = cycle["drives"]["position"][first : first + len(machine.rails)]
    return Columns([numbers, draw_plane(machine, cycle["pose"] if located else None, rails)])


def pose(cycle: Record, located: bool) -> Text:
    """Where the handle is and what it feels, in a state in which the controller knows it."""
    if not located:
        return Text("pose          not known in this state", style="dim")
    lines = (
        ("pose", cycle["pose"] * MM, "mm"),
        ("velocity", cycle["velocity"] * MM, "mm/s"),
        ("wanted", cycle["wanted_force"], "N"),
        ("delivered", cycle["delivered_force"], "N"),
        ("closure", [cycle["residual"] * MM], "mm"),
    )
    return Text("\n".join(f"{name:12}  {vector(values)} {unit}" for name, values, unit in lines))


def vector(values: Sequence[float]) -> str:
    """Numbers in columns."""
    return " ".join(f"{value:9.3f}" for value in values)


def cables(telemetry: Telemetry, cycle: Record) -> Table:
    """Tensions between their bounds."""
    low, high = (float(telemetry.counts[f"tension_{end}"]) for end in ("min", "max"))
    table = plain("cable", "tension", f"{low:g} to {high:g} N", "slack")
    for i, tension in enumerate(cycle["tension"]):
        share = (float(tension) - low) / (high - low) if high > low else 0.0
        slack = f"{cycle['slack'][i] * MM:.2f} mm" if cycle["slack"][i] else ""
        table.add_row(telemetry.drive_names[i], f"{tension:.2f} N", bar(share), slack)
    return table


def drives(telemetry: Telemetry, cycle: Record) -> Table:
    """What every drive reports, what it is ordered."""
    table = plain("drive", "power", "mode", "position", "torque", "ordered", "status", "remarks")
    for name, drive in zip(telemetry.drive_names, cycle["drives"], strict=True):
        table.add_row(
            name,
            telemetry.layouts.word("power", drive["power"]),
            telemetry.layouts.word("mode", drive["mode"]),
            f"{drive['position'] * MM:.2f} mm",
            f"{drive['torque'] * 1e3:.1f} mN m",
            f"{drive['ordered_torque'] * 1e3:.1f} mN m",
            f"{drive['statusword']:04X}",
            ", ".join(remarks(telemetry.layouts, drive)),
        )
    return table


def remarks(layouts: Layouts, drive: Record) -> Iterator[str]:
    """What is unusual about a drive."""
    if drive["silent"]:
        silence = layouts.name("silence", drive["silent"])
        yield SILENCES.get(silence, silence)
    if drive["missed"]:
        yield f"{drive['missed']} answers missing"
    if drive["error_code"]:
        yield f"error {drive['error_code']:04X}"
    if drive["task"]:
        yield layouts.word("task", drive["task"])


def buses(telemetry: Telemetry, reading: Reading) -> Table:
    """State, load and what went wrong on every bus."""
    table = plain(
        "bus",
        "state",
        "load",
        "frames/s",
        "sent",
        "received",
        "refused",
        "lost",
        "malformed",
        "off",
    )
    each = rates(reading.before, reading.status, float(telemetry.counts["period"]))
    for name, bus, rate in zip(telemetry.bus_names, reading.status["buses"], each, strict=True):
        table.add_row(
            name,
            telemetry.layouts.word("can_state", bus["state"]).removeprefix("error "),
            f"{100 * rate.load:.0f} %",
            f"{rate.frames:.0f}",
            *(str(bus[count]) for count in ("sent", "received", "refused", "lost", "malformed")),
            str(bus["bus_off"]),
        )
    return table


def cycles(status: Record) -> Text:
    """How many there were, and how many there should have been."""
    times = status["times"]
    missed = Text(
        f"{status['published']} cycles, {times['missed']} missed,"
        f" at most {times['longest_gap']} at once"
    )
    if times["missed"]:
        missed.stylize("yellow")
    return missed


def times(telemetry: Telemetry, kept: Record) -> RenderableType:
    """How well the loop keeps time."""
    edges = [*(f"{edge / US:g} us" for edge in telemetry.counts["edges"]), "more"]
    table = plain("up to", "wake-up late", "", "computing", "")
    seen = np.flatnonzero(kept["lateness"]["bins"] + kept["computing"]["bins"])
    for i in range(seen[-1] + 1 if len(seen) else 0):
        row: list[RenderableType] = [edges[i]]
        for name in ("lateness", "computing"):
            histogram = kept[name]
            share = float(histogram["bins"][i]) / max(1, int(histogram["count"]))
            row += [str(histogram["bins"][i]), bar(share)]
        table.add_row(*row)
    return Group(extremes(kept), table)


def extremes(kept: Record) -> Text:
    """Mean and longest of both times."""
    words = []
    for name, what in (("lateness", "late"), ("computing", "computing")):
        histogram = kept[name]
        mean = float(histogram["sum"]) / max(1, int(histogram["count"]))
        words.append(f"{what} {mean / US:.1f} us, longest {histogram['most'] / US:.1f} us")
    return Text("; ".join(words))


def plain(*columns: str) -> Table:
    """A table without lines."""
    table = Table(box=None, padding=(0, 2, 0, 0), header_style="dim", title_justify="left")
    for column in columns:
        table.add_column(column, no_wrap=True)
    return table


def bar(share: float) -> Text:
    """A bar of a share; beyond 0 or 1 it is red."""
    full = round(min(1.0, max(0.0, share)) * BAR)
    inside = -1e-9 <= share <= 1 + 1e-9
    return Text("█" * full + "░" * (BAR - full), style="cyan" if inside else "red")
