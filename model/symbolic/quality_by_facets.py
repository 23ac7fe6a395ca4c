"""How good a pose is, in more than two dimensions: facets are visited, not written out.

Zero-wrench tension, tension factor and isotropic force (Yoon section III-A and III-B) are calls in
sequence: the structure matrix of the pose, then what a sweep over the facets and the tension
distribution make of it. The isotropic force of a platform that turns is that without any moment.
"""

import casadi as ca

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import arguments
from turnbuckle.model.symbolic.composition import Call, Composition
from turnbuckle.model.symbolic.facets import Facet, FacetSweep
from turnbuckle.model.symbolic.function import (
    Input,
    ModelFunction,
    Output,
    Status,
    Verdict,
    carried,
    not_all_above,
    scalar_output,
    vector_output,
)
from turnbuckle.model.symbolic.scalar import Vector, largest, smallest, where
from turnbuckle.model.symbolic.sweep import Ports, Subset, Sweep
from turnbuckle.model.symbolic.wrench_set import FAR

#: A normal whose part along forces is shorter bounds moments only.
NO_FORCE = 1e-6
OUTSIDE = "the pose is outside the wrench-feasible workspace for zero wrench"


def isotropic_sweep(machine: Machine) -> Sweep:
    """The isotropic force of a structure matrix: over all facets the least distance from zero.

    With a normal m and its part m_F along forces, no force above (half - |centre|) / |m_F| is
    feasible in the direction of m_F without a moment.
    """
    low, high = machine.tension.min, machine.tension.max
    state = (scalar_output("margin", "N", ca.SX(FAR)), scalar_output("radius", "N", ca.SX(FAR)))

    def visit(facet: Facet, _: Subset, known: Ports) -> dict[str, Vector]:
        gap, slope = facet.gap(low, high), facet.slope(machine.space)
        margin, radius = (known[name].scalars()[0] for name in ("margin", "radius"))
        there = facet.exists()
        counts = ca.logic_and(there, slope > NO_FORCE)
        return {
            "margin": [where(there, ca.fmin(margin, gap), margin)],
            "radius": [where(counts, ca.fmin(radius, gap / slope), radius)],
        }

    def finish(known: Ports) -> tuple[tuple[Output, ...], tuple[Verdict, ...]]:
        margin, radius = (known[name].scalars()[0] for name in ("margin", "radius"))
        outside = ca.logic_not(margin >= 0)
        force = where(outside, 0, ca.fmax(radius, 0))
        return (scalar_output("force", "N", force),), (
            Verdict(outside, Status.INFEASIBLE, OUTSIDE),
        )

    sweep = FacetSweep(machine, arguments.structure(machine), (), state, visit, finish)
    return sweep.named("isotropic", "Isotropic force of a structure matrix", "its facets")


def balance_sweep(machine: Machine) -> Sweep:
    """Whether a structure matrix can hold the platform at zero wrench, as a number; that wrench."""
    low, high = machine.tension.min, machine.tension.max
    state = (scalar_output("margin", "N", ca.SX(FAR)),)

    def visit(facet: Facet, _: Subset, known: Ports) -> dict[str, Vector]:
        margin = known["margin"].scalars()[0]
        return {"margin": [where(facet.exists(), ca.fmin(margin, facet.gap(low, high)), margin)]}

    def finish(known: Ports) -> tuple[tuple[Output, ...], tuple[Verdict, ...]]:
        balanced = known["margin"].scalars()[0] >= 0
        results = (
            scalar_output("balanced", "1", where(balanced, 1, 0)),
            vector_output("wrench", "N", [ca.SX(0)] * machine.dof),
        )
        return results, (Verdict(ca.logic_not(balanced), Status.INFEASIBLE, OUTSIDE),)

    sweep = FacetSweep(machine, arguments.structure(machine), (), state, visit, finish)
    return sweep.named("balance", "Whether the cables hold the platform at rest", "their facets")


def pose_inputs(machine: Machine) -> tuple[Input, ...]:
    """Pose and rail coordinates."""
    return arguments.pose(machine), arguments.rails(machine)


def isotropic_force(machine: Machine) -> Composition:
    """True isotropic force."""
    moment = " without any moment" if machine.is_rigid else ""
    return Composition(
        "isotropic_force",
        f"Isotropic force I_F: the largest force in every direction{moment}; 0 outside the"
        " workspace",
        "Yoon section III-A, exact by the facets of {S T}",
        pose_inputs(machine),
        (Call("structure_matrix"), Call(isotropic_sweep(machine))),
    )


def at_rest(machine: Machine) -> tuple[Input, Input]:
    """Whether the platform can rest, a number, and its tensions then: locals of a composition."""
    rest = vector_output("rest", "N", [ca.SX(0)] * len(machine.cables))
    balanced, solved = carried((scalar_output("balanced", "1", ca.SX(0)), rest))
    return balanced, solved


def resting(machine: Machine, last: ModelFunction) -> tuple[Call, ...]:
    """The calls that find the tensions of a pose at rest, and one that reads them."""
    results = {"tension": "rest", "delivered": "exerted", "kkt_residual": "residual"}
    return (
        Call("structure_matrix"),
        Call(balance_sweep(machine)),
        Call("least_norm_tension", results, given="balanced"),
        Call(last),
    )


def zero_wrench_tension(machine: Machine) -> Composition:
    """Least-norm tensions under zero wrench."""
    low = machine.tension.min
    balanced, rest = at_rest(machine)
    tension = [where(balanced.scalars()[0] > 0, value, low) for value in rest.scalars()]
    summary = "Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace"
    source = "Yoon eq. 12 with W = 0"
    results = (vector_output("tension", "N", tension, fallback=low),)
    last = ModelFunction("tension_at_rest", summary, source, (balanced, rest), results)
    calls = resting(machine, last)
    return Composition("zero_wrench_tension", summary, source, pose_inputs(machine), calls)


def tension_factor(machine: Machine) -> Composition:
    """Least over largest zero-wrench tension."""
    balanced, rest = at_rest(machine)
    holds = balanced.scalars()[0] > 0
    most = largest(rest.scalars())
    factor = where(holds, smallest(rest.scalars()) / most, 0)
    meaning = "T_min is 0, and so is every zero-wrench tension"
    slack = not_all_above([where(holds, most, 1)], 0, meaning)
    summary = "Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace"
    results = (scalar_output("factor", "1", factor),)
    inputs = (balanced, rest)
    last = ModelFunction("factor_at_rest", summary, "Yoon eq. 13", inputs, results, (slack,))
    calls = resting(machine, last)
    return Composition("tension_factor", summary, "Yoon eq. 13", pose_inputs(machine), calls)


def composites(machine: Machine) -> list[Composition]:
    """Everything this topic generates in more than two dimensions."""
    return [zero_wrench_tension(machine), tension_factor(machine), isotropic_force(machine)]
