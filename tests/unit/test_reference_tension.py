"""The reference tension distribution against other solvers, brute force and the papers."""

import daqp
import numpy as np
import numpy.typing as npt
import pytest
import quadprog
from scipy.optimize import linprog, lsq_linear

from turnbuckle.model.machine import Cable, Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.kinematics import structure_matrix
from turnbuckle.model.reference.optimality import optimality_gap
from turnbuckle.model.reference.tension import (
    POLICIES,
    distribute_tension,
    minimum_norm_tension,
    wrench_feasible,
)
from turnbuckle.model.reference.wrench_set import largest_share

Doubles = npt.NDArray[np.float64]
STOCK = load_machine("machines/yoon2023.toml")
LOWER, UPPER = STOCK.tension.min, STOCK.tension.max
EPS = np.finfo(float).eps
SCREEN_WIDTH, SCREEN_HEIGHT = STOCK.target.size
CABLE_COUNTS = [3, 4, 5, 6, 8]


def diagonal_machine() -> Machine:
    """Yoon Fig. 4, top row: four pulleys fixed at the corners of the screen."""
    corners = [(0.0, 0.0), (SCREEN_WIDTH, 0.0), (SCREEN_WIDTH, SCREEN_HEIGHT), (0.0, SCREEN_HEIGHT)]
    cables = [Cable.model_validate({"base": [f"{x!r} m", f"{y!r} m"]}) for x, y in corners]
    return STOCK.model_copy(update={"cables": tuple(cables)})


def random_problems(cables: int, count: int) -> tuple[Doubles, Doubles]:
    """Cables in random directions; wrenches of random bounded tensions, pushed out to twice."""
    rng = np.random.default_rng(cables)
    angle = rng.uniform(0, 2 * np.pi, (count, cables))
    structure = np.stack([np.cos(angle), np.sin(angle)], axis=-2)
    share = rng.uniform(0, 1, (count, cables))
    tension = LOWER + (UPPER - LOWER) * np.clip(3 * share - 1, 0, 1)
    wrench = np.sum(structure * tension[:, None, :], axis=-1)
    return structure, wrench * rng.choice([0.5, 1, 1, 2], (count, 1))


def published_solution(s: Doubles, w: Doubles, upper: float | None) -> Doubles | None:
    """Goldfarb and Idnani's solver; None where it finds the problem infeasible."""
    n = s.shape[1]
    rows = np.vstack([s, np.eye(n), -np.eye(n) if upper else np.zeros((0, n))])
    limits = np.concatenate([w, np.full(n, LOWER), np.full(n, -upper) if upper else np.zeros(0)])
    try:
        return np.asarray(quadprog.solve_qp(np.eye(n), np.zeros(n), rows.T, limits, meq=2)[0])
    except ValueError:
        return None


def another_published_solution(s: Doubles, w: Doubles) -> Doubles:
    """The dual active-set solver DAQP."""
    n = s.shape[1]
    lower, upper = np.concatenate([np.full(n, LOWER), w]), np.concatenate([np.full(n, UPPER), w])
    equality = 5
    sense = np.concatenate([np.zeros(n), np.full(2, equality)]).astype(np.int32)
    rows = np.ascontiguousarray(s)
    solution, _, flag, _ = daqp.solve(np.eye(n), np.zeros(n), rows, upper, lower, sense)
    assert flag == 1
    return np.asarray(solution)


def is_feasible(s: Doubles, w: Doubles) -> bool:
    return bool(
        linprog(np.zeros(s.shape[1]), A_eq=s, b_eq=w, bounds=(LOWER, UPPER), method="highs").success
    )


@pytest.mark.parametrize("cables", CABLE_COUNTS)
def test_feasible_tensions_are_those_of_two_published_solvers(cables: int) -> None:
    structure, wrench = random_problems(cables, 300)
    wrench = 0.999 * wrench + 0.001 * np.sum(structure, axis=-1) * (LOWER + UPPER) / 2
    found = distribute_tension(STOCK, structure, wrench)
    inside = np.flatnonzero(found.feasible)
    assert 100 < len(inside) < 300
    for i in inside:
        first = published_solution(structure[i], wrench[i], UPPER)
        assert first is not None
        assert np.allclose(found.tension[i], first, rtol=0, atol=1e-8)
        second = another_published_solution(structure[i], wrench[i])
        assert np.allclose(found.tension[i], second, rtol=0, atol=1e-6)


