"""Forces, tension factor and tensions of maps against the papers, the reference and solvers."""

import numpy as np
import numpy.typing as npt
import pytest
import quadprog
from scipy.optimize import linprog

from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference import quality
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.reference.kinematics import structure_matrix
from turnbuckle.model.workspace.facets import rounding
from turnbuckle.model.workspace.feasible import ball_margin, feasible, polytope_margin
from turnbuckle.model.workspace.force import (
    force_along,
    isotropic_force,
    isotropic_force_eq17,
    isotropic_limits,
    tension_factor,
    zero_wrench_tension,
)
from turnbuckle.model.workspace.least_norm import least_norm_tension
from turnbuckle.model.workspace.max_tension import needed_tension

Doubles = npt.NDArray[np.float64]
STOCK = load_machine("machines/yoon2023.toml")
DIAGONAL = load_machine("tests/machines/fixed_diagonal.toml")
ORTHOGONAL = load_machine("tests/machines/fixed_orthogonal.toml")
WIDTH, HEIGHT = STOCK.target.size
LOWER, UPPER = STOCK.tension.min, STOCK.tension.max
NO_RAILS = np.zeros(0)
EPS = np.finfo(float).eps
NEWTON = 100 * EPS * UPPER


def screen() -> Doubles:
    """The 101 x 57 grid of the audit, borders included (5757, 2) [m]."""
    x, y = np.meshgrid(np.linspace(0, WIDTH, 101), np.linspace(0, HEIGHT, 57))
    return np.stack([x.ravel(), y.ravel()], axis=-1)


def at(machine: Machine, pose: npt.ArrayLike) -> Doubles:
    return np.asarray(structure_matrix(machine, pose, NO_RAILS), np.float64)


def random_structures(rows: int, d: int, n: int) -> Doubles:
    s = np.random.default_rng(10 * d + n).normal(size=(rows, d, n))
    return np.asarray(s / np.linalg.norm(s, axis=1, keepdims=True))


def test_the_centres_of_the_fixed_machines_have_the_papers_forces() -> None:
    centre = [WIDTH / 2, HEIGHT / 2]
    for measure in (isotropic_force, isotropic_force_eq17):
        diagonal = measure(at(DIAGONAL, centre), LOWER, UPPER)
        assert diagonal == pytest.approx(5.975360269920283, rel=20 * EPS)
        assert measure(at(ORTHOGONAL, centre), LOWER, UPPER) == pytest.approx(7, rel=20 * EPS)


@pytest.mark.parametrize(("machine", "share"), [(DIAGONAL, 0.595), (ORTHOGONAL, 0.279)])
def test_the_zero_wrench_workspace_covers_the_audited_share(machine: Machine, share: float) -> None:
    s = at(machine, screen())
    inside = feasible(ball_margin(s, LOWER, UPPER), s, UPPER)
    assert np.mean(inside) == pytest.approx(share, abs=0.0005)
    assert np.array_equal(inside, np.isfinite(tension_factor(s, LOWER, UPPER)))


def test_equation_17_is_too_low_where_the_audit_says() -> None:
    s = at(DIAGONAL, [0.108, 0.107])
    assert isotropic_force_eq17(s, LOWER, UPPER) == pytest.approx(4.163, abs=0.0005)
    assert isotropic_force(s, LOWER, UPPER) == pytest.approx(4.685, abs=0.0005)


def test_movable_bases_are_even_and_strong_wherever_no_pulley_is() -> None:
    poses = screen()
    x, y = poses.T
    none = np.zeros(len(poses))
    to_sides = np.array([[none, WIDTH - x, none, -x], [-y, none, HEIGHT - y, none]])
    with np.errstate(invalid="ignore"):
        s = np.moveaxis(to_sides / np.linalg.norm(to_sides, axis=0), -1, 0)
    defined = np.isfinite(isotropic_force(s, LOWER, UPPER))
    assert np.sum(defined) == 5445
    assert np.allclose(isotropic_force(s[defined], LOWER, UPPER), 7, rtol=8 * EPS)
    assert np.allclose(tension_factor(s[defined], LOWER, UPPER), 1, rtol=8 * EPS)


def test_the_stock_machine_has_7_newtons_all_over_its_target() -> None:
    poses = screen() - np.array([WIDTH, HEIGHT]) / 2 + STOCK.target.centre
    s = structure_matrix(STOCK, poses, base_targets(STOCK, poses))
    assert np.allclose(isotropic_force(s, LOWER, UPPER), 7, rtol=8 * EPS)
    assert np.allclose(tension_factor(s, LOWER, UPPER), 1, rtol=8 * EPS)


