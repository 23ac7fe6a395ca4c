"""The facets of the set of wrenches {S T, lower <= T <= upper}: a zonotope, for any d and n.

A facet of the zonotope is parallel to d - 1 cables, so its normal is their generalised cross
product (Bouchard, Gosselin and Moore 2010). The set reaches upper * pull - lower * push along a
normal p, with pull the sum of the positive parts of p . s_i and push that of the negative parts:
the bounds enter only here, so one set of facets serves all bounds.

That is true of every direction p, not of facets only. A direction more than needed, or one that
rounding turned, is therefore a true bound on the set as well: it cannot make it smaller.
"""

from collections.abc import Callable
from functools import cache
from itertools import combinations
from math import comb
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from turnbuckle.model.workspace.rows import Array, in_chunks

ROUNDINGS = 32  # a sum over the cables may be off by this many units in its last place
NEARLY_FLAT = np.sqrt(np.finfo(np.float64).eps)  # least singular value of S over its largest
SUSPECT = NEARLY_FLAT  # det(S S') over its largest for that trace: above NEARLY_FLAT squared


class Facets(NamedTuple):
    """Unit normals (rows, f, d), one of each antiparallel pair; pull and push (rows, f)."""

    normals: Array
    pull: Array
    push: Array

    def supports(self, lower: float, upper: float) -> tuple[Array, Array]:
        """How far [N] the set reaches along every normal, and against it (rows, f)."""
        return upper * self.pull - lower * self.push, upper * self.push - lower * self.pull

    def support(self, lower: float, upper: float) -> Array:
        """The smaller of the two supports (rows, f) [N]: all that counts for symmetric demands."""
        return np.asarray(upper * self.weaker - lower * self.stronger)

    @property
    def weaker(self) -> Array:
        """The smaller of pull and push (rows, f)."""
        return np.minimum(self.pull, self.push)

    @property
    def stronger(self) -> Array:
        """The larger of pull and push (rows, f)."""
        return np.maximum(self.pull, self.push)


def over_facets(
    measure: Callable[..., npt.NDArray[np.float64]],
    structure: npt.ArrayLike,
    *inputs: tuple[npt.ArrayLike, int],
) -> Array:
    """`measure` of the facets of every structure matrix (..., d, n), in bounded memory.

    The measure gets `Facets`, the structure matrices (rows, d, n), and the further inputs, each
    given with its number of trailing axes that are not batch axes; it returns (rows, ...). NaN in
    a structure matrix goes through to its facets.
    """
    *_, d, n = np.shape(structure)

    def measured(s: Array, *others: Array) -> Array:
        flat = _is_nearly_flat(s)
        if not np.any(flat):
            return measure(_facets(s, _spanned_normals(s)), s, *others)
        parts = []
        for rows, normals_of in ((~flat, _spanned_normals), (flat, _flat_normals)):
            own = s[rows]
            if own.size:
                found = measure(_facets(own, normals_of(own)), own, *(o[rows] for o in others))
                parts.append((rows, found))
        result = np.empty((len(s), *parts[0][1].shape[1:]))
        for rows, found in parts:
            result[rows] = found
        return result

    return in_chunks(measured, _floats_per_row(d, n), (structure, 2), *inputs)


def rounding(structure: Array, upper: float) -> Array:
    """What rounding can add to a wrench of tensions up to `upper` (...) [N]."""
    most = upper * np.sum(np.sqrt(np.sum(structure**2, axis=-2)), axis=-1)
    return np.asarray(ROUNDINGS * np.finfo(np.float64).eps * most)


def _floats_per_row(d: int, n: int) -> int:
    return 4 * (d + 2) * comb(n, d - 1) + n * d


def _facets(structure: Array, normals: Array) -> Facets:
    """Supports of the directions, summed cable by cable: an array (rows, f, n) is never held."""
    pull = np.zeros(normals.shape[:-1])
    push = np.zeros(normals.shape[:-1])
    for cable in np.moveaxis(structure, -1, 0):
        along = np.einsum("rfd,rd->rf", normals, cable)
        pull += np.maximum(along, 0)
        push += np.maximum(-along, 0)
    return Facets(normals, pull, push)


