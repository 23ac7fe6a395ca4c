"""`turnbuckle optimise`: what it writes, says and refuses."""

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

import turnbuckle.lab.design.search
from turnbuckle.command_line import app
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
DIAGONAL = ROOT / "tests" / "machines" / "fixed_diagonal.toml"
TURNBUCKLE = Path(sys.executable).with_name("turnbuckle")
MIRRORED = "cable[2].base[1],cable[3].base[1]=300 mm..506 mm"
NOTHING_BETTER, INTERRUPTED = 3, 130


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Tests run in an empty folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def optimise(*arguments: str | Path) -> Result:
    """Run `turnbuckle optimise` in this process."""
    return CliRunner().invoke(app, ["optimise", *map(str, arguments)], env={"COLUMNS": "100"})


def assert_refused(result: Result, *words: str, status: int = 2) -> None:
    """The exit status, nothing on stdout, one message on stderr that holds the words."""
    assert result.exit_code == status, result.stderr
    assert result.stdout == ""
    assert result.stderr.count("\n") == 1
    assert result.stderr.startswith("turnbuckle: ")
    for word in words:
        assert word in result.stderr


def test_a_better_machine_is_written_and_told(folder: Path) -> None:
    result = optimise(DIAGONAL, "--vary", MIRRORED, "--search", "local", "--out", "new/better.toml")
    assert (result.exit_code, result.stderr) == (0, "")
    machine = load_machine(folder / "new" / "better.toml")
    x, _ = machine.base_motions[1].start
    assert f"{x * 1e3:.7g} mm" in result.stdout
    assert "least isotropic force [N]" in result.stdout
    assert "new/better.toml: written, the best of " in result.stdout


def test_the_default_name_says_which_machine_it_is(folder: Path) -> None:
    assert optimise(DIAGONAL, "--vary", MIRRORED, "--search", "local").exit_code == 0
    assert [path.name for path in folder.iterdir()] == ["fixed_diagonal_optimised.toml"]


def test_the_same_command_writes_the_same_bytes(folder: Path) -> None:
    for name in ("one.toml", "two.toml"):
        done = subprocess.run(
            [
                TURNBUCKLE,
                "optimise",
                DIAGONAL,
                "--vary",
                MIRRORED,
                "--goal",
                "motor",
                "--out",
                name,
            ],
            env=os.environ | {"PYTHONHASHSEED": str(len(name) + ord(name[0]))},
            capture_output=True,
            text=True,
        )
        assert (done.returncode, done.stderr) == (0, "")
        assert "\x1b" not in done.stdout
    assert (folder / "one.toml").read_bytes() == (folder / "two.toml").read_bytes()


def test_nothing_better_has_a_status_of_its_own_and_writes_nothing(folder: Path) -> None:
    vary = "cable[1].rail.from[1]=0 mm..100 mm"
    result = optimise(STOCK, "--vary", vary, "--search", "local")
    words = ["better than the file's own", "7; nothing written"]
    assert_refused(result, str(STOCK), *words, status=NOTHING_BETTER)
    assert not list(folder.iterdir())


def test_a_target_that_no_pose_covers_has_that_status_too(folder: Path) -> None:
    vary = "cable[2].base[1],cable[3].base[1]=60 mm..100 mm"
    result = optimise(DIAGONAL, "--vary", vary)
    assert_refused(result, "hold the platform in 0% of the target", status=NOTHING_BETTER)
    assert not list(folder.iterdir())


@pytest.mark.parametrize(
    ("vary", "words"),
    [
        ("tension.maximum=1 N..2 N", ["tension.maximum", "no such key", "did you mean"]),
        ("tension.max=8..15", ["tension.max", '"8", a number without a unit']),
        ("tension.max=15 N..8 N", ["LOW less than HIGH"]),
        ("machine.name=1 N..8 N", ['found "yoon2023"', "a key that is a quantity"]),
        ("tension.max=8 N..15 N:4", ["found a COUNT", "study"]),
        ("tension.min=20 N..30 N", ["none of the", "tension.min", "below tension.max"]),
    ],
)
def test_a_wrong_range_is_one_message(vary: str, words: list[str], folder: Path) -> None:
    assert_refused(optimise(STOCK, "--vary", vary, "--search", "local"), *words)
    assert not list(folder.iterdir())


def test_an_existing_file_is_kept_unless_told_otherwise(folder: Path) -> None:
    path = folder / "mine.toml"
    path.write_text("mine")
    arguments: list[str | Path] = [DIAGONAL, "--vary", MIRRORED, "--search", "local", "--out", path]
    assert_refused(optimise(*arguments), "mine.toml", "exists already", "--force")
    assert path.read_text() == "mine"
    assert optimise(*arguments, "--force").exit_code == 0
    load_machine(path)
    assert_refused(optimise(*arguments[:-1], folder, "--force"), "is a folder")


def test_a_full_disk_leaves_nothing(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    result = optimise(DIAGONAL, "--vary", MIRRORED, "--search", "local", "--out", "new.toml")
    assert_refused(result, "new.toml: cannot be written: No space left on device")
    assert not list(folder.iterdir())


def test_an_interrupt_while_searching_is_told(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(turnbuckle.lab.design.search, "global_search", interrupt)
    result = optimise(DIAGONAL, "--vary", MIRRORED)
    assert (result.exit_code, result.stderr) == (INTERRUPTED, "turnbuckle: interrupted\n")
    assert not list(folder.iterdir())
