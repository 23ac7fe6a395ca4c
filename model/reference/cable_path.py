"""The way of a cable from its base to its anchor, over a pulley of some radius or none.

Every function takes the vectors D = a - b (..., space) [m] from the base point to the anchor point.
A pulley of radius r has the cable on its rim up to the tangent point q, over the wrap angle alpha;
the rest, of length l_f, is straight. Moving the anchor by da changes the length by -u . da, with u
the unit vector from the anchor to q: the rim unwinds like an involute.
"""

from typing import NamedTuple

import numpy as np

from turnbuckle.model.pulley import Pulley
from turnbuckle.model.reference.arrays import Array, norm, unit


class Path(NamedTuple):
    """vector q - a (..., space) [m] from the anchor to where the cable leaves; length (...) [m].

    NaN where the anchor is on the pulley or inside, or on the line about which it swivels.
    """

    vector: Array
    length: Array


def cable_path(span: Array, pulley: Pulley | None) -> Path:
    """The way over the pulley, or over a point where there is none; span D = a - b."""
    if pulley is None:
        return Path(-span, norm(span))
    return _planar_path(span, pulley) if span.shape[-1] == 2 else _spatial_path(span, pulley)


def _planar_path(span: Array, pulley: Pulley) -> Path:
    """b is the pulley's centre. D = r n + l_f t; t is n turned by a right angle as it winds."""
    winds = pulley.winds
    first = unit(np.asarray(pulley.contact, span.dtype))
    free, n = _tangent(span, pulley.radius, winds)
    t = winds * _turned_left(n)
    # the angle from the first contact, counted from a right angle on so that it starts at -pi/2
    middle = winds * _turned_left(first)
    side = middle[0] * n[..., 1] - middle[1] * n[..., 0]
    along = np.sum(middle * n, axis=-1)
    wrap = _right_angle(span.dtype) + winds * np.arctan2(side, along)
    return Path(-free[..., None] * t, free + pulley.radius * wrap)


def _spatial_path(span: Array, pulley: Pulley) -> Path:
    """The pulley swivels about the line through b along k, in which the cable comes.

    It turns to where the anchor is, e; in the plane of e and k its centre is r e from b, and the
    cable goes round it clockwise (k to e), from the normal -e.
    """
    k = unit(np.asarray(pulley.axis, span.dtype))
    height = np.sum(span * k, axis=-1)
    aside = span - height[..., None] * k
    e = unit(aside)
    from_centre = np.stack([np.sum(aside * e, axis=-1) - pulley.radius, height], axis=-1)
    free, n = _tangent(from_centre, pulley.radius, -1)
    t = -_turned_left(n)
    wrap = _right_angle(span.dtype) + np.arctan2(n[..., 0], n[..., 1])
    travel = t[..., :1] * e + t[..., 1:] * k
    return Path(-free[..., None] * travel, free + pulley.radius * wrap)


def _tangent(span: Array, radius: float, winds: int) -> tuple[Array, Array]:
    """l_f (...) and n (..., 2) with span = r n + l_f t, t = n turned left (winds 1) or right (-1).

    As complex numbers span = n (r + i winds l_f), whose two factors have the moduli 1 and |span|.
    """
    distance = norm(span)
    with np.errstate(invalid="ignore"):
        free = np.sqrt((distance - radius) * (distance + radius))
    # in place of zero: on the rim a cable has no straight part whose direction could be told
    free = np.where(free > 0, free, np.asarray(np.nan, span.dtype))
    turned = radius * span - (winds * free)[..., None] * _turned_left(span)
    return free, np.asarray(turned / (distance * distance)[..., None])


def _turned_left(vector: Array) -> Array:
    return np.stack([-vector[..., 1], vector[..., 0]], axis=-1)


def _right_angle(dtype: np.dtype[np.floating]) -> Array:
    return np.asarray(np.arccos(np.asarray(0, dtype)))
