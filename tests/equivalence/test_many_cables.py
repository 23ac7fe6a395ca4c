"""Tensions and nearest wrenches by loops: machines of every kind with many cables."""

from dataclasses import replace
from functools import lru_cache
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest
import quadprog
from built import optimised, printed
from many_cables import (
    Doubles,
    Problems,
    about,
    known_problems,
    many_cables,
    middle,
    tension_items,
)
from numpy.typing import NDArray

from turnbuckle.codegen.bind import REALS, Generated
from turnbuckle.codegen.evaluate import DOUBLE, FLOAT, evaluate, statuses
from turnbuckle.codegen.item import Item
from turnbuckle.codegen.loop import Loop
from turnbuckle.codegen.verify import call
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import Status
from turnbuckle.model.symbolic.nearest_wrench import BEYOND
from turnbuckle.model.symbolic.tension import INWARDS, KKT_TOLERANCE, OFF_BORDER
from turnbuckle.model.symbolic.wrench_norm import weights

COUNT = 6_000
#: Most cables with which what is composed of loops is evaluated in Python too, which takes long.
COMPOSED = 12
#: The self-check of a loop lets pass so many units of EPSILON times T_max a cable.
TOLERANCE = KKT_TOLERANCE / 4
#: Problems beside a border that rounding closes: one in so many may be refused as inaccurate.
REFUSED = 2000
CASES = [
    ("planar-point", 8, 3.0),
    ("planar-point", 16, 0.0),
    ("planar-rigid", 9, 3.0),
    ("spatial-point", 12, 0.0),
    ("spatial-rigid", 8, 3.0),
    ("spatial-rigid", 16, 3.0),
]
Array = NDArray[Any]
Case = tuple[Machine, dict[str, Item], dict[str, Generated]]


@lru_cache
def prepared(kind: str, count: int, low: float) -> Case:
    """A machine, its tension functions, and their C in both precisions."""
    with TemporaryDirectory() as folder:
        machine = many_cables(Path(folder), kind, count, low)
    items = tension_items(machine)
    return machine, {item.function.name: item for item in items}, compiled(machine, items)


def compiled(machine: Machine, items: list[Item]) -> dict[str, Generated]:
    """The C of some functions in both precisions."""
    folder = printed(machine, items)
    with optimised("-O1"):
        return {precision: Generated(machine, folder, precision) for precision in REALS}


@pytest.fixture(params=CASES, ids=lambda given: f"{given[0]}-{given[1]}")
def case(request: pytest.FixtureRequest) -> Case:
    """Every machine."""
    return prepared(*request.param)


@pytest.fixture(params=CASES[2:], ids=lambda given: f"{given[0]}-{given[1]}")
def beyond_the_plane(request: pytest.FixtureRequest) -> Case:
    """The machines whose feasible wrenches are no polygon."""
    return prepared(*request.param)


def asked(generated: Generated, name: str, *arguments: Array) -> dict[str, Doubles]:
    """All answers of a function as doubles."""
    real = REALS[generated.precision]
    return call(generated.functions[name], [a.astype(real) for a in arguments])


def epsilon(precision: str) -> float:
    return float(np.finfo(REALS[precision]).eps)


def seen(machine: Machine, wrench: Array) -> Array:
    """Wrenches with moments over the lever."""
    return np.asarray(wrench * np.array(weights(machine)))


def exerted(structure: Doubles, tension: Doubles) -> Array:
    """What tensions exert, in long double."""
    return np.asarray(np.einsum("kdn,kn->kd", structure.astype(np.longdouble), tension))


def allowance(machine: Machine, precision: str, structure: Doubles) -> Doubles:
    """What the self-check lets pass [N], with the rounding of its own sum."""
    alike = structure * np.array(weights(machine))[:, None]
    least = np.linalg.svd(alike, compute_uv=False)[:, -1]
    units = TOLERANCE * max(4, len(machine.cables))
    return np.asarray(2 * units * epsilon(precision) * machine.tension.max / np.minimum(least, 1))


def amplification(machine: Machine, problems: Problems) -> Doubles:
    """How much a rounding of the wrench moves the tensions: one over the free cables' least
    singular value; infinite where they do not span the wrenches.
    """
    low, high = machine.tension.min, machine.tension.max
    free = (problems.tension > low) & (problems.tension < high)
    alike = problems.structure * np.array(weights(machine))[:, None] * free[:, None, :]
    least = np.linalg.svd(alike, compute_uv=False)[:, -1]
    with np.errstate(divide="ignore"):
        return np.asarray(np.where(free.sum(axis=1) < machine.dof, np.inf, 1 / least))


