"""The benchmark's results, for a person and for a program."""

import json
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

from turnbuckle.lab.benchmark.cortex_m4.comparison import CountRow
from turnbuckle.lab.benchmark.cycle.cost import CycleRow
from turnbuckle.lab.benchmark.map.comparison import MapRow, MapTable
from turnbuckle.lab.benchmark.solvers.turnbuckle import OURS
from turnbuckle.lab.benchmark.step.comparison import StepRow
from turnbuckle.lab.benchmark.table1 import Table1
from turnbuckle.lab.benchmark.targets import Target
from turnbuckle.lab.benchmark.tension import Row, TensionTable
from turnbuckle.model.files import write_whole

COUNTED = (
    "turnbuckle: bounds, status and self-check included; CasADi as documented: casadi_real=float;"
    " CasADi remapped: its double names and constants made float by hand; SymPy: float32 and cse;"
    " SymPy own Pow: powers printed as products by hand"
)


@dataclass(frozen=True)
class Results:
    """Everything one run measured."""

    machine: str
    tension: list[TensionTable]
    table1: Table1
    step: list[StepRow]
    cycle: list[CycleRow]
    cortex_m4: list[CountRow]
    maps: list[MapTable]
    targets: list[Target]


def write_json(results: Results, path: Path) -> None:
    """All numbers; times in ns, errors in SI units."""
    write_whole(path, json.dumps(asdict(results), indent=1) + "\n")


def show(results: Results, console: Console) -> None:
    """Print every table; the ratios are peer / ours, of least times."""
    for table in results.tension:
        console.print(tension_table(table))
    console.print(table1_view(results.table1))
    console.print(step_table(results.step))
    console.print(cycle_table(results.cycle))
    console.print(count_table(results.cortex_m4))
    for each in results.maps:
        console.print(map_table(each))
    console.print(target_table(results.targets))


def tension_table(table: TensionTable) -> Table:
    """One set of tension problems."""
    view = new_table(
        f"Tension solve, {table.problems}: {table.feasible} of {table.count} feasible",
        ("name", "least ns", "median ns", "ratio", "max |dT| N", "missed", "invented"),
        notes(table.rows),
    )
    for row in table.rows:
        timing, agreement = row.timing, row.agreement
        view.add_row(
            row.name,
            f"{timing.least:.0f}",
            f"{timing.median:.0f}",
            f"{table.ratio(row.name):.2f}",
            f"{agreement.error:.1e}",
            str(agreement.missed),
            str(agreement.invented),
        )
    return view


def table1_view(table1: Table1) -> Table:
    """Brau's comparison, and what reduced matrices give away."""
    view, excess = tension_table(table1.table), table1.excess
    view.caption = (
        f"{view.caption}; reduced matrices: optimal in {excess.optimal:.1%}, |T| higher by"
        f" {excess.norm[0]:.2%} on average and {excess.norm[1]:.1%} at most, the largest tension"
        f" by {excess.tension[0]:.1%} and {excess.tension[1]:.0%}"
    )
    return view


def step_table(rows: Sequence[StepRow]) -> Table:
    """The whole controller step on the host."""
    columns = ("name", "least ns", "median ns", "ratio", "|dtorque| N m", "|dforce| N")
    view = new_table("Controller step, double, this host", columns, notes(rows))
    ours = rows[0].timing.least
    for row in rows:
        view.add_row(
            row.name,
            f"{row.timing.least:.0f}",
            f"{row.timing.median:.0f}",
            f"{row.timing.least / ours:.2f}",
            f"{row.torque_error:.1e}",
            f"{row.force_error:.1e}",
        )
    return view


def cycle_table(rows: Iterable[CycleRow]) -> Table:
    """The whole control cycle on the host."""
    columns = ("name", "least ns", "median ns", "frames")
    what = "reading frames, supervisor, controller step, recorder, sending; buses in memory"
    view = new_table("Control cycle at work, this host", columns, what)
    for row in rows:
        timing = row.timing
        view.add_row(
            row.precision, f"{timing.least:.0f}", f"{timing.median:.0f}", f"{row.frames:.1f}"
        )
    return view


def count_table(rows: Iterable[CountRow]) -> Table:
    """Instructions on the microcontroller."""
    columns = ("function", "generator", "mean", "most", "ratio", "max error")
    view = new_table("Cortex-M4F, float, instructions per call", columns, COUNTED)
    ours = 1.0
    for row in rows:
        is_ours = row.generator == OURS
        ours = row.mean if is_ours else ours
        view.add_row(
            row.function if is_ours else "",
            row.generator,
            f"{row.mean:.0f}",
            f"{row.most:.0f}",
            f"{row.mean / ours:.2f}",
            f"{row.error:.1e}",
        )
    return view


def map_table(table: MapTable) -> Table:
    """One scene, mapped in all ways."""
    columns = ("name", "least ns", "10^6/s", "ratio", "|dmargin| N", "|dTF|")
    view = new_table(f"Map of margin and tension factor: {table.scene}", columns, notes(table.rows))
    for row in table.rows:
        view.add_row(
            row.name,
            f"{row.timing.least:.0f}",
            f"{row.poses_per_second / 1e6:.3g}",
            f"{table.ratio(row.name):.2f}",
            f"{row.margin_error:.1e}",
            f"{row.factor_error:.1e}",
        )
    return view


def target_table(targets: Iterable[Target]) -> Table:
    """What was promised."""
    view = new_table("Promised: times faster than, or as said", ("what", "wanted", "measured", ""))
    for target in targets:
        verdict = "met" if target.is_met else "missed"
        view.add_row(target.what, f"{target.wanted:g}", f"{target.measured:.2f}", verdict)
    return view


def notes(rows: Iterable[Row] | Iterable[StepRow] | Iterable[MapRow]) -> str:
    """What every program of a table includes."""
    return "; ".join(f"{row.name}: {row.note}" for row in rows)


def new_table(title: str, columns: Sequence[str], caption: str = "") -> Table:
    """A table whose numbers stand to the right."""
    view = Table(
        title=title, box=SIMPLE_HEAD, caption=caption, title_justify="left", caption_justify="left"
    )
    for column in columns:
        is_text = column in ("name", "function", "generator", "what", "")
        view.add_column(column, justify="left" if is_text else "right", no_wrap=True)
    return view
