"""The command `turnbuckle check`."""

from rich.console import Console
from rich.table import Table
from rich.text import Text

from turnbuckle.model.terminal import MachineFile


def check(file: MachineFile) -> None:
    """Say what machine a file describes, or what is wrong.

    \b
    Example:
      turnbuckle check machines/yoon2023.toml
    """
    from turnbuckle.model.machine import load_machine

    table = Table(show_header=False, box=None, padding=(0, 2, 0, 0))
    for label, value in load_machine(file).describe():
        table.add_row(Text(label, style="bold"), Text(value))
    Console().print(table)
