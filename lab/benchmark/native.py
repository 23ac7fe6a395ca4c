"""Compiles C for the benchmark and loads it."""

import ctypes
import subprocess
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory, mkdtemp

from turnbuckle.codegen.compile import FLAGS, GCC_FLAGS

ROOT = Path(__file__).parents[3]
#: Where this run builds; gone when it ends, so that runs side by side do not meet.
FOLDER = TemporaryDirectory(prefix="turnbuckle-benchmark-")
BUILD = Path(FOLDER.name)

#: What our C is shipped with.
OUR_FLAGS = (*FLAGS, *GCC_FLAGS)
#: What the peers get: at least as much.
PEER_FLAGS = ("-std=gnu11", "-O3")
OUR_WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror")


def run_tool(command: Sequence[str]) -> str:
    """Run a command and return what it prints; RuntimeError with its message when it fails."""
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise RuntimeError(f"{command[0]} failed:\n{result.stderr}")
    return result.stdout


def compile_object(source: Path, target: Path, flags: Sequence[str]) -> Path:
    """Compile one file for a shared library of this host."""
    target.parent.mkdir(parents=True, exist_ok=True)
    run_tool(["gcc", *flags, "-fPIC", "-c", str(source), "-o", str(target)])
    return target


def load_library(name: str, objects: Sequence[Path]) -> ctypes.CDLL:
    """Link objects to a library of this run and load it."""
    library = mkdtemp(prefix=name, dir=BUILD) + ".so"  # never a path that is loaded already
    run_tool(["gcc", "-shared", "-Wl,-Bsymbolic", *map(str, objects), "-lm", "-o", library])
    return ctypes.CDLL(library)
