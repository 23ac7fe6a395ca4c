"""Laws that the workspace analyses obey for any set of cables."""

from random import Random
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from turnbuckle.model.workspace.feasible import (
    ball_margin,
    smallest_singular_value,
    wrench_closure,
    wrench_margin,
)
from turnbuckle.model.workspace.force import force_along, isotropic_force, tension_factor
from turnbuckle.model.workspace.max_tension import needed_tension

Doubles = npt.NDArray[np.float64]
LOWER, UPPER = 1.0, 10.0
NEWTON = 1e-9  # of 10 N: facets of nearly parallel cables have lost some digits

unhurried = settings(max_examples=50)


class Cables(NamedTuple):
    """A structure matrix (d, n) and how many of its rows are forces."""

    structure: Doubles
    space: int


@st.composite
def cables(draw: st.DrawFn) -> Cables:
    """Cables of a random machine of any kind, well away from its singular set."""
    d, space = draw(st.sampled_from([(2, 2), (3, 2), (3, 3), (6, 3)]))
    n = draw(st.integers(d + 1, 10))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    s = rng.normal(size=(d, n))
    s[:space] /= np.linalg.norm(s[:space], axis=0)
    if draw(st.booleans()):  # else the zero wrench would rarely be feasible
        s[:, n // 2 :] = s[:, n // 2 :] / 3 - s[:, : n - n // 2]
        s[:space] /= np.linalg.norm(s[:space], axis=0)
    assume(smallest_singular_value(s) > 0.05)
    return Cables(s, space)


@st.composite
def turned(draw: st.DrawFn) -> tuple[Cables, Doubles]:
    """Cables, and a rotation of the fixed frame as it acts on wrenches."""
    drawn = draw(cables())
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    spin = Rotation.random(rng=rng).as_matrix()
    plane = Rotation.from_rotvec([0, 0, rng.uniform(0, 7)]).as_matrix()
    turn = np.eye(len(drawn.structure))
    turn[: drawn.space, : drawn.space] = spin if drawn.space == 3 else plane[:2, :2]
    if len(turn) == 6:
        turn[3:, 3:] = spin
    return drawn, turn


def measures(s: Doubles, space: int) -> Doubles:
    return np.array(
        [
            isotropic_force(s, LOWER, UPPER, space),
            ball_margin(s, LOWER, UPPER, 2.0, 0.5, space),
            ball_margin(s, LOWER, UPPER),
            needed_tension(s, LOWER, 2.0, 0.5, space),
            tension_factor(s, LOWER, UPPER),
            smallest_singular_value(s),
        ]
    )


def forces_alone(s: Doubles, space: int) -> Doubles:
    """What is said of forces without a moment."""
    return np.array(
        [
            isotropic_force(s, LOWER, UPPER, space),
            needed_tension(s, LOWER, 2.0, space=space),
            tension_factor(s, LOWER, UPPER),
        ]
    )


def same(one: npt.ArrayLike, other: npt.ArrayLike) -> bool:
    return np.allclose(one, other, rtol=1e-9, atol=NEWTON, equal_nan=True)


@unhurried
@given(turned())
def test_nothing_depends_on_how_the_frame_is_turned(drawn: tuple[Cables, Doubles]) -> None:
    (s, space), turn = drawn
    assert same(measures(s, space), measures(turn @ s, space))
    assert wrench_closure(s) == wrench_closure(turn @ s)


@unhurried
@given(cables(), st.randoms(use_true_random=False))
def test_nothing_depends_on_the_order_of_the_cables(drawn: Cables, random: Random) -> None:
    s, space = drawn
    order = random.sample(range(s.shape[1]), s.shape[1])
    assert same(measures(s, space), measures(s[:, order], space))


@unhurried
@given(cables(), st.floats(0.1, 10))
def test_forces_without_a_moment_do_not_depend_on_the_lever(drawn: Cables, lever: float) -> None:
    s, space = drawn
    other = s.copy()
    other[space:] /= lever
    assume(smallest_singular_value(other) > 0.05)
    assert same(forces_alone(s, space), forces_alone(other, space))
    assert wrench_closure(s) == wrench_closure(other)


@unhurried
@given(cables(), st.floats(0.01, 100))
def test_forces_scale_with_the_bounds(drawn: Cables, factor: float) -> None:
    s, space = drawn
    force = isotropic_force(s, LOWER, UPPER, space)
    assert same(isotropic_force(s, factor * LOWER, factor * UPPER, space) / factor, force)
    margin = ball_margin(s, factor * LOWER, factor * UPPER, factor * 2.0)
    assert same(margin / factor, ball_margin(s, LOWER, UPPER, 2.0))
    needed = needed_tension(s, factor * LOWER, factor * 2.0)
    assert same(needed / factor, needed_tension(s, LOWER, 2.0))


@unhurried
@given(cables(), st.floats(0, 1), st.floats(0, 1))
def test_wider_bounds_take_no_wrench_away(drawn: Cables, less: float, more: float) -> None:
    s, space = drawn
    narrow = isotropic_force(s, LOWER, UPPER, space)
    assert isotropic_force(s, LOWER * less, UPPER * (1 + more), space) >= narrow - NEWTON


@unhurried
@given(cables())
def test_another_cable_that_may_go_slack_takes_no_force_away(drawn: Cables) -> None:
    s, space = drawn
    assume(s.shape[1] > s.shape[0] + 1)
    fewer = isotropic_force(s[:, :-1], 0.0, UPPER, space)
    assert isotropic_force(s, 0.0, UPPER, space) >= fewer - NEWTON


@unhurried
@given(cables(), st.integers(0, 2**32 - 1))
def test_the_margin_of_a_wrench_is_its_distance_from_the_boundary(drawn: Cables, seed: int) -> None:
    s, _ = drawn
    rng = np.random.default_rng(seed)
    wrench = s @ rng.uniform(LOWER, UPPER, s.shape[1])
    margin = float(wrench_margin(s, LOWER, UPPER, wrench))
    unit = rng.normal(size=len(s))
    unit /= np.linalg.norm(unit)
    assert margin >= -NEWTON
    assert wrench_margin(s, LOWER, UPPER, wrench + margin * unit) >= -NEWTON
    assert wrench_margin(s, LOWER, UPPER, wrench + 1000 * unit) < 0


@unhurried
@given(cables(), st.integers(0, 2**32 - 1))
def test_no_direction_is_weaker_than_the_isotropic_force(drawn: Cables, seed: int) -> None:
    s, space = drawn
    direction = np.zeros(len(s))
    direction[:space] = np.random.default_rng(seed).normal(size=space)
    direction /= np.linalg.norm(direction)
    force = force_along(s, LOWER, UPPER, direction)
    assert force >= isotropic_force(s, LOWER, UPPER, space) - NEWTON
    assert wrench_margin(s, LOWER, UPPER, force * direction) >= -NEWTON or force == 0
    assert force == pytest.approx(force_along(s, LOWER, UPPER, 2 * direction) * 2)
