"""Tension capable workspace (TCW): where every force up to F needs at most t_max (Brau section 4).

Brau takes t_min = 0. Then only the ratio F / t_max counts, and for three or four fixed cables of a
planar point the boundary consists of arcs of circles (eqs 21, 22). For anything else, and for
t_min > 0, the facets decide: `feasible.ball_margin`, or `force.isotropic_force` with the bounds 0
and 1, which is the largest ratio of a pose. A TCW may be empty; that is a result.
"""

from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np
import numpy.typing as npt

from model.workspace.feasible import wrench_closure
from model.workspace.gaps import adjacent_gaps
from model.workspace.rows import Array

HALVINGS = 52  # of the ratio, from 1 to its last place
ROUNDING = 64 * np.finfo(np.float64).eps  # of an angle [rad]
SAME_POINT = np.sqrt(np.finfo(np.float64).eps)  # crossings of almost tangent arcs are that inexact


def largest_angle(ratio: float) -> float:
    """theta_max [rad] between neighbouring cables for F / t_max = ratio <= 1 (Brau eq. 21)."""
    return float(np.pi - np.arcsin(ratio))


def capable_by_gap(structure: npt.ArrayLike, ratio: float) -> npt.NDArray[np.bool_]:
    """Whether poses (...) of a planar point are tension capable, by their largest gap (t_min = 0).

    Exact for three and four cables; five and more may be capable with a larger gap as well.
    """
    if ratio > 1:
        return np.zeros(np.shape(structure)[:-2], np.bool_)
    gap = np.max(adjacent_gaps(structure)[1], axis=-1)
    return np.asarray(gap <= largest_angle(ratio))


def capable_ratio_eq23(structure: npt.ArrayLike) -> Array:
    """Largest F / t_max (...) of a spatial point with four cables (..., 3, 4), t_min = 0.

    Brau eq. 23 with the smallest of |u_i, u_j, u_k| / |u_i x u_j| over distinct i, j, k in place of
    the largest. 0 outside the tetrahedron of the pulleys.
    """
    u = np.swapaxes(np.asarray(structure, np.float64), -1, -2)
    ratios = []
    for i, j in combinations(range(4), 2):
        normal = np.cross(u[..., i, :], u[..., j, :])
        area = np.sqrt(np.sum(normal**2, axis=-1))
        for k in set(range(4)) - {i, j}:
            volume = np.abs(np.sum(normal * u[..., k, :], axis=-1))
            ratios.append(np.divide(volume, area, out=np.zeros_like(area), where=area != 0))
    return np.where(wrench_closure(structure), np.min(ratios, axis=0), 0)


def largest_circle_eq22(circumradius: float, ratio: float) -> float:
    """Radius [m] of the largest circle in the TCW of an equilateral triangle (Brau eq. 22).

    circumradius [m] of the triangle. Where it is negative, from a ratio of sqrt(3)/2 on, there is
    no circle: the TCW is empty.
    """
    tangent = np.tan((np.pi - largest_angle(ratio)) / 2)
    return float(circumradius * (1 - np.sqrt(3) * tangent) / 2)


@dataclass(frozen=True)
class Arc:
    """A piece of a circle: centre [m], radius [m], first angle and signed sweep [rad]."""

    centre: tuple[float, float]
    radius: float
    start: float
    sweep: float

    def points(self, share: npt.ArrayLike) -> Array:
        """Points (..., 2) [m] at shares (...) of the sweep, from 0 to 1."""
        angle = self.start + np.asarray(share, np.float64) * self.sweep
        around = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        return np.asarray(self.centre + self.radius * around)

    @property
    def swept_area(self) -> float:
        """Half the integral of x dy - y dx along the arc [m^2]: their sum is a region's area."""
        first, last = self.points(0.0), self.points(1.0)
        x, y = last - first
        chord = self.centre[0] * y - self.centre[1] * x
        return float(self.radius**2 * self.sweep + chord) / 2

    def part(self, begin: float, end: float) -> "Arc":
        """The arc between two shares of its sweep."""
        return Arc(
            self.centre, self.radius, self.start + begin * self.sweep, (end - begin) * self.sweep
        )


@dataclass(frozen=True)
class CapableRegion:
    """The TCW of three or four fixed pulleys for a ratio F / t_max, with its exact boundary.

    The arcs run counter-clockwise around it; area [m^2]; share of the polygon of the pulleys,
    which is the theoretical workspace; best_ratio, the largest that leaves a TCW.
    """

    ratio: float
    arcs: tuple[Arc, ...]
    area: float
    share: float
    best_ratio: float

    def __str__(self) -> str:
        if not self.arcs:
            return (
                f"the tension capable workspace is empty: F / t_max = {self.ratio:.4g} is wanted"
                f" in every direction, and no pose gives more than {self.best_ratio:.4g}"
            )
        return (
            f"F / t_max = {self.ratio:.4g} is given in every direction"
            f" on {self.share:.2%} of the theoretical workspace"
        )


