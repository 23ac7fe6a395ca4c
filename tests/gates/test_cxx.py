"""C++ from C++11 on takes every header, and links with the C behind them."""

import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from turnbuckle.codegen.compile import compile_library

ROOT = Path(__file__).parents[2]
PARTS = ("core", "canopen", "can", "port/linux")
STANDARDS = ("c++11", "c++14", "c++17", "c++20")
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-pedantic", "-Werror")
GUARD = re.compile(r"^#ifdef __cplusplus\n(extern \"C\" \{|\})\n#endif\n", re.MULTILINE)
#: One source for C and C++: a step of the controller, and a few cycles of everything on its buses.
PROGRAM = """
#include <stdio.h>

#include "controller.h"
#include "loopback.h"
#include "master.h"
#include "network.h"
#include "tb_control.h"
#include "tb_kinematics.h"

static tb_controller controller;
static tb_loopback buses[TB_BUSES];
static tb_network network;
static tb_master master;
static tb_inputs inputs;
static tb_wishes wishes;

static void step(void)
{
    const real_t pose[TB_DOF] = {TB_C(0.3), TB_C(0.2)};
    tb_outputs outputs;
    tb_base_targets(pose, inputs.rails);
    tb_cable_lengths(pose, inputs.rails, inputs.lengths);
    tb_controller_start(&controller, inputs.lengths, inputs.rails);
    for (int cycle = 0; cycle < 10; cycle++) {
        printf("%d", (int)tb_controller_step(&controller, &inputs, &outputs));
        for (int i = 0; i < TB_CABLES; i++) {
            printf(" %a", (double)outputs.motor_torque[i]);
        }
        printf("\\n");
    }
}

int main(void)
{
    tb_can_port *ports[TB_BUSES];
    tb_can_frame frame;
    step();
    for (int i = 0; i < TB_BUSES; i++) {
        tb_loopback_open(&buses[i]);
        ports[i] = &buses[i].port;
    }
    tb_network_start(&network, ports);
    tb_master_start(&master, &network.fieldbus);
    for (int cycle = 0; cycle < 5; cycle++) {
        tb_master_sync(&master);
        tb_master_run(&master, &wishes, 0);
        for (int i = 0; i < TB_BUSES; i++) {
            while (tb_loopback_take(&buses[i], &frame) == TB_CAN_OK) {
                printf("%d: %03x %d\\n", i, (unsigned)frame.id, (int)frame.length);
            }
        }
    }
    return 0;
}
"""


def folders(generated: Path, runtime: Path) -> list[Path]:
    """Where the headers are."""
    return [generated, *(runtime / part for part in PARTS)]


def headers(include: list[Path]) -> list[Path]:
    """Every header of these folders."""
    found = [header for folder in include for header in sorted(folder.glob("*.h"))]
    assert len(found) > 60
    return found


def call(command: list[str], source: str) -> subprocess.CompletedProcess[str]:
    """Give a source to a compiler."""
    return subprocess.run(command, input=source, capture_output=True, text=True, check=False)


def compiler(name: str, standard: str, include: list[Path]) -> list[str]:
    """The command of a compiler that reads its source from a pipe."""
    language = "c++" if standard.startswith("c++") else "c"
    options = [f"-I{folder}" for folder in include]
    return [name, f"-x{language}", f"-std={standard}", *WARNINGS, *options, "-"]


def complaints(name: str, standard: str, include: list[Path], source: str) -> str:
    """What a compiler says about a source."""
    return call([*compiler(name, standard, include), "-fsyntax-only"], source).stderr


def including(names: list[str]) -> str:
    """A source that includes some headers and does nothing else."""
    return "".join(f'#include "{name}"\n' for name in names)


@pytest.fixture(scope="module")
def include(stock_folder: Path) -> list[Path]:
    """The folders of a user of the stock machine on Linux."""
    return folders(stock_folder, ROOT / "runtime")


@pytest.fixture(scope="module")
def library(include: list[Path]) -> Path:
    """All C of that user but main()."""
    sources = [source for folder in include for source in sorted(folder.glob("*.c"))]
    return compile_library([path for path in sources if path.name != "main.c"], include)


@pytest.mark.parametrize("name", ["g++", "clang++"])
@pytest.mark.parametrize("standard", STANDARDS)
def test_all_headers_together_are_c_plus_plus(
    name: str, standard: str, include: list[Path]
) -> None:
    names = [header.name for header in headers(include)]
    assert complaints(name, standard, include, including(names)) == ""


