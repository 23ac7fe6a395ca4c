"""The set of wrenches that bounded tensions can give: a zonotope, in the plane a polygon.

Its edges are parallel to the cables. structure (rows, 2, n), wrench (rows, 2) [N].
"""

import numpy as np
import numpy.typing as npt

from model.machine import Machine
from model.reference.active_sets import ROUNDINGS
from model.reference.arrays import Array, norm
from model.reference.planar import inner_products, minors


def slabs(machine: Machine, structure: Array) -> tuple[Array, Array, Array]:
    """The set of wrenches as slabs: unit normals p (..., 2n, 2), middles and half widths [N].

    W is feasible exactly when |p . W - middle| <= half width for every p. The polygon's facets are
    normal to a cable; a polygon that has shrunk to a segment, all cables parallel, also needs the
    directions of the cables.
    """
    lower, upper = np.asarray([machine.tension.min, machine.tension.max], structure.dtype)
    middle, reach = (upper + lower) / 2, (upper - lower) / 2
    cables = np.swapaxes(structure, -1, -2)
    length = norm(cables)[..., None]
    # sides[j, i] = p . s_i, first for p normal to cable j, then for p along it
    sides = np.concatenate([minors(cables) / length, inner_products(cables) / length], axis=-2)
    turned = np.stack([-cables[..., 1], cables[..., 0]], axis=-1)
    normals = np.concatenate([turned / length, cables / length], axis=-2)
    return normals, middle * np.sum(sides, axis=-1), reach * np.sum(np.abs(sides), axis=-1)


def contains(machine: Machine, structure: Array, wrench: Array) -> npt.NDArray[np.bool_]:
    """Whether the wrench is in the set or on its boundary; False where anything is NaN."""
    normals, middle, half_width = slabs(machine, structure)
    along = np.sum(normals * wrench[..., None, :], axis=-1)
    slack = _rounding(machine, structure, wrench)[..., None]
    return np.asarray(np.all(np.abs(along - middle) <= half_width + slack, axis=-1))


def largest_share(machine: Machine, structure: Array, wrench: Array) -> Array:
    """Largest s in [0, 1] with s W feasible; NaN where no such s exists.

    Every side of every slab gives s (p . W) <= h: an upper limit, a lower limit, or a yes or no.
    """
    normals, middle, half_width = slabs(machine, structure)
    along = np.sum(normals * wrench[..., None, :], axis=-1)
    rate = np.concatenate([along, -along], axis=-1)
    support = np.concatenate([half_width + middle, half_width - middle], axis=-1)
    slack = _rounding(machine, structure, wrench)[..., None]
    with np.errstate(divide="ignore", invalid="ignore"):
        limit = support / rate
        share_slack = slack[..., 0] / norm(wrench)
    largest = np.min(np.where(rate > slack, limit, 1), axis=-1)
    smallest = np.max(np.where(rate < -slack, limit, 0), axis=-1)
    beside = np.any((np.abs(rate) <= slack) & (support < -slack), axis=-1)
    hit = (np.maximum(smallest, 0) <= np.minimum(largest, 1) + share_slack) & ~beside
    return np.where(hit, np.clip(largest, 0, 1), np.asarray(np.nan, wrench.dtype))


def closest_wrench(machine: Machine, structure: Array, wrench: Array) -> Array:
    """The point of the boundary nearest to the wrench: the nearest of its projections on edges."""
    begin, end = _edges(machine, structure)
    edge = end - begin
    reach = wrench[:, None, :] - begin
    square = np.sum(edge**2, axis=-1)
    share = np.clip(np.sum(reach * edge, axis=-1) / square, 0, 1)
    points = begin + share[..., None] * edge
    distance = norm(wrench[:, None, :] - points)
    nearest = np.argmin(distance, axis=-1)
    return np.asarray(np.take_along_axis(points, nearest[:, None, None], axis=1)[:, 0, :])


def _edges(machine: Machine, structure: Array) -> tuple[Array, Array]:
    """Ends (rows, 2n, 2) of the edges of the set of wrenches: edge j runs along cable j.

    Cables on the outer side are at T_max, on the inner at T_min; those exactly parallel to
    cable j go from one bound to the other together with it.
    """
    lower, upper = np.asarray([machine.tension.min, machine.tension.max], structure.dtype)
    cables = np.swapaxes(structure, -1, -2)
    sides = minors(cables)
    along = inner_products(cables)
    ends = []
    for side in (sides, -sides):
        low = np.where(along > 0, lower, upper)
        fixed = np.where(side > 0, upper, lower)
        parallel = side == 0
        for edge_end in (low, np.where(along > 0, upper, lower)):
            tension = np.where(parallel, edge_end, fixed)
            ends.append(np.sum(tension[..., None] * cables[..., None, :, :], axis=-2))
    begin = np.concatenate(ends[0::2], axis=-2)
    end = np.concatenate(ends[1::2], axis=-2)
    return begin, end


def _rounding(machine: Machine, structure: Array, wrench: Array) -> Array:
    """What rounding can add to a sum of wrenches [N]."""
    most = structure.shape[-1] * machine.tension.max + norm(wrench)
    return np.asarray(ROUNDINGS * np.finfo(wrench.dtype).eps * most)
