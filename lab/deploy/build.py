"""The machine's program for another computer: one file that needs no library there."""

import shutil
import subprocess
from pathlib import Path

from turnbuckle.codegen.bind import generate_into_cache
from turnbuckle.codegen.compile import compile_static
from turnbuckle.lab.deploy import DeployError
from turnbuckle.lab.deploy.processor import Processor
from turnbuckle.lab.live.program import FOLDERS, refuse_without_buses
from turnbuckle.model.machine import Machine


def build_for(machine: Machine, processor: Processor, precision: str) -> Path:
    """The machine's executable for a processor, in the cache of compiled C.

    Raises LiveError for a machine without buses, DeployError without the compiler, CompileError
    where that refuses.
    """
    refuse_without_buses(machine)
    refuse_without_compiler(processor)
    return compile_folder(generate_into_cache(machine), processor, precision)


def compile_folder(folder: Path, processor: Processor, precision: str = "double") -> Path:
    """The executable for a processor around a machine's generated folder."""
    sources = [path for each in (folder, *FOLDERS) for path in sorted(each.glob("*.c"))]
    return compile_static(sources, [folder, *FOLDERS], precision, processor.compiler)


def refuse_without_compiler(processor: Processor) -> None:
    """DeployError where the compiler for a processor, or the C library, is not installed here."""
    if not (shutil.which(processor.compiler) and has_library(processor.compiler)):
        raise DeployError(
            f"{processor.compiler}, the compiler for {processor.name}, or its C library is not"
            " installed here; sudo apt-get install --no-install-recommends"
            f" {' '.join(processor.packages)}"
        )


def has_library(compiler: str) -> bool:
    """Whether a compiler has a C library that goes into the program."""
    words = [compiler, "-print-file-name=libc.a"]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    return Path(done.stdout.strip()).is_absolute()
