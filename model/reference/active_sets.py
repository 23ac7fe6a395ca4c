"""Least-norm tensions in the plane by trying every active set: exact, slow, hard to get wrong.

Each cable is free, at the lower or at the upper bound. With the others at their bounds, the free
ones take the least-norm solution. The optimum is one of these candidates, because it is the
least-norm solution of its own free cables; where fewer than two are free, so is that of two
independent cables. Hence at most n - 2 cables need to be at a bound.

Cables that are parallel, or within 1e-8 of it, are fine. In between, where all cables lie within
1e-9 to 1e-15 of one line, the wrench is met but the norm may not be the least (long double: not
before 1e-11).

In this file the batch is the last axis: s (2, n, rows), w (2, rows), tension (n, rows).
"""

from collections.abc import Callable, Iterator
from itertools import combinations, product

import numpy as np
import numpy.typing as npt

from turnbuckle.model.reference.arrays import Array
from turnbuckle.model.reference.planar import minors

ROUNDINGS = 32  # a sum over the cables may be off by this many units in its last place
Solver = Callable[[Array, Array, tuple[int, ...]], Array]


def least_norm(
    structure: Array, wrench: Array, lower: float, upper: float
) -> tuple[Array, npt.NDArray[np.bool_]]:
    """Tensions (rows, n) for structure (rows, 2, n), wrench (rows, 2); whether they are exact.

    Where no bounded tension gives the wrench: the candidate, clipped, with the smallest error.
    """
    s = np.ascontiguousarray(np.moveaxis(structure, 0, -1))
    w = np.ascontiguousarray(np.moveaxis(wrench, 0, -1))
    bounds = (lower, upper) if np.isfinite(upper) else (lower,)
    best = _Best(s, w, lower, upper)
    best.try_all(bounds, _independent_cables(structure), fewest_free=2)
    parallel = _all_parallel(structure)
    if np.any(parallel):
        line = _Best(s[..., parallel], w[..., parallel], lower, upper)
        line.try_all(bounds, _parallel_cables, fewest_free=1)
        best.replace(parallel, line)
    return np.moveaxis(best.tension, -1, 0), np.asarray(best.error == 0)


class _Best:
    """The best candidate so far in each row: least error first, then least norm."""

    def __init__(self, s: Array, w: Array, lower: float, upper: float) -> None:
        self.s, self.w, self.lower, self.upper = s, w, lower, upper
        self.tension = np.full(s.shape[1:], np.nan, s.dtype)
        self.error = np.full(w.shape[1:], np.inf, s.dtype)
        self.square = np.full(w.shape[1:], np.inf, s.dtype)

    def try_all(self, bounds: tuple[float, ...], solve: Solver, fewest_free: int) -> None:
        """Try all active sets that leave at least so many cables free."""
        with np.errstate(all="ignore"):  # a set that does not span the plane: not finite, rejected
            for free, held in _active_sets(self.s.shape[1], fewest_free, bounds):
                self._keep_better(_candidate(self.s, self.w, solve, free, held))

    def replace(self, rows: npt.NDArray[np.bool_], other: "_Best") -> None:
        """Take over the rows of another result."""
        self.tension[:, rows], self.error[rows] = other.tension, other.error

    def _keep_better(self, candidate: Array) -> None:
        tension = np.clip(candidate, self.lower, self.upper)
        error = np.max(np.abs(_wrench_left(self.s, self.w, tension)), axis=0)
        size = np.sum(tension, axis=0) + np.sum(np.abs(self.w), axis=0)
        error[error <= ROUNDINGS * np.finfo(error.dtype).eps * size] = 0
        square = np.sum(tension * tension, axis=0)
        better = (error < self.error) | ((error == self.error) & (square < self.square))
        np.copyto(self.tension, tension, where=better)
        np.copyto(self.error, error, where=better)
        np.copyto(self.square, square, where=better)


def _active_sets(
    cables: int, fewest_free: int, bounds: tuple[float, ...]
) -> Iterator[tuple[tuple[int, ...], dict[int, float]]]:
    """Every choice of free cables, and every way to put the others at a bound."""
    for count in range(fewest_free, cables + 1):
        for free in combinations(range(cables), count):
            others = [i for i in range(cables) if i not in free]
            for values in product(bounds, repeat=len(others)):
                yield free, dict(zip(others, values, strict=True))


def _candidate(
    s: Array, w: Array, solve: Solver, free: tuple[int, ...], held: dict[int, float]
) -> Array:
    """The free cables' least-norm tensions, refined once.

    Without it two cables at an angle of 0.01 would miss the wrench by 100 roundings, and the best
    candidate would be taken for infeasible.
    """
    tension = np.zeros(s.shape[1:], s.dtype)
    for i, value in held.items():
        tension[i] = value
    for _ in range(2):
        tension[list(free)] += solve(s, _wrench_left(s, w, tension), free)
    return tension


def _wrench_left(s: Array, w: Array, tension: Array) -> Array:
    return np.asarray(w - np.einsum("dnr,nr->dr", s, tension))


def _independent_cables(structure: Array) -> Solver:
    """T_i = sum_j D_ij (w x s_j) / sum of squared minors D: the least-norm solution."""
    minor = np.ascontiguousarray(np.moveaxis(minors(np.swapaxes(structure, -1, -2)), 0, -1))

    def solve(s: Array, w: Array, free: tuple[int, ...]) -> Array:
        weight = sum(minor[i, j] ** 2 for i, j in combinations(free, 2))
        moment = {j: w[0] * s[1, j] - w[1] * s[0, j] for j in free}
        share = [sum(minor[i, j] * moment[j] for j in free if j != i) for i in free]
        return np.asarray(np.stack(share) / weight)

    return solve


def _parallel_cables(s: Array, w: Array, free: tuple[int, ...]) -> Array:
    """T_i = s_i . w / sum of |s|^2: the least-norm solution along one line."""
    columns = s[:, list(free)]
    return np.asarray(np.einsum("dnr,dr->nr", columns, w) / np.sum(columns**2, axis=(0, 1)))


def _all_parallel(structure: Array) -> npt.NDArray[np.bool_]:
    size = np.sum(structure**2, axis=(-2, -1))
    largest = np.max(np.abs(minors(np.swapaxes(structure, -1, -2))), axis=(-2, -1))
    return np.asarray(largest <= ROUNDINGS * np.finfo(size.dtype).eps * size)
