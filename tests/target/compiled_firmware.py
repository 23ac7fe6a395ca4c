"""Small pieces of firmware for the simulated chip, with register code of their own.

They share nothing with the board's drivers: a model and a driver by one hand only agree with each
other.
"""

import subprocess
import tempfile
from functools import cache
from pathlib import Path

from elftools.elf.elffile import ELFFile
from stm32g474 import Chip, flash

FOLDER = Path(__file__).with_name("own_firmware")
COMPILER = (
    "arm-none-eabi-gcc",
    f"-I{FOLDER}",
    "-std=gnu11",
    "-O2",
    "-Wall",
    "-Wextra",
    "-Werror",
    "-mcpu=cortex-m4",
    "-mthumb",
    "-mfpu=fpv4-sp-d16",
    "-mfloat-abi=hard",
    "-ffreestanding",
    "-fno-move-loop-stores",
)
#: own.h's REPORT.
REPORT = 0x20010000


@cache
def _scratch() -> tempfile.TemporaryDirectory[str]:
    """A folder that lives as long as the tests, with the object of own.c."""
    folder = tempfile.TemporaryDirectory()
    source, compiled = FOLDER / "own.c", Path(folder.name) / "own.o"
    subprocess.run([*COMPILER, "-c", str(source), "-o", str(compiled)], check=True)
    return folder


@cache
def image(body: str, more: str = "") -> bytes:
    """The flash content of a firmware whose function has this body; `more` comes before it."""
    folder = Path(_scratch().name)
    source, elf = folder / "firmware.c", folder / "firmware.elf"
    source.write_text(f'#include "own.h"\n{more}\nvoid firmware(void)\n{{\n{body}\n}}\n')
    link = "-nostdlib", f"-T{FOLDER / 'own.ld'}", str(folder / "own.o"), str(source)
    subprocess.run([*COMPILER, *link, "-o", str(elf)], check=True)
    content = bytearray()
    with elf.open("rb") as stream:
        for segment in ELFFile(stream).iter_segments("PT_LOAD"):
            begin, data = segment["p_paddr"] - flash.BASE, segment.data()
            content[begin : begin + len(data)] = data
    return bytes(content)


def report(chip: Chip, place: int) -> int:
    """What the firmware has written into a word of REPORT."""
    return chip.bus_read(REPORT + 4 * place)
