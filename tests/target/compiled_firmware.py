"""Small pieces of firmware for the simulated chip, with register code of their own.

They share nothing with the board's drivers: a model and a driver by one hand only agree with each
other.
"""

import subprocess
import tempfile
from functools import cache
from pathlib import Path

from stm32g474 import Chip

FOLDER = Path(__file__).with_name("own_firmware")
FLAGS = (
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
    "-nostdlib",
    "-fno-move-loop-stores",
)
#: own.h's REPORT.
REPORT = 0x20010000


@cache
def image(body: str, more: str = "") -> bytes:
    """The flash content of a firmware whose function has this body; `more` comes before it."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        source, elf, binary = (folder / file for file in ("f.c", "f.elf", "f.bin"))
        source.write_text(f'#include "own.h"\n{more}\nvoid firmware(void)\n{{\n{body}\n}}\n')
        sources = str(FOLDER / "own.c"), str(source)
        places = f"-I{FOLDER}", f"-T{FOLDER / 'own.ld'}"
        command = ["arm-none-eabi-gcc", *FLAGS, *places, *sources, "-lgcc", "-o", str(elf)]
        subprocess.run(command, check=True)
        copy = ["arm-none-eabi-objcopy", "-O", "binary", str(elf), str(binary)]
        subprocess.run(copy, check=True)
        return binary.read_bytes()


def report(chip: Chip, place: int) -> int:
    """What the firmware has written into a word of REPORT."""
    return chip.bus_read(REPORT + 4 * place)
