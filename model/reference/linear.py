"""Linear algebra of small matrices in any floating type, over any batch.

NumPy's own stops at double. The factorisation is Gram-Schmidt with column pivoting, every column
made orthogonal twice, which is as good as Householder's (Giraud, Langou, Rozloznik 2005). In the
plane `planar` gives the same answers by minors.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from turnbuckle.model.reference import planar
from turnbuckle.model.reference.arrays import Array, norm

RANK_ROUNDINGS = 16  # a pivot below this many roundings of the largest is zero


class Factors(NamedTuple):
    """A = Q R with the columns of A (..., n, k) in `order` (..., k); rank (...).

    q (..., n, p), r (..., p, k), p the lesser of n and k. Columns of q and rows of r from the rank
    on are zero.
    """

    q: Array
    r: Array
    order: npt.NDArray[np.intp]
    rank: npt.NDArray[np.intp]


def factorise(matrix: Array) -> Factors:
    """Q R of a matrix (..., n, k); the column with the most that is new comes first."""
    left = matrix.copy()
    count, pivots = left.shape[-1], min(left.shape[-2:])
    q = np.zeros((*left.shape[:-1], pivots), left.dtype)
    r = np.zeros((*left.shape[:-2], pivots, count), left.dtype)
    order = np.broadcast_to(np.arange(count), (*left.shape[:-2], count)).copy()
    rank = np.zeros(left.shape[:-2], np.intp)
    limit = _least_pivot(matrix)
    for k in range(pivots):
        _largest_first(left, r, order, k)
        column = left[..., k]
        twice = q[..., :k] @ (np.swapaxes(q[..., :k], -1, -2) @ column[..., None])
        column = column - twice[..., 0]
        size = norm(column)
        counts = size > limit
        rank += counts
        size = np.where(counts, size, 0)
        direction = np.divide(
            column, size[..., None], out=np.zeros_like(column), where=counts[..., None]
        )
        q[..., k] = direction
        share = np.sum(direction[..., None] * left[..., k + 1 :], axis=-2)
        r[..., k, k], r[..., k, k + 1 :] = size, share
        left[..., k + 1 :] -= direction[..., None] * share[..., None, :]
    return Factors(q, r, order, rank)


def least_squares(rows: Array, values: Array) -> Array:
    """The x (..., d) of least ||rows x - values||, rows (..., n, d); NaN where x is not unique."""
    if rows.shape[-1] == 2:
        return planar.least_squares(rows, values)
    f = factorise(rows)
    return _where_full_rank(f, _solution(f, values))


def inverse(matrix: Array) -> Array:
    """Of square matrices (..., d, d); NaN where singular."""
    units = np.eye(matrix.shape[-1], dtype=matrix.dtype)
    if matrix.shape[-1] == 2:
        return np.stack([planar.least_squares(matrix, unit) for unit in units], axis=-1)
    f = factorise(matrix)
    return np.stack([_where_full_rank(f, _solution(f, unit)) for unit in units], axis=-1)


def least_norm(columns: Array, target: Array) -> Array:
    """The least x (..., n) with sum of x_i columns_i = target (..., d), columns (..., n, d).

    NaN where the columns do not span.
    """
    if columns.shape[-1] == 2:
        return planar.least_norm(columns, target)
    f = factorise(columns)
    wanted = np.take_along_axis(target, f.order, axis=-1)
    solution = forward_substitution(np.swapaxes(f.r, -1, -2), wanted)
    return _where_full_rank(f, np.sum(f.q * solution[..., None, :], axis=-1))


def pseudo_solution(matrix: Array, target: Array) -> Array:
    """The least x (..., n) of least ||matrix x - target||, matrix (..., d, n) of any rank."""
    f = factorise(np.swapaxes(matrix, -1, -2))
    # matrix = P R' Q' with the rows in the order P: first the least squares, then x along Q
    wanted = np.take_along_axis(target, f.order, axis=-1)
    along = _solution(factorise(np.swapaxes(f.r, -1, -2)), wanted)
    return np.asarray(np.sum(f.q * along[..., None, :], axis=-1))


def kernel(matrix: Array) -> Array:
    """Orthonormal columns (..., n, n - d) that a matrix (..., d, n) of full rank sends to zero.

    NaN where the rank is less than d.
    """
    d, n = matrix.shape[-2:]
    f = factorise(np.swapaxes(matrix, -1, -2))
    rest = np.eye(n, dtype=matrix.dtype) - f.q @ np.swapaxes(f.q, -1, -2)
    null = factorise(rest).q[..., : n - d]
    return np.where((f.rank == d)[..., None, None], null, np.asarray(np.nan, matrix.dtype))


def complete_basis(columns: Array) -> Array:
    """Orthonormal basis (..., d, d) whose first columns span those given (..., d, n), n >= d."""
    f = factorise(columns)
    rest = np.eye(f.q.shape[-1], dtype=columns.dtype) - f.q @ np.swapaxes(f.q, -1, -2)
    others = factorise(rest)
    # what the others lack is what the first have: fill the zero columns with them, in order
    missing = np.arange(f.q.shape[-1]) - f.rank[..., None]
    index = np.broadcast_to(np.maximum(missing, 0)[..., None, :], f.q.shape)
    filled = np.take_along_axis(others.q, index, axis=-1)
    return np.where((missing >= 0)[..., None, :], filled, f.q)


def back_substitution(upper: Array, values: Array) -> Array:
    """x (..., k) with upper x = values; zero where a pivot is zero."""
    x = np.zeros(np.broadcast_shapes(upper.shape[:-1], values.shape), values.dtype)
    for k in reversed(range(upper.shape[-1])):
        left = values[..., k] - np.sum(upper[..., k, k + 1 :] * x[..., k + 1 :], axis=-1)
        x[..., k] = _quotient(left, upper[..., k, k])
    return x


def forward_substitution(lower: Array, values: Array) -> Array:
    """x (..., k) with lower x = values; zero where a pivot is zero."""
    return back_substitution(lower[..., ::-1, ::-1], values[..., ::-1])[..., ::-1]


def _solution(factors: Factors, values: Array) -> Array:
    """Least squares with the leading columns; zero for those beyond the rank."""
    pivots = factors.r.shape[-2]
    leading = factors.r[..., :pivots]
    solution = back_substitution(leading, np.sum(factors.q * values[..., None], axis=-2))
    placed = np.zeros((*solution.shape[:-1], factors.order.shape[-1]), solution.dtype)
    np.put_along_axis(placed, factors.order[..., :pivots], solution, axis=-1)
    return placed


def _quotient(value: Array, pivot: Array) -> Array:
    return np.divide(value, pivot, out=np.zeros_like(value), where=pivot != 0)


def _least_pivot(matrix: Array) -> Array:
    largest = np.sqrt(np.max(np.sum(matrix * matrix, axis=-2), axis=-1))
    return np.asarray(
        RANK_ROUNDINGS * sum(matrix.shape[-2:]) * np.finfo(matrix.dtype).eps * largest
    )


def _largest_first(left: Array, r: Array, order: npt.NDArray[np.intp], k: int) -> None:
    """Exchange column k with the largest one from there on."""
    pick = k + np.argmax(np.sum(left[..., k:] ** 2, axis=-2), axis=-1)
    for part in (left, r, order[..., None, :]):
        index = np.broadcast_to(pick[..., None, None], (*part.shape[:-1], 1))
        chosen = np.take_along_axis(part, index, axis=-1)
        np.put_along_axis(part, index, part[..., k : k + 1], axis=-1)
        part[..., k : k + 1] = chosen


def _where_full_rank(factors: Factors, solution: Array) -> Array:
    full = factors.rank == factors.order.shape[-1]
    return np.where(full[..., None], solution, np.asarray(np.nan, solution.dtype))
