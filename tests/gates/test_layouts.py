"""What the runtime says of its structs is all that the compiler knows of them; reading it takes no
compiler."""

import ctypes
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from c_structs import Declarations, declarations
from flown import Flight

from turnbuckle.codegen.compile import compile_library
from turnbuckle.codegen.struct_layout import Layout, Layouts, layouts_in
from turnbuckle.lab.flight.recording import HEADER
from turnbuckle.lab.live.program import FOLDERS
from turnbuckle.lab.live.telemetry import BEGINNING
from turnbuckle.places import RUNTIME

ROOT = Path(__file__).parents[2]
DESCRIPTIONS = ("tb_recording_layout", "tb_telemetry_layout")


def compiled(folder: Path, runtime: Path, precision: str = "double") -> Path:
    """The runtime's descriptions, with debug information; FOLDERS of another runtime."""
    folders = [runtime / path.relative_to(RUNTIME) for path in FOLDERS]
    names = ("core/recorder.c", "core/recording_layout.c", "port/linux/telemetry_layout.c")
    sources = [runtime / name for name in names]
    return compile_library(sources, [folder, *folders], precision)


@pytest.fixture(params=["double", "float"])
def library(
    request: pytest.FixtureRequest, stock_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> Path:
    """The stock machine's, in both precisions."""
    monkeypatch.setenv("CC", "gcc -g")
    return compiled(stock_folder, RUNTIME, request.param)


def differences(library: Path) -> list[str]:
    """Members and values that a description lacks, or has otherwise than the debug information."""
    known, loaded = declarations(library), ctypes.CDLL(str(library))
    found = []
    for name in DESCRIPTIONS:
        layouts = layouts_in(loaded, name)
        found += [
            difference
            for struct, layout in layouts.structs.items()
            for difference in of_struct(struct, layout, known.types[f"tb_{struct}"])
        ]
        found += of_values(layouts, known)
    return found


def of_struct(name: str, layout: Layout, struct: Any) -> list[str]:
    """The same of one struct."""
    fields: dict[str, Any] = dict(layout.fields or {})
    wanted = {
        member: (getattr(struct, member).offset, ctypes.sizeof(kind))
        for member, kind in struct._fields_
    }
    described = {member: (at, kind.itemsize) for member, (kind, at, *_) in fields.items()}
    return [
        f"tb_{name}.{member}"
        for member in wanted.keys() | described.keys()
        if wanted.get(member) != described.get(member)
    ]


def of_values(layouts: Layouts, known: Declarations) -> list[str]:
    """The same of the values of enumerations; which they are their names tell."""
    described: dict[str, int] = {}
    wanted: dict[str, int] = {}
    for enumeration, values in layouts.enumerations.items():
        beginning = BEGINNINGS.get(enumeration, f"TB_{enumeration.upper()}_")
        described |= {f"{beginning}{name}": value for name, value in values.items()}
        wanted |= {
            name: value
            for name, value in known.constants.items()
            if name.startswith(beginning) and name not in OTHERS
        }
    for name in MACROS:
        described.pop(name, None)
    return [
        name for name in wanted.keys() | described.keys() if wanted.get(name) != described.get(name)
    ]


BEGINNINGS = {"progress": "TB_TASK_", "bus_state": "TB_BUS_", "can_state": "TB_CAN_"}
MACROS = {
    *(f"TB_REQUEST_{name}" for name in ("ARM", "STOP", "RESET")),
    "TB_VERSION_RUNTIME_VERSION",
}
"""What is described and is no enumerator."""
RESULTS = """
    OK EMPTY FULL CLOSED REFUSED NO_DEVICE NO_PERMISSION BUSY NOT_CAN DOWN BIT_RATE UNSUPPORTED
    RESULTS
"""
OTHERS = {"TB_CAUSE_COUNT", *(f"TB_CAN_{name}" for name in RESULTS.split())}
"""Enumerators that are no states and causes."""


def test_every_member_and_value_is_described(library: Path) -> None:
    assert differences(library) == []
    structs = layouts_in(ctypes.CDLL(str(library)), DESCRIPTIONS[0]).structs
    assert {"supervisor", "orders", "observation", "controller", "inputs"} <= structs.keys()


@pytest.mark.parametrize(
    ("name", "right", "wrong", "found"),
    [
        ("core/cycle.h", "uint16_t index;", "uint16_t index; uint8_t seeded;", "tb_orders.seeded"),
        (
            "core/cycle.h",
            "    TB_PHASE_POWER_OFF\n",
            "    TB_PHASE_POWER_OFF, TB_PHASE_SEEDED\n",
            "TB_PHASE_SEEDED",
        ),
        (
            "port/linux/telemetry.h",
            "uint32_t simulated;",
            "uint32_t seeded, simulated;",
            "tb_telemetry_header.seeded",
        ),
    ],
    ids=["a member of the core", "a value", "a member of the port"],
)
def test_what_is_not_described_is_named(
    name: str,
    right: str,
    wrong: str,
    found: str,
    stock_folder: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("CC", "gcc -g")
    runtime = tmp_path / "runtime"
    shutil.copytree(RUNTIME, runtime)
    text = (runtime / name).read_text()
    assert text.count(right) == 1
    (runtime / name).write_text(text.replace(right, wrong))
    assert found in differences(compiled(stock_folder, runtime))


def test_what_a_reader_knows_by_itself_is_what_the_c_has(library: Path) -> None:
    known = declarations(library).types
    for struct, layout in (("tb_recording_header", HEADER), ("tb_telemetry_header", BEGINNING)):
        for member, (kind, at, *_) in (layout.fields or {}).items():
            field = getattr(known[struct], member)
            assert (field.offset, field.size) == (at, kind.itemsize), f"{struct}.{member}"
    assert ctypes.sizeof(known["tb_recording_header"]) == HEADER.itemsize


def test_a_recording_is_made_a_table_without_any_compiler(tmp_path: Path) -> None:
    flight, path, table = Flight(), tmp_path / "flight.dump", tmp_path / "log.csv"
    flight.machine.run(300)
    path.write_bytes(flight.read_out())
    done = without_compiler(tmp_path, "log", path, ROOT / "machines/yoon2023.toml", "--out", table)
    assert (done.returncode, done.stderr) == (0, "")
    assert len(table.read_text().splitlines()) == 301


def without_compiler(folder: Path, *arguments: object) -> subprocess.CompletedProcess[str]:
    """A command of turnbuckle where no other program can be found, and nothing compiled is kept."""
    (folder / "nothing").mkdir()
    environment = {
        **{name: value for name, value in os.environ.items() if name != "CC"},
        "PATH": str(folder / "nothing"),
        "XDG_CACHE_HOME": str(folder / "nothing"),
    }
    command = [sys.executable, "-m", "turnbuckle", *map(str, arguments)]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)


def test_what_needs_a_compiler_is_told_so_in_that_place(tmp_path: Path) -> None:
    flight, path = Flight(), tmp_path / "flight.dump"
    flight.machine.run(300)
    path.write_bytes(flight.read_out())
    done = without_compiler(tmp_path, "replay", path, ROOT / "machines/yoon2023.toml")
    assert done.returncode == 2
    assert "the C compiler 'gcc' is not installed" in done.stderr
