"""Grids, maps in tiles, and the motors that a machine needs over them."""

import numpy as np
import numpy.typing as npt
import pytest

from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.workspace.actuators import choose_actuators
from turnbuckle.model.workspace.feasible import ball_margin
from turnbuckle.model.workspace.force import isotropic_force
from turnbuckle.model.workspace.grid import Grid, frame_grid, target_grid
from turnbuckle.model.workspace.maps import Tally, evaluate, summarise
from turnbuckle.model.workspace.structures import Demand, structures, target_demand

Doubles = npt.NDArray[np.float64]
STOCK = load_machine("machines/yoon2023.toml")
DIAGONAL = load_machine("tests/machines/fixed_diagonal.toml")
NO_RAILS = np.zeros(0)
EPS = np.finfo(float).eps


def forces_of_the_diagonal(poses: Doubles) -> Doubles:
    bounds = DIAGONAL.tension
    return isotropic_force(structures(DIAGONAL, poses, NO_RAILS), bounds.min, bounds.max)


def turning(machine: Machine, space: int, dof: int) -> Machine:
    """The same machine with a rotation of its target, as only rigid kinds have it."""
    kind = {(2, 3): "planar-rigid", (3, 6): "spatial-rigid"}[space, dof]
    target = machine.target.model_copy(
        update={"rotation": 0.3, "size": (1.0,) * space, "centre": (0.5,) * space}
    )
    identity = machine.identity.model_copy(update={"kind": kind})
    return machine.model_copy(update={"target": target, "identity": identity})


def test_a_grid_over_the_target_reaches_its_border() -> None:
    grid = target_grid(STOCK, (5, 3))
    poses = grid.poses()
    size, centre = np.array(STOCK.target.size), np.array(STOCK.target.centre)
    assert grid.shape == (5, 3) and grid.size == 15
    assert np.allclose(np.min(poses, axis=0), centre - size / 2, rtol=0, atol=EPS)
    assert np.allclose(np.max(poses, axis=0), centre + size / 2, rtol=0, atol=EPS)
    assert np.array_equal(poses[1] - poses[0] > 0, [False, True])


def test_a_grid_over_the_frame_keeps_off_its_border() -> None:
    poses = frame_grid(DIAGONAL, (10, 10)).poses()
    assert np.allclose(np.min(poses, axis=0), np.array(DIAGONAL.frame.size) / 20, rtol=4 * EPS)
    assert np.all(np.isfinite(forces_of_the_diagonal(poses)))


@pytest.mark.parametrize(("space", "dof"), [(2, 3), (3, 6)])
def test_a_rigid_platform_also_turns(space: int, dof: int) -> None:
    grid = target_grid(turning(STOCK, space, dof), (2,) * space, rotations=3)
    assert grid.shape == (2,) * space + (3,) * (dof - space)
    assert np.array_equal(np.unique(grid.poses()[:, space:]), [-0.3, 0, 0.3])
    still = target_grid(turning(STOCK, space, dof), (1,) * space)
    assert np.array_equal(still.poses(), [[0.5] * space + [0.0] * (dof - space)])


def test_a_map_does_not_depend_on_its_tiles_and_tells_how_far_it_is() -> None:
    grid = target_grid(DIAGONAL, (30, 20))
    heard: list[tuple[int, int]] = []
    whole = evaluate(forces_of_the_diagonal, grid)
    tiled = evaluate(forces_of_the_diagonal, grid, 77, lambda *done: heard.append(done))
    assert np.array_equal(whole, tiled) and whole.shape == (30, 20)
    assert heard[0] == (77, 600) and heard[-1] == (600, 600) and len(heard) == 8


def test_a_map_may_hold_several_quantities() -> None:
    grid = target_grid(DIAGONAL, (6, 5))
    both = evaluate(lambda poses: np.stack([forces_of_the_diagonal(poses)] * 2, -1), grid, rows=7)
    assert both.shape == (6, 5, 2)
    assert np.array_equal(both[..., 1], evaluate(forces_of_the_diagonal, grid))


def test_nothing_has_no_summary() -> None:
    with pytest.raises(ValueError, match="no poses to summarise"):
        _ = Tally().summary


def test_the_summary_is_that_of_the_map() -> None:
    grid = frame_grid(DIAGONAL, (41, 23))
    forces = evaluate(forces_of_the_diagonal, grid)
    found = summarise(forces_of_the_diagonal, grid, wanted=2.0, rows=100)
    assert found.poses == 41 * 23 and found.undefined == 0
    assert found.share == np.mean(forces >= 2)
    assert found.least == np.min(forces)
    assert found.mean == pytest.approx(np.mean(forces), rel=1e-13)
    worst = grid.poses()[np.argmin(forces)]
    assert found.worst == tuple(worst.tolist())


