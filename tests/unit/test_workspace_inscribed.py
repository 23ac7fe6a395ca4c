"""The largest inscribed circle and screen against exact geometry."""

import numpy as np
import numpy.typing as npt
import pytest

from turnbuckle.model.reading import load_machine
from turnbuckle.model.workspace.feasible import ball_margin
from turnbuckle.model.workspace.inscribed import largest_circle, largest_screen
from turnbuckle.model.workspace.maps import Measure
from turnbuckle.model.workspace.structures import structures
from turnbuckle.model.workspace.tension_capable import capable_region, largest_circle_eq22

Doubles = npt.NDArray[np.float64]
SQUARE = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
DIAGONAL = load_machine("tests/machines/fixed_diagonal.toml")
LOW, HIGH = np.array([-1.0, -1.0]), np.array([1.0, 1.0])


def polygon(corners: int) -> Doubles:
    angle = 2 * np.pi * np.arange(corners) / corners
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def capable(pulleys: Doubles, ratio: float) -> Measure:
    """Margin of the force `ratio` with tensions from 0 to 1."""

    def margin(poses: Doubles) -> Doubles:
        reach = pulleys - poses[:, None, :]
        with np.errstate(invalid="ignore"):
            s = reach / np.linalg.norm(reach, axis=-1, keepdims=True)
        return ball_margin(np.swapaxes(s, -1, -2), 0, 1, ratio)

    return margin


def within_triangle(poses: Doubles) -> Doubles:
    x, y = poses.T
    return np.asarray(np.minimum(np.minimum(x, y), 1 - x - y))


def test_the_largest_circle_of_a_triangle_is_its_incircle() -> None:
    found = largest_circle(within_triangle, [0, 0], [1, 1])
    assert found is not None
    radius = 1 - np.sqrt(0.5)
    assert found.half_size == pytest.approx((radius, radius), abs=1e-9)
    assert found.centre == pytest.approx((radius, radius), abs=1e-5)
    assert found.accuracy < 1e-6


@pytest.mark.parametrize("ratio", [0.3, 0.8])
def test_the_largest_circle_in_brau_s_triangle_is_that_of_equation_22(ratio: float) -> None:
    found = largest_circle(capable(polygon(3), ratio), LOW, HIGH)
    assert found is not None
    assert found.half_size[0] == pytest.approx(largest_circle_eq22(1, ratio), abs=1e-9)
    assert found.centre == pytest.approx((0, 0), abs=1e-7)


@pytest.mark.parametrize("aspect", [1.0, 16 / 9])
def test_the_largest_screen_in_brau_s_square_touches_the_arcs(aspect: float) -> None:
    found = largest_screen(capable(SQUARE, 0.5), LOW, HIGH, aspect)
    assert found is not None
    half = np.array(found.half_size)
    assert half[0] / half[1] == pytest.approx(aspect, rel=1e-12)
    arcs = capable_region(SQUARE, 0.5).arcs
    on_arcs = np.concatenate([arc.points(np.linspace(0, 1, 20_001)) for arc in arcs])
    clear = np.max(np.abs(on_arcs - found.centre) / half, axis=-1)
    assert np.min(clear) == pytest.approx(1, abs=1e-7)
    at_centre = np.min(np.max(np.abs(on_arcs) / [aspect, 1], axis=-1))
    assert half[1] >= at_centre - 1e-9


def test_the_larger_of_two_pieces_is_found() -> None:
    def two_discs(poses: Doubles) -> Doubles:
        left = 0.30 - np.linalg.norm(poses - [-0.5, 0.1], axis=-1)
        right = 0.31 - np.linalg.norm(poses - [0.5, -0.2], axis=-1)
        return np.asarray(np.maximum(left, right))

    found = largest_circle(two_discs, LOW, HIGH)
    assert found is not None
    assert found.half_size[0] == pytest.approx(0.31, abs=1e-9)
    assert found.centre == pytest.approx((0.5, -0.2), abs=1e-6)


def test_a_hole_limits_the_circle() -> None:
    hole = np.array([0.1, 0.0])
    found = largest_circle(lambda p: np.linalg.norm(p - hole, axis=-1) - 0.2, LOW, HIGH)
    assert found is not None
    x, y = np.abs(found.centre)
    radius = found.half_size[0]
    assert radius == pytest.approx(1 - max(x, y), abs=1e-9)
    assert np.linalg.norm(found.centre - hole) == pytest.approx(radius + 0.2, abs=1e-9)


def test_the_box_limits_the_shape() -> None:
    found = largest_circle(lambda p: np.ones(len(p)), [0, 0], [2, 1])
    assert found is not None and found.half_size[1] == pytest.approx(0.5, abs=1e-12)
    screen = largest_screen(lambda p: np.ones(len(p)), [0, 0], [2, 1], 2.0)
    assert screen is not None and screen.half_size == pytest.approx((1, 0.5), abs=1e-12)


def test_without_a_feasible_pose_there_is_no_shape() -> None:
    assert largest_circle(capable(polygon(3), 0.9), LOW, HIGH) is None
    assert largest_screen(capable(polygon(3), 0.9), LOW, HIGH, 1.5) is None


def test_poses_on_pulleys_are_no_part_of_the_shape() -> None:
    lower, upper = DIAGONAL.tension.min, DIAGONAL.tension.max
    size = np.array(DIAGONAL.frame.size)

    def margin(poses: Doubles) -> Doubles:
        return ball_margin(structures(DIAGONAL, poses, np.zeros(0)), lower, upper, 2.0)

    found = largest_screen(margin, [0, 0], size, size[0] / size[1], cells=60)
    assert found is not None
    half = np.array(found.half_size)
    along = np.linspace(-1, 1, 401)
    across = np.ones(401)
    sides = [(along, across), (along, -across), (across, along), (-across, along)]
    outline = half * np.concatenate([np.stack(side, axis=-1) for side in sides])
    assert np.min(margin(found.centre + 0.999 * outline)) > 0
    assert np.min(margin(found.centre + 1.001 * outline)) < 0
