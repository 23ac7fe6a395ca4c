"""What was measured for a function is taken from the C that is there while nothing changed."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from turnbuckle.codegen import accuracy_cache
from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.accuracy_cache import ACCURACY, as_json, measured_accuracy
from turnbuckle.codegen.item import Item
from turnbuckle.codegen.model import Model
from turnbuckle.model.machine import Machine


@pytest.fixture
def routines(stock_model: Model, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[Item]:
    """Two cheap functions, with an empty cache."""
    monkeypatch.setattr(accuracy_cache, "CACHE", tmp_path / "cache")
    return [
        item
        for item in stock_model.items()
        if item.function.name in ("base_points", "cable_lengths")
    ]


@pytest.fixture
def measured(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many functions are measured, each time."""
    counts: list[int] = []
    real: Callable[[Machine, list[Item], list[int]], list[Accuracy]] = accuracy_cache.measure_all

    def counted(machine: Machine, routines: list[Item], numbers: list[int]) -> list[Accuracy]:
        counts.append(len(numbers))
        return real(machine, routines, numbers)

    monkeypatch.setattr(accuracy_cache, "measure_all", counted)
    return counts


@pytest.fixture
def folder(stock_model: Model, routines: list[Item], measured: list[int], tmp_path: Path) -> Path:
    """Where the accuracy of both is told, by the first computer that measured it."""
    folder = tmp_path / "generated"
    folder.mkdir()
    found = measured_accuracy(stock_model.machine, routines)
    (folder / ACCURACY).write_text(as_json(found))
    for path in accuracy_cache.CACHE.iterdir():
        path.unlink()
    measured.clear()
    return folder


def test_what_the_folder_tells_is_not_measured_again_and_is_kept(
    stock_model: Model, routines: list[Item], folder: Path, measured: list[int]
) -> None:
    first = measured_accuracy(stock_model.machine, routines, folder)
    second = measured_accuracy(stock_model.machine, routines)
    assert measured == [0, 0]
    assert first == second
    assert as_json(first) == (folder / ACCURACY).read_text()


def test_a_function_that_changed_is_measured_and_only_that(
    stock_model: Model, routines: list[Item], folder: Path, measured: list[int]
) -> None:
    told = json.loads((folder / ACCURACY).read_text())
    told["base_points"]["key"] = "0" * 32
    (folder / ACCURACY).write_text(json.dumps(told))
    measured_accuracy(stock_model.machine, routines, folder)
    assert measured == [1]


def test_another_way_of_measuring_counts_as_a_change(
    stock_model: Model,
    routines: list[Item],
    folder: Path,
    measured: list[int],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(accuracy_cache, "method_hash", lambda: "another")
    measured_accuracy(stock_model.machine, routines, folder)
    assert measured == [2]


@pytest.mark.parametrize("text", ["", "{}", "[]", "{", '{"cable_lengths": {"key": 1}}', "\0"])
def test_where_the_file_is_damaged_all_is_measured(
    stock_model: Model, routines: list[Item], folder: Path, measured: list[int], text: str
) -> None:
    (folder / ACCURACY).write_text(text)
    found = measured_accuracy(stock_model.machine, routines, folder)
    assert measured == [2]
    assert found.keys() == {"base_points", "cable_lengths"}
