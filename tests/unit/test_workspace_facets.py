"""Facets of the wrench set against linear programming, for all dimensions and degenerate sets."""

from itertools import combinations

import numpy as np
import numpy.typing as npt
import pytest
from scipy.optimize import linprog

from turnbuckle.model.workspace.facets import Facets, over_facets, rounding
from turnbuckle.model.workspace.feasible import (
    ball_margin,
    feasible,
    polytope_margin,
    singular,
    smallest_singular_value,
    wrench_closure,
)

Doubles = npt.NDArray[np.float64]
LOWER, UPPER = 1.0, 10.0
LP = 1e-7  # what HiGHS takes for feasible, relative to bounds of 10 N


def random_structures(rows: int, d: int, n: int, seed: int = 0) -> Doubles:
    rng = np.random.default_rng(seed)
    s = rng.normal(size=(rows, d, n))
    return np.asarray(s / np.linalg.norm(s, axis=1, keepdims=True))


def largest_share(s: Doubles, wrench: Doubles, lower: float, upper: float) -> float:
    """Largest k with c + k w feasible, by a linear programme; c is the wrench of mid tensions."""
    n = s.shape[1]
    centre = s @ np.full(n, (lower + upper) / 2)
    found = linprog(
        np.append(np.zeros(n), -1.0),
        A_eq=np.column_stack([s, -wrench]),
        b_eq=centre,
        bounds=[(lower, upper)] * n + [(0, None)],
    )
    assert found.x is not None
    return float(found.x[-1])


@pytest.mark.parametrize(
    ("d", "n"), [(2, 3), (2, 4), (2, 10), (3, 4), (3, 6), (3, 10), (6, 7), (6, 8), (6, 10)]
)
def test_the_facets_bound_the_set_that_linear_programming_finds(d: int, n: int) -> None:
    rng = np.random.default_rng(n)
    for s in random_structures(8, d, n, seed=d):
        wrench = rng.normal(size=d)
        share = largest_share(s, wrench, LOWER, UPPER)
        edge = s @ np.full(n, (LOWER + UPPER) / 2) + share * wrench
        margin = float(polytope_margin(s, LOWER, UPPER, [edge]))
        assert abs(margin) < LP * UPPER
        assert polytope_margin(s, LOWER, UPPER, [edge - 0.01 * wrench]) > 0
        assert polytope_margin(s, LOWER, UPPER, [edge + 0.01 * wrench]) < 0


FLAT_SETS = {
    "all cables of a plane on one line": [[1, -1, 1, -1], [0, 0, 0, 0]],
    "all cables of space on one line": [[1, -1, 1, -1], [1, -1, 1, -1], [0, 0, 0, 0]],
    "all cables of space in one plane": [[1, -0.6, -0.6, 0.2], [0, 0.8, -0.8, 0.3], [0, 0, 0, 0]],
    "parallel pairs in a plane": [[1, -1, 1, -1, 0, 0], [0, 0, 0, 0, 1, -1]],
    "three coplanar cables in space": [
        [1, -0.6, -0.6, 0, 0.1],
        [0, 0.8, -0.8, 0, 0.2],
        [0, 0, 0, 1, -1],
    ],
    "a rigid platform with all anchors in its centre": [
        *[[1, -1, 0, 0, 0, 0, 0.6], [0, 0, 1, -1, 0, 0, 0.8], [0, 0, 0, 0, 1, -1, 0]],
        *[[0] * 7, [0] * 7, [0] * 7],
    ],
}


@pytest.mark.parametrize("name", FLAT_SETS)
@pytest.mark.parametrize("turned", [False, True])
def test_degenerate_sets_are_described_exactly(name: str, turned: bool) -> None:
    s = np.array(FLAT_SETS[name], float)
    d, n = s.shape
    rng = np.random.default_rng(1)
    if turned:
        s = np.linalg.qr(rng.normal(size=(d, d)))[0] @ s
    for _ in range(20):
        inside = s @ rng.uniform(LOWER, UPPER, n)
        assert feasible(polytope_margin(s, LOWER, UPPER, [inside]), s, UPPER)
        wrench = s @ rng.normal(size=n)
        share = largest_share(s, wrench, LOWER, UPPER)
        edge = s @ np.full(n, (LOWER + UPPER) / 2) + share * wrench
        assert abs(polytope_margin(s, LOWER, UPPER, [edge])) < LP * UPPER
        assert polytope_margin(s, LOWER, UPPER, [edge + 0.01 * wrench]) < -1e-4
    if np.linalg.matrix_rank(s) < d:
        off = np.linalg.svd(s)[0][:, -1]
        assert polytope_margin(s, LOWER, UPPER, [s @ np.full(n, 2.0) + off]) < -0.9


def test_flat_and_full_sets_in_one_batch_do_not_disturb_each_other() -> None:
    flat = np.array(FLAT_SETS["all cables of space on one line"], float)
    batch = np.stack([*random_structures(5, 3, 4), flat, *random_structures(5, 3, 4, seed=1)])
    together = ball_margin(batch, LOWER, UPPER)
    alone = [float(ball_margin(s, LOWER, UPPER)) for s in batch]
    assert np.array_equal(together, alone)


def test_a_set_that_is_almost_flat_keeps_its_thickness() -> None:
    thin = 1e-7
    s = np.array([[1, -1, 1, -1], [thin, thin, -thin, -thin]])
    assert ball_margin(s, LOWER, UPPER) == pytest.approx(2 * thin * (UPPER - LOWER), rel=1e-6)


def test_a_pose_on_a_pulley_is_undefined_and_counts_as_infeasible() -> None:
    s = random_structures(3, 2, 4)
    s[1, :, 2] = np.nan
    margin = ball_margin(s, LOWER, UPPER)
    assert np.array_equal(np.isnan(margin), [False, True, False])
    assert not feasible(margin, s, UPPER)[1]
    assert not wrench_closure(s)[1] and np.isnan(smallest_singular_value(s)[1])


