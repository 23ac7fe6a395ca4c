"""Wrench-feasible workspace (Yoon eq. 11; Bosscher 2006) and theoretical workspace (Brau 2.2).

A margin [N] says how far every wrench of a demand is from the boundary of what bounded tensions
can give. Where it is negative, the demand sticks out of the worst facet by as much. Its sign is the
verdict; on the boundary it is rounding, and `feasible` counts the boundary in.

structure (..., d, n), rows in newtons (moments divided by the lever); forces fill the first `space`
entries of a wrench, moments the rest. NaN in S gives NaN margins and False verdicts.
"""

import numpy as np
import numpy.typing as npt

from turnbuckle.model.workspace.facets import ROUNDINGS, Facets, over_facets, rounding
from turnbuckle.model.workspace.rows import Array

Verdict = npt.NDArray[np.bool_]


def ball_margin(
    structure: npt.ArrayLike,
    lower: float,
    upper: float,
    force: float = 0.0,
    moment: float = 0.0,
    space: int | None = None,
) -> Array:
    """Margin (...) [N] of all forces up to `force` [N] together with all moments up to `moment`.

    `moment` [N] is divided by the lever like the rows of S. With neither: of the zero wrench.
    Exact: the ball reaches force |p_F| + moment |p_M| along a facet's normal p = (p_F, p_M).
    """

    def margin(facets: Facets, _: Array) -> Array:
        reach = ball_reach(facets, force, moment, space)
        return np.asarray(np.min(facets.support(lower, upper) - reach, axis=-1))

    return over_facets(margin, structure)


def polytope_margin(
    structure: npt.ArrayLike, lower: float, upper: float, vertices: npt.ArrayLike
) -> Array:
    """Margin (...) [N] of the wrench polytope with these vertices (v, d) [N], moments by lever."""
    corners = np.asarray(vertices, np.float64)

    def margin(facets: Facets, _: Array) -> Array:
        ahead, behind = facets.supports(lower, upper)
        margins = np.full(len(facets.normals), np.inf)
        for corner in corners:  # one at a time: memory does not grow with their number
            along = facets.normals @ corner
            own = np.min(np.minimum(ahead - along, behind + along), axis=-1)
            margins = np.minimum(margins, own)
        return margins

    return over_facets(margin, structure)


def wrench_margin(
    structure: npt.ArrayLike, lower: float, upper: float, wrench: npt.ArrayLike
) -> Array:
    """Margin (...) [N] of one wrench (..., d) [N] for every structure matrix."""

    def margin(facets: Facets, _: Array, w: Array) -> Array:
        ahead, behind = facets.supports(lower, upper)
        along = np.einsum("rfd,rd->rf", facets.normals, w)
        return np.asarray(np.min(np.minimum(ahead - along, behind + along), axis=-1))

    return over_facets(margin, structure, (wrench, 1))


def ball_reach(facets: Facets, force: float, moment: float, space: int | None) -> Array:
    """How far [N] the ball of forces and moments reaches along every normal (rows, f)."""
    forces, moments = facets.normals[..., :space], facets.normals[..., space:]
    reach = force * np.sqrt(np.sum(forces**2, axis=-1))
    if space is not None:
        reach = reach + moment * np.sqrt(np.sum(moments**2, axis=-1))
    return np.asarray(reach)


def feasible(
    margin: npt.ArrayLike, structure: npt.ArrayLike, upper: float, demand: npt.ArrayLike = 0.0
) -> Verdict:
    """Whether a margin (...) [N] says yes, boundary included up to rounding; False for NaN.

    `demand` (...) [N]: the largest wrench that was asked for, which is rounded as well.
    """
    slack = rounding(np.asarray(structure, np.float64), upper)
    slack = slack + ROUNDINGS * np.finfo(np.float64).eps * np.asarray(demand)
    return np.asarray(np.asarray(margin) >= -slack)


def wrench_closure(structure: npt.ArrayLike) -> Verdict:
    """Theoretical workspace W_th (...): tensions without an upper bound can give every wrench.

    Brau 2.2: S has rank d, and a self-stress that tightens all cables. Equivalent: zero is inside
    the set of wrenches of tensions from 0 to 1, so that cables pull to both sides of every facet.
    """
    s = np.asarray(structure, np.float64)
    weakest = over_facets(lambda facets, _: np.min(facets.weaker, axis=-1), s)
    return np.asarray(weakest > rounding(s, 1.0))


def smallest_singular_value(structure: npt.ArrayLike) -> Array:
    """Smallest singular value of S (...): 0 exactly in the singular set, where rank S < d.

    No unit, as the rows of S are all in newtons for a newton of tension. NaN for NaN.
    """
    s = np.asarray(structure, np.float64)
    known = np.all(np.isfinite(s), axis=(-2, -1))
    values = np.linalg.svd(np.where(known[..., None, None], s, 0.0), compute_uv=False)
    return np.where(known, values[..., -1], np.nan)


def singular(structure: npt.ArrayLike) -> Verdict:
    """Whether rank S < d, up to rounding (...): some wrench can be given by no tension at all."""
    s = np.asarray(structure, np.float64)
    return np.asarray(smallest_singular_value(s) <= rounding(s, 1.0))
