"""How good a pose is: tension factor and isotropic force, Yoon section III-A and III-B."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import arguments, kinematics, quality_by_facets
from turnbuckle.model.symbolic.active_set import ActiveSet, Answer, Bounded, Optimum, Start
from turnbuckle.model.symbolic.composition import Composite
from turnbuckle.model.symbolic.function import (
    EPSILON,
    Input,
    Label,
    ModelFunction,
    Output,
    Repeat,
    Status,
    Verdict,
    carried,
    matrix_output,
    not_all_above,
    scalar_output,
    vector_output,
)
from turnbuckle.model.symbolic.linear import dot, factorise, none_between, transpose
from turnbuckle.model.symbolic.null_space import factored
from turnbuckle.model.symbolic.rank import least_pivot, regular
from turnbuckle.model.symbolic.rest import from_neighbours
from turnbuckle.model.symbolic.scalar import (
    Matrix,
    Scalar,
    Vector,
    largest,
    smallest,
    total,
    where,
)
from turnbuckle.model.symbolic.tension import (
    KKT_TOLERANCE,
    PLANE,
    QUICK_TOLERANCE,
    is_unrolled,
    least_norm_tension,
    rank_lost,
    rounding,
    tolerated,
)
from turnbuckle.model.symbolic.wrench_set import FAR, WrenchSet, wrench_set

#: A result, and the verdicts and labels that come with it.
Taken = tuple[Output, tuple[Verdict, ...], tuple[Label, ...]]


@dataclass(frozen=True)
class Rig:
    """The cables at a pose: their directions u_i and the wrenches they can exert."""

    rays: Matrix
    bounds: tuple[float, float]

    @property
    def matrix(self) -> Matrix:
        """The structure matrix."""
        return transpose(self.rays)

    @cached_property
    def wrench_set(self) -> WrenchSet:
        """The feasible wrenches."""
        return wrench_set(self.rays, *self.bounds)

    def outside(self) -> Verdict:
        """The pose is outside the zero-wrench workspace."""
        return Verdict(
            ca.logic_not(self.wrench_set.contains_zero()),
            Status.INFEASIBLE,
            "the pose is outside the wrench-feasible workspace for zero wrench",
        )


@dataclass(frozen=True)
class Placed:
    """The machine at a symbolic pose."""

    inputs: tuple[Input, ...]
    cables: kinematics.Cables
    rig: Rig

    def touching(self) -> Verdict:
        """The platform is at a pulley."""
        return kinematics.touches_a_pulley(self.cables.clearances)

    def label(self) -> Label:
        """Names the cable lengths in the C."""
        return kinematics.length_label(self.cables.lengths)


def placed(machine: Machine) -> Placed:
    """The machine at any pose and any rail coordinates."""
    pose, rails = arguments.pose(machine), arguments.rails(machine)
    cables = kinematics.cables(machine, pose.scalars(), rails.scalars())
    rig = Rig(cables.rays, (machine.tension.min, machine.tension.max))
    return Placed((pose, rails), cables, rig)


@dataclass(frozen=True)
class Measure:
    """A measure of a pose that is taken of T0, the least-norm tensions under zero wrench.

    `take` makes results, verdicts and labels of the rig, its T0 and whether that is accurate.
    """

    name: str
    summary: str
    source: str
    take: Callable[[Machine, Rig, Vector, Scalar], Taken]


def unrolled(machine: Machine, measure: Measure) -> ModelFunction:
    """The measure in one pass."""
    here = placed(machine)
    zero = [ca.SX(0)] * machine.dof
    space = factored(here.rig.matrix, zero)
    rest = least_norm_tension(here.rig.matrix, zero, space, *here.rig.bounds)
    limit = rounding(KKT_TOLERANCE, ca.SX(machine.tension.max), space)
    output, verdicts, labels = measure.take(
        machine, here.rig, rest.tension, rest.kkt_residual <= limit
    )
    return ModelFunction(
        measure.name,
        measure.summary,
        measure.source,
        here.inputs,
        (output,),
        (here.touching(), rank_lost(space), *verdicts),
        (here.label(), *labels),
    )


def looped(machine: Machine, measure: Measure) -> Repeat:
    """The measure with a loop for T0."""
    here = placed(machine)
    pivots = factorise(here.rig.matrix).pivots()
    made = matrix_output("structure", "1", here.rig.matrix)
    (structure,) = carried([made])
    low, high = here.rig.bounds
    zero = [ca.SX(0)] * machine.dof
    loop = ActiveSet(
        Bounded(structure.rows(), zero, low, high, ca.SX(high)),
        (structure,),
        Start(here.inputs, (made,), pivots, (here.touching(), regular(pivots))),
    )

    def answer(best: Optimum, pivot: Scalar) -> Answer:
        rig = replace(here.rig, rays=transpose(structure.rows()))
        accurate = best.residual <= tolerated(machine, pivot)
        output, verdicts, _ = measure.take(machine, rig, best.tension, accurate)
        return (output,), verdicts

    return loop.repeat(measure.name, measure.summary, measure.source, answer)


def rest_tension(machine: Machine, rig: Rig, rest: Vector, accurate: Scalar) -> Taken:
    """T0 itself."""
    outside = rig.outside()
    tension = [where(outside.condition, machine.tension.min, value) for value in rest]
    inaccurate = Verdict(
        ca.logic_not(ca.logic_or(outside.condition, accurate)),
        Status.INACCURATE,
        "the optimality conditions are missed by more than rounding",
    )
    output = vector_output("tension", "N", tension, fallback=machine.tension.min)
    return output, (inaccurate, outside), ()


def factor(_: Machine, rig: Rig, rest: Vector, __: Scalar) -> Taken:
    """Least over largest zero-wrench tension."""
    outside = rig.outside()
    most = largest(rest)
    slack = not_all_above([most], 0, "T_min is 0, and so is every zero-wrench tension")
    output = scalar_output("factor", "1", where(outside.condition, 0, smallest(rest) / most))
    return output, (slack, outside), (Label("rest", rest, "T0"),)


@dataclass(frozen=True)
class Attempt:
    """TF from one way to find T0; `excess` is by how much T0 misses its check [N], if positive."""

    factor: Scalar
    excess: Scalar


def attempts(machine: Machine, rig: Rig) -> list[Attempt]:
    """TF in every way that this machine has, the quickest first; each checks itself."""
    low, high = rig.bounds
    if not low:
        return [Attempt(ca.SX(0), ca.SX(0))]
    limit = QUICK_TOLERANCE * EPSILON * high
    neighbours = from_neighbours(rig.wrench_set, limit)
    guesses = neighbours, neighbours.improved()
    quick = [Attempt(ratio(each.tension), each.miss - limit) for each in guesses]
    if not is_unrolled(machine):
        return quick
    zero = [ca.SX(0)] * machine.dof
    space = factored(rig.matrix, zero)
    rest = least_norm_tension(rig.matrix, zero, space, low, high)
    most = rounding(KKT_TOLERANCE, ca.SX(high), space)
    return [*quick, Attempt(ratio(rest.tension), rest.kkt_residual - most)]


def ratio(tension: Vector) -> Scalar:
    """Least over largest tension."""
    return smallest(tension) / largest(tension)


def parallel(rig: Rig) -> Verdict:
    """The cables are parallel: by det S S' (Cauchy-Binet), without a root."""
    squares = [x * x for i, row in enumerate(rig.wrench_set.crosses) for x in row[i + 1 :]]
    square = total(squares) / (len(rig.rays) / 2)
    return not_all_above([square], least_pivot() * least_pivot(), "the cables are parallel")


