"""The command `turnbuckle demo`."""

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from turnbuckle.model.terminal import MachineFile, progress


def demo(
    file: MachineFile,
    out: Annotated[
        Path, typer.Option(metavar="DIR", help="Folder for the picture.", show_default=True)
    ] = Path("build/demo"),
) -> None:
    """Run the compiled controller on the virtual bench.

    Prints a table of numbers and draws a picture.

    \b
    Example:
      turnbuckle demo machines/yoon2023.toml --out pictures
    """
    from turnbuckle.model.reading import load_machine

    load_machine(file)  # a mistake is told before the slow imports
    from turnbuckle.lab.demo import run_demo, summary_table

    with progress() as tell:
        result = run_demo(file, out, tell)
    Console().print(summary_table(result))
    typer.echo(f"picture: {result.picture}")
