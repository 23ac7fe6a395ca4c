"""The set of wrenches that bounded tensions can give: a zonotope, in the plane a polygon.

Its edges are parallel to the cables. structure (rows, d, n), wrench (rows, d) [N, N m]. Distances
between wrenches are those of (F, M / lever) [N], with the platform's lever; for points there are
forces only.
"""

from collections.abc import Callable
from math import comb
from typing import Any

import numpy as np
import numpy.typing as npt

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.arrays import ROWS_PER_CHUNK, Array, in_chunks, norm
from turnbuckle.model.reference.bounded import ROUNDINGS, closest_tension
from turnbuckle.model.reference.kinematics import moment_lever
from turnbuckle.model.reference.linear import complete_basis, factorise
from turnbuckle.model.reference.minors import none_yet, normal, with_vector
from turnbuckle.model.reference.planar import inner_products, minors

MOST_SIDES = 2**20  # in one chunk, each 16 bytes in long double


def slabs(machine: Machine, structure: Array) -> tuple[Array, Array, Array]:
    """The set of wrenches as slabs: normals p (..., k, d), middles and half widths (..., k) [N].

    W is feasible exactly when |p . W - middle| <= half width for every p. Forces and moments over
    the lever make p a unit vector: (p_F, lever p_M). The set's facets are normal to d - 1 cables;
    a set that has shrunk, because the cables do not span, also needs directions that fewer cables
    and what they all leave open determine. Such a row in the batch adds them to all rows.
    """
    normals, sides = facet_directions(machine, structure)
    lower, upper = np.asarray([machine.tension.min, machine.tension.max], structure.dtype)
    middle, reach = (upper + lower) / 2, (upper - lower) / 2
    half_width = reach * np.sum(np.abs(sides), axis=-1)
    return normals, middle * np.sum(sides, axis=-1), half_width


def facet_directions(machine: Machine, structure: Array) -> tuple[Array, Array]:
    """The slabs' normals p (..., k, d) and sides p . s_i (..., k, n), whatever the bounds are."""
    cables = _cables(machine, structure)
    normals, sides = _planar_normals(cables) if machine.dof == 2 else _normals(cables)
    return normals / moment_lever(machine, structure.dtype), sides


def contains(machine: Machine, structure: Array, wrench: Array) -> npt.NDArray[np.bool_]:
    """Whether the wrench is in the set or on its boundary; False where anything is NaN."""
    return np.asarray(margin(machine, structure, wrench) >= -_rounding(machine, structure, wrench))


def margin(machine: Machine, structure: Array, wrench: Array) -> Array:
    """Distance (rows) [N] of the wrench from the nearest facet's plane; negative outside the set.

    NaN where anything is NaN.
    """
    normals, middle, half_width = slabs(machine, structure)
    along = np.sum(normals * wrench[..., None, :], axis=-1)
    return np.asarray(np.min(half_width - np.abs(along - middle), axis=-1))


