"""How much rounding grows: pivots and singular values of the matrices that functions solve with.

In the plane by minors in long double; beyond, singular values in double precision, whose own
rounding is far below what they decide.
"""

from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.judges.problem import ROUNDINGS, Bools
from turnbuckle.model.reference.arrays import Array as Wide
from turnbuckle.model.reference.planar import minors

#: A singular value below this is rounding.
NOTHING = np.finfo(float).eps * ROUNDINGS


def least_pivot(rows: Wide) -> Wide:
    """Smallest pivot (count) of rows' rows without exchanges, rows (count, n, d)."""
    if rows.shape[-1] == 2:
        first = np.sum(rows[..., 0] ** 2, axis=-1)
        determinant = np.sum(minors(rows) ** 2, axis=(-2, -1)) / 2
        second = np.divide(determinant, first, out=np.zeros_like(first), where=first > 0)
        return np.asarray(np.minimum(first, second))
    pivots = np.diagonal(np.linalg.qr(rows.astype(float), mode="r"), axis1=-2, axis2=-1)
    return np.asarray(np.min(pivots**2, axis=-1), np.longdouble)


def smallest_singular_value(columns: Wide) -> Wide:
    """Of S (count), whose columns are given (count, n, d); weights 0 leave columns out."""
    if columns.shape[-1] == 2:
        trace = np.sum(columns**2, axis=(-2, -1))
        determinant = np.sum(minors(columns) ** 2, axis=(-2, -1)) / 2
        largest = (trace + np.sqrt(np.maximum(trace**2 - 4 * determinant, 0))) / 2
        square = np.divide(determinant, largest, out=np.zeros_like(trace), where=largest > 0)
        return np.asarray(np.sqrt(square))
    finite = np.where(np.isfinite(columns), columns, 0).astype(float)
    return np.asarray(np.linalg.svd(finite, compute_uv=False)[..., -1], np.longdouble)


def narrowest(columns: Wide, among: Bools) -> Wide:
    """Least singular value (count) of any d columns that are not dependent, `among` included.

    For two planar unit columns it is, but for a factor of sqrt(2), the sine of their angle. among
    (count, n): columns that must be part of the choice, as many of them as are independent.
    """
    count, n, d = columns.shape
    result = np.full(count, np.inf, np.longdouble)
    independent = rank(columns * among[..., None])
    for chosen in combinations(range(n), d):
        inside = np.sum(among[:, chosen], axis=-1)
        rows = np.flatnonzero(inside >= independent)
        if rows.size:
            least = smallest_singular_value(columns[rows][:, chosen])
            result[rows] = np.minimum(result[rows], np.where(least > NOTHING, least, np.inf))
    return np.where(np.isfinite(result), result, 1)


def rank(rows: Wide) -> NDArray[np.int_]:
    """How many of the rows (count, n, d) are independent (count)."""
    values = np.linalg.svd(rows.astype(float), compute_uv=False)
    return np.asarray(np.sum(values > NOTHING, axis=-1))
