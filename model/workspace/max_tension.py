"""The largest tension that a force of a given size needs, whatever its direction (Brau section 3).

`needed_tension` is exact, for any bounds. The others are Brau's, for T_min = 0 and inside the
theoretical workspace, with what the published ones get wrong put right or named. structure
(..., d, n), rows in newtons, moments divided by the lever.
"""

from itertools import combinations

import numpy as np
import numpy.typing as npt

from turnbuckle.model.workspace.facets import ROUNDINGS, Facets, over_facets, rounding
from turnbuckle.model.workspace.feasible import ball_reach
from turnbuckle.model.workspace.gaps import adjacent_gaps
from turnbuckle.model.workspace.rows import Array


def needed_tension(
    structure: npt.ArrayLike,
    lower: float,
    force: float,
    moment: float = 0.0,
    space: int | None = None,
) -> Array:
    """Least upper bound T_max (...) [N] with which all forces and moments of the ball are feasible.

    `force` and `moment` [N] (divided by the lever), `space` as in `feasible.ball_margin`. For a
    fixed T_min every facet gives a limit in closed form. inf where no tension is enough.
    """

    def least_upper(facets: Facets, s: Array) -> Array:
        demand = ball_reach(facets, force, moment, space) + lower * facets.stronger
        noise = rounding(s, 1.0)[:, None]
        held = demand <= noise * lower + ROUNDINGS * np.finfo(np.float64).eps * (force + moment)
        slack = facets.weaker <= noise
        enough = np.where(held, lower, np.inf)
        limit = np.divide(demand, facets.weaker, out=enough, where=~slack)
        return np.asarray(np.maximum(np.max(limit, axis=-1), lower))

    return over_facets(least_upper, structure)


def max_tension_eq12(structure: npt.ArrayLike, force: float) -> Array:
    """Largest tension of every cable (..., n) [N], Brau eq. 12, with |det|: also eqs 14 and 18.

    d cables that contain cable i carry the force, the others nothing: t_i is at most the force
    times the norm of row i of their inverse. The largest over all choices; exact for n = d + 1.
    Beyond that it also counts choices nobody would make, and grows without limit where a choice is
    nearly singular. inf where no choice is regular.
    """
    s = np.asarray(structure, np.float64)
    d, n = s.shape[-2:]
    largest = np.zeros((*s.shape[:-2], n))
    used = np.zeros(largest.shape, np.bool_)
    for chosen in map(list, combinations(range(n), d)):
        reduced = s[..., chosen]
        regular = np.abs(np.linalg.det(reduced)) > rounding(reduced, 1.0)
        inverse = np.linalg.inv(np.where(regular[..., None, None], reduced, np.eye(d)))
        tension = force * np.sqrt(np.sum(inverse**2, axis=-1))
        greater = np.where(regular[..., None], tension, 0)
        largest[..., chosen] = np.maximum(largest[..., chosen], greater)
        used[..., chosen] |= regular[..., None]
    return np.where(used, largest, np.inf)


def max_tension_eq17(structure: npt.ArrayLike, force: float) -> Array:
    """Largest tension of every cable (..., n) [N] by Brau's rule for four cables, as printed.

    The second largest force / |sin theta_ij| over j. It is wrong away from the centre, where it
    overlooks the larger of two gaps: `max_tension_adjacent` is right.
    """
    s = np.asarray(structure, np.float64)
    x, y = s[..., 0, :], s[..., 1, :]
    sines = np.abs(x[..., :, None] * y[..., None, :] - y[..., :, None] * x[..., None, :])
    others = ~np.eye(s.shape[-1], dtype=np.bool_)
    with np.errstate(divide="ignore"):
        tension = np.where(others, force / sines, 0)
    return np.asarray(np.sort(tension, axis=-1)[..., -2])


def max_tension_adjacent(structure: npt.ArrayLike, force: float) -> Array:
    """Largest tension of every cable (..., n) [N] of a planar point: eqs 14 and 17 corrected.

    Only the neighbours around the platform share a force with a cable: across a gap theta it needs
    force / sin theta, or the force itself where theta is below 90 degrees. The largest over the
    cables is exact for three and four cables; five and more may do with less. inf where a gap is
    180 degrees or more.
    """
    s = np.asarray(structure, np.float64)
    order, gap = adjacent_gaps(s)
    across = force / np.sin(np.clip(gap, np.pi / 2, np.pi))
    tension = np.where(gap >= np.pi, np.inf, across)
    shared = np.maximum(tension, np.roll(tension, 1, axis=-1))
    result = np.empty(shared.shape)
    np.put_along_axis(result, order, shared, axis=-1)
    return result
