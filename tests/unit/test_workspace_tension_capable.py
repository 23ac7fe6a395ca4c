"""Tension capable workspace and maximum tension: Brau's numbers, corrected, and the exact ones."""

import numpy as np
import numpy.typing as npt
import pytest

from turnbuckle.model.workspace.feasible import ball_margin, wrench_closure
from turnbuckle.model.workspace.force import isotropic_force
from turnbuckle.model.workspace.max_tension import (
    max_tension_adjacent,
    max_tension_eq12,
    max_tension_eq17,
    needed_tension,
)
from turnbuckle.model.workspace.tension_capable import (
    Arc,
    capability,
    capable_by_gap,
    capable_ratio_eq23,
    capable_region,
    largest_angle,
    largest_circle_eq22,
)

Doubles = npt.NDArray[np.float64]
EPS = np.finfo(float).eps
SQUARE = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
TETRAHEDRON = np.array([[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]])
SQUARE_SHARE = 1 - 2 * (np.pi / 3 - np.sqrt(3) / 2)


def polygon(corners: int) -> Doubles:
    angle = 2 * np.pi * np.arange(corners) / corners
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def cables(pulleys: Doubles, poses: npt.ArrayLike) -> Doubles:
    reach = pulleys - np.asarray(poses, float)[..., None, :]
    return np.swapaxes(reach / np.linalg.norm(reach, axis=-1, keepdims=True), -1, -2)


def poses_among(pulleys: Doubles, count: int, seed: int = 0) -> Doubles:
    share = np.random.default_rng(seed).dirichlet(np.ones(len(pulleys)), count)
    return np.asarray(share @ pulleys)


def fans(count: int, n: int) -> Doubles:
    angle = np.random.default_rng(n).uniform(0, 2 * np.pi, (count, n))
    return np.stack([np.cos(angle), np.sin(angle)], axis=-2)


def brau_grid() -> Doubles:
    """Their 50 x 50 grid inside the square."""
    x, y = np.meshgrid(*[2 * np.arange(1, 51) / 51 - 1] * 2)
    return np.stack([x.ravel(), y.ravel()], axis=-1)


def test_the_square_at_half_the_tension_is_capable_on_63_77_percent_of_its_area() -> None:
    region = capable_region(SQUARE, 0.5)
    assert region.share == pytest.approx(SQUARE_SHARE, rel=20 * EPS)
    assert region.share == pytest.approx(0.6376557, abs=5e-8)
    assert len(region.arcs) == 4


def test_the_square_at_half_the_tension_is_capable_on_66_4_percent_of_braus_grid() -> None:
    s = cables(SQUARE, brau_grid())
    capable = isotropic_force(s, 0, 1) >= 0.5
    assert np.mean(capable) == 0.664
    assert np.array_equal(capable_by_gap(s, 0.5), capable)
    assert np.array_equal(ball_margin(s, 0, 10, force=5) >= 0, capable)


def test_the_rule_of_the_second_maximum_is_wrong_away_from_the_centre() -> None:
    s = cables(SQUARE, brau_grid())
    assert np.mean(np.max(max_tension_eq17(s, 5), axis=-1) <= 10) == pytest.approx(0.962, abs=5e-4)
    pose = cables(SQUARE, [0.8, 0.1])
    assert np.max(max_tension_eq17(pose, 1)) == pytest.approx(1.389, abs=5e-4)
    assert np.max(max_tension_adjacent(pose, 1)) == pytest.approx(2.5769, abs=5e-5)
    assert needed_tension(pose, 0, 1) == pytest.approx(2.5769, abs=5e-5)


@pytest.mark.parametrize("n", [3, 4])
def test_the_largest_gap_decides_for_three_and_four_cables(n: int) -> None:
    s = fans(20_000, n)
    closed = wrench_closure(s)
    exact = isotropic_force(s, 0, 1)[closed]
    by_gap = 1 / np.max(max_tension_adjacent(s[closed], 1), axis=-1)
    assert np.allclose(by_gap, exact, rtol=0, atol=1e-12)
    assert np.all(isotropic_force(s[~closed], 0, 1) < 1e-12)


@pytest.mark.parametrize(("n", "share"), [(5, 0.126), (6, 0.335), (8, 0.665)])
def test_the_largest_gap_is_too_careful_with_more_cables(n: int, share: float) -> None:
    s = fans(40_000, n)
    s = s[wrench_closure(s)]
    exact = isotropic_force(s, 0, 1)
    by_gap = 1 / np.max(max_tension_adjacent(s, 1), axis=-1)
    assert np.all(by_gap <= exact + 1e-12)
    assert np.mean(by_gap < exact - 1e-9) == pytest.approx(share, abs=0.01)