@pytest.mark.parametrize("cables", CABLE_COUNTS)
def test_the_verdict_is_that_of_a_linear_program(cables: int) -> None:
    structure, wrench = random_problems(cables, 200)
    off_the_boundary = 1 + 1e-6 * np.where(np.arange(200) % 2, 1, -1)[:, None]
    wrench = wrench * off_the_boundary
    verdict = wrench_feasible(STOCK, structure, wrench)
    assert 0.2 < np.mean(verdict) < 0.95
    assert [is_feasible(s, w) for s, w in zip(structure, wrench, strict=True)] == list(verdict)


@pytest.mark.parametrize("policy", POLICIES)
@pytest.mark.parametrize("cables", CABLE_COUNTS)
def test_every_tension_is_within_bounds_and_has_the_least_norm(cables: int, policy: str) -> None:
    structure, wrench = random_problems(cables, 2000 if cables < 8 else 100)
    found = distribute_tension(STOCK, structure, wrench, policy)
    assert found.tension.min() >= LOWER and found.tension.max() <= UPPER
    if policy != "paper":
        met = np.abs(found.delivered - wrench)[found.feasible]
        assert np.max(met) < 100 * cables * UPPER * EPS
        assert np.max(optimality_gap(structure, found.tension, LOWER, UPPER)) < 1e-9


def test_the_optimality_gap_sees_a_tension_that_is_not_optimal() -> None:
    structure, wrench = random_problems(4, 500)
    best = distribute_tension(STOCK, structure, wrench, "closest").tension
    _, _, rows = np.linalg.svd(structure)
    for sign in (1, -1):
        moved = best + sign * 0.01 * rows[:, 2, :]
        within = np.all((moved >= LOWER) & (moved <= UPPER), axis=-1)
        assert np.sum(within) > 20
        assert np.all(optimality_gap(structure, moved, LOWER, UPPER)[within] > 1e-5)


@pytest.mark.parametrize("cables", CABLE_COUNTS)
def test_closest_delivers_the_feasible_wrench_nearest_to_the_wanted_one(cables: int) -> None:
    structure, wrench = random_problems(cables, 200)
    wrench *= 2
    found = distribute_tension(STOCK, structure, wrench, "closest")
    assert not np.all(found.feasible)
    for s, w, delivered in zip(structure, wrench, found.delivered, strict=True):
        nearest = lsq_linear(s, w, (LOWER, UPPER), method="bvls", tol=1e-14)
        assert np.allclose(delivered, s @ nearest.x, rtol=0, atol=1e-7)


@pytest.mark.parametrize("cables", CABLE_COUNTS)
def test_scale_delivers_the_largest_fraction_of_the_wanted_wrench(cables: int) -> None:
    structure, wrench = random_problems(cables, 200)
    wrench *= 2
    found = distribute_tension(STOCK, structure, wrench, "scale")
    nearest = distribute_tension(STOCK, structure, wrench, "closest")
    cost = np.zeros(cables + 1)
    cost[-1] = -1
    bounds = [(LOWER, UPPER)] * cables + [(0, 1)]
    scaled = 0
    for i in range(200):
        rows = np.column_stack([structure[i], -wrench[i]])
        best = linprog(cost, A_eq=rows, b_eq=np.zeros(2), bounds=bounds, method="highs")
        scaled += best.x is not None
        wanted = nearest.delivered[i] if best.x is None else best.x[-1] * wrench[i]
        assert np.allclose(found.delivered[i], wanted, rtol=0, atol=1e-6)
    assert scaled > 20


@pytest.mark.parametrize("cables", CABLE_COUNTS)
def test_paper_is_equation_22_clipped_as_in_equation_23(cables: int) -> None:
    structure, _ = random_problems(cables, 200)
    wrench = np.random.default_rng(cables).normal(0, 8, (200, 2))
    found = distribute_tension(STOCK, structure, wrench, "paper")
    unsolved = 0
    for i in range(200):
        unbounded = published_solution(structure[i], wrench[i], None)
        unsolved += unbounded is None
        wanted = np.full(cables, LOWER) if unbounded is None else np.minimum(unbounded, UPPER)
        assert np.allclose(found.tension[i], wanted, rtol=0, atol=1e-6)
        assert np.allclose(found.delivered[i], structure[i] @ found.tension[i], atol=1e-12)
    assert unsolved < 150
    assert np.any(found.tension == UPPER)


