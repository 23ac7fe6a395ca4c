"""The commands `deploy`, `rollback` and `info`: what they take, what they print."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Annotated, Literal

import typer

from turnbuckle.model.terminal import MachineFile, complain

HostName = Annotated[
    str,
    typer.Argument(
        metavar="HOST", help="The computer, as ssh takes it: pi@192.168.0.7.", show_default=False
    ),
]
Folder = Annotated[
    str | None,
    typer.Option(
        metavar="DIR",
        help="Folder there, for the machine's own folder.  [default: turnbuckle, in your home"
        " folder; with --unit /opt/turnbuckle]",
        show_default=False,
    ),
]
Ssh = Annotated[
    str, typer.Option(metavar="COMMAND", help="ssh with its options, such as 'ssh -p 2222'.")
]


def deploy(
    file: MachineFile,
    host: HostName,
    arch: Annotated[
        Literal["x86-64", "aarch64", "armv7", "riscv64"] | None,
        typer.Option(
            help="Processor that the host must have.  [default: what it has]", show_default=False
        ),
    ] = None,
    folder: Folder = None,
    unit: Annotated[
        bool, typer.Option("--unit", help="Install the systemd unit too, which starts the program.")
    ] = False,
    precision: Annotated[
        Literal["double", "float"], typer.Option(help="Of the program.")
    ] = "double",
    ssh: Ssh = "ssh",
) -> None:
    """Bring a machine's program to another computer.

    Asks the host by ssh what it is, compiles the program for it, copies it,
    checks there what arrived and that it starts, and switches to it at once;
    the program before is kept, for the command rollback. A program that runs
    goes on until it is started again. Where anything fails, the host stays
    as it was. Needs a key: nobody is asked for a password.

    \b
    Example:
      turnbuckle deploy machines/yoon2023.toml pi@192.168.0.7
      turnbuckle deploy yoon2023 pi --unit --ssh 'ssh -p 2222'
    """
    from turnbuckle.lab.deploy.deploy import HOME_FOLDER, UNIT_FOLDER, install_unit
    from turnbuckle.lab.deploy.deploy import deploy as bring
    from turnbuckle.lab.deploy.host import Host
    from turnbuckle.lab.deploy.report import changes, next_steps, stranger
    from turnbuckle.model.reading import load_machine

    refuse_unit_elsewhere(unit, folder)
    machine, there = load_machine(file), Host(host, ssh)
    place = folder or (UNIT_FOLDER if unit else HOME_FOLDER)
    switched = bring(machine, there, place, arch, precision, typer.echo)
    if warning := stranger(machine, there, switched):
        complain(warning)
    typer.echo("\n".join([f"{host}: {switched.place}", *changes(switched)]))
    answer = install_unit(machine, there) if unit else None
    typer.echo("\n".join(next_steps(machine, there, switched, answer)))


def refuse_unit_elsewhere(unit: bool, folder: str | None) -> None:
    """The unit starts programs of one folder alone."""
    from turnbuckle.lab.deploy.deploy import UNIT_FOLDER

    if unit and folder not in (None, UNIT_FOLDER):
        raise typer.BadParameter(
            f"--unit: the unit starts programs of {UNIT_FOLDER}; leave --folder out"
        )


def rollback(
    file: MachineFile,
    host: HostName,
    folder: Folder = None,
    unit: Annotated[
        bool, typer.Option("--unit", help="The program that the systemd unit starts.")
    ] = False,
    ssh: Ssh = "ssh",
) -> None:
    """Switch another computer back to the program before.

    That of before the last deploy, at once, without building anything; once
    more switches forward again.
    A program that runs goes on until it is started again.

    \b
    Example:
      turnbuckle rollback machines/yoon2023.toml pi@192.168.0.7
    """
    from turnbuckle.lab.deploy.deploy import HOME_FOLDER, UNIT_FOLDER, roll_back
    from turnbuckle.lab.deploy.host import Host
    from turnbuckle.lab.deploy.report import changes
    from turnbuckle.model.reading import load_machine

    machine, there = load_machine(file), Host(host, ssh)
    place = folder or (UNIT_FOLDER if unit else HOME_FOLDER)
    switched = roll_back(machine, there, place)
    typer.echo("\n".join([f"{host}: {switched.place}", *changes(switched)]))
    typer.echo("a program that runs there goes on as it is until it is started again")


def info(
    program: Annotated[
        Path, typer.Argument(metavar="PROGRAM", help="The file.", show_default=False)
    ],
) -> None:
    """Say what a program is, of any processor, without running it.

    Tells its machine and the hash of that, which turnbuckle generate tells
    too, its precision, version and processor, and the sha256 of the file. Of
    an image for a board, also the board, what its C was compiled with, its
    length, and the CRC that the board checks; a damaged one is refused.

    \b
    Example:
      turnbuckle info build/yoon2023/turnbuckle
    """
    from turnbuckle.lab.boards.record import is_image, read_image
    from turnbuckle.lab.deploy.identity import carried_identity

    if is_image(program):
        record, _ = read_image(program)
        rows = {**vars(record.identity), **record.rows()}
    else:
        rows = {**vars(carried_identity(program))}
    rows["sha256"] = hashlib.sha256(program.read_bytes()).hexdigest()
    typer.echo("\n".join(f"{key:<11}{value}" for key, value in rows.items()))
