"""The executable brings eight simulated drives up on SocketCAN, under a Linux kernel with CAN.

Both run inside the guest, in simulated time.
"""

import json
import pickle
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from guest import run_in_guest

from turnbuckle.codegen.bind import Generated, generate_into_cache
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.drives.wire import WIRES
from turnbuckle.lab.live.program import build_program
from turnbuckle.lab.live.simulated import Bench
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.control import base_targets

INSIDE = Path(__file__).with_name("bring_up_in_guest.py")
HEARTBEAT_LOST = 0x8130
BRISK = (
    ('name = "yoon2023"', 'name = "brisk"'),
    ('speed = "60 mm/s"', 'speed = "1.5 m/s"'),
    ('acceleration = "0.5 m/s^2"', 'acceleration = "12 m/s^2"'),
    ('current = "1 A"', 'current = "4 A"'),
    (
        "[plant]",
        '[calibration]\nsamples = 12\ninterval = "25 ms"\ntravel = "50 mm"\n\n'
        '[supervision]\nrail_speed = "12 m/s"\n\n[plant]',
    ),
)
"""What makes a bring-up of the stock machine short."""

Told = dict[str, Any]


@pytest.fixture(scope="module")
def story(stock_file: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Told]:
    """What the runs in the guest were like."""
    folder = tmp_path_factory.mktemp("brisk")
    return told_of(brisk(stock_file, folder), ("stopped", "killed", "unplugged"), folder)


def told_of(
    bench: Bench, runs: Sequence[str], folder: Path, seconds: float = 3600
) -> dict[str, Told]:
    """What these runs of a machine in the guest were like."""
    (folder / "bench").write_bytes(pickle.dumps(bench))
    done = run_in_guest(
        [sys.executable, INSIDE, build_program(bench.machine), folder / "bench", *runs],
        interfaces=[f"vcan{number}" for number in range(len(bench.machine.buses))],
        seconds=seconds,
    )
    assert done.status == 0, done.output
    told: dict[str, Told] = json.loads(done.output.splitlines()[-1])
    return told


def brisk(stock_file: Path, folder: Path) -> Bench:
    """The stock machine with a quick homing, its bases about the handle."""
    text = stock_file.read_text()
    for old, new in BRISK:
        assert text.count(old) == 1
        text = text.replace(old, new)
    file = folder / "brisk.toml"
    file.write_text(text)
    machine = load_machine(file)
    task = plan_task(Generated(machine, generate_into_cache(machine), "double"))
    rails = [float(s) for s in base_targets(machine, task.path.at(0.0)[0])]
    return Bench(machine, plant_of(machine), task, rails, WIRES["worst"])


def test_eight_drives_are_brought_from_power_on_to_work_and_stopped(
    story: dict[str, Told],
) -> None:
    told = story["stopped"]
    up = ["INIT", "IDENTIFY", "CONFIGURE", "HOME", "TENSION", "RUN", "SOFT_STOP"]
    assert told["states"][: len(up)] == up, told
    assert told["pulled"] and told["status"] == 0, told
    assert told["drives"] == 8 * [["OFF", 0, 0.0]]


def test_no_frame_is_lost_and_no_setpoint_missing_or_twice(story: dict[str, Told]) -> None:
    told = story["stopped"]
    assert told["findings"] == [] and told["setpoints"] > 10_000
    assert told["said"].count(" 0 refused, 0 lost, 0 malformed, 0 bus errors") == 3, told["said"]


def test_drives_of_a_killed_program_switch_themselves_off(story: dict[str, Told]) -> None:
    told = story["killed"]
    assert told["pulled"] and told["status"] == -9
    assert told["drives"] == 8 * [["FAULT", HEARTBEAT_LOST, 0.0]]


def test_an_interface_that_goes_down_stops_the_machine(story: dict[str, Told]) -> None:
    told = story["unplugged"]
    assert told["pulled"] and told["states"][-1] == "HARD_STOP"
    assert "cable2" in told["cause"] and "off, or its device has gone" in told["cause"]
    assert told["status"] == 1
    # The heartbeat stops until every drive is off; those behind the interface are never seen off.
    assert told["drives"] == 8 * [["FAULT", HEARTBEAT_LOST, 0.0]]
