"""What the pages on adding a port, a fieldbus and an adapter show works, as they show it."""

import ctypes
import re
import shutil
import struct
import subprocess
from ctypes import byref
from pathlib import Path
from typing import Any

import pytest
from canopen_c import MACHINE, RUNTIME, Canopen
from variants import ROOT

from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.compile import compile_library, compile_program
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.drives.bus import Frame
from turnbuckle.lab.machine_sim import SimulatedMachine
from turnbuckle.model.reference.control import base_targets

BARE = RUNTIME / "port" / "bare"
PORTABLE = [
    *sorted(MACHINE.glob("*.c")),
    *sorted((RUNTIME / "core").glob("*.c")),
    *sorted((RUNTIME / "canopen").glob("*.c")),
    RUNTIME / "can" / "can.c",
    RUNTIME / "can" / "loopback.c",
]
SECOND = 1_000_000_000
WORLD = ctypes.CFUNCTYPE(None, ctypes.c_int64)
FRAME = struct.Struct("=IBB64x")
"""The head of a tb_can_frame: id, flags, length."""


def blocks(page: str, language: str) -> list[str]:
    """The code blocks of a page in a language."""
    text = (ROOT / "docs" / page).read_text()
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def written(page: str, folder: Path) -> Path:
    """The C of a page, in a file of the name that it gives."""
    (code,) = blocks(page, "c")
    path = folder / str(re.findall(r"/\* (\w+\.c) \*/", code)[0])
    path.write_text(code)
    return path


class Board:
    """The page's board with a simulated machine on its buses."""

    def __init__(self, board: Path, machine: SimulatedMachine) -> None:
        sources = [*PORTABLE, BARE / "cycles.c", board]
        self.c = Canopen(sources, folders=[BARE])
        self.machine = machine
        self.buses = self.c.variable("board_buses")
        self.wishes = self.c.variable("board_wishes")
        self._world = WORLD(self.pass_time)
        ctypes.c_void_p.in_dll(self.c._library, "board_world").value = ctypes.cast(
            self._world, ctypes.c_void_p
        ).value
        self.cycles = self.c.new("tb_cycles")
        self.c._library.tb_board_start.restype = ctypes.c_void_p
        fieldbus = self.c._library.tb_board_start()
        self.c.tb_cycles_start(byref(self.cycles), ctypes.c_void_p(fieldbus))

    def pass_time(self, until: int) -> None:
        """Frames of the master go out, time passes, answers come."""
        frame = self.c.new("tb_can_frame")
        for loop, bus in zip(self.buses, self.machine.buses, strict=True):
            while self.c.tb_loopback_take(byref(loop), byref(frame)) == self.c.TB_CAN_OK:
                bus.send(Frame(frame.id, bytes(frame.data[: frame.length])), 0.0)
        self.machine.run_until(until / SECOND)
        for loop, bus in zip(self.buses, self.machine.buses, strict=True):
            for identifier, data in bus.take():
                frame.id, frame.length = identifier, len(data)
                frame.data[: len(data)] = data
                self.c.tb_loopback_give(byref(loop), byref(frame))

    @property
    def orders(self) -> Any:
        """Of the last cycle."""
        return self.cycles.master.orders

    @property
    def fed(self) -> int:
        """How often the watchdog was."""
        return int(self.c.variable("board_fed").value)

    def run_until(self, state: str, phase: str, most: int) -> None:
        """Run until the machine is there."""
        there = getattr(self.c, f"TB_STATE_{state}"), getattr(self.c, f"TB_PHASE_{phase}")
        for _ in range(most):
            self.c.tb_cycles_run(byref(self.cycles))
            if (self.orders.state, self.orders.phase) == there:
                return
        raise AssertionError(f"{self.orders.state}, {self.orders.phase}: {self.orders.cause}")


@pytest.fixture
def board(double: Generated, tmp_path: Path) -> Board:
    """The stock machine on the page's board."""
    task = plan_task(double)
    plant = plant_of(double.machine)
    start = task.path.at(0.0)[0]
    rails = [float(s) for s in base_targets(double.machine, start)]
    machine = SimulatedMachine(double.machine, plant, task, rails)
    return Board(written("adding-a-port.md", tmp_path), machine)


