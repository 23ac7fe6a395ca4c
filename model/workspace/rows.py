"""Large batches a chunk of rows at a time, so that memory stays bounded."""

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

FLOATS_IN_A_CHUNK = 1 << 18  # 2 MB: what one step of the work writes stays near the cache


def in_chunks(
    function: Callable[..., npt.NDArray[Any]],
    floats_per_row: int,
    *inputs: tuple[npt.ArrayLike, int],
) -> npt.NDArray[Any]:
    """Apply `function` to the broadcast batch, at most so many rows at a time.

    Each input comes with the number of its trailing axes that are not batch axes; the function
    gets arrays (rows, ...) and returns one (rows, ...), which comes back with the batch's axes.
    """
    arrays = [(np.asarray(values, np.float64), core) for values, core in inputs]
    batch = np.broadcast_shapes(*(array.shape[: array.ndim - core] for array, core in arrays))
    flat = []
    for array, core in arrays:
        own = array.shape[array.ndim - core :]
        flat.append(np.broadcast_to(array, batch + own).reshape(-1, *own))
    step = max(1, FLOATS_IN_A_CHUNK // floats_per_row)
    starts = range(0, max(1, flat[0].shape[0]), step)
    result = np.concatenate([function(*(rows[at : at + step] for rows in flat)) for at in starts])
    return result.reshape(batch + result.shape[1:])
