"""How good a pose is: tension factor and isotropic force, Yoon section III-A and III-B."""

from dataclasses import dataclass

import casadi as ca

from model.machine import Machine
from model.symbolic import arguments, kinematics
from model.symbolic.function import (
    EPSILON,
    Input,
    Label,
    ModelFunction,
    Status,
    Verdict,
    not_all_above,
    scalar_output,
    vector_output,
)
from model.symbolic.linear import dot, norm, transpose
from model.symbolic.null_space import factored
from model.symbolic.rest import from_neighbours
from model.symbolic.scalar import (
    Matrix,
    Scalar,
    Vector,
    any_of,
    largest,
    smallest,
    total,
    where,
)
from model.symbolic.tension import (
    KKT_TOLERANCE,
    QUICK_TOLERANCE,
    Solution,
    least_norm_tension,
    least_pivot,
    rank_lost,
    rounding,
)
from model.symbolic.wrench_set import FAR, WrenchSet, wrench_set


@dataclass(frozen=True)
class Attempt:
    """TF from one way to find T0; `excess` is by how much T0 misses its check [N], if positive."""

    factor: Scalar
    excess: Scalar


class Rig:
    """The machine at a symbolic pose: its directions, wrench set and zero-wrench tensions."""

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.pose, self.rails = arguments.pose(machine), arguments.rails(machine)
        vectors = kinematics.cable_vectors(machine, self.pose.scalars(), self.rails.scalars())
        self.lengths = [norm(vector) for vector in vectors]
        self.rays: Matrix = kinematics.directions(vectors, self.lengths)
        self.bounds = machine.tension.min, machine.tension.max
        self.wrench_set: WrenchSet = wrench_set(self.rays, *self.bounds)
        self.zero = [ca.SX(0)] * machine.dof
        self.matrix = transpose(self.rays)
        self.space = factored(self.matrix, self.zero)

    @property
    def inputs(self) -> tuple[Input, ...]:
        """Pose and rail coordinates."""
        return self.pose, self.rails

    def at_rest(self) -> Solution:
        """T0, the least-norm tensions that hold the platform without any force on it."""
        return least_norm_tension(self.matrix, self.zero, self.space, *self.bounds)

    def attempts(self) -> list[Attempt]:
        """TF in every way that this machine has, the quickest first; each checks itself."""
        low, high = self.bounds
        if not low:
            return [Attempt(ca.SX(0), ca.SX(0))]
        rest = self.at_rest()
        limit = rounding(KKT_TOLERANCE, ca.SX(high), self.space)
        always = Attempt(ratio(rest.tension), rest.kkt_residual - limit)
        if self.machine.dof != 2:
            return [always]
        limit = QUICK_TOLERANCE * EPSILON * high
        neighbours = from_neighbours(self.wrench_set, limit)
        guesses = neighbours, neighbours.improved()
        return [*(Attempt(ratio(each.tension), each.miss - limit) for each in guesses), always]

    def touching(self) -> Verdict:
        """The platform is at a pulley."""
        return kinematics.touches_a_pulley(self.lengths)

    def parallel(self) -> Verdict:
        """The cables are parallel: by det S S' (Cauchy-Binet) in the plane, without a root."""
        if self.machine.dof != 2:
            return rank_lost(self.space)
        crosses = self.wrench_set.crosses
        squares = [x * x for i, row in enumerate(crosses) for x in row[i + 1 :]]
        square = total(squares) / (len(self.rays) / 2)
        return not_all_above([square], least_pivot() * least_pivot(), "the cables are parallel")

    def outside(self) -> Verdict:
        """The pose is outside the zero-wrench workspace."""
        return Verdict(
            ca.logic_not(self.wrench_set.contains_zero()),
            Status.INFEASIBLE,
            "the pose is outside the wrench-feasible workspace for zero wrench",
        )


def ratio(tension: Vector) -> Scalar:
    """Least over largest tension."""
    return smallest(tension) / largest(tension)


def zero_wrench_tension_function(machine: Machine) -> ModelFunction:
    """Least-norm tensions under zero wrench."""
    rig = Rig(machine)
    rest, outside = rig.at_rest(), rig.outside()
    tension = [where(outside.condition, machine.tension.min, value) for value in rest.tension]
    limit = rounding(KKT_TOLERANCE, ca.SX(machine.tension.max), rig.space)
    inaccurate = Verdict(
        ca.logic_not(ca.logic_or(outside.condition, rest.kkt_residual <= limit)),
        Status.INACCURATE,
        "the optimality conditions are missed by more than rounding",
    )
    return ModelFunction(
        "zero_wrench_tension",
        "Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace",
        "Yoon eq. 12 with W = 0",
        rig.inputs,
        (vector_output("tension", "N", tension, fallback=machine.tension.min),),
        (rig.touching(), rank_lost(rig.space), inaccurate, outside),
        (kinematics.length_label(rig.lengths),),
    )


