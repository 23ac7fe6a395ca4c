"""CasADi's own QP solver, qrqp, as the C that CasADi generates for it."""

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

import casadi as ca

from turnbuckle.lab.benchmark.native import BUILD, PEER_FLAGS, compile_object
from turnbuckle.lab.benchmark.solvers.solver import Solver, adapter, c_solver
from turnbuckle.model.machine import Machine

QUIET = {"print_iter": False, "print_header": False, "print_info": False, "error_on_fail": True}
#: qrqp's own tolerances, 1e-8.
EXACT: Mapping[str, float] = MappingProxyType({})
#: What qrqp can reach in single precision.
SINGLE: Mapping[str, float] = MappingProxyType({"constr_viol_tol": 1e-4, "dual_inf_tol": 1e-4})


def qrqp(machine: Machine) -> Solver:
    """qrqp behind the common signature."""
    function = tension_function(machine, "qrqp_tension")
    source = generate_c(function)
    flags = (*PEER_FLAGS, f"-isystem{BUILD}", *work_sizes(function))
    objects = [
        adapter("qrqp", flags),
        compile_object(source, source.with_suffix(".o"), PEER_FLAGS),
    ]
    return c_solver("CasADi qrqp", "C from conic(), cold start", objects, column_major=True)


def tension_function(
    machine: Machine, name: str, tolerances: Mapping[str, float] = EXACT
) -> ca.Function:
    """(structure (d, n), wrench (d)) -> tension (n) of least norm, by conic."""
    cables, dof = len(machine.cables), machine.dof
    hessian = ca.DM.eye(cables)
    shape = {"h": hessian.sparsity(), "a": ca.Sparsity.dense(dof, cables)}
    solver = ca.conic(f"{name}_qp", "qrqp", shape, {**QUIET, **tolerances})
    structure, wrench = ca.MX.sym("structure", dof, cables), ca.MX.sym("wrench", dof)
    bounds = machine.tension
    solution = solver(
        h=hessian, g=ca.DM.zeros(cables), a=structure,
        lba=wrench, uba=wrench, lbx=bounds.min, ubx=bounds.max,
    )  # fmt: skip
    return ca.Function(name, [structure, wrench], [solution["x"]])


def generate_c(function: ca.Function) -> Path:
    """Write <name>.c and .h of a function, for this run."""
    generator = ca.CodeGenerator(f"{function.name()}.c", {"with_header": True})
    generator.add(function)
    generator.generate(f"{BUILD}/")
    return BUILD / f"{function.name()}.c"


def work_sizes(function: ca.Function) -> list[str]:
    """Sizes of the work arrays that a call needs, as definitions for the compiler."""
    sizes = {
        "ARG": function.sz_arg(),
        "RES": function.sz_res(),
        "IW": function.sz_iw(),
        "W": function.sz_w(),
    }
    return [f"-DSZ_{name}={max(1, size)}" for name, size in sizes.items()]
