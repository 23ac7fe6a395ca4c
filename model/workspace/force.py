"""How strong and how even a pose is: isotropic force, force along a direction, tension factor.

structure (..., d, n), rows in newtons; forces fill the first `space` entries of a wrench (all by
default), moments divided by the lever the rest. NaN in S gives NaN.
"""

from math import comb

import numpy as np
import numpy.typing as npt

from turnbuckle.model.workspace.facets import ROUNDINGS, Facets, over_facets, rounding
from turnbuckle.model.workspace.feasible import ball_reach
from turnbuckle.model.workspace.gaps import adjacent_gaps
from turnbuckle.model.workspace.least_norm import least_norm_tension
from turnbuckle.model.workspace.rows import Array


def isotropic_force(
    structure: npt.ArrayLike, lower: float, upper: float, space: int | None = None
) -> Array:
    """I_F (...) [N]: the largest r such that every force up to r, without a moment, is feasible.

    Over the facets with support h and normal (p_F, p_M): min h / |p_F|. 0 where the zero wrench
    is infeasible.
    """

    def largest_ball(facets: Facets, s: Array) -> Array:
        forces = facets.normals[..., :space]
        return _largest_share(
            facets.support(lower, upper), np.sqrt(np.sum(forces**2, axis=-1)), rounding(s, upper)
        )

    return over_facets(largest_ball, structure)


def served_share(
    structure: npt.ArrayLike,
    lower: float,
    upper: float,
    force: float,
    moment: float = 0.0,
    space: int | None = None,
) -> Array:
    """Largest share k (...) such that all forces up to k `force` with all moments up to k `moment`
    are feasible; both [N], see `feasible.ball_margin`. 0 where the zero wrench is infeasible.
    """
    size = max(force, moment)

    def largest_ball(facets: Facets, s: Array) -> Array:
        reach = ball_reach(facets, force / size, moment / size, space)
        return _largest_share(facets.support(lower, upper), reach, rounding(s, upper)) / size

    return over_facets(largest_ball, structure)


def isotropic_limits(
    structure: npt.ArrayLike, lower: float, upper: float, space: int | None = None
) -> Array:
    """What every facet by itself allows of I_F (..., f) [N], both sides; f = 2 C(n, d-1).

    Negative where the zero wrench is beyond the facet. Piecewise smooth in the pose and the bases,
    as their smallest is not: for optimisation. Neither way is a limit larger than what all cables
    together could pull.
    """
    *_, d, n = np.shape(structure)
    normals = comb(n, d - 1)  # the directions that only a flat set has come after these

    def limits(facets: Facets, s: Array) -> Array:
        forces = facets.normals[:, :normals, :space]
        rate = np.sqrt(np.sum(forces**2, axis=-1))
        near = rate > ROUNDINGS * np.finfo(np.float64).eps
        slack = rounding(s, upper)[:, None]
        found = []
        for support in facets.supports(lower, upper):
            side = support[:, :normals]
            far = np.where(side < -slack, -np.inf, np.inf)
            found.append(np.divide(side, rate, out=far, where=near))
        return np.asarray(np.clip(np.concatenate(found, axis=-1), -n * upper, n * upper))

    return over_facets(limits, structure)


def force_along(
    structure: npt.ArrayLike, lower: float, upper: float, direction: npt.ArrayLike
) -> Array:
    """Largest k (...) such that k' w is feasible for all 0 <= k' <= k; w (..., d) any wrench.

    In newtons where w is a unit force. 0 where the zero wrench is infeasible.
    """

    def ray(facets: Facets, s: Array, w: Array) -> Array:
        along = np.einsum("rfd,rd->rf", facets.normals, w)
        ahead, behind = facets.supports(lower, upper)
        reach = np.where(along > 0, ahead, behind)
        worst_at_zero = np.minimum(ahead, behind)
        # a facet that the ray leaves parallel, or backwards, still has to hold the zero wrench
        reach = np.where(worst_at_zero < -rounding(s, upper)[:, None], worst_at_zero, reach)
        return _largest_share(reach, np.abs(along), rounding(s, upper))

    return over_facets(ray, structure, (direction, 1))


def _largest_share(support: Array, rate: Array, slack: Array) -> Array:
    """Largest k (rows) with k rate <= support for all facets (rows, f); 0 where even 0 is not.

    A rate of nothing but rounding sets no limit: in a flat set of wrenches, the directions that it
    does not extend in are normal to everything it contains.
    """
    still = rate <= ROUNDINGS * np.finfo(np.float64).eps
    limit = np.divide(support, rate, out=np.full_like(support, np.inf), where=~still)
    limit = np.where(support < -slack[:, None], 0, limit)
    return np.asarray(np.maximum(np.min(limit, axis=-1), 0))


def zero_wrench_tension(structure: npt.ArrayLike, lower: float, upper: float) -> Array:
    """T0 (..., n) [N]: bounded tensions of least norm that give no wrench (Yoon eq. 12), or NaN."""
    return least_norm_tension(structure, np.zeros(np.shape(structure)[-2]), lower, upper)


def tension_factor(structure: npt.ArrayLike, lower: float, upper: float) -> Array:
    """TF = min T0 / max T0 (...), from lower / upper to 1 (Yoon eq. 13).

    NaN where the zero wrench is infeasible; and everywhere for lower = 0, as T0 is then 0.
    """
    tension = zero_wrench_tension(structure, lower, upper)
    least, most = np.min(tension, axis=-1), np.max(tension, axis=-1)
    return np.asarray(np.divide(least, most, out=np.full_like(most, np.nan), where=most > 0))


def isotropic_force_eq17(structure: npt.ArrayLike, lower: float, upper: float) -> Array:
    """I_F (...) [N] as in Yoon eq. 17, for planar points with any n: a lower bound of the true one.

    Two neighbours around the platform with what is left of their tensions, t = upper - T0, span a
    parallelogram; the largest disc in all of them. Two cables more than 90 degrees apart bound it
    by the parallelogram's height, others by the shorter t. NaN where T0 is.
    """
    s = np.asarray(structure, np.float64)
    left = upper - zero_wrench_tension(s, lower, upper)
    order, gap = adjacent_gaps(s)
    left = np.take_along_axis(left, order, axis=-1)
    shorter = np.minimum(left, np.roll(left, -1, axis=-1))
    height = shorter * np.maximum(np.sin(gap), 0)
    return np.asarray(np.min(np.where(gap > np.pi / 2, height, shorter), axis=-1))
