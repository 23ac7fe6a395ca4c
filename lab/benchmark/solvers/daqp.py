"""DAQP, a dual active-set solver in C: its own source and flags, a workspace that is kept."""

from pathlib import Path

from turnbuckle.lab.benchmark.native import BUILD, PEER_FLAGS, compile_object
from turnbuckle.lab.benchmark.solvers.solver import Solver, adapter, bound_flags, c_solver
from turnbuckle.lab.benchmark.solvers.source_package import fetch_source
from turnbuckle.model.machine import Machine

#: The flags of DAQP's own Python package, less its timers.
AUTHORS_FLAGS = ("-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math")


def daqp(machine: Machine) -> Solver:
    """DAQP behind the common signature: cold start, problem data updated for every solve."""
    objects, flags = daqp_library()
    objects.append(adapter("daqp", (*flags, *bound_flags(machine))))
    return c_solver("DAQP", "C, kept workspace, update + solve", objects)


def daqp_library() -> tuple[list[Path], tuple[str, ...]]:
    """DAQP's objects, and the flags for what calls them."""
    sources = fetch_source("daqp") / "csrc"
    flags = (*PEER_FLAGS, *AUTHORS_FLAGS)
    objects = [
        compile_object(
            source, BUILD / "daqp" / f"{source.stem}.o", (*flags, f"-I{sources}/include")
        )
        for source in sorted((sources / "src").glob("*.c"))
    ]
    return objects, (*flags, f"-isystem{sources}/include")
