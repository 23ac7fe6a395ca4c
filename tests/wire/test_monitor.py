"""`turnbuckle monitor` and `turnbuckle run`, without drives: what is shown, and what is refused."""

import os
import pty
import re
import select
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from running import PATIENCE, Lines, Running, running, shared_file
from typer.testing import CliRunner, Result

from turnbuckle.command_line import app
from turnbuckle.lab.live.telemetry import Request
from turnbuckle.lab.lockstep import State

ROOT = Path(__file__).parents[2]
REQUESTS: tuple[Request, ...] = ("arm", "stop", "reset")


@pytest.fixture
def watched(program: Path, lines: Lines) -> Iterator[Running]:
    """A program that runs, without drives."""
    with running(program, lines.options) as run:
        run.await_cycles(20)
        yield run


def turnbuckle(*arguments: object) -> Result:
    """Run a command in this process."""
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


def assert_refused(result: Result, *words: str) -> None:
    """Exit status 2, one message that holds the words."""
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.count("\n") == 1
    for word in words:
        assert word in result.stderr


def test_one_picture_shows_state_drives_buses_and_times(watched: Running, stock_file: Path) -> None:
    watched.await_state(State.FAULT)
    shown = turnbuckle("monitor", stock_file, "--once", "--telemetry", watched.telemetry.path)
    assert shown.exit_code == 0
    for words in ("yoon2023", "FAULT", "did not boot", "cable_1", "base_4", "cable2"):
        assert words in shown.stdout
    for words in ("frames/s", "missed", "in simulated time", "3 to 10 N"):
        assert words in shown.stdout
    assert "wake-up late" not in shown.stdout


def test_a_program_in_real_time_shows_how_well_it_keeps_it(program: Path, lines: Lines) -> None:
    with running(program, lines.real_time_options) as run:
        run.await_cycles(20)
        shown = turnbuckle("monitor", "yoon2023", "--once", "--telemetry", run.telemetry.path)
    for words in ("frames/s", "missed", "wake-up late", "computing"):
        assert words in shown.stdout
    assert "in simulated time" not in shown.stdout


def test_a_name_is_enough_to_watch(watched: Running) -> None:
    shown = turnbuckle("monitor", "yoon2023", "--once", "--telemetry", watched.telemetry.path)
    assert shown.exit_code == 0 and "cable_1" in shown.stdout


