"""`turnbuckle monitor` and `turnbuckle run`, without drives: what is shown, and what is refused."""

import os
import pty
import select
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from running import PATIENCE, Lines, Running, running, silent_lines
from typer.testing import CliRunner, Result

from lab.live.program import compile_machine
from lab.live.telemetry import Request
from lab.live.words import STATES
from turnbuckle import app

ROOT = Path(__file__).parents[2]
REQUESTS: tuple[Request, ...] = ("arm", "stop", "reset")


@pytest.fixture(scope="module")
def program(stock_folder: Path) -> Path:
    """The executable of the stock machine."""
    return compile_machine(stock_folder)


@pytest.fixture
def lines() -> Iterator[Lines]:
    """A serial line a bus."""
    with silent_lines() as lines:
        yield lines


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
    watched.await_state(STATES.index("FAULT"))
    shown = turnbuckle("monitor", stock_file, "--once", "--telemetry", watched.telemetry.path)
    assert shown.exit_code == 0
    for words in ("yoon2023", "FAULT", "did not boot", "cable_1", "base_4", "cable2"):
        assert words in shown.stdout
    for words in ("frames/s", "missed", "wake-up late", "computing", "3 to 10 N"):
        assert words in shown.stdout


def test_a_name_is_enough_to_watch(watched: Running) -> None:
    shown = turnbuckle("monitor", "yoon2023", "--once", "--telemetry", watched.telemetry.path)
    assert shown.exit_code == 0 and "cable_1" in shown.stdout


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
    assert_refused(turnbuckle("monitor", "yoon2023", "--telemetry", path), str(path), "run")


def test_keys_reach_the_program_and_q_leaves(watched: Running) -> None:
    screen, keyboard = pty.openpty()
    command = [sys.executable, str(ROOT / "turnbuckle.py"), "monitor", "yoon2023"]
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
        (["--pace", "2"], "only with --sim"),
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
    command = [sys.executable, str(ROOT / "turnbuckle.py"), "run"]
    done = subprocess.run(
        [*command, stock_file, "--program", program], capture_output=True, text=True
    )
    assert done.returncode == 2
    assert "the bus cable1 is missing" in done.stderr
