"""The commands `new` and `runtime`: what they take, what they print."""

from pathlib import Path
from typing import Annotated

import typer

from turnbuckle.model.terminal import complete_machine

Name = Annotated[
    str, typer.Argument(help="Name of the folder and of the machine.", show_default=False)
]


def new(
    name: Name,
    source: Annotated[
        str,
        typer.Option(
            "--from",
            metavar="FILE",
            help="The machine to begin with: a file, or a stock machine's name.",
            autocompletion=complete_machine,
        ),
    ] = "yoon2023",
) -> None:
    """Make a folder for a machine of your own.

    It holds the machine file, a Makefile with `make` and `make test`, the C
    runtime, applications in C, C++ and Python that feel a virtual wall, and a
    workflow for continuous integration. All of it is yours to change.

    \b
    Example:
      turnbuckle new my_arm --from spidar_g
    """
    from turnbuckle.codegen.project.project import new_project

    folder = new_project(name, source)
    typer.echo(f"{folder}: a new machine, like {source}; next: cd {folder} && make && make test")


def runtime(
    out: Annotated[
        Path,
        typer.Option(
            metavar="DIR",
            help="Folder for the C files, new or of this command before.",
            show_default=False,
        ),
    ],
) -> None:
    """Copy the C runtime to a folder.

    For programs that are built without Turnbuckle; its manifest.json says of
    which version the copy is.

    \b
    Example:
      turnbuckle runtime --out firmware/runtime
    """
    from turnbuckle.codegen.project.runtime import write_runtime

    typer.echo(f"{out}: {write_runtime(out)} files written")
