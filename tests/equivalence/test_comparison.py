"""Methods to compare with against brute force: every set tried in NumPy, linear programs, hulls."""

from itertools import combinations, product
from pathlib import Path

import numpy as np
import pytest
import quadprog
from built import answered, built, printed
from kinds import Array, machine_of, structures, weighed
from scipy.optimize import linprog
from scipy.spatial import ConvexHull

from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.composite import Item
from turnbuckle.codegen.model import composed, lowered
from turnbuckle.model.kind import KINDS
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import comparison
from turnbuckle.model.symbolic.function import Status

#: Every kind with one redundant cable, and with more; planar ones on either side of what is
#: written out.
MACHINES = [
    ("planar-point", 3),
    ("planar-point", 4),
    ("planar-point", 6),
    ("planar-point", 7),
    ("planar-rigid", 4),
    ("planar-rigid", 5),
    ("spatial-point", 4),
    ("spatial-point", 5),
    ("spatial-rigid", 7),
    ("spatial-rigid", 8),
]
POINTS = 40


def items(machine: Machine) -> list[Item]:
    """All functions of the topic."""
    known = {f.name: lowered(f) for f in comparison.functions(machine)}
    made = [composed(composite, {**known}) for composite in comparison.composites(machine)]
    return [*known.values(), *made]


def of(*chosen: tuple[str, int]) -> pytest.MarkDecorator:
    """Runs a test for some machines."""
    names = [f"{kind}-{count}" for kind, count in chosen]
    return pytest.mark.parametrize("machine", chosen, ids=names, indirect=True, scope="module")


