"""The cables of a planar point around the platform, and the angles between neighbours."""

import numpy as np
import numpy.typing as npt

from turnbuckle.model.workspace.rows import Array


def adjacent_gaps(structure: npt.ArrayLike) -> tuple[npt.NDArray[np.intp], Array]:
    """Order (..., n) of the cables counter-clockwise, and the angle [rad] (..., n) to the next.

    structure (..., 2, n). NaN in it makes the angles beside it NaN.
    """
    s = np.asarray(structure, np.float64)
    bearing = np.arctan2(s[..., 1, :], s[..., 0, :])
    order = np.argsort(bearing, axis=-1)
    bearing = np.take_along_axis(bearing, order, axis=-1)
    gap = np.roll(bearing, -1, axis=-1) - bearing
    gap[..., -1] += 2 * np.pi
    return order, gap
