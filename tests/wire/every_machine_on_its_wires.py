"""Every stock machine with buses on the worst wires that its proof allows, with the real program.

Not collected by itself, because it takes long: `make soak` runs it.
"""

import subprocess
import sys
from pathlib import Path

import pytest
from test_bring_up_on_vcan import told_of

from turnbuckle.lab.drives.wire import WIRES
from turnbuckle.lab.live.run import bench_of
from turnbuckle.model.reading import load_machine
from turnbuckle.places import MACHINES

WITH_BUSES = [path for path in sorted(MACHINES.glob("*.toml")) if load_machine(path).buses]
each_machine = pytest.mark.parametrize("path", WITH_BUSES, ids=lambda path: path.stem)


@each_machine
def test_a_machine_comes_to_work_and_stops_on_serial_lines(path: Path, tmp_path: Path) -> None:
    words = ["--sim", "--wire=worst", "--arm", "--seconds=60", f"--telemetry={tmp_path / 'shared'}"]
    done = subprocess.run(
        [sys.executable, "-m", "turnbuckle", "run", path, *words],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert "RUN" in done.stdout and "cycles, 0 missed" in done.stdout


@each_machine
def test_a_machine_comes_to_work_and_stops_on_interfaces_of_the_kernel(
    path: Path, tmp_path: Path
) -> None:
    machine = load_machine(path)
    bench = bench_of(machine)._replace(conditions=WIRES["worst"])
    told = told_of(bench, ["stopped"], tmp_path, seconds=7200)["stopped"]
    assert "RUN" in told["states"] and told["pulled"] and told["status"] == 0, told
    assert told["findings"] == []
    assert told["drives"] == len(machine.drives) * [["OFF", 0, 0.0]]
