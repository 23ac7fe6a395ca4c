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
    apart: Callable[[Array], npt.NDArray[np.bool_]] | None = None,
) -> tuple[npt.NDArray[Any], ...]:
    """Apply `function` to the broadcast batch a chunk of rows at a time, so memory stays bounded.

    Each input comes with the number of its trailing axes that are not batch axes. `apart` tells,
    from the first input, which rows must not share a chunk with the others.
    """
    batch = np.broadcast_shapes(*(array.shape[: array.ndim - core] for array, core in inputs))
    flat = []
    for array, core in inputs:
        own = array.shape[array.ndim - core :]
        rows = int(np.prod(batch))
        flat.append(np.broadcast_to(array, batch + own).reshape(rows, *own))
    chunks = _chunks(flat[0], rows_per_chunk, apart)
    parts = [function(*(rows[chunk] for rows in flat)) for chunk in chunks]
    columns = [np.concatenate(column) for column in zip(*parts, strict=True)]
    back = np.argsort(np.concatenate(chunks)) if apart else slice(None)
    return tuple(column[back].reshape(batch + column.shape[1:]) for column in columns)


def _chunks(
    first: Array, most: int, apart: Callable[[Array], npt.NDArray[np.bool_]] | None
) -> list[Any]:
    """Numbers of the rows of every chunk; one chunk where there are no rows."""
    if apart is None:
        starts = range(0, max(1, len(first)), most)
        return [slice(start, start + most) for start in starts]
    special = apart(first)
    groups = [np.flatnonzero(~special), np.flatnonzero(special)]
    chunks = [rows[start : start + most] for rows in groups for start in range(0, len(rows), most)]
    return chunks or [np.arange(0)]
