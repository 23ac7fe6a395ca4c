"""The command line: check a machine file, analyze it, generate its C, verify it, try it.

Every command is in the command_line.py of its subject; here they become one program. The modules
behind a command are imported by that command alone, so that the quick ones are quick.
"""

import errno
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Annotated

import typer

from turnbuckle.codegen.command_line import generate, verify
from turnbuckle.codegen.project.command_line import new, runtime
from turnbuckle.extras import extra_of
from turnbuckle.lab.analysis.command_line import analyze, compare
from turnbuckle.lab.boards.command_line import flash, image
from turnbuckle.lab.command_line import demo
from turnbuckle.lab.deploy.command_line import deploy, info, rollback
from turnbuckle.lab.design.command_line import optimise, study
from turnbuckle.lab.flight.command_line import log, replay
from turnbuckle.lab.live.command_line import monitor, run
from turnbuckle.model.bus.command_line import bus
from turnbuckle.model.command_line import check
from turnbuckle.model.refusal import Refusal
from turnbuckle.model.terminal import CANNOT, INTERRUPTED, complain, fail
from turnbuckle.version import VERSION

app = typer.Typer(
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
    except OSError as error:  # of --help and --version, which are no commands
        complain(in_words(error))
        sys.exit(CANNOT)


def in_words(error: OSError) -> str:
    """What is wrong with which file: a full one without a name is the standard output."""
    full = error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
    name = error.filename or ("standard output" if full else None)
    return ": ".join(str(part) for part in (name, error.strerror or error) if part)


def print_version(wanted: bool) -> None:
    """Print the version and stop, where it is wanted."""
    if wanted:
        typer.echo(f"turnbuckle {VERSION}")
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


@contextmanager
def errors_in_words(command: str) -> Iterator[None]:
    """Turn what a user of a command can cause into one message on stderr and an exit status."""
    try:
        yield
    except (BrokenPipeError, typer.Exit, typer.BadParameter):
        raise  # typer knows how to end; a broken pipe is a reader that has seen enough
    except KeyboardInterrupt:
        fail("interrupted", INTERRUPTED)
    except OSError as error:
        fail(in_words(error))
    except Refusal as refusal:
        fail(str(refusal))
    except ModuleNotFoundError as error:
        if (extra := extra_of(error.name or "")) is None:
            raise
        fail(
            f"{command} needs {error.name}, which is not installed;"
            f" install it with pip install 'turnbuckle[{extra}]'"
        )


COMMANDS: tuple[Callable[..., None], ...] = (
    check,
    new,
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
    deploy,
    rollback,
    image,
    flash,
    info,
    runtime,
)
"""In the order of --help."""
for command in COMMANDS:
    app.command()(errors_in_words(command.__name__)(command))

if __name__ == "__main__":
    main()
