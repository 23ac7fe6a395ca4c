"""Rotations and angles without a library: to a few units in the last place, in both precisions."""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from turnbuckle.codegen.evaluate import DOUBLE, FLOAT, Arithmetic, evaluate
from turnbuckle.codegen.lower import lower
from turnbuckle.codegen.simplify import simplify
from turnbuckle.model.symbolic.angle import (
    arc_tangent,
    planar_rotation,
    rotation_vector_rate,
    spatial_rotation,
)
from turnbuckle.model.symbolic.function import Input, ModelFunction, make_input, vector_output
from turnbuckle.model.symbolic.scalar import Vector

Wide = NDArray[np.longdouble]
POINTS = 20000
PRECISIONS = pytest.mark.parametrize("arithmetic", [DOUBLE, FLOAT], ids=lambda a: str(a.name))


def computed(
    inputs: tuple[Input, ...], values: Vector, points: list[Any], arithmetic: Arithmetic
) -> Wide:
    """Values (k, m) at points (k, size), as the C computes them."""
    function = ModelFunction("f", "", "", inputs, (vector_output("values", "1", values),))
    typed = [np.asarray(arithmetic.number(p)) for p in points]
    (entries,) = evaluate(simplify(lower(function)), typed, arithmetic).outputs
    return np.asarray(np.stack(entries, axis=-1), np.longdouble)


def argument(name: str, size: int) -> Input:
    return make_input(name, (size,), "rad", [-10.0], [10.0])


def directions(random: np.random.Generator, most: float) -> NDArray[np.float64]:
    """Rotation vectors of up to `most`, some of them tiny, one of them zero."""
    vectors = random.standard_normal((POINTS, 3))
    sizes = most * random.random((POINTS, 1)) ** (1 / 3)
    sizes[::10] = 10.0 ** random.uniform(-12, 0, (POINTS // 10, 1))
    vectors *= sizes / np.linalg.norm(vectors, axis=1, keepdims=True)
    vectors[0] = 0
    return vectors


def rodrigues(vectors: Wide) -> Wide:
    """exp([t]x) in long double."""
    size = np.sqrt(np.sum(vectors**2, axis=1))
    safe = np.where(size > 0, size, 1)
    a, b = np.where(size > 0, np.sin(size) / safe, 1), 2 * np.sin(size / 2) ** 2 / safe**2
    turn = np.zeros((len(vectors), 3, 3), np.longdouble)
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        turn[:, j, i], turn[:, i, j] = vectors[:, k], -vectors[:, k]
    return np.asarray(np.eye(3) + a[:, None, None] * turn + b[:, None, None] * (turn @ turn))


@PRECISIONS
@pytest.mark.parametrize(("most", "units"), [(1.0, 1.5), (2.0, 2.0), (np.pi, 3.5)])
def test_a_planar_rotation_is_that_of_sine_and_cosine(
    arithmetic: Arithmetic, most: float, units: float
) -> None:
    angle = argument("angle", 1)
    points = np.random.default_rng(1).uniform(-most, most, (POINTS, 1))
    rows = planar_rotation(angle.scalars()[0])
    found = computed((angle,), [x for row in rows for x in row], [points], arithmetic)
    exact = np.asarray(arithmetic.number(points[:, 0])).astype(np.longdouble)
    c, s = np.cos(exact), np.sin(exact)
    assert np.max(np.abs(found - np.stack([c, -s, s, c], axis=1))) < units * arithmetic.epsilon


@PRECISIONS
@pytest.mark.parametrize(("most", "units"), [(1.0, 2.0), (2.0, 2.5), (np.pi, 4.0)])
def test_a_spatial_rotation_is_that_of_rodrigues(
    arithmetic: Arithmetic, most: float, units: float
) -> None:
    vector = argument("vector", 3)
    points = directions(np.random.default_rng(2), most)
    rows = spatial_rotation(vector.scalars())
    found = computed((vector,), [x for row in rows for x in row], [points], arithmetic)
    exact = rodrigues(np.asarray(arithmetic.number(points)).astype(np.longdouble))
    assert np.max(np.abs(found.reshape(-1, 3, 3) - exact)) < units * arithmetic.epsilon


@PRECISIONS
def test_an_arc_tangent_is_right_all_around(arithmetic: Arithmetic) -> None:
    pair = argument("pair", 2)
    random = np.random.default_rng(3)
    angles = np.concatenate(
        [
            random.uniform(-np.pi, np.pi, POINTS),
            np.arange(-8, 9) * np.pi / 8,
            10.0 ** random.uniform(-30, 0, 1000),
        ]
    )
    points = np.asarray(arithmetic.number(np.stack([np.sin(angles), np.cos(angles)], axis=1)))
    found = computed((pair,), [arc_tangent(*pair.scalars())], [points], arithmetic)[:, 0]
    wide = points.astype(np.longdouble)
    exact = np.arctan2(wide[:, 0], wide[:, 1])
    assert np.max(np.abs(found - exact) - 3 * arithmetic.epsilon * np.abs(exact)) <= 0


def test_a_rotation_vector_follows_the_spin() -> None:
    vector, spin = argument("vector", 3), argument("spin", 3)
    random = np.random.default_rng(4)
    points, spins = directions(random, 3.0), random.standard_normal((POINTS, 3))
    rates = rotation_vector_rate(vector.scalars(), spin.scalars())
    found = computed((vector, spin), rates, [points, spins], DOUBLE)
    step = np.longdouble(1e-6)
    wide = points.astype(np.longdouble)
    ahead, behind = rodrigues(wide + step * found), rodrigues(wide - step * found)
    turned = (ahead - behind) / (2 * step) @ np.swapaxes(rodrigues(wide), 1, 2)
    read = np.stack([turned[:, 2, 1], turned[:, 0, 2], turned[:, 1, 0]], axis=1)
    assert np.max(np.abs(read - spins)) < 1e-9


def test_a_rotation_is_smooth_at_zero() -> None:
    vector = argument("vector", 3)
    rows = spatial_rotation(vector.scalars())
    found = computed((vector,), [x for row in rows for x in row], [np.zeros((1, 3))], DOUBLE)
    assert np.array_equal(found.reshape(3, 3), np.eye(3))
