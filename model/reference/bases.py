"""Where the bases go when the rail coordinates change, in any floating type."""

from typing import NamedTuple

import numpy as np

from turnbuckle.model.base import FixedBase, PlaneBase, RailBase
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.arrays import Array, unit


class Travel(NamedTuple):
    """b = start + sum of s_k e: start (space) [m]; pairs of k and the unit vector e (space)."""

    start: Array
    directions: tuple[tuple[int, Array], ...]


def travels(machine: Machine, dtype: np.dtype[np.floating]) -> list[Travel]:
    """How the base of every cable moves; the directions are rounded in the given type only."""
    result = []
    for cable, motion in zip(machine.cables, machine.base_motions, strict=True):
        numbers = [k for k, _ in motion.travel]
        start, ends = _ends(cable.base)
        origin = np.asarray(start, dtype)
        directions = [unit(np.asarray(end, dtype) - origin) for end in ends]
        result.append(Travel(origin, tuple(zip(numbers, directions, strict=True))))
    return result


Point = tuple[float, ...]


def _ends(base: FixedBase | RailBase | PlaneBase) -> tuple[Point, tuple[Point, ...]]:
    if isinstance(base, FixedBase):
        return base.position, ()
    if isinstance(base, RailBase):
        return base.start, (base.end,)
    return base.corner, (base.along, base.across)
