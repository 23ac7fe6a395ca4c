"""Time of a pose in a map of margin and tension factor, and whether all maps are the same."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.bind import REALS, Generated
from turnbuckle.codegen.pose_map import Grid, PoseMap, target_grid
from turnbuckle.lab.benchmark.map.loop_map import loop_map
from turnbuckle.lab.benchmark.map.numpy_map import numpy_map
from turnbuckle.lab.benchmark.map.scene import Scene, scenes
from turnbuckle.lab.benchmark.tension_problems import Reals
from turnbuckle.lab.benchmark.timing import Timing, time_in_turn
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import quality

OURS, LARGE, NUMPY, LOOP = "turnbuckle", "turnbuckle, large", "NumPy", "quadprog and SciPy"
#: Poses a side of the small map that is compared with the reference.
JUDGED = 24

Maps = tuple[NDArray[np.floating[Any]], NDArray[np.floating[Any]]]


@dataclass(frozen=True)
class Mapper:
    """A way to draw a map, which is timed on a square grid of `side` x `side` poses.

    `draw` gives margin [N] and factor (poses) in parts, one after the other.
    """

    name: str
    note: str
    side: int
    draw: Callable[[Scene, Grid], Iterable[Maps]]


@dataclass(frozen=True)
class MapRow:
    """One way: time a pose, and how far margin and factor are from the reference's."""

    name: str
    note: str
    poses: int
    timing: Timing
    margin_error: float  # N
    factor_error: float

    @property
    def poses_per_second(self) -> float:
        """At the least time."""
        return 1e9 / self.timing.least


@dataclass(frozen=True)
class MapTable:
    """All ways to map one scene: ours in double precision first."""

    scene: str
    rows: list[MapRow]

    def ratio(self, name: str) -> float:
        """Least time a pose of one way, by ours."""
        times = {row.name: row.timing.least for row in self.rows}
        return times[name] / self.rows[0].timing.least


def mappers(machine: Machine, generated: Path) -> list[Mapper]:
    """Ours, in both precisions and once on a larger map, then what one would use instead."""
    double, single = (
        ours(PoseMap(Generated(machine, generated, precision))) for precision in REALS
    )
    return [
        Mapper(OURS, "double, status and self-check included", 512, double),
        Mapper(LARGE, "the same, 16 times the poses", 2048, double),
        Mapper("turnbuckle, float", "single precision", 512, single),
        Mapper(NUMPY, "vectorised: facets, all active sets", 256, peer(numpy_map)),
        Mapper(LOOP, "a quadratic program and a convex hull a pose", 24, peer(loop_map)),
    ]


def ours(pose_map: PoseMap) -> Callable[[Scene, Grid], Iterable[Maps]]:
    """Tile by tile, as a map is meant to be used."""

    def draw(scene: Scene, grid: Grid) -> Iterable[Maps]:
        for tile in pose_map.tiles(grid, rails=scene.rails, lag=scene.lag):
            yield tile.margin.ravel(), tile.factor.ravel()

    return draw


def peer(function: Callable[[Scene, Reals], Maps]) -> Callable[[Scene, Grid], Iterable[Maps]]:
    """A function of poses; they are laid out as it likes them."""

    def draw(scene: Scene, grid: Grid) -> Iterable[Maps]:
        yield function(scene, grid.poses(range(grid.rows)).reshape(grid.count, -1))

    return draw


def compare_maps(machine: Machine, generated: Path, repetitions: int) -> list[MapTable]:
    """Draw every scene in every way, in turn."""
    ways = mappers(machine, generated)
    return [compare(scene, ways, repetitions) for scene in scenes(machine)]


def compare(scene: Scene, ways: Sequence[Mapper], repetitions: int) -> MapTable:
    """Time all ways on one scene, and check what they draw."""
    runs = {way.name: partial(draw_all, scene, way) for way in ways}
    timings = time_in_turn(runs, 1, repetitions)
    reference = Reference.of(scene)
    rows = []
    for way in ways:
        count, timing = way.side**2, timings[way.name]
        a_pose = Timing(timing.least / count, timing.median / count)
        rows.append(MapRow(way.name, way.note, count, a_pose, *reference.errors(way)))
    return MapTable(scene.name, rows)


def draw_all(scene: Scene, way: Mapper) -> None:
    """Draw a map without keeping it."""
    for _ in way.draw(scene, target_grid(scene.machine, way.side, way.side)):
        pass


@dataclass(frozen=True)
class Reference:
    """What the independent reference draws of a scene: margin [N] and factor (poses)."""

    scene: Scene
    grid: Grid
    margin: Reals
    factor: Reals

    @classmethod
    def of(cls, scene: Scene) -> "Reference":
        """A small map."""
        machine = scene.machine
        grid = target_grid(machine, JUDGED, JUDGED)
        poses = grid.poses(range(grid.rows)).reshape(grid.count, -1)
        rails = scene.rails_at(poses)
        factor = np.nan_to_num(np.asarray(quality.tension_factor(machine, poses, rails), float))
        margin = np.asarray(quality.capacity_margin(machine, poses, rails), float)
        return cls(scene, grid, margin, factor)

    def errors(self, way: Mapper) -> tuple[float, float]:
        """Largest errors of margin [N] and factor that a way makes."""
        margin, factor = map(np.concatenate, zip(*way.draw(self.scene, self.grid), strict=True))
        return (
            float(np.max(np.abs(margin - self.margin))),
            float(np.max(np.abs(factor - self.factor))),
        )
