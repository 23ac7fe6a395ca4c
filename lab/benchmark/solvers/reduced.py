"""Reduced matrices (Brau eqs 6, 7, corrected), as generated; not the optimum, and no T_max."""

from pathlib import Path

from turnbuckle.lab.benchmark.native import BUILD, OUR_FLAGS, compile_object
from turnbuckle.lab.benchmark.solvers.solver import Solver, adapter, c_solver

REDUCED = "reduced matrices"


def reduced(generated: Path) -> Solver:
    """The method of one machine's generated folder."""
    flags = (*OUR_FLAGS, f"-I{generated}")
    objects = [
        adapter("reduced", flags),
        compile_object(generated / "tb_comparison.c", BUILD / "tb_comparison.o", flags),
    ]
    return c_solver(REDUCED, "status included; lowest sum, T_max not looked at", objects)
