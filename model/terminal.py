"""What the commands share: exit statuses, the machine file they take, progress and complaints.

Exit status: 0 done; 1 the check failed; 2 it cannot be done, and the message says why; 3 nothing
better was found; 130 the user stopped it. What a command finds goes to stdout, what it says about
itself to stderr.
"""

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from glob import escape, glob
from pathlib import Path
from typing import Annotated, NoReturn

import typer
from rich.console import Console
from rich.text import Text

FAILED_CHECK, CANNOT, NOTHING_BETTER, INTERRUPTED = 1, 2, 3, 130


def complete_machine(incomplete: str) -> list[str]:
    """What a shell offers for a machine file that is begun so: files, folders, stock machines."""
    from turnbuckle.model.stock import stock_names

    found = sorted(glob(f"{escape(incomplete)}*"))
    folders = [f"{path}/" for path in found if os.path.isdir(path)]
    files = [path for path in found if path.endswith(".toml") and path + "/" not in folders]
    return [*files, *folders, *(name for name in stock_names() if name.startswith(incomplete))]


MachineFile = Annotated[
    Path,
    typer.Argument(
        help="The machine file, or a stock machine's name.",
        show_default=False,
        autocompletion=complete_machine,
    ),
]

Force = Annotated[
    bool, typer.Option("--force", help="Replace the files of another machine in the folder.")
]


def fail(message: str, status: int = CANNOT) -> NoReturn:
    """Say why on stderr, and end."""
    complain(message)
    raise typer.Exit(status)


def complain(message: str) -> None:
    """One message on stderr."""
    typer.echo(f"turnbuckle: {message}", err=True)


@contextmanager
def working(what: str) -> Iterator[None]:
    """A sign of life on a terminal's stderr while something without steps is done."""
    with Console(stderr=True).status(Text(what)):
        yield


@contextmanager
def progress() -> Iterator[Callable[[str, float], None]]:
    """A progress bar on a terminal's stderr; told what is being done and the share that is done."""
    from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

    columns = (
        SpinnerColumn(),
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        TimeElapsedColumn(),
    )
    console = Console(stderr=True)
    with Progress(
        *columns, console=console, transient=True, disable=not console.is_terminal
    ) as bars:
        bar = bars.add_task("starting", total=None)

        def tell(stage: str, share: float) -> None:
            bars.update(bar, description=stage, completed=share, total=1.0 if share else None)

        yield tell
