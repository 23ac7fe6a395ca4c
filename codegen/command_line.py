"""The commands `generate` and `verify`: what they take, what they print."""

from __future__ import annotations

import json
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console

from turnbuckle.model.terminal import (
    FAILED_CHECK,
    Force,
    MachineFile,
    complain,
    fail,
    progress,
    working,
)

if TYPE_CHECKING:
    from turnbuckle.codegen.verify import Report
    from turnbuckle.model.machine import Machine


def generate(
    file: MachineFile,
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help="Folder for the C files, new or generated before.  [default: generated/<name>,"
            " or generated/<prefix>_<name>]",
            show_default=False,
        ),
    ] = None,
    prefix: Annotated[
        str | None,
        typer.Option(
            metavar="WORD",
            help="Begin every name with it, not with tb, and add the runtime: for several machines"
            " in one program.",
            show_default=False,
        ),
    ] = None,
    strict: Annotated[
        bool,
        typer.Option("--strict", help="Write nothing if the target's force is not to be had."),
    ] = False,
    force: Force = False,
) -> None:
    """Write the C of a machine.

    Files are left alone when nothing changed. Measuring
    the accuracy of a function takes a while, the first time; it is kept in
    accuracy.json beside the C.

    Warns where the cables cannot give the wanted force (and moment) in all of
    the target, judged on a coarse grid; with --strict that is a failure, with
    exit status 1. The command analyze looks more closely.

    \b
    Example:
      turnbuckle generate machines/yoon2023.toml --out firmware/controller
      turnbuckle generate machines/yoon2023.toml --prefix left
    """
    begin = time.perf_counter()
    from turnbuckle.codegen.generate import folder_name
    from turnbuckle.codegen.prefix import PLAIN, refuse_prefix
    from turnbuckle.model.reading import load_machine

    if prefix is not None:
        refuse_prefix(prefix)
    machine = load_machine(file)
    folder = out or Path("generated") / folder_name(machine, prefix or PLAIN)
    warn_of_weakness(machine, strict)
    with working(f"generating {machine.name}"):
        files, changed = write_changed(machine, folder, prefix or PLAIN, force)
    say_what_was_generated(machine, folder, files, changed, time.perf_counter() - begin)


def warn_of_weakness(machine: Machine, strict: bool) -> None:
    """Say so where the target does not get what it wants, and end if the user is strict."""
    from turnbuckle.model.workspace.summary import coarse_grid, coverage
    from turnbuckle.model.workspace.words import coverage_in_words

    found = coverage(machine, coarse_grid(machine))
    if found.complete:
        return
    message = f"{machine.path}: the cables give {coverage_in_words(machine, found)}"
    if strict:
        fail(f"{message}; nothing was written", FAILED_CHECK)
    complain(f"warning: {message}")


def write_changed(
    machine: Machine, folder: Path, prefix: str, force: bool
) -> tuple[dict[str, str], bool]:
    """The generated files of a machine, and whether the folder had to be written."""
    from turnbuckle.codegen.folder import refuse_foreign
    from turnbuckle.codegen.generate import MANIFEST, generate, write

    refuse_foreign(folder, MANIFEST, [machine.name], force)  # before the long work
    files = generate(machine, prefix, folder)
    changed = any(content_of(folder / name) != text.encode() for name, text in files.items())
    if changed:
        write(files, folder, force)
    return files, changed


def content_of(path: Path) -> bytes | None:
    """The bytes of a file, None where there is no such file."""
    try:
        return path.read_bytes()
    except FileNotFoundError:
        return None


def say_what_was_generated(
    machine: Machine, folder: Path, files: dict[str, str], changed: bool, seconds: float
) -> None:
    """One line of numbers, and every file with its size."""
    from turnbuckle.codegen.generate import MANIFEST

    manifest = json.loads(files[MANIFEST])
    functions = len(manifest["functions"]) + len(manifest["aliases"])
    if not changed:
        typer.echo(f"{folder}: nothing changed, files left alone")
    else:
        typer.echo(f"{folder}: {len(files)} files written")
        for name, text in files.items():
            typer.echo(f"  {name:<16} {len(text.encode()):>7} bytes")
    typer.echo(
        f"{machine.name}: machine hash {manifest['hash']}, {functions} functions, {seconds:.1f} s"
    )


def verify(
    file: MachineFile,
    points: Annotated[
        int | None,
        typer.Option(
            metavar="N", min=1, help="Points tried for each function.", show_default=False
        ),
    ] = None,
    folder: Annotated[
        Path | None,
        typer.Option(
            "--in",
            metavar="DIR",
            help="The folder with the C.  [default: the C is generated again, and left nowhere]",
            show_default=False,
        ),
    ] = None,
    built: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help="Judge what `make build` made of that C: DIR holds double/libturnbuckle.a and"
            " float/libturnbuckle.a.",
            show_default=False,
        ),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the report as JSON.")] = False,
) -> None:
    """Compare the C with the independent reference.

    Compiles the C in double and single precision, and runs both and the reference on the same
    points. Fails, with exit status 1, where they differ by more than the accuracy that is allowed.

    \b
    Example:
      turnbuckle verify machines/yoon2023.toml --points 500 --json > report.json
    """
    from turnbuckle.model.reading import load_machine

    load_machine(file)  # a mistake is told before the slow imports
    if built and not folder:
        fail("--built: needs --in, the folder of the C that was built")
    report = judged(file, points, folder, built)
    show_report(report, as_json)
    if not report.passed:
        fail(f"{file}: the generated C is not what the reference computes", FAILED_CHECK)


def judged(file: Path, points: int | None, folder: Path | None, built: Path | None) -> Report:
    """Every generated function against the reference."""
    from turnbuckle.codegen.verify import POINTS, verify

    with progress() as tell:
        return verify(
            file,
            points or POINTS,
            progress=lambda function, done, total: tell(f"verifying {function}", done / total),
            folder=folder,
            built=built,
        )


def show_report(report: Report, as_json: bool) -> None:
    """The table of worst errors, then what disagrees; or all of it as JSON."""
    from turnbuckle.codegen.verify_report import failure, json_text, table, verdict

    if as_json:
        typer.echo(json_text(report))
        return
    Console().print(table(report))
    for row in report.failures():
        typer.echo(failure(row))
    typer.echo(verdict(report))
