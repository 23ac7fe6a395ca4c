"""The reference pose quality against the published numbers and brute force."""

from itertools import product

import numpy as np
import numpy.typing as npt
import pytest

from turnbuckle.model.machine import Cable, Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.reference.kinematics import structure_matrix
from turnbuckle.model.reference.quality import (
    capacity_margin,
    isotropic_force,
    isotropic_force_eq17,
    tension_factor,
    zero_wrench_tension,
)
from turnbuckle.model.reference.statics import wrench
from turnbuckle.model.reference.tension import wrench_feasible

Doubles = npt.NDArray[np.float64]
STOCK = load_machine("machines/yoon2023.toml")
WIDTH, HEIGHT = STOCK.target.size
CENTRE = np.array([WIDTH, HEIGHT]) / 2
EPS = np.finfo(float).eps
NO_RAILS = np.zeros(0)
NEWTON = STOCK.tension.max * EPS


def fixed_machine(points: npt.ArrayLike) -> Machine:
    """The stock machine with pulleys fixed at the points (n, 2) [m]."""
    places = [[f"{x!r} m", f"{y!r} m"] for x, y in np.asarray(points, float).tolist()]
    cables = tuple(Cable.model_validate({"base": place}) for place in places)
    return STOCK.model_copy(update={"cables": cables})


def ring(cables: int) -> Machine:
    """Pulleys evenly spread on a circle of radius 1 m about (2, 2) m."""
    angle = 2 * np.pi * np.arange(cables) / cables
    return fixed_machine(2 + np.stack([np.cos(angle), np.sin(angle)], axis=-1))


DIAGONAL = fixed_machine([(0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT)])
ORTHOGONAL = fixed_machine(
    [(WIDTH / 2, 0), (WIDTH, HEIGHT / 2), (WIDTH / 2, HEIGHT), (0, HEIGHT / 2)]
)


def screen() -> Doubles:
    """The 101 x 57 grid of the audit, borders included (5757, 2) [m]."""
    x, y = np.meshgrid(np.linspace(0, WIDTH, 101), np.linspace(0, HEIGHT, 57))
    return np.stack([x.ravel(), y.ravel()], axis=-1)


def test_the_fixed_diagonal_machine_has_the_papers_5_98_newtons_at_its_centre() -> None:
    exact = 14 * WIDTH * HEIGHT / (WIDTH**2 + HEIGHT**2)
    assert exact == pytest.approx(5.975360269920283, rel=4 * EPS)
    assert isotropic_force(DIAGONAL, CENTRE, NO_RAILS) == pytest.approx(exact, rel=8 * EPS)
    assert isotropic_force_eq17(DIAGONAL, CENTRE, NO_RAILS) == pytest.approx(exact, rel=8 * EPS)
    assert tension_factor(DIAGONAL, CENTRE, NO_RAILS) == pytest.approx(1, rel=8 * EPS)


def test_the_fixed_orthogonal_machine_has_the_papers_7_newtons_at_its_centre() -> None:
    assert isotropic_force(ORTHOGONAL, CENTRE, NO_RAILS) == pytest.approx(7, rel=8 * EPS)
    assert isotropic_force_eq17(ORTHOGONAL, CENTRE, NO_RAILS) == pytest.approx(7, rel=8 * EPS)


def test_movable_bases_give_7_newtons_and_a_tension_factor_of_1_all_over_the_screen() -> None:
    pose = screen() - CENTRE + STOCK.target.centre
    rails = base_targets(STOCK, pose)
    for force in (isotropic_force, isotropic_force_eq17):
        assert np.allclose(force(STOCK, pose, rails), 7, rtol=8 * EPS, atol=0)
    assert np.allclose(tension_factor(STOCK, pose, rails), 1, rtol=8 * EPS, atol=0)


def test_three_cables_at_their_best_give_7_newtons_times_half_the_root_of_3() -> None:
    force = isotropic_force(ring(3), [2.0, 2.0], NO_RAILS)
    assert force == pytest.approx(7 * np.sqrt(3) / 2, rel=20 * EPS)


@pytest.mark.parametrize(("machine", "share"), [(DIAGONAL, 0.595), (ORTHOGONAL, 0.279)])
def test_the_zero_wrench_workspace_covers_the_audited_share(machine: Machine, share: float) -> None:
    inside = wrench_feasible(machine, structure_matrix(machine, screen(), NO_RAILS), np.zeros(2))
    assert np.mean(inside) == pytest.approx(share, abs=0.0005)
    defined = np.isfinite(tension_factor(machine, screen(), NO_RAILS))
    assert np.array_equal(defined, inside)


def test_the_tension_factor_stays_above_the_ratio_of_the_bounds() -> None:
    factor = tension_factor(DIAGONAL, screen(), NO_RAILS)
    assert np.nanmin(factor) == pytest.approx(0.3009, abs=5e-5)
    assert np.nanmax(factor) <= 1


def test_equation_17_is_too_low_on_a_quarter_of_the_diagonal_workspace() -> None:
    exact = isotropic_force(DIAGONAL, screen(), NO_RAILS)
    paper = isotropic_force_eq17(DIAGONAL, screen(), NO_RAILS)
    inside = np.isfinite(paper)
    missing = (exact - paper)[inside]
    assert np.mean(missing > 1e-9) == pytest.approx(0.24, abs=0.005)
    assert np.min(missing) > -100 * NEWTON
    worst = [0.108, 0.107]
    assert isotropic_force(DIAGONAL, worst, NO_RAILS) == pytest.approx(4.685, abs=0.0005)
    assert isotropic_force_eq17(DIAGONAL, worst, NO_RAILS) == pytest.approx(4.163, abs=0.0005)
    assert 0.51 < np.max(missing) <= 0.5225


