"""How far the ray from zero to a wrench runs through the feasible ones, in any dimension.

In the plane all facets are written out, see wrench_set; elsewhere a sweep visits them.
"""

import casadi as ca

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.facets import Facet, FacetSweep
from turnbuckle.model.symbolic.function import (
    EPSILON,
    Input,
    Output,
    Verdict,
    scalar_output,
    vector_output,
)
from turnbuckle.model.symbolic.linear import dot
from turnbuckle.model.symbolic.scalar import Scalar, Vector, where
from turnbuckle.model.symbolic.sweep import Ports, Subset, Sweep
from turnbuckle.model.symbolic.wrench_norm import weighed
from turnbuckle.model.symbolic.wrench_set import FAR, RAY_SLACK


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
    return sweep.named("wrench_ray", "How far the ray to a wrench is feasible", "facets of {S T}")


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
    without. A ray that runs along the facets up to the slack is between them everywhere or nowhere.
    """
    crosses = ca.fabs(height) > slack
    inverse = 1 / height
    sides = (centre - half - slack) * inverse, (centre + half + slack) * inverse
    beside = ca.fabs(centre) > half + slack
    top = (centre + ca.copysign(half, height)) * inverse
    return (
        where(crosses, ca.fmin(*sides), where(beside, FAR, 0)),
        where(crosses, ca.fmax(*sides), 1),
        where(crosses, top, 1),
    )
