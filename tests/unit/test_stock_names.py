"""Stock machines are known by name, wherever one is; a file of that name comes first."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from turnbuckle import load_machine
from turnbuckle.command_line import app
from turnbuckle.model.problem import MachineError
from turnbuckle.model.stock import stock_names
from turnbuckle.places import MACHINES


def test_every_stock_machine_is_found_by_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert len(stock_names()) > 5
    for name in stock_names():
        machine = load_machine(name)
        assert (machine.name, machine.path) == (name, MACHINES / f"{name}.toml")
    assert CliRunner().invoke(app, ["check", "spidar_g"]).exit_code == 0


def test_a_file_of_the_same_name_comes_first_a_folder_does_not(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("spidar_g").mkdir()
    assert load_machine("spidar_g").name == "spidar_g"
    Path("yoon2023").write_bytes((MACHINES / "brau_square.toml").read_bytes())
    assert load_machine("yoon2023").name == "brau_square"


@pytest.mark.parametrize("words", ["yoon", "machines/yoon2023", "yoon2023.toml", "Yoon2023", ".."])
def test_what_is_no_name_of_a_stock_machine_is_a_path(
    words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(MachineError) as refused:
        load_machine(words)
    message = str(refused.value)
    assert message.startswith(f"{words}: found ")
    assert words == ".." or all(name in message for name in stock_names())