@pytest.mark.parametrize("precision", REALS)
def test_problems_with_known_solutions_are_solved(case: Case, precision: str) -> None:
    machine, _, libraries = case
    known = known_problems(machine, COUNT, 11)
    answer = asked(libraries[precision], "least_norm_tension", known.structure, known.wrench)
    solved = answer["status"] == Status.OK
    assert np.sum(~solved) <= COUNT / REFUSED
    assert set(answer["status"]) <= {Status.OK, Status.SINGULAR, Status.INACCURATE}
    tension = answer["tension"][solved].astype(np.float64)
    low, high = machine.tension.min, machine.tension.max
    assert np.all((tension >= np.float32(low)) & (tension <= np.float32(high)))
    missed = seen(machine, exerted(known.structure[solved], tension) - known.wrench[solved])
    scale = allowance(machine, precision, known.structure)[solved]
    assert np.all(np.abs(missed).max(axis=1) <= scale)
    off = np.abs(tension - known.tension[solved]).max(axis=1)
    gain = amplification(machine, known)[solved]
    assert np.all(off <= (8 * gain + 1) * scale)


@pytest.mark.parametrize("precision", REALS)
def test_the_c_of_the_loops_is_their_evaluation_to_the_bit(case: Case, precision: str) -> None:
    machine, items, libraries = case
    known = known_problems(machine, 600, 12)
    wrench = about(machine, known, np.tile([0.9, 1.0, 1.1], 200))
    real = REALS[precision]
    arguments = [known.structure.reshape(600, -1).astype(real), wrench.astype(real)]
    # what is composed of loops is composed alike whatever their size: fewer cables show it
    alone = len(machine.cables) > COMPOSED
    for name, item in items.items():
        if alone and not isinstance(item, Loop):
            continue
        computed = evaluate(item, arguments, DOUBLE if precision == "double" else FLOAT)
        answer = asked(libraries[precision], name, known.structure, wrench)
        wanted = statuses(item, computed)
        assert np.array_equal(answer["status"], wanted), name
        usable = wanted <= Status.INFEASIBLE
        for output, entries in zip(item.function.outputs, computed.outputs, strict=True):
            values = np.stack(entries, axis=-1)[usable]
            given = answer[output.name].reshape(600, -1)[usable]
            assert values.tobytes() == given.tobytes(), f"{name}.{output.name}"


def test_a_published_solver_finds_the_same_tensions(case: Case) -> None:
    machine, _, libraries = case
    known = known_problems(machine, 300, 13)
    wrench = about(machine, known, np.full(300, 0.97))
    answer = asked(libraries["double"], "least_norm_tension", known.structure, wrench)
    assert np.all(answer["status"] == Status.OK)
    for structure, wanted, tension in zip(known.structure, wrench, answer["tension"], strict=True):
        assert np.abs(tension - by_quadprog(machine, structure, wanted)).max() < 1e-6


def by_quadprog(machine: Machine, structure: Doubles, wrench: Doubles) -> Doubles:
    """min |T|, S T = W, T_min <= T <= T_max by Goldfarb and Idnani's method as published."""
    count = structure.shape[1]
    bounds = machine.tension
    sides = np.concatenate([structure.T, np.eye(count), -np.eye(count)], axis=1)
    limits = np.concatenate([wrench, np.full(count, bounds.min), np.full(count, -bounds.max)])
    return np.asarray(
        quadprog.solve_qp(np.eye(count), np.zeros(count), sides, limits, machine.dof)[0]
    )