@pytest.mark.parametrize(("name", "standard"), [("g++", "c++11"), ("clang++", "c++20")])
def test_every_header_stands_alone(name: str, standard: str, include: list[Path]) -> None:
    told = {
        header.name: complaints(name, standard, include, including([header.name]))
        for header in headers(include)
    }
    assert not {header: text for header, text in told.items() if text}


@pytest.mark.parametrize(
    "line",
    [
        "typedef struct { int class; } tb_seeded;",
        "static inline tb_blame tb_seeded(void) { return (tb_blame){.cause = TB_CAUSE_NONE}; }",
        "void tb_seeded(const real_t pose[static 2]);",
        "typedef struct { _Atomic uint32_t seeded; } tb_seeded;",
    ],
    ids=["keyword", "compound literal", "array of at least", "atomic"],
)
def test_what_is_c_alone_is_noticed(line: str, include: list[Path]) -> None:
    assert complaints("g++", "c++20", include, f"{including(['states.h'])}{line}\n") != ""
    assert complaints("gcc", "c11", include, f"{including(['states.h'])}{line}\n") == ""


def functions(library: Path, include: list[Path]) -> list[str]:
    """Functions of the library that a header declares."""
    command = ["nm", "--defined-only", "--dynamic", str(library)]
    listed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    words = {word for header in headers(include) for word in re.findall(r"\w+", header.read_text())}
    names = [name for _, kind, name in map(str.split, listed.splitlines()) if kind == "T"]
    found = sorted(words.intersection(names))
    assert len(found) > 150
    return found


def calling_all(names: list[str], include: list[Path]) -> str:
    """A program that takes the address of every function."""
    entries = ",\n".join(f"    reinterpret_cast<void (*)()>(&{name})" for name in names)
    return (
        f"{including([header.name for header in headers(include)])}\n"
        f"void (*volatile all[])() = {{\n{entries}\n}};\n"
        "int main() { return all[0] == nullptr; }\n"
    )


def undefined(include: list[Path], library: Path, names: list[str], program: Path) -> set[str]:
    """Functions that the linker does not find for a program in C++."""
    command = [*compiler("g++", "c++11", include), "-xnone", str(library), "-o", str(program)]
    said = call(command, calling_all(names, include)).stderr
    return set(re.findall(r"undefined reference to `(\w+)", said))


def test_every_function_links_from_c_plus_plus(
    include: list[Path], library: Path, tmp_path: Path
) -> None:
    names = functions(library, include)
    assert undefined(include, library, names, tmp_path / "program") == set()
    assert subprocess.run([tmp_path / "program"], check=False).returncode == 0


def unguarded(include: list[Path], folder: Path, names: list[str]) -> Iterator[Path]:
    """Copies of the folders in which some headers have no guard."""
    for number, original in enumerate(include):
        copy = Path(shutil.copytree(original, folder / str(number)))
        for header in copy.glob("*.h"):
            if header.name in names:
                header.write_text(GUARD.sub("", header.read_text()))
        yield copy


@pytest.mark.parametrize("header", ["tb_kinematics.h", "master.h", "say.h"])
def test_a_header_without_its_guard_does_not_link(
    header: str, include: list[Path], library: Path, tmp_path: Path
) -> None:
    bare = list(unguarded(include, tmp_path, [header]))
    missing = undefined(bare, library, functions(library, include), tmp_path / "program")
    words = next(path for path in headers(bare) if path.name == header).read_text()
    assert missing and all(name in words for name in missing)


def run_program(name: str, standard: str, include: list[Path], library: Path, to: Path) -> str:
    """What the program prints, compiled with the C of the library beside it."""
    command = [*compiler(name, standard, include), "-xnone", str(library), "-o", str(to)]
    done = call(command, PROGRAM)
    assert done.stderr == ""
    return subprocess.run([to], capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize("name", ["g++", "clang++"])
@pytest.mark.parametrize("standard", STANDARDS)
def test_a_controller_on_its_buses_runs_in_c_plus_plus_as_in_c(
    name: str, standard: str, include: list[Path], library: Path, tmp_path: Path
) -> None:
    in_c = run_program("gcc", "c11", include, library, tmp_path / "c")
    assert in_c.count("\n") > 20 and ": 080 0" in in_c  # SYNC
    assert run_program(name, standard, include, library, tmp_path / "cxx") == in_c
