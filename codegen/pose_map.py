"""Maps of pose quality: the generated C over a plane of poses, a tile of rows at a time.

Memory holds one tile, however many poses there are; the time is that of the poses alone.
"""

import ctypes
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from turnbuckle.codegen.bind import REALS, Generated, pointer
from turnbuckle.codegen.compile import compile_library
from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import MachineError, Problem

Reals = NDArray[np.floating[Any]]
Doubles = NDArray[np.float64]

SHIM = Path(__file__).parent / "pose_map_shim.c"
#: Poses of a tile unless told otherwise: its results stay in the processor's cache.
TILE_POSES = 2**15


@dataclass(frozen=True)
class Grid:
    """Poses origin + row row_step + column column_step [m, rad], each of d entries."""

    origin: tuple[float, ...]
    column_step: tuple[float, ...]
    row_step: tuple[float, ...]
    columns: int
    rows: int

    def __post_init__(self) -> None:
        if min(self.columns, self.rows) < 1:
            raise ValueError(f"grid: found {self.columns} x {self.rows} poses; each is 1 or more")

    @property
    def count(self) -> int:
        """Number of poses."""
        return self.rows * self.columns

    def poses(self, rows: range) -> Doubles:
        """The poses (rows, columns, d) of some rows."""
        row = np.arange(rows.start, rows.stop)[:, None, None]
        column = np.arange(self.columns)[None, :, None]
        start = np.asarray(self.origin) + row * np.asarray(self.row_step)
        return np.asarray(start + column * np.asarray(self.column_step))


@dataclass(frozen=True)
class Tile:
    """Some rows of a map: margin (rows, columns) [N] and factor (rows, columns) [1].

    The margin is negative outside the zero-wrench workspace, where the factor is 0; both are NaN
    where a pose has no answer, at a pulley or between parallel cables.
    """

    rows: range
    margin: Reals
    factor: Reals


def target_grid(machine: Machine, columns: int, rows: int) -> Grid:
    """The target's first two directions, its borders included; its centre in all others."""
    size, centre = machine.target.size, machine.target.centre
    corner = [middle - extent / 2 for middle, extent in zip(centre[:2], size[:2], strict=True)]
    rest = [*centre[2:], *[0.0] * (machine.dof - len(centre))]
    still = [0.0] * (machine.dof - 2)
    across, up = (
        extent / max(1, number - 1)
        for extent, number in zip(size[:2], (columns, rows), strict=True)
    )
    return Grid(
        (*corner, *rest), (across, 0.0, *still), (0.0, up, *still), columns=columns, rows=rows
    )


def refuse_without_quality(generated: Generated) -> None:
    """Refuse a machine of a kind for which pose quality is not generated: MachineError."""
    machine = generated.machine
    if "pose_quality" not in generated.functions:
        allowed = "planar-point, for a map of pose quality"
        raise MachineError(machine.path, [Problem("machine.kind", machine.kind, allowed)])


class PoseMap:
    """Maps of one machine in one precision.

    Raises MachineError for a machine whose C has no pose quality, RuntimeError when the C struct is
    not laid out as this module believes.
    """

    def __init__(self, generated: Generated) -> None:
        """Compile the loop around a machine's generated C, and load it."""
        refuse_without_quality(generated)
        folder = generated.folder
        sources = [*sorted(folder.glob("*.c")), SHIM]
        library = compile_library(sources, [folder], generated.precision)
        self.machine, self._real = generated.machine, REALS[generated.precision]
        self._library = ctypes.CDLL(str(library))
        self._library.shim_map.restype = None
        self._layout = grid_layout(self.machine)
        self._library.shim_grid_size.restype = ctypes.c_size_t
        if self._library.shim_grid_size() != self._layout.itemsize:
            raise RuntimeError("shim_grid is laid out otherwise in the library than here")

    def tiles(
        self,
        grid: Grid,
        tile_rows: int | None = None,
        *,
        rails: ArrayLike | None = None,
        lag: ArrayLike | None = None,
    ) -> Iterator[Tile]:
        """The map of a grid, so many rows at a time.

        Bases stay at `rails` (m) [m]. Without it they follow the platform by tb_base_targets, and
        are where it was when its pose was less by `lag` (d) [m, rad], by default nowhere behind.
        Raises ValueError for arguments of another size than the machine's.
        """
        height = max(1, TILE_POSES // grid.columns) if tile_rows is None else tile_rows
        if height < 1:
            raise ValueError(f"tile_rows: found {height}; it takes 1 or more")
        given, behind = self._bases(rails, lag)
        layout = np.zeros((), self._layout)
        layout["columns"] = grid.columns
        for name in ("origin", "column_step", "row_step"):
            layout[name] = vector(name, getattr(grid, name), self.machine.dof)
        for first in range(0, grid.rows, height):
            rows = range(first, min(first + height, grid.rows))
            yield self._tile(layout, given, behind, rows, grid.columns)

    def _tile(
        self,
        layout: NDArray[Any],
        rails: Doubles,
        lag: Doubles | None,
        rows: range,
        columns: int,
    ) -> Tile:
        margin, factor = (np.empty((len(rows), columns), self._real) for _ in range(2))
        self._library.shim_map(
            pointer(layout),
            pointer(rails),
            None if lag is None else pointer(lag),
            ctypes.c_size_t(rows.start),
            ctypes.c_size_t(len(rows)),
            pointer(margin),
            pointer(factor),
        )
        return Tile(rows, margin, factor)

    def _bases(
        self, rails: ArrayLike | None, lag: ArrayLike | None
    ) -> tuple[Doubles, Doubles | None]:
        """Rail coordinates in the slots that the C has, and the lag where the bases follow."""
        count = len(self.machine.rails)
        slots = np.zeros(max(1, count))
        if rails is None:
            nowhere = np.zeros(self.machine.dof)
            return slots, vector("lag", nowhere if lag is None else lag, self.machine.dof)
        if lag is not None:
            raise ValueError("rails and lag: bases that stay have no lag; give one of them")
        slots[:count] = vector("rails", rails, count)
        return slots, None


def vector(name: str, values: ArrayLike, size: int) -> Doubles:
    """An argument as contiguous doubles; ValueError where it has another size."""
    array = np.ascontiguousarray(values, dtype=np.float64)
    if array.shape != (size,):
        raise ValueError(f"{name}: found shape {array.shape}; it takes ({size},)")
    return array


def grid_layout(machine: Machine) -> np.dtype[np.void]:
    """shim_grid of pose_map_shim.c."""
    places = [(name, np.float64, (machine.dof,)) for name in ("origin", "column_step", "row_step")]
    return np.dtype([("columns", np.uintp), *places], align=True)
