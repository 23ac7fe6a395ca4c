"""Vectors normal to d - 1 others, by the minors of those: one vector more at a time (Laplace)."""

from itertools import combinations

import numpy as np

from turnbuckle.model.reference.arrays import Array

#: Minors (...) of k vectors by the coordinates they take, k of 0 to d - 1 in rising order.
Minors = dict[tuple[int, ...], Array]


def none_yet(like: Array) -> Minors:
    """The minor of no vectors."""
    return {(): np.ones_like(like)}


def with_vector(minors: Minors, vector: Array) -> Minors:
    """The minors with one vector more, its coordinates in the first axis (d, ...)."""
    size = len(next(iter(minors))) + 1
    return {
        rows: _expansion(minors, vector, rows) for rows in combinations(range(len(vector)), size)
    }


def normal(minors: Minors) -> Array:
    """The vector (d, ...) whose inner product with any w is det[w, v_1, ..., v_(d-1)]."""
    d = len(minors)
    rows = tuple(range(d))
    return np.stack([(-1) ** row * minors[_without(rows, row)] for row in rows])


def _expansion(minors: Minors, vector: Array, rows: tuple[int, ...]) -> Array:
    """Along the last vector."""
    total = vector[rows[-1]] * minors[rows[:-1]]
    for place, row in enumerate(rows[:-1]):
        term = vector[row] * minors[_without(rows, row)]
        total += term if (len(rows) - 1 - place) % 2 == 0 else -term
    return np.asarray(total)


def _without(rows: tuple[int, ...], row: int) -> tuple[int, ...]:
    return tuple(other for other in rows if other != row)
