"""Tension distribution: min |T| subject to S T = W, T_min <= T <= T_max (Yoon eq. 12), exactly.

What happens to a wrench that no admissible tension exerts is a policy of the machine file:
`scale` keeps its direction, `closest` takes the nearest feasible one, `paper` clips (eq. 22, 23).
"""

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from model.machine import Machine
from model.symbolic import arguments
from model.symbolic.function import (
    EPSILON,
    Label,
    ModelFunction,
    Output,
    Status,
    Verdict,
    scalar_output,
    vector_output,
)
from model.symbolic.linear import Factorisation, dot, factorise, multiply, transpose
from model.symbolic.polytope import UNBOUNDED, Slabs, nearest
from model.symbolic.scalar import (
    Matrix,
    Scalar,
    Vector,
    all_of,
    any_of,
    clamp,
    largest,
    total,
    where,
)
from model.symbolic.wrench_set import WrenchSet, wrench_set

#: Rounding that bounds may be missed by while solving, in units of EPSILON times the tension scale.
SLACK = 16.0
#: Self-check: the KKT residual may reach this many EPSILON times the tension scale.
KKT_TOLERANCE = 256.0
#: The structure matrix has lost rank when a pivot of its factorisation is below this many EPSILON.
RANK_TOLERANCE = 4096.0


@dataclass(frozen=True)
class Solution:
    """Least-norm tensions and the residual of their optimality conditions [N]."""

    tension: Vector
    delivered: Vector
    kkt_residual: Scalar


def least_norm_tension(
    structure: Matrix,
    factors: Factorisation,
    wrench: Vector,
    low: float,
    high: float | None,
) -> Solution:
    """The tension of least norm that exerts a feasible wrench; `high` None means unbounded."""
    start = factors.least_norm(wrench)
    normals = factors.null_space()
    top = ca.SX(UNBOUNDED) if high is None else ca.SX(high)
    slack = SLACK * EPSILON * tension_scale(wrench, low, high)
    slabs = Slabs(normals, [low - x for x in start], [top - x for x in start], slack)
    best = nearest(slabs)
    tension = [
        clamp(x + dot(normal, best.point), low, top)
        for x, normal in zip(start, normals, strict=True)
    ]
    delivered = multiply(structure, tension)
    misses = [ca.fabs(a - b) for a, b in zip(delivered, wrench, strict=True)]
    return Solution(tension, delivered, largest([best.misfit, *misses]))


def tension_scale(wrench: Vector, low: float, high: float | None) -> Scalar:
    """Magnitude that rounding errors of a tension are measured by [N]."""
    if high is not None:
        return ca.SX(high)
    return low + total([ca.fabs(x) for x in wrench])


Policy = Callable[[WrenchSet, Vector], Vector]


def scaled(feasible: WrenchSet, wrench: Vector) -> Vector:
    """Largest feasible fraction of the wrench; the closest one where its whole ray is infeasible."""
    low, high = feasible.fraction(wrench)
    missed = ca.logic_or(low > ca.fmin(high, 1), high < 0)
    closest = feasible.closest(wrench)
    return [
        where(missed, near, ca.fmin(high, 1) * entry)
        for near, entry in zip(closest, wrench, strict=True)
    ]


def closest(feasible: WrenchSet, wrench: Vector) -> Vector:
    """Nearest feasible wrench."""
    return feasible.closest(wrench)


POLICIES: dict[str, Policy] = {"scale": scaled, "closest": closest}
POLICY_MEANINGS = {
    "scale": "an infeasible wrench keeps its direction and is scaled down to the largest fraction",
    "closest": "an infeasible wrench is replaced by the nearest feasible one",
    "paper": "no upper bound while solving, then clipped to T_max (the wrench is not kept)",
}


