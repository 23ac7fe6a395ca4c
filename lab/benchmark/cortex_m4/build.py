"""Links C to a program for the emulated Cortex-M4F."""

from collections.abc import Sequence
from pathlib import Path

from turnbuckle.lab.benchmark.cortex_m4.emulator import FLASH, RAM
from turnbuckle.lab.benchmark.native import BUILD, run_tool

#: The same for ours and for all peers.
FLAGS = (
    "-O2",
    "-mcpu=cortex-m4",
    "-mthumb",
    "-mfpu=fpv4-sp-d16",
    "-mfloat-abi=hard",
    "-fno-math-errno",
    "-ffp-contract=off",
    "-fno-move-loop-stores",
)
#: Freestanding: no start-up code, C library only for what the mathematics calls.
LINK = ("--specs=nosys.specs", "-nostartfiles", f"-Wl,-Ttext={FLASH:#x},-Tdata={RAM:#x},-e,0")


def program(name: str, sources: Sequence[Path], flags: Sequence[str]) -> Path:
    """Compile and link sources to <name>.elf of this run."""
    target = BUILD / "cortex_m4" / f"{name}.elf"
    target.parent.mkdir(parents=True, exist_ok=True)
    files = [str(source) for source in sources]
    run_tool(["arm-none-eabi-gcc", *FLAGS, *flags, *files, *LINK, "-lm", "-o", str(target)])
    return target
