"""The control loop of the executable: time, stops, the seal, the watchdog.

In simulated time, but for what the computer's own clock is asked for.
"""

import itertools
import os
import re
import signal
import socket
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest
from running import Lines, Running, running

from turnbuckle.codegen.compile import compile_program
from turnbuckle.lab.live.program import FOLDERS
from turnbuckle.lab.live.telemetry import Telemetry
from turnbuckle.lab.lockstep import State
from turnbuckle.places import RUNTIME

FAULT = State.FAULT
PORT = RUNTIME / "port" / "linux"
CYCLIC = {"clock_nanosleep", "clock_gettime", "read", "write", "ioctl"}
"""System calls that the loop may make: sleep, frames, the length of a line's queue."""
CLOCKS = {"real": CYCLIC, "simulated": CYCLIC | {"sendto", "recvfrom"}}
"""By the clock that the loop lives by."""


def kept(telemetry: Telemetry) -> list[np.void]:
    """All cycles that the ring still holds."""
    published = int(telemetry.status()["published"])
    cycles = (telemetry.cycle(number) for number in range(max(0, published - 2000), published))
    return [cycle for cycle in cycles if cycle is not None]


def assert_on_the_grid(telemetry: Telemetry) -> None:
    """Every cycle began in the first quarter of a period, and skipped ones were counted."""
    cycles = kept(telemetry)
    period = round(float(telemetry.counts["period"]) * 1e9)
    for before, after in itertools.pairwise(cycles):
        gap = int(after["time"]) - int(before["time"])
        assert abs(gap - (1 + int(after["missed"])) * period) <= period / 4 + 1


@pytest.mark.parametrize("name", ["SIGTERM", "SIGINT", "SIGHUP"])
def test_a_signal_is_a_stop_that_was_asked_for(program: Path, lines: Lines, name: str) -> None:
    with running(program, lines.options) as run:
        run.await_cycles(20)
        status, out, err = run.end(signal.Signals[name])
        assert status == 0, err
        assert "cycles" in out and "bus base:" in out
        assert run.telemetry.ended


def await_sleep(pid: int) -> None:
    """Wait until a program waits for something."""
    while Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "S":
        time.sleep(0.001)


def test_a_second_signal_ends_the_program_at_once(program: Path, lines: Lines) -> None:
    with running(program, lines.options) as run:
        run.await_cycles(1)
        with lines.standstill():
            await_sleep(run.process.pid)  # for the clock: both signals come in one cycle
            run.process.send_signal(signal.SIGTERM)
            run.process.send_signal(signal.SIGINT)
        assert run.process.wait() == 1
        assert run.process.stderr is not None
        assert "ended at once" in run.process.stderr.read()


def test_so_many_cycles_are_run_and_no_more(program: Path, lines: Lines) -> None:
    with running(program, [*lines.options, "--cycles=50"]) as run:
        assert run.process.wait() == 0
        assert int(run.telemetry.status()["published"]) in (50, 51)


def test_without_drives_the_program_says_which_one_is_missing(program: Path, lines: Lines) -> None:
    with running(program, [*lines.options, "--arm"]) as run:
        run.await_state(FAULT)
        cause = run.telemetry.status()["cause"].decode()
        assert re.fullmatch(
            r"drive \w+ \(bus \w+, node \d\): did not boot, or does not answer; check power, .*",
            cause,
        )
        status, _out, err = run.end(signal.SIGTERM)
        assert status == 1
        assert err == f"turnbuckle-yoon2023: stopped: {cause}\n"


def test_a_line_that_disappears_is_a_fault_that_names_its_bus(program: Path, lines: Lines) -> None:
    with running(program, lines.options) as run:
        run.await_cycles(20)
        lines.unplug(1)
        run.await_state(FAULT)
        assert run.telemetry.status()["cause"].decode().startswith("bus cable2: ")
        status, _out, err = run.end(signal.SIGTERM)
        assert status == 1 and "bus cable2" in err


def test_a_stalled_program_counts_the_cycles_it_missed(program: Path, lines: Lines) -> None:
    with running(program, lines.real_time_options) as run:
        run.await_cycles(50)
        before = run.telemetry.status()["times"]
        run.process.send_signal(signal.SIGSTOP)
        stopped_for(run)
        run.process.send_signal(signal.SIGCONT)
        run.await_cycles(50)
        after = run.telemetry.status()["times"]
        assert int(after["longest_gap"]) >= 20
        assert int(after["missed"]) - int(before["missed"]) >= int(after["longest_gap"])
        assert int(after["lateness"]["bins"][-1]) >= 1
        assert int(after["lateness"]["most"]) >= 20e6
        assert_on_the_grid(run.telemetry)


def stopped_for(run: Running) -> None:
    """Let time pass for a program that stands still."""
    while "T" not in Path(f"/proc/{run.process.pid}/stat").read_text().rpartition(")")[2][:3]:
        time.sleep(0.001)
    time.sleep(0.05)


def test_every_wake_up_and_every_computation_is_in_the_histogram(
    program: Path, lines: Lines
) -> None:
    with running(program, [*lines.real_time_options, "--cycles=300"]) as run:
        run.process.wait()
        status = run.telemetry.status()
        for name in ("lateness", "computing"):
            histogram = status["times"][name]
            assert histogram["bins"].sum() == histogram["count"] == status["published"]
            assert 0 <= histogram["least"] <= histogram["sum"] / histogram["count"]
            assert histogram["sum"] / histogram["count"] <= histogram["most"]
        assert_on_the_grid(run.telemetry)


def options_of(lines: Lines, clock: str) -> list[str]:
    """The buses, and a simulation's clock if it shall be that."""
    return lines.options if clock == "simulated" else lines.real_time_options


