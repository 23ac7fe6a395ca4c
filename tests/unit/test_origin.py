"""Generated files say from which machine file they are: by the path that the user gave."""

import shlex
from pathlib import Path

import pytest

from turnbuckle.codegen.bus.dbc import dbc_files
from turnbuckle.codegen.generate import banner
from turnbuckle.codegen.origin import command
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.places import MACHINES


def machine_at(path: str | Path) -> Machine:
    """A machine with buses as if it were read from a path."""
    return load_machine(MACHINES / "yoon2023.toml").read_from(Path(path))


@pytest.mark.parametrize("path", ["my_arm.toml", "arms/my_arm.toml", "../my_arm.toml"])
def test_a_relative_path_is_told_as_it_was_given(path: str) -> None:
    machine = machine_at(path)
    assert command(machine) == f"turnbuckle generate {path}"
    assert f"Regenerate: turnbuckle generate {path} --out" in banner(machine, "0")
    assert all(f"generate {path}." in text for text in dbc_files(machine).values())


def test_a_stock_machine_is_the_same_from_everywhere(monkeypatch: pytest.MonkeyPatch) -> None:
    wanted = "turnbuckle generate machines/yoon2023.toml"
    assert command(load_machine("yoon2023")) == wanted
    assert command(load_machine(MACHINES / "yoon2023.toml")) == wanted
    monkeypatch.chdir(MACHINES.parent)
    assert command(load_machine("machines/yoon2023.toml")) == wanted


def test_folders_of_the_user_do_not_enter_the_c(tmp_path: Path) -> None:
    assert command(machine_at(tmp_path / "arm.toml")) == "turnbuckle generate arm.toml"


@pytest.mark.parametrize("path", ["a*/b.toml", "b/*.toml", 'a".toml', "a\\.toml", "a\nb.toml"])
def test_a_path_that_would_end_the_comment_is_not_told(path: str) -> None:
    assert command(machine_at(path)) == "turnbuckle generate yoon2023.toml"


def test_a_path_with_spaces_can_be_pasted_into_a_shell() -> None:
    assert shlex.split(command(machine_at("my arm.toml")))[-1] == "my arm.toml"
