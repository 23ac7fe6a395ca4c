"""The generated tension distribution on a million problems, and against the reference."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from kkt import EPSILON, KnownProblems, conditioned, known_problems, wrench_rounding
from numpy.typing import NDArray

from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.hard_cases import HardSampler
from turnbuckle.codegen.judges.problem import Problem
from turnbuckle.codegen.judges.tensions import distribution
from turnbuckle.codegen.samples import Sampler
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.optimality import optimality_gap
from turnbuckle.model.reference.tension import POLICIES, distribute_tension
from turnbuckle.model.reference.wrench_set import slabs
from turnbuckle.model.symbolic.function import Status
from turnbuckle.model.symbolic.tension import INWARDS

Doubles = NDArray[np.float64]

CHUNK, CHUNKS = 100_000, 10
#: Multiples of rounding that are allowed; cables a millionth of a radian apart, which no pose of
#: the machine has, may miss the wrench by more, one time in a hundred thousand.
WRENCH_ROUNDINGS, STRANGE_WRENCH_ROUNDINGS, TENSION_ROUNDINGS = 8, 32, 64
#: Nearer to the border of the feasible wrenches than this part of T_max, both verdicts are right.
BORDER = 1e-12


def poses(machine: Machine, seed: int, count: int) -> Doubles:
    """Structures of poses in operation; on a pulley there is none, and these are left out."""
    structure = Sampler(machine, seed, count).structure
    return structure[np.all(np.any(structure != 0, axis=1), axis=1)]


def any_directions(machine: Machine, seed: int, count: int) -> Doubles:
    """Cables in any direction, a fifth of them nearly parallel to another one."""
    random = np.random.default_rng(seed)
    angle = random.uniform(0, 2 * np.pi, (count, len(machine.cables)))
    beside = angle[:, [0]] + 10.0 ** random.uniform(-6, -1, (count, 1))
    near = random.random((count, 1)) < 0.2
    angle[:, [1]] = np.where(
        near, beside + np.pi * random.integers(0, 2, (count, 1)), angle[:, [1]]
    )
    return np.stack([np.cos(angle), np.sin(angle)], axis=1)


def spanning(structure: Doubles) -> Doubles:
    """The structures that are not nearly singular."""
    smallest = np.linalg.svd(structure, compute_uv=False)[:, -1]
    return structure[smallest > 1e-3]


@dataclass(frozen=True)
class Judgement:
    """Errors in roundings of the problems that were solved; how many were not, and should be."""

    wrench: Doubles
    tension: Doubles
    unsolved: int


def judged(machine: Machine, known: KnownProblems, generated: Generated) -> Judgement:
    """Answers against the solutions that are known by construction."""
    answer = generated.distribute_tension(known.structure, known.wrench)
    solved = answer.status == Status.OK
    exerted = np.einsum("kdn,kn->kd", known.structure.astype(np.longdouble), answer.tension)
    scale = wrench_rounding(machine, known.structure, known.wrench)
    missed = np.max(np.abs(exerted - known.wrench), axis=1) / scale
    scale = conditioned(machine, known.structure, known.wrench, known.tension)
    off = np.max(np.abs(answer.tension - known.tension), axis=1) / scale
    unsolved = ~solved & ~on_border(machine, known.structure, known.wrench)
    return Judgement(missed[solved], off[solved], int(np.sum(unsolved)))


def on_border(machine: Machine, structure: Doubles, wrench: Doubles) -> NDArray[np.bool_]:
    """Wrenches that rounding may put on either side of the border of the feasible ones."""
    return np.abs(distance_inside(machine, structure, wrench)) <= BORDER * machine.tension.max


def distance_inside(machine: Machine, structure: Doubles, wrench: Doubles) -> Doubles:
    """How far a wrench is inside the nearest facet, negative outside [N]."""
    normals, middle, half_width = slabs(machine, structure)
    along = np.einsum("kpd,kd->kp", normals, wrench)
    return np.asarray(np.min(half_width - np.abs(along - middle), axis=1), dtype=np.float64)


@pytest.mark.parametrize(
    ("structures", "most"),
    [(poses, WRENCH_ROUNDINGS), (any_directions, STRANGE_WRENCH_ROUNDINGS)],
)
def test_half_a_million_problems_with_known_solutions_are_solved(
    structures: Callable[[Machine, int, int], Doubles],
    most: int,
    stock: Machine,
    double: Generated,
) -> None:
    worst_wrench, worst_tension, unusual, unsolved, tried = 0.0, 0.0, 0, 0, 0
    for chunk in range(CHUNKS // 2):
        known = known_problems(stock, spanning(structures(stock, chunk, CHUNK)), 100 + chunk)
        found = judged(stock, known, double)
        worst_wrench = max(worst_wrench, float(np.max(found.wrench)))
        worst_tension = max(worst_tension, float(np.max(found.tension)))
        unusual += int(np.sum(found.wrench > WRENCH_ROUNDINGS))
        unsolved, tried = unsolved + found.unsolved, tried + len(known.wrench)
    print(
        f"{tried} problems: wrench {worst_wrench:.2f}, {unusual} times more than the usual; "
        f"tension {worst_tension:.2f} roundings; {unsolved} unsolved"
    )
    assert tried > 0.9 * CHUNK * CHUNKS / 2
    assert unsolved == 0
    assert worst_wrench <= most and unusual <= tried / CHUNK
    assert worst_tension <= TENSION_ROUNDINGS


def test_the_check_would_see_a_tension_that_is_off_by_a_billionth(
    stock: Machine, double: Generated
) -> None:
    known = known_problems(stock, spanning(poses(stock, 1, 2000)), 1)
    shifted = KnownProblems(known.structure, known.wrench, known.tension * (1 + 1e-9))
    assert np.max(judged(stock, shifted, double).tension) > TENSION_ROUNDINGS


@pytest.mark.parametrize("policy", POLICIES)
def test_every_policy_is_that_of_the_reference(
    policy: str, stock: Machine, double: Generated
) -> None:
    samplers = [Sampler(stock, 21, 15_000), HardSampler(stock, 22, 15_000)]
    structure = np.concatenate([s.structure for s in samplers])
    wrench = np.concatenate([s.wrenches() for s in samplers])
    pulled = np.all(np.any(structure != 0, axis=1), axis=1)
    structure, wrench = structure[pulled], wrench[pulled]
    arguments = {
        "structure": structure.astype(np.longdouble),
        "wrench": wrench.astype(np.longdouble),
    }
    wanted = distribution(policy)(Problem(stock, EPSILON, arguments))
    answer = double.functions[f"distribute_tension_{policy}"](structure, wrench)
    right = wanted.allowed[np.arange(len(wrench)), answer.status]
    assert np.all(right), wrong_verdicts(answer.status, wanted.allowed, structure, wrench)
    usable = answer.status <= Status.INFEASIBLE
    for name in ("tension", "delivered"):
        error = np.abs(getattr(answer, name) - wanted.values[name])[usable]
        assert np.all(error <= wanted.tolerance[name][usable]), name


def wrong_verdicts(
    status: NDArray[np.intc], allowed: NDArray[np.bool_], structure: Doubles, wrench: Doubles
) -> str:
    wrong = np.flatnonzero(~allowed[np.arange(len(status)), status])
    lines = [
        f"{Status(int(status[k])).name}, not {[s.name for s in Status if allowed[k, s]]}: "
        f"{structure[k].tolist()} {wrench[k].tolist()}"
        for k in wrong[:5]
    ]
    return f"{len(wrong)} wrong verdicts:\n" + "\n".join(lines)


@pytest.mark.parametrize("policy", ["scale", "closest"])
def test_tensions_are_optimal_by_the_test_that_knows_no_solver(
    policy: str, stock: Machine, double: Generated
) -> None:
    sampler = Sampler(stock, 31, 20_000)
    structure, wrench = sampler.structure, sampler.wrenches()
    regular = np.linalg.svd(structure, compute_uv=False)[:, -1] > 1e-3
    pulled = np.all(np.any(structure != 0, axis=1), axis=1) & regular
    structure, wrench = structure[pulled], wrench[pulled]
    answer = double.functions[f"distribute_tension_{policy}"](structure, wrench)
    bounds = stock.tension
    assert np.all((answer.tension >= bounds.min) & (answer.tension <= bounds.max))
    scale = conditioned(stock, structure, wrench, answer.tension)
    gap = optimality_gap(structure, answer.tension, bounds.min, bounds.max)
    solved = answer.status <= Status.INFEASIBLE
    assert np.all(solved)
    assert float(np.max((gap / scale)[solved])) <= TENSION_ROUNDINGS


@pytest.mark.parametrize("policy", ["scale", "closest"])
def test_the_verdict_is_that_of_the_facets(policy: str, stock: Machine, double: Generated) -> None:
    sampler = Sampler(stock, 41, 100_000)
    structure = sampler.structure
    regular = np.all(np.any(structure != 0, axis=1), axis=1)
    structure, wrench = structure[regular], sampler.wrenches()[regular]
    status = double.functions[f"distribute_tension_{policy}"](structure, wrench).status
    inside = distance_inside(stock, structure, wrench)
    decided = (np.abs(inside) > BORDER * stock.tension.max) & (status != Status.SINGULAR)
    wanted = np.where(inside > 0, Status.OK, Status.INFEASIBLE)
    wrong = decided & (status != wanted)
    assert 0.1 < np.mean(inside > 0) < 0.9 and np.mean(decided) > 0.5
    allowed = np.eye(len(Status), dtype=bool)[wanted] | ~decided[:, None]
    assert not wrong.any(), wrong_verdicts(status, allowed, structure, wrench)


ORTHOGONAL = np.array([[0.0, 1.0, 0.0, -1.0], [-1.0, 0.0, 1.0, 0.0]])


@pytest.mark.parametrize(
    ("wrench", "tension", "status"),
    [
        ((0, 0), (3, 3, 3, 3), Status.OK),
        ((7, 0), (3, 10, 3, 3), Status.OK),
        ((0, -7), (10, 3, 3, 3), Status.OK),
        ((-2, 0), (3, 3, 3, 5), Status.OK),
        ((7, 7), (3, 10, 10, 3), Status.OK),
        ((14, 0), (3, 10, 3, 3), Status.INFEASIBLE),
        ((14, 14), (3, 10, 10, 3), Status.INFEASIBLE),
    ],
)
@pytest.mark.parametrize("precision", ["double", "single"])
def test_the_orthogonal_configuration_is_solved_exactly(
    wrench: tuple[float, float],
    tension: tuple[float, ...],
    status: Status,
    precision: str,
    request: pytest.FixtureRequest,
) -> None:
    generated: Generated = request.getfixturevalue(precision)
    answer = generated.distribute_tension(ORTHOGONAL, wrench)
    rounding = 64 * np.finfo(answer.tension.dtype).eps * max(tension)
    assert np.max(np.abs(answer.tension - tension)) <= rounding
    assert answer.status == status


def test_parallel_cables_are_singular(double: Generated) -> None:
    structure = np.array([[0.0, 0.0, 0.0, 0.0], [1.0, -1.0, 1.0, -1.0]])
    for turn in (structure, structure[::-1], np.array([[0.6], [0.8]]) * structure[1]):
        answer = double.distribute_tension(np.ascontiguousarray(turn), [1.0, 2.0])
        assert answer.status == Status.SINGULAR
        assert answer.tension.tolist() == [3.0] * 4


def test_the_reference_finds_the_solutions_known_by_construction(stock: Machine) -> None:
    known = known_problems(stock, spanning(any_directions(stock, 5, 10_000)), 5)
    found = distribute_tension(stock, known.structure, known.wrench, "closest")
    scale = conditioned(stock, known.structure, known.wrench, known.tension)
    off = np.max(np.abs(found.tension - known.tension), axis=1) / scale
    assert float(np.max(off)) < 100 * TENSION_ROUNDINGS


@pytest.mark.parametrize("policy", ["scale", "closest"])
def test_a_wrench_of_the_border_that_has_no_tensions_is_served_a_little_further_in(
    stock_file: Path, policy: str
) -> None:
    """Cables nearly in one line: rounding leaves nothing that exerts exactly this wrench."""
    machine = load_machine(stock_file.with_name("brau_five.toml"))
    five = Generated(machine, stock_file.parents[1] / "generated" / "brau_five", "double")
    x, y, steep = 0.9999991826143633, 0.00127858148172523, 0.8943127433148662
    flat = 0.44744241768593884
    structure = np.array([[-x, -flat, flat, x, 0.0], [y, -steep, -steep, y, 1.0]])
    wrench = np.array([-6.61979830870712, 10.017107671185919])
    assert five.least_norm_tension(structure, wrench).status is Status.INACCURATE
    answer = getattr(five, f"distribute_tension_{policy}")(structure, wrench)
    middle = (machine.tension.min + machine.tension.max) / 2 * structure.sum(axis=1)
    assert answer.status is Status.INFEASIBLE
    off = np.linalg.norm(answer.delivered - wrench) / np.linalg.norm(middle - wrench)
    assert 0 < off < 2 * INWARDS
