"""An image for the board stm32g474 that is small in what it does, and a chip at a probe."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

from compiled_firmware import COMPILER, FOLDER
from stm32g474 import Chip
from stm32g474_debug import DebugServer

from turnbuckle.codegen.compile import run
from turnbuckle.lab.boards.record import sealed
from turnbuckle.places import RUNTIME

GENERATED = Path(__file__).parents[2] / "generated"
CORE, IMAGE = RUNTIME / "core", RUNTIME / "port" / "image"
MARK_OF_A_DAMAGED_IMAGE = 0xBADC0DE
FLAGS = "-O2 -mcpu=cortex-m4"


@cache
def linked(
    folder: Path, machine: str = "yoon2023", board: str = "stm32g474", weight: int = 44_000
) -> Path:
    """A program (ELF) of a stock machine that carries so many bytes more than it needs."""
    product = folder / f"{machine}-{board}-{weight}.elf"
    sources = [FOLDER / "flashed.c", IMAGE / "image.c", CORE / "identity.c"]
    include = [IMAGE, CORE, GENERATED / machine]
    defines = [f'-DTB_BOARD_NAME="{board}"', f'-DTB_BUILD_FLAGS="{FLAGS}"', f"-DWEIGHT={weight}"]
    options = [*COMPILER[1:], "-DTB_REAL_FLOAT", "-fdata-sections", "-nostdlib", *defines]
    words = [*options, *(f"-I{each}" for each in include), *map(str, sources)]
    run(COMPILER[0], [*words, f"-T{FOLDER / 'flashed.ld'}"], product)
    return product


@cache
def image(folder: Path, **what: Any) -> Path:
    """The same as an image, with its length and its CRC."""
    program = linked(folder, **what)
    product = program.with_suffix(".image.elf")
    product.write_bytes(sealed(program.read_bytes()))
    return product


@contextmanager
def at_a_probe(
    chip: Chip, folder: Path, cut: Callable[[Chip], bool] = lambda chip: False, **more: bool
) -> Iterator[tuple[DebugServer, Path]]:
    """A chip at a probe, and the file that tells OpenOCD of the probe."""
    with DebugServer(chip, folder, cut=cut, **more) as server:
        file = folder / "simulated.cfg"
        file.write_text(
            f"adapter driver remote_bitbang\nremote_bitbang host {server.place}\n"
            "remote_bitbang port 0\nreset_config none\n"
        )
        yield server, file