def bounded_function(machine: Machine, name: str, policy: str) -> ModelFunction:
    """Exact bounded distribution; `policy` chooses what stands in for an infeasible wrench."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    matrix, wanted = structure.rows(), wrench.scalars()
    low, high = machine.tension.min, machine.tension.max
    feasible = wrench_set(transpose(matrix), low, high)
    infeasible = ca.logic_not(feasible.contains(wanted))
    substitute = POLICIES[policy](feasible, wanted)
    served = [where(infeasible, a, b) for a, b in zip(substitute, wanted, strict=True)]
    factors = factorise(matrix)
    solution = least_norm_tension(matrix, factors, served, low, high)
    return ModelFunction(
        name,
        "Tensions of least norm within their bounds; " + POLICY_MEANINGS[policy],
        "Yoon eq. 12",
        (structure, wrench),
        solution_outputs(machine, solution),
        (
            rank_lost(factors),
            inaccurate(machine, solution, ca.SX(high)),
            Verdict(infeasible, Status.INFEASIBLE, "no admissible tension exerts the wrench"),
        ),
        (
            Label("facet", feasible.halves, "facets of the feasible wrenches, half distances"),
            Label("served", served, "the wrench that is served"),
            Label("delivered", solution.delivered, "what the tensions exert, S T"),
        ),
    )


def paper_function(machine: Machine) -> ModelFunction:
    """Yoon's own control law: eq. 22 has no upper bound, eq. 23 clips what exceeds it."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    matrix, wanted = structure.rows(), wrench.scalars()
    low, high = machine.tension.min, machine.tension.max
    factors = factorise(matrix)
    unsolvable = outside_cone(transpose(matrix), wanted, low)
    served = [
        where(unsolvable, low * total(row), entry)
        for row, entry in zip(matrix, wanted, strict=True)
    ]
    solution = least_norm_tension(matrix, factors, served, low, None)
    clipped = [ca.fmin(value, high) for value in solution.tension]
    exceeds = any_of([value > high for value in solution.tension])
    answer = Solution(clipped, multiply(matrix, clipped), solution.kkt_residual)
    return ModelFunction(
        "distribute_tension_paper",
        "Tensions of least norm above T_min, then " + POLICY_MEANINGS["paper"],
        "Yoon eq. 22, 23",
        (structure, wrench),
        solution_outputs(machine, answer),
        (
            rank_lost(factors),
            inaccurate(machine, solution, tension_scale(served, low, None)),
            Verdict(
                ca.logic_or(unsolvable, exceeds),
                Status.INFEASIBLE,
                "a tension was clipped, or eq. 22 has no solution and every cable holds T_min",
            ),
        ),
    )


def outside_cone(columns: Matrix, wrench: Vector, low: float) -> Scalar:
    """Whether no tension above `low`, however large, exerts the wrench: eq. 22 has no solution."""
    pulls = wrench_set(columns, low, low)
    rest = [
        height - centre for height, centre in zip(pulls.heights(wrench), pulls.centres, strict=True)
    ]
    cuts = []
    for number, beyond in enumerate(rest):
        others = [pulls.crosses[number][j] for j in range(len(columns)) if j != number]
        cuts.append(ca.logic_and(all_of([x <= 0 for x in others]), beyond > 0))
        cuts.append(ca.logic_and(all_of([x >= 0 for x in others]), beyond < 0))
    return any_of(cuts)


def solution_outputs(machine: Machine, solution: Solution) -> tuple[Output, ...]:
    """Outputs of every distribution; T_min stands in for a result that must not be used."""
    return (
        vector_output("tension", "N", solution.tension, fallback=machine.tension.min),
        vector_output("delivered", "N", solution.delivered),
        scalar_output("kkt_residual", "N", solution.kkt_residual),
    )


def rank_lost(factors: Factorisation) -> Verdict:
    """The structure matrix does not span the wrenches."""
    limit = RANK_TOLERANCE * EPSILON
    return Verdict(
        ca.logic_not(factors.smallest_pivot() > limit), Status.SINGULAR, "the cables are parallel"
    )


def inaccurate(machine: Machine, solution: Solution, scale: Scalar) -> Verdict:
    """The self-check of the optimality conditions failed."""
    limit = KKT_TOLERANCE * len(machine.cables) * EPSILON * scale
    return Verdict(
        ca.logic_not(solution.kkt_residual <= limit),
        Status.INACCURATE,
        "the optimality conditions are missed by more than rounding",
    )


def functions(machine: Machine) -> list[ModelFunction]:
    """Everything this topic generates."""
    return [
        bounded_function(machine, "distribute_tension_scale", "scale"),
        bounded_function(machine, "distribute_tension_closest", "closest"),
        paper_function(machine),
    ]
