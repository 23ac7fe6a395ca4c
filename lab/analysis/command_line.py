"""The commands `analyze` and `compare`: what they take, what they print."""

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.table import Table
from rich.text import Text

from turnbuckle.model.terminal import FAILED_CHECK, Force, MachineFile, complete_machine, progress


def as_length(millimetres: float) -> float:
    """Refuse what is no finite length."""
    if not math.isfinite(millimetres):
        raise typer.BadParameter("a finite number of millimetres is due")
    return millimetres


Lag = Annotated[
    float,
    typer.Option(
        metavar="MM", min=0, callback=as_length, help="How far late bases are behind the hand."
    ),
]


def analyze(
    file: MachineFile,
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help="Folder for report, numbers and maps.  [default: build/analysis/<name>]",
            show_default=False,
        ),
    ] = None,
    lag: Lag = 20.0,
    force: Force = False,
) -> None:
    """Say whether a geometry is any good, before metal is cut.

    Writes report.md, analysis.json and maps as PNG: the force there is in
    every direction, the margin of what the target wants, the motor torque it
    takes, and more. Exit status 1 if the target does not get what it wants
    everywhere, or not from these motors.

    \b
    Example:
      turnbuckle analyze machines/yoon2023.toml --out analysis --lag 10
    """
    from turnbuckle.model.reading import load_machine

    machine = load_machine(file)  # a mistake is told before the slow imports
    from turnbuckle.lab.analysis.analyze import analyze as look_at
    from turnbuckle.lab.analysis.report import rows, verdict

    folder = out or Path("build/analysis") / machine.name
    with progress() as tell:
        findings = look_at(machine, folder, lag / 1e3, tell, force)
    show_rows(["", machine.name], rows(findings))
    typer.echo(f"{verdict(findings)}\nreport: {folder / 'report.md'}")
    if not findings.target.passed:
        raise typer.Exit(FAILED_CHECK)


def compare(
    file: MachineFile,
    other: Annotated[
        Path,
        typer.Argument(
            help="Another machine.", show_default=False, autocompletion=complete_machine
        ),
    ],
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR", help="Folder for a report, numbers and maps.", show_default=False
        ),
    ] = None,
    lag: Lag = 20.0,
    force: Force = False,
) -> None:
    """Say what changed between two machines, and what it did.

    Lists the keys of the machine files whose values differ, and the numbers of
    the command analyze side by side.

    \b
    Example:
      turnbuckle compare machines/yoon_fixed_diagonal.toml machines/yoon2023.toml
    """
    from turnbuckle.model.reading import load_machine

    machines = load_machine(file), load_machine(other)
    from turnbuckle.lab.analysis.compare import compare as put_side_by_side

    with progress() as tell:
        comparison = put_side_by_side(machines, out, lag / 1e3, tell, force)
    names = comparison.names
    show_rows(["changed key", *names], comparison.changes or [("nothing", "", "")])
    show_rows(["", *names, "change"], comparison.rows)
    if out is not None:
        typer.echo(f"report: {out / 'report.md'}")


def show_rows(header: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """A table: labels on the left, values on the right."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column(header[0], overflow="fold")
    for heading in header[1:]:
        table.add_column(Text(heading), justify="right", overflow="fold")
    for row in rows:
        table.add_row(*map(Text, row))
    Console().print(table)
