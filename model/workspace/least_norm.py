"""Tensions of least norm within bounds, min ||T||, S T = W (Yoon eq. 12), for whole batches.

The dual is to minimise a convex, piecewise quadratic function of d unknowns l, whose gradient is
S clip(S' l) - W. Newton's method with an exact line search ends after finitely many steps, because
there are finitely many pieces (Chen and Pinar 1998). A small multiple of |l - centre|^2 keeps every
step defined; the centre follows l until the multiple has no effect (proximal point method). Solving
once more for the cables between their bounds leaves rounding only.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from turnbuckle.model.workspace.facets import ROUNDINGS, rounding
from turnbuckle.model.workspace.feasible import feasible, wrench_margin
from turnbuckle.model.workspace.rows import Array, in_chunks

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
    possible = feasible(margin, s, upper, np.max(np.abs(w), axis=-1))

    def solve(s: Array, w: Array, possible: Array) -> Array:
        tension = np.full((len(s), n), np.nan)
        rows = possible != 0
        if np.any(rows):
            problems = _Problems(s[rows], w[rows], lower, upper)
            tension[rows] = _finished(problems, _dual_newton(problems))
        return tension

    return in_chunks(solve, 4 * n * n, (s, 2), (w, 1), (possible, 0))


class _Problems(NamedTuple):
    """S (rows, d, n), W (rows, d) and the bounds."""

    s: Array
    w: Array
    lower: float
    upper: float

    def only(self, rows: npt.NDArray[np.intp]) -> "_Problems":
        return self._replace(s=self.s[rows], w=self.w[rows])

    def along(self, dual: Array) -> Array:
        """S' l (rows, n), the tensions without bounds."""
        return np.asarray(np.einsum("rdn,rd->rn", self.s, dual))

    def tension(self, dual: Array) -> Array:
        return np.asarray(np.clip(self.along(dual), self.lower, self.upper))

    def error(self, tension: Array) -> Array:
        """S T - W (rows, d)."""
        return np.asarray(np.einsum("rdn,rn->rd", self.s, tension) - self.w)

    def rounding(self) -> Array:
        size = ROUNDINGS * np.finfo(np.float64).eps * np.max(np.abs(self.w), axis=-1)
        return np.asarray(rounding(self.s, self.upper) + size)


def _dual_newton(problems: _Problems) -> Array:
    """Tensions (rows, n) at the least value of the dual."""
    dual, centre = np.zeros(problems.w.shape), np.zeros(problems.w.shape)
    small = problems.rounding()
    going = np.arange(len(dual))
    for _ in range(MOST_STEPS):
        error = problems.only(going).error(problems.only(going).tension(dual[going]))
        unsolved = np.max(np.abs(error), axis=-1) > small[going]
        going, error = going[unsolved], error[unsolved]
        if not going.size:
            break
        slope = error + DAMPING * (dual[going] - centre[going])
        settled = np.max(np.abs(slope), axis=-1) <= small[going]
        centre[going[settled]] = dual[going[settled]]
        slope[settled] = error[settled]
        dual[going] += _newton_step(problems.only(going), dual[going], slope)
    return problems.tension(dual)


def _newton_step(problems: _Problems, dual: Array, slope: Array) -> Array:
    """Newton's step (rows, d), as long as it makes the dual smallest."""
    along = problems.along(dual)
    free = problems.s * ((along > problems.lower) & (along < problems.upper))[:, None, :]
    curvature = free @ np.swapaxes(free, -1, -2) + DAMPING * np.eye(dual.shape[-1])
    step = np.asarray(-np.linalg.solve(curvature, slope[..., None])[..., 0], np.float64)
    share = _line_search(problems, along, problems.along(step), step, slope)
    return np.asarray(share[:, None] * step)


def _line_search(
    problems: _Problems, along: Array, change: Array, step: Array, slope: Array
) -> Array:
    """Share of the step (rows) where the derivative along it, growing in pieces, is zero.

    It is step . slope at the start and changes with the tensions, whose bounds are the knots.
    """
    bounds = problems.lower, problems.upper
    rate = np.where(change == 0, np.inf, change)
    knots = [np.zeros((len(step), 1)), *((bound - along) / rate for bound in bounds)]
    at = np.maximum(np.concatenate(knots, axis=-1), 0)
    tension = np.clip(along[:, None] + at[..., None] * change[:, None], *bounds)
    gained = np.einsum("rkn,rn->rk", tension - tension[:, :1], change)
    damping = DAMPING * np.sum(step**2, axis=-1)
    start = np.sum(step * slope, axis=-1)
    return _root(at, start[:, None] + gained + damping[:, None] * at, damping)


def _root(at: Array, value: Array, growth: Array) -> Array:
    """Zero (rows) of a growing function that is linear between knots `at` (rows, k), not sorted.

    Beyond the last knot it grows with the slope `growth` (rows). 0 where no value is negative.
    """
    negative = value < 0
    before = np.max(np.where(negative, at, 0), axis=-1)
    after = np.min(np.where(negative, np.inf, at), axis=-1)
    below = np.max(np.where(negative, value, -np.inf), axis=-1)
    above = np.min(np.where(negative, np.inf, value), axis=-1)
    with np.errstate(invalid="ignore", divide="ignore"):
        inside = before - below * (after - before) / (above - below)
        beyond = before - below / growth
    root = np.where(np.isfinite(after), inside, beyond)
    return np.where(np.any(negative, axis=-1), root, 0)


def _finished(problems: _Problems, found: Array) -> Array:
    """The least-norm tensions of the cables found free; as found where those leave the bounds."""
    free = (found > problems.lower) & (found < problems.upper)
    held = np.where(free, 0, found)
    inverse = np.asarray(np.linalg.pinv(problems.s * free[:, None, :], rcond=DAMPING), np.float64)
    solved = held - np.einsum("rnd,rd->rn", inverse, problems.error(held))
    clipped = np.clip(solved, problems.lower, problems.upper)
    bounded = np.max(np.abs(solved - clipped), axis=-1) <= problems.rounding()
    error, was = (np.max(np.abs(problems.error(t)), axis=-1) for t in (clipped, found))
    tension = np.where((bounded & (error <= was))[:, None], clipped, found)
    wrong = np.max(np.abs(problems.error(tension)), axis=-1) > DAMPING * problems.upper
    return np.where(wrong[:, None], np.nan, tension)
