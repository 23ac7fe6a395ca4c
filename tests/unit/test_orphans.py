"""A command that is killed leaves no process behind."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
MACHINE = ROOT / "machines" / "yoon2023.toml"
PATIENCE = 300.0
"""Seconds after which a test gives up; nothing takes that long, on no computer."""
COMMANDS = {
    "generate": ["--out", "out"],
    "verify": ["--points", "2000000"],
    "study": ["--out", "out", "--samples", "100000", "--vary", "tension.max=8 N..11 N"],
    "run": ["--sim", "--telemetry", "shared", "--record", "dump"],
}
BUSY = {"generate": 2, "verify": 2, "study": 2, "run": 2}
"""Processes below a command when it is at work: of the pool, or drives and program."""


def below(pid: int) -> set[int]:
    """All processes that a process has started, and those that these have."""
    try:
        tasks = Path(f"/proc/{pid}/task").iterdir()
        words = "".join((task / "children").read_text() for task in tasks).split()
    except (FileNotFoundError, ProcessLookupError):
        return set()
    children = {int(word) for word in words}
    return children.union(*map(below, children))


def is_alive(pid: int) -> bool:
    """Whether a process runs; one that has ended and was not waited for does not."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


def await_workers(process: "subprocess.Popen[bytes]", count: int) -> set[int]:
    """The processes below a command, as soon as so many are there and as many have worked."""
    begin = time.monotonic()
    while time.monotonic() < begin + PATIENCE and process.poll() is None:
        found = below(process.pid)
        if sum(map(has_worked, found)) >= count:
            return found
        time.sleep(0.02)
    raise AssertionError(f"{process.args!r} ended, or has not begun")


def has_worked(pid: int) -> bool:
    """Whether a process is Python or the program, and has used the processor."""
    try:
        name, _, rest = Path(f"/proc/{pid}/stat").read_text().rpartition(")")
    except (FileNotFoundError, ProcessLookupError):
        return False
    return "cc1" not in name and "gcc" not in name and int(rest.split()[11]) > 0


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_that_is_killed_leaves_no_process_behind(command: str, tmp_path: Path) -> None:
    words = [sys.executable, "-m", "turnbuckle", command, str(MACHINE), *COMMANDS[command]]
    caches = {} if command in ("verify", "run") else {"XDG_CACHE_HOME": str(tmp_path / "cache")}
    with subprocess.Popen(
        words,
        cwd=tmp_path,
        env=os.environ | caches,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    ) as process:
        workers = await_workers(process, BUSY[command])
        process.send_signal(signal.SIGKILL)
        process.wait()
    begin = time.monotonic()
    while left := {pid for pid in workers if is_alive(pid)}:
        assert time.monotonic() < begin + PATIENCE / 10, f"{left} live on"
        time.sleep(0.02)
