"""Facets in more than two dimensions against linear programs, convex hulls and quadprog."""

from itertools import product
from pathlib import Path

import numpy as np
import pytest
import quadprog
from built import answered, built
from kinds import Array, machine_of, structures, weighed
from scipy.optimize import linprog, lsq_linear
from scipy.spatial import ConvexHull

from turnbuckle.codegen.bind import REALS, Generated
from turnbuckle.codegen.chain import Chain, chain
from turnbuckle.codegen.composite import Item
from turnbuckle.codegen.enumeration import enumeration
from turnbuckle.codegen.model import composed, lowered
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import arguments, kinematic_functions, quality_by_facets, tension
from turnbuckle.model.symbolic.function import ModelFunction, Status, vector_output
from turnbuckle.model.symbolic.quality_by_facets import balance_sweep, isotropic_sweep

MACHINES = [
    ("planar-rigid", 4),
    ("planar-rigid", 6),
    ("spatial-point", 5),
    ("spatial-rigid", 7),
    ("spatial-rigid", 8),
]
POINTS = 40
#: What stands in for the nearest feasible wrench is this part of the wanted one.
PART = 0.25


@pytest.fixture(scope="module", params=MACHINES, ids=lambda pair: f"{pair[0]}-{pair[1]}")
def machine(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Machine:
    kind, count = request.param
    return machine_of(kind, count, tmp_path_factory.mktemp("machines"))


def middle_of(machine: Machine, matrix: Array) -> Array:
    """Wrench of the mean tension on every cable."""
    return np.asarray((machine.tension.min + machine.tension.max) / 2 * matrix.sum(axis=-1))


def problems(machine: Machine) -> tuple[Array, Array]:
    """Structure matrices; wrenches inside, on and beyond the border, and against all cables."""
    given = structures(machine, POINTS)
    random = np.random.default_rng(3)
    shape = (POINTS, len(machine.cables))
    low, high = machine.tension.min, machine.tension.max
    vertex = np.where(random.random(shape) < 0.5, low, high)
    exerted = np.where(random.random((POINTS, 1)) < 0.5, random.uniform(low, high, shape), vertex)
    wrench = np.einsum("kdn,kn->kd", given, exerted)
    return given, random.choice([-1.5, 0.7, 1.5], (POINTS, 1)) * wrench


def stand_in(machine: Machine) -> Item:
    """A function in place of the policy `closest`, which the ray calls where it finds nothing."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    part = [PART * x for x in wrench.scalars()]
    outputs = (vector_output("served", "N", part), vector_output("inner", "N", part))
    return lowered(
        ModelFunction("served_wrench_closest", "Part", "trial", (structure, wrench), outputs)
    )


def served(machine: Machine) -> tuple[Item, Chain]:
    """The policy `scale` and what it calls."""
    closest = stand_in(machine)
    return closest, chain(
        tension.scale_by_ray(machine), {"served_wrench_closest": closest}, lowered
    )


def largest_fraction(machine: Machine, matrix: Array, wrench: Array) -> float | None:
    """Largest s in [0, 1] with s W feasible, by a linear program; None where there is none."""
    count = len(machine.cables)
    bounds = [(machine.tension.min, machine.tension.max)] * count + [(0, 1)]
    equations = weighed(machine, np.column_stack([matrix, -wrench]))
    cost = np.append(np.zeros(count), -1)
    program = linprog(cost, A_eq=equations, b_eq=np.zeros(machine.dof), bounds=bounds)
    return float(program.x[-1]) if program.x is not None else None


def test_the_fraction_served_is_that_of_the_linear_program(machine: Machine) -> None:
    library = built(machine, list(served(machine)), "double")
    given, wrench = problems(machine)
    answer = library.served_wrench_scale(given, wrench)
    seen = set()
    for k, (matrix, wanted) in enumerate(zip(given, wrench, strict=True)):
        fraction = largest_fraction(machine, matrix, wanted)
        scale = np.max(np.abs(wanted))
        if fraction is None:
            assert np.allclose(answer.served[k], PART * wanted, rtol=1e-12, atol=1e-12 * scale)
        else:
            assert np.max(np.abs(answer.served[k] - fraction * wanted)) < 1e-7 * scale
            inwards = 2.0**-18 * (middle_of(machine, matrix) - answer.served[k])
            assert np.allclose(answer.inner[k] - answer.served[k], inwards, atol=1e-12 * scale)
        feasible = fraction is not None and fraction > 1 - 1e-9
        assert answer.status[k] == (Status.OK if feasible else Status.INFEASIBLE)
        seen.add("none" if fraction is None else "all" if feasible else "some")
    assert seen == {"none", "some", "all"}


def test_a_feasible_wrench_is_served_to_the_bit(machine: Machine) -> None:
    library = built(machine, list(served(machine)), "double")
    given = structures(machine, POINTS)
    inside = 0.9 * middle_of(machine, given) + 0.1 * given[:, :, 0]
    answer = library.served_wrench_scale(given, inside)
    assert np.all(answer.status == Status.OK)
    assert np.array_equal(answer.served, inside)


@pytest.mark.parametrize("precision", REALS)
def test_the_c_is_the_evaluation_to_the_bit(machine: Machine, precision: str) -> None:
    items = [
        *served(machine),
        enumeration(isotropic_sweep(machine), lowered),
        enumeration(balance_sweep(machine), lowered),
    ]
    library = built(machine, items, precision)
    given, wrench = problems(machine)
    for item in items:
        by_name = {"structure": given, "wrench": wrench}
        answered(item, library, [by_name[port.name] for port in item.function.inputs])


def isotropic_by_hull(machine: Machine, matrix: Array) -> float:
    """Largest force in every direction without a moment; negative where zero is infeasible."""
    bounds = (machine.tension.min, machine.tension.max)
    vertices = np.array(list(product(bounds, repeat=matrix.shape[1])))
    facets = ConvexHull(vertices @ weighed(machine, matrix).T).equations
    forces = machine.space if machine.is_rigid else machine.dof
    slope = np.linalg.norm(facets[:, :forces], axis=1)
    if np.any(facets[:, -1] > 0):
        return -1.0
    return float(np.min(-facets[:, -1][slope > 1e-9] / slope[slope > 1e-9]))


def around(machine: Machine, points: int) -> Array:
    """Structure matrices of cables in almost opposite pairs: half of them hold at rest."""
    given = structures(machine, points)
    half = given.shape[2] // 2
    given[::2, :, half : 2 * half] = -given[::2, :, :half]
    given[::2] += 0.1 * structures(machine, points, seed=2)[::2]
    return given


def test_the_isotropic_force_is_that_of_the_convex_hull(machine: Machine) -> None:
    items: list[Item] = [enumeration(isotropic_sweep(machine), lowered)]
    library = built(machine, items, "double")
    given = around(machine, POINTS)
    answer = library.isotropic(given)
    wanted = [isotropic_by_hull(machine, matrix) for matrix in given]
    assert np.allclose(answer, np.maximum(wanted, 0), rtol=1e-9, atol=1e-9)
    assert np.array_equal(answer.status == Status.INFEASIBLE, np.array(wanted) < 0)
    assert {Status.OK, Status.INFEASIBLE} == set(answer.status)


def test_dependent_cables_add_no_facet_and_no_nan(machine: Machine) -> None:
    """Every cable twice: most subsets are dependent, and the feasible set is twice as large."""
    items: list[Item] = [enumeration(isotropic_sweep(machine), lowered)]
    library = built(machine, items, "double")
    given = around(machine, POINTS)
    given[:, :, 1] = given[:, :, 0]
    given[:5, :, 2] = given[:5, :, 0]
    given[5:10] = given[5:10, :, :1]
    answer = library.isotropic(given)
    assert np.all(np.isfinite(answer))
    for matrix, force, status in zip(given[10:], answer[10:], answer.status[10:], strict=True):
        wanted = isotropic_by_hull(machine, matrix)
        assert status == (Status.INFEASIBLE if wanted < 0 else Status.OK)
        assert abs(force - max(wanted, 0)) < 1e-9


@pytest.fixture(scope="module")
def pose_qualities(tmp_path_factory: pytest.TempPathFactory) -> tuple[Machine, Generated]:
    """Quality of poses of a point in space held by eight cables from the corners of its frame."""
    cube = machine_of("spatial-point", 6, tmp_path_factory.mktemp("machines"))
    structure = next(f for f in kinematic_functions.functions(cube) if f.name == "structure_matrix")
    solver = tension.least_norm_function(cube, *tension.methods(cube)[-1])
    known: dict[str, Item] = {f.name: lowered(f) for f in (structure, solver)}
    for composite in quality_by_facets.composites(cube):
        known[composite.name] = chain(composite, known, lowered)
    return cube, built(cube, list(known.values()), "double")


def test_the_quality_of_a_pose_is_that_of_its_structure_matrix(
    pose_qualities: tuple[Machine, Generated],
) -> None:
    cube, library = pose_qualities
    pose = np.random.default_rng(1).uniform(0.0, 0.6, (100, 3))
    structure = library.structure_matrix(pose)
    force, rest = library.isotropic_force(pose), library.zero_wrench_tension(pose)
    factor = library.tension_factor(pose)
    low, high, count = cube.tension.min, cube.tension.max, len(cube.cables)
    seen = set()
    for k, matrix in enumerate(structure):
        wanted = isotropic_by_hull(cube, matrix)
        status = Status.INFEASIBLE if wanted < 0 else Status.OK
        assert {status} == {answer.status[k] for answer in (force, rest, factor)}
        assert abs(force[k] - max(wanted, 0)) < 1e-9
        seen.add(status)
        if status == Status.INFEASIBLE:
            assert np.all(rest[k] == low)
            assert factor[k] == 0
            continue
        rows = np.vstack([matrix, np.eye(count), -np.eye(count)]).T
        bounds = np.concatenate([np.zeros(3), np.full(count, low), np.full(count, -high)])
        best = quadprog.solve_qp(np.eye(count), np.zeros(count), rows, bounds, 3)[0]
        assert np.max(np.abs(rest[k] - best)) < 1e-9 * high
        assert factor[k] == pytest.approx(np.min(best) / np.max(best), abs=1e-9)
    assert seen == {Status.OK, Status.INFEASIBLE}


def test_a_pose_at_a_pulley_is_singular_for_every_quality(
    pose_qualities: tuple[Machine, Generated], tmp_path: Path
) -> None:
    cube, library = pose_qualities
    pose = cube.base_motions[2].start
    for name in ("zero_wrench_tension", "tension_factor", "isotropic_force"):
        answer = library.functions[name](pose)
        assert answer.status == Status.SINGULAR


def nearest_wrench(machine: Machine, matrix: Array, wrench: Array) -> Array:
    """The feasible wrench nearest to one, weighed, by least squares within bounds."""
    bounds = (machine.tension.min, machine.tension.max)
    rows = weighed(machine, matrix)
    found = lsq_linear(rows, weighed(machine, wrench[:, None])[:, 0], bounds, method="bvls")
    return np.asarray(rows @ found.x)


def test_the_distribution_delivers_the_largest_fraction_or_the_nearest_wrench(
    machine: Machine,
) -> None:
    known: dict[str, Item] = {f.name: lowered(f) for f in tension.functions(machine)}
    for composite in tension.composites(machine):
        known[composite.name] = composed(composite, known)
    library = built(machine, list(known.values()), "double")
    given, wrench = problems(machine)
    answer = library.distribute_tension_scale(given, wrench)
    assert np.all(answer.status <= Status.INFEASIBLE)
    for k, (matrix, wanted) in enumerate(zip(given, wrench, strict=True)):
        fraction = largest_fraction(machine, matrix, wanted)
        if fraction is None:
            served = nearest_wrench(machine, matrix, wanted)
        else:
            served = fraction * weighed(machine, wanted[:, None])[:, 0]
        got = weighed(machine, answer.delivered[k][:, None])[:, 0]
        assert np.max(np.abs(got - served)) < 1e-6 * np.max(np.abs(wanted))
        assert np.all(answer.tension[k] >= machine.tension.min)
        assert np.all(answer.tension[k] <= machine.tension.max)
