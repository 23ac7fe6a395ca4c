"""Tension distribution: min |T| subject to S T = W, T_min <= T <= T_max (Yoon eq. 12), exactly.

What happens to a wrench that no admissible tension exerts is a policy of the machine file:
`scale` keeps its direction, `closest` takes the nearest feasible one, `paper` clips (eq. 22, 23).
"""

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import arguments
from turnbuckle.model.symbolic.active_set import ActiveSet, Answer, Bounded, Optimum, Start
from turnbuckle.model.symbolic.composition import Call, Composite, Composition
from turnbuckle.model.symbolic.function import (
    EPSILON,
    Label,
    ModelFunction,
    Output,
    Repeat,
    Retry,
    Status,
    Verdict,
    carried,
    scalar_output,
    vector_output,
)
from turnbuckle.model.symbolic.linear import factorise, multiply, transpose
from turnbuckle.model.symbolic.nearest_wrench import Nearest, Reach, nearest_loop
from turnbuckle.model.symbolic.null_space import NullSpace, crossed, factored
from turnbuckle.model.symbolic.polytope import UNBOUNDED, Slabs
from turnbuckle.model.symbolic.rank import regular
from turnbuckle.model.symbolic.scalar import (
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
from turnbuckle.model.symbolic.wrench_norm import weighed, weighed_rows, weights
from turnbuckle.model.symbolic.wrench_ray import ray_outputs, ray_sweep
from turnbuckle.model.symbolic.wrench_set import WrenchSet, wrench_set

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
#: The solver without a loop nests once more with every redundant cable; beyond this many a loop
#: takes less code, and in more than two dimensions it closes fewer corners by rounding.
UNROLLED_REDUNDANCY = 2
#: Dimension in which the feasible wrenches are a polygon.
PLANE = 2

PAPER = "distribute_tension_paper"
PAPER_SUMMARY = (
    "Tensions of least norm above T_min, then clipped to T_max, which changes the wrench"
)
PAPER_SOURCE = "Yoon eq. 22, 23"


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
    return ModelFunction(
        name,
        f"Tensions of least norm within their bounds that exert a wrench{remark}",
        "Yoon eq. 12",
        (structure, wrench),
        solution_outputs(machine, solution),
        (rank_lost(space), kkt_missed(solution, limit)),
        solution_labels(space, solution),
    )


def kkt_missed(solution: Solution, limit: Scalar) -> Verdict:
    """The solution fails its own check."""
    return Verdict(
        ca.logic_not(solution.kkt_residual <= limit),
        Status.INACCURATE,
        "no admissible tension exerts the wrench, or the optimality conditions are missed",
    )


def active_set(machine: Machine, high: float | None) -> tuple[ActiveSet, Matrix]:
    """The loop for any number of cables, and S; moments count by the force at the lever."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    low, wanted = machine.tension.min, weighed(machine, wrench.scalars())
    magnitude = total([ca.fabs(x) for x in wanted])
    problem = Bounded(
        weighed_rows(machine, structure.rows()),
        wanted,
        low,
        UNBOUNDED if high is None else high,
        low + magnitude if high is None else ca.SX(high),
    )
    inputs, pivots = (structure, wrench), factorise(problem.matrix).pivots()
    start = Start(inputs, (), pivots, (regular(pivots),))
    return ActiveSet(problem, inputs, start), structure.rows()


def least_norm_loop(machine: Machine) -> Repeat:
    """Exact bounded distribution of a feasible wrench over any number of cables."""
    high = machine.tension.max
    loop, matrix = active_set(machine, high)

    def answer(best: Optimum, pivot: Scalar) -> Answer:
        solution = Solution(best.tension, multiply(matrix, best.tension), best.residual)
        return solution_outputs(machine, solution), (
            kkt_missed(solution, tolerated(machine, pivot)),
        )

    return loop.repeat(
        "least_norm_tension",
        "Tensions of least norm within their bounds that exert a wrench",
        "Yoon eq. 12, by active sets: Goldfarb, Idnani 1983",
        answer,
    )


def tolerated(machine: Machine, pivot: Scalar) -> Scalar:
    """Residual of a loop's optimality conditions that rounding explains [N]."""
    high, units = machine.tension.max, KKT_TOLERANCE * max(1.0, len(machine.cables) / 4)
    return ca.fmin(units * EPSILON * high / ca.fmin(1, pivot), LARGEST_MISS * high)


def paper_loop(machine: Machine) -> Repeat:
    """Yoon's own control law over any number of cables."""
    low, high = machine.tension.min, machine.tension.max
    loop, matrix = active_set(machine, None)

    def answer(best: Optimum, pivot: Scalar) -> Answer:
        limit = KKT_TOLERANCE * EPSILON * largest(best.tension) / pivot
        solved = best.residual <= ca.fmin(limit, LARGEST_MISS * high)
        solution, verdicts = clipped(matrix, best.tension, best.residual, solved, low, high)
        return solution_outputs(machine, solution), verdicts

    return loop.repeat(PAPER, PAPER_SUMMARY, PAPER_SOURCE, answer)


def served_wrench_function(machine: Machine, policy: str) -> ModelFunction:
    """The feasible wrench that a policy puts in place of an infeasible one, in the plane."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    wanted = wrench.scalars()
    feasible = wrench_set(transpose(structure.rows()), machine.tension.min, machine.tension.max)
    choose, _ = POLICIES[policy]
    outputs, infeasible = served_outputs(
        feasible.contains(wanted), wanted, choose(feasible, wanted), feasible.middle
    )
    return ModelFunction(
        *served_names(policy, "facets of the zonotope {S T}"),
        (structure, wrench),
        outputs,
        (infeasible,),
        (Label("facet", feasible.halves, "facets of the feasible wrenches, half distances"),),
    )


def served_names(policy: str, source: str) -> tuple[str, str, str]:
    """Name, summary and source of the function that serves the wrench of a policy."""
    _, meaning = POLICIES[policy]
    return (
        f"served_wrench_{policy}",
        f"The wrench that is served: an infeasible one {meaning}",
        source,
    )


def served_outputs(
    inside: Scalar, wanted: Vector, border: Vector, middle: Vector
) -> tuple[tuple[Output, ...], Verdict]:
    """The wanted wrench, or one just inside the border; then one with more room."""
    served = [
        where(inside, asked, edge + OFF_BORDER * EPSILON * (centre - edge))
        for asked, edge, centre in zip(wanted, border, middle, strict=True)
    ]
    inner = [a + INWARDS * (b - a) for a, b in zip(served, middle, strict=True)]
    outputs = vector_output("served", "N", served), vector_output("inner", "N", inner)
    infeasible = Verdict(ca.logic_not(inside), Status.INFEASIBLE, "no admissible tension exerts it")
    return outputs, infeasible


def closest_loop(machine: Machine) -> Repeat:
    """The nearest feasible wrench in any dimension; moments count by the force at the lever."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    matrix, wanted = structure.rows(), wrench.scalars()
    low, high = machine.tension.min, machine.tension.max
    reach = Reach(weighed_rows(machine, matrix), weighed(machine, wanted), low, high)
    middle = [(low + high) / 2 * total(row) for row in matrix]

    def answer(found: Nearest) -> tuple[tuple[Output, ...], tuple[Verdict, ...]]:
        offset = [x / w for x, w in zip(found.offset, weights(machine), strict=True)]
        border = [a + b for a, b in zip(wanted, offset, strict=True)]
        outputs, infeasible = served_outputs(found.inside, wanted, border, middle)
        return outputs, (found.inaccurate, infeasible)

    names = served_names("closest", "point of least norm of {S T - W}: Wolfe 1976")
    return nearest_loop(names, (structure, wrench), reach, answer)


def scale_by_ray(machine: Machine) -> Composition:
    """The largest feasible fraction in any dimension; the nearest wrench where there is none."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    nothing = [ca.SX(0)] * machine.dof
    told = (*ray_outputs(*nothing[:1] * 3), vector_output("closest", "N", nothing))
    ray = carried(told)
    feasible, fraction, missed, *closest = [x for port in ray for x in port.scalars()]
    border = [
        where(missed > 0, near, fraction * asked)
        for near, asked in zip(closest, wrench.scalars(), strict=True)
    ]
    mean = (machine.tension.min + machine.tension.max) / 2
    middle = [mean * total(row) for row in structure.rows()]
    outputs, infeasible = served_outputs(feasible > 0, wrench.scalars(), border, middle)
    name, summary, source = served_names("scale", "facets of the zonotope {S T}")
    inputs = (structure, wrench)
    last = ModelFunction(
        "served_fraction", summary, source, (*inputs, *ray), outputs, (infeasible,)
    )
    nearest = Call("served_wrench_closest", {"served": "closest", "inner": "closer"}, "missed")
    calls = (Call(ray_sweep(machine, structure, wrench)), nearest, Call(last))
    return Composition(name, summary, source, inputs, calls)


def paper_function(machine: Machine) -> ModelFunction:
    """Yoon's own control law: eq. 22 has no upper bound, eq. 23 clips what exceeds it."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    matrix, wanted = structure.rows(), wrench.scalars()
    low, high = machine.tension.min, machine.tension.max
    space = factored(matrix, wanted)
    solution = least_norm_tension(matrix, wanted, space, low, None)
    limit = rounding(KKT_TOLERANCE, largest(solution.tension), space)
    solved = solution.kkt_residual <= ca.fmin(limit, LARGEST_MISS * high)
    answer, verdicts = clipped(matrix, solution.tension, solution.kkt_residual, solved, low, high)
    return ModelFunction(
        PAPER,
        PAPER_SUMMARY,
        PAPER_SOURCE,
        (structure, wrench),
        solution_outputs(machine, answer),
        (rank_lost(space), *verdicts),
        solution_labels(space, answer),
    )


def clipped(
    matrix: Matrix, tension: Vector, residual: Scalar, solved: Scalar, low: float, high: float
) -> tuple[Solution, tuple[Verdict, ...]]:
    """What eq. 23 makes of a solution of eq. 22; T_min where there is none."""
    held = [where(solved, ca.fmin(value, high), low) for value in tension]
    exceeds = any_of([value > high for value in tension])
    return Solution(held, multiply(matrix, held), where(solved, residual, 0)), (
        Verdict(
            ca.logic_not(solved),
            Status.INFEASIBLE,
            "eq. 22 has no solution, and every cable holds T_min",
        ),
        Verdict(exceeds, Status.INFEASIBLE, "eq. 23 clipped a tension"),
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
    return regular(space.pivots)


def is_unrolled(machine: Machine) -> bool:
    """Whether tensions are found without a loop: in the plane, of few cables."""
    return machine.dof == PLANE and machine.redundancy <= UNROLLED_REDUNDANCY


def planar_policies(machine: Machine) -> list[str]:
    """Policies that the polygon of feasible forces decides."""
    return list(POLICIES) if machine.dof == PLANE else []


def functions(machine: Machine) -> list[ModelFunction]:
    """Everything this topic computes in one pass."""
    served = [served_wrench_function(machine, policy) for policy in planar_policies(machine)]
    if not is_unrolled(machine):
        return served
    return [
        *(least_norm_function(machine, *method) for method in methods(machine)),
        *served,
        paper_function(machine),
    ]


Method = tuple[str, Callable[[Matrix, Vector], NullSpace], float, str]


def methods(machine: Machine) -> list[Method]:
    """The ways to distribute a feasible wrench that this machine has, the quickest first."""
    remark = ", from cross products alone"
    quick = ("least_norm_tension_quick", crossed, QUICK_TOLERANCE, remark)
    always = ("least_norm_tension", factored, KKT_TOLERANCE, "")
    return [quick, always] if (machine.dof, len(machine.cables)) == (2, 4) else [always]


def composites(machine: Machine) -> list[Composite]:
    """Loops, and distributions that serve another wrench where the wanted one is infeasible."""
    result: list[Composite] = []
    if not is_unrolled(machine):
        result += [least_norm_loop(machine), paper_loop(machine)]
    if machine.dof > PLANE:
        result += [closest_loop(machine), scale_by_ray(machine)]
    for policy, (_, meaning) in POLICIES.items():
        retry = Retry(
            f"distribute_tension_{policy}",
            f"Tensions of least norm within their bounds; an infeasible wrench {meaning}",
            "Yoon eq. 12",
            tuple(name for name, *_ in methods(machine)),
            f"served_wrench_{policy}",
            "wrench",
        )
        result.append(retry)
    return result
