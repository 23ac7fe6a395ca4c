"""What a map amounts to, added up tile by tile, so that no map need be kept whole."""

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.pose_map import Reals, Tile
from turnbuckle.model.machine import Machine

#: Classes of the histogram of margins, unless told otherwise.
BINS = 400


@dataclass(frozen=True)
class Histogram:
    """How many margins fall into each of equal classes from `low` to `high` [N].

    Those beyond an end are counted in the class there.
    """

    low: float
    high: float
    counts: NDArray[np.int64] = field(default_factory=lambda: np.zeros(BINS, np.int64))

    def add(self, margins: Reals) -> None:
        """Count some margins."""
        bins = len(self.counts)
        scaled = (margins - self.low) * (bins / (self.high - self.low))
        classes = np.clip(scaled, 0, bins - 1).astype(np.intp)
        self.counts[:] += np.bincount(classes, minlength=bins)

    @property
    def edges(self) -> NDArray[np.float64]:
        """Ends of the classes [N], one more than there are classes."""
        return np.linspace(self.low, self.high, len(self.counts) + 1)


@dataclass
class Tally:
    """Sums over the poses of a map.

    Margins and forces are in newtons; `force` is the one that is wanted in every direction.
    """

    force: float
    histogram: Histogram
    poses: int = 0
    #: Poses without an answer, at a pulley or between parallel cables.
    refused: int = 0
    #: Poses where the zero wrench is feasible, and where every force up to `force` is.
    feasible: int = 0
    covered: int = 0
    #: Least margin, and the row and column of the first pose that has it.
    least_margin: float = np.inf
    worst: tuple[int, int] | None = None
    total_force: float = 0.0
    total_factor: float = 0.0

    @property
    def answered(self) -> int:
        """Poses with an answer."""
        return self.poses - self.refused

    @property
    def coverage(self) -> float:
        """Share of all poses at which every force up to `force` is feasible."""
        return self.covered / self.poses if self.poses else np.nan

    @property
    def mean_force(self) -> float:
        """Mean isotropic force I_F over the poses with an answer, 0 outside the workspace [N]."""
        return self.total_force / self.answered if self.answered else np.nan

    @property
    def mean_factor(self) -> float:
        """Mean tension factor over the poses where the zero wrench is feasible."""
        return self.total_factor / self.feasible if self.feasible else np.nan

    def add(self, tile: Tile) -> None:
        """Add the poses of a tile."""
        known = np.isfinite(tile.margin)
        whole = bool(known.all())
        margin = tile.margin.ravel() if whole else tile.margin[known]
        self.poses += tile.margin.size
        self.refused += tile.margin.size - margin.size
        self.feasible += int(np.count_nonzero(margin >= 0))
        self.covered += int(np.count_nonzero(margin >= self.force))
        self.total_force += float(np.sum(np.maximum(margin, 0), dtype=np.float64))
        self.total_factor += float(np.nansum(tile.factor, dtype=np.float64))
        self.histogram.add(margin)
        self._keep_worst(tile)

    def _keep_worst(self, tile: Tile) -> None:
        least = float(np.fmin.reduce(tile.margin, axis=None))
        if least < self.least_margin:
            first = int(np.flatnonzero(tile.margin == least)[0])
            row, column = divmod(first, tile.margin.shape[1])
            self.least_margin, self.worst = least, (tile.rows.start + row, column)


def tally(machine: Machine, tiles: Iterable[Tile], force: float | None = None) -> Tally:
    """Add up a map; `force` [N] is by default the machine's target.

    The histogram reaches from -n T_max to n T_max / 2, which no margin exceeds.
    """
    span = len(machine.cables) * machine.tension.max
    wanted = machine.target.force if force is None else force
    total = Tally(wanted, Histogram(-span, span / 2))
    for tile in tiles:
        total.add(tile)
    return total
