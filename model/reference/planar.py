"""Linear algebra in the plane by 2 x 2 minors, for any floating type, over any batch.

A least-squares solution, and a minimum-norm solution too, is the mean of the solutions of all
2 x 2 subsystems weighted by their squared determinants (Berg 1986; Ben-Tal and Teboulle 1990).
Nothing is squared before it is subtracted, so nearly parallel rows cost one condition number.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.floating[Any]]

ROWS_PER_CHUNK = 8192  # keeps the temporaries of one chunk in the cache


def as_floating(*values: npt.ArrayLike) -> list[Array]:
    """The inputs as arrays of one floating type: the widest given, at least double."""
    arrays = [np.asarray(value) for value in values]
    dtype = np.result_type(np.float64, *arrays)
    return [array.astype(dtype, copy=False) for array in arrays]


def cross(a: Array, b: Array) -> Array:
    """z component of a x b for vectors in the last axis."""
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


def norm(vectors: Array) -> Array:
    """Euclidean norm over the last axis, in the type of the input."""
    return np.asarray(np.sqrt(np.sum(vectors * vectors, axis=-1)))


def minors(vectors: Array) -> Array:
    """All cross products D[i, j] = v_i x v_j of vectors (..., n, 2), exactly antisymmetric."""
    product = vectors[..., :, None, 0] * vectors[..., None, :, 1]
    return np.asarray(product - np.swapaxes(product, -1, -2))


def inner_products(vectors: Array) -> Array:
    """All inner products v_i . v_j of vectors (..., n, 2), exactly symmetric."""
    x, y = vectors[..., 0], vectors[..., 1]
    return np.asarray(x[..., :, None] * x[..., None, :] + y[..., :, None] * y[..., None, :])


def least_squares(rows: Array, values: Array) -> Array:
    """The x (..., 2) of least ||rows x - values||, rows (..., n, 2); NaN where all are parallel."""
    determinants = minors(rows)
    share = np.sum(determinants * values[..., :, None], axis=-2)
    solution = np.stack(
        [np.sum(share * rows[..., 1], axis=-1), -np.sum(share * rows[..., 0], axis=-1)], axis=-1
    )
    return np.asarray(solution / _total_weight(rows, determinants)[..., None])


def least_norm(columns: Array, target: Array) -> Array:
    """The least x (..., n) with sum of x_i columns_i = target; NaN where all are parallel."""
    determinants = minors(columns)
    moments = cross(target[..., None, :], columns)
    share = np.sum(determinants * moments[..., None, :], axis=-1)
    return np.asarray(share / _total_weight(columns, determinants)[..., None])


def _total_weight(vectors: Array, determinants: Array) -> Array:
    """Sum of the squared minors; NaN where they are nothing but rounding."""
    weight = np.sum(determinants**2, axis=(-2, -1)) / 2
    size = np.sum(vectors**2, axis=(-2, -1))
    rounding = vectors.shape[-2] * np.finfo(weight.dtype).eps * size
    return np.where(weight > rounding**2, weight, np.asarray(np.nan, weight.dtype))


def in_chunks(
    function: Callable[..., tuple[npt.NDArray[Any], ...]], *inputs: tuple[Array, int]
) -> tuple[npt.NDArray[Any], ...]:
    """Apply `function` to the broadcast batch a chunk of rows at a time, so memory stays bounded.

    Each input comes with the number of its trailing axes that are not batch axes.
    """
    batch = np.broadcast_shapes(*(array.shape[: array.ndim - core] for array, core in inputs))
    flat = []
    for array, core in inputs:
        own = array.shape[array.ndim - core :]
        flat.append(np.broadcast_to(array, batch + own).reshape(-1, *own))
    starts = range(0, max(1, flat[0].shape[0]), ROWS_PER_CHUNK)
    parts = [function(*(rows[start : start + ROWS_PER_CHUNK] for rows in flat)) for start in starts]
    columns = [np.concatenate(column) for column in zip(*parts, strict=True)]
    return tuple(column.reshape(batch + column.shape[1:]) for column in columns)
