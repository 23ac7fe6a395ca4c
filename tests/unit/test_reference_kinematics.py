"""The reference kinematics against the paper's printed formulas, differences and SciPy."""

import numpy as np
import numpy.typing as npt
import pytest
from scipy.optimize import OptimizeResult, least_squares

from turnbuckle.model.machine import Cable, Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.kinematics import (
    base_points,
    cable_lengths,
    forward_kinematics,
    length_jacobian,
    rail_jacobian,
    structure_matrix,
    task_velocity,
)

Doubles = npt.NDArray[np.float64]
STOCK = load_machine("machines/yoon2023.toml")
WIDTH, HEIGHT = STOCK.frame.size
EPS = np.finfo(float).eps
NO_RAILS = np.zeros(0)


def machine_with(*bases: tuple[float, ...]) -> Machine:
    """The stock machine with other bases: (x, y) fixed, (x0, y0, x1, y1) on a rail [m]."""
    cables = []
    for base in bases:
        lengths = [f"{value!r} m" for value in base]
        place = {"rail": {"from": lengths[:2], "to": lengths[2:]}} if len(base) == 4 else {}
        cables.append(Cable.model_validate(place or {"base": lengths}))
    return STOCK.model_copy(update={"cables": tuple(cables)})


MIXED = machine_with(
    (0.0, 0.0, 0.4, 0.3), (0.7, 0.1), (0.6, 0.4, 0.2, 0.45), (0.0, 0.4), (0.3, 0.0)
)


def random_poses(count: int) -> tuple[Doubles, Doubles]:
    rng = np.random.default_rng(count)
    pose = rng.uniform(0.02, 0.98, (count, 2)) * [WIDTH, HEIGHT]
    rails = rng.uniform(0, 1, (count, 4)) * [WIDTH, HEIGHT, WIDTH, HEIGHT]
    return pose, rails


def test_lengths_are_those_of_yoon_equation_18() -> None:
    pose, rails = random_poses(1000)
    x, y = pose.T
    xb1, yb2, xb3, yb4 = rails.T
    printed = [
        np.sqrt((x - xb1) ** 2 + y**2),
        np.sqrt((WIDTH - x) ** 2 + (y - yb2) ** 2),
        np.sqrt((xb3 - x) ** 2 + (HEIGHT - y) ** 2),
        np.sqrt(x**2 + (yb4 - y) ** 2),
    ]
    assert np.allclose(cable_lengths(STOCK, pose, rails).T, printed, rtol=4 * EPS, atol=0)


def test_structure_matrix_is_that_of_yoon_equation_21() -> None:
    pose, rails = random_poses(1000)
    x, y = pose.T
    xb1, yb2, xb3, yb4 = rails.T
    l1, l2, l3, l4 = cable_lengths(STOCK, pose, rails).T
    printed = np.array(
        [
            [-(x - xb1) / l1, (WIDTH - x) / l2, (xb3 - x) / l3, -x / l4],
            [-y / l1, -(y - yb2) / l2, (HEIGHT - y) / l3, (yb4 - y) / l4],
        ]
    )
    structure = structure_matrix(STOCK, pose, rails)
    assert np.allclose(np.moveaxis(structure, 0, -1), printed, rtol=0, atol=4 * EPS)


@pytest.mark.parametrize("machine", [STOCK, MIXED], ids=["yoon", "mixed"])
def test_jacobians_are_the_differences_of_the_lengths(machine: Machine) -> None:
    pose, rails = (part.astype(np.longdouble) for part in random_poses(200))
    pose[:, 1] = 0.15 + 0.1 * pose[:, 1]
    rails = 0.3 * rails[:, : len(machine.rails)]
    step = np.longdouble(1e-6)

    def slope(of_pose: Doubles, of_rails: Doubles) -> Doubles:
        ahead = cable_lengths(machine, pose + step * of_pose, rails + step * of_rails)
        behind = cable_lengths(machine, pose - step * of_pose, rails - step * of_rails)
        return np.asarray((ahead - behind) / (2 * step))

    still = np.zeros(rails.shape[1])
    by_pose = np.stack([slope(axis, still) for axis in np.eye(2)], axis=-1)
    by_rails = np.stack([slope(np.zeros(2), axis) for axis in np.eye(len(still))], axis=-1)
    shortest = float(np.min(cable_lengths(machine, pose, rails)))
    tolerance = (1e-6 / shortest) ** 2
    assert np.max(np.abs(length_jacobian(machine, pose, rails) - by_pose)) < tolerance
    assert np.max(np.abs(rail_jacobian(machine, pose, rails) - by_rails)) < tolerance


def test_a_consistent_motion_gives_back_its_velocity() -> None:
    pose, rails = random_poses(1000)
    rng = np.random.default_rng(1)
    velocity, rail_rates = rng.normal(size=(1000, 2)), rng.normal(size=(1000, 4))
    rates = np.einsum("rnd,rd->rn", length_jacobian(STOCK, pose, rails), velocity)
    rates += np.einsum("rnm,rm->rn", rail_jacobian(STOCK, pose, rails), rail_rates)
    found = task_velocity(STOCK, pose, rails, rates, rail_rates)
    assert np.max(np.abs(found - velocity)) < 1000 * EPS