def by_slabs(
    machine: Machine,
    function: Callable[..., tuple[npt.NDArray[Any], ...]],
    structure: Array,
    *wrench: Array,
) -> tuple[npt.NDArray[Any], ...]:
    """Apply `function` to some rows at a time, so that the slabs of all fit into a few dozen MB.

    Rows whose set has shrunk go together, because all rows of a batch get their directions.
    """
    d, n = structure.shape[-2:]
    inputs = [(structure, 2), *((part, 1) for part in wrench)]
    at_once = int(max(1, min(ROWS_PER_CHUNK, MOST_SIDES // (n * comb(n, d - 1)))))
    apart = None if d == 2 else lambda s: _has_shrunk(_cables(machine, s))
    return in_chunks(function, *inputs, rows_per_chunk=at_once, apart=apart)


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
        share_slack = slack[..., 0] / _size(machine, wrench)
    largest = np.min(np.where(rate > slack, limit, 1), axis=-1)
    smallest = np.max(np.where(rate < -slack, limit, 0), axis=-1)
    beside = np.any((np.abs(rate) <= slack) & (support < -slack), axis=-1)
    hit = (np.maximum(smallest, 0) <= np.minimum(largest, 1) + share_slack) & ~beside
    return np.where(hit, np.clip(largest, 0, 1), np.asarray(np.nan, wrench.dtype))


def closest_wrench(machine: Machine, structure: Array, wrench: Array) -> Array:
    """The point of the set nearest to a wrench that is outside (rows, d)."""
    if machine.dof == 2:
        return _closest_on_edges(machine, structure, wrench)
    lever = moment_lever(machine, structure.dtype)
    bounds = machine.tension
    tension = closest_tension(structure / lever[:, None], wrench / lever, bounds.min, bounds.max)
    return np.asarray(np.sum(structure * tension[..., None, :], axis=-1))


def _planar_normals(cables: Array) -> tuple[Array, Array]:
    """Unit normals p (..., 2n, 2) and sides p . s_i (..., 2n, n): p normal to cable j, then along.

    Minors are exactly antisymmetric, so the side of a cable to its own normal is exactly zero.
    """
    length = norm(cables)[..., None]
    sides = np.concatenate([minors(cables) / length, inner_products(cables) / length], axis=-2)
    turned = np.stack([-cables[..., 1], cables[..., 0]], axis=-1)
    return np.concatenate([turned / length, cables / length], axis=-2), sides


def _normals(cables: Array) -> tuple[Array, Array]:
    """The same for d > 2, with p normal to d - 1 cables; see slabs."""
    d = cables.shape[-1]
    normals = _normals_to_cables(cables, d - 1, cables[..., :0, :])
    if np.any(_has_shrunk(cables)):
        basis = np.swapaxes(complete_basis(np.swapaxes(cables, -1, -2)), -1, -2)
        fewer = [_normals_to_cables(cables, k, basis[..., k + 1 :, :]) for k in range(d - 1)]
        normals = np.concatenate([normals, *fewer, basis], axis=-2)
    return normals, np.asarray(normals @ np.swapaxes(cables, -1, -2))


def _cables(machine: Machine, structure: Array) -> Array:
    """The columns of S (..., n, d), moments over the lever."""
    return np.asarray(np.swapaxes(structure, -1, -2) / moment_lever(machine, structure.dtype))


def _has_shrunk(cables: Array) -> npt.NDArray[np.bool_]:
    """Where the cables do not span, so that the set is flat."""
    flat = factorise(np.swapaxes(cables, -1, -2)).rank < cables.shape[-1]
    return np.asarray(flat & np.all(np.isfinite(cables), axis=(-2, -1)))


def _normals_to_cables(cables: Array, count: int, others: Array) -> Array:
    """Unit vectors (..., k, d) normal to `others` and to every choice of so many cables.

    Where these are not independent: any unit vector.
    """
    n = cables.shape[-2]
    columns = np.ascontiguousarray(np.moveaxis(cables, (-1, -2), (0, 1)))  # (d, n, ...)
    beside = np.ascontiguousarray(np.moveaxis(others, (-2, -1), (0, 1)))[:, :, None]
    minors = none_yet(columns[0, :1])
    for vector in beside:
        minors = with_vector(minors, vector)
    chosen: list[tuple[int, ...]] = [()]
    for _ in range(count):
        grown = [(k, i) for k, c in enumerate(chosen) for i in range(max(c, default=-1) + 1, n)]
        parents, added = np.array(grown).T
        minors = with_vector({r: minor[parents] for r, minor in minors.items()}, columns[:, added])
        chosen = [(*chosen[k], i) for k, i in grown]
    normals = np.moveaxis(normal(minors), (0, 1), (-1, -2))
    size = norm(normals)[..., None]
    first = np.zeros_like(normals)
    first[..., 0] = 1
    return np.divide(normals, size, out=first, where=size > 0)


def _closest_on_edges(machine: Machine, structure: Array, wrench: Array) -> Array:
    """The nearest of the projections on the edges of a polygon."""
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


def _size(machine: Machine, wrench: Array) -> Array:
    return norm(wrench / moment_lever(machine, wrench.dtype))


def _rounding(machine: Machine, structure: Array, wrench: Array) -> Array:
    """What rounding can add to a sum of wrenches [N]."""
    most = structure.shape[-1] * machine.tension.max + _size(machine, wrench)
    return np.asarray(ROUNDINGS * np.finfo(wrench.dtype).eps * most)