def test_a_board_without_an_operating_system_brings_the_machine_to_work(board: Board) -> None:
    board.run_until("CONFIGURE", "READY", 3000)
    for cycle in range(10):  # a request is an edge, and the drives are off a little later
        board.wishes.requests = cycle % 2
        board.c.tb_cycles_run(byref(board.cycles))
    board.run_until("RUN", "NONE", 60_000)
    assert board.cycles.missed == 0
    fed = board.fed
    board.cycles.master.supervisor.complement = board.cycles.master.supervisor.state
    for _ in range(5):
        board.c.tb_cycles_run(byref(board.cycles))
    assert board.orders.state == board.c.TB_STATE_HARD_STOP
    assert board.fed == fed  # the watchdog will bite


def test_a_board_that_was_busy_leaves_cycles_out_and_the_supervisor_judges(board: Board) -> None:
    board.run_until("CONFIGURE", "READY", 3000)
    begin = board.cycles.begin
    board.c.variable("board_now").value = begin + SECOND // 1000 * 3
    board.machine.run_until(begin / SECOND + 0.003)
    board.c.tb_cycles_run(byref(board.cycles))
    assert (board.cycles.missed, board.cycles.begin - begin) == (3, SECOND // 1000 * 4)


def test_a_port_compiles_for_a_processor_without_an_operating_system(tmp_path: Path) -> None:
    image = tmp_path / "image.elf"
    assert used_memory(image_command(tmp_path), image) < 80_000
    whole = image_command(tmp_path).replace("-DTB_RECORDER_SEGMENTS=1u -DTB_SEGMENT_CYCLES=64u", "")
    assert round(used_memory(whole, image) / 1e6) == 6  # what the page says of its defaults


def image_command(folder: Path) -> str:
    """The page's compilation of its board, with warnings as errors."""
    (command,) = (text for text in blocks("adding-a-port.md", "sh") if "image.elf" in text)
    board = written("adding-a-port.md", folder)
    strict = f"-Wl,--no-warn-rwx-segments -Wall -Wextra -Werror -o {folder}/image.elf"
    return command.replace("board.c", str(board)).replace("-o image.elf", strict).strip()


def used_memory(command: str, image: Path) -> int:
    """RAM [bytes] of what a command, run in the repository, links."""
    done = subprocess.run(
        command, cwd=ROOT, shell=True, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    size = ["arm-none-eabi-size", str(image)]
    told = subprocess.run(size, capture_output=True, text=True, check=True).stdout
    _, data, bss, *_ = told.splitlines()[1].split()
    return int(data) + int(bss)


def test_a_fieldbus_that_is_no_can_brings_the_machine_to_where_it_can_be_armed(
    tmp_path: Path,
) -> None:
    ideal = written("adding-a-fieldbus.md", tmp_path)
    c = Canopen([*PORTABLE, ideal])  # the generated tables of drives name functions of CANopen
    master, bus, wishes = c.new("tb_master"), c.new("ideal_bus"), c.new("tb_wishes")
    c._library.ideal_start.restype = ctypes.c_void_p
    c.tb_master_start(byref(master), ctypes.c_void_p(c._library.ideal_start(byref(bus))))
    for _ in range(3000):
        c.tb_master_sync(byref(master))
        c.tb_master_run(byref(master), byref(wishes), 0)
    assert (master.orders.state, master.orders.phase) == (c.TB_STATE_CONFIGURE, c.TB_PHASE_READY)
    bus.drives[2].silent = c.TB_SILENCE_UNHEARD
    c.tb_master_sync(byref(master))
    c.tb_master_run(byref(master), byref(wishes), 0)
    assert (master.orders.cause, master.orders.culprit) == (c.TB_CAUSE_DRIVE_SILENT, 2)


def test_a_folder_of_a_fieldbus_is_in_the_library_without_registration(tmp_path: Path) -> None:
    shutil.copytree(RUNTIME, tmp_path / "runtime")
    shutil.copytree(MACHINE, tmp_path / "generated" / "yoon2023")
    wire = tmp_path / "runtime" / "wire"
    wire.mkdir()
    written("adding-a-fieldbus.md", wire)
    shutil.copy(ROOT / "Makefile", tmp_path)
    done = subprocess.run(
        ["make", "-n", "build/yoon2023/cortex-m4f/libturnbuckle.a"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert "runtime/wire/ideal.c" in done.stdout and "-Iruntime/wire" in done.stdout, done.stderr
    assert "runtime/can/socketcan.c" not in done.stdout and "port/" not in done.stdout


def with_adapter(folder: Path) -> Path:
    """A copy of the runtime with the page's adapter and its lines."""
    runtime = folder / "runtime"
    shutil.copytree(RUNTIME, runtime)
    linux = runtime / "port" / "linux"
    written("adding-an-adapter.md", linux)
    header, table = (
        [line[1:] for line in block.splitlines()]
        for block in blocks("adding-an-adapter.md", "diff")
    )
    for name, after, line in (
        ("adapters.h", '#include "can.h"', header[0]),
        ("adapters.h", "    tb_socketcan socketcan;", header[1]),
        ("adapters.h", "extern const tb_adapter tb_adapter_socketcan;", header[2]),
        ("adapters.c", "    &tb_adapter_socketcan,", table[0]),
    ):
        text = (linux / name).read_text()
        assert text.count(after) == 1
        (linux / name).write_text(text.replace(after, f"{after}\n{line}"))
    return runtime


def test_an_adapter_is_a_file_and_a_line_of_the_table(tmp_path: Path) -> None:
    runtime = with_adapter(tmp_path)
    parts = [runtime / part for part in ("core", "canopen", "can", "port/linux")]
    sources = [path for folder in (MACHINE, *parts) for path in sorted(folder.glob("*.c"))]
    program = compile_program(sources, [MACHINE, *parts])

    def run(*words: str) -> subprocess.CompletedProcess[str]:
        command = [str(program), *words, "--priority=0", f"--telemetry={tmp_path / 'shared'}"]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    assert "--bus NAME=nobody:x" in run("--help").stdout
    assert "base=nobody:x" in run("--bus=cable1=nobody:x", "--bus=cable2=nobody:x").stderr
    buses = [f"--bus={name}=nobody:{name}" for name in ("cable1", "cable2", "base")]
    done = run(*buses, "--cycles=60")
    assert done.returncode == 0
    assert len(re.findall(r"^bus \w+: [1-9]\d* frames sent, 0 received", done.stdout, re.M)) == 3


def test_every_file_of_an_adapter_has_its_row_in_the_table() -> None:
    linux = RUNTIME / "port" / "linux"
    rows = set(re.findall(r"^ +&tb_(\w+),", (linux / "adapters.c").read_text(), re.MULTILINE))
    assert {path.stem for path in linux.glob("adapter_*.c")} == rows, "adapters.c: the table"


def test_without_its_line_in_the_table_an_adapter_is_not_there(tmp_path: Path) -> None:
    runtime = with_adapter(tmp_path)
    table = runtime / "port" / "linux" / "adapters.c"
    table.write_text(table.read_text().replace("    &tb_adapter_nobody,\n", ""))
    parts = [runtime / part for part in ("core", "can", "port/linux")]
    shim = tmp_path / "find.c"
    shim.write_text(
        '#include "adapters.h"\nint found(const char *text);\nint found(const char *text)\n'
        "{\n    const char *device;\n    return tb_adapter_find(text, &device) != NULL;\n}\n"
    )
    linux = runtime / "port" / "linux"
    sources = [*sorted(linux.glob("adapter*.c")), *sorted((runtime / "can").glob("*.c")), shim]
    found = ctypes.CDLL(str(compile_library(sources, [MACHINE, *parts]))).found
    assert (found(b"slcan:a"), found(b"socketcan:a"), found(b"nobody:a")) == (1, 1, 0)
