"""Whether tensions have the least norm, judged from the tensions alone."""

from collections.abc import Iterator
from itertools import combinations

import numpy as np
import numpy.typing as npt

from turnbuckle.model.reference.arrays import Array, as_floating, norm
from turnbuckle.model.reference.planar import inner_products, minors


def optimality_gap(
    structure: npt.ArrayLike, tension: npt.ArrayLike, lower: float, upper: float
) -> Array:
    """How far (...) [N] a tension is from the least norm among those that give its own wrench.

    The longest step towards a smaller norm along a self-stress, stopped at the bounds. Every
    self-stress that the bounds leave open is a sum of open ones of at most three cables, so those
    are enough: zero means optimal (the Karush-Kuhn-Tucker conditions, without multipliers).
    """
    structure, tension = as_floating(structure, tension)
    gap = np.zeros(tension.shape[:-1], tension.dtype)
    for stress in _self_stresses(np.swapaxes(structure, -1, -2)):
        slope = np.sum(stress * tension, axis=-1)
        downhill = -np.sign(slope)[..., None] * stress
        room = np.where(downhill > 0, upper - tension, tension - lower)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = np.where(downhill == 0, np.inf, np.maximum(room, 0) / np.abs(downhill))
        gap = np.maximum(gap, np.minimum(np.abs(slope), np.min(step, axis=-1)))
    return gap


def _self_stresses(cables: Array) -> Iterator[Array]:
    """Unit tension patterns (..., n) that give no wrench, with as few cables as possible."""
    count = cables.shape[-2]
    side, along = minors(cables), inner_products(cables)
    for i, j, k in combinations(range(count), 3):
        stress = np.zeros(cables.shape[:-1], cables.dtype)
        stress[..., i] = side[..., j, k]
        stress[..., j] = side[..., k, i]
        stress[..., k] = side[..., i, j]
        yield _unit_or_zero(stress)
    for i, j in combinations(range(count), 2):
        stress = np.zeros(cables.shape[:-1], cables.dtype)
        stress[..., i], stress[..., j] = along[..., j, j], -along[..., i, j]
        yield _unit_or_zero(np.where(side[..., i, j, None] == 0, stress, 0))


def _unit_or_zero(stress: Array) -> Array:
    size = norm(stress)[..., None]
    return np.divide(stress, size, out=np.zeros_like(stress), where=size > 0)
