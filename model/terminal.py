"""What the commands share: exit statuses, the machine file they take, progress and complaints.

Exit status: 0 done; 1 the check failed; 2 it cannot be done, and the message says why; 3 nothing
better was found; 130 the user stopped it. What a command finds goes to stdout, what it says about
itself to stderr.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, NoReturn

import typer
from rich.console import Console
from rich.text import Text

FAILED_CHECK, CANNOT, NOTHING_BETTER, INTERRUPTED = 1, 2, 3, 130

MachineFile = Annotated[Path, typer.Argument(help="The machine file.", show_default=False)]

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
