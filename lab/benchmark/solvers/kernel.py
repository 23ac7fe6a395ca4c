"""Kernel and quadratic program (Brau eqs 3, 4): T = G+ F + K lambda with the least lambda.

Per problem G+ and an orthonormal K by reflections, in C; then a published solver finds the two
entries of lambda that bring all tensions within their bounds.
"""

from turnbuckle.lab.benchmark.native import BUILD, PEER_FLAGS, compile_object
from turnbuckle.lab.benchmark.solvers.daqp import daqp_library
from turnbuckle.lab.benchmark.solvers.solver import Solver, adapter, bound_flags, c_solver
from turnbuckle.lab.benchmark.solvers.source_package import fetch_source
from turnbuckle.model.machine import Machine

DAQP, QUADPROG = "kernel + DAQP", "kernel + quadprog"
#: The kernel is our C, so it gets what our C gets: square roots inline.
INLINE_ROOTS = ("-fno-math-errno", "-fno-trapping-math")


def kernel_daqp(machine: Machine) -> Solver:
    """With DAQP: kept workspace, cold start, problem data updated for every solve."""
    objects, flags = daqp_library()
    objects.append(adapter("kernel_daqp", (*flags, *INLINE_ROOTS, *bound_flags(machine))))
    return c_solver(DAQP, "C, kept workspace, update + solve", objects)


def kernel_quadprog(machine: Machine) -> Solver:
    """With the C of the quadprog package (Goldfarb and Idnani), called from C."""
    flags = (*PEER_FLAGS, *INLINE_ROOTS)
    objects = [
        compile_object(source, BUILD / "quadprog" / f"{source.stem}.o", flags)
        for source in sorted((fetch_source("quadprog") / "quadprog").glob("*.c"))
    ]
    objects.append(adapter("kernel_quadprog", (*flags, *bound_flags(machine))))
    return c_solver(QUADPROG, "its C called from C, factor given", objects)
