"""The reference tensions of every kind against published solvers and a linear program."""

import numpy as np
import numpy.typing as npt
import pytest
import quadprog
from reference_poses import NAMES, WIDE_EPS, Wide, machine_of, random_poses
from scipy.optimize import linprog, lsq_linear

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import active_sets, bounded
from turnbuckle.model.reference.kinematics import moment_lever, structure_matrix
from turnbuckle.model.reference.statics import wrench as wrench_of
from turnbuckle.model.reference.tension import POLICIES, distribute_tension, wrench_feasible

Doubles = npt.NDArray[np.float64]
LOWER, UPPER = 3.0, 30.0
SIZES = [(3, 4), (3, 7), (3, 16), (6, 7), (6, 9), (6, 16)]
sizes = pytest.mark.parametrize(("d", "cables"), SIZES)
IN_SPACE = [machine_of(name) for name in NAMES if name != "mixed_bases"]
every_machine = pytest.mark.parametrize("machine", IN_SPACE, ids=lambda m: m.name)


def bounded_tensions(shape: tuple[int, int], seed: int) -> Doubles:
    """Of which two in three are at a bound."""
    share = np.random.default_rng(seed).uniform(0, 1, shape)
    return LOWER + (UPPER - LOWER) * np.clip(3 * share - 1, 0, 1)


def random_problems(d: int, cables: int, count: int) -> tuple[Wide, Wide]:
    """Unit columns; wrenches of bounded tensions, a hair inside the set or pushed out of it."""
    rng = np.random.default_rng(cables)
    structure = rng.normal(size=(count, d, cables)).astype(np.longdouble)
    structure /= np.sqrt(np.sum(structure**2, axis=-2, keepdims=True))
    tension = bounded_tensions((count, cables), cables)
    tension += 1e-3 * ((LOWER + UPPER) / 2 - tension)
    wrench = np.sum(structure * tension[:, None, :], axis=-1)
    return structure, wrench * rng.choice([1, 1, 2], (count, 1))


def published_solution(s: Doubles, w: Doubles) -> Doubles | None:
    """Goldfarb and Idnani's solver; None where it finds the problem infeasible."""
    d, n = s.shape
    rows = np.vstack([s, np.eye(n), -np.eye(n)])
    limits = np.concatenate([w, np.full(n, LOWER), np.full(n, -UPPER)])
    try:
        return np.asarray(quadprog.solve_qp(np.eye(n), np.zeros(n), rows.T, limits, meq=d)[0])
    except ValueError:
        return None


def duality_gap(structure: Wide, tension: Wide) -> Wide:
    """How much |T|^2 / 2 may be above the least there is (rows), by its dual function.

    The least over the bounds of |t|^2 / 2 - y . (S t - S T) for the multipliers y of the cables
    strictly between their bounds is below the least there is.
    """
    free = (tension > LOWER) & (tension < UPPER)
    gap = np.zeros(len(tension), np.longdouble)
    for row, (s, t, f) in enumerate(zip(structure, tension, free, strict=True)):
        y, *_ = np.linalg.lstsq(s[:, f].T.astype(float), t[f].astype(float))
        best = np.clip(s.T @ y, LOWER, UPPER)
        gap[row] = (t @ t - best @ best) / 2 - y @ (s @ (t - best))
    return gap


@sizes
def test_feasible_tensions_are_those_of_a_published_solver(d: int, cables: int) -> None:
    structure, wrench = random_problems(d, cables, 300)
    found, solved = bounded.least_norm(structure, wrench, LOWER, UPPER)
    assert 50 < np.sum(solved) < 300
    for i in range(300):
        published = published_solution(structure[i].astype(float), wrench[i].astype(float))
        assert (published is not None) == solved[i]
        if published is not None:
            assert np.allclose(found[i].astype(float), published, rtol=0, atol=1e-8)


@sizes
def test_tensions_meet_the_wrench_to_long_double(d: int, cables: int) -> None:
    structure, wrench = random_problems(d, cables, 1000)
    found, solved = bounded.least_norm(structure, wrench, LOWER, UPPER)
    assert np.all((found >= LOWER) & (found <= UPPER))
    met = np.sum(structure * found[:, None, :], axis=-1) - wrench
    assert np.max(np.abs(met[solved])) < 100 * cables * UPPER * WIDE_EPS


@sizes
def test_tensions_have_the_least_norm(d: int, cables: int) -> None:
    structure, wrench = random_problems(d, cables, 500)
    found, solved = bounded.least_norm(structure, wrench, LOWER, UPPER)
    free = np.sum((found > LOWER) & (found < UPPER), axis=-1) >= d
    usable = solved & free
    assert np.sum(usable) > 100
    assert np.max(duality_gap(structure[usable], found[usable])) < 1e-9


