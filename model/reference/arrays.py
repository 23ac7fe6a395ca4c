"""Batches of vectors in any floating type."""

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


def norm(vectors: Array) -> Array:
    """Euclidean norm over the last axis, in the type of the input."""
    return np.asarray(np.sqrt(np.sum(vectors * vectors, axis=-1)))


def unit(vectors: Array) -> Array:
    """Unit vectors along the last axis; NaN for the zero vector."""
    with np.errstate(invalid="ignore"):
        return np.asarray(vectors / norm(vectors)[..., None])


def in_chunks(
    function: Callable[..., tuple[npt.NDArray[Any], ...]],
    *inputs: tuple[Array, int],
    rows_per_chunk: int = ROWS_PER_CHUNK,
) -> tuple[npt.NDArray[Any], ...]:
    """Apply `function` to the broadcast batch a chunk of rows at a time, so memory stays bounded.

    Each input comes with the number of its trailing axes that are not batch axes.
    """
    batch = np.broadcast_shapes(*(array.shape[: array.ndim - core] for array, core in inputs))
    flat = []
    for array, core in inputs:
        own = array.shape[array.ndim - core :]
        rows = int(np.prod(batch))
        flat.append(np.broadcast_to(array, batch + own).reshape(rows, *own))
    starts = range(0, max(1, flat[0].shape[0]), rows_per_chunk)
    parts = [function(*(rows[start : start + rows_per_chunk] for rows in flat)) for start in starts]
    columns = [np.concatenate(column) for column in zip(*parts, strict=True)]
    return tuple(column.reshape(batch + column.shape[1:]) for column in columns)
