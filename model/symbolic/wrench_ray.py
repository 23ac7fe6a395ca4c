"""The wrench that is served where the wanted one is infeasible: a fraction of it, in any dimension.

In the plane all facets are written out (`tension.served_wrench_function`); elsewhere a sweep visits
them, and the closest wrench stands in where the ray from zero misses the feasible ones.
"""

import casadi as ca

from model.machine import Machine
from model.symbolic import arguments
from model.symbolic.composition import Call, Composition
from model.symbolic.facets import Facet, FacetSweep
from model.symbolic.function import (
    EPSILON,
    Input,
    ModelFunction,
    Output,
    Status,
    Verdict,
    carried,
    scalar_output,
    vector_output,
)
from model.symbolic.linear import dot
from model.symbolic.scalar import Scalar, Vector, total, where
from model.symbolic.sweep import Ports, Subset, Sweep
from model.symbolic.tension import INWARDS, OFF_BORDER
from model.symbolic.wrench_norm import weighed
from model.symbolic.wrench_set import FAR, RAY_SLACK

SOURCE = "facets of the zonotope {S T}"


def ray_sweep(machine: Machine, structure: Input, wrench: Input) -> Sweep:
    """How far the ray from zero to a wrench runs through the feasible ones."""
    asked = weighed(machine, wrench.scalars())
    low, high = machine.tension.min, machine.tension.max
    state = (
        vector_output("asked", "N", asked),
        scalar_output("inside", "1", ca.SX(1)),
        scalar_output("largest", "1", ca.SX(1)),
        scalar_output("first", "1", ca.SX(0)),
        scalar_output("last", "1", ca.SX(1)),
    )

    def visit(facet: Facet, _: Subset, known: Ports) -> dict[str, Vector]:
        there = facet.exists()
        centre, half = facet.slab(low, high)
        height = dot(facet.normal, known["asked"].scalars())
        slack = RAY_SLACK * EPSILON * high
        begin, end, top = ray_within(height, centre, half, slack)
        beyond = ca.logic_and(there, ca.fabs(height - centre) > half)
        before = {name: known[name].scalars()[0] for name in ("inside", "largest", "first", "last")}
        return {
            "inside": [where(beyond, 0, before["inside"])],
            "largest": [where(there, ca.fmin(before["largest"], top), before["largest"])],
            "first": [where(there, ca.fmax(before["first"], begin), before["first"])],
            "last": [where(there, ca.fmin(before["last"], end), before["last"])],
        }

    def finish(known: Ports) -> tuple[tuple[Output, ...], tuple[Verdict, ...]]:
        inside, top, first, last = (
            known[name].scalars()[0] for name in ("inside", "largest", "first", "last")
        )
        # a feasible wrench is no reason to look for the closest one
        missed = ca.logic_and(inside <= 0, first > last)
        return ray_outputs(inside, ca.fmax(top, 0), where(missed, 1, 0)), ()

    sweep = FacetSweep(machine, structure, (wrench,), state, visit, finish)
    return sweep.named("wrench_ray", "How far the ray to a wrench is feasible", SOURCE)


def ray_outputs(feasible: Scalar, fraction: Scalar, missed: Scalar) -> tuple[Output, ...]:
    """Whether the wrench is feasible, which fraction of it is, whether none is: numbers."""
    return (
        scalar_output("feasible", "1", feasible),
        scalar_output("fraction", "1", fraction),
        scalar_output("missed", "1", missed),
    )


def ray_within(
    height: Scalar, centre: Scalar, half: Scalar, slack: Scalar
) -> tuple[Scalar, Scalar, Scalar]:
    """Where the ray s W, W of a height along a normal, runs between a pair of facets.

    Returns the least and largest s, with the facets further out by a slack, and the largest s
    without. A ray along the facets is between them everywhere or nowhere.
    """
    crosses = ca.fabs(height) > 0
    inverse = 1 / height
    sides = (centre - half - slack) * inverse, (centre + half + slack) * inverse
    beside = ca.fabs(centre) > half + slack
    top = (centre + ca.copysign(half, height)) * inverse
    return (
        where(crosses, ca.fmin(*sides), where(beside, FAR, 0)),
        where(crosses, ca.fmax(*sides), 1),
        where(crosses, top, 1),
    )


def served_function(machine: Machine, structure: Input, wrench: Input) -> ModelFunction:
    """What is served, from what the ray tells and, where it tells nothing, the closest wrench."""
    nothing = [ca.SX(0)] * machine.dof
    zeros = (vector_output("closest", "N", nothing), vector_output("closer", "N", nothing))
    told = carried((*ray_outputs(*nothing[:1] * 3), *zeros))
    feasible, fraction, missed = (port.scalars()[0] for port in told[:3])
    closest, closer = (port.scalars() for port in told[3:])
    mean = (machine.tension.min + machine.tension.max) / 2
    middle = [mean * total(row) for row in structure.rows()]
    scaled = [fraction * entry for entry in wrench.scalars()]
    border = moved(scaled, OFF_BORDER * EPSILON, middle)
    served = chosen(feasible > 0, wrench.scalars(), chosen(missed > 0, closest, border))
    inner = chosen(missed > 0, closer, moved(served, ca.SX(INWARDS), middle))
    return ModelFunction(
        "served_fraction",
        "The fraction that is served, off the border",
        SOURCE,
        (structure, wrench, *told),
        (vector_output("served", "N", served), vector_output("inner", "N", inner)),
        (Verdict(feasible <= 0, Status.INFEASIBLE, "no admissible tension exerts it"),),
    )


def chosen(condition: Scalar, yes: Vector, no: Vector) -> Vector:
    """One vector or the other."""
    return [where(condition, a, b) for a, b in zip(yes, no, strict=True)]


def moved(start: Vector, part: Scalar, end: Vector) -> Vector:
    """The point that is a part of the way from start to end."""
    return [a + part * (b - a) for a, b in zip(start, end, strict=True)]


def served_wrench_scale(machine: Machine) -> Composition:
    """The policy `scale` for d > 2; it calls the policy `closest` where no fraction is feasible."""
    structure, wrench = arguments.structure(machine), arguments.wrench(machine)
    closest = Call("served_wrench_closest", {"served": "closest", "inner": "closer"}, "missed")
    return Composition(
        "served_wrench_scale",
        "The wrench that is served: an infeasible one keeps its direction and is scaled down to the"
        " largest feasible fraction",
        SOURCE,
        (structure, wrench),
        (
            Call(ray_sweep(machine, structure, wrench)),
            closest,
            Call(served_function(machine, structure, wrench)),
        ),
    )
