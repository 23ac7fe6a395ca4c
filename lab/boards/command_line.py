"""The commands `image` and `flash`: what they take, what they print."""

from __future__ import annotations

import shlex
from pathlib import Path
from typing import Annotated, Literal

import typer

from turnbuckle.model.terminal import MachineFile

BoardName = Annotated[Literal["stm32g474"], typer.Option(help="The board.")]


def image(
    file: MachineFile,
    program: Annotated[
        Path,
        typer.Option(metavar="ELF", help="The program that you have linked.", show_default=False),
    ],
    board: BoardName = "stm32g474",
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="Image to write, .elf or .bin.  [default: build/MACHINE/BOARD.elf]",
            show_default=False,
        ),
    ] = None,
) -> None:
    """Make an image for a board of the program that you have linked.

    Puts its length and its CRC into the record that it carries, which the
    board checks before it does anything else. Refuses a program of another
    machine or board, and one that does not fit. The file is written whole or
    not at all.

    \b
    Example:
      turnbuckle image machines/yoon2023.toml --program board.elf
    """
    from turnbuckle.lab.boards.chip import CHIPS
    from turnbuckle.lab.boards.image import image_of, write_image
    from turnbuckle.lab.boards.record import read_image
    from turnbuckle.model.reading import load_machine

    machine = load_machine(file)
    place = out or Path("build") / machine.name / f"{board}.elf"
    write_image(image_of(machine, CHIPS[board], program), place)
    record, _ = read_image(place)
    rows = {"image": str(place), "identity": str(record.identity), **record.rows()}
    typer.echo("\n".join(f"{key:<10}{value}" for key, value in rows.items()))


def flash(
    file: MachineFile,
    image: Annotated[
        Path,
        typer.Option(
            metavar="IMAGE", help="What turnbuckle image has written.", show_default=False
        ),
    ],
    board: BoardName = "stm32g474",
    probe: Annotated[
        str,
        typer.Option(
            metavar="PROBE",
            help="stlink, cmsis-dap, jlink, or a .cfg of OpenOCD for another one.",
        ),
    ] = "stlink",
) -> None:
    """Write a machine's image into a board's flash, and start it.

    By OpenOCD and a debug probe: sees that it is the right chip, erases,
    writes, verifies what was written, and starts it. The motors have to be
    without power: the program that runs in the board is stopped at once. What
    fails is told, with what the chip holds then.

    \b
    Example:
      turnbuckle flash machines/yoon2023.toml --image build/yoon2023/stm32g474.elf
      turnbuckle flash yoon2023 --image board.bin --probe jlink
    """
    from turnbuckle.lab.boards.chip import CHIPS
    from turnbuckle.lab.boards.fit import refuse_unfit
    from turnbuckle.lab.boards.flash import flash as write
    from turnbuckle.lab.boards.image import refuse_other
    from turnbuckle.lab.boards.record import read_image
    from turnbuckle.lab.boards.session import Session
    from turnbuckle.model.reading import load_machine

    machine = load_machine(file)
    record, content = read_image(image)
    refuse_other(image, record, machine, CHIPS[board])
    refuse_unfit(machine, CHIPS[board], record)
    words = ["turnbuckle", "flash", str(file), f"--image={image}", f"--board={board}"]
    again = shlex.join([*words, f"--probe={probe}"])
    done = write(content, record, Session(CHIPS[board], probe), probe, again)
    typer.echo(f"before    {done.before}")
    typer.echo(f"now       {done.now.identity}, {done.now.board}, CRC {done.now.crc:08x}")
    typer.echo(f"{board}: written, verified and started")
