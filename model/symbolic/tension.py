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
    Retry,
    Status,
    Verdict,
    not_all_above,
    scalar_output,
    vector_output,
)
from model.symbolic.linear import multiply, transpose
from model.symbolic.null_space import NullSpace, crossed, factored
from model.symbolic.polytope import UNBOUNDED, Slabs
from model.symbolic.scalar import (
    Matrix,
    Scalar,
    Vector,
    any_of,
    clamp,
    largest,
    smallest,
    total,
    where,
)
from model.symbolic.wrench_set import WrenchSet, wrench_set

#: Rounding that bounds may be missed by while solving, in units of EPSILON times the tension scale.
SLACK = 3.0
#: The KKT residual of a solution reaches at most this many EPSILON times the tension scale.
KKT_TOLERANCE = 128.0
#: The quick attempt is only taken where it is as good as usual; else the robust one is asked.
QUICK_TOLERANCE = 12.0
#: A wrench on the border leaves its tensions a corner that rounding may close. So the served one is
#: moved off it, towards the middle of the feasible wrenches, by this many EPSILON of the way ...
OFF_BORDER = 32.0
#: ... and where that was not enough, by this part: room even in single precision.
INWARDS = 2.0**-18
#: A wrench missed by more than this part of T_max is not solved, however large the tensions.
LARGEST_MISS = 1e-3
#: The structure matrix has lost rank when a pivot of its factorisation is below this: cables within
#: a millionth of a radian of one line hold nothing across it ...
SMALLEST_PIVOT = 1e-6
#: ... or below this many EPSILON, where a pivot is rounding.
RANK_TOLERANCE = 4096.0


@dataclass(frozen=True)
class Solution:
    """Least-norm tensions and the residual of their optimality conditions [N]."""

    tension: Vector
    delivered: Vector
    kkt_residual: Scalar


def least_norm_tension(
    matrix: Matrix, wrench: Vector, space: NullSpace, low: float, high: float | None
) -> Solution:
    """The tension of least norm that exerts a feasible wrench; `high` None means unbounded."""
    top = ca.SX(UNBOUNDED) if high is None else ca.SX(high)
    magnitude = total([ca.fabs(x) for x in wrench])
    slabs = Slabs(
        [low - x for x in space.start],
        [top - x for x in space.start],
        rounding(SLACK, ca.SX(high) if high is not None else low + magnitude, space),
    )
    best = space.space.nearest(slabs, len(space.start))
    tension = [
        clamp(start + shift, low, top) for start, shift in zip(space.start, best.shift, strict=True)
    ]
    delivered = multiply(matrix, tension)
    misses = [ca.fabs(a - b) for a, b in zip(delivered, wrench, strict=True)]
    return Solution(tension, delivered, largest([best.misfit, *misses]))


def rounding(units: float, scale: Scalar, space: NullSpace) -> Scalar:
    """So many EPSILON of a scale of tensions, more where S is nearly singular [N]."""
    # Every dimension beyond two nests the solver once more, and rounds once more.
    nested = 4 ** max(0, len(space.start) - len(space.pivots) - 2)
    return units * nested * EPSILON * scale / smallest(space.pivots)


Policy = Callable[[WrenchSet, Vector], Vector]


def scaled(feasible: WrenchSet, wrench: Vector) -> Vector:
    """Largest feasible fraction of the wrench; the closest one where there is none."""
    fraction, missed = feasible.fraction(wrench)
    closest = feasible.closest(wrench)
    return [
        where(missed, near, fraction * entry) for near, entry in zip(closest, wrench, strict=True)
    ]


def closest(feasible: WrenchSet, wrench: Vector) -> Vector:
    """Nearest feasible wrench."""
    return feasible.closest(wrench)


POLICIES: dict[str, tuple[Policy, str]] = {
    "scale": (scaled, "keeps its direction and is scaled down to the largest feasible fraction"),
    "closest": (closest, "is replaced by the nearest feasible one"),
}