def test_an_inconsistent_motion_is_fitted_with_equal_weight_on_every_cable() -> None:
    pose, rails = np.array([0.2, 0.1]), np.array([0.5, 0.3, 0.1, 0.4])
    rates = np.array([0.1, -0.2, 0.3, 0.15])
    found = task_velocity(STOCK, pose, rails, rates, np.zeros(4))
    equal, *_ = np.linalg.lstsq(length_jacobian(STOCK, pose, rails), rates)
    lengths = cable_lengths(STOCK, pose, rails)
    paper, *_ = np.linalg.lstsq(
        lengths[:, None] * length_jacobian(STOCK, pose, rails), lengths * rates
    )
    assert np.allclose(found, equal, rtol=0, atol=100 * EPS)
    assert np.max(np.abs(paper - equal)) > 0.01


def test_forward_kinematics_undoes_the_lengths_for_any_rails_and_pose() -> None:
    pose, rails = random_poses(20000)
    found = forward_kinematics(STOCK, cable_lengths(STOCK, pose, rails), rails)
    assert np.max(np.abs(found.pose - pose)) < 10 * EPS
    assert np.max(found.residual) < 10 * EPS


def test_forward_kinematics_undoes_the_lengths_with_mixed_bases() -> None:
    pose, rails = random_poses(2000)
    rails = 0.5 * rails[:, :2]
    found = forward_kinematics(MIXED, cable_lengths(MIXED, pose, rails), rails)
    assert np.max(np.abs(found.pose - pose)) < 10 * EPS


def fitted(lengths: Doubles, rails: Doubles, start: Doubles) -> OptimizeResult:
    def misfit(pose: Doubles) -> Doubles:
        return lengths - cable_lengths(STOCK, pose, rails)

    return least_squares(misfit, start, xtol=1e-15, ftol=1e-15, gtol=1e-15)


@pytest.mark.parametrize("noise", [1e-6, 1e-3, 2e-2])
def test_forward_kinematics_is_the_least_squares_fit_of_wrong_lengths(noise: float) -> None:
    pose, rails = random_poses(100)
    rng = np.random.default_rng(2)
    lengths = cable_lengths(STOCK, pose, rails) + noise * rng.normal(size=(100, 4))
    found = forward_kinematics(STOCK, lengths, rails)
    for i in range(100):
        fit = fitted(lengths[i], rails[i], pose[i])
        misfit = np.sqrt(2 * fit.cost)
        assert found.residual[i] <= misfit * (1 + 1e-9) + 10 * EPS
        assert np.allclose(found.pose[i], fit.x, rtol=0, atol=1e-7)


def test_forward_kinematics_settles_even_where_the_lengths_are_far_off() -> None:
    pose, rails = random_poses(300)
    lengths = cable_lengths(STOCK, pose, rails)
    lengths = np.abs(lengths + 0.05 * np.random.default_rng(0).normal(size=lengths.shape))
    found = forward_kinematics(STOCK, lengths, rails)
    left = lengths - cable_lengths(STOCK, found.pose, rails)
    slope = np.sum(structure_matrix(STOCK, found.pose, rails) * left[:, None, :], axis=-1)
    assert np.max(np.abs(slope)) < 1e-3


def test_two_mirrored_poses_are_not_told_apart() -> None:
    in_line = machine_with((0.1, 0.2), (0.3, 0.2), (0.6, 0.2))
    found = forward_kinematics(in_line, cable_lengths(in_line, [0.2, 0.3], NO_RAILS), NO_RAILS)
    assert np.all(np.isnan(found.pose)) and np.isnan(found.residual)


def test_a_platform_on_a_pulley_has_no_direction_there() -> None:
    structure = structure_matrix(STOCK, [0.2, 0.0], [0.2, 0.1, 0.2, 0.1])
    assert np.all(np.isnan(structure[:, 0])) and np.all(np.isfinite(structure[:, 1:]))


def test_forward_kinematics_finds_a_platform_on_a_pulley() -> None:
    corners = machine_with((0.0, 0.0), (0.375, 0.0), (0.375, 0.5), (0.0, 0.5))  # 3, 4, 5: exact
    pose = base_points(corners, NO_RAILS)
    found = forward_kinematics(corners, cable_lengths(corners, pose, NO_RAILS), NO_RAILS)
    assert np.max(np.abs(found.pose - pose)) < 10 * EPS
    assert np.max(found.residual) < 10 * EPS


def test_every_function_broadcasts_poses_against_rails() -> None:
    pose, rails = random_poses(7)
    grid = structure_matrix(STOCK, pose[:, None, :], rails[None, :5, :])
    assert grid.shape == (7, 5, 2, 4)
    assert np.array_equal(grid[3, 4], structure_matrix(STOCK, pose[3], rails[4]))
    lengths = cable_lengths(STOCK, pose[:, None, :], rails[None, :5, :])
    back = forward_kinematics(STOCK, lengths, rails[None, :5, :])
    assert back.pose.shape == (7, 5, 2) and back.residual.shape == (7, 5)
    assert np.allclose(back.pose, pose[:, None, :], rtol=0, atol=10 * EPS)


def test_long_double_goes_in_and_comes_out() -> None:
    pose, rails = (part.astype(np.longdouble) for part in random_poses(500))
    lengths = cable_lengths(STOCK, pose, rails)
    found = forward_kinematics(STOCK, lengths, rails)
    assert lengths.dtype == found.pose.dtype == found.residual.dtype == np.longdouble
    assert base_points(STOCK, rails).dtype == np.longdouble
    assert np.max(np.abs(found.pose - pose)) < 100 * np.finfo(np.longdouble).eps