def test_the_duality_gap_sees_a_tension_that_is_not_of_the_least_norm() -> None:
    structure, wrench = random_problems(3, 7, 500)
    found, _ = bounded.least_norm(structure, wrench, LOWER, UPPER)
    kernel = np.linalg.svd(structure.astype(float))[2][:, -1, :]
    moved = found + 0.01 * kernel
    within = np.all((moved >= LOWER) & (moved <= UPPER), axis=-1)
    within &= np.sum((moved > LOWER) & (moved < UPPER), axis=-1) > 3
    assert np.sum(within) > 10
    assert np.min(duality_gap(structure[within], moved[within])) > 1e-6


@pytest.mark.parametrize("cables", [3, 4, 6])
def test_the_search_and_trying_every_active_set_agree_in_the_plane(cables: int) -> None:
    structure, wrench = random_problems(2, cables, 2000)
    searched, solved = bounded.least_norm(structure, wrench, LOWER, UPPER)
    tried, also_solved = active_sets.least_norm(structure, wrench, LOWER, UPPER)
    assert np.array_equal(solved, also_solved)
    assert np.max(np.abs(searched - tried)[solved]) < 1e-9


@pytest.mark.parametrize("case", ["parallel", "equal", "flat", "vertex", "facet"])
@pytest.mark.parametrize(("d", "cables"), [(3, 8), (6, 9)])
def test_degenerate_cables_and_wrenches_on_the_border_are_served(
    case: str, d: int, cables: int
) -> None:
    structure, _ = random_problems(d, cables, 500)
    rng = np.random.default_rng(4)
    tension: Wide = bounded_tensions((500, cables), 5).astype(np.longdouble)
    apart = 1e-9 if case == "parallel" else 1
    if case == "parallel":
        structure[..., 1] = structure[..., 0] + apart * structure[..., 1]
    if case == "equal":
        structure[..., 1], structure[..., 2] = structure[..., 0], -structure[..., 0]
    if case == "flat":
        structure[..., -1, :] = 0
    if case == "vertex":
        tension = rng.choice([LOWER, UPPER], (500, cables)).astype(np.longdouble)
    if case == "facet":
        structure[..., -1, : d - 1] = 0
        tension[:, d - 1 :] = np.where(structure[:, -1, d - 1 :] > 0, UPPER, LOWER)
    wrench = np.sum(structure * tension[:, None, :], axis=-1)
    found, solved = bounded.least_norm(structure, wrench, LOWER, UPPER)
    assert np.all(solved)
    shorter = np.sqrt(np.sum(found**2, axis=-1)) - np.sqrt(np.sum(tension**2, axis=-1))
    assert np.max(shorter) < 1e4 * WIDE_EPS * UPPER / apart


@sizes
def test_the_closest_wrench_is_that_of_bounded_least_squares(d: int, cables: int) -> None:
    structure, wrench = random_problems(d, cables, 100)
    wrench *= 2
    found = bounded.closest_tension(structure, wrench, LOWER, UPPER)
    for s, w, t in zip(structure.astype(float), wrench.astype(float), found, strict=True):
        nearest = lsq_linear(s, w, (LOWER, UPPER), method="bvls", tol=1e-14)
        assert np.allclose(s @ t.astype(float), s @ nearest.x, rtol=0, atol=1e-6)


def test_the_search_ends_where_two_cables_are_opposite_but_for_rounding() -> None:
    """Together they pull a hair sideways, where nothing acts against two other cables."""
    rng = np.random.default_rng(6)
    turn, arm = rng.uniform(0.05, 0.4, (2, 200)), rng.uniform(0.7, 0.95, 200)
    hair, one = rng.uniform(-2e-17, 2e-17, (2, 200)), np.ones(200)
    columns = [
        [np.sin(turn[0]), -np.cos(turn[0]), arm],
        [hair[0], -one, -0.8 * one],
        [one, 0 * one, 0 * one],
        [hair[1], one, 0.8 * one],
        [np.sin(turn[1]), np.cos(turn[1]), -arm],
        [one, 0 * one, 0 * one],
    ]
    structure = np.moveaxis(np.array(columns, np.longdouble), -1, 0).swapaxes(-1, -2)
    found, solved = bounded.least_norm(structure, np.zeros((200, 3), np.longdouble), 3.0, 10.0)
    assert not solved.any()
    for s, t in zip(structure.astype(float), found.astype(float), strict=True):
        nearest = lsq_linear(s, np.zeros(3), (3.0, 10.0), method="bvls", tol=1e-14)
        assert np.allclose(s @ t, s @ nearest.x, rtol=0, atol=1e-6)


