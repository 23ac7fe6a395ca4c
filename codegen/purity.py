"""Whether C is fit for a small machine: what its compiled objects ask for, define and keep.

The single-precision build for a Cortex-M4F must not compute in double (the core has no unit for it,
and a call costs fifty cycles), nor call the mathematical library, nor use a heap, nor export names
that may clash, nor keep state.
"""

import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

CROSS_COMPILER, CROSS_NM = "arm-none-eabi-gcc", "arm-none-eabi-nm"
CORTEX_M4F = (
    "-O2",
    "-mcpu=cortex-m4",
    "-mthumb",
    "-mfpu=fpv4-sp-d16",
    "-mfloat-abi=hard",
    "-fno-math-errno",
    "-ffp-contract=off",
    "-DTB_REAL_FLOAT",
)
PREFIX = "tb_"
#: What a compiler makes of copying or clearing a struct; every C library for a target has them.
COMPILER_MADE = frozenset({"memcpy", "memmove", "memset"})
HEAP = frozenset({"malloc", "calloc", "realloc", "free", "_sbrk", "_malloc_r", "_free_r"})
#: Kinds of symbols that are variables: initialised, zeroed, common.
STATE = frozenset("DdBbCc")


class PurityError(Exception):
    """The C does not compile for the target; the text holds what the compiler said."""


@dataclass(frozen=True)
class Finding:
    """One thing that has no place in an object file."""

    source: str
    symbol: str
    why: str

    def __str__(self) -> str:
        return f"{self.source}: {self.symbol}: {self.why}"


def impurities(
    sources: Sequence[Path], include: Sequence[Path], standard: str = "c99"
) -> list[Finding]:
    """Everything in the Cortex-M4F objects of some C files that should not be there.

    Raises PurityError where a file does not compile.
    """
    with tempfile.TemporaryDirectory() as folder:
        return [
            finding
            for source in sources
            for finding in findings(source, compiled(source, include, standard, Path(folder)))
        ]


def compiled(source: Path, include: Sequence[Path], standard: str, folder: Path) -> Path:
    """The object file of one source."""
    target = folder / f"{source.stem}.o"
    flags = [*CORTEX_M4F, f"-std={standard}", *(f"-I{path}" for path in include)]
    command = [CROSS_COMPILER, *flags, "-c", str(source), "-o", str(target)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise PurityError(f"{source} does not compile for the target:\n{done.stderr.strip()}")
    return target


def findings(source: Path, target: Path) -> list[Finding]:
    """What is wrong with one object file."""
    listed = subprocess.run(
        [CROSS_NM, "--format=posix", str(target)], capture_output=True, text=True, check=True
    ).stdout
    found = []
    for line in listed.splitlines():
        name, kind = line.split()[:2]
        why = reason(name, kind)
        if why:
            found.append(Finding(source.name, name, why))
    return found


def reason(name: str, kind: str) -> str:
    """Why a symbol has no place here; empty where it may stay."""
    if kind in STATE:
        return "a variable outlives the call"
    if kind == "U":
        return outside_reason(name)
    exported = kind.isupper() and not name.startswith("$")
    return f"exported without the prefix {PREFIX}" if exported and not ours(name) else ""


def outside_reason(name: str) -> str:
    """Why a name must not be asked for; empty where it may."""
    if ours(name) or name in COMPILER_MADE:
        return ""
    if name.startswith("__aeabi_d") or name.endswith("2d"):
        return "arithmetic in double precision"
    if name in HEAP:
        return "the heap"
    return "a function of a library"


def ours(name: str) -> bool:
    """Whether a name is one of this project's."""
    return name.startswith(PREFIX)