def test_the_least_tension_factor_of_the_diagonal_machine_is_the_audited_one() -> None:
    factor = tension_factor(at(DIAGONAL, screen()), LOWER, UPPER)
    assert np.nanmin(factor) == pytest.approx(0.3009, abs=5e-5)


@pytest.mark.parametrize("machine", [DIAGONAL, ORTHOGONAL])
def test_maps_equal_the_reference(machine: Machine) -> None:
    poses = np.random.default_rng(0).uniform([0, 0], [WIDTH, HEIGHT], (2000, 2))
    s = at(machine, poses)
    pairs = [
        (isotropic_force, quality.isotropic_force),
        (isotropic_force_eq17, quality.isotropic_force_eq17),
        (tension_factor, quality.tension_factor),
        (zero_wrench_tension, quality.zero_wrench_tension),
    ]
    for measure, reference in pairs:
        expected = reference(machine, poses, NO_RAILS)
        assert np.allclose(measure(s, LOWER, UPPER), expected, rtol=0, atol=1e-11, equal_nan=True)


def test_three_cables_at_their_best_give_7_newtons_times_half_the_root_of_3() -> None:
    angle = 2 * np.pi * np.arange(3) / 3
    s = np.stack([np.cos(angle), np.sin(angle)])
    assert isotropic_force(s, LOWER, UPPER) == pytest.approx(6.0622, abs=5e-5)
    assert isotropic_force(s, LOWER, UPPER) == pytest.approx(7 * np.sqrt(3) / 2, rel=20 * EPS)


@pytest.mark.parametrize(("d", "n", "space"), [(2, 4, 2), (3, 5, 3), (3, 5, 2), (6, 12, 3)])
def test_the_isotropic_force_is_feasible_in_every_direction_and_no_more(
    d: int, n: int, space: int
) -> None:
    rng = np.random.default_rng(n)
    forces = np.zeros((150, d))
    forces[:, :space] = rng.normal(size=(150, space))
    forces /= np.linalg.norm(forces, axis=1, keepdims=True)
    strong = 0
    for s in random_structures(30, d, n):
        force = float(isotropic_force(s, 0.5, UPPER, space))
        if force > 0.2:
            strong += 1
            assert polytope_margin(s, 0.5, UPPER, (force - 1e-9) * forces) > 0
            weakest = float(np.min(force_along(s, 0.5, UPPER, forces)))
            assert force <= weakest + NEWTON and weakest < 1.5 * force
    assert strong > 2


@pytest.mark.parametrize(("d", "n"), [(2, 4), (3, 6), (6, 12)])
def test_the_force_along_a_direction_is_what_linear_programming_finds(d: int, n: int) -> None:
    rng = np.random.default_rng(d)
    found = 0
    for s in random_structures(60, d, n):
        w = rng.normal(size=d)
        lp = linprog(
            np.append(np.zeros(n), -1.0),
            A_eq=np.column_stack([s, -w]),
            b_eq=np.zeros(d),
            bounds=[(0.5, UPPER)] * n + [(0, None)],
        )
        zero = linprog(np.zeros(n), A_eq=s, b_eq=np.zeros(d), bounds=[(0.5, UPPER)] * n)
        assert lp.x is not None or zero.status != 0
        expected = lp.x[-1] if lp.x is not None and zero.status == 0 else 0.0
        found += expected > 0
        assert force_along(s, 0.5, UPPER, w) == pytest.approx(expected, abs=1e-6)
    assert found > 5


def test_a_platform_whose_cables_give_no_moment_still_has_its_forces() -> None:
    forces = np.array([[1, -1, 0, 0], [0, 0, 1, -1], [0, 0, 0, 0]], float)
    turn = np.linalg.qr(np.random.default_rng(0).normal(size=(2, 2)))[0]
    for s in (forces, np.vstack([turn @ forces[:2], forces[2:]])):
        assert isotropic_force(s, LOWER, UPPER, space=2) == pytest.approx(7, rel=20 * EPS)
        assert isotropic_force(s, LOWER, UPPER) == pytest.approx(0, abs=NEWTON)
        assert needed_tension(s, LOWER, 7.0, space=2) == pytest.approx(UPPER, rel=20 * EPS)
        assert np.isinf(needed_tension(s, LOWER, 7.0, 0.01, space=2))
        assert force_along(s, LOWER, UPPER, [0.6, 0.8, 0]) > 7
        assert force_along(s, LOWER, UPPER, [0, 0, 1]) == pytest.approx(0, abs=NEWTON)


