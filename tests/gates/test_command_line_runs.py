"""The long commands as a user runs them, from another folder, with their real work."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.generate import render
from turnbuckle.codegen.model import Model
from turnbuckle.command_line import app
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
TURNBUCKLE = Path(sys.executable).with_name("turnbuckle")


def execute(folder: Path, *arguments: str | Path) -> subprocess.CompletedProcess[str]:
    """Run the installed command in a folder, its output piped, as on a narrow terminal."""
    return subprocess.run(
        [TURNBUCKLE, *arguments],
        cwd=folder,
        env=os.environ | {"COLUMNS": "80"},
        capture_output=True,
        text=True,
        check=False,
    )


def test_the_stock_machine_passes_verification(tmp_path: Path) -> None:
    done = execute(tmp_path, "verify", STOCK, "--points", "200", "--json")
    assert (done.returncode, done.stderr) == (0, "")
    report = json.loads(done.stdout)
    assert report["passed"] is True
    assert {row["precision"] for row in report["rows"]} == {"double", "float"}
    assert not list(tmp_path.iterdir())


def test_a_wrong_sign_in_the_generated_c_fails_verification(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def seeded(model: Model, accuracies: dict[str, Accuracy]) -> dict[str, str]:
        files = render(model, accuracies)
        right, wrong = "TB_WALL_1_STIFFNESS", "-TB_WALL_1_STIFFNESS"
        assert right in files["tb_control.c"]
        return files | {"tb_control.c": files["tb_control.c"].replace(right, wrong, 1)}

    path = tmp_path / "seeded.toml"
    path.write_text(STOCK.read_text().replace('"yoon2023"', '"seeded"'))
    monkeypatch.setattr("turnbuckle.codegen.verify.render", seeded)
    result = CliRunner().invoke(app, ["verify", str(path), "--points", "200"])
    assert result.exit_code == 1
    assert "FAILED wall_force, force, double" in result.stdout


def test_the_demo_leaves_a_table_and_a_picture(tmp_path: Path) -> None:
    done = execute(tmp_path, "demo", STOCK, "--out", "pictures [new] Δ")
    assert (done.returncode, done.stderr) == (0, "")
    assert "\x1b" not in done.stdout
    picture = Path("pictures [new] Δ") / f"{load_machine(STOCK).name}.png"
    assert done.stdout.splitlines()[-1] == f"picture: {picture}"
    assert (tmp_path / picture).read_bytes().startswith(b"\x89PNG")


def test_a_picture_that_cannot_be_written_is_told_in_words(tmp_path: Path) -> None:
    (tmp_path / "pictures").write_text("a file, not a folder")
    done = execute(tmp_path, "demo", STOCK, "--out", "pictures")
    assert done.returncode == 2
    assert done.stderr.startswith("turnbuckle: pictures")
    assert done.stderr.count("\n") == 1
