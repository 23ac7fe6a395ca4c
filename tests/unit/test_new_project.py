"""`turnbuckle new`: a whole folder or none, with a machine file like the one it began with."""

import errno
import json
import os
import tomllib
from importlib.metadata import version
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from turnbuckle.command_line import app
from turnbuckle.model.reading import load_machine
from turnbuckle.model.stock import stock_names
from turnbuckle.places import MACHINES, RUNTIME


@pytest.fixture(autouse=True)
def empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, arguments)


def assert_refused(result: Result, *words: str) -> None:
    """Exit status 2, one message that holds the words."""
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.count("\n") == 1
    for word in words:
        assert word in result.stderr


@pytest.mark.parametrize("source", stock_names())
def test_any_stock_machine_becomes_a_machine_of_the_user(source: str) -> None:
    assert run("new", "arm", "--from", source).exit_code == 0
    wanted = tomllib.loads((MACHINES / f"{source}.toml").read_text())
    wanted["machine"]["name"] = "arm"
    text = Path("arm/arm.toml").read_text()
    assert tomllib.loads(text) == wanted
    assert text.count("#") >= (MACHINES / f"{source}.toml").read_text().count("#")
    machine = load_machine("arm/arm.toml")
    assert Path("arm/app/live.c").exists() == bool(machine.buses)
    texts = [path.read_text() for path in Path("arm").rglob("*") if path.is_file()]
    assert not [text for text in texts if "{{" in text.replace("${{", "") and "{%" in text]


def test_the_folder_holds_the_runtime_and_says_which_version_made_it() -> None:
    assert run("new", "arm").exit_code == 0
    assert run("runtime", "--out", "copy").exit_code == 0
    for path in RUNTIME.rglob("*"):
        if path.is_file():
            name = path.relative_to(RUNTIME)
            assert path.read_bytes() == Path("arm/runtime", name).read_bytes()
            assert path.read_bytes() == Path("copy", name).read_bytes()
    manifest = json.loads(Path("arm/runtime/manifest.json").read_text())
    assert manifest["turnbuckle"] == version("turnbuckle")
    assert f"Turnbuckle {version('turnbuckle')}" in Path("arm/README.md").read_text()


@pytest.mark.parametrize("name", ["Arm", "a-b", "../arm", "1arm", "", "int", "a" * 32, "arm.toml"])
def test_a_bad_name_is_refused_in_one_message(name: str) -> None:
    assert_refused(run("new", name), "NAME: found", "allowed: a name")
    assert not list(Path().iterdir())


@pytest.mark.parametrize("what", ["file", "folder", "link"])
def test_what_is_there_is_left_alone(what: str) -> None:
    path = Path("arm")
    if what == "folder":
        path.mkdir()
    else:
        path.symlink_to("nowhere") if what == "link" else path.touch()
    assert_refused(run("new", "arm"), "arm: exists already")
    assert [each.name for each in Path().iterdir()] == ["arm"]
    assert not path.is_dir() or not list(path.iterdir())


def test_an_unknown_machine_is_refused_with_the_stock_ones() -> None:
    assert_refused(run("new", "arm", "--from", "yoon"), "yoon: found no such file", *stock_names())
    assert not list(Path().iterdir())


def test_a_machine_of_ones_own_can_be_the_beginning() -> None:
    assert run("new", "arm", "--from", "brau_square").exit_code == 0
    assert run("new", "leg", "--from", "arm/arm.toml").exit_code == 0
    assert load_machine("leg/leg.toml").name == "leg"


def test_a_file_whose_name_cannot_be_changed_is_refused() -> None:
    text = (MACHINES / "brau_square.toml").read_text()
    Path("odd.toml").write_text(text.replace('name = "brau_square"', "name = 'brau_square'"))
    assert_refused(run("new", "arm", "--from", "odd.toml"), "odd.toml: machine.name")
    assert not Path("arm").exists()


def test_a_full_disk_leaves_nothing_behind(monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr("turnbuckle.codegen.folder.os.fsync", full)
    assert_refused(run("new", "arm"), "arm: cannot be written: No space left on device")
    assert not list(Path().iterdir())


def test_a_foreign_file_in_a_copy_of_the_runtime_is_never_lost() -> None:
    assert run("runtime", "--out", "copy").exit_code == 0
    assert run("runtime", "--out", "copy").exit_code == 0
    Path("copy/core/mine.c").touch()
    assert_refused(run("runtime", "--out", "copy"), "holds 'core/mine.c'")
    assert Path("copy/core/mine.c").exists()
