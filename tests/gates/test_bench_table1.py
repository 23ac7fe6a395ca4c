"""Brau Table 1: whoever claims the optimum has it, in C, on the paper's problems."""

from pathlib import Path

import numpy as np
import pytest

from turnbuckle.lab.benchmark.solvers.kernel import DAQP, QUADPROG, kernel_daqp
from turnbuckle.lab.benchmark.solvers.reduced import REDUCED
from turnbuckle.lab.benchmark.solvers.solver import Solver
from turnbuckle.lab.benchmark.solvers.turnbuckle import OURS
from turnbuckle.lab.benchmark.table1 import (
    FORCE,
    Excess,
    Table1,
    bounded,
    excess_over,
    table1_problems,
    table1_solvers,
    tensions,
)
from turnbuckle.lab.benchmark.targets import table1_target
from turnbuckle.lab.benchmark.tension import Agreement, Row, TensionTable, compare
from turnbuckle.lab.benchmark.tension_problems import TensionProblems
from turnbuckle.lab.benchmark.timing import Timing
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
#: Rounding that the tensions of two exact methods may differ by, in units of eps T_max.
ROUNDING = 2**12


@pytest.fixture(scope="module")
def problems() -> TensionProblems:
    return table1_problems(bounded(load_machine(ROOT / "machines" / "brau_square.toml")))


@pytest.fixture(scope="module")
def solvers(problems: TensionProblems) -> dict[str, Solver]:
    return table1_solvers(problems.machine)


@pytest.fixture(scope="module")
def table(problems: TensionProblems, solvers: dict[str, Solver]) -> TensionTable:
    return compare([*solvers.values()], problems, repetitions=1)


def tolerance(problems: TensionProblems) -> float:
    return float(ROUNDING * np.finfo(float).eps * problems.machine.tension.max)


def row(table: TensionTable, name: str) -> Row:
    return next(each for each in table.rows if each.name == name)


def test_the_problems_are_the_papers(problems: TensionProblems) -> None:
    assert problems.structure.shape == (15 * 16 * 15, 2, 4)
    assert len(np.unique(problems.structure, axis=0)) == 15 * 16
    assert len(np.unique(problems.wrench, axis=0)) == 15
    assert np.allclose(np.linalg.norm(problems.wrench, axis=1), FORCE)


def test_every_problem_has_tensions_and_every_method_finds_some(table: TensionTable) -> None:
    assert table.feasible == table.count
    assert [(each.agreement.missed, each.agreement.invented) for each in table.rows] == [(0, 0)] * 4


@pytest.mark.parametrize("name", [OURS, DAQP, QUADPROG])
def test_exact_methods_answer_what_the_reference_does(
    problems: TensionProblems, table: TensionTable, name: str
) -> None:
    assert row(table, name).agreement.error < tolerance(problems)


def test_a_kernel_program_with_other_bounds_is_told_apart(problems: TensionProblems) -> None:
    low = problems.machine.tension.min * (1 + 1e-6)
    bounds = problems.machine.tension.model_copy(update={"min": low})
    other = kernel_daqp(problems.machine.model_copy(update={"tension": bounds}))
    (wrong,) = compare([other], problems, repetitions=1).rows
    assert wrong.agreement.error > tolerance(problems)


def test_reduced_matrices_exert_the_force_but_are_not_always_the_optimum(
    problems: TensionProblems, solvers: dict[str, Solver]
) -> None:
    found = tensions(solvers[REDUCED], problems)
    missed = np.einsum("kij,kj->ki", problems.structure, found) - problems.wrench
    assert np.max(np.abs(missed)) < tolerance(problems)
    assert np.min(found) >= problems.machine.tension.min
    excess = excess_over(tensions(solvers[OURS], problems), found)
    assert 0.8 < excess.optimal < 0.85
    assert 0.0 < excess.norm[0] < 0.01 and 0.1 < excess.norm[1] < 0.25
    assert 0.01 < excess.tension[0] < 0.03 and 0.4 < excess.tension[1] < 0.7


def test_the_optimum_exceeds_nothing(problems: TensionProblems, solvers: dict[str, Solver]) -> None:
    excess = excess_over(*(tensions(solvers[name], problems) for name in (OURS, QUADPROG)))
    assert excess.optimal == 1.0
    assert np.max(np.abs([*excess.norm, *excess.tension])) < tolerance(problems)


def test_tensions_that_are_a_little_higher_are_no_optimum(
    problems: TensionProblems, solvers: dict[str, Solver]
) -> None:
    best = tensions(solvers[OURS], problems)
    assert excess_over(best, best * (1 + 1e-6)).optimal == 0.0


def test_the_promise_is_measured_against_the_faster_program() -> None:
    times = {OURS: 40.0, REDUCED: 25.0, DAQP: 250.0, QUADPROG: 300.0}
    rows = [Row(name, "", Timing(time, time), Agreement(0.0, 0, 0)) for name, time in times.items()]
    table1 = Table1(TensionTable("", 1, 1, rows), Excess(1.0, (0.0, 0.0), (0.0, 0.0)))
    target = table1_target(table1)
    assert target.measured == 6.25 and target.is_met
    assert table1.published_ratio == pytest.approx(10.0)
