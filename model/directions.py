"""How many independent directions vectors have; in plain Python, which starts at once."""

import math
from collections.abc import Iterable, Sequence


def rank(vectors: Iterable[Sequence[float]], tolerance: float) -> int:
    """Number of independent directions among vectors of one dimension.

    Whatever is left of a vector beside those that count already, and not longer than `tolerance`,
    is rounding.
    """
    left = [list(vector) for vector in vectors]
    found = 0
    while left:
        longest = max(left, key=lambda vector: math.hypot(*vector))
        length = math.hypot(*longest)
        if length <= tolerance:
            break
        found += 1
        direction = [x / length for x in longest]
        left.remove(longest)
        left = [_beside(vector, direction) for vector in left]
    return found


def _beside(vector: list[float], direction: list[float]) -> list[float]:
    """The part of a vector that is square to a unit vector."""
    along = dot(vector, direction)
    return [x - along * e for x, e in zip(vector, direction, strict=True)]


def dot(first: Sequence[float], second: Sequence[float]) -> float:
    """Inner product."""
    return math.fsum(a * b for a, b in zip(first, second, strict=True))