def tension_factor_function(machine: Machine) -> ModelFunction:
    """Least over largest zero-wrench tension."""
    rig = Rig(machine)
    rest, outside = rig.at_rest(), rig.outside()
    most = largest(rest.tension)
    factor = smallest(rest.tension) / most
    slack = not_all_above([most], 0, "T_min is 0, and so is every zero-wrench tension")
    return ModelFunction(
        "tension_factor",
        "Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace",
        "Yoon eq. 13",
        rig.inputs,
        (scalar_output("factor", "1", where(outside.condition, 0, factor)),),
        (rig.touching(), rank_lost(rig.space), slack, outside),
        (kinematics.length_label(rig.lengths), Label("rest", rest.tension, "T0")),
    )


def isotropic_force_function(machine: Machine) -> ModelFunction:
    """True isotropic force, from the facets of the feasible wrenches."""
    rig = Rig(machine)
    outside = rig.outside()
    radius = ca.fmax(0, rig.wrench_set.inner_radius())
    return ModelFunction(
        "isotropic_force",
        "Isotropic force I_F: the largest force in every direction; 0 outside the workspace",
        "Yoon section III-A, exact by the facets of {S T}; eq. 17 is a lower bound of it",
        rig.inputs,
        (scalar_output("force", "N", radius),),
        (rig.touching(), outside),
        (kinematics.length_label(rig.lengths),),
    )


def pose_quality_function(machine: Machine) -> ModelFunction:
    """All that a map of poses shows, without doing common work twice.

    The quickest way to T0 is gone first, the next one where that fails its check, and none where
    the zero wrench is infeasible.
    """
    rig = Rig(machine)
    outside = rig.outside()
    margin = rig.wrench_set.inner_radius()
    attempts = rig.attempts()
    factor, excess = attempts[-1].factor, attempts[-1].excess
    for attempt in reversed(attempts[:-1]):
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
        rig.inputs,
        (
            scalar_output("margin", "N", margin),
            scalar_output("factor", "1", where(outside.condition, 0, factor)),
            scalar_output("force", "N", ca.fmax(0, margin)),
        ),
        (rig.touching(), rig.parallel(), inaccurate, outside),
        (kinematics.length_label(rig.lengths),),
    )


def isotropic_force_eq17_function(machine: Machine) -> ModelFunction:
    """Isotropic force as published, from the parallelograms of adjacent tension margins."""
    rig = Rig(machine)
    outside = rig.outside()
    margins = [machine.tension.max - value for value in rig.at_rest().tension]
    radius = smallest(
        [
            where(adjacent(rig, i, j), parallelogram_radius(rig, margins, i, j), FAR)
            for i in range(len(margins))
            for j in range(len(margins))
            if i != j
        ]
    )
    return ModelFunction(
        "isotropic_force_eq17",
        "Isotropic force as published: a circle in the parallelograms of adjacent cables",
        "Yoon eq. 17; a lower bound of the true isotropic force",
        rig.inputs,
        (scalar_output("force", "N", where(outside.condition, 0, radius)),),
        (rig.touching(), rank_lost(rig.space), outside),
        (kinematics.length_label(rig.lengths), Label("margin", margins, "t_i = T_max - T0_i")),
    )


def adjacent(rig: Rig, i: int, j: int) -> Scalar:
    """Whether cable j is the next one counter-clockwise from cable i, at an angle in (0, pi]."""
    crosses = rig.wrench_set.crosses
    ahead = ca.logic_or(
        crosses[i][j] > 0,
        ca.logic_and(crosses[i][j] >= 0, dot(rig.rays[i], rig.rays[j]) < 0),
    )
    between = [
        ca.logic_and(crosses[i][k] > 0, crosses[k][j] > 0)
        for k in range(len(rig.rays))
        if k not in (i, j)
    ]
    return ca.logic_and(ahead, ca.logic_not(any_of(between))) if between else ahead


def parallelogram_radius(rig: Rig, margins: Vector, i: int, j: int) -> Scalar:
    """r_i of eq. 17: the shorter side, or the smaller height where the angle exceeds pi/2."""
    shorter = ca.fmin(margins[i], margins[j])
    obtuse = dot(rig.rays[i], rig.rays[j]) < 0
    return where(obtuse, shorter * rig.wrench_set.crosses[i][j], shorter)


def functions(machine: Machine) -> list[ModelFunction]:
    """Everything this topic generates."""
    return [
        zero_wrench_tension_function(machine),
        tension_factor_function(machine),
        isotropic_force_function(machine),
        pose_quality_function(machine),
        isotropic_force_eq17_function(machine),
    ]