@pytest.mark.parametrize("clock", CLOCKS)
def test_a_sealed_program_runs_and_stops(
    program: Path, lines: Lines, tmp_path: Path, clock: str
) -> None:
    dump = tmp_path / "dump"
    options = options_of(lines, clock)
    with running(program, [*options, "--seal", f"--record={dump}"]) as run:
        run.await_state(FAULT)  # bring-up, a fault and its words included
        status, out, err = run.end(signal.SIGTERM)
        assert status == 1, err
        assert "cycles" in out and "stopped: drive" in err
        assert dump.stat().st_size > 0


DEFECTS = {
    "heap": 'char *volatile copy = strdup("cycle"); free(copy);',
    "file": 'close(open("/dev/null", O_RDONLY));',
    "wait": "poll(NULL, 0, 0);",
    "scheduler": "sched_yield();",
    "lock": "syscall(SYS_futex, &(int){0}, FUTEX_WAKE, 1, NULL, NULL, 0);",
}
"""What a careless change could put into the loop."""


@pytest.fixture(scope="module")
def careless(stock_folder: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The executable with all defects in its loop; $DEFECT chooses one."""
    headers = ("fcntl", "linux/futex", "poll", "sched", "stdlib", "string", "sys/syscall", "unistd")
    includes = "#define _GNU_SOURCE\n" + "".join(f"#include <{name}.h>\n" for name in headers)
    lines = "".join(
        f'if (strcmp(getenv("DEFECT"), "{name}") == 0) {{ {line} }}\n'
        for name, line in DEFECTS.items()
    )
    text = (PORT / "loop.c").read_text()
    behind = "    tb_publish(loop, began);\n"
    assert behind in text
    source = tmp_path_factory.mktemp("careless") / "loop.c"
    source.write_text(includes + text.replace(behind, behind + lines))
    others = [path for folder in (stock_folder, *FOLDERS) for path in sorted(folder.glob("*.c"))]
    sources = [path for path in others if path != PORT / "loop.c"]
    return compile_program([*sources, source], [stock_folder, *FOLDERS])


@pytest.mark.parametrize("defect", DEFECTS)
def test_the_seal_breaks_where_the_loop_does_what_it_must_not(
    careless: Path, lines: Lines, monkeypatch: pytest.MonkeyPatch, defect: str
) -> None:
    monkeypatch.setenv("DEFECT", "none")
    with running(careless, [*lines.options, "--cycles=20", "--seal"]) as run:
        assert run.process.wait() == 0
    monkeypatch.setenv("DEFECT", defect)
    with running(careless, [*lines.options, "--cycles=20", "--seal"]) as run:
        assert run.process.wait() == -signal.SIGSYS


@pytest.mark.parametrize(
    ("clock", "sleep"), [("real", "clock_nanosleep"), ("simulated", "recvfrom")]
)
def test_strace_sees_only_sleep_and_frames_in_the_loop(
    program: Path, lines: Lines, tmp_path: Path, clock: str, sleep: str
) -> None:
    trace = tmp_path / "trace"
    wrapper = ["strace", "-f", "-o", str(trace)]
    with running(program, [*options_of(lines, clock), "--cycles=200"], wrapper) as run:
        run.process.wait()
    calls = [name for name in map(called, trace.read_text().splitlines()) if name]
    assert ("mlockall" in calls) == (clock == "real")
    first = calls.index(sleep, calls.index("mlockall") if clock == "real" else 0)
    last = len(calls) - 1 - calls[::-1].index(sleep)
    assert calls[first:last].count(sleep) >= 400
    assert set(calls[first:last]) <= CLOCKS[clock]


def called(line: str) -> str | None:
    """Name of the system call in a line of strace."""
    match = re.match(r"\d+ +(\w+)\(", line)
    return match[1] if match else None


@pytest.mark.parametrize("clock", CLOCKS)
def test_the_watchdog_hears_of_complete_cycles_alone(
    program: Path, lines: Lines, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, clock: str
) -> None:
    path = tmp_path / "notify"
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as systemd:
        systemd.bind(str(path))
        systemd.settimeout(60)
        monkeypatch.setenv("NOTIFY_SOCKET", str(path))
        monkeypatch.setenv("WATCHDOG_USEC", "30000")
        with running(program, options_of(lines, clock)) as run:
            assert [systemd.recv(100) for _ in range(3)] == [b"READY=1"] + [b"WATCHDOG=1"] * 2
            run.process.send_signal(signal.SIGSTOP)
            stopped_for(run)
            drain(systemd)
            systemd.settimeout(0.1)
            with pytest.raises(TimeoutError):
                systemd.recv(100)
            run.process.send_signal(signal.SIGCONT)
            systemd.settimeout(60)
            assert systemd.recv(100) == b"WATCHDOG=1"
            run.process.send_signal(signal.SIGTERM)
            assert run.process.wait() == 0
            assert drain(systemd)[-1] == b"STOPPING=1"


def drain(systemd: socket.socket) -> list[bytes]:
    """What waits in a socket."""
    systemd.setblocking(False)
    found = []
    try:
        while True:
            found.append(systemd.recv(100))
    except BlockingIOError:
        return found


def test_a_notify_socket_that_is_not_there_is_named(
    program: Path, lines: Lines, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("NOTIFY_SOCKET", "/run/no_such_socket")
    done = subprocess.run(
        [program, *lines.options, f"--telemetry={tmp_path / 'shared'}"],
        capture_output=True,
        text=True,
        env=os.environ,
    )
    assert done.returncode == 2
    assert "$NOTIFY_SOCKET /run/no_such_socket" in done.stderr
