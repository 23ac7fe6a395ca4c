"""Compiles C into a shared library or a program, once for the same sources and flags."""

import hashlib
import os
import shlex
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from turnbuckle.model.refusal import Refusal
from turnbuckle.places import cache_folder

#: Where libraries are kept; safe to delete.
LIBRARIES = cache_folder() / "libraries"
#: Flags that every build of ours uses: the same bits on every target, square roots inline.
FLAGS: tuple[str, ...] = (
    "-std=c11",
    "-O2",
    "-ffp-contract=off",
    "-fno-math-errno",
    "-fno-trapping-math",
)
#: gcc would take minima and maxima apart into jumps that no processor predicts, copy in pairs what
#: was just written one by one, which has to wait, and in a shared library call our own functions as
#: if they could be replaced; clang does none of that.
GCC_FLAGS: tuple[str, ...] = (
    "-fno-thread-jumps",
    "-fno-tree-vectorize",
    "-fno-tree-slp-vectorize",
    "-fno-semantic-interposition",
)
PRECISIONS = {"double": (), "float": ("-DTB_REAL_FLOAT",)}


class CompileError(Refusal):
    """The C compiler refused; the text holds what it said."""


def compile_library(
    sources: Sequence[Path],
    include: Sequence[Path],
    precision: str = "double",
    defines: Sequence[str] = (),
) -> Path:
    """Shared library of some C files for one precision ("double" or "float").

    defines: macros, "NAME=VALUE". Raises CompileError with the compiler's words, ValueError for an
    unknown precision.
    """
    kind = ("-shared", "-fPIC", *(f"-D{each}" for each in defines))
    return compiled(sources, include, precision, kind, ".so")


def compile_program(
    sources: Sequence[Path], include: Sequence[Path], precision: str = "double"
) -> Path:
    """Executable of some C files, one of which has main(); otherwise as compile_library."""
    return compiled(sources, include, precision, (), "")


def compile_static(
    sources: Sequence[Path], include: Sequence[Path], precision: str, compiler: str
) -> Path:
    """Executable for another computer, with its C library inside; otherwise as compile_program.

    A warning of the linker is an error: it tells of what would need that computer's library.
    """
    return compiled(sources, include, precision, ("-static", "-Wl,--fatal-warnings"), "", compiler)


def compiled(
    sources: Sequence[Path],
    include: Sequence[Path],
    precision: str,
    kind: Sequence[str],
    suffix: str,
    command: str | None = None,
) -> Path:
    """What the compiler makes of the sources; made before, it is not made again.

    command: the compiler with its options; None for that of the environment's CC, or gcc.
    """
    if precision not in PRECISIONS:
        raise ValueError(f"precision {precision!r}: choose one of {', '.join(PRECISIONS)}")
    compiler, *extra = shlex.split(command or os.environ.get("CC") or "gcc")
    own = () if "clang" in compiler else GCC_FLAGS
    flags = [*extra, *FLAGS, *own, *PRECISIONS[precision], *kind]
    product = LIBRARIES / f"{key(sources, include, [compiler, *flags])}{suffix}"
    if not product.exists():
        product.parent.mkdir(parents=True, exist_ok=True)
        arguments = [*flags, *(f"-I{folder}" for folder in include), *map(str, sources)]
        run(compiler, arguments, product)
    return product


def key(sources: Sequence[Path], include: Sequence[Path], flags: Sequence[str]) -> str:
    """Changes with every byte the compiler reads of ours."""
    digest = hashlib.sha256("\0".join(flags).encode())
    headers = [header for folder in include for header in sorted(folder.glob("*.h"))]
    for path in [*sources, *headers]:
        digest.update(path.name.encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:32]


def run(compiler: str, arguments: Sequence[str], product: Path) -> None:
    """Compile next to the target, then move it there: no one ever loads half a library."""
    handle, name = tempfile.mkstemp(suffix=product.suffix, dir=product.parent)
    os.close(handle)
    try:
        done = subprocess.run(
            [compiler, *arguments, "-o", name], capture_output=True, text=True, check=False
        )
        if done.returncode:
            raise CompileError(f"{compiler} failed:\n{done.stderr.strip()}")
        os.chmod(name, 0o755)
        os.replace(name, product)
    except FileNotFoundError:
        raise CompileError(f"the C compiler {compiler!r} is not installed") from None
    finally:
        Path(name).unlink(missing_ok=True)