@pytest.mark.parametrize("subject", ["yoon2023", "machines/yoon2023.toml"])
def test_a_program_is_watched_without_any_compiler(
    subject: str, watched: Running, tmp_path: Path
) -> None:
    nothing = {**os.environ, "PATH": str(tmp_path), "XDG_CACHE_HOME": str(tmp_path / "cache")}
    command = [sys.executable, "-m", "turnbuckle", "monitor", subject, "--once"]
    done = subprocess.run(
        [*command, f"--telemetry={watched.telemetry.path}"],
        cwd=ROOT,
        env={name: value for name, value in nothing.items() if name != "CC"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "cable_1" in done.stdout


def test_a_program_that_has_ended_is_said_to_have(watched: Running) -> None:
    assert watched.end(signal.SIGTERM)[0] == 0
    shown = turnbuckle("monitor", "yoon2023", "--once", "--telemetry", watched.telemetry.path)
    assert "the program has ended" in shown.stdout
    asked = turnbuckle("monitor", "yoon2023", "--arm", "--telemetry", watched.telemetry.path)
    assert_refused(asked, str(watched.telemetry.path), "its program has ended")


def test_a_killed_program_is_said_to_have_ended_too(watched: Running) -> None:
    watched.end(signal.SIGKILL)
    shown = turnbuckle("monitor", "yoon2023", "--once", "--telemetry", watched.telemetry.path)
    assert "the program has ended" in shown.stdout


def test_the_program_of_another_hash_is_refused(
    watched: Running, stock_file: Path, tmp_path: Path
) -> None:
    other = tmp_path / "other.toml"
    other.write_text(stock_file.read_text().replace('max = "10 N"', 'max = "9 N"', 1))
    shown = turnbuckle("monitor", other, "--once", "--telemetry", watched.telemetry.path)
    assert_refused(shown, str(watched.telemetry.path), watched.telemetry.hash, str(other))


def test_no_telemetry_is_told_with_what_to_do(tmp_path: Path) -> None:
    path = tmp_path / "none"
    shown = turnbuckle("monitor", "yoon2023", "--once", "--telemetry", path)
    assert_refused(shown, str(path), "turnbuckle run")


def test_keys_reach_the_program_and_q_leaves(watched: Running) -> None:
    screen, keyboard = pty.openpty()
    command = [sys.executable, "-m", "turnbuckle", "monitor", "yoon2023"]
    with subprocess.Popen(
        [*command, f"--telemetry={watched.telemetry.path}"],
        stdin=keyboard,
        stdout=keyboard,
        env={**os.environ, "TERM": "xterm"},
    ) as process:
        os.close(keyboard)
        seen = read_until(screen, b"q leave")
        for request in REQUESTS:
            os.write(screen, request[0].encode())
            await_request(watched, request)
        os.write(screen, b"q")
        drain_until_end(screen)
        assert process.wait() == 0
    assert b"yoon2023" in seen
    os.close(screen)


def watch(path: Path) -> "subprocess.Popen[str]":
    """A monitor without a keyboard."""
    command = [sys.executable, "-m", "turnbuckle", "monitor", "yoon2023"]
    return subprocess.Popen(
        [*command, f"--telemetry={path}"],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONUNBUFFERED": "1"},
    )


@pytest.mark.parametrize("before", ["nothing", "a program that has ended"])
def test_a_monitor_that_comes_first_says_for_what_it_waits_and_then_watches(
    program: Path, lines: Lines, before: str
) -> None:
    if before != "nothing":
        with running(program, lines.options, keep=True) as run:
            run.await_cycles(1)
    path = shared_file(keep=True)
    with watch(path) as monitor:
        assert monitor.stdout is not None
        first = monitor.stdout.readline()
        assert str(path) in first and "turnbuckle run" in first
        with running(program, lines.options) as run:
            run.await_state(State.FAULT)
            run.end(signal.SIGTERM)
            shown = monitor.stdout.read()
        assert monitor.wait() == 0
    assert "cable_1" in shown and "the program has ended" in shown


def read_until(screen: int, words: bytes) -> bytes:
    """What is on the screen, until the words are."""
    seen = b""
    while words not in seen:
        assert select.select([screen], [], [], PATIENCE)[0], seen
        seen += os.read(screen, 65536)
    return seen


def drain_until_end(screen: int) -> None:
    """Read until the program at the other end has gone."""
    try:
        while os.read(screen, 65536):
            pass
    except OSError:
        return


def await_request(watched: Running, name: Request) -> None:
    """Wait until a request is in the inbox."""
    begin = time.monotonic()
    while not watched.telemetry.asked(name):
        assert time.monotonic() - begin < PATIENCE
        time.sleep(0.01)


def test_run_refuses_the_program_of_another_machine(
    program: Path, stock_file: Path, tmp_path: Path
) -> None:
    other = tmp_path / "other.toml"
    other.write_text(stock_file.read_text().replace('max = "10 N"', 'max = "9 N"', 1))
    answer = turnbuckle("run", other, "--program", program, "--bus", "cable1=slcan:/dev/none")
    assert_refused(answer, str(program), "compiled for yoon2023", str(other))


@pytest.mark.parametrize("name", ["/bin/true", "/etc/hostname", "/nowhere"])
def test_run_refuses_what_is_no_program_of_ours(stock_file: Path, name: str) -> None:
    assert_refused(turnbuckle("run", stock_file, "--program", name), name, "not a")


def test_run_refuses_a_machine_without_buses() -> None:
    file = ROOT / "machines" / "brau_triangle.toml"
    assert_refused(turnbuckle("run", file, "--sim"), str(file), "[[bus]]")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--sim", "--bus", "cable1=slcan:a"], "--bus is for real adapters"),
        (["--sim", "--seconds", "0"], "a positive number of seconds"),
        (["--sim", "--seconds", "nan"], "a positive number of seconds"),
    ],
)
def test_run_refuses_options_that_contradict(
    stock_file: Path, options: list[str], words: str
) -> None:
    answer = turnbuckle("run", stock_file, *options)
    assert answer.exit_code == 2 and words in answer.stderr


def test_run_hands_on_what_the_program_says(stock_file: Path, program: Path) -> None:
    command = [sys.executable, "-m", "turnbuckle", "run"]
    done = subprocess.run(
        [*command, stock_file, "--program", program], capture_output=True, text=True
    )
    assert done.returncode == 2
    assert "the bus cable1 is missing" in done.stderr


def start_run(file: Path, program: Path, lines: Lines, *options: str) -> "subprocess.Popen[str]":
    """`turnbuckle run` on lines without drives, in real time."""
    command = [sys.executable, "-m", "turnbuckle", "run", str(file)]
    words = [f"--program={program}", f"--telemetry={shared_file()}", *lines.real_time_options]
    return subprocess.Popen(
        [*command, *words, *options],
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env={**os.environ, "PYTHONUNBUFFERED": "1"},
    )


def test_a_run_of_so_many_seconds_ends_with_the_cause_after_a_fault(
    program: Path, stock_file: Path, lines: Lines
) -> None:
    with start_run(stock_file, program, lines, "--seconds=100000") as run:
        told, complaints = run.communicate(timeout=PATIENCE)
    assert run.returncode == 1
    assert re.search(r" s  FAULT\n.* s +drive \w+ .* did not boot", told)
    assert "did not boot" in complaints.splitlines()[-1]


def test_a_run_without_end_tells_the_cause_at_once_and_waits_for_a_reset(
    program: Path, stock_file: Path, lines: Lines
) -> None:
    with start_run(stock_file, program, lines) as run:
        told = read_told(run, "did not boot")
        asked = turnbuckle("monitor", "yoon2023", "--reset", "--telemetry", shared_file(keep=True))
        assert asked.exit_code == 0
        again = read_told(run, "INIT")
        run.send_signal(signal.SIGINT)
        rest, _complaints = run.communicate(timeout=PATIENCE)
    assert "FAULT" in told and "FAULT" not in again
    assert "stopping" in rest and run.returncode == 0


def read_told(run: "subprocess.Popen[str]", words: str) -> str:
    """What a run tells, until it says so."""
    assert run.stdout is not None
    told = ""
    while words not in told:
        line = run.stdout.readline()
        assert line, told
        told += line
    return told
