"""What the benchmark asks of a solver of tension problems."""

import ctypes
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from turnbuckle.lab.benchmark.native import BUILD, OUR_WARNINGS, compile_object, load_library
from turnbuckle.lab.benchmark.tension_problems import Reals, TensionProblems
from turnbuckle.model.machine import Machine

FOLDER = Path(__file__).parent


@dataclass(frozen=True)
class Answers:
    """What a solver found: tension (count, n) [N], and which problems it calls solved (count)."""

    tension: Reals
    solved: NDArray[np.intc]


@dataclass(frozen=True)
class Solver:
    """`prepare` lays the problems out as the solver likes them, untimed; the result solves all."""

    name: str
    note: str
    prepare: Callable[[TensionProblems], Callable[[], Answers]]


def c_solver(name: str, note: str, objects: Sequence[Path], column_major: bool = False) -> Solver:
    """A solver in C: void solve_all(count, structure, wrench, tension, solved)."""
    solve_all = load_library(name, objects).solve_all
    solve_all.argtypes = [ctypes.c_size_t] + [ctypes.c_void_p] * 4
    solve_all.restype = None

    def prepare(problems: TensionProblems) -> Callable[[], Answers]:
        axes = (0, 2, 1) if column_major else (0, 1, 2)
        structure = np.ascontiguousarray(problems.structure.transpose(axes))
        wrench = np.ascontiguousarray(problems.wrench)
        count, cables = problems.count, problems.structure.shape[2]
        answers = Answers(np.empty((count, cables)), np.empty(count, np.intc))
        arrays = structure, wrench, answers.tension, answers.solved

        def solve() -> Answers:
            solve_all(count, *(array.ctypes.data for array in arrays))
            return answers

        return solve

    return Solver(name, note, prepare)


def adapter(name: str, flags: Sequence[str]) -> Path:
    """The object of <name>.c beside this file: the solver behind the common signature."""
    target = BUILD / f"{name}_adapter.o"
    return compile_object(FOLDER / f"{name}.c", target, (*flags, *OUR_WARNINGS))


def bound_flags(machine: Machine) -> tuple[str, str]:
    """The tension bounds [N] as definitions for an adapter."""
    return f"-DTENSION_MIN={machine.tension.min!r}", f"-DTENSION_MAX={machine.tension.max!r}"