def test_equation_17_is_exact_for_the_fixed_orthogonal_machine() -> None:
    exact = isotropic_force(ORTHOGONAL, screen(), NO_RAILS)
    paper = isotropic_force_eq17(ORTHOGONAL, screen(), NO_RAILS)
    inside = np.isfinite(paper)
    assert np.allclose(exact[inside], paper[inside], rtol=0, atol=100 * NEWTON)


def test_no_turn_of_a_base_beats_the_orthogonal_configuration() -> None:
    rng = np.random.default_rng(0)
    angle = rng.uniform(0, 2 * np.pi, (500, 4))
    corners = np.array([2, 2]) + np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    best = max(float(isotropic_force(fixed_machine(p), [2, 2], NO_RAILS)) for p in corners)
    assert 5 < best < 7


@pytest.mark.parametrize("cables", [3, 4, 5, 8])
def test_the_isotropic_force_is_met_in_every_direction_and_no_more(cables: int) -> None:
    machine = ring(cables)
    rng = np.random.default_rng(cables)
    angle = np.linspace(0, 2 * np.pi, 3600, endpoint=False)
    around = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    reached = 0
    for pose in 2 + rng.uniform(-0.4, 0.4, (20, 2)):
        structure = structure_matrix(machine, pose, NO_RAILS)
        force = float(isotropic_force(machine, pose, NO_RAILS))
        if force > 0:
            reached += 1
            assert np.all(wrench_feasible(machine, structure, (force - 1e-9) * around))
            assert not np.all(wrench_feasible(machine, structure, (force + 1e-4) * around))
    assert reached > 5


@pytest.mark.parametrize("cables", [3, 4, 5, 6])
def test_equation_17_is_never_too_high_with_any_number_of_cables(cables: int) -> None:
    machine = ring(cables)
    pose = 2 + np.random.default_rng(cables).uniform(-0.6, 0.6, (1000, 2))
    paper = isotropic_force_eq17(machine, pose, NO_RAILS)
    inside = np.isfinite(paper)
    assert np.sum(inside) > 100
    exact = isotropic_force(machine, pose, NO_RAILS)
    assert np.all(paper[inside] <= exact[inside] + 100 * NEWTON)
    assert np.max(paper[inside]) > 0.3 * np.max(exact)


def test_the_order_of_the_cables_does_not_matter() -> None:
    points = [(0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT)]
    shuffled = fixed_machine([points[i] for i in (2, 0, 3, 1)])
    for quality in (isotropic_force, isotropic_force_eq17, tension_factor, capacity_margin):
        there, here = (quality(m, screen(), NO_RAILS) for m in (shuffled, DIAGONAL))
        assert np.allclose(there, here, rtol=0, atol=1e-12, equal_nan=True)


def test_zero_wrench_tensions_balance_within_bounds() -> None:
    tension = zero_wrench_tension(DIAGONAL, screen(), NO_RAILS)
    inside = np.isfinite(tension[:, 0])
    left = wrench(DIAGONAL, structure_matrix(DIAGONAL, screen(), NO_RAILS), tension)
    assert np.max(np.abs(left[inside])) < 100 * NEWTON
    assert np.nanmin(tension) == 3 and np.nanmax(tension) <= 10


def test_outside_the_workspace_the_force_is_zero_and_the_rest_undefined() -> None:
    outside = [0.25, 0.01]
    assert isotropic_force(DIAGONAL, outside, NO_RAILS) == 0
    for quality in (isotropic_force_eq17, tension_factor, zero_wrench_tension):
        assert np.all(np.isnan(quality(DIAGONAL, outside, NO_RAILS)))


def test_the_margin_is_the_isotropic_force_inside_and_negative_outside() -> None:
    margin = capacity_margin(DIAGONAL, screen(), NO_RAILS)
    inside = np.isfinite(tension_factor(DIAGONAL, screen(), NO_RAILS))
    assert np.array_equal(margin >= 0, inside)
    force = isotropic_force(DIAGONAL, screen(), NO_RAILS)
    assert np.allclose(np.maximum(margin[inside], 0), force[inside], rtol=0, atol=16 * NEWTON)


@pytest.mark.parametrize("cables", [3, 4, 6])
def test_the_margin_is_the_distance_from_the_nearest_facet_by_all_vertices(cables: int) -> None:
    machine = ring(cables)
    bounds = machine.tension.min, machine.tension.max
    vertices = np.array(list(product(*[bounds] * cables)))
    outside = 0
    for pose in 2 + np.random.default_rng(cables).uniform(-0.8, 0.8, (50, 2)):
        columns = structure_matrix(machine, pose, NO_RAILS)
        normals = np.stack([columns[1], -columns[0]], axis=-1)
        support = [np.max(vertices @ columns.T @ p) for p in (*normals, *-normals)]
        margin = float(capacity_margin(machine, pose, NO_RAILS))
        outside += margin < 0
        assert margin == pytest.approx(min(support), rel=0, abs=100 * NEWTON)
    assert 5 < outside < 45


def test_quality_keeps_long_double() -> None:
    pose = CENTRE.astype(np.longdouble)
    width, height = (np.longdouble(size) for size in (WIDTH, HEIGHT))
    exact = 14 * width * height / (width**2 + height**2)
    for force in (isotropic_force, isotropic_force_eq17):
        found = force(DIAGONAL, pose, NO_RAILS)
        assert found.dtype == np.longdouble
        assert abs(found - exact) < 100 * np.finfo(np.longdouble).eps
