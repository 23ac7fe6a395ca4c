"""The processors on which a machine's vectors are computed, by compilers and emulators."""

import hashlib
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Protocol

import turnbuckle.codegen.compile
from turnbuckle.codegen.compile import LIBRARIES, PRECISIONS, key, run
from turnbuckle.codegen.controller import STEP
from turnbuckle.lab.emulated.image import STARTING, linked
from turnbuckle.lab.emulated.processor import FIRMWARE, M4F, M7, Processor
from turnbuckle.lab.emulated.target import emulator_command
from turnbuckle.model.files import write_whole
from turnbuckle.places import RUNTIME

PROGRAM = Path(__file__).parent / "program"
CORE = RUNTIME / "core"
BUILD = LIBRARIES.parent / "vectors"
WHOLE = ("-fwhole-program",)
TOPICS = ("control", "kinematics", "statics", "tension")
"""Generated C that the controller step needs."""


class Platform(Protocol):
    """A processor, a compiler for it, and the precision in which it computes."""

    @property
    def name(self) -> str:
        """What it is called."""

    @property
    def precision(self) -> str:
        """double or float."""

    def answer(self, generated: Path, stream: bytes, flags: Sequence[str] = ()) -> bytes:
        """What the machine's C in a folder gives there for the arguments in a stream."""


@dataclass(frozen=True)
class LinuxPlatform:
    """A Linux computer, this one or one whose programs an emulator runs."""

    name: str
    precision: str
    compiler: str
    emulator: tuple[str, ...] = ()

    def answer(self, generated: Path, stream: bytes, flags: Sequence[str] = ()) -> bytes:
        """What the machine's C in a folder gives there for the arguments in a stream."""
        source, include = whole(generated, [PROGRAM / "stream_stdio.c"])
        common = turnbuckle.codegen.compile.FLAGS  # the tests' own, where they have their own
        own = () if self.compiler == "clang" else WHOLE
        options = [*common, *own, *PRECISIONS[self.precision], *flags]
        name = key([source], include, [self.compiler, *options])
        program = BUILD / name
        if not program.exists():
            arguments = [*options, *(f"-I{each}" for each in include), str(source), "-lm"]
            run(self.compiler, arguments, program)
        command = [*self.emulator, str(program)]
        return subprocess.run(command, input=stream, capture_output=True, check=True).stdout


@dataclass(frozen=True)
class CortexPlatform:
    """A microcontroller that an emulator runs, without an operating system."""

    processor: Processor

    @property
    def name(self) -> str:
        """What it is called."""
        return self.processor.name

    @property
    def precision(self) -> str:
        """double or float."""
        return self.processor.precision

    def answer(self, generated: Path, stream: bytes, flags: Sequence[str] = ()) -> bytes:
        """What the machine's C in a folder gives there for the arguments in a stream."""
        own = [PROGRAM / "stream_semihosting.c", *(FIRMWARE / name for name in STARTING)]
        source, include = whole(generated, own)
        script = FIRMWARE / "mps2.ld"
        image = linked(self.processor, [source], [*include, FIRMWARE], [*WHOLE, *flags], script)
        with TemporaryDirectory(prefix="turnbuckle-vectors-") as folder:
            (Path(folder) / "arguments").write_bytes(stream)
            subprocess.run(emulator_command(self.processor, image), cwd=folder, check=True)
            return (Path(folder) / "results").read_bytes()


def whole(generated: Path, more: Sequence[Path]) -> tuple[Path, list[Path]]:
    """One source with all of the program, so that a compiler can leave out what nothing calls; and
    the folders of its headers."""
    topics = [generated / f"tb_{topic}.c" for topic in TOPICS]
    parts = [*(path for path in topics if path.exists()), *(CORE / name for name in STEP)]
    lines = [
        f'#include "{part.resolve()}" /* {hashlib.sha256(part.read_bytes()).hexdigest()} */'
        for part in [*parts, PROGRAM / "answer.c", *more]
    ]
    text = "\n".join(lines) + "\n"
    source = BUILD / f"{hashlib.sha256(text.encode()).hexdigest()[:16]}.c"
    if not source.exists():
        write_whole(source, text)
    return source, [generated, CORE, PROGRAM]


def elsewhere(name: str, precision: str, triple: str, emulator: str) -> LinuxPlatform:
    """Another Linux computer than this one."""
    return LinuxPlatform(name, precision, f"{triple}-gcc", (emulator, "-L", f"/usr/{triple}"))


HOST = {each: LinuxPlatform("x86-64, gcc", each, "gcc") for each in PRECISIONS}
PLATFORMS: tuple[Platform, ...] = (
    *HOST.values(),
    LinuxPlatform("x86-64, clang", "double", "clang"),
    elsewhere("AArch64", "double", "aarch64-linux-gnu", "qemu-aarch64"),
    elsewhere("ARMv7", "float", "arm-linux-gnueabihf", "qemu-arm"),
    elsewhere("RISC-V 64", "double", "riscv64-linux-gnu", "qemu-riscv64"),
    CortexPlatform(M4F),
    CortexPlatform(M7),
)
"""All that are tried; tests/gates/test_targets.py tries all functions of one machine in both."""