def test_the_papers_clip_loses_force_where_a_bounded_solution_exists() -> None:
    """A case of the audit: 8 N at 195 degrees comes out 1.16 N off. Larger losses exist."""
    angle = np.deg2rad(195)
    wanted = 8 * np.array([np.cos(angle), np.sin(angle)])
    structure = structure_matrix(diagonal_machine(), [0.3795, 0.09656], np.zeros(0))
    exact = distribute_tension(STOCK, structure, wanted, "scale")
    paper = distribute_tension(STOCK, structure, wanted, "paper")
    assert exact.feasible and paper.feasible
    assert np.allclose(exact.delivered, wanted, rtol=0, atol=100 * EPS)
    assert np.isclose(np.linalg.norm(paper.delivered - wanted), 1.16, atol=0.005)


def test_the_papers_clip_loses_force_in_about_one_feasible_case_in_a_hundred() -> None:
    rng = np.random.default_rng(0)
    pose = rng.uniform(0, 1, (40000, 2)) * STOCK.target.size
    angle, size = rng.uniform(0, 2 * np.pi, 40000), rng.integers(1, 9, 40000)
    wanted = size[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    structure = structure_matrix(diagonal_machine(), pose, np.zeros((40000, 0)))
    paper = distribute_tension(STOCK, structure, wanted, "paper")
    lost = np.linalg.norm(paper.delivered - wanted, axis=-1)[paper.feasible]
    assert np.mean(lost > 1e-6) == pytest.approx(0.0088, abs=0.0015)


@pytest.mark.parametrize("cables", [3, 4, 5])
def test_every_corner_and_edge_of_the_wrench_set_is_feasible_and_met(cables: int) -> None:
    structure, _ = random_problems(cables, 50)
    for pattern in range(3**cables):
        digits = (pattern // 3 ** np.arange(cables)) % 3
        if np.sum(digits == 2) > 1:
            continue
        tension = np.choose(digits, [LOWER, UPPER, (LOWER + UPPER) / 2]).astype(float)
        wrench = structure @ tension
        found = distribute_tension(STOCK, structure, wrench, "closest")
        assert np.all(found.feasible)
        assert np.max(np.abs(found.delivered - wrench)) < 1e3 * UPPER * EPS


def test_parallel_cables_share_the_load() -> None:
    up, right = (0.0, 1.0), (1.0, 0.0)
    structure = np.array([up, up, up, (0.0, -1.0), right, (-1.0, 0.0)]).T
    found = distribute_tension(STOCK, structure, [0.0, 9.0], "scale")
    assert found.feasible
    assert np.allclose(found.tension, [4, 4, 4, 3, 3, 3], rtol=0, atol=100 * EPS)


@pytest.mark.parametrize("policy", ["scale", "closest"])
def test_cables_all_on_one_line_give_what_they_can_along_it(policy: str) -> None:
    structure = np.array([[1.0, 1.0, -1.0, -1.0], [0.0, 0.0, 0.0, 0.0]])
    along = distribute_tension(STOCK, structure, [4.0, 0.0], policy)
    assert along.feasible
    assert np.allclose(along.tension, [5, 5, 3, 3], rtol=0, atol=100 * EPS)
    far = distribute_tension(STOCK, structure, [40.0, 0.0], policy)
    assert not far.feasible
    assert np.allclose(far.tension, [10, 10, 3, 3], rtol=0, atol=100 * EPS)
    across = distribute_tension(STOCK, structure, [0.0, 5.0], policy)
    assert not across.feasible
    assert np.allclose(across.delivered, 0, rtol=0, atol=100 * EPS)


def test_nearly_parallel_cables_still_meet_the_wrench_with_the_least_norm() -> None:
    rng = np.random.default_rng(3)
    for spread in 10.0 ** -np.arange(1, 8):
        angle = rng.uniform(0, 2 * np.pi, (500, 1)) + spread * rng.normal(size=(500, 4))
        angle += np.pi * rng.integers(0, 2, (500, 4))
        structure = np.stack([np.cos(angle), np.sin(angle)], axis=-2)
        wrench = np.sum(structure * rng.uniform(LOWER, UPPER, (500, 1, 4)), axis=-1)
        found = distribute_tension(STOCK, structure, wrench, "closest")
        assert np.all(found.feasible)
        assert np.max(np.abs(found.delivered - wrench)) < 1e3 * UPPER * EPS
        wide = distribute_tension(STOCK, structure, wrench.astype(np.longdouble), "closest")
        assert np.allclose(found.tension, wide.tension, rtol=0, atol=1e-4)


def test_where_the_zero_wrench_is_infeasible_scale_takes_the_largest_feasible_part() -> None:
    structure = np.array([[0.6, 0.8, 0.0], [0.8, 0.6, 1.0]])  # all three pull up
    assert not wrench_feasible(STOCK, structure, [0.0, 0.0])
    reached = distribute_tension(STOCK, structure, [30.0, 40.0], "scale")
    assert np.isclose(reached.delivered[0] / reached.delivered[1], 0.75, rtol=0, atol=100 * EPS)
    assert np.linalg.norm(reached.delivered) > np.linalg.norm(structure @ np.full(3, LOWER))
    away = distribute_tension(STOCK, structure, [0.0, -5.0], "scale")
    nearest = distribute_tension(STOCK, structure, [0.0, -5.0], "closest")
    assert np.array_equal(away.tension, nearest.tension)


def test_scale_takes_the_closest_where_the_ray_runs_beside_the_wrench_set() -> None:
    structure = np.array([[1.0, 1.0, 0.0], [0.0, 0.0, 1.0]])  # the third always pulls up
    along_a_cable = 60 * structure[:, 0]
    assert np.isnan(largest_share(STOCK, structure[None], along_a_cable[None]))
    beside = distribute_tension(STOCK, structure, along_a_cable, "scale")
    nearest = distribute_tension(STOCK, structure, along_a_cable, "closest")
    assert np.array_equal(beside.tension, nearest.tension)


def test_long_double_is_met_to_long_double() -> None:
    structure, wrench = random_problems(5, 500)
    fine = structure.astype(np.longdouble)
    fine /= np.sqrt(np.sum(fine**2, axis=-2, keepdims=True))
    for policy in POLICIES:
        wide = distribute_tension(STOCK, fine, wrench.astype(np.longdouble), policy)
        assert wide.tension.dtype == wide.delivered.dtype == np.longdouble
        if policy != "paper":
            met = np.abs(wide.delivered - wrench)[wide.feasible]
            assert np.max(met) < 1000 * UPPER * np.finfo(np.longdouble).eps


def test_batches_broadcast_and_chunks_do_not_show() -> None:
    structure, wrench = random_problems(4, 20000)
    whole = distribute_tension(STOCK, structure, wrench)
    for i in (0, 8191, 8192, 19999):
        alone = distribute_tension(STOCK, structure[i], wrench[i])
        assert alone.tension.shape == (4,) and alone.feasible.shape == ()
        assert np.allclose(alone.tension, whole.tension[i], rtol=100 * EPS, atol=0)
    grid = distribute_tension(STOCK, structure[:3, None], wrench[None, :5])
    assert grid.tension.shape == (3, 5, 4) and grid.delivered.shape == (3, 5, 2)
    assert distribute_tension(STOCK, structure[:0], wrench[:0]).tension.shape == (0, 4)


def test_what_is_not_a_number_gives_no_tension_and_is_not_feasible() -> None:
    structure, wrench = random_problems(4, 3)
    wrench[1, 0] = np.nan
    for policy in POLICIES:
        found = distribute_tension(STOCK, structure, wrench, policy)
        assert not found.feasible[1] and np.all(np.isnan(found.tension[1]))
        assert np.all(np.isfinite(found.tension[[0, 2]]))


def test_an_unknown_policy_is_refused_with_the_known_ones() -> None:
    structure, wrench = random_problems(4, 1)
    with pytest.raises(ValueError, match="'clip' is not one of scale, closest, paper"):
        distribute_tension(STOCK, structure, wrench, "clip")


def test_an_infeasible_minimum_norm_is_marked_unsolved() -> None:
    structure, wrench = random_problems(4, 1)
    assert not minimum_norm_tension(structure, wrench * 0 + 100, LOWER, UPPER).solved[0]
