"""The machine in the plane, drawn with characters: bases, cables, handle."""

import numpy as np
from numpy.typing import ArrayLike, NDArray
from rich.text import Text

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.kinematics import base_points

COLUMNS, LARGEST_ROWS = 48, 20
ASPECT = 2.0
"""Height of a character over its width."""
CABLE, BASE, HANDLE = ".", "o", "@"


def draw_plane(machine: Machine, pose: ArrayLike | None, rails: ArrayLike) -> Text:
    """Bases at their rail coordinates [m] and, with a pose [m], the handle and its cables."""
    width, height = machine.frame.size[:2]
    rows = min(LARGEST_ROWS, max(4, round(COLUMNS * height / width / ASPECT)))
    canvas = np.full((rows, COLUMNS), " ")
    scale = np.array([(COLUMNS - 1) / width, (rows - 1) / height])

    def put(points: NDArray[np.floating], sign: str) -> None:
        column, up = np.rint(np.atleast_2d(points) * scale).astype(int).T
        seen = (column >= 0) & (column < COLUMNS) & (up >= 0) & (up < rows)
        canvas[rows - 1 - up[seen], column[seen]] = sign

    bases = base_points(machine, np.asarray(rails, dtype=float))
    if pose is not None:
        handle = np.asarray(pose, dtype=float)[:2]
        for base in bases:
            put(handle + np.linspace(0, 1, 2 * COLUMNS)[:, None] * (base - handle), CABLE)
        put(handle, HANDLE)
    put(bases, BASE)
    frame = "+" + "-" * COLUMNS + "+"
    return Text("\n".join([frame, *(f"|{''.join(row)}|" for row in canvas), frame]))


def has_plane(machine: Machine) -> bool:
    """Whether the picture knows this machine: in the plane, every base fixed or on its own rail."""
    return (
        machine.space == 2
        and all(len(rail.cables) == 1 for rail in machine.rails)
        and not any(cable.plane for cable in machine.cables)
    )
