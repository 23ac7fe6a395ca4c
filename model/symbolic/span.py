"""One cable between its anchor and its base: straight, or over a pulley of some radius."""

import math
from collections.abc import Callable
from dataclasses import dataclass

from turnbuckle.model.pulley import Pulley
from turnbuckle.model.symbolic.angle import arc_tangent
from turnbuckle.model.symbolic.linear import add_scaled, cross, dot, norm, subtract
from turnbuckle.model.symbolic.scalar import Scalar, Vector, sqrt

#: (sine, cosine) of a unit vector -> its angle from -pi to pi [rad].
ArcTangent = Callable[[Scalar, Scalar], Scalar]


@dataclass(frozen=True)
class Span:
    """The straight part of a cable, and what it adds up to.

    vector [m]: from the anchor to where the cable meets the pulley; ray: its unit vector; free [m]:
    its length; length [m]: with what lies on the pulley; clearances [m]: distances without which
    the cable has no direction.
    """

    vector: Vector
    ray: Vector
    free: Scalar
    length: Scalar
    clearances: tuple[Scalar, ...]


def span(
    pulley: Pulley | None,
    anchor: Vector,
    base: Vector,
    angle_of: ArcTangent = arc_tangent,
) -> Span:
    """The cable from an anchor to a base, both in the fixed frame [m].

    `angle_of` measures the angle of wrap: derivatives want one whose own derivative is known.
    """
    if pulley is None:
        return straight(subtract(base, anchor))
    over = planar if len(anchor) == 2 else spatial
    return over(pulley, subtract(anchor, base), angle_of)


def straight(vector: Vector) -> Span:
    """A cable through a point (Yoon eq. 1)."""
    free = norm(vector)
    return Span(vector, [entry / free for entry in vector], free, free, (free,))


def planar(pulley: Pulley, reach: Vector, angle_of: ArcTangent) -> Span:
    """Over a pulley whose centre is the base; `reach` goes from there to the anchor [m].

    The cable leaves where the normal n of the pulley turns into the tangent -ray = winds i n. Its
    angle of wrap, from `contact` to n, lies in [-pi/2, 3 pi/2].
    """
    radius, sense = pulley.radius, pulley.winds
    square = dot(reach, reach)
    free = sqrt(square - radius * radius)
    x, y = reach
    normal = [
        (x * radius + y * free * sense) / square,
        (y * radius - x * free * sense) / square,
    ]
    ray = [normal[1] * sense, -normal[0] * sense]
    quarter = [-pulley.contact[1] * sense, pulley.contact[0] * sense]
    turned = sense * angle_of(cross(quarter, normal), dot(quarter, normal))
    wrapped = radius * (math.pi / 2 + turned)
    vector = subtract([radius * entry for entry in normal], reach)
    return Span(vector, ray, free, free + wrapped, (free,))


def spatial(pulley: Pulley, reach: Vector, angle_of: ArcTangent) -> Span:
    """Over a pulley that swivels about `axis`, along which the cable runs into the base.

    `reach` goes from the base to the anchor [m]. In the plane of the axis k and the swivel arm e,
    the cable leaves along t = e sin a + k cos a, where a in [-pi/2, 3 pi/2] is its angle of wrap.
    """
    radius, axis = pulley.radius, pulley.axis
    along = dot(reach, axis)
    arm = add_scaled(reach, -along, axis)
    swivel = norm(arm)
    outward = [entry / swivel for entry in arm]
    across = swivel - radius
    square = across * across + along * along
    free = sqrt(square - radius * radius)
    sine = (free * across + radius * along) / square
    cosine = (free * along - radius * across) / square
    ray = [-sine * e - cosine * k for e, k in zip(outward, axis, strict=True)]
    wrapped = radius * (math.pi / 2 + angle_of(-cosine, sine))
    vector = [free * entry for entry in ray]
    return Span(vector, ray, free, free + wrapped, (free, swivel))
