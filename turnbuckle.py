"""The command line: check a machine file, analyze it, generate its C, verify it, try it.

Every command is in the command_line.py of its subject; here they become one program. The modules
behind a command are imported by that command alone, so that the quick ones are quick.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer
from rich.console import Console
from rich.table import Table
from rich.text import Text

from codegen.command_line import generate, verify
from lab.analysis.command_line import analyze, compare
from lab.command_line import demo
from lab.flight.command_line import log, replay
from lab.live.command_line import monitor, run
from model.bus.command_line import bus
from model.command_line import check
from model.terminal import (
    INTERRUPTED,
    NOTHING_BETTER,
    MachineFile,
    fail,
    progress,
)

if TYPE_CHECKING:
    from lab.design.design import Design
    from lab.design.improve import Improvement
    from lab.design.results import Results
    from model.machine import Machine

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


app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def main() -> None:
    """The installed command `turnbuckle`."""
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
    try:
        app()
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)


def print_version(wanted: bool) -> None:
    """Print the version and stop, where it is wanted."""
    if wanted:
        typer.echo(f"turnbuckle {version('turnbuckle')}")
        raise typer.Exit


@app.callback()
def describe_turnbuckle(
    _version: Annotated[
        bool,
        typer.Option(
            "--version", callback=print_version, is_eager=True, help="Print the version and exit."
        ),
    ] = False,
) -> None:
    """Describe a cable-driven haptic machine in one file; get its controller as C.

    \b
    Example, from nothing to numbers:
      turnbuckle check    machines/yoon2023.toml
      turnbuckle analyze  machines/yoon2023.toml
      turnbuckle generate machines/yoon2023.toml
      turnbuckle verify   machines/yoon2023.toml
      turnbuckle demo     machines/yoon2023.toml

    \b
    Exit status: 0 done, 1 the check failed, 2 it cannot be done (the message
    says why), 3 nothing better was found, 130 interrupted.
    """


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
    from lab.design.files import write_whole

    write_whole(path, found.text)
    show_improvement(design, found)
    typer.echo(f"{path}: written, the best of {tried} machines tried")


def question(file: Path, vary: list[str], goal: str) -> Design:
    """What is asked of which machine."""
    read(file)  # a mistake is told before the slow imports
    from lab.design.design import Design

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
    from lab.design.improve import NoImprovement, improvement
    from lab.design.search import search

    with progress() as tell:
        trials = search(design, method, seed, tell)
    try:
        return improvement(design, trials.best), trials.count
    except NoImprovement as reason:
        fail(f"{reason}; nothing written", NOTHING_BETTER)


def show_improvement(design: Design, found: Improvement) -> None:
    """What changed in the file, and what that did."""
    from model.problem import key_path

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
    from lab.design.results import Results
    from lab.design.study import plan_study, run_study

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
    from lab.design.files import write_whole
    from lab.design.improve import NoImprovement, improvement

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


def read(file: Path) -> Machine:
    """The machine of a file."""
    from model.machine import load_machine

    return load_machine(file)


@contextmanager
def errors_in_words() -> Iterator[None]:
    """Turn what a user can cause into one message on stderr and an exit status."""
    try:
        yield
    except (BrokenPipeError, typer.Exit, typer.BadParameter):
        raise  # typer knows how to end; a broken pipe is a reader that has seen enough
    except KeyboardInterrupt:
        fail("interrupted", INTERRUPTED)
    except OSError as error:
        fail(": ".join(str(part) for part in (error.filename, error.strerror or error) if part))
    except Exception as error:
        if not isinstance(error, refusals()):
            raise
        fail(str(error))


def refusals() -> tuple[type[Exception], ...]:
    """Errors whose text is written for the user; imported only when there has been an error."""
    from codegen.compile import CompileError
    from codegen.folder import FolderError
    from codegen.generate import GenerateError
    from lab.design import DesignError
    from lab.flight import FlightError
    from lab.live import LiveError
    from model.machine import MachineError

    wrong_input = MachineError, DesignError, LiveError, FlightError
    return (*wrong_input, GenerateError, FolderError, CompileError)


COMMANDS: tuple[Callable[..., None], ...] = (
    check,
    generate,
    verify,
    analyze,
    compare,
    demo,
    optimise,
    study,
    bus,
    run,
    monitor,
    replay,
    log,
)
"""In the order of --help."""
for command in COMMANDS:
    app.command()(errors_in_words()(command))

if __name__ == "__main__":
    main()
