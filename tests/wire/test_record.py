"""The flight recorder's file: on the disk while the program runs, and never over something else."""

import os
import re
import resource
import shutil
import signal
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from running import PATIENCE, Lines, Running, running, shared_file, silent_lines

from turnbuckle.lab.flight import FlightError
from turnbuckle.lab.flight.recording import Recording, read_recording
from turnbuckle.lab.flight.replay import Supervisor, compile_supervisor, run_again
from turnbuckle.lab.live.program import compile_machine

ROOT = Path(__file__).parents[2]
MACHINE = ROOT / "machines" / "yoon2023.toml"
KEPT = b"TBFLIGHT of the last run"


@pytest.fixture(scope="module")
def program(stock_folder: Path) -> Path:
    """The executable of the stock machine."""
    return compile_machine(stock_folder)


@pytest.fixture(scope="module")
def supervisor(stock_folder: Path) -> Supervisor:
    """The stock machine's C, to run recordings again."""
    return compile_supervisor(stock_folder, "double")


@pytest.fixture
def lines() -> Iterator[Lines]:
    """A serial line a bus."""
    with silent_lines() as lines:
        yield lines


def killed(run: Running) -> int:
    """Kill a program, and wait for its writer, which closes stderr; the cycles it published."""
    run.process.kill()
    _out, err = run.process.communicate(timeout=PATIENCE)
    assert err == ""
    return int(run.telemetry.status()["published"])


def writer_of(run: Running) -> int:
    """The process that writes a program's record."""
    return int(Path(f"/proc/{run.process.pid}/task/{run.process.pid}/children").read_text())


def await_recording(path: Path, cycles: int) -> Recording:
    """A recording, as soon as so many cycles are in it."""
    begin = time.monotonic()
    while time.monotonic() < begin + PATIENCE:
        try:
            recording = read_recording(path, MACHINE)
        except (FileNotFoundError, FlightError):
            recording = None
        if recording is not None and len(recording.numbers) >= cycles:
            return recording
        time.sleep(0.01)
    raise AssertionError(f"no {cycles} cycles in {path}")


@pytest.mark.parametrize("seal", [[], ["--seal"]])
def test_a_killed_program_leaves_its_flight_up_to_the_kill(
    program: Path, lines: Lines, tmp_path: Path, supervisor: Supervisor, seal: list[str]
) -> None:
    dump = tmp_path / "dump"
    with running(program, [*lines.options, f"--record={dump}", *seal]) as run:
        run.await_cycles(700)
        published = killed(run)
    recording = read_recording(dump, MACHINE)
    assert recording.numbers[0] == 0
    assert published - 1 <= recording.numbers[-1] <= published
    assert recording.flaws == []
    assert run_again(recording, supervisor).matched == len(recording.numbers)
    assert list(tmp_path.iterdir()) == [dump]


def test_the_file_can_be_read_while_the_program_runs_and_when_all_of_it_is_killed(
    program: Path, lines: Lines, tmp_path: Path, supervisor: Supervisor
) -> None:
    dump = tmp_path / "dump"
    with running(program, [*lines.options, f"--record={dump}"]) as run:
        first = await_recording(dump, 1)
        assert "the program still runs" in first.flaws[-1]
        await_recording(dump, len(first.numbers) + 1)
        os.kill(writer_of(run), signal.SIGKILL)
        killed(run)
    found = read_recording(dump, MACHINE)
    assert len(found.numbers) > len(first.numbers)
    assert run_again(found, supervisor).difference is None


def test_the_ring_in_the_file_comes_round_with_the_recorder(
    stock_folder: Path, lines: Lines, tmp_path: Path, supervisor: Supervisor
) -> None:
    dump, folder = tmp_path / "dump", tmp_path / "small"
    shutil.copytree(stock_folder, folder)
    types = folder / "tb_machine.h"
    sizes = "#define TB_SEGMENT_CYCLES 16u\n#define TB_RECORDER_SEGMENTS 4u\n"
    types.write_text(types.read_text().replace("\n#define TB_", f"\n{sizes}#define TB_", 1))
    with running(compile_machine(folder), [*lines.options, f"--record={dump}"]) as run:
        run.await_cycles(1000)
        published = killed(run)
    found = read_recording(dump, MACHINE)
    assert found.flaws == [] and len(found.segments) == 4
    assert published - 1 <= found.numbers[-1] <= published
    assert len(found.numbers) > 48
    assert run_again(found, supervisor).matched == len(found.numbers)