@pytest.fixture(scope="module", params=MACHINES, ids=lambda pair: f"{pair[0]}-{pair[1]}")
def machine(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Machine:
    kind, count = request.param
    return machine_of(kind, count, tmp_path_factory.mktemp("machines"))


@pytest.fixture(scope="module")
def made(machine: Machine) -> list[Item]:
    return items(machine)


@pytest.fixture(scope="module")
def folder(machine: Machine, made: list[Item]) -> Path:
    return printed(machine, made)


@pytest.fixture(scope="module")
def generated(machine: Machine, folder: Path) -> Generated:
    return Generated(machine, folder, "double")


def problems(machine: Machine, seed: int = 1) -> tuple[Array, Array]:
    """Structure matrices, half with cables all around, some on one side; wrenches of any sign."""
    given = structures(machine, 40 * POINTS, seed)
    kernel = np.linalg.svd(given)[2][:, -1]
    around = np.all(kernel * kernel[:, :1] > 0, axis=1)
    given = np.concatenate([given[around][: POINTS // 2], given[~around][: POINTS // 2]])
    given[-10:] *= np.sign(given[-10:, :1])
    random = np.random.default_rng(seed)
    tension = random.uniform(0, 12, (len(given), len(machine.cables)))
    wrench = np.einsum("kdn,kn->kd", given, tension)
    wrench[::3] *= random.choice([-1, 1], wrench[::3].shape)
    return given, wrench


@pytest.mark.parametrize("precision", ["double", "float"])
def test_the_c_is_the_evaluation_to_the_bit(
    machine: Machine, made: list[Item], folder: Path, precision: str
) -> None:
    given, wrench = problems(machine)
    force = np.linspace(0.1, 20.0, len(given))
    library = Generated(machine, folder, precision)
    for item in made:
        by_name = {"structure": given, "wrench": wrench, "force": force}
        answered(item, library, [by_name[port.name] for port in item.function.inputs])


def reduced_by_trial(machine: Machine, matrix: Array, wrench: Array) -> tuple[float, list[Array]]:
    """Lowest sum of tensions, and the tensions of all sets that have it."""
    low, least = machine.tension.min, np.inf
    best: list[Array] = []
    for chosen in combinations(range(matrix.shape[1]), machine.dof):
        tension = np.full(matrix.shape[1], low)
        others = np.setdiff1d(np.arange(matrix.shape[1]), chosen)
        try:
            inner = np.linalg.solve(matrix[:, chosen], wrench - low * matrix[:, others].sum(axis=1))
        except np.linalg.LinAlgError:
            continue
        tension[list(chosen)] = inner
        if np.all(inner >= low) and tension.sum() < least + 1e-9:
            best = [tension, *(best if tension.sum() > least - 1e-9 else [])]
            least = min(least, tension.sum())
    return least, best


def test_reduced_matrices_give_the_lowest_sum_of_all_sets(
    machine: Machine, generated: Generated
) -> None:
    given, wrench = problems(machine)
    answer = generated.reduced_matrix_tension(given, wrench)
    for matrix, wanted, tension, status in zip(given, wrench, answer, answer.status, strict=True):
        least, best = reduced_by_trial(machine, matrix, wanted)
        assert status == (Status.OK if best else Status.INFEASIBLE)
        if best:
            assert min(np.max(np.abs(tension - other)) for other in best) < 1e-9 * least
        else:
            assert np.all(tension == machine.tension.min)
    assert {Status.OK, Status.INFEASIBLE} == set(answer.status)


def test_the_lowest_sum_is_that_of_the_linear_program(
    machine: Machine, generated: Generated
) -> None:
    given, wrench = problems(machine)
    answer = generated.reduced_matrix_tension(given, wrench)
    cost = np.ones(len(machine.cables))
    for matrix, wanted, tension, status in zip(given, wrench, answer, answer.status, strict=True):
        scaled = weighed(machine, np.column_stack([matrix, wanted]))
        program = linprog(
            cost, A_eq=scaled[:, :-1], b_eq=scaled[:, -1], bounds=(machine.tension.min, None)
        )
        assert program.success == (status == Status.OK)
        if program.fun is not None:
            assert abs(tension.sum() - program.fun) < 1e-7 * program.fun


@of(*((kind, count) for kind, count in MACHINES if count == KINDS[kind].dof + 1))
def test_the_kernel_method_lifts_the_least_tension_to_its_bound(
    machine: Machine, generated: Generated
) -> None:
    given, wrench = problems(machine)
    answer = generated.kernel_tension(given, wrench)
    low = machine.tension.min
    for matrix, wanted, tension, status in zip(given, wrench, answer, answer.status, strict=True):
        scaled = weighed(machine, np.column_stack([matrix, wanted]))
        kernel = np.linalg.svd(scaled[:, :-1])[2][-1]
        cooperative = np.all(kernel * kernel[0] > 0)
        assert status == (Status.OK if cooperative else Status.INFEASIBLE)
        start = np.linalg.pinv(scaled[:, :-1]) @ scaled[:, -1]
        kernel *= np.sign(kernel[0])
        wanted_tension = start + np.max((low - start) / kernel) * kernel if cooperative else low
        scale = np.max(np.abs(start)) / np.min(np.abs(kernel))
        assert np.max(np.abs(tension - wanted_tension)) < 1e-12 * scale
        if cooperative:
            assert abs(tension.min() - low) < 1e-9


@of(*((kind, count) for kind, count in MACHINES if count > KINDS[kind].dof + 1))
def test_the_kernel_method_is_the_quadratic_program(machine: Machine, generated: Generated) -> None:
    given, wrench = problems(machine)
    answer = generated.kernel_tension(given, wrench)
    count = len(machine.cables)
    for matrix, wanted, tension, status in zip(given, wrench, answer, answer.status, strict=True):
        scaled = weighed(machine, np.column_stack([matrix, wanted]))
        rows = np.vstack([scaled[:, :-1], np.eye(count)]).T
        bounds = np.append(scaled[:, -1], np.full(count, machine.tension.min))
        try:
            best = quadprog.solve_qp(np.eye(count), np.zeros(count), rows, bounds, machine.dof)[0]
        except ValueError:
            assert status == Status.INFEASIBLE
            continue
        assert status == Status.OK
        assert np.max(np.abs(tension - best)) < 1e-8 * np.max(best)


def test_equation_12_is_the_largest_row_of_the_inverses(
    machine: Machine, generated: Generated
) -> None:
    given, _ = problems(machine)
    force = 3.0
    answer = generated.largest_tensions_eq12(given, force)
    forces = machine.space if machine.is_rigid else machine.dof
    for matrix, tension in zip(given, answer, strict=True):
        wanted = np.zeros(len(tension))
        for chosen in combinations(range(len(tension)), machine.dof):
            inverse = np.linalg.inv(matrix[:, chosen])
            row = force * np.linalg.norm(inverse[:, :forces], axis=1)
            wanted[list(chosen)] = np.maximum(wanted[list(chosen)], row)
        assert np.allclose(tension, wanted, rtol=1e-8)


def is_enough(machine: Machine, matrix: Array, high: float, force: float) -> bool:
    """Whether tensions up to `high` exert every force of a size, by the hull of the vertices."""
    bounds = (machine.tension.min, high)
    vertices = np.array(list(product(bounds, repeat=matrix.shape[1])))
    facets = ConvexHull(vertices @ weighed(machine, matrix).T).equations
    forces = machine.space if machine.is_rigid else machine.dof
    return bool(np.all(force * np.linalg.norm(facets[:, :forces], axis=1) + facets[:, -1] <= 0))


def test_the_largest_tension_is_just_enough(machine: Machine, generated: Generated) -> None:
    given = problems(machine)[0][:: machine.dof - 1]
    answer = generated.largest_tension(given, 3.0)
    for matrix, tension, status in zip(given, answer, answer.status, strict=True):
        if status == Status.OK:
            assert is_enough(machine, matrix, tension * (1 + 1e-9), 3.0)
            assert not is_enough(machine, matrix, tension * (1 - 1e-7), 3.0)
        else:
            assert status == Status.INFEASIBLE
            assert tension == 0
            assert not is_enough(machine, matrix, 1e6, 3.0)
    assert {Status.OK, Status.INFEASIBLE} == set(answer.status)


FEW = [("planar-point", count) for count in (3, 4, 5)]


@of(*FEW)
def test_adjacent_cables_tell_the_exact_tension_of_three_and_four_only(
    machine: Machine, tmp_path: Path
) -> None:
    """T_min is taken as 0, so the machine must have that for the exact function to say the same."""
    slack = machine_of("planar-point", len(machine.cables), tmp_path, low=0.0)
    generated = built(slack, items(slack), "double")
    given, _ = problems(slack)
    adjacent = generated.largest_tensions_eq17(given, 3.0)
    exact = generated.largest_tension(given, 3.0)
    assert np.array_equal(adjacent.status, exact.status)
    assert {Status.OK, Status.INFEASIBLE} == set(exact.status)
    same = np.isclose(np.max(adjacent, axis=1), exact, rtol=1e-9)
    assert np.all(same) == (len(slack.cables) < 5)
    if len(slack.cables) == 3:
        fine = exact.status == Status.OK
        eq14 = np.asarray(generated.largest_tensions_eq12(given, 3.0))
        assert np.allclose(eq14[fine], np.asarray(adjacent)[fine], rtol=1e-9)


def test_dependent_cables_leave_equation_12_without_a_bound(
    machine: Machine, generated: Generated
) -> None:
    given = structures(machine, 10)
    given[:5, :, 1] = -given[:5, :, 0]
    answer = generated.largest_tensions_eq12(given, 1.0)
    assert list(answer.status) == [Status.SINGULAR] * 5 + [Status.OK] * 5


def test_the_second_largest_maximum_of_equation_17_is_not_exact(tmp_path: Path) -> None:
    """In a square of cables, at the two places that show what is wrong with eq. 17.

    Off the centre the second largest value, which the paper takes, is 1.389; and beside a diagonal
    opposite cables make the largest one grow without bounds.
    """
    square = machine_of("planar-point", 4, tmp_path, low=0.0)
    generated = built(square, items(square), "double")
    corners = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])
    for place, exact, published in (((0.8, 0.1), 2.5769, 2.5769), ((0.5, 0.501), 1.1189312, 749.0)):
        arms = corners - np.array(place)
        matrix = (arms / np.linalg.norm(arms, axis=1, keepdims=True)).T
        assert generated.largest_tension(matrix, 1.0) == pytest.approx(exact, rel=1e-4)
        adjacent = np.max(generated.largest_tensions_eq17(matrix, 1.0))
        assert adjacent == pytest.approx(exact, rel=1e-4)
        assert np.max(generated.largest_tensions_eq12(matrix, 1.0)) > 0.999 * published


def test_bounds_below_are_not_bounds_above(machine: Machine, generated: Generated) -> None:
    """The negative control of the comparison: these methods exceed T_max without a word."""
    given, wrench = problems(machine)
    for method in (generated.reduced_matrix_tension, generated.kernel_tension):
        answer = method(given, 10 * wrench)
        fine = answer.status == Status.OK
        assert np.any(np.asarray(answer)[fine] > machine.tension.max)
