"""The tension solve: ours against published solvers, judged by the independent reference."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from turnbuckle.lab.benchmark.solvers.daqp import daqp
from turnbuckle.lab.benchmark.solvers.osqp import osqp
from turnbuckle.lab.benchmark.solvers.qrqp import qrqp
from turnbuckle.lab.benchmark.solvers.quadprog import QUADPROG
from turnbuckle.lab.benchmark.solvers.solver import Answers, Solver
from turnbuckle.lab.benchmark.solvers.turnbuckle import turnbuckle
from turnbuckle.lab.benchmark.tension_problems import Reals, TensionProblems
from turnbuckle.lab.benchmark.timing import Timing, time_in_turn
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.tension import minimum_norm_tension, wrench_feasible


@dataclass(frozen=True)
class Agreement:
    """How a solver's answers compare with the reference."""

    error: float  # N, largest |dT| where both call the problem solved
    missed: int  # feasible problems it does not solve
    invented: int  # infeasible problems it claims to solve


@dataclass(frozen=True)
class Row:
    """One solver on one set of problems."""

    name: str
    note: str
    timing: Timing
    agreement: Agreement


@dataclass(frozen=True)
class TensionTable:
    """All solvers on one set of problems, ours first."""

    problems: str
    count: int
    feasible: int
    rows: list[Row]

    def ratio(self, solver: str) -> float:
        """Least time of a solver, by ours."""
        times = {row.name: row.timing.least for row in self.rows}
        return times[solver] / self.rows[0].timing.least


def all_solvers(machine: Machine, generated: Path) -> list[Solver]:
    """Ours first, then the peers."""
    return [turnbuckle(generated), daqp(machine), qrqp(machine), osqp(machine), QUADPROG]


def compare(
    solvers: Sequence[Solver], problems: TensionProblems, repetitions: int, sweeps: int = 1
) -> TensionTable:
    """Time all solvers in turn and check what they answered.

    In its turn a solver sweeps the problems so many times: of few problems, one sweep would time
    how caches forget what the solver before it left there.
    """
    runs = {solver.name: swept(solver.prepare(problems), sweeps) for solver in solvers}
    timings = time_in_turn(runs, problems.count * sweeps, repetitions)
    reference = Reference.of(problems)
    rows = [
        Row(solver.name, solver.note, timings[solver.name], reference.judge(runs[solver.name]()))
        for solver in solvers
    ]
    return TensionTable(problems.name, problems.count, int(np.sum(reference.feasible)), rows)


def swept(solve: Callable[[], Answers], sweeps: int) -> Callable[[], Answers]:
    """Solves all problems so many times and gives the last answers."""

    def sweep() -> Answers:
        for _ in range(sweeps - 1):
            solve()
        return solve()

    return sweep


@dataclass(frozen=True)
class Reference:
    """What the independent reference answers."""

    feasible: NDArray[np.bool_]  # (count)
    tension: Reals  # (count, n) N, where feasible

    @classmethod
    def of(cls, problems: TensionProblems) -> "Reference":
        """Solve all problems."""
        machine, structure, wrench = problems.machine, problems.structure, problems.wrench
        bounds = machine.tension
        best = minimum_norm_tension(structure, wrench, bounds.min, bounds.max)
        return cls(wrench_feasible(machine, structure, wrench), np.asarray(best.tension, float))

    def judge(self, answers: Answers) -> Agreement:
        """Compare a solver's answers with these."""
        solved = answers.solved.astype(bool)
        errors = np.abs(answers.tension - self.tension)[solved & self.feasible]
        return Agreement(
            error=float(np.max(errors, initial=0.0)),
            missed=int(np.sum(self.feasible & ~solved)),
            invented=int(np.sum(solved & ~self.feasible)),
        )
