"""Ours: the generated tb_distribute_tension, as shipped, with its self-check and its policy."""

from pathlib import Path

from turnbuckle.lab.benchmark.native import BUILD, OUR_FLAGS, compile_object
from turnbuckle.lab.benchmark.solvers.solver import Solver, adapter, c_solver

OURS = "turnbuckle"


def turnbuckle(generated: Path) -> Solver:
    """The solver of one machine's generated folder."""
    flags = (*OUR_FLAGS, f"-I{generated}")
    objects = [
        adapter("turnbuckle", flags),
        compile_object(generated / "tb_tension.c", BUILD / "tb_tension.o", flags),
    ]
    return c_solver(OURS, "status, policy and KKT check included", objects)