def test_recording_makes_the_loop_fault_no_page(
    program: Path, lines: Lines, tmp_path: Path
) -> None:
    options = [*lines.real_time_options, f"--record={tmp_path / 'dump'}"]
    with running(program, options) as run:
        run.await_cycles(100)
        before = faults(run.process.pid)
        run.await_cycles(2000)
        assert faults(run.process.pid) == before


def faults(pid: int) -> list[str]:
    """Page faults of a process so far, minor and major ones."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return [fields[7], fields[9]]


def refused(program: Path, *options: str) -> str:
    """What a program says that cannot start; it says one thing."""
    command: list[str | Path] = [program, f"--telemetry={shared_file()}", *options]
    done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.count("\n") == 1
    return done.stderr


def test_where_no_bus_can_be_opened_the_last_recording_stays(program: Path, tmp_path: Path) -> None:
    dump = tmp_path / "dump"
    dump.write_bytes(KEPT)
    buses = [f"--bus={name}=slcan:/dev/no_{name}" for name in ("cable1", "cable2", "base")]
    assert "--bus cable1" in refused(program, *buses, f"--record={dump}")
    assert dump.read_bytes() == KEPT
    assert list(tmp_path.iterdir()) == [dump]


def test_the_last_recording_stays_until_a_cycle_has_run(
    program: Path, lines: Lines, tmp_path: Path
) -> None:
    dump = tmp_path / "dump"
    dump.write_bytes(KEPT)
    with lines.standstill(), running(program, [*lines.options, f"--record={dump}"]) as run:
        assert dump.read_bytes() == KEPT
        killed(run)
        assert dump.read_bytes() == KEPT
    assert list(tmp_path.iterdir()) == [dump]


def test_in_a_folder_every_run_has_a_file_of_its_own(
    program: Path, lines: Lines, tmp_path: Path
) -> None:
    for _ in range(2):
        with running(program, [*lines.options, f"--record={tmp_path}", "--cycles=20"]) as run:
            assert run.process.wait() == 0
    dumps = sorted(path.name for path in tmp_path.iterdir())
    assert len(dumps) == 2
    for name in dumps:
        assert re.fullmatch(r"yoon2023-\d{8}T\d{6}\.\d{3}Z\.dump", name)
        assert len(read_recording(tmp_path / name).numbers) in (20, 21)


@pytest.mark.parametrize("option", ["record", "telemetry"])
def test_what_is_not_ours_is_not_replaced(
    program: Path, lines: Lines, tmp_path: Path, option: str
) -> None:
    precious, link = tmp_path / "precious.txt", tmp_path / "link"
    pipe, folder = tmp_path / "pipe", tmp_path / "folder"
    link.symlink_to(precious)
    os.mkfifo(pipe)
    folder.mkdir()
    for content in (b"precious", b"TB", bytes(4096)):
        precious.write_bytes(content)
        for path in (precious, link):
            said = refused(program, *lines.options, f"--{option}={path}")
            assert f"--{option} {path}: is no " in said and "would be replaced" in said
            assert precious.read_bytes() == content and link.is_symlink()
    others = [pipe, Path("/dev/null"), *([folder] if option == "telemetry" else [])]
    for path in others:
        about = path.lstat()
        assert f"--{option} {path}: is no " in refused(
            program, *lines.options, f"--{option}={path}"
        )
        assert path.lstat()[:2] == about[:2]
    assert {path.name for path in tmp_path.iterdir()} == {"precious.txt", "link", "pipe", "folder"}


@pytest.mark.parametrize("option", ["record", "telemetry"])
def test_what_is_ours_or_empty_is_replaced(
    program: Path, lines: Lines, tmp_path: Path, option: str
) -> None:
    path = tmp_path / "ours"
    path.touch()
    words = [*lines.options, "--cycles=20", f"--{option}={path}"]
    for _ in range(2):
        done = subprocess.run(
            [program, f"--telemetry={shared_file()}", *words], capture_output=True, text=True
        )
        assert (done.returncode, done.stderr) == (0, "")
        assert path.stat().st_size > 1000


def no_large_files() -> None:
    """For a process that may write nothing of a megabyte."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 20, 1 << 20))
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)


@pytest.mark.parametrize("option", ["record", "telemetry"])
def test_without_room_nothing_is_left_and_the_file_is_named(
    program: Path, lines: Lines, tmp_path: Path, option: str
) -> None:
    path = tmp_path / "file"
    done = subprocess.run(
        [program, f"--telemetry={shared_file()}", *lines.options, f"--{option}={path}"],
        preexec_fn=no_large_files,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 2 and done.stderr.count("\n") == 1
    assert f"--{option} {path}: no room" in done.stderr
    assert list(tmp_path.iterdir()) == []
