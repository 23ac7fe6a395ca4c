"""`turnbuckle generate`: what it writes, where, and what it leaves alone."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

import turnbuckle.codegen.generate
from turnbuckle.codegen.generate import generate
from turnbuckle.command_line import app
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
TURNBUCKLE = Path(sys.executable).with_name("turnbuckle")


@pytest.fixture(scope="module")
def files() -> dict[str, str]:
    """The generated files of the stock machine."""
    return generate(load_machine(STOCK))


@pytest.fixture(scope="module")
def left() -> dict[str, str]:
    """The same with the prefix `left`."""
    return generate(load_machine(STOCK), "left")


@pytest.fixture
def run(
    files: dict[str, str], left: dict[str, str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> Path:
    """Generation takes no time in these tests; they run in an empty folder."""
    known = {"tb": files, "left": left}
    monkeypatch.setattr(
        turnbuckle.codegen.generate, "generate", lambda machine, prefix, before: known[prefix]
    )
    monkeypatch.chdir(tmp_path)
    return tmp_path


def invoke(*arguments: str | Path) -> Result:
    """Run `turnbuckle generate` in this process, successfully."""
    result = CliRunner().invoke(app, ["generate", *map(str, arguments)])
    assert result.exit_code == 0, result.stderr
    return result


def read(folder: Path) -> dict[str, str]:
    """Contents of a folder by name."""
    paths = [path for path in folder.rglob("*") if path.is_file()]
    return {path.relative_to(folder).as_posix(): path.read_text() for path in paths}


def test_the_c_goes_to_generated_and_the_name(run: Path, files: dict[str, str]) -> None:
    invoke(STOCK)
    assert read(run / "generated" / "yoon2023") == files


def test_another_folder_may_be_named(run: Path, files: dict[str, str]) -> None:
    invoke(STOCK, "--out", "firmware/control [new]")
    assert read(run / "firmware" / "control [new]") == files


def test_what_was_written_is_told(run: Path, files: dict[str, str]) -> None:
    output = invoke(STOCK).stdout
    manifest = json.loads(files["manifest.json"])
    for name in files:
        assert name in output
    assert manifest["hash"] in output
    assert f"{len(manifest['functions']) + len(manifest['aliases'])} functions" in output


def written(folder: Path) -> dict[Path, tuple[int, int]]:
    """Which files there are, and when each was written; when it was read does not count."""
    stats = {path: path.stat() for path in [folder, *folder.rglob("*")]}
    return {path: (found.st_ino, found.st_mtime_ns) for path, found in stats.items()}


@pytest.mark.parametrize("prefix", [[], ["--prefix", "left"]], ids=["plain", "left"])
def test_unchanged_files_are_left_alone(run: Path, prefix: list[str]) -> None:
    invoke(STOCK, *prefix)
    (folder,) = (run / "generated").iterdir()
    before = written(folder)
    assert "nothing changed" in invoke(STOCK, *prefix).stdout
    assert written(folder) == before


def test_a_prefix_has_a_folder_of_its_own_with_the_runtime(run: Path, left: dict[str, str]) -> None:
    invoke(STOCK, "--prefix", "left")
    assert read(run / "generated" / "left_yoon2023") == left
    assert {"left_tension.c", "left_master.c", "linux/left_socketcan.c"} <= left.keys()


def test_a_damaged_file_in_a_folder_of_the_folder_is_written_again(
    run: Path, left: dict[str, str]
) -> None:
    invoke(STOCK, "--prefix", "left", "--out", "mine")
    (run / "mine" / "linux" / "left_slcan.c").unlink()
    assert "nothing changed" not in invoke(STOCK, "--prefix", "left", "--out", "mine").stdout
    assert read(run / "mine") == left


@pytest.mark.parametrize("name", ["mine.c", "linux/mine.c", "notes"])
def test_a_stranger_in_a_prefixed_folder_is_not_lost(run: Path, name: str) -> None:
    invoke(STOCK, "--prefix", "left", "--out", "mine")
    stranger = run / "mine" / name
    stranger.write_text("mine") if name.endswith(".c") else stranger.mkdir()
    result = CliRunner().invoke(app, ["generate", str(STOCK), "--out", "mine"])
    assert result.exit_code != 0
    assert f"holds {name!r}, which was not generated" in result.stderr
    assert stranger.exists()


def test_a_prefix_that_is_no_word_is_refused_in_one_sentence(tmp_path: Path) -> None:
    arguments = ["generate", str(STOCK), "--prefix", "class"]
    done = subprocess.run([TURNBUCKLE, *arguments], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode != 0
    assert done.stderr.startswith('turnbuckle: --prefix: found "class"; allowed: ')
    assert done.stderr.count("\n") == 1
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("damage", ["edited", "missing"])
def test_a_damaged_folder_is_written_again(run: Path, files: dict[str, str], damage: str) -> None:
    invoke(STOCK)
    folder = run / "generated" / "yoon2023"
    if damage == "edited":
        (folder / "tb_control.c").write_text("mine")
    else:
        (folder / "tb_control.c").unlink()
    assert "nothing changed" not in invoke(STOCK).stdout
    assert read(folder) == files


def test_the_real_command_works_from_elsewhere_with_an_awkward_name(
    tmp_path: Path, files: dict[str, str]
) -> None:
    path = tmp_path / "my [bold]machine – Δx.toml"
    shutil.copy(STOCK, path)
    arguments = ["generate", path.name, "--out", "C code [α]"]
    done = subprocess.run(
        [TURNBUCKLE, *arguments], cwd=tmp_path, env=os.environ, capture_output=True, text=True
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "C code [α]" in done.stdout
    assert "\x1b" not in done.stdout
    assert read(tmp_path / "C code [α]").keys() == files.keys()
