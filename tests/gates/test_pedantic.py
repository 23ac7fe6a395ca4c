"""The generated C compiles with every warning an error, on two compilers, in both precisions."""

import subprocess
from pathlib import Path

import pytest

PEDANTIC = [
    "-std=c99",
    "-O2",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wshadow",
    "-Wdouble-promotion",
    "-Wstrict-prototypes",
    "-Wmissing-prototypes",
    "-Wundef",
    "-Werror",
    "-fsyntax-only",
]
#: What single precision must not do unnoticed.
PROMOTES = """
#include "tb_types.h"
real_t tb_seeded(real_t x);
real_t tb_seeded(real_t x) { return x * 1.1; }
"""


def complaints(compiler: str, precision: str, sources: list[Path], folder: Path) -> str:
    flags = [*PEDANTIC, precision, f"-I{folder}"]
    command = [compiler, *flags, *map(str, sources)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.stderr if done.returncode else ""


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("precision", ["-UTB_REAL_FLOAT", "-DTB_REAL_FLOAT"])
def test_generated_c_compiles_without_a_warning(
    compiler: str, precision: str, stock_folder: Path
) -> None:
    assert complaints(compiler, precision, sorted(stock_folder.glob("*.c")), stock_folder) == ""


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_a_silent_promotion_to_double_is_a_warning(
    compiler: str, stock_folder: Path, tmp_path: Path
) -> None:
    seeded = tmp_path / "seeded.c"
    seeded.write_text(PROMOTES)
    assert "double" in complaints(compiler, "-DTB_REAL_FLOAT", [seeded], stock_folder)
