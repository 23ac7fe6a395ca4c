"""Where the bases go: Yoon section III-B, each cable square to its rail or along its heading."""

from dataclasses import dataclass

from turnbuckle.model.base import BaseMotion
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic import arguments, kinematics
from turnbuckle.model.symbolic.function import ModelFunction, vector_output
from turnbuckle.model.symbolic.linear import add_scaled, dot, subtract
from turnbuckle.model.symbolic.scalar import Vector, clamp, total

#: A plane seen along its heading is a line when the square of its area is below this.
EDGE_ON = 1e-12


@dataclass(frozen=True)
class Foot:
    """A coordinate that brings a base under its anchor: gauge . (anchor - start) / weight [m]."""

    gauge: Vector
    weight: float


def feet(motion: BaseMotion) -> list[Foot]:
    """How the coordinates of one base follow its anchor, in the order of its travel.

    Seen along the heading, the base comes as near to the anchor as it can. Where a plane base can
    come there in many ways, it rests on its first side, as on a rail.
    """
    seen = [across(motion, list(direction)) for _, direction in motion.travel]
    weights = [dot(e, e) if motion.heading else 1.0 for e in seen]
    if len(seen) < 2:
        return [Foot(e, weight) for e, weight in zip(seen, weights, strict=True)]
    first, second = seen
    skew = dot(first, second)
    area = dot(first, first) * dot(second, second) - skew * skew
    if len(motion.start) == 2 or area < EDGE_ON:
        return [Foot(first, weights[0]), Foot([0.0] * len(first), 1.0)]
    return [
        Foot(add_scaled([dot(second, second) * x for x in first], -skew, second), area),
        Foot(add_scaled([dot(first, first) * x for x in second], -skew, first), area),
    ]


def across(motion: BaseMotion, direction: Vector) -> Vector:
    """The part of a direction that is square to the heading; all of it without one."""
    if not motion.heading:
        return direction
    return add_scaled(direction, -dot(direction, motion.heading), motion.heading)


def base_targets_function(machine: Machine) -> ModelFunction:
    """Where the bases go so that each cable is perpendicular to its rail."""
    pose = arguments.pose(machine)
    reached: list[Vector] = [[] for _ in machine.rails]
    weights: list[list[float]] = [[] for _ in machine.rails]
    anchors = kinematics.anchors(machine, pose.scalars())
    for motion, anchor in zip(machine.base_motions, anchors, strict=True):
        arm = subtract(anchor, list(motion.start))
        for (number, _), foot in zip(motion.travel, feet(motion), strict=True):
            reached[number].append(dot(arm, foot.gauge))
            weights[number].append(foot.weight)
    targets = [
        clamp(total(found) / sum(weight), 0, rail.length)
        for found, weight, rail in zip(reached, weights, machine.rails, strict=True)
    ]
    target = "anchor" if machine.is_rigid else "pose"
    return ModelFunction(
        "base_targets",
        f"Rail coordinates of the orthogonal configuration: the foot of the {target} on each rail",
        "Yoon section III-B",
        (pose,),
        (vector_output("target", "m", targets),),
    )
