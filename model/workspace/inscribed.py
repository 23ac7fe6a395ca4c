"""The largest circle, or screen of a given shape, all of whose poses are feasible.

A distance transform on a grid of poses finds where; then rays from the centre find how far the
exact margin stays positive, and linear programmes move the centre to where the shortest ray is
longest. Planar poses (rows, 2) [m].
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.ndimage import distance_transform_cdt, distance_transform_edt, label, maximum_position
from scipy.optimize.elementwise import find_root

from turnbuckle.model.workspace.grid import Grid
from turnbuckle.model.workspace.maps import Measure, evaluate
from turnbuckle.model.workspace.maximin import GAIN, climb
from turnbuckle.model.workspace.rows import Array

RAYS = 180
STEPS = 40  # along a ray, to find where the margin first becomes negative
ROUNDS = 4  # of rays ever closer to the points of contact
CLOSER = 9  # times closer with every round
MOST_CONTACTS = 8  # three determine a circle; two sides of a screen may touch all along
GRAZING = 0.05  # least sine between a ray and a boundary that it says something about


@dataclass(frozen=True)
class Inscribed:
    """The largest shape: centre (x, y) [m], half size [m] along each axis (of a circle, radii).

    accuracy [m]: what the last refinement still changed in the half height. Feasible poses that are
    in pieces, or holes in them, are told apart as far as the first grid resolves them.
    """

    centre: tuple[float, float]
    half_size: tuple[float, float]
    accuracy: float


@dataclass(frozen=True)
class _Outline:
    """A shape of half height 1: its outline at parameters (k) in [0, 1), as points (k, 2)."""

    points: Callable[[Array], Array]
    half_width: float
    distance: Callable[[npt.NDArray[np.bool_]], Array]


def largest_circle(
    margin: Measure, low: npt.ArrayLike, high: npt.ArrayLike, cells: int = 100
) -> Inscribed | None:
    """The largest circle of poses with margin >= 0 in the box from low to high (2) [m].

    `margin` takes poses (rows, 2) and gives (rows): NaN counts as infeasible. `cells`: of the first
    grid along the longer side. None where the grid has no feasible pose.
    """

    def points(t: Array) -> Array:
        return np.stack([np.cos(2 * np.pi * t), np.sin(2 * np.pi * t)], axis=-1)

    outline = _Outline(points, 1.0, distance_transform_edt)
    return _largest(margin, outline, np.asarray(low, float), np.asarray(high, float), cells)


def largest_screen(
    margin: Measure, low: npt.ArrayLike, high: npt.ArrayLike, aspect: float, cells: int = 100
) -> Inscribed | None:
    """The largest rectangle of `aspect` = width / height, sides along the axes; else as above."""

    def points(t: Array) -> Array:
        side, along = np.divmod(4 * np.mod(t, 1), 1)
        turn = np.exp(1j * np.pi / 2 * side) * (1 + 1j * (2 * along - 1))
        return np.stack([aspect * turn.real, turn.imag], axis=-1)

    def distance(feasible: npt.NDArray[np.bool_]) -> Array:
        return np.asarray(distance_transform_cdt(feasible, metric="chessboard"), np.float64)

    outline = _Outline(points, aspect, distance)
    return _largest(margin, outline, np.asarray(low, float), np.asarray(high, float), cells)


def _largest(
    margin: Measure, outline: _Outline, low: Array, high: Array, cells: int
) -> Inscribed | None:
    def inside(poses: Array) -> Array:
        """The margin, negative as well outside the box and where it is not defined."""
        edge = np.min(np.minimum(poses - low, high - poses), axis=-1)
        known = np.nan_to_num(margin(poses), nan=-1.0, posinf=1.0)
        return np.asarray(np.minimum(known, edge))

    cell = float(np.max((high - low) / [outline.half_width, 1])) / cells
    starts = _starts(inside, outline, low, high, cell)
    found = [_refined(inside, outline, *start, cell) for start in starts]
    return max(found, key=lambda shape: shape.half_size[1], default=None)


def _starts(
    inside: Measure, outline: _Outline, low: Array, high: Array, cell: float
) -> list[tuple[Array, float]]:
    """Centres and half heights to refine: the best of each group of nearly best cells."""
    step = cell * np.array([outline.half_width, 1])
    counts = np.maximum(1, np.ceil((high - low) / step)).astype(int)
    axes = [
        a + (np.arange(n) + 0.5) * (b - a) / n for a, b, n in zip(low, high, counts, strict=True)
    ]
    grid = Grid((axes[0], axes[1]))
    feasible = evaluate(inside, grid) >= 0
    if not np.any(feasible):
        return []
    distance = outline.distance(np.pad(feasible, 1))[1:-1, 1:-1]
    groups = label(distance >= np.max(distance) - 2)[0]
    best = np.array(maximum_position(distance, groups, range(1, np.max(groups) + 1)))
    return [
        (np.array([axes[0][i], axes[1][j]]), float(distance[i, j] * cell)) for i, j in best.tolist()
    ]


def _refined(
    inside: Measure, outline: _Outline, centre: Array, half: float, cell: float
) -> Inscribed:
    """Move the centre; then again with more rays about the points of contact, and again."""
    around = np.arange(RAYS) / RAYS
    window = 1 / RAYS
    t, scale = around, np.inf
    for _ in range(ROUNDS):
        last = scale
        centre, reach = _climb(inside, outline.points(t), centre, half + 3 * cell, cell)
        half = scale = float(np.min(reach))
        contacts = _contacts(t, reach)
        closer = contacts[:, None] + window * np.linspace(-1, 1, 2 * CLOSER + 1)
        t = np.unique(np.mod(np.concatenate([around, closer.ravel()]), 1))
        window /= CLOSER
    x, y = centre.tolist()
    return Inscribed((x, y), (scale * outline.half_width, scale), abs(last - scale) + GAIN * scale)


def _contacts(t: Array, reach: Array) -> Array:
    """Parameters of the shortest rays among those shorter than their neighbours."""
    valleys = np.flatnonzero((reach < np.roll(reach, 1)) & (reach <= np.roll(reach, -1)))
    return t[valleys[np.argsort(reach[valleys])[:MOST_CONTACTS]]]


def _climb(
    inside: Measure, rays: Array, centre: Array, most: float, cell: float
) -> tuple[Array, Array]:
    """The centre with the longest shortest ray near the given one, and its rays' lengths (k)."""

    def reach(centre: Array) -> Array:
        return _reach(inside, centre, rays, most)

    def slopes(centre: Array, reach: Array) -> Array:
        return _slopes(inside, centre, rays, np.where(reach < most, reach, np.nan), cell)

    return climb(reach, slopes, centre, cell)