@pytest.mark.parametrize(
    "pulleys",
    [
        polygon(3),
        SQUARE,
        np.array([[0, 0], [3, 0.1], [0.7, 0.9]]),
        np.array([[0, 0], [2, 0.1], [1.5, 1.2], [0.2, 0.7]]),
        np.array([[0, 0], [4, 0.0], [4, 0.5], [0, 0.5]]),
        np.array([[0, 0], [1, 0], [3, 2.5]]),
    ],
)
@pytest.mark.parametrize("ratio", [0.2, 0.45, 0.7])
def test_the_boundary_of_arcs_holds_what_the_facets_say(pulleys: Doubles, ratio: float) -> None:
    region = capable_region(pulleys, ratio)
    for arc in region.arcs:
        on_arc = cables(pulleys, arc.points(np.linspace(0.001, 0.999, 50)))
        assert np.allclose(isotropic_force(on_arc, 0, 1), ratio, rtol=1e-9)
    low, span = np.min(pulleys, axis=0), np.ptp(pulleys, axis=0)
    x, y = np.meshgrid(*[(np.arange(250) + 0.5) / 250] * 2)
    poses = low + span * np.stack([x.ravel(), y.ravel()], axis=-1)
    capable = isotropic_force(cables(pulleys, poses), 0, 1) >= ratio
    # a grid errs by no more than the cells that the boundary crosses, mostly far less
    edge_cells = 4 * 250
    assert region.area / np.prod(span) == pytest.approx(np.mean(capable), abs=edge_cells / 250**2)
    assert region.area > 0


def test_the_arcs_of_a_triangle_meet_as_its_corners_are_sharp() -> None:
    assert len(capable_region(polygon(3), 0.5).arcs) == 3
    assert capable_region(polygon(3), 0.5).area < capable_region(polygon(3), 0.4).area


def test_the_best_ratio_of_an_equilateral_triangle_is_half_the_root_of_3() -> None:
    assert capable_region(polygon(3), 0.5).best_ratio == pytest.approx(np.sqrt(3) / 2, rel=1e-12)
    assert largest_circle_eq22(1.0, np.sqrt(3) / 2) == pytest.approx(0, abs=1e-15)
    assert largest_circle_eq22(1.0, 0.87) < 0


@pytest.mark.parametrize("ratio", [0.3, 0.5, 0.8])
def test_the_circle_of_equation_22_touches_the_boundary(ratio: float) -> None:
    radius = largest_circle_eq22(2.0, ratio)
    arcs = capable_region(2 * polygon(3), ratio).arcs
    distances = [np.linalg.norm(arc.points(np.linspace(0, 1, 10_001)), axis=-1) for arc in arcs]
    assert np.min(distances) == pytest.approx(radius, rel=1e-7)


@pytest.mark.parametrize(("pulleys", "ratio"), [(polygon(3), 0.87), (polygon(3), 1), (SQUARE, 1.2)])
def test_an_empty_workspace_is_a_result_that_says_so(pulleys: Doubles, ratio: float) -> None:
    region = capable_region(pulleys, ratio)
    assert region.arcs == () and region.area == 0 and region.share == 0
    assert str(region).startswith("the tension capable workspace is empty")
    assert f"{region.best_ratio:.4g}" in str(region)


def test_a_workspace_that_is_not_empty_tells_its_share() -> None:
    assert "63.77%" in str(capable_region(SQUARE, 0.5))


def test_any_machine_tells_how_much_of_its_grid_is_capable() -> None:
    s = cables(SQUARE, brau_grid())
    found = capability(s, 0, 10, 5)
    assert found.share == 0.664 and found.best_ratio < 1
    assert str(found) == "F / t_max = 0.5 is given in every direction on 66.40%"
    centre = capability(cables(SQUARE, [[0, 0]]), 3, 10, 7)
    assert centre.share == 1 and centre.best_ratio == pytest.approx(0.7, rel=8 * EPS)
    five = capability(cables(polygon(5), poses_among(polygon(5), 500)), 1, 10, 15)
    assert five.share == 0 and str(five).startswith("the tension capable workspace is empty")
    with np.errstate(invalid="ignore"):
        on_pulley = cables(SQUARE, [SQUARE[0], [0.0, 0.0]])
    assert capability(on_pulley, 0, 10, 5).share == 0.5


def test_arcs_are_refused_where_they_are_not_the_boundary() -> None:
    dent = np.array([[0, 0], [2, 0], [0.5, 0.5], [0, 2]])
    with pytest.raises(ValueError, match="corners of a convex polygon"):
        capable_region(dent, 0.5)
    with pytest.raises(ValueError, match=r"shape \(5, 2\)"):
        capable_region(polygon(5), 0.5)
    with pytest.raises(ValueError, match="a positive number"):
        capable_region(SQUARE, 0)


