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

from lab.live import LiveError
from lab.live.telemetry import Telemetry
from lab.live.words import STATES

ROOT = Path(__file__).parents[2]
COMMAND = [sys.executable, str(ROOT / "turnbuckle.py")]
PACE = 4
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
    """Whether the application asked for a force in the cycles of work that were looked at."""


@pytest.fixture(scope="module")
def file(stock_file: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The stock machine with quicker homing, and patient with a busy computer."""
    text = stock_file.read_text()
    for old, new in (
        ('name = "yoon2023"', 'name = "patient"'),
        ('speed = "60 mm/s"', 'speed = "250 mm/s"'),
        ('acceleration = "0.5 m/s^2"', 'acceleration = "2 m/s^2"'),
        ('current = "1 A"', 'current = "1.5 A"'),
        ("[plant]", "[supervision]\nmissed_syncs = 20\nskipped_cycles = 20\n\n[plant]"),
    ):
        assert old in text
        text = text.replace(old, new, 1)
    path = tmp_path_factory.mktemp("machine") / "patient.toml"
    path.write_text(text)
    return path


@pytest.fixture(scope="module")
def story(file: Path) -> Iterator[Story]:
    """One run: brought up, watched, stopped by the monitor."""
    shared, record = Path(f"/dev/shm/turnbuckle-sim-{os.getpid()}"), file.with_name("dump")
    words = ["--sim", "--arm", f"--pace={PACE}", f"--telemetry={shared}", f"--record={record}"]
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
    """Wait until the machine has worked for a while; whether a force was asked for meanwhile."""
    telemetry = await_state(process, shared, "RUN")
    first = telemetry.latest()
    assert first is not None
    asked = []
    while (cycle := telemetry.latest()) is not None and cycle["number"] < first["number"] + WORK:
        asked.append(bool(cycle["drives"]["ordered_torque"].any()))
        time.sleep(0.01)
    telemetry.close()
    return asked


def await_state(process: "subprocess.Popen[str]", shared: Path, name: str) -> Telemetry:
    """Wait until the machine is in a state; its telemetry."""
    while process.poll() is None:
        time.sleep(0.05)
        try:
            telemetry = Telemetry(shared)
        except LiveError:
            continue
        cycle = telemetry.latest()
        if cycle is not None and cycle["state"] == STATES.index(name):
            return telemetry
        if cycle is not None and cycle["state"] == STATES.index("FAULT"):
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


def test_the_report_tells_cycles_times_and_buses(story: Story) -> None:
    for words in ("cycles,", "late ", "computing ", "bus cable1:", "bus cable2:", "bus base:"):
        assert words in story.told


def test_the_monitor_shows_the_machine_at_work(story: Story) -> None:
    for words in ("patient", "RUN", "pose", "cable_1", "base_4", "enabled", "frames/s", "@"):
        assert words in story.picture


def test_what_the_executable_recorded_runs_again_to_the_bit(story: Story, file: Path) -> None:
    assert story.record.read_bytes()[:8] == b"TBFLIGHT"
    replay = [*COMMAND, "replay", str(story.record), str(file)]
    done = subprocess.run(replay, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert "to the bit" in done.stdout