def test_twice_as_many_steps_are_allowed_as_any_of_many_thousand_problems_takes(
    case: Case,
) -> None:
    """Half the bound refuses nothing that the whole bound solves."""
    machine, items, libraries = case
    loops = [item for item in items.values() if isinstance(item, Loop)]
    halved = [replace(x, repeat=replace(x.repeat, most=x.repeat.most // 2)) for x in loops]
    shorter = compiled(machine, [*halved])
    for chunk in range(6 if len(machine.cables) < COMPOSED else 2):
        known = known_problems(machine, COUNT, 100 + chunk)
        factors = np.random.default_rng(chunk).choice([0.5, 0.99, 1.0], COUNT)
        wrench = about(machine, known, factors)
        for item, precision in product(halved, REALS):
            half, whole = (
                asked(library[precision], item.function.name, known.structure, wrench)["status"]
                for library in (shorter, libraries)
            )
            assert np.array_equal(half, whole), (item.function.name, precision)


def support(machine: Machine, structure: Doubles, direction: Array) -> Array:
    """How far the feasible wrenches reach in a direction (k, d)."""
    along = np.einsum("kdn,kd->kn", structure, direction)
    bounds = machine.tension
    return np.asarray(np.where(along > 0, bounds.max * along, bounds.min * along).sum(axis=1))


def on_border(machine: Machine, precision: str, structure: Doubles, served: Array) -> Array:
    """The wrench of the border that a served one was moved in from."""
    part = OFF_BORDER * epsilon(precision)
    return np.asarray((served - part * middle(machine, structure)) / (1 - part))


@pytest.mark.parametrize("precision", REALS)
def test_the_nearest_wrench_is_served_and_none_is_nearer(
    beyond_the_plane: Case, precision: str
) -> None:
    """The plane through the served wrench, across the way to the wanted one, bounds them all."""
    machine, _, libraries = beyond_the_plane
    known = known_problems(machine, COUNT, 14)
    factors = np.random.default_rng(5).choice([0.9, 1.01, 1.1, 2.0, 30.0], COUNT)
    wrench = about(machine, known, factors).astype(REALS[precision]).astype(np.longdouble)
    answer = asked(libraries[precision], "served_wrench_closest", known.structure, wrench)
    status, whole = answer["status"], machine.tension.max * len(machine.cables)
    assert np.sum(status == Status.INACCURATE) <= COUNT / REFUSED
    assert not np.any(status[factors < 1] == Status.INFEASIBLE)
    border = on_border(machine, precision, known.structure, answer["served"].astype(np.longdouble))
    way = seen(machine, wrench - border)
    length = np.linalg.norm(way.astype(np.float64), axis=1)
    judged = (status == Status.INFEASIBLE) & (length > np.sqrt(epsilon(precision)) * whole)
    assert np.sum(judged) > COUNT / 4
    normal = way / np.linalg.norm(way.astype(np.float64), axis=1)[:, None]
    alike = known.structure * np.array(weights(machine))[:, None]
    beyond = support(machine, alike, normal) - np.sum(seen(machine, border) * normal, axis=1)
    scale = whole + np.linalg.norm(seen(machine, wrench).astype(np.float64), axis=1)
    # The way is known to a rounding of the scale, and so is its direction.
    rounding = 2 * BEYOND * epsilon(precision) * scale * (1 + whole / length)
    assert np.all(np.abs(beyond[judged]) <= rounding[judged])


@pytest.mark.parametrize("precision", REALS)
def test_an_infeasible_wrench_is_replaced_by_the_nearest_and_exerted(
    beyond_the_plane: Case, precision: str
) -> None:
    machine, _, libraries = beyond_the_plane
    known = known_problems(machine, COUNT, 15)
    factors = np.random.default_rng(6).choice([0.97, 1.0, 1.05, 3.0], COUNT)
    wrench = about(machine, known, factors)
    served = asked(libraries[precision], "served_wrench_closest", known.structure, wrench)
    answer = asked(libraries[precision], "distribute_tension_closest", known.structure, wrench)
    assert np.sum(answer["status"] == Status.INACCURATE) <= COUNT / REFUSED
    replaced = (answer["status"] == Status.INFEASIBLE) & (served["status"] == Status.INFEASIBLE)
    assert np.sum(replaced) > COUNT / 4 and np.all(factors[replaced] >= 1)
    centre = middle(machine, known.structure)
    room = np.linalg.norm(seen(machine, served["served"] - centre), axis=1)
    off = np.linalg.norm(seen(machine, answer["delivered"] - served["served"]), axis=1)
    allowed = INWARDS * room + 4 * allowance(machine, precision, known.structure)
    assert np.all(off[replaced] <= 2 * allowed[replaced])


@pytest.mark.parametrize("precision", REALS)
def test_a_wrench_beyond_the_feasible_ones_is_never_solved(case: Case, precision: str) -> None:
    """The farthest in some direction, moved on by a hundredth: does the self-check notice?"""
    machine, _, libraries = case
    structure = known_problems(machine, COUNT, 16).structure
    direction = np.random.default_rng(7).standard_normal((COUNT, 1, machine.dof))
    farthest = np.where((direction @ structure)[:, 0] > 0, machine.tension.max, machine.tension.min)
    corner = Problems(structure, np.einsum("kdn,kn->kd", structure, farthest), farthest)
    wrench = about(machine, corner, np.full(COUNT, 1.01))
    answer = asked(libraries[precision], "least_norm_tension", structure, wrench)
    assert np.all(answer["status"] >= Status.SINGULAR)


@pytest.mark.parametrize("precision", REALS)
def test_without_an_upper_bound_the_loop_ends_where_no_tensions_exert_the_wrench(
    case: Case, precision: str
) -> None:
    """Of cables that alone pull in some direction none is held, or the loop goes round for ever."""
    machine, _, libraries = case
    known = known_problems(machine, COUNT, 17)
    wrench = about(machine, known, np.full(COUNT, 4.0))
    answer = asked(libraries[precision], "distribute_tension_paper", known.structure, wrench)
    assert set(answer["status"]) <= {Status.OK, Status.INFEASIBLE, Status.SINGULAR}
