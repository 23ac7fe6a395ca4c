"""Links programs for emulated processors; made before from the same C, they are not made again."""

from collections.abc import Sequence
from pathlib import Path

from turnbuckle.codegen.compile import LIBRARIES, key, run
from turnbuckle.lab.emulated.processor import COMPILER, FIRMWARE, LINK, Processor
from turnbuckle.lab.lockstep import CAN, FOLDERS, PORTABLE_CAN, SHIM

RECORDER = ("-DTB_SEGMENT_CYCLES=16u", "-DTB_RECORDER_SEGMENTS=3u")
"""A flight recorder that has room in a microcontroller."""
STARTING = ("start.c", "semihosting.c")


def linked(
    processor: Processor,
    sources: Sequence[Path],
    include: Sequence[Path],
    flags: Sequence[str],
    script: Path,
) -> Path:
    """A program; CompileError with the compiler's words where there is none."""
    options = [*processor.flags, *RECORDER, *flags]
    read = [*sources, SHIM, script]  # the lockstep's program includes the shim
    name = key(read, include, [COMPILER, *options, *LINK])
    product = LIBRARIES.parent / "images" / f"{name}.elf"
    if not product.exists():
        product.parent.mkdir(parents=True, exist_ok=True)
        arguments = [*options, *(f"-I{folder}" for folder in include), *map(str, sources)]
        run(COMPILER, [*arguments, *LINK, f"-T{script}", "-lm"], product)
    return product


def lockstep_image(
    processor: Processor,
    generated: Path,
    flags: Sequence[str] = (),
    folders: Sequence[Path] = FOLDERS,
) -> Path:
    """The runtime of a machine, for a Target to run. folders: of its core and canopen."""
    sources = [path for folder in folders for path in sorted(folder.glob("*.c"))]
    sources += [*sorted(generated.glob("*.c")), *PORTABLE_CAN]
    sources += [FIRMWARE / name for name in (*STARTING, "lockstep.c")]
    include = [generated, *folders, CAN, FIRMWARE, SHIM.parent]
    return linked(processor, sources, include, flags, FIRMWARE / "mps2.ld")
