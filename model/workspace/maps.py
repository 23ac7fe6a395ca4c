"""Quantities over a grid of poses: as a map, or as a summary where the map would be too large."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from turnbuckle.model.workspace.grid import TILE, Grid, Progress
from turnbuckle.model.workspace.rows import Array

Measure = Callable[[Array], Array]


class Summary(NamedTuple):
    """A quantity over a grid: `share` of the poses where it is at least what is wanted.

    least and mean are over the poses where it is defined (NaN if there are none); worst is where
    it is least, or the first pose where it is not defined, if there is one; `undefined` counts
    those.
    """

    poses: int
    undefined: int
    share: float
    least: float
    mean: float
    worst: tuple[float, ...]


class Tally:
    """Adds up a quantity tile by tile, so that its map need not be held."""

    def __init__(self, wanted: float = 0.0) -> None:
        """`wanted`: less by the quantity's rounding, where poses lie on the boundary."""
        self._wanted = wanted
        self._poses = self._defined = self._covered = 0
        self._total, self._least = 0.0, np.inf
        self._worst: Array | None = None
        self._lost: Array | None = None

    def add(self, poses: Array, values: npt.NDArray[np.floating]) -> None:
        """Take in poses (rows, dim) and their values (rows), NaN where it is not defined."""
        known = ~np.isnan(values)
        self._poses += len(poses)
        self._defined += int(np.sum(known))
        self._covered += int(np.sum(values >= self._wanted))
        self._total += float(np.sum(values[known]))
        if self._lost is None and not np.all(known):
            self._lost = poses[np.argmin(known)]
        least = float(np.min(values[known], initial=np.inf))
        if least < self._least or (self._worst is None and np.any(known)):
            self._least, self._worst = least, poses[np.nanargmin(values)]

    @property
    def summary(self) -> Summary:
        """All that was taken in. ValueError when that was nothing."""
        worst = self._worst if self._lost is None else self._lost
        if worst is None:
            raise ValueError("there are no poses to summarise")
        return Summary(
            poses=self._poses,
            undefined=self._poses - self._defined,
            share=self._covered / self._poses,
            least=self._least if self._defined else np.nan,
            mean=self._total / self._defined if self._defined else np.nan,
            worst=tuple(worst.tolist()),
        )


def evaluate(
    measure: Measure, grid: Grid, rows: int = TILE, progress: Progress | None = None
) -> Array:
    """`measure` of every pose, an array (*grid.shape, ...): it gives (rows, ...) for (rows, dim).

    Memory is that of the result and of one tile.
    """
    result = np.empty(0)
    start = 0
    for poses in grid.tiles(rows, progress):
        values = measure(poses)
        if start == 0:
            result = np.empty((grid.size, *values.shape[1:]))
        result[start : start + len(poses)] = values
        start += len(poses)
    return result.reshape(grid.shape + result.shape[1:])


def summarise(
    measure: Measure,
    grid: Grid,
    wanted: float = 0.0,
    rows: int = TILE,
    progress: Progress | None = None,
) -> Summary:
    """Summary of `measure` over the grid, in the memory of one tile; `wanted` as in `Tally`."""
    tally = Tally(wanted)
    for poses in grid.tiles(rows, progress):
        tally.add(poses, measure(poses))
    return tally.summary