def _reach(inside: Measure, centre: Array, rays: Array, most: float) -> Array:
    """How many times each ray (k, 2) fits between the centre and infeasible poses, up to `most`."""

    def along(scale: Array, x: Array, y: Array) -> Array:
        return inside(centre + scale[:, None] * np.stack([x, y], axis=-1))

    scales = most * np.arange(1, STEPS + 1) / STEPS
    poses = centre + scales[:, None, None] * rays
    beyond = inside(poses.reshape(-1, 2)).reshape(STEPS, -1) < 0
    reach = np.full(len(rays), most)
    ends = np.any(beyond, axis=0)
    outer = scales[np.argmax(beyond, axis=0)][ends]
    bracket = (outer - most / STEPS, outer)
    reach[ends] = find_root(along, bracket, args=tuple(rays[ends].T)).x
    return reach


def _slopes(inside: Measure, centre: Array, rays: Array, reach: Array, cell: float) -> Array:
    """How every ray's length changes with the centre (k, 2); NaN where the ray only grazes."""
    ends = centre + reach[:, None] * rays
    small = 1e-4 * cell
    columns = [inside(ends + side) - inside(ends - side) for side in small * np.eye(2)]
    gradient = np.stack(columns, axis=-1)
    across = np.sum(gradient * rays, axis=-1)
    size = np.linalg.norm(gradient, axis=-1) * np.linalg.norm(rays, axis=-1)
    crossing = (np.abs(across) > GRAZING * size)[:, None]
    unknown = np.full(gradient.shape, np.nan)
    return np.asarray(np.divide(-gradient, across[:, None], out=unknown, where=crossing))
