"""How much of the lines and branches of runtime/core and runtime/canopen the tests go through."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[2]
RUNTIME = ROOT / "runtime"
FOLDERS = ("core", "canopen")
SUPERVISOR = ("causes", "limits", "without_rails", "one_rail", "words")
UNIT = [
    *("supervisor", *(f"supervisor_{name}" for name in SUPERVISOR), "directions", "guide"),
    *("carriage", "measurement", "flight", "controller_step"),
    *("canopen_messages", "emcy", "cia402"),
]
TESTS = [
    *(f"tests/unit/test_{name}.py" for name in UNIT),
    *(f"tests/equivalence/test_{name}.py" for name in ("calibration", "watch")),
    *(f"tests/wire/test_{name}.py" for name in ("sdo", "drive_setup", "network", "master")),
]
#: Controls of the tests themselves, and what goes where others go already.
LEFT_OUT = "seeded or changed or replay or log or float or no_order"


class Share(NamedTuple):
    """Percent of a file that was run."""

    lines: float
    branches: float


#: Files in which an outcome of a condition is not reached, mostly a count at the end of its range.
LEAST = {
    "canopen/drive_link.c": Share(100.0, 96.0),
    "canopen/echo.c": Share(100.0, 95.0),
    "canopen/network.c": Share(100.0, 96.0),
    "canopen/nmt.c": Share(100.0, 94.0),
    "canopen/sdo.c": Share(100.0, 96.0),
    "core/calibration.c": Share(100.0, 98.0),
    "core/controller.c": Share(100.0, 97.0),
    "core/drive_orders.c": Share(100.0, 97.0),
    "core/measurement.c": Share(100.0, 95.0),
    "core/pose_space.c": Share(100.0, 90.0),
    "core/recorder.c": Share(100.0, 92.0),
    "core/watch.c": Share(100.0, 95.0),
}

#: Files that hold tables alone.
WITHOUT_CODE = {"core/identity.c", "core/recording_layout.c"}


def coverage(folder: Path, *tests: str) -> dict[str, Share]:
    """What these tests go through of every C file of core and canopen."""
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", "no:xdist"]
    environment = os.environ | {"TURNBUCKLE_COVERAGE": str(folder), "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [*command, *tests], cwd=ROOT, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout
    report = folder / "report.json"
    gcovr = [sys.executable, "-m", "gcovr", "--root", str(RUNTIME), "--json-summary", str(report)]
    merge = "--merge-mode-functions=separate"  # machines with rails and without have their own
    subprocess.run([*gcovr, merge, str(folder)], cwd=folder, check=True, capture_output=True)
    return {
        file["filename"]: Share(file["line_percent"], file["branch_percent"] or 100.0)
        for file in json.loads(report.read_text())["files"]
        if file["filename"].endswith(".c")
    }


def test_the_tests_go_through_the_runtime(tmp_path: Path) -> None:
    reached = coverage(tmp_path, "-k", f"not ({LEFT_OUT})", *TESTS)
    files = [
        path.relative_to(RUNTIME).as_posix()
        for name in FOLDERS
        for path in (RUNTIME / name).glob("*.c")
    ]
    files = [file for file in files if file not in WITHOUT_CODE]
    assert {file: reached[file] for file in files if is_missed(file, reached[file])} == {}


def is_missed(file: str, reached: Share) -> bool:
    """Whether less of a file is reached than should be."""
    least = LEAST.get(file, Share(100.0, 100.0))
    return reached.lines < least.lines or reached.branches < least.branches


def test_fewer_tests_are_found_to_miss_something(tmp_path: Path) -> None:
    one = "tests/unit/test_supervisor.py::test_the_pose_is_known_after_the_bring_up"
    assert coverage(tmp_path, one)["core/faults.c"].branches < 80.0
