"""Nobody's map is timed on wrong answers: ours, NumPy's and the loop's are the same."""

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from turnbuckle.codegen.pose_map import Grid
from turnbuckle.lab.benchmark.map.comparison import (
    LARGE,
    LOOP,
    NUMPY,
    OURS,
    Mapper,
    MapRow,
    Maps,
    MapTable,
    Reference,
    compare,
    mappers,
)
from turnbuckle.lab.benchmark.map.scene import Scene, scenes
from turnbuckle.lab.benchmark.targets import map_targets
from turnbuckle.lab.benchmark.timing import Timing
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
#: Rounding that margin and factor of exact methods may differ by, in units of eps and of T_max.
ROUNDING = 2**7


@pytest.fixture(scope="module")
def machine() -> Machine:
    return load_machine(ROOT / "machines" / "yoon2023.toml")


@pytest.fixture(scope="module")
def ways(machine: Machine) -> list[Mapper]:
    """All ways, on grids too small to be worth timing."""
    return [replace(w, side=4) for w in mappers(machine, ROOT / "generated" / "yoon2023")]


@pytest.fixture(scope="module")
def mapped(machine: Machine) -> list[Scene]:
    """The scenes that are timed, and one with half of its poses outside the workspace."""
    return [*scenes(machine), Scene("bases far behind", machine, lag=(0.17, 0.08))]


def row(table: MapTable, name: str) -> MapRow:
    return next(row for row in table.rows if row.name == name)


def test_all_ways_draw_the_reference_map(
    machine: Machine, ways: list[Mapper], mapped: list[Scene]
) -> None:
    for scene in mapped:
        table = compare(scene, ways, repetitions=1)
        for each in table.rows:
            epsilon = np.finfo(np.float32 if "float" in each.name else np.float64).eps
            assert each.margin_error < ROUNDING * epsilon * machine.tension.max, each
            assert each.factor_error < ROUNDING * epsilon, each


def test_the_scenes_have_something_to_find(mapped: list[Scene]) -> None:
    references = [Reference.of(scene) for scene in mapped]
    assert [bool(np.ptp(r.factor) > 0.01) for r in references] == [False, True, True, True]
    inside = np.mean(references[-1].margin >= 0)
    assert 0.2 < inside < 0.8


def test_a_map_that_is_a_little_wrong_is_told_apart(
    ways: list[Mapper], mapped: list[Scene]
) -> None:
    right = next(way for way in ways if way.name == OURS)

    def shifted(scene: Scene, grid: Grid) -> Iterable[Maps]:
        return right.draw(scene, replace(grid, origin=(grid.origin[0] + 1e-9, grid.origin[1])))

    (wrong,) = compare(mapped[2], [replace(right, draw=shifted)], repetitions=1).rows
    epsilon = float(np.finfo(float).eps)
    assert wrong.margin_error > ROUNDING * epsilon * mapped[2].machine.tension.max
    assert wrong.factor_error > ROUNDING * epsilon


def test_promises_are_measured_against_the_right_times() -> None:
    times = {OURS: 50.0, LARGE: 40.0, NUMPY: 550.0, LOOP: 40_000.0}
    rows = [MapRow(name, "", 1, Timing(time, time), 0.0, 0.0) for name, time in times.items()]
    found = {target.what.split(",")[1]: target for target in map_targets([MapTable("", rows)])}
    measured = [target.measured for target in found.values()]
    assert measured == pytest.approx([20.0, 11.0, 800.0, 1.25])
    assert [target.is_met for target in found.values()] == [True, True, False, True]