def least_norm_function(
    machine: Machine,
    name: str,
    method: Callable[[Matrix, Vector], NullSpace],
    tolerance: float,
    remark: str,
) -> ModelFunction:
    """Exact bounded distribution of a feasible wrench."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    matrix, wanted = structure.rows(), wrench.scalars()
    low, high = machine.tension.min, machine.tension.max
    space = method(matrix, wanted)
    solution = least_norm_tension(matrix, wanted, space, low, high)
    limit = ca.fmin(rounding(tolerance, ca.SX(high), space), LARGEST_MISS * high)
    missed = ca.logic_not(solution.kkt_residual <= limit)
    return ModelFunction(
        name,
        f"Tensions of least norm within their bounds that exert a wrench{remark}",
        "Yoon eq. 12",
        (structure, wrench),
        solution_outputs(machine, solution),
        (
            rank_lost(space),
            Verdict(
                missed,
                Status.INACCURATE,
                "no admissible tension exerts the wrench, or the optimality conditions are missed",
            ),
        ),
        solution_labels(space, solution),
    )


def served_wrench_function(machine: Machine, policy: str) -> ModelFunction:
    """The feasible wrench that a policy puts in place of an infeasible one."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    wanted = wrench.scalars()
    feasible = wrench_set(transpose(structure.rows()), machine.tension.min, machine.tension.max)
    inside = feasible.contains(wanted)
    choose, meaning = POLICIES[policy]
    border = choose(feasible, wanted)
    served = [
        where(inside, asked, edge + OFF_BORDER * EPSILON * (middle - edge))
        for asked, edge, middle in zip(wanted, border, feasible.middle, strict=True)
    ]
    inner = [a + INWARDS * (b - a) for a, b in zip(served, feasible.middle, strict=True)]
    return ModelFunction(
        f"served_wrench_{policy}",
        f"The wrench that is served: an infeasible one {meaning}",
        "facets of the zonotope {S T}",
        (structure, wrench),
        (vector_output("served", "N", served), vector_output("inner", "N", inner)),
        (Verdict(ca.logic_not(inside), Status.INFEASIBLE, "no admissible tension exerts it"),),
        (Label("facet", feasible.halves, "facets of the feasible wrenches, half distances"),),
    )


def paper_function(machine: Machine) -> ModelFunction:
    """Yoon's own control law: eq. 22 has no upper bound, eq. 23 clips what exceeds it."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    matrix, wanted = structure.rows(), wrench.scalars()
    low, high = machine.tension.min, machine.tension.max
    space = factored(matrix, wanted)
    solution = least_norm_tension(matrix, wanted, space, low, None)
    limit = rounding(KKT_TOLERANCE, largest(solution.tension), space)
    solved = solution.kkt_residual <= ca.fmin(limit, LARGEST_MISS * high)
    clipped = [where(solved, ca.fmin(value, high), low) for value in solution.tension]
    exceeds = any_of([value > high for value in solution.tension])
    answer = Solution(clipped, multiply(matrix, clipped), where(solved, solution.kkt_residual, 0))
    return ModelFunction(
        "distribute_tension_paper",
        "Tensions of least norm above T_min, then clipped to T_max, which changes the wrench",
        "Yoon eq. 22, 23",
        (structure, wrench),
        solution_outputs(machine, answer),
        (
            rank_lost(space),
            Verdict(
                ca.logic_not(solved),
                Status.INFEASIBLE,
                "eq. 22 has no solution, and every cable holds T_min",
            ),
            Verdict(exceeds, Status.INFEASIBLE, "eq. 23 clipped a tension"),
        ),
        solution_labels(space, answer),
    )


def solution_labels(space: NullSpace, solution: Solution) -> tuple[Label, ...]:
    """Names for what every distribution computes."""
    return (
        *space.labels,
        Label("start", space.start, "the least-norm tensions that exert the wrench"),
        Label("delivered", solution.delivered, "what the tensions exert, S T"),
    )


def solution_outputs(machine: Machine, solution: Solution) -> tuple[Output, ...]:
    """Outputs of every distribution; T_min stands in for a result that must not be used."""
    return (
        vector_output("tension", "N", solution.tension, fallback=machine.tension.min),
        vector_output("delivered", "N", solution.delivered),
        scalar_output("kkt_residual", "N", solution.kkt_residual),
    )


def rank_lost(space: NullSpace) -> Verdict:
    """The structure matrix does not span the wrenches."""
    return not_all_above(space.pivots, least_pivot(), "the cables are parallel")


def least_pivot() -> Scalar:
    """No larger, a pivot of the structure matrix counts as zero."""
    return ca.fmax(SMALLEST_PIVOT, RANK_TOLERANCE * EPSILON)


def functions(machine: Machine) -> list[ModelFunction]:
    """Everything this topic computes in one pass."""
    return [
        *(least_norm_function(machine, *method) for method in methods(machine)),
        served_wrench_function(machine, "scale"),
        served_wrench_function(machine, "closest"),
        paper_function(machine),
    ]


Method = tuple[str, Callable[[Matrix, Vector], NullSpace], float, str]


def methods(machine: Machine) -> list[Method]:
    """The ways to distribute a feasible wrench that this machine has, the quickest first."""
    remark = ", from cross products alone"
    quick = ("least_norm_tension_quick", crossed, QUICK_TOLERANCE, remark)
    always = ("least_norm_tension", factored, KKT_TOLERANCE, "")
    return [quick, always] if (machine.dof, len(machine.cables)) == (2, 4) else [always]


def procedures(machine: Machine) -> list[Retry]:
    """Distributions that serve another wrench where the wanted one is infeasible."""
    return [
        Retry(
            f"distribute_tension_{policy}",
            f"Tensions of least norm within their bounds; an infeasible wrench {meaning}",
            "Yoon eq. 12",
            tuple(name for name, *_ in methods(machine)),
            f"served_wrench_{policy}",
            "wrench",
        )
        for policy, (_, meaning) in POLICIES.items()
    ]