@pytest.mark.parametrize(("d", "n", "space"), [(2, 4, 2), (3, 5, 2), (6, 9, 3)])
def test_the_least_limit_is_the_isotropic_force(d: int, n: int, space: int) -> None:
    s = random_structures(300, d, n)
    least = np.min(isotropic_limits(s, 0.2, UPPER, space), axis=-1)
    force = isotropic_force(s, 0.2, UPPER, space)
    assert np.sum(force > 0) > 5 and np.sum(least < 0) > 5
    assert np.allclose(np.maximum(least, 0), force, rtol=1e-12, atol=NEWTON)


def test_a_moment_that_no_cable_holds_is_a_limit_below_zero() -> None:
    diagonal = np.sqrt(0.5)
    s = np.array(  # all cables turn the platform to the left
        [[1, 0, -1, 0, diagonal], [0, 1, 0, -1, diagonal], [1, 1, 1, 1, 1]]
    )
    assert np.min(isotropic_limits(s, LOWER, UPPER, space=2)) < 0
    assert isotropic_force(s, LOWER, UPPER, space=2) == 0
    through_centre = np.array([[1, 0, -1, -1], [0, 1, -1, -0.2], [0, 0, -1, -1]])
    assert np.min(isotropic_limits(through_centre, LOWER, UPPER, space=2)) == -4 * UPPER


def test_no_force_is_given_where_the_cables_cannot_even_hold_still() -> None:
    s = at(DIAGONAL, [0.25, 0.01])
    assert isotropic_force(s, LOWER, UPPER) == 0
    assert force_along(s, LOWER, UPPER, [0, 1]) == 0
    assert np.isnan(tension_factor(s, LOWER, UPPER))


def test_the_tension_factor_of_one_redundant_cable_is_that_of_its_self_stress() -> None:
    for d in (2, 3, 6):
        s = random_structures(3000, d, d + 1)
        stress = np.linalg.svd(s)[2][:, -1]
        stress *= np.sign(np.sum(stress, axis=-1, keepdims=True))
        expected = np.min(stress, axis=-1) / np.max(stress, axis=-1)
        expected = np.where(expected >= 0.05, expected, np.nan)
        found = tension_factor(s, 0.5, 10.0)
        assert np.sum(np.isfinite(found)) > 5
        assert np.allclose(found, expected, rtol=1e-9, equal_nan=True)


def test_the_tension_factor_is_undefined_without_a_least_tension() -> None:
    assert np.all(np.isnan(tension_factor(random_structures(3, 2, 4), 0, UPPER)))


@pytest.mark.parametrize(("d", "n"), [(2, 3), (2, 5), (3, 6), (6, 8), (6, 10)])
def test_least_norm_tensions_are_those_of_a_published_solver(d: int, n: int) -> None:
    rng = np.random.default_rng(n)
    structures = random_structures(200, d, n)
    wrenches = np.einsum("rdn,rn->rd", structures, rng.uniform(LOWER, UPPER, (200, n)))
    wrenches[::4] *= 2
    found = least_norm_tension(structures, wrenches, LOWER, UPPER)
    for s, w, tension in zip(structures, wrenches, found, strict=True):
        sides = np.vstack([s, np.eye(n), -np.eye(n)]).T
        limits = np.concatenate([w, np.full(n, LOWER), np.full(n, -UPPER)])
        try:
            expected = quadprog.solve_qp(np.eye(n), np.zeros(n), sides, limits, d)[0]
        except ValueError:
            expected = np.full(n, np.nan)
        assert np.allclose(tension, expected, rtol=0, atol=1e-9, equal_nan=True)
    assert np.sum(np.isnan(found[:, 0])) > 5


def test_least_norm_tensions_hold_on_the_boundary_of_the_set() -> None:
    structures = random_structures(2000, 3, 6)
    rng = np.random.default_rng(0)
    corner = np.where(rng.random((2000, 6)) < 0.5, LOWER, UPPER)
    wrenches = np.einsum("rdn,rn->rd", structures, corner)
    tension = least_norm_tension(structures, wrenches, LOWER, UPPER)
    error = np.abs(np.einsum("rdn,rn->rd", structures, tension) - wrenches)
    assert np.nanmax(error) < 1e-7
    assert np.mean(np.isnan(tension[:, 0])) < 0.001
    assert np.nanmin(tension) >= LOWER and np.nanmax(tension) <= UPPER
    assert np.all(rounding(structures, UPPER) < 1e-11)
