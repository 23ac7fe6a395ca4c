"""Makes an image of a linked program, and refuses one of another machine or board."""

import struct
from pathlib import Path

from turnbuckle.lab.boards import BoardError
from turnbuckle.lab.boards.chip import Chip
from turnbuckle.lab.boards.elf import flash_content
from turnbuckle.lab.boards.fit import refuse_unfit
from turnbuckle.lab.boards.record import Record, record_in, sealed
from turnbuckle.lab.live.identity import hash_of
from turnbuckle.model.files import write_whole
from turnbuckle.model.machine import Machine

SUFFIXES = (".elf", ".bin")


def image_of(machine: Machine, chip: Chip, program: Path) -> bytes:
    """The image (ELF) of a program that was linked for a board, with its length and CRC.

    Raises BoardError for what is no such program of this machine, or does not fit.
    """
    linked = program.read_bytes()
    try:
        done = sealed(linked)
        content = flash_content(done)
        record = record_in(content)
        if record is None:
            raise ValueError
    except (ValueError, struct.error):
        raise BoardError(
            f"{program}: found no program with a record at its begin; allowed: an ELF of 32 bits"
            " with runtime/port/image/image.c and runtime/core/identity.c, which the linker script"
            " puts behind the vectors: docs/flashing.md"
        ) from None
    refuse_other(program, record, machine, chip)
    refuse_unfit(machine, chip, record)
    return done


def write_image(image: bytes, file: Path) -> None:
    """Write it whole or not at all, as the file's name ends; BoardError for another ending."""
    if file.suffix not in SUFFIXES:
        raise BoardError(
            f'--out: found "{file}"; allowed: a name that ends in {" or ".join(SUFFIXES)}'
        )
    write_whole(file, image if file.suffix == ".elf" else flash_content(image))


def refuse_other(file: Path, record: Record, machine: Machine, chip: Chip) -> None:
    """BoardError for an image of another board, or of another machine than the file's."""
    if record.board != chip.name:
        raise BoardError(
            f"{file}: found an image for the board {record.board}; allowed: {chip.name};"
            f" nothing was changed; build it for {chip.name}, or name the other one with --board"
        )
    wanted = f"{machine.name} {hash_of(machine)}"
    found = f"{record.identity.machine} {record.identity.hash}"
    if found != wanted:
        raise BoardError(
            f"{file}: found an image of {found}; allowed: {wanted}, the hash of {machine.path};"
            " nothing was changed; generate and build it again, or name its own machine file"
        )
