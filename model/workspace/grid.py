"""Regular grids of poses, which are computed where they are needed instead of held in memory."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from turnbuckle.model.machine import Machine
from turnbuckle.model.workspace.rows import Array

TILE = 1 << 16  # poses at a time
Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class Grid:
    """All combinations of the coordinates of the axes, the last axis fastest."""

    axes: tuple[Array, ...]

    @property
    def shape(self) -> tuple[int, ...]:
        """How many coordinates every axis has."""
        return tuple(len(axis) for axis in self.axes)

    @property
    def size(self) -> int:
        """How many poses."""
        return int(np.prod(self.shape, dtype=np.int64))

    def poses(self, start: int = 0, stop: int | None = None) -> Array:
        """Poses (rows, dim) number `start` up to but not including `stop`."""
        number = np.arange(start, self.size if stop is None else min(stop, self.size))
        places = np.unravel_index(number, self.shape)
        return np.stack([axis[k] for axis, k in zip(self.axes, places, strict=True)], axis=-1)

    def tiles(self, rows: int = TILE, progress: Progress | None = None) -> Iterator[Array]:
        """All poses, so many at a time; `progress` hears after each how many of how many are done.

        A tile is done when the next is asked for.
        """
        bounds = [*range(0, self.size, rows), self.size]
        for start, stop in pairwise(bounds):
            yield self.poses(start, stop)
            if progress is not None:
                progress(stop, self.size)


def target_grid(machine: Machine, counts: Sequence[int], rotations: int = 1) -> Grid:
    """Grid over the machine's target, its border included, with `counts` poses along each side.

    A rigid platform also turns: `rotations` angles from minus to plus the target's rotation about
    every axis. A count of 1 is the middle.
    """
    target = machine.target
    centred = zip(target.centre, target.size, counts, strict=True)
    sides = [_to_border(centre - size / 2, centre + size / 2, n) for centre, size, n in centred]
    return Grid((*sides, *_turns(machine, target.rotation, rotations)))


def frame_grid(machine: Machine, counts: Sequence[int], rotations: int = 1) -> Grid:
    """Grid of the middles of `counts` cells along each side of the frame; rotations as above.

    Middles, because pulleys often sit on the frame, where poses are not defined.
    """
    sides = [
        np.asarray((np.arange(n) + 0.5) * (size / n), np.float64)
        for size, n in zip(machine.frame.size, counts, strict=True)
    ]
    return Grid((*sides, *_turns(machine, machine.rotation, rotations)))


def _to_border(low: float, high: float, count: int) -> Array:
    return np.linspace(low, high, count) if count > 1 else np.array([(low + high) / 2])


def _turns(machine: Machine, largest: float, count: int) -> list[Array]:
    return [_to_border(-largest, largest, count)] * (machine.dof - machine.space)
