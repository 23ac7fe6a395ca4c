"""OSQP's generated C, an operator-splitting solver: default tolerances, inexact by design."""

import shutil

import numpy as np
import osqp as package
from scipy import sparse

from turnbuckle.lab.benchmark.native import BUILD, PEER_FLAGS, compile_object
from turnbuckle.lab.benchmark.solvers.solver import Solver, adapter, bound_flags, c_solver
from turnbuckle.model.machine import Machine

FOLDER = BUILD / "osqp"


def osqp(machine: Machine) -> Solver:
    """OSQP behind the common signature: cold start, matrix and bounds updated for every solve."""
    generate(machine)
    includes = f"-isystem{FOLDER}", f"-isystem{FOLDER}/inc/public", f"-isystem{FOLDER}/inc/private"
    sources = [*sorted((FOLDER / "src").glob("*.c")), FOLDER / "workspace.c"]
    objects = [
        compile_object(source, FOLDER / f"{source.stem}.o", (*PEER_FLAGS, *includes))
        for source in sources
    ]
    objects.append(adapter("osqp", (*PEER_FLAGS, *includes, *bound_flags(machine))))
    return c_solver("OSQP", "generated C, default tolerance 1e-3", objects, column_major=True)


def generate(machine: Machine) -> None:
    """Write OSQP's C for problems of this machine's size; every entry of S is stored."""
    dof, cables = machine.dof, len(machine.cables)
    constraints = sparse.csc_matrix(np.vstack([np.full((dof, cables), 0.5), np.eye(cables)]))
    wrench, bounds = np.zeros(dof), machine.tension
    model = package.OSQP()
    model.setup(
        sparse.identity(cables, format="csc"),
        np.zeros(cables),
        constraints,
        np.concatenate([wrench, np.full(cables, bounds.min)]),
        np.concatenate([wrench, np.full(cables, bounds.max)]),
        verbose=False,
        warm_starting=False,
    )
    shutil.rmtree(FOLDER, ignore_errors=True)
    model.codegen(str(FOLDER), parameters="matrices", extension_name=None)