@sizes
def test_no_wrench_of_the_set_is_further_along_the_error_than_the_closest(
    d: int, cables: int
) -> None:
    """Its support: the error e = W - S T is normal to the set at the closest wrench."""
    structure, wrench = random_problems(d, cables, 500)
    wrench *= 2
    found = bounded.closest_tension(structure, wrench, LOWER, UPPER)
    error = wrench - np.sum(structure * found[:, None, :], axis=-1)
    slope = np.sum(structure * error[..., None], axis=-2)
    room = np.where(slope > 0, UPPER - found, LOWER - found)
    size = np.sum(np.abs(wrench), axis=-1) * UPPER * cables
    assert np.all(np.sum(slope * room, axis=-1) <= 1e3 * WIDE_EPS * size)


@every_machine
def test_the_verdict_is_that_of_a_linear_program(machine: Machine) -> None:
    structure, wrench = machine_problems(machine, 100)
    off_the_boundary = 1 + 1e-6 * np.where(np.arange(100) % 2, 1, -1)[:, None]
    wrench = wrench * off_the_boundary
    verdict = wrench_feasible(machine, structure, wrench)
    assert 0.1 < np.mean(verdict) < 0.95
    for s, w, feasible in zip(structure.astype(float), wrench.astype(float), verdict, strict=True):
        bounds = (machine.tension.min, machine.tension.max)
        found = linprog(np.zeros(s.shape[1]), A_eq=s, b_eq=w, bounds=bounds, method="highs")
        assert found.success == feasible


def machine_problems(machine: Machine, count: int) -> tuple[Wide, Wide]:
    structure = structure_matrix(machine, *random_poses(machine, count))
    tension = bounded_tensions((count, len(machine.cables)), 6)
    wrench = np.sum(structure * tension[:, None, :], axis=-1)
    return structure, wrench * np.random.default_rng(7).choice([0.9, 1.5, 3], (count, 1))


@every_machine
@pytest.mark.parametrize("policy", POLICIES)
def test_every_policy_keeps_the_bounds_and_tells_what_it_delivers(
    machine: Machine, policy: str
) -> None:
    structure, wrench = machine_problems(machine, 300)
    found = distribute_tension(machine, structure, wrench, policy)
    assert found.tension.min() >= LOWER and found.tension.max() <= UPPER
    assert np.array_equal(found.delivered, wrench_of(machine, structure, found.tension))
    if policy != "paper":
        met = np.abs(found.delivered - wrench)[found.feasible]
        assert np.max(met) < 1e4 * UPPER * WIDE_EPS
        served = wrench_feasible(machine, structure, found.delivered)
        assert np.all(served)


@every_machine
def test_scaling_keeps_the_direction_and_closest_comes_closest(machine: Machine) -> None:
    structure, wrench = machine_problems(machine, 300)
    nothing = np.zeros_like(wrench)
    usable = wrench_feasible(machine, structure, nothing)
    assert np.sum(usable) > 20
    structure, wrench = structure[usable], wrench[usable]
    scaled = distribute_tension(machine, structure, wrench, "scale").delivered
    share = np.sum(scaled * wrench, axis=-1) / np.sum(wrench * wrench, axis=-1)
    assert np.allclose(scaled, share[:, None] * wrench, rtol=0, atol=1e-14)
    further = wrench_feasible(machine, structure, (share * (1 + 1e-9))[:, None] * wrench)
    assert not np.any(further & (share < 1 - 1e-9))
    closest = distribute_tension(machine, structure, wrench, "closest").delivered
    lever = moment_lever(machine, wrench.dtype)
    away, least = (np.sum(((x - wrench) / lever) ** 2, axis=-1) for x in (scaled, closest))
    assert np.all(least <= away + 1e-14)


@every_machine
def test_what_is_not_a_number_gives_no_tension_and_is_not_feasible(machine: Machine) -> None:
    structure, wrench = machine_problems(machine, 3)
    wrench[1, 0] = np.nan
    structure[2, 0, 0] = np.nan
    for policy in POLICIES:
        found = distribute_tension(machine, structure, wrench, policy)
        assert not np.any(found.feasible[1:]) and np.all(np.isnan(found.tension[1:]))
        assert np.all(np.isfinite(found.tension[0]))
