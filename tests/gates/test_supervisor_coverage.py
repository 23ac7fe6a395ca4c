"""The tests of gate and supervisor go through every line and every branch of them."""

import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
CORE = ROOT / "runtime" / "core"
TESTS = ["test_supervisor.py", "test_supervisor_causes.py", "test_supervisor_limits.py"]
TESTS += ["test_supervisor_without_rails.py", "test_supervisor_words.py", "test_directions.py"]
#: What these tests are about; calibration, watch and controller have their own.
FILES = ["torque_gate", "setpoints", "measurement", "guide", "hold", "drive_orders", "faults"]
FILES += [
    "bring_up",
    "homing",
    "direction",
    "carriage",
    "sweep",
    "work",
    "stopping",
    "supervisor",
    "words",
]


def coverage(folder: Path, *tests: str) -> dict[str, tuple[float, float]]:
    """Percent of lines and of branches of every file, after these tests."""
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", "no:xdist"]
    environment = os.environ | {"TURNBUCKLE_COVERAGE": str(folder), "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [*command, *tests], cwd=ROOT, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout
    report = folder / "report.json"
    gcovr = [sys.executable, "-m", "gcovr", "--root", str(CORE), "--json-summary", str(report)]
    merge = "--merge-mode-functions=separate"  # machines with rails and without have their own
    subprocess.run([*gcovr, merge, str(folder)], cwd=folder, check=True, capture_output=True)
    files = json.loads(report.read_text())["files"]
    return {
        Path(file["filename"]).stem: (file["line_percent"], file["branch_percent"] or 100.0)
        for file in files
    }


def test_every_line_and_branch_of_gate_and_supervisor_is_tested(tmp_path: Path) -> None:
    one = "tests/unit/test_supervisor.py::test_the_pose_is_known_after_the_bring_up"
    after_one = coverage(tmp_path, one)
    assert after_one["faults"][1] < 80.0, "fewer tests must be found to miss something"
    reached = coverage(tmp_path, *(f"tests/unit/{name}" for name in TESTS))
    assert {name: reached[name] for name in FILES} == dict.fromkeys(FILES, (100.0, 100.0))
