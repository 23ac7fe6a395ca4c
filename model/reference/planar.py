"""Linear algebra in the plane by 2 x 2 minors, for any floating type, over any batch.

A least-squares solution, and a minimum-norm solution too, is the mean of the solutions of all
2 x 2 subsystems weighted by their squared determinants (Berg 1986; Ben-Tal and Teboulle 1990).
Nothing is squared before it is subtracted, so nearly parallel rows cost one condition number.
"""

import numpy as np

from turnbuckle.model.reference.arrays import Array, norm

__all__ = ["Array", "cross", "inner_products", "least_norm", "least_squares", "minors", "norm"]


def cross(a: Array, b: Array) -> Array:
    """z component of a x b for vectors in the last axis."""
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


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
