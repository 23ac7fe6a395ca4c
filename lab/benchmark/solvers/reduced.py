"""Reduced matrices (Brau eqs 6, 7, corrected), as generated; not the optimum, and no T_max."""

from pathlib import Path

from lab.benchmark.native import BUILD, OUR_FLAGS, compile_object
from lab.benchmark.solvers.solver import Solver, adapter, c_solver

REDUCED = "reduced matrices"


def reduced(generated: Path) -> Solver:
    """The method in a generated folder that has it."""
    flags = (*OUR_FLAGS, f"-I{generated}")
    objects = [
        adapter("reduced", flags),
        compile_object(generated / "tb_tension.c", BUILD / "tb_tension.o", flags),
    ]
    return c_solver(REDUCED, "status included; lowest sum, T_max not looked at", objects)