def pose_quality_function(machine: Machine) -> ModelFunction:
    """All that a map of poses shows, without doing common work twice.

    The quickest way to T0 is gone first, the next one where that fails its check, and none where
    the zero wrench is infeasible.
    """
    here = placed(machine)
    rig, outside = here.rig, here.rig.outside()
    margin = rig.wrench_set.inner_radius()
    ways = attempts(machine, rig)
    factor, excess = ways[-1].factor, ways[-1].excess
    for attempt in reversed(ways[:-1]):
        holds = attempt.excess <= 0
        factor, excess = where(holds, attempt.factor, factor), where(holds, 0, excess)
    inaccurate = Verdict(
        ca.logic_not(where(outside.condition, 0, excess) <= 0),
        Status.INACCURATE,
        "the optimality conditions of T0 are missed by more than rounding",
    )
    return ModelFunction(
        "pose_quality",
        "What a map shows of a pose: capacity margin, least distance of the zero wrench from a "
        "facet of the feasible forces, negative outside; TF = min(T0) / max(T0), 0 outside and "
        "for T_min = 0; I_F = max(0, margin). Every force up to F is feasible where margin >= F",
        "Yoon section III-A, eq. 13; Guay et al. 2014",
        here.inputs,
        (
            scalar_output("margin", "N", margin),
            scalar_output("factor", "1", where(outside.condition, 0, factor)),
            scalar_output("force", "N", ca.fmax(0, margin)),
        ),
        (here.touching(), parallel(rig), inaccurate, outside),
        (here.label(),),
    )


