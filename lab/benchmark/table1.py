"""Brau et al., Table 1, run again in C: reduced matrices and ours against kernel and QP.

Tensions of a point that four cables from the corners of a square hold (section 3.2.2), for 15 x 16
points and 15 directions of the force. The paper gives neither the force nor the bounds.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.bind import folder_of
from turnbuckle.codegen.composite import Item
from turnbuckle.codegen.generate import render
from turnbuckle.codegen.model import Model, composed, lowered
from turnbuckle.lab.benchmark.solvers.kernel import DAQP, QUADPROG, kernel_daqp, kernel_quadprog
from turnbuckle.lab.benchmark.solvers.reduced import REDUCED, reduced
from turnbuckle.lab.benchmark.solvers.solver import Solver
from turnbuckle.lab.benchmark.solvers.turnbuckle import OURS, turnbuckle
from turnbuckle.lab.benchmark.tension import TensionTable, compare
from turnbuckle.lab.benchmark.tension_problems import Reals, TensionProblems
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import kinematics
from turnbuckle.model.symbolic import comparison, tension

POINTS, DIRECTIONS = (15, 16), 15
FORCE = 10.0  # N, of the paper's Figs 4 and 5
#: N. The method of the kernel needs T_min above zero, or it says nothing on slack cables; close to
#: a side of the square 10 N outwards take 51 N, so that with this T_max every problem is feasible.
BOUNDS = {"min": 1.0, "max": 60.0}
#: The paper's problems are few: ours solves all 3600 in a seventh of a millisecond.
SWEEPS, REPETITIONS = 4, 60


@dataclass(frozen=True)
class Excess:
    """How far tensions of some method are from the optimum, over all problems."""

    optimal: float  # share of the problems with the tensions of least norm
    norm: tuple[float, float]  # |T| over its least, minus 1: mean and largest
    tension: tuple[float, float]  # the same of the largest tension


@dataclass(frozen=True)
class Table1:
    """All methods on the paper's problems, and what reduced matrices give away."""

    table: TensionTable
    excess: Excess

    @property
    def ratio(self) -> float:
        """Least time of the faster kernel and QP, by ours."""
        return min(self.table.ratio(DAQP), self.table.ratio(QUADPROG))

    @property
    def published_ratio(self) -> float:
        """The paper's own: the faster kernel and QP, by reduced matrices."""
        return self.ratio / self.table.ratio(REDUCED)


def compare_table1(square: Machine) -> Table1:
    """Time all methods in turn on the same problems, and check what they answered."""
    machine = bounded(square)
    problems = table1_problems(machine)
    methods = table1_solvers(machine)
    table = compare([*methods.values()], problems, REPETITIONS, SWEEPS)
    best, found = (tensions(methods[name], problems) for name in (OURS, REDUCED))
    return Table1(table, excess_over(best, found))


def bounded(square: Machine) -> Machine:
    """The stock square, which takes T_min as null, with the bounds of this comparison."""
    return square.model_copy(update={"tension": square.tension.model_copy(update=BOUNDS)})


def table1_problems(machine: Machine) -> TensionProblems:
    """For each point in turn all directions, as the paper sweeps them; no point on a side."""
    x, y = (
        side * np.arange(1, count + 1) / (count + 1)
        for side, count in zip(machine.frame.size, POINTS, strict=True)
    )
    poses = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    structure = np.asarray(kinematics.structure_matrix(machine, poses, np.zeros(0)), float)
    angle = 2 * np.pi * np.arange(DIRECTIONS) / DIRECTIONS
    force = FORCE * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    return TensionProblems(
        f"Brau Table 1, 15 x 16 points, 15 directions of {FORCE:g} N",
        machine,
        np.repeat(structure, DIRECTIONS, axis=0),
        np.tile(force, (len(poses), 1)),
    )


def table1_solvers(machine: Machine) -> dict[str, Solver]:
    """Ours first; every method in C."""
    generated = tension_folder(machine)
    solvers = [
        turnbuckle(generated),
        reduced(generated),
        kernel_daqp(machine),
        kernel_quadprog(machine),
    ]
    return {solver.name: solver for solver in solvers}


def tension_folder(machine: Machine) -> Path:
    """A generated folder with the tension methods alone, accuracy not measured."""
    known: dict[str, Item] = {f.name: lowered(f) for f in tension.functions(machine)}
    for composite in tension.composites(machine):
        known[composite.name] = composed(composite, known)
    published: list[Item] = [lowered(f) for f in comparison.functions(machine)]
    model = Model(machine, {"tension": [*known.values()], "comparison": published})
    return folder_of(machine, render(model, {i.function.name: Accuracy() for i in model.items()}))


def tensions(solver: Solver, problems: TensionProblems) -> Reals:
    """What a solver answers: tension (count, n) [N]."""
    return solver.prepare(problems)().tension


def excess_over(best: Reals, found: Reals) -> Excess:
    """What tensions (count, n) have above those of least norm."""
    norm, least = np.linalg.norm(found, axis=1), np.linalg.norm(best, axis=1)
    # |T|^2 - |T*|^2 is at least |T - T*|^2, so norms that differ by rounding allow its root
    equal = np.max(np.abs(found - best), axis=1) <= np.sqrt(np.finfo(float).eps) * least
    return Excess(
        float(np.mean(equal)),
        mean_and_largest(norm / least - 1),
        mean_and_largest(np.max(found, axis=1) / np.max(best, axis=1) - 1),
    )


def mean_and_largest(values: Reals) -> tuple[float, float]:
    """Over all problems."""
    return float(np.mean(values)), float(np.max(values))
