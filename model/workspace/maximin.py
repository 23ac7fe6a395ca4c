"""Where the smallest of several functions is largest: linear programmes in a trust region."""

from collections.abc import Callable

import numpy as np
from scipy.optimize import linprog

from turnbuckle.model.workspace.rows import Array

MOST_MOVES = 60
GAIN = 1e-10  # a smaller growth, relative to the smallest function, is not worth a move


def climb(
    values: Callable[[Array], Array],
    slopes: Callable[[Array, Array], Array],
    start: Array,
    trust: float,
    low: Array | float = -np.inf,
    high: Array | float = np.inf,
) -> tuple[Array, Array]:
    """A point (m) near `start` with a largest smallest value, and the values (k) there.

    values(point) are k functions; slopes(point, values) their gradients (k, m), NaN where unknown.
    Every move is a linear programme with steps of at most `trust` along each axis, between low and
    high. Functions may have kinks: a move that does not help makes the next one shorter.
    """
    point, found = start, values(start)
    for _ in range(MOST_MOVES):
        smallest = float(np.min(found))
        least = np.maximum(-trust, low - point)
        most = np.minimum(trust, high - point)
        step, promised = _best_step(found, slopes(point, found), least, most)
        if promised - smallest <= GAIN * abs(smallest):
            break
        moved = values(point + step)
        if np.min(moved) > smallest:
            point, found = point + step, moved
        else:
            trust /= 4
    return point, found


def _best_step(values: Array, slopes: Array, least: Array, most: Array) -> tuple[Array, float]:
    """The step within its limits (m) with the largest smallest value to first order; that value."""
    known = np.all(np.isfinite(slopes), axis=-1)
    m = len(least)
    found = linprog(
        np.append(np.zeros(m), -1.0),
        A_ub=np.column_stack([-slopes[known], np.ones(np.sum(known))]),
        b_ub=values[known],
        bounds=[*zip(least, most, strict=True), (None, None)],
    )
    if found.x is None:
        return np.zeros(m), float(np.min(values))
    return np.asarray(found.x[:m], np.float64), float(found.x[m])
