"""The commands `optimise` and `study`: what they take, what they print."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer
from rich.console import Console
from rich.table import Table
from rich.text import Text

from turnbuckle.model.terminal import INTERRUPTED, NOTHING_BETTER, MachineFile, fail, progress

if TYPE_CHECKING:
    from turnbuckle.lab.design.design import Design
    from turnbuckle.lab.design.improve import Improvement
    from turnbuckle.lab.design.results import Results

Vary = Annotated[
    list[str],
    typer.Option(
        metavar="KEY=LOW..HIGH",
        help="A quantity of the file that may change, and its bounds. Several at once:"
        " repeat it. KEY,KEY,...=LOW..HIGH changes the others in proportion to the first.",
        show_default=False,
    ),
]
GoalName = Annotated[
    Literal["isotropic_force", "motor"],
    typer.Option(
        help="The most force in every direction, anywhere in the target; or the least torque"
        " that gives target.force there, which sets tension.max and cable_motor.torque_limit."
    ),
]
Seed = Annotated[
    int, typer.Option(metavar="N", min=0, help="The same seed tries the same machines.")
]


def optimise(
    file: MachineFile,
    vary: Vary,
    goal: GoalName = "isotropic_force",
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="The new machine file.  [default: <file>_optimised.toml, in this folder]",
            show_default=False,
        ),
    ] = None,
    search: Annotated[
        Literal["global", "local"],
        typer.Option(help="Look everywhere, or only uphill from the file's own values."),
    ] = "global",
    seed: Seed = 0,
    force: Annotated[bool, typer.Option("--force", help="Replace an existing file.")] = False,
) -> None:
    """Find better values for a machine, and write them to a new file.

    The new file keeps the comments and the layout of the old one. Nothing is written, and the exit
    status is 3, where no machine in the ranges is better.

    \b
    Example:
      turnbuckle optimise machines/yoon2023.toml --goal motor \\
        --vary "cable[1].rail.from[1]=0 mm..300 mm"
    """
    path = out or Path(f"{file.stem}_optimised.toml")
    design = question(file, vary, goal)
    refuse_count(design)
    refuse_existing(path, force)
    found, tried = improved(design, search, seed)
    from turnbuckle.model.files import write_whole

    write_whole(path, found.text)
    show_improvement(design, found)
    typer.echo(f"{path}: written, the best of {tried} machines tried")


def question(file: Path, vary: list[str], goal: str) -> Design:
    """What is asked of which machine."""
    from turnbuckle.model.reading import load_machine

    load_machine(file)  # a mistake is told before the slow imports
    from turnbuckle.lab.design.design import Design

    return Design.read(file, vary, goal)


def refuse_count(design: Design) -> None:
    """A search chooses its own values."""
    for one in design.ranges:
        if one.count:
            fail(f"--vary {one.key}: found a COUNT; allowed: KEY=LOW..HIGH (COUNT is for study)")


def refuse_existing(path: Path, force: bool) -> None:
    """A file that is there is kept, unless the user says otherwise."""
    if path.is_dir() or (path.exists() and not force):
        found = "is a folder" if path.is_dir() else "exists already; replace it with --force"
        fail(f"{path}: {found}, or name another file with --out")


def improved(design: Design, method: str, seed: int) -> tuple[Improvement, int]:
    """A better machine, and how many were tried; ends with a status of its own where none is."""
    from turnbuckle.lab.design.improve import NoImprovement, improvement
    from turnbuckle.lab.design.search import search

    with progress() as tell:
        trials = search(design, method, seed, tell)
    try:
        return improvement(design, trials.best), trials.count
    except NoImprovement as reason:
        fail(f"{reason}; nothing written", NOTHING_BETTER)


def show_improvement(design: Design, found: Improvement) -> None:
    """What changed in the file, and what that did."""
    from turnbuckle.model.problem import key_path

    table = Table(box=None, padding=(0, 2, 0, 0))
    for heading in ("", "before", "after"):
        table.add_column(heading, justify="right" if heading else "left", overflow="fold")
    for location, text in found.changes.items():
        table.add_row(Text(key_path(location)), Text(design.document.words(location)), Text(text))
    before, after = found.before.figures, found.after.figures
    for name, old, new in zip(design.goal.figures, before, after, strict=True):
        table.add_row(Text(name), f"{old:.4g}", f"{new:.4g}", style="bold")
    Console().print(table)


def study(
    file: MachineFile,
    vary: Vary,
    out: Annotated[
        Path,
        typer.Option(
            metavar="DIR",
            help="Folder for the results, new or of the same study.",
            show_default=False,
        ),
    ],
    goal: GoalName = "isotropic_force",
    samples: Annotated[
        int | None,
        typer.Option(
            metavar="N",
            min=1,
            help="Try N machines spread over the ranges.  [default: a grid of KEY=LOW..HIGH:COUNT]",
            show_default=False,
        ),
    ] = None,
    seed: Seed = 0,
    scheduler: Annotated[
        str | None,
        typer.Option(
            metavar="ADDRESS",
            help="A Dask scheduler, such as tcp://192.168.0.7:8786.  [default: this computer]",
            show_default=False,
        ),
    ] = None,
) -> None:
    """Judge many machines, on all cores or on a cluster.

    Writes a line a machine to DIR/results.csv as it is judged, and the best machine to
    DIR/best.toml. Interrupted, it goes on where it was when the same command is run again.

    \b
    Example:
      turnbuckle study machines/yoon2023.toml --out build/study \\
        --vary "tension.max=8 N..11 N:4" --vary "tension.min=1 N..3 N:3"
    """
    design = question(file, vary, goal)
    from turnbuckle.lab.design.results import Results
    from turnbuckle.lab.design.study import plan_study, run_study

    points, plan = plan_study(design, samples, seed)
    with closing(Results(out, design, plan)) as results:
        try:
            with progress() as tell:
                run_study(design, points, results, scheduler, tell)
        except KeyboardInterrupt:
            fail(f"interrupted; {out}: {results.go_on()}", INTERRUPTED)
    conclude_study(design, results)


def conclude_study(design: Design, results: Results) -> None:
    """Say what was found, and write the best machine."""
    from turnbuckle.lab.design.improve import NoImprovement, improvement
    from turnbuckle.model.files import write_whole

    refused = sum(kept.outcome.score is None for kept in results.kept.values())
    typer.echo(f"{results.folder}: {len(results.kept)} machines judged, {refused} cannot be")
    if results.best is None:
        return
    try:
        found = improvement(design, results.best.outcome)
    except NoImprovement as reason:
        typer.echo(str(reason))
        return
    write_whole(results.folder / "best.toml", found.text)
    show_improvement(design, found)
    typer.echo(f"{results.folder / 'best.toml'}: point {results.best.point}")