def test_an_undefined_pose_is_the_worst_and_does_not_count_as_covered() -> None:
    grid = Grid((np.linspace(0, DIAGONAL.frame.size[0], 11), np.linspace(0, 0.2, 3)))
    found = summarise(forces_of_the_diagonal, grid, rows=5)
    assert found.undefined == 2 and found.worst == (0.0, 0.0)
    assert found.share == 31 / 33 and np.isfinite(found.mean) and found.least == 0
    nowhere = summarise(lambda poses: np.full(len(poses), np.nan), grid)
    assert np.isnan(nowhere.least) and np.isnan(nowhere.mean) and nowhere.share == 0


def test_a_billion_poses_are_never_held() -> None:
    axis = np.linspace(0, 1, 1000)
    grid = Grid((axis, axis, axis))
    assert grid.size == 10**9
    assert grid.poses(10**9 - 2).tolist() == [[1, 1, axis[-2]], [1, 1, 1]]
    assert len(next(iter(grid.tiles(1000)))) == 1000


def test_the_stock_machine_needs_10_newtons_and_its_motors_have_them() -> None:
    poses = target_grid(STOCK, (21, 11)).poses()
    choice = choose_actuators(STOCK, poses, base_targets(STOCK, poses))
    assert choice.tension == pytest.approx(10, rel=20 * EPS)
    assert choice.torque == pytest.approx(0.05, rel=20 * EPS)
    assert choice.sufficient and "55 mN m are enough" in str(choice)


def test_the_least_motor_is_one_that_just_covers_the_poses() -> None:
    poses = target_grid(DIAGONAL, (21, 11)).poses()
    demand = Demand(4.0, 0.0, 2)
    choice = choose_actuators(DIAGONAL, poses, NO_RAILS, demand)
    s = structures(DIAGONAL, poses, NO_RAILS)
    lower = DIAGONAL.tension.min
    margin = ball_margin(s, lower, choice.tension, *demand)
    assert np.min(margin) == pytest.approx(0, abs=1e-12)
    at_worst = structures(DIAGONAL, choice.worst_pose, NO_RAILS)
    assert ball_margin(at_worst, lower, choice.tension, *demand) == pytest.approx(0, abs=1e-12)
    assert np.min(ball_margin(s, lower, 0.99 * choice.tension, *demand)) < 0


def test_motors_that_are_too_weak_are_named() -> None:
    choice = choose_actuators(DIAGONAL, [0.253, 0.142], NO_RAILS, Demand(12.0, 0.0, 2))
    assert not choice.sufficient
    assert "are not enough" in str(choice) and "tension.max = 10 N is too low" in str(choice)


@pytest.mark.parametrize("pose", [[0.6, 0.1], [0.0, 0.0]])
def test_a_pose_that_no_motor_can_serve_says_so(pose: list[float]) -> None:
    choice = choose_actuators(DIAGONAL, [[0.25, 0.14], pose], NO_RAILS)
    assert np.isinf(choice.tension) and not choice.sufficient
    assert choice.worst_pose == tuple(pose) and "no motor is strong enough" in str(choice)


def test_moments_are_made_comparable_by_the_lever(monkeypatch: pytest.MonkeyPatch) -> None:
    turned = turning(STOCK, 2, 3)
    anchors = [(0.3, 0.0), (0.0, 0.3), (-0.3, 0.0), (0.0, -0.3)]
    cables = tuple(
        cable.model_copy(update={"anchor": anchor})
        for cable, anchor in zip(STOCK.cables, anchors, strict=True)
    )
    target = turned.target.model_copy(update={"moment": 0.6})
    machine = turned.model_copy(update={"cables": cables, "target": target})
    s = np.arange(12.0).reshape(3, 4)
    monkeypatch.setattr("turnbuckle.model.workspace.structures.structure_matrix", lambda *_: s)
    found = structures(machine, [0.0] * 3, [0.0] * 4)
    assert np.array_equal(found[:2], s[:2]) and np.allclose(found[2], s[2] / 0.3, rtol=4 * EPS)
    assert target_demand(machine) == pytest.approx((STOCK.target.force, 2.0, 2), rel=4 * EPS)


def test_points_have_forces_only() -> None:
    assert target_demand(STOCK) == (STOCK.target.force, 0, 2)
    assert structures(STOCK, [0.3, 0.2], [0.3, 0.2, 0.3, 0.2]).shape == (2, 4)
