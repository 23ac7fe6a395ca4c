"""The best places of movable bases, searched for, and what a lag of theirs costs."""

from itertools import pairwise

import numpy as np
import numpy.typing as npt
import pytest

from turnbuckle.model.machine import Cable, Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference import quality
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.workspace.bases import best_rails, lag_directions, lagging_force
from turnbuckle.model.workspace.maximin import climb

Doubles = npt.NDArray[np.float64]
STOCK = load_machine("machines/yoon2023.toml")
SLANTED = load_machine("tests/machines/slanted_rails.toml")
MIXED = load_machine("tests/machines/mixed_bases.toml")
EPS = np.finfo(float).eps


def equilateral(side: float = 0.6) -> Machine:
    """Three bases on the sides of an equilateral triangle (Yoon section III-B)."""
    corners = side * np.array([[0, 0], [1, 0], [0.5, np.sqrt(3) / 2]])
    texts = [[f"{x!r} m", f"{y!r} m"] for x, y in (*corners.tolist(), corners[0].tolist())]
    cables = [Cable.model_validate({"rail": {"from": a, "to": b}}) for a, b in pairwise(texts)]
    return STOCK.model_copy(update={"cables": tuple(cables)})


@pytest.mark.parametrize("pose", [(0.3559, 0.2309), (0.12, 0.1)])
def test_the_orthogonal_rule_comes_out_as_the_optimum(pose: tuple[float, float]) -> None:
    best = best_rails(STOCK, pose)
    assert best.searched == pytest.approx(7, rel=1e-9) and best.searched <= 7 * (1 + 20 * EPS)
    assert best.force == pytest.approx(7, rel=8 * EPS)
    assert np.array_equal(best.rails, base_targets(STOCK, np.array(pose)))


def test_three_bases_reach_7_newtons_times_half_the_root_of_3() -> None:
    best = best_rails(equilateral(), (0.3, 0.15))
    assert best.searched == pytest.approx(7 * np.sqrt(3) / 2, rel=1e-9)
    assert best.force == pytest.approx(6.0622, abs=5e-5)


@pytest.mark.parametrize("machine", [SLANTED, MIXED])
def test_no_other_place_within_the_limits_is_better(machine: Machine) -> None:
    pose = np.array(machine.target.centre) + 0.04
    best = best_rails(machine, pose)
    lengths = np.array([rail.length for rail in machine.rails])
    rails = np.random.default_rng(0).uniform(0, lengths, (5_000, len(lengths)))
    assert np.all((best.rails >= 0) & (best.rails <= lengths))
    others = quality.isotropic_force(machine, pose, rails)
    assert np.max(others) <= best.force * (1 + 1e-9)
    assert best.force == pytest.approx(
        quality.isotropic_force(machine, pose, best.rails), rel=1e-12
    )
    assert best.force >= quality.isotropic_force(machine, pose, base_targets(machine, pose))


def test_a_machine_without_rails_has_no_best_ones() -> None:
    with pytest.raises(ValueError, match="fixed_diagonal has no movable base"):
        best_rails(load_machine("tests/machines/fixed_diagonal.toml"), (0.2, 0.1))


def test_bases_that_do_not_lag_keep_the_full_force() -> None:
    poses = np.random.default_rng(0).uniform([0.15, 0.15], [0.55, 0.3], (50, 2))
    assert np.allclose(lagging_force(STOCK, poses, 0.0), 7, rtol=8 * EPS)


def test_a_longer_lag_costs_more_force() -> None:
    poses = np.random.default_rng(0).uniform([0.2, 0.15], [0.5, 0.3], (50, 2))
    forces = [lagging_force(STOCK, poses, lag) for lag in (0.0, 0.01, 0.02, 0.05)]
    assert all(np.all(later < earlier) for earlier, later in pairwise(forces))


def test_the_lagging_force_is_that_of_the_worst_direction() -> None:
    pose, lag = np.array([0.3, 0.25]), 0.03
    angle = 2 * np.pi * np.arange(16) / 16
    ways = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    rails = base_targets(STOCK, pose - lag * ways)
    expected = np.min(quality.isotropic_force(STOCK, pose, rails))
    assert lagging_force(STOCK, pose, lag) == pytest.approx(expected, rel=1e-12)
    one_way = lagging_force(STOCK, pose, lag, directions=[[1.0, 0.0]])
    rails = base_targets(STOCK, pose - [lag, 0])
    assert one_way[0] == pytest.approx(quality.isotropic_force(STOCK, pose, rails), rel=1e-12)


@pytest.mark.parametrize(("space", "count"), [(2, 16), (3, 14)])
def test_directions_of_lag_go_all_around(space: int, count: int) -> None:
    ways = lag_directions(space)
    assert ways.shape == (count, space)
    assert np.allclose(np.linalg.norm(ways, axis=-1), 1, rtol=4 * EPS)
    assert np.allclose(np.sum(ways, axis=0), 0, atol=count * EPS)
    nearest = np.max(ways @ ways.T - 2 * np.eye(count), axis=-1)
    assert np.all(nearest > 0.5) and np.all(nearest < 1 - 1e-3)


def test_another_rule_may_place_the_bases() -> None:
    def parked(machine: Machine, poses: Doubles) -> Doubles:
        return np.tile([0.3559, 0.2309, 0.3559, 0.2309], (len(poses), 1))

    found = lagging_force(STOCK, [[0.3, 0.2]], 0.1, rule=parked)
    expected = quality.isotropic_force(STOCK, [0.3, 0.2], parked(STOCK, np.zeros((1, 2)))[0])
    assert found[0] == pytest.approx(expected, rel=1e-12)


def test_a_climb_ends_on_the_ridge_of_functions_with_kinks() -> None:
    target = np.array([0.3, -0.2, 0.7])

    def values(point: Doubles) -> Doubles:
        return np.asarray(1 - np.abs(point - target) * [1, 5, 2])

    def slopes(point: Doubles, _: Doubles) -> Doubles:
        return np.asarray(np.diag(-np.sign(point - target) * [1, 5, 2]))

    point, found = climb(values, slopes, np.zeros(3), 0.5, -np.ones(3), np.ones(3))
    assert np.min(found) == pytest.approx(1, abs=1e-6)
    assert point == pytest.approx(target, abs=1e-6)
    held, _ = climb(values, slopes, np.zeros(3), 0.5, -np.ones(3), np.array([0.1, 1, 1]))
    assert held[0] == pytest.approx(0.1, abs=1e-12)
