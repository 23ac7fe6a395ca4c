"""The commands `replay` and `log`: what they take, what they print."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from turnbuckle.model.terminal import FAILED_CHECK, complain, complete_machine

if TYPE_CHECKING:
    from turnbuckle.lab.flight.recording import Recording

Dump = Annotated[Path, typer.Argument(help="What the flight recorder wrote.", show_default=False)]
OfMachine = Annotated[
    Path | None,
    typer.Argument(
        metavar="[FILE]",
        help="The machine file.  [default: machines/<name>.toml]",
        show_default=False,
        autocompletion=complete_machine,
    ),
]


def replay(dump: Dump, file: OfMachine = None) -> None:
    """Run a flight recording again, compare it to the bit.

    Compiles the C of the machine file. A segment that was cut off cannot be
    checked, and is not run. Exit status 1 if an order differs from
    the recorded one: then the program was not made from this C, or its
    processor or its memory was at fault.

    \b
    Example:
      turnbuckle replay flight.dump machines/yoon2023.toml
    """
    from turnbuckle.lab.flight.recording import read_recording
    from turnbuckle.lab.flight.replay import replay as run_again

    recording = read_recording(dump, file)
    found = run_again(recording)
    warn_of_flaws(recording)
    total, segments = len(recording.numbers), len(recording.segments)
    typer.echo(
        f"{dump}: {recording.machine.name}, machine hash {recording.hash}, {recording.precision}:"
        f" {total} cycles in {segments} segments"
    )
    if found.difference is None:
        all_of_them = f"all {total}" if found.matched == total else f"{found.matched} of {total}"
        typer.echo(f"{all_of_them} cycles ordered the same again, to the bit")
    else:
        typer.echo(f"{found.matched} cycles ordered the same; then {found.difference}")
        raise typer.Exit(FAILED_CHECK)


def log(
    dump: Dump,
    out: Annotated[
        Path,
        typer.Option(
            metavar="FILE", help="The table: FILE.csv or FILE.parquet.", show_default=False
        ),
    ],
    file: OfMachine = None,
    plot: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="A picture of it as PNG.", show_default=False),
    ] = None,
) -> None:
    """Turn a flight recording into a table, and a picture.

    A row for every control cycle; the names of the columns end in their unit.
    Of a recording that was cut off or damaged the whole cycles are taken.

    \b
    Example:
      turnbuckle log flight.dump --out flight.parquet --plot flight.png
    """
    from turnbuckle.lab.flight.recording import read_recording
    from turnbuckle.lab.flight.table import refuse_foreign_table, write_table
    from turnbuckle.lab.pictures import refuse_foreign_picture

    refuse_foreign_table(out)
    if plot is not None:
        refuse_foreign_picture(plot)
    if plot is not None:
        from turnbuckle.lab.flight.picture import draw
    recording = read_recording(dump, file)
    warn_of_flaws(recording)
    write_table(recording, out)
    typer.echo(f"{out}: {len(recording.numbers)} cycles")
    if plot is not None:
        draw(recording, plot)
        typer.echo(f"picture: {plot}")


def warn_of_flaws(recording: Recording) -> None:
    """Say what is not in a recording."""
    if recording.flaws:
        complain(f"warning: {recording.path}: {'; '.join(recording.flaws)}")
