"""A quantity over a grid of poses: as a map, or as its summary when the map would be too large."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from model.workspace.grid import TILE, Grid, Progress
from model.workspace.rows import Array

Measure = Callable[[Array], Array]


class Summary(NamedTuple):
    """A quantity over a grid: `share` of the poses where it is at least what is wanted.

    least and mean are over the poses where it is defined (NaN if there are none), worst is where
    it is least, or a pose where it is not defined if there is one; `undefined` counts those.
    """

    poses: int
    undefined: int
    share: float
    least: float
    mean: float
    worst: tuple[float, ...]


def evaluate(
    measure: Measure, grid: Grid, rows: int = TILE, progress: Progress | None = None
) -> Array:
    """`measure` of every pose, an array (*grid.shape): it gets poses (rows, dim), gives (rows).

    Memory is that of the result and of one tile.
    """
    result = np.empty(grid.size)
    start = 0
    for poses in grid.tiles(rows, progress):
        result[start : start + len(poses)] = measure(poses)
        start += len(poses)
    return result.reshape(grid.shape)


def summarise(
    measure: Measure,
    grid: Grid,
    wanted: float = 0.0,
    rows: int = TILE,
    progress: Progress | None = None,
) -> Summary:
    """Summary of `measure` over the grid, in the memory of one tile.

    A pose where it is not defined (NaN) does not have what is wanted. Let `wanted` be less by the
    rounding of the measure where poses lie on the boundary.
    """
    covered = undefined = 0
    total, least, lost = 0.0, np.inf, False
    worst = grid.poses(0, 1)[0]
    for poses in grid.tiles(rows, progress):
        values = measure(poses)
        known = ~np.isnan(values)
        covered += int(np.sum(values >= wanted))
        undefined += int(np.sum(~known))
        total += float(np.sum(values[known]))
        if np.any(~known) and not lost:
            worst, lost = poses[np.argmin(known)], True
        lowest = np.min(values[known], initial=np.inf)
        if lowest < least:
            least = float(lowest)
            worst = worst if lost else poses[np.nanargmin(values)]
    defined = grid.size - undefined
    return Summary(
        poses=grid.size,
        undefined=undefined,
        share=covered / grid.size,
        least=least if defined else np.nan,
        mean=total / defined if defined else np.nan,
        worst=tuple(worst.tolist()),
    )