def test_the_area_of_a_circle_comes_from_its_arcs() -> None:
    east, west = (3.5, -2.0), (2.5, -2.0)
    lower, upper = Arc(east, west, np.pi / 2), Arc(west, east, np.pi / 2)
    assert lower.swept_area + upper.swept_area == pytest.approx(-np.pi / 4, rel=20 * EPS)
    thirds = sum(lower.part(k / 3, (k + 1) / 3).swept_area for k in range(3))
    assert thirds == pytest.approx(lower.swept_area, rel=20 * EPS)
    assert lower.points(0.5) == pytest.approx([3, -2.5], rel=8 * EPS)
    assert lower.centre == pytest.approx((3, -2), rel=8 * EPS)
    assert lower.radius == pytest.approx(0.5, rel=8 * EPS)


def test_the_area_of_a_shallow_arc_is_no_rounding() -> None:
    steep, shallow = (Arc((0, 0), (1, 0), angle).swept_area for angle in (0.005001, 0.004999))
    assert steep / shallow == pytest.approx(0.005001 / 0.004999, rel=1e-8)
    assert Arc((0, 0), (1, 0), 1e-9).swept_area == pytest.approx(-1e-9 / 6, rel=1e-8)


@pytest.mark.parametrize("ratio", [1e-3, 1e-6, 1e-12])
def test_a_small_force_takes_a_share_of_the_square_in_proportion(ratio: float) -> None:
    region = capable_region(SQUARE, ratio)
    assert len(region.arcs) == 4
    assert 1 - region.share == pytest.approx(2 / 3 * ratio, rel=ratio, abs=20 * EPS)


def test_the_largest_angle_is_that_of_equation_21() -> None:
    assert largest_angle(0.5) == pytest.approx(5 * np.pi / 6, rel=4 * EPS)


def test_the_centre_of_a_regular_tetrahedron_gives_the_root_of_two_thirds() -> None:
    s = cables(TETRAHEDRON, [0.0, 0.0, 0.0])
    for measure in (isotropic_force(s, 0, 1), capable_ratio_eq23(s), 1 / needed_tension(s, 0, 1)):
        assert measure == pytest.approx(np.sqrt(2 / 3), rel=20 * EPS)


def test_equation_23_with_the_smallest_ratio_is_exact_in_a_tetrahedron() -> None:
    inside = cables(TETRAHEDRON, poses_among(TETRAHEDRON, 3000))
    assert np.allclose(capable_ratio_eq23(inside), isotropic_force(inside, 0, 1), atol=1e-12)
    outside = cables(TETRAHEDRON, -3 * TETRAHEDRON)
    assert np.all(capable_ratio_eq23(outside) == 0)


@pytest.mark.parametrize("pulleys", [polygon(3), TETRAHEDRON])
def test_equation_12_is_tight_with_one_redundant_cable(pulleys: Doubles) -> None:
    s = cables(pulleys, poses_among(pulleys, 3000))
    tension = np.max(max_tension_eq12(s, 10), axis=-1)
    assert np.allclose(tension, needed_tension(s, 0, 10), rtol=1e-9)


def test_equation_12_covers_equations_14_and_18() -> None:
    s = cables(polygon(3), poses_among(polygon(3), 200))
    sines = np.abs(s[:, 0, :, None] * s[:, 1, None, :] - s[:, 1, :, None] * s[:, 0, None, :])
    sines[:, range(3), range(3)] = np.inf
    assert np.allclose(max_tension_eq12(s, 10), np.max(10 / sines, axis=-1), rtol=1e-9)
    (s,) = cables(TETRAHEDRON, poses_among(TETRAHEDRON, 1))
    u = s.T
    first = [
        10 * np.linalg.norm(np.cross(u[j], u[k])) / abs(np.linalg.det(u[[0, j, k]]))
        for j, k in ((1, 2), (2, 3), (1, 3))
    ]
    assert max_tension_eq12(s, 10)[0] == pytest.approx(max(first), rel=1e-9)


def test_equation_12_finds_no_limit_where_no_choice_of_cables_is_regular() -> None:
    s = np.array([[1.0, -1.0, 1.0], [0.0, 0.0, 0.0]])
    assert np.all(np.isinf(max_tension_eq12(s, 1)))
    assert np.isinf(needed_tension(s, 0, 1)) and needed_tension(s, 2, 0) == 4


@pytest.mark.parametrize(("d", "n", "space"), [(2, 4, 2), (3, 6, 3), (3, 6, 2), (6, 12, 3)])
def test_the_needed_tension_is_just_enough(d: int, n: int, space: int) -> None:
    rng = np.random.default_rng(d)
    s = rng.normal(size=(100, d, n))
    s /= np.linalg.norm(s, axis=1, keepdims=True)
    needed = needed_tension(s, 0.5, 2.0, 0.3 * (d > space), space)
    possible = np.isfinite(needed)
    assert np.array_equal(possible, wrench_closure(s)) and np.sum(possible) > 3
    for row, upper in zip(s[possible], needed[possible], strict=True):
        margin = ball_margin(row, 0.5, upper, 2.0, 0.3 * (d > space), space)
        assert abs(margin) < 1e-12 * upper
        assert ball_margin(row, 0.5, 0.999 * upper, 2.0, 0.3 * (d > space), space) < 0
