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

from turnbuckle.model.workspace.feasible import feasible, wrench_closure
from turnbuckle.model.workspace.force import isotropic_force
from turnbuckle.model.workspace.gaps import adjacent_gaps
from turnbuckle.model.workspace.rows import Array

HALVINGS = 52  # of the ratio, from 1 to its last place
SAME_POINT = 64 * np.finfo(np.float64).eps  # in shares of an arc
SHALLOW = 0.01  # [rad]: of smaller segments, the area by formula would be rounding


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
    """An arc of a circle from begin to end (x, y) [m], bulging to the left of its chord.

    angle [rad]: between chord and arc at either end, half of what the arc sweeps about its centre.
    Nothing here divides by the arc's height, so that next to straight arcs are as exact as others.
    """

    begin: tuple[float, float]
    end: tuple[float, float]
    angle: float

    @property
    def chord(self) -> Array:
        """From begin to end (2) [m]."""
        return np.subtract(self.end, self.begin)

    @property
    def radius(self) -> float:
        """Radius [m]."""
        return float(np.hypot(*self.chord) / (2 * np.sin(self.angle)))

    @property
    def centre(self) -> tuple[float, float]:
        """Centre (x, y) [m]."""
        x, y = self.chord / 2
        height = 1 / np.tan(self.angle)
        return float(self.begin[0] + x + y * height), float(self.begin[1] + y - x * height)

    def points(self, share: npt.ArrayLike) -> Array:
        """Points (..., 2) [m] at shares (...) of the arc, from 0 to 1."""
        run = np.asarray(share, np.float64)
        reach = np.sin(run * self.angle) / np.sin(self.angle)
        turn = (1 - run) * self.angle
        x, y = self.chord
        ahead = np.cos(turn) * x - np.sin(turn) * y
        aside = np.sin(turn) * x + np.cos(turn) * y
        return np.asarray(self.begin + np.stack([reach * ahead, reach * aside], axis=-1))

    def part(self, first: float, last: float) -> "Arc":
        """The arc between two shares of it."""
        (x, y), (u, v) = self.points([first, last]).tolist()
        return Arc((x, y), (u, v), (last - first) * self.angle)

    @property
    def swept_area(self) -> float:
        """Half the integral of x dy - y dx along the arc [m^2]; summed up, a region's area."""
        sweep = 2 * self.angle
        if sweep < SHALLOW:  # sweep - sin(sweep) in powers of it
            bulge = sweep**3 / 6 * (1 - sweep**2 / 20 * (1 - sweep**2 / 42))
        else:
            bulge = sweep - np.sin(sweep)
        chord = self.begin[0] * self.end[1] - self.begin[1] * self.end[0]
        return float(chord - self.radius**2 * bulge) / 2


@dataclass(frozen=True)
class Capability:
    """How much is tension capable at a ratio F / t_max: its share, and the best ratio of all."""

    ratio: float
    share: float
    best_ratio: float

    def __str__(self) -> str:
        if self.share == 0:
            return (
                f"the tension capable workspace is empty: F / t_max = {self.ratio:.4g} is wanted"
                f" in every direction, and no pose gives more than {self.best_ratio:.4g}"
            )
        return f"F / t_max = {self.ratio:.4g} is given in every direction on {self.share:.2%}"


@dataclass(frozen=True)
class CapableRegion(Capability):
    """The TCW of three or four fixed pulleys for a ratio F / t_max, with its exact boundary.

    `share` is of the polygon of the pulleys, which is the theoretical workspace. The arcs run
    counter-clockwise around the TCW; area [m^2].
    """

    arcs: tuple[Arc, ...]
    area: float

    def __str__(self) -> str:
        text = super().__str__()
        return text + " of the theoretical workspace" if self.arcs else text


def capability(
    structure: npt.ArrayLike, lower: float, upper: float, force: float, space: int | None = None
) -> Capability:
    """How many of the poses (rows, d, n) give `force` [N] in every direction, for any machine.

    Bounds [N], `space` as for `force.isotropic_force`. Poses on a pulley do not count as capable.
    """
    s = np.asarray(structure, np.float64)
    strength = np.nan_to_num(isotropic_force(s, lower, upper, space), nan=0.0)
    capable = feasible(strength - force, s, upper, force)
    best = float(np.max(strength, initial=0.0))
    return Capability(force / upper, float(np.mean(capable)), best / upper)


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
    share = area / _polygon_area(corners)
    return CapableRegion(ratio, share, _best_ratio(corners), arcs, area)


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
    """The arcs over the edges, cut where they meet, without what other edges rule out."""
    if ratio > 1:
        return ()
    ends = [(x, y) for x, y in corners.tolist()]
    angle = float(np.arcsin(ratio))
    arcs = [Arc(a, b, angle) for a, b in pairwise([*ends, ends[0]])]
    pieces = []
    for edge, arc in enumerate(arcs):
        others = [other for other in arcs if other is not arc]
        cuts = sorted({0.0, 1.0, *(cut for other in others for cut in _crossings(arc, other))})
        for first, last in pairwise(cuts):
            middle = arc.points((first + last) / 2)
            if last - first > SAME_POINT and _others_allow(middle, corners, edge, ratio):
                pieces.append(arc.part(first, last))
    return tuple(pieces)


def _crossings(arc: Arc, other: Arc) -> list[float]:
    """Shares of the arc, inside it, where it meets the circle of another arc of the same angle.

    The difference of both circles' equations is linear; on the arc it is quadratic in
    v = tan(share angle), and exactly 0 at v = 0 where the arcs share this corner.
    """
    here, slope = _circle(other, arc.begin)
    slope = slope - _circle(arc, arc.begin)[1]
    along, across = (float(slope @ side) for side in (arc.chord, _turned(arc.chord)))
    sine, cosine = np.sin(arc.angle), np.cos(arc.angle)
    quadratic = [here + along - across * cosine / sine, along * cosine / sine + across, here]
    roots = np.roots(quadratic)
    shares = np.arctan(roots[np.isreal(roots)].real) / arc.angle
    return [share for share in shares.tolist() if 0 < share < 1]


def _circle(arc: Arc, point: tuple[float, float]) -> tuple[float, Array]:
    """What is zero on an arc's circle, with value and gradient (2) at a point.

    The sine of the angle under which the point sees the chord, beyond that of the arc, times both
    distances.
    """
    first, last = np.subtract(arc.begin, point), np.subtract(arc.end, point)
    sine, cosine = np.sin(arc.angle), np.cos(arc.angle)
    value = float(_cross(first, last) * cosine + np.sum(first * last) * sine)
    return value, _turned(last - first) * cosine - (first + last) * sine


def _others_allow(point: Array, corners: Array, edge: int, ratio: float) -> bool:
    """Whether a point over one edge is in the polygon, and sees no other edge under too much."""
    reach = corners - point
    following = np.roll(reach, -1, axis=0)
    angle = np.delete(
        np.arctan2(_cross(reach, following), np.sum(reach * following, axis=-1)), edge
    )
    return bool(np.all((angle > 0) & (angle <= largest_angle(ratio))))


def _turned(vector: Array) -> Array:
    """A quarter to the left."""
    return np.array([-vector[1], vector[0]])


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
