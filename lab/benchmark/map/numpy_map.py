"""The map in vectorised NumPy: facets in closed form, T0 by all active sets at once, exactly.

For planar machines with any number of cables, as ours. Arrays are (n, poses), a few thousand poses
at a time, so that they stay in the processor's cache.
"""

from collections.abc import Iterator
from itertools import combinations, product

import numpy as np

from turnbuckle.lab.benchmark.map.scene import Scene
from turnbuckle.lab.benchmark.tension_problems import Reals

#: Poses that are worked on at once: the quickest of 1 000 to 64 000.
CHUNK = 8192
#: What rounding may put a tension outside its bounds by, as part of T_max.
SLACK = 1e-12


def numpy_map(scene: Scene, poses: Reals) -> tuple[Reals, Reals]:
    """Margin [N] and factor (count) of poses (count, 2)."""
    margin, factor = np.empty(len(poses)), np.zeros(len(poses))
    for start in range(0, len(poses), CHUNK):
        part = slice(start, start + CHUNK)
        x, y = directions(scene, poses[part])
        margin[part] = facet_margin(scene, x, y)
        inside = np.flatnonzero(margin[part] >= 0)
        if len(inside) < x.shape[1]:
            x, y = x[:, inside], y[:, inside]
        factor[start + inside] = tension_factor(scene, x, y)
    return margin, factor


def directions(scene: Scene, poses: Reals) -> tuple[Reals, Reals]:
    """Both components (n, count) of the unit vectors along the cables."""
    points = scene.base_points(poses)
    x, y = points[0] - poses[:, 0], points[1] - poses[:, 1]
    scale = 1 / np.sqrt(x * x + y * y)
    return x * scale, y * scale


def facet_margin(scene: Scene, x: Reals, y: Reals) -> Reals:
    """Least distance (count) of the zero wrench from a facet [N]."""
    bounds = scene.machine.tension
    mean, half = (bounds.max + bounds.min) / 2, (bounds.max - bounds.min) / 2
    reach = np.zeros_like(x)
    for i, j in combinations(range(len(x)), 2):
        sine = np.abs(x[i] * y[j] - y[i] * x[j])
        reach[i] += sine
        reach[j] += sine
    centre = np.abs(x * (mean * y.sum(axis=0)) - y * (mean * x.sum(axis=0)))
    return np.asarray(np.min(half * reach - centre, axis=0))


def tension_factor(scene: Scene, x: Reals, y: Reals) -> Reals:
    """TF (count) of the least of all tensions with at most n - 2 cables at a bound."""
    low, high = scene.machine.tension.min, scene.machine.tension.max
    square, factor = np.full(x.shape[1], np.inf), np.zeros(x.shape[1])
    with np.errstate(all="ignore"):  # cables that do not span the plane give no candidate
        for tension in candidates(x, y, (low, high)):
            least, most = np.min(tension, axis=0), np.max(tension, axis=0)
            size = np.einsum("ik,ik->k", tension, tension)
            fits = (least >= low - SLACK * high) & (most <= high + SLACK * high)
            better = fits & (size < square)
            np.copyto(square, size, where=better)
            np.copyto(factor, least / most, where=better)
    return factor


def candidates(x: Reals, y: Reals, bounds: tuple[float, float]) -> Iterator[Reals]:
    """Tensions (n, count) without a wrench: some cables at bounds, the others of least norm.

    T_i = sum_j (s_i x s_j)(w x s_j) / sum of the squared minors, for the wrench w that is missing.
    The array is used again for the next one.
    """
    cables = range(len(x))
    tension = np.empty_like(x)
    minor = {(i, j): x[i] * y[j] - y[i] * x[j] for i, j in combinations(cables, 2)}
    minor |= {(j, i): -value for (i, j), value in minor.items()}
    for count in range(1, len(x) - 1):
        for held in combinations(cables, count):
            free = [i for i in cables if i not in held]
            weight = 1 / sum(minor[pair] ** 2 for pair in combinations(free, 2))
            for values in product(bounds, repeat=count):
                for i, value in zip(held, values, strict=True):
                    tension[i] = value
                # w x s_j, as w is less the wrench of those at bounds
                moment = {
                    j: sum(v * minor[j, i] for i, v in zip(held, values, strict=True)) * weight
                    for j in free
                }
                for i in free:
                    tension[i] = sum(minor[i, j] * moment[j] for j in free if j != i)
                yield tension
