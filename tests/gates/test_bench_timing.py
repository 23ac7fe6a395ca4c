"""The benchmark's clock and its judge: nobody is timed on wrong answers."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from turnbuckle.lab.benchmark.solvers.qrqp import qrqp
from turnbuckle.lab.benchmark.solvers.quadprog import QUADPROG
from turnbuckle.lab.benchmark.solvers.solver import Answers, Solver
from turnbuckle.lab.benchmark.solvers.turnbuckle import turnbuckle
from turnbuckle.lab.benchmark.targets import Target
from turnbuckle.lab.benchmark.tension import Reference, compare
from turnbuckle.lab.benchmark.tension_problems import TensionProblems, tension_problems
from turnbuckle.lab.benchmark.timing import time_in_turn
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
GENERATED = ROOT / "generated" / "yoon2023"
#: Rounding that the tensions of two exact methods may differ by, in units of eps T_max.
ROUNDING = 2**12


@pytest.fixture(scope="module")
def machine() -> Machine:
    return load_machine(ROOT / "machines" / "yoon2023.toml")


@pytest.fixture(scope="module")
def problems(machine: Machine) -> list[TensionProblems]:
    return tension_problems(machine, count=400, seed=7)


def at_minimum(problems: TensionProblems) -> Callable[[], Answers]:
    """A seeded defect: T_min everywhere, called solved."""
    count, _, cables = problems.structure.shape
    tension = np.full((count, cables), problems.machine.tension.min)
    return lambda: Answers(tension, np.ones(count, np.intc))


def test_programs_take_turns() -> None:
    calls: list[str] = []
    runs = {name: (lambda name=name: calls.append(name)) for name in "ab"}
    time_in_turn(runs, calls=1, repetitions=2)
    assert "".join(calls) == "ab" + "abab"


def test_the_least_time_is_not_above_the_median() -> None:
    timing = time_in_turn({"sum": lambda: sum(range(100))}, calls=1, repetitions=9)["sum"]
    assert 0 < timing.least <= timing.median


def test_exact_solvers_agree_with_the_reference(
    machine: Machine, problems: list[TensionProblems]
) -> None:
    tolerance = ROUNDING * np.finfo(float).eps * machine.tension.max
    for each in problems:
        table = compare([turnbuckle(GENERATED), QUADPROG], each, repetitions=1)
        assert [row.agreement.error < tolerance for row in table.rows] == [True, True]
        assert [(row.agreement.missed, row.agreement.invented) for row in table.rows] == [
            (0, 0)
        ] * 2


def test_casadi_solves_nearly_all(machine: Machine, problems: list[TensionProblems]) -> None:
    answers = qrqp(machine).prepare(problems[0])()
    reference = Reference.of(problems[0])
    off = np.max(np.abs(answers.tension - reference.tension), axis=1)
    assert np.mean(answers.solved) > 0.95
    assert np.mean(off < 1e-6 * machine.tension.max) > 0.95


def test_wrong_tensions_are_caught(problems: list[TensionProblems]) -> None:
    wrong = Solver("wrong", "", at_minimum)
    (row,) = compare([wrong], problems[0], repetitions=1).rows
    assert row.agreement.error > 1.0


def test_infeasible_problems_called_solved_are_caught(problems: list[TensionProblems]) -> None:
    table = compare([Solver("wrong", "", at_minimum)], problems[1], repetitions=1)
    assert table.feasible < table.count
    assert table.rows[0].agreement.invented == table.count - table.feasible


def test_problems_given_up_are_caught(problems: list[TensionProblems]) -> None:
    reference = Reference.of(problems[0])
    nothing = Answers(reference.tension, np.zeros(problems[0].count, np.intc))
    assert reference.judge(nothing).missed == problems[0].count


@pytest.mark.parametrize(("measured", "met"), [(4.99, False), (5.0, True)])
def test_a_promise_is_met_from_its_ratio_on(measured: float, met: bool) -> None:
    assert Target("a ratio", 5.0, measured).is_met is met