def force_eq17(machine: Machine, rig: Rig, rest: Vector, _: Scalar) -> Taken:
    """Isotropic force as published, from the parallelograms of adjacent tension margins."""
    outside = rig.outside()
    margins = [machine.tension.max - value for value in rest]
    radius = smallest(
        [
            where(adjacent(rig, i, j), parallelogram_radius(rig, margins, i, j), FAR)
            for i in range(len(margins))
            for j in range(len(margins))
            if i != j
        ]
    )
    output = scalar_output("force", "N", where(outside.condition, 0, radius))
    return output, (outside,), (Label("margin", margins, "t_i = T_max - T0_i"),)


MEASURES = (
    Measure(
        "zero_wrench_tension",
        "Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace",
        "Yoon eq. 12 with W = 0",
        rest_tension,
    ),
    Measure(
        "tension_factor",
        "Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace",
        "Yoon eq. 13",
        factor,
    ),
    Measure(
        "isotropic_force_eq17",
        "Isotropic force as published: a circle in the parallelograms of adjacent cables",
        "Yoon eq. 17; a lower bound of the true isotropic force",
        force_eq17,
    ),
)


def isotropic_force_function(machine: Machine) -> ModelFunction:
    """True isotropic force, from the facets of the feasible wrenches."""
    here = placed(machine)
    outside = here.rig.outside()
    radius = ca.fmax(0, here.rig.wrench_set.inner_radius())
    return ModelFunction(
        "isotropic_force",
        "Isotropic force I_F: the largest force in every direction; 0 outside the workspace",
        "Yoon section III-A, exact by the facets of {S T}; eq. 17 is a lower bound of it",
        here.inputs,
        (scalar_output("force", "N", radius),),
        (here.touching(), outside),
        (here.label(),),
    )


def adjacent(rig: Rig, i: int, j: int) -> Scalar:
    """Whether cable j is the next one counter-clockwise from cable i, at an angle in (0, pi]."""
    crosses = rig.wrench_set.crosses
    ahead = ca.logic_or(
        crosses[i][j] > 0,
        ca.logic_and(crosses[i][j] >= 0, dot(rig.rays[i], rig.rays[j]) < 0),
    )
    alone = none_between(i, j, len(rig.rays), lambda first, second: crosses[first][second] > 0)
    return ca.logic_and(ahead, alone)


def parallelogram_radius(rig: Rig, margins: Vector, i: int, j: int) -> Scalar:
    """r_i of eq. 17: the shorter side, or the smaller height where the angle exceeds pi/2."""
    shorter = ca.fmin(margins[i], margins[j])
    obtuse = dot(rig.rays[i], rig.rays[j]) < 0
    return where(obtuse, shorter * rig.wrench_set.crosses[i][j], shorter)


def functions(machine: Machine) -> list[ModelFunction]:
    """Everything this topic computes in one pass."""
    if machine.dof > PLANE:
        return []
    rest, factor, eq17 = MEASURES
    if not is_unrolled(machine):
        return [isotropic_force_function(machine), pose_quality_function(machine)]
    return [
        unrolled(machine, rest),
        unrolled(machine, factor),
        isotropic_force_function(machine),
        pose_quality_function(machine),
        unrolled(machine, eq17),
    ]


def composites(machine: Machine) -> list[Composite]:
    """The measures of tensions that take a loop, and all where facets are visited."""
    if machine.dof > PLANE:
        return [*quality_by_facets.composites(machine)]
    return [] if is_unrolled(machine) else [looped(machine, measure) for measure in MEASURES]
