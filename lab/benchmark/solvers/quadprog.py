"""quadprog (Goldfarb and Idnani): one call from Python a problem, and timed as such."""

from collections.abc import Callable

import numpy as np
import quadprog as package

from turnbuckle.lab.benchmark.solvers.solver import Answers, Solver
from turnbuckle.lab.benchmark.tension_problems import TensionProblems


def prepare(problems: TensionProblems) -> Callable[[], Answers]:
    """Constraints C' T >= b: the equalities first, then both bounds."""
    count, dof, cables = problems.structure.shape
    bounds = problems.machine.tension
    identity = np.eye(cables)
    nothing = np.zeros(cables)
    sides = np.hstack([identity, -identity])
    limits = np.repeat([bounds.min, -bounds.max], cables)
    matrices = [np.hstack([structure.T, sides]) for structure in problems.structure]
    rights = [np.concatenate([wrench, limits]) for wrench in problems.wrench]
    answers = Answers(np.empty((count, cables)), np.empty(count, np.intc))

    def solve() -> Answers:
        for i, (matrix, right) in enumerate(zip(matrices, rights, strict=True)):
            try:
                answers.tension[i] = package.solve_qp(identity, nothing, matrix, right, dof)[0]
                answers.solved[i] = 1
            except ValueError:
                answers.solved[i] = 0
        return answers

    return solve


QUADPROG = Solver("quadprog", "one Python call a problem", prepare)