def capable_region(pulleys: npt.ArrayLike, ratio: float) -> CapableRegion:
    """The TCW of a planar point with pulleys (n, 2) [m], n = 3 or 4, for t_min = 0 (Brau 4.1, 4.3).

    Each two neighbouring pulleys see the platform under at most theta_max: outside the circle
    through them with that inscribed angle. ValueError where the pulleys are not 3 or 4 corners of
    a convex polygon, or the ratio is not positive: then the boundary is no such set of arcs.
    """
    corners = _convex_corners(np.asarray(pulleys, np.float64))
    if not ratio > 0:
        raise ValueError(f"F / t_max is {ratio}; allowed: a positive number")
    arcs = _boundary(corners, ratio)
    area = sum(arc.swept_area for arc in arcs)
    return CapableRegion(ratio, arcs, area, area / _polygon_area(corners), _best_ratio(corners))


def _convex_corners(pulleys: Array) -> Array:
    """The pulleys counter-clockwise."""
    if pulleys.shape not in ((3, 2), (4, 2)):
        raise ValueError(f"pulleys have shape {pulleys.shape}; allowed: (3, 2) or (4, 2)")
    about = pulleys - np.mean(pulleys, axis=0)
    corners = pulleys[np.argsort(np.arctan2(about[:, 1], about[:, 0]))]
    edge = np.roll(corners, -1, axis=0) - corners
    if np.any(_cross(edge, np.roll(edge, -1, axis=0)) <= 0):
        raise ValueError("pulleys are not the corners of a convex polygon")
    return corners


def _boundary(corners: Array, ratio: float) -> tuple[Arc, ...]:
    if ratio > 1:
        return ()
    arcs = [
        _arc_over(begin, end, ratio)
        for begin, end in zip(corners, np.roll(corners, -1, axis=0), strict=True)
    ]
    pieces = []
    for arc in arcs:
        cuts = sorted({0.0, 1.0, *(cut for other in arcs for cut in _crossings(arc, other))})
        pieces += [
            arc.part(first, last) for first, last in pairwise(cuts) if last - first > SAME_POINT
        ]
    return tuple(piece for piece in pieces if _is_capable(piece.points(0.5), corners, ratio))


def _arc_over(begin: Array, end: Array, ratio: float) -> Arc:
    """The points inside the polygon that see the edge under theta_max, from begin to end.

    The centre lies beyond the edge, so that the arc is less than half a circle, run clockwise.
    """
    edge = end - begin
    half = np.arcsin(ratio)
    outward = np.array([edge[1], -edge[0]])
    centre = (begin + end) / 2 + outward * (np.sqrt(1 - ratio**2) / (2 * ratio))
    x, y = begin - centre
    radius = float(np.hypot(x, y))
    return Arc((float(centre[0]), float(centre[1])), radius, float(np.arctan2(y, x)), -2 * half)


def _crossings(arc: Arc, other: Arc) -> list[float]:
    """Shares of the arc's sweep, inside it, where it meets the other arc's circle."""
    x, y = np.subtract(other.centre, arc.centre)
    distance = float(np.hypot(x, y))
    if distance == 0:
        return []
    along = (distance**2 + arc.radius**2 - other.radius**2) / (2 * distance * arc.radius)
    if abs(along) >= 1:
        return []
    turns = [np.arctan2(y, x) + side * np.arccos(along) - arc.start for side in (1, -1)]
    shares = [float(-np.mod(-turn, 2 * np.pi) / arc.sweep) for turn in turns]
    return [share for share in shares if 0 < share < 1]


def _is_capable(point: Array, corners: Array, ratio: float) -> bool:
    """Whether no two neighbouring pulleys are seen under more than theta_max."""
    reach = corners - point
    following = np.roll(reach, -1, axis=0)
    angle = np.arctan2(_cross(reach, following), np.sum(reach * following, axis=-1))
    return bool(np.all((angle > 0) & (angle <= largest_angle(ratio) + ROUNDING)))


def _best_ratio(corners: Array) -> float:
    """The largest ratio that leaves a TCW, by halving: a smaller ratio leaves a larger TCW."""
    low, high = 0.0, 1.0
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if _boundary(corners, middle) else (low, middle)
    return low


def _polygon_area(corners: Array) -> float:
    return float(np.sum(_cross(corners, np.roll(corners, -1, axis=0)))) / 2


def _cross(a: Array, b: Array) -> Array:
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])