def _spanned_normals(structure: Array) -> Array:
    """Unit vectors (rows, f, d) normal to d - 1 cables: all facets of a set with an inside.

    Cables that are dependent, up to rounding, span no facet; one of the other facets takes their
    place. If all are, the normals are those of rounding, and the set is flat.
    """
    d, n = structure.shape[-2:]
    product = _wedge_products(np.ascontiguousarray(np.moveaxis(structure, 0, -1)))
    signs = np.asarray([(-1.0) ** i for i in range(d)])
    normals = product[::-1].transpose(2, 1, 0) * signs  # the choice of rows k lacks d - 1 - k
    length = np.sqrt(np.sum(normals**2, axis=-1))
    size = np.sqrt(np.sum(structure**2, axis=-2))
    largest = np.prod(size[:, _choices(n, d - 1)], axis=-1)
    dependent = length <= ROUNDINGS * np.finfo(np.float64).eps * largest
    if np.any(dependent):
        rows, facets = np.nonzero(dependent)
        other = np.argmax(length, axis=-1)[rows]
        normals[rows, facets], length[rows, facets] = normals[rows, other], length[rows, other]
    normals[length == 0] = np.eye(d)[0]
    length[length == 0] = 1
    return np.asarray(normals / length[..., None])


@cache
def _choices(n: int, size: int) -> npt.NDArray[np.intp]:
    """All choices of so many columns (C(n, size), size)."""
    return np.array(list(combinations(range(n), size)), np.intp)


def _wedge_products(cables: Array) -> Array:
    """Minors (d, C(n, d-1), rows) of all d - 1 columns of (d, n, rows), expanded by columns.

    The minors of k columns come from those of k - 1, so work shared by many facets is done once.
    """
    d, n, rows = cables.shape
    minors = np.ones((1, 1, rows))
    for size in range(1, d):
        last, others = _columns(n, size)
        column, smaller = cables[:, last], minors[:, others]
        minors = np.zeros((comb(d, size), len(last), rows))
        for minor, terms in zip(minors, _expansion(d, size), strict=True):
            for sign, row, rest in terms:
                minor += sign * column[row] * smaller[rest]
    return minors


@cache
def _columns(n: int, size: int) -> tuple[list[int], list[int]]:
    """For every choice of columns: the last one, and the index of the choice of the others."""
    index = {chosen: k for k, chosen in enumerate(combinations(range(n), size - 1))}
    choices = list(combinations(range(n), size))
    return [chosen[-1] for chosen in choices], [index[chosen[:-1]] for chosen in choices]


@cache
def _expansion(d: int, size: int) -> list[list[tuple[float, int, int]]]:
    """For every choice of rows, the terms along the last column: sign, row, index of the rest."""
    index = {chosen: k for k, chosen in enumerate(combinations(range(d), size - 1))}
    return [
        [
            ((-1.0) ** (size - 1 - j), row, index[chosen[:j] + chosen[j + 1 :]])
            for j, row in enumerate(chosen)
        ]
        for chosen in combinations(range(d), size)
    ]


def _is_nearly_flat(structure: Array) -> npt.NDArray[np.bool_]:
    """Whether the set of wrenches is as good as flat, or singular (rows); False for NaN.

    The determinant sifts out most rows for less than a singular value decomposition costs.
    """
    d = structure.shape[-2]
    gram = structure @ np.swapaxes(structure, -1, -2)
    largest = (np.trace(gram, axis1=-2, axis2=-1) / d) ** d
    with np.errstate(invalid="ignore"):
        flat = np.asarray(np.linalg.det(gram) <= SUSPECT * largest)
    if np.any(flat):
        values = np.linalg.svd(structure[flat], compute_uv=False)
        flat[flat] = values[..., -1] <= NEARLY_FLAT * values[..., 0]
    return flat


def _flat_normals(structure: Array) -> Array:
    """Directions (rows, f, d) that describe a set of wrenches of any dimension.

    A set of dimension k lies in the span of the first k left singular vectors of S. Its facets are
    those of its image there; the other singular vectors say that it reaches no further. All k are
    taken, so nothing hangs on where a rank is said to drop.
    """
    left = np.linalg.svd(structure)[0]
    directions = [_spanned_normals(structure), np.swapaxes(left, -1, -2)]
    for k in range(1, structure.shape[-2]):
        basis = left[..., :k]
        image = np.swapaxes(basis, -1, -2) @ structure
        directions.append(_spanned_normals(image) @ np.swapaxes(basis, -1, -2))
    return np.concatenate(directions, axis=-2)
