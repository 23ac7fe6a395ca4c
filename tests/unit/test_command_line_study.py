"""`turnbuckle study`: the real command, with workers of its own."""

import csv
import os
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from typer.testing import CliRunner

from turnbuckle.command_line import app
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
DIAGONAL = ROOT / "tests" / "machines" / "fixed_diagonal.toml"
TURNBUCKLE = Path(sys.executable).with_name("turnbuckle")
INTERRUPTED = 130
GRID = ["--vary", "cable[2].base[1]=400 mm..506 mm:200"]


def command(folder: Path, *arguments: str | Path) -> list[str | Path]:
    """The command line of a study into a folder."""
    return [TURNBUCKLE, "study", DIAGONAL, "--out", folder, *arguments]


def points_in(folder: Path) -> list[int]:
    """Points of which there are results, in order."""
    rows = csv.DictReader((folder / "results.csv").read_text().splitlines())
    return sorted(int(row["point"]) for row in rows)


def test_a_study_leaves_a_table_and_the_best_machine(tmp_path: Path) -> None:
    folder = tmp_path / "a study"
    vary = ["--vary", "tension.max=8 N..12 N:5", "--vary", "tension.min=1 N..3 N:3"]
    arguments: list[str | Path] = [TURNBUCKLE, "study", STOCK, "--out", folder, *vary]
    done = subprocess.run(arguments, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert f"{folder}: 15 machines judged, 6 cannot be\n" in done.stdout
    assert points_in(folder) == list(range(15))
    best = load_machine(folder / "best.toml")
    assert (best.tension.min, best.tension.max) == (
        1,
        10,
    )  # the torque limit ends what T_max may be


def test_an_interrupt_from_the_terminal_keeps_results_and_the_study_goes_on(tmp_path: Path) -> None:
    folder = tmp_path / "study"
    process = subprocess.Popen(
        command(folder, *GRID),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    table = folder / "results.csv"
    while process.poll() is None and not (table.exists() and table.read_bytes().count(b"\n") > 20):
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to the workers too
    output, errors = process.communicate(timeout=60)
    kept = len(points_in(folder))
    assert 20 <= kept < 200
    assert (process.returncode, output) == (INTERRUPTED, "")
    assert errors == (
        f"turnbuckle: interrupted; {folder}: {kept} results are kept: run the same command again"
        " to go on\n"
    )
    done = subprocess.run(command(folder, *GRID), capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert points_in(folder) == list(range(200))


def test_a_full_disk_keeps_results_and_the_study_goes_on(tmp_path: Path) -> None:
    folder = tmp_path / "study"
    grid = ["--vary", "cable[2].base[1]=400 mm..506 mm:60"]

    def little_room() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (3000, 3000))

    full = subprocess.run(
        command(folder, *grid), capture_output=True, text=True, preexec_fn=little_room
    )
    kept = len(points_in(folder))
    assert 0 < kept < 60
    assert full.returncode == 2
    assert full.stderr.startswith(f"turnbuckle: {folder}/results.csv: cannot be written: ")
    assert f"; {kept} results are kept" in full.stderr
    assert full.stderr.count("\n") == 1
    done = subprocess.run(command(folder, *grid), capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert points_in(folder) == list(range(60))


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--vary", "tension.max=8 N..9 N"], "--vary tension.max: found no COUNT"),
        (["--vary", "tension.maxx=8 N..9 N:3"], "--vary tension.maxx: found no such key"),
        (
            [*GRID, "--scheduler", "tcp://127.0.0.1:1"],
            "--scheduler tcp://127.0.0.1:1: no Dask scheduler answers there",
        ),
        ([*GRID, "--scheduler", "nonsense"], "--scheduler nonsense: no Dask scheduler"),
    ],
)
def test_what_cannot_be_is_one_message_and_leaves_nothing(
    tmp_path: Path, arguments: list[str], words: str
) -> None:
    folder = tmp_path / "study"
    result = CliRunner().invoke(app, ["study", str(DIAGONAL), "--out", str(folder), *arguments])
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.startswith("turnbuckle: ")
    assert result.stderr.count("\n") == 1
    assert words in result.stderr
    assert not folder.exists()


def test_a_folder_with_other_content_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("mine")
    arguments = ["study", str(DIAGONAL), "--out", str(tmp_path), *GRID]
    result = CliRunner().invoke(app, arguments)
    assert result.exit_code == 2
    assert "holds files and no study.json" in result.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.tex"]
