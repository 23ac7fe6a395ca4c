"""What of a linked program (ELF of 32 bits, little endian) goes into the flash."""

import struct
from collections.abc import Iterator
from dataclasses import dataclass

MAGIC = b"\x7fELF\x01\x01"
LOADED = 1
"""The type of a segment that has bytes in memory."""
LARGEST = 1 << 24
"""Bytes of an image, from its first to its last."""


@dataclass(frozen=True)
class Segment:
    """Bytes of the file, the address where they are put, and that where the program uses them."""

    offset: int
    address: int
    used: int
    size: int
    memory: int
    """Bytes there, with those that begin as zero or as anything."""

    @property
    def in_memory(self) -> bool:
        """Whether the program uses them in RAM."""
        return self.used != self.address or not self.size


def is_elf(program: bytes) -> bool:
    """Whether a file is an ELF of 32 bits."""
    return program.startswith(MAGIC)


def segments(program: bytes) -> list[Segment]:
    """Those with content, by their load address. ValueError, struct.error for a damaged file."""
    found = sorted((each for each in all_segments(program) if each.size), key=_address)
    if not found or found[-1].address + found[-1].size - found[0].address > LARGEST:
        raise ValueError("no program for a flash")
    return found


def _address(segment: Segment) -> int:
    return segment.address


def all_segments(program: bytes) -> Iterator[Segment]:
    """Those with content and those without; errors like segments."""
    (table,) = struct.unpack_from("<I", program, 28)
    size, count = struct.unpack_from("<HH", program, 42)
    for number in range(count):
        row = struct.unpack_from("<IIIIII", program, table + number * size)
        kind, offset, used, address, in_file, in_memory = row
        if kind == LOADED:
            if offset + in_file > len(program):
                raise ValueError("a segment is not within the file")
            yield Segment(offset, address, used, in_file, in_memory)


def flash_content(program: bytes) -> bytes:
    """The bytes from the lowest address on; what is between segments is as if erased."""
    found = segments(program)
    begin = found[0].address
    content = bytearray()
    for segment in found:
        content = content.ljust(segment.address - begin, b"\xff")
        content += program[segment.offset : segment.offset + segment.size]
    return bytes(content)


def place_in_file(program: bytes, at: int) -> int:
    """Where in the file a byte of flash_content is."""
    found = segments(program)
    address = found[0].address + at
    inside = (each for each in found if each.address <= address < each.address + each.size)
    segment = next(inside)
    return segment.offset + address - segment.address


def memory_used(program: bytes) -> int:
    """Bytes of RAM that the program has been given: variables, and its stack."""
    return sum(each.memory for each in all_segments(program) if each.in_memory)
