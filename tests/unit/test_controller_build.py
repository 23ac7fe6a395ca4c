"""The runtime's core compiles everywhere without a warning, and asks nothing of a target."""

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
CORE = ROOT / "runtime" / "core"
MACHINE = ROOT / "generated" / "yoon2023"
SOURCES = sorted(CORE.glob("*.c"))
STRICT = [
    "-std=c11",
    "-O2",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Werror",
    "-fno-math-errno",
]
CORTEX_M4F = [
    "-mcpu=cortex-m4",
    "-mthumb",
    "-mfpu=fpv4-sp-d16",
    "-mfloat-abi=hard",
    "-DTB_REAL_FLOAT",
]

ALLOWED_FROM_OUTSIDE = {"memcpy", "memmove", "memset"}  # what a compiler makes of copying a struct
COMPARISON_IN_DOUBLE = "\nint compare(float x);\nint compare(float x) { return x * 1.1 > 2.2; }\n"


def compile_object(compiler: str, source: Path, folder: Path, *flags: str) -> Path:
    """Compile one file with all warnings as errors."""
    target = folder / f"{source.stem}.o"
    includes = [f"-I{CORE}", f"-I{MACHINE}"]
    command = [compiler, *STRICT, *flags, *includes, "-c", str(source), "-o", str(target)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return target


def symbols(target: Path, *flags: str) -> set[str]:
    """Names in an object file for a Cortex-M."""
    command = ["arm-none-eabi-nm", "--format=posix", *flags, str(target)]
    listed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return {line.split()[0] for line in listed.splitlines()}


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("precision", [(), ("-DTB_REAL_FLOAT",)], ids=["double", "float"])
@pytest.mark.parametrize("source", SOURCES, ids=lambda path: path.stem)
def test_the_core_compiles_without_a_warning(
    compiler: str, precision: tuple[str, ...], source: Path, tmp_path: Path
) -> None:
    compile_object(compiler, source, tmp_path, *precision)


@pytest.mark.parametrize("source", SOURCES, ids=lambda path: path.stem)
def test_on_a_cortex_m4f_the_core_needs_no_double_no_heap_and_no_library(
    source: Path, tmp_path: Path
) -> None:
    target = compile_object("arm-none-eabi-gcc", source, tmp_path, *CORTEX_M4F)
    foreign = symbols(target, "--undefined-only") - ALLOWED_FROM_OUTSIDE
    assert {name for name in foreign if not name.startswith("tb_")} == set()


def test_arithmetic_in_double_would_be_noticed(tmp_path: Path) -> None:
    source = tmp_path / "gate_in_double.c"
    source.write_text((CORE / "torque_gate.c").read_text() + COMPARISON_IN_DOUBLE)
    target = compile_object("arm-none-eabi-gcc", source, tmp_path, *CORTEX_M4F)
    assert any(name.startswith("__aeabi_d") for name in symbols(target, "--undefined-only"))


@pytest.mark.parametrize("source", SOURCES, ids=lambda path: path.stem)
def test_the_core_keeps_no_state_of_its_own(source: Path, tmp_path: Path) -> None:
    target = compile_object("gcc", source, tmp_path)
    sections = subprocess.run(
        ["size", "--format=sysv", str(target)], capture_output=True, text=True, check=True
    ).stdout
    sizes = {name: int(size) for name, size in re.findall(r"^(\.\w+)\s+(\d+)", sections, re.M)}
    assert sizes[".data"] == 0 and sizes[".bss"] == 0
