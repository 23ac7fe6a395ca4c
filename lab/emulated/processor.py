"""The emulated processors, and how C is compiled for them."""

from dataclasses import dataclass
from pathlib import Path

from turnbuckle.codegen.compile import PRECISIONS

FIRMWARE = Path(__file__).parent / "firmware"
COMPILER = "arm-none-eabi-gcc"
FLAGS = (
    "-std=c11",
    "-O2",
    "-ffp-contract=off",
    "-fno-math-errno",
    "-fno-trapping-math",
    "-fno-thread-jumps",
    "-fno-tree-vectorize",
    "-fno-tree-slp-vectorize",
    "-fno-move-loop-stores",
    "-ffunction-sections",
    "-fdata-sections",
)
"""As the Makefile compiles for a microcontroller; the linker leaves out what nothing calls."""
LINK = ("--specs=nosys.specs", "-nostartfiles", "-Wl,--gc-sections,--fatal-warnings")


@dataclass(frozen=True)
class Processor:
    """A Cortex-M with a floating-point unit."""

    name: str
    board: str
    """The machine of QEMU that has it."""
    part: int
    """PARTNO of the CPUID register."""
    precision: str
    """Of the unit's arithmetic: what the machine's C is compiled for."""
    options: tuple[str, ...]
    """Of the compiler, for this processor alone."""

    @property
    def flags(self) -> list[str]:
        """What C is compiled with for it."""
        cpu = ("-mthumb", "-mfloat-abi=hard", *self.options)
        return [*FLAGS, *cpu, *PRECISIONS[self.precision]]


M4F = Processor(
    "Cortex-M4F", "mps2-an386", 0xC24, "float", ("-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16")
)
M7 = Processor("Cortex-M7", "mps2-an500", 0xC27, "double", ("-mcpu=cortex-m7", "-mfpu=fpv5-d16"))
