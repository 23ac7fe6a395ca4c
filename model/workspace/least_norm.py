"""Tensions of least norm within bounds, min ||T||, S T = W (Yoon eq. 12), for whole batches.

The dual is to minimise a convex, piecewise quadratic function of d unknowns l, whose gradient is
S clip(S' l) - W. Newton's method with an exact line search ends after finitely many steps, because
there are finitely many pieces (Chen and Pinar 1998). A small multiple of |l - centre|^2 keeps every
step defined; the centre follows l until the multiple has no effect (proximal point method). Solving
once more for the cables between their bounds leaves rounding only.
"""

import numpy as np
import numpy.typing as npt

from model.workspace.facets import ROUNDINGS, rounding
from model.workspace.feasible import feasible, wrench_margin
from model.workspace.rows import Array, in_chunks

DAMPING = 1e-8  # of the share of one cable in S S', which is about 1
MOST_STEPS = 60  # 20 are rarely passed with six degrees of freedom and eight cables


def least_norm_tension(
    structure: npt.ArrayLike, wrench: npt.ArrayLike, lower: float, upper: float
) -> Array:
    """Bounded tensions of least norm (..., n) [N] that give the wrenches (..., d) [N].

    NaN where no bounded tensions do. So it is too for a few wrenches on the very boundary of the
    feasible ones, where rounding decides whether there are any.
    """
    s, w = np.asarray(structure, np.float64), np.asarray(wrench, np.float64)
    n = s.shape[-1]
    margin = wrench_margin(s, lower, upper, w)
    possible = feasible(margin, s, upper, float(np.max(np.abs(w), initial=0)))

    def solve(s: Array, w: Array, possible: Array) -> Array:
        tension = np.full((len(s), n), np.nan)
        rows = possible != 0
        if np.any(rows):
            found = _dual_newton(s[rows], w[rows], lower, upper)
            tension[rows] = _finished(s[rows], w[rows], lower, upper, found)
        return tension

    return in_chunks(solve, 4 * n * n, (s, 2), (w, 1), (possible, 0))


def _dual_newton(s: Array, w: Array, lower: float, upper: float) -> Array:
    """Tensions (rows, n) at the least value of the dual."""
    dual, centre = np.zeros(w.shape), np.zeros(w.shape)
    small = rounding(s, upper) + ROUNDINGS * np.finfo(np.float64).eps * np.max(np.abs(w), axis=-1)
    going = np.arange(len(s))
    for _ in range(MOST_STEPS):
        error = _given(s[going], np.clip(_along(s[going], dual[going]), lower, upper)) - w[going]
        unsolved = np.max(np.abs(error), axis=-1) > small[going]
        going, error = going[unsolved], error[unsolved]
        if not going.size:
            break
        slope = error + DAMPING * (dual[going] - centre[going])
        settled = np.max(np.abs(slope), axis=-1) <= small[going]
        centre[going[settled]] = dual[going[settled]]
        slope[settled] = error[settled]
        step = _newton_step(s[going], dual[going], slope, lower, upper)
        dual[going] += (
            _line_search(s[going], dual[going], step, slope, lower, upper)[:, None] * step
        )
    return np.asarray(np.clip(_along(s, dual), lower, upper))


def _along(s: Array, dual: Array) -> Array:
    return np.asarray(np.einsum("rdn,rd->rn", s, dual))


def _given(s: Array, tension: Array) -> Array:
    return np.asarray(np.einsum("rdn,rn->rd", s, tension))


def _newton_step(s: Array, dual: Array, slope: Array, lower: float, upper: float) -> Array:
    along = _along(s, dual)
    free = s * ((along > lower) & (along < upper))[:, None, :]
    curvature = free @ np.swapaxes(s, -1, -2) + DAMPING * np.eye(s.shape[-2])
    return np.asarray(-np.linalg.solve(curvature, slope[..., None])[..., 0])


def _line_search(
    s: Array, dual: Array, step: Array, slope: Array, lower: float, upper: float
) -> Array:
    """Where the derivative along the step (rows), piecewise linear and growing, is zero.

    It is known to be step . slope at the start; the rest follows from the tensions' change.
    """
    along, change = _along(s, dual), _along(s, step)
    still = change == 0
    knots = [(bound - along) / np.where(still, np.inf, change) for bound in (lower, upper)]
    at = np.maximum(np.concatenate([np.zeros((len(s), 1)), *knots], axis=-1), 0)
    tension = np.clip(along[:, None] + at[..., None] * change[:, None], lower, upper)
    stiffness = DAMPING * np.sum(step**2, axis=-1)
    gained = np.einsum("rkn,rn->rk", tension - tension[:, :1], change)
    derivative = np.sum(step * slope, axis=-1)[:, None] + gained + stiffness[:, None] * at
    falling = derivative < 0
    before = np.max(np.where(falling, at, 0), axis=-1)
    after = np.min(np.where(falling, np.inf, at), axis=-1)
    below = np.max(np.where(falling, derivative, -np.inf), axis=-1)
    above = np.min(np.where(falling, np.inf, derivative), axis=-1)
    with np.errstate(invalid="ignore", divide="ignore"):
        inside = before - below * (after - before) / (above - below)
        beyond = before - below / stiffness
    share = np.where(np.isfinite(after), inside, beyond)
    return np.where(np.any(falling, axis=-1), share, 0)


def _finished(s: Array, w: Array, lower: float, upper: float, found: Array) -> Array:
    """The least-norm tensions of the cables found free; as found where those leave the bounds."""
    free = (found > lower) & (found < upper)
    held = np.where(free, 0, found)
    inverse = np.asarray(np.linalg.pinv(s * free[:, None, :], rcond=DAMPING), np.float64)
    solved = held + _given(inverse, w - _given(s, held))
    small = rounding(s, upper)[:, None]
    bounded = np.all((solved >= lower - small) & (solved <= upper + small), axis=-1)
    better = bounded & (_error(s, w, solved) <= _error(s, w, found))
    tension = np.where(better[:, None], np.clip(solved, lower, upper), found)
    true = _error(s, w, tension) <= DAMPING * upper
    return np.where(true[:, None], tension, np.nan)


def _error(s: Array, w: Array, tension: Array) -> Array:
    return np.asarray(np.max(np.abs(_given(s, tension) - w), axis=-1))
