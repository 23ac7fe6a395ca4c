"""The record of what an image is, which stands in the image itself: runtime/port/image/image.h."""

from __future__ import annotations

import struct
import zlib
from dataclasses import dataclass
from pathlib import Path

from turnbuckle.lab.boards import BoardError
from turnbuckle.lab.boards.elf import flash_content, is_elf, memory_used, place_in_file
from turnbuckle.lab.deploy.identity import MARKED, Identity, identity_from

MARK = b"TBIMAGE\0"
LAYOUT = struct.Struct("<8sIII20s216s")
LENGTH, MEMORY, CRC = 8, 12, 16
"""Places in the record."""
UNSEALED = 0xFFFFFFFF
"""The length before the program has been made an image."""
HEAD = 0x800
"""Bytes from the begin of an image that hold record and identity."""


@dataclass(frozen=True)
class Record:
    """What an image tells of itself."""

    identity: Identity
    board: str
    flags: str
    length: int
    memory: int
    crc: int

    def rows(self) -> dict[str, str]:
        """What it tells beside its identity, by what people call it."""
        return {
            "board": self.board,
            "length": f"{self.length} B",
            "memory": f"{self.memory} B",
            "CRC": f"{self.crc:08x}",
            "flags": self.flags,
        }


def record_in(content: bytes) -> Record | None:
    """The record of an image, of which at least the first HEAD bytes are given; None without."""
    at = content.find(MARK, 0, HEAD)
    marked = MARKED.search(content[:HEAD])
    identity = identity_from(marked[1].decode()) if marked else None
    if at < 0 or identity is None or len(content) < at + LAYOUT.size:
        return None
    _, length, memory, crc, board, flags = LAYOUT.unpack_from(content, at)
    return Record(identity, text_of(board), text_of(flags), length, memory, crc)


def text_of(field: bytes) -> str:
    """A field of text, up to its end."""
    return field.partition(b"\0")[0].decode("ascii", "replace")


def crc_of(content: bytes) -> int:
    """CRC-32 of an image as if the record's own were zero."""
    at = content.find(MARK, 0, HEAD) + CRC
    return zlib.crc32(content[:at] + bytes(4) + content[at + 4 :])


def is_whole(content: bytes) -> bool:
    """Whether an image, with nothing or anything behind it, is as it was built."""
    record = record_in(content)
    if record is None or len(content) < record.length:
        return False
    return crc_of(content[: record.length]) == record.crc


def sealed(program: bytes) -> bytes:
    """A linked program (ELF) with all that its record tells.

    Raises ValueError and struct.error for what is no such program.
    """
    content = bytearray(flash_content(program))
    at = content.find(MARK, 0, HEAD)
    if at < 0:
        raise ValueError("the program has no record at its begin")
    struct.pack_into("<II", content, at + LENGTH, len(content), memory_used(program))
    struct.pack_into("<I", content, at + CRC, crc_of(bytes(content)))
    done = bytearray(program)
    place = place_in_file(program, at) + LENGTH
    done[place : place + 12] = content[at + LENGTH : at + LENGTH + 12]
    return bytes(done)


def content_of(program: bytes) -> bytes:
    """What goes into the flash, of a program as .elf or .bin; empty for a damaged .elf."""
    try:
        return flash_content(program) if is_elf(program) else program
    except (ValueError, struct.error):
        return b""


def is_image(file: Path) -> bool:
    """Whether a file is an image for a board, damaged or not."""
    return MARK in file.read_bytes()


def read_image(file: Path) -> tuple[Record, bytes]:
    """An image's record and what goes into the flash; BoardError for a damaged one or none."""
    content = content_of(file.read_bytes())
    record = record_in(content)
    if record is None:
        found = "a part of an image" if is_image(file) else "a file that is no image"
        raise BoardError(
            f"{file}: found {found}; allowed: what turnbuckle image has written; make it again"
        )
    if record.length == UNSEALED:
        raise BoardError(
            f"{file}: found a program without length and CRC; allowed: what turnbuckle image makes"
            f" of it: turnbuckle image MACHINE --program {file}"
        )
    if len(content) != record.length or not is_whole(content):
        raise BoardError(
            f"{file}: damaged: found {len(content)} bytes with the CRC {crc_of(content):08x};"
            f" allowed: {record.length} bytes with {record.crc:08x}, as it was built; make it"
            " again with turnbuckle image"
        )
    return record, content
