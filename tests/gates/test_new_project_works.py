"""A new machine's folder does what it says: its tests pass, and notice what is wrong."""

import subprocess
import sys
from pathlib import Path

import pytest

from turnbuckle.codegen.project.project import new_project


def make(folder: Path, *targets: str) -> subprocess.CompletedProcess[str]:
    """Run the folder's make with the Python that runs the tests."""
    return subprocess.run(
        ["make", f"PYTHON={sys.executable}", *targets],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )


def project(source: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(folder)
    return folder / new_project("arm", source)


def change(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))


def test_the_tests_of_a_new_machine_with_buses_pass(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    arm = project("yoon_fixed_diagonal", tmp_path, monkeypatch)
    assert make(arm).returncode == 0
    done = make(arm, "test")
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.count("mm into the wall") == 3
    assert done.stdout.count("500 cycles at work") == 3
    nothing = "    force[1] = TB_C(0.0);\n    return TB_OK;"
    change(arm / "generated" / "tb_control.c", nothing, nothing.replace("0.0", "0.1"))
    assert "axis 1: walls and application" in make(arm, "live").stdout


@pytest.mark.parametrize("source", ["brau_tetrahedron", "planar_rigid", "spidar_g"])
def test_a_wall_is_felt_with_every_kind_of_machine(
    source: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    done = make(project(source, tmp_path, monkeypatch), "walls")
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.count("mm into the wall") == 3


@pytest.fixture
def square(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder whose C is as it should be."""
    arm = project("brau_square", tmp_path, monkeypatch)
    assert make(arm, "generate", "drift").returncode == 0
    return arm


def test_drift_is_noticed_and_made_good_by_make(square: Path) -> None:
    for changed, old, new in (
        ("arm.toml", '"10 N"', '"9 N"'),
        ("generated/tb_control.c", "TB_C(0.0)", "TB_C(0.1)"),
        ("runtime/core/torque_gate.c", "<", "<="),
    ):
        change(square / changed, old, new)
        done = make(square, "drift")
        assert done.returncode != 0
        assert "is not up to date: run make" in done.stderr
        assert make(square, "generate", "drift").returncode == 0


def test_torques_that_are_too_small_are_felt_at_the_wall(square: Path) -> None:
    change(
        square / "runtime" / "core" / "controller.c",
        "tb_torque_gate(controller->torque[i], command,",
        "tb_torque_gate(controller->torque[i], TB_C(0.8) * command,",
    )
    done = make(square, "walls")
    assert done.returncode != 0
    assert "mm into the wall" in done.stdout
