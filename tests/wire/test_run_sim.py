"""`turnbuckle run --sim`: the real executable brings simulated drives up over serial lines."""

import os
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from running import PATIENCE

from turnbuckle.lab.live import LiveError
from turnbuckle.lab.live.telemetry import Telemetry
from turnbuckle.lab.lockstep import State

ROOT = Path(__file__).parents[2]
COMMAND = [sys.executable, "-m", "turnbuckle"]
WORK = 300
"""Cycles of work before the stop."""


class Story(NamedTuple):
    """What a run was like, from power-on to the end."""

    status: int
    told: str
    complaints: str
    picture: str
    record: Path
    task: list[bool]
    """Whether a torque was ordered, in the cycles of work that were looked at."""


@pytest.fixture(scope="module")
def file(stock_file: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The stock machine with quicker homing."""
    text = stock_file.read_text()
    for old, new in (
        ('name = "yoon2023"', 'name = "quick"'),
        ('speed = "60 mm/s"', 'speed = "250 mm/s"'),
        ('acceleration = "0.5 m/s^2"', 'acceleration = "2 m/s^2"'),
        ('current = "1 A"', 'current = "1.5 A"'),
    ):
        assert old in text
        text = text.replace(old, new, 1)
    path = tmp_path_factory.mktemp("machine") / "quick.toml"
    path.write_text(text)
    return path


@pytest.fixture(scope="module")
def story(file: Path) -> Iterator[Story]:
    """One run: brought up, watched, stopped by the monitor."""
    shared, record = Path(f"/dev/shm/turnbuckle-sim-{os.getpid()}"), file.with_name("dump")
    words = ["--sim", "--wire=worst", "--arm", f"--telemetry={shared}", f"--record={record}"]
    with subprocess.Popen(
        [*COMMAND, "run", file, *words], text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        try:
            task = await_work(process, shared)
            watch = [*COMMAND, "monitor", str(file), f"--telemetry={shared}"]
            picture = subprocess.run([*watch, "--once"], capture_output=True, text=True).stdout
            subprocess.run([*watch, "--stop"], check=True)
            subprocess.run([*watch, "--stop"], check=True)
            await_state(process, shared, "CONFIGURE")
            process.terminate()
            told, complaints = process.communicate(timeout=PATIENCE)
        finally:
            process.kill()
            shared.unlink(missing_ok=True)
    yield Story(process.returncode, told, complaints, picture, record, task)


def await_work(process: "subprocess.Popen[str]", shared: Path) -> list[bool]:
    """Wait until the machine has worked for a while; whether a torque was ordered in the last
    cycles of it that can still be seen."""
    telemetry = await_state(process, shared, "RUN")
    first = telemetry.latest()
    assert first is not None
    while (last := telemetry.latest()) is not None and last["number"] < first["number"] + WORK:
        time.sleep(0.01)
    assert last is not None
    cycles = [telemetry.cycle(int(last["number"]) - back) for back in range(WORK)]
    telemetry.close()
    return [bool(cycle["drives"]["ordered_torque"].any()) for cycle in cycles if cycle is not None]


def await_state(process: "subprocess.Popen[str]", shared: Path, name: str) -> Telemetry:
    """Wait until the machine is in a state; its telemetry."""
    while process.poll() is None:
        time.sleep(0.05)
        try:
            telemetry = Telemetry(shared)
        except LiveError:
            continue
        cycle = telemetry.latest()
        if cycle is not None and cycle["state"] == State[name]:
            return telemetry
        if cycle is not None and cycle["state"] == State.FAULT:
            pytest.fail(telemetry.status()["cause"].decode())
        telemetry.close()
    pytest.fail(str(process.communicate()))


def test_all_states_are_gone_through_in_order(story: Story) -> None:
    states = re.findall(r"^ *[\d.]+ s  (\w+)", story.told, re.MULTILINE)
    assert states == [
        *("INIT", "IDENTIFY", "CONFIGURE", "HOME", "TENSION", "RUN", "SOFT_STOP", "CONFIGURE")
    ]


def test_cables_pull_while_the_machine_works(story: Story) -> None:
    assert story.task and all(story.task)


def test_a_stop_that_was_asked_for_ends_without_a_complaint(story: Story) -> None:
    assert story.status == 0, story.complaints
    assert "stopped" not in story.complaints


def test_the_report_tells_that_no_cycle_was_missed_and_no_frame_lost(
    story: Story,
) -> None:
    for words in ("cycles, 0 missed", "bus cable1:", "bus cable2:", "bus base:"):
        assert words in story.told
    assert story.told.count(" 0 refused, 0 lost, 0 malformed, 0 bus errors") == 3


def test_the_monitor_shows_the_machine_at_work(story: Story) -> None:
    for words in (
        "quick",
        "in simulated time",
        "RUN",
        "pose",
        "cable_1",
        "base_4",
        "enabled",
        "frames/s",
        "@",
    ):
        assert words in story.picture


def test_what_the_executable_recorded_runs_again_to_the_bit(story: Story, file: Path) -> None:
    assert story.record.read_bytes()[:8] == b"TBFLIGHT"
    replay = [*COMMAND, "replay", str(story.record), str(file)]
    done = subprocess.run(replay, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert "to the bit" in done.stdout


def test_a_fault_ends_the_run_at_once_with_its_cause(file: Path) -> None:
    hasty = file.with_name("hasty.toml")
    text = file.read_text().replace('name = "quick"', 'name = "hasty"', 1)
    hasty.write_text(text.replace("[plant]", '[supervision]\ncable_speed = "1 mm/s"\n\n[plant]', 1))
    words = ["--sim", "--arm", "--seconds=100000", "--telemetry", f"/dev/shm/hasty-{os.getpid()}"]
    done = subprocess.run([*COMMAND, "run", hasty, *words], capture_output=True, text=True)
    assert done.returncode == 1
    assert re.search(r" s  HARD_STOP\n.* s +drive cable_\d .* jumped", done.stdout), done.stdout
    assert re.search(r"stopped: drive cable_\d .* jumped", done.stderr.splitlines()[-1])
