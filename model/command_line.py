"""The command `turnbuckle check`."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.console import Console
from rich.table import Table
from rich.text import Text

from turnbuckle.model.terminal import CANNOT, MachineFile, complain

if TYPE_CHECKING:
    from turnbuckle.model.machine import Machine
    from turnbuckle.model.problem import MachineError


def check(
    file: MachineFile,
    as_json: Annotated[bool, typer.Option("--json", help="Print it all as JSON.")] = False,
) -> None:
    """Say what machine a file describes, or all that is wrong with it.

    Every problem is one line on stderr: file, key, what was found, what is
    allowed. Rules between keys are silent about keys that are wrong already.
    With --json, for editors and CI: file, valid and problems; of a machine
    also name, kind, warnings and a hash of what the file says, however that
    is written (not that of the C, which turnbuckle generate tells).

    \b
    Examples:
      turnbuckle check machines/yoon2023.toml
      turnbuckle check machines/yoon2023.toml --json
    """
    from turnbuckle.model.problem import MachineError
    from turnbuckle.model.reading import load_machine

    try:
        machine = load_machine(file)
    except MachineError as error:
        if as_json:
            typer.echo(json.dumps(_refused(file, error), indent=2))
        else:
            for problem in error.problems:
                complain(f"{file}: {problem}")
        raise typer.Exit(CANNOT) from None
    if as_json:
        typer.echo(json.dumps(_described(file, machine), indent=2))
    else:
        _show(machine)


def _show(machine: Machine) -> None:
    table = Table(show_header=False, box=None, padding=(0, 2, 0, 0))
    for label, value in machine.describe():
        table.add_row(Text(label, style="bold"), Text(value))
    Console().print(table)


def _refused(file: Path, error: MachineError) -> dict[str, Any]:
    problems = [vars(problem) for problem in error.problems]
    return {"file": str(file), "valid": False, "problems": problems}


def _content_sha256(machine: Machine) -> str:
    """Of what the file says, however it is spelled; the machine hash is that of the generated C."""
    content = machine.model_dump(mode="json", by_alias=True)
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def _described(file: Path, machine: Machine) -> dict[str, Any]:
    return {
        "file": str(file),
        "valid": True,
        "problems": [],
        "name": machine.name,
        "kind": machine.kind,
        "content_sha256": _content_sha256(machine),
        "warnings": [{"key": key, "text": text} for key, text in machine.warnings()],
    }
