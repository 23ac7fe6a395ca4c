"""The command `turnbuckle bus`."""

import json
from typing import Annotated, Literal

import typer
from rich.console import Console
from rich.table import Table
from rich.text import Text

from turnbuckle.model.terminal import MachineFile


def bus(
    file: MachineFile,
    as_json: Annotated[bool, typer.Option("--json", help="Print every message as JSON.")] = False,
) -> None:
    """Prove that every frame on the machine's buses is in time.

    Worst response times (Davis et al. 2007) with every stuff bit, the load of
    each bus, and when in a cycle what has arrived. A file with a bus that is
    too slow is refused by every command, which then says what would fit.

    \b
    Example:
      turnbuckle bus machines/yoon2023.toml
    """
    from turnbuckle.model.bus.report import as_data, table
    from turnbuckle.model.reading import load_machine

    machine = load_machine(file)
    if as_json:
        typer.echo(json.dumps(as_data(machine), indent=2))
    elif machine.buses:
        _show(*table(machine))
    else:
        typer.echo(f"{machine.name}: no buses; the table [[bus]] of a machine file makes one")


def _show(header: list[str], rows: list[list[str]]) -> None:
    shown = Table(box=None, padding=(0, 2, 0, 0))
    for number, heading in enumerate(header):
        justify: Literal["left", "right"] = "right" if number else "left"
        shown.add_column(Text(heading), justify=justify, no_wrap=not number, overflow="fold")
    for row in rows:
        shown.add_row(*map(Text, row), style="bold" if len(row) == 1 else "")
    Console().print(shown)