def test_large_batches_give_the_same_as_small_ones() -> None:
    s = random_structures(30_000, 2, 5).reshape(100, 300, 2, 5)
    whole = ball_margin(s, LOWER, UPPER, force=2)
    assert whole.shape == (100, 300)
    assert np.array_equal(whole[70], ball_margin(s[70], LOWER, UPPER, force=2))


@pytest.mark.parametrize(("d", "n"), [(2, 4), (3, 6), (6, 9)])
def test_the_margin_of_a_ball_is_that_of_the_worst_of_its_wrenches(d: int, n: int) -> None:
    rng = np.random.default_rng(d)
    space = 3 if d == 6 else d
    (s,) = random_structures(1, d, n, seed=7)
    ball = rng.normal(size=(20_000, d))
    ball[:, :space] /= np.linalg.norm(ball[:, :space], axis=1, keepdims=True)
    if d > space:
        ball[:, space:] *= 0.5 / np.linalg.norm(ball[:, space:], axis=1, keepdims=True)
    exact = float(ball_margin(s, LOWER, UPPER, 1.0, 0.5, space))
    sampled = float(polytope_margin(s, LOWER, UPPER, ball))
    assert exact <= sampled < exact + 0.2


@pytest.mark.parametrize(("d", "n"), [(2, 3), (2, 5), (3, 4), (3, 7), (6, 7), (6, 10)])
def test_wrench_closure_means_that_a_self_stress_tightens_every_cable(d: int, n: int) -> None:
    structures = random_structures(60, d, n, seed=3)
    structures[::2, 0, -1] = -np.sum(structures[::2, 0, :-1], axis=-1)  # else it is too rare
    for s in structures:
        stress = linprog(np.zeros(n), A_eq=s, b_eq=np.zeros(d), bounds=[(1, None)] * n)
        assert wrench_closure(s) == (stress.status == 0)


def test_a_singular_set_is_where_the_cables_do_not_span_the_wrenches() -> None:
    for cables in FLAT_SETS.values():
        s = np.array(cables, float)
        assert singular(s) == (np.linalg.matrix_rank(s) < len(s))
    assert not np.any(singular(random_structures(100, 3, 4)))


def test_the_supports_are_what_the_tensions_give() -> None:
    (s,) = random_structures(1, 3, 5)

    def whole(facets: Facets, _: Doubles) -> Doubles:
        pull, push = facets.pull[..., None], facets.push[..., None]
        return np.concatenate([facets.normals, pull, push], axis=-1)

    found = over_facets(whole, s)
    along, pull, push = found[:, :3] @ s, found[:, 3], found[:, 4]
    assert np.allclose(pull - push, along.sum(-1), atol=rounding(s, 1.0))
    assert np.allclose(pull + push, np.abs(along).sum(-1), atol=rounding(s, 1.0))
    assert np.all(np.sum(np.abs(along) < 1e-12, axis=-1) == 2)


@pytest.mark.parametrize(("d", "n"), [(2, 5), (3, 7), (6, 8)])
def test_normals_are_the_null_vectors_of_the_cables_they_belong_to(d: int, n: int) -> None:
    for s in random_structures(20, d, n, seed=d):
        subsets = [s[:, chosen] for chosen in combinations(range(n), d - 1)]
        normals = np.array([np.linalg.svd(cables)[0][:, -1] for cables in subsets])
        along = normals @ s
        reach = UPPER * np.maximum(along, 0) - LOWER * np.maximum(-along, 0)
        back = UPPER * np.maximum(-along, 0) - LOWER * np.maximum(along, 0)
        expected = np.min(np.minimum(reach.sum(-1), back.sum(-1)))
        assert ball_margin(s, LOWER, UPPER) == pytest.approx(expected, rel=1e-9, abs=1e-11)


def test_cables_that_span_no_facet_add_none() -> None:
    (s,) = random_structures(1, 3, 6)
    s[:, 1] = -s[:, 0]
    outside = np.array([1e5, 0, 0])  # the axis itself would say less than all facets
    expected = np.inf
    for i, j in combinations(range(6), 2):
        normal = np.cross(s[:, i], s[:, j])
        if (i, j) != (0, 1):
            for unit in (normal / np.linalg.norm(normal), -normal / np.linalg.norm(normal)):
                reach = UPPER * np.maximum(unit @ s, 0) - LOWER * np.maximum(-unit @ s, 0)
                expected = min(expected, float(np.sum(reach) - unit @ outside))
    assert polytope_margin(s, LOWER, UPPER, [outside]) == pytest.approx(expected, rel=1e-12)
    axis_alone = UPPER * np.sum(np.maximum(s[0], 0)) - LOWER * np.sum(np.maximum(-s[0], 0)) - 1e5
    assert axis_alone < expected - 0.1


def test_the_theoretical_workspace_of_fixed_pulleys_is_their_polygon() -> None:
    pulleys = np.array([[0, 0], [2, 0.1], [1.5, 1.2], [0.2, 0.7]])
    rng = np.random.default_rng(0)
    corners = rng.dirichlet(np.ones(4), 500) @ pulleys
    outside = np.mean(pulleys, axis=0) + 4 * (pulleys - np.mean(pulleys, axis=0))
    edges = 0.7 * pulleys + 0.3 * np.roll(pulleys, -1, axis=0)
    for poses, inside in ((corners, True), (outside, False), (edges, False)):
        reach = pulleys - poses[:, None, :]
        s = np.swapaxes(reach / np.linalg.norm(reach, axis=-1, keepdims=True), -1, -2)
        assert np.all(wrench_closure(s) == inside)
