"""Pose quality over planes through the target's centre, upright and at the worst rotations."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import reduce
from itertools import combinations

import numpy as np

from turnbuckle.model.machine import Machine
from turnbuckle.model.workspace.bases import lagging_force
from turnbuckle.model.workspace.grid import target_grid
from turnbuckle.model.workspace.quality import PoseQuality, pose_quality
from turnbuckle.model.workspace.rows import Array
from turnbuckle.model.workspace.summary import wanted_turns

Progress = Callable[[str, float], None]

AXES = "xyz"
CELLS = {(2, False): 180, (2, True): 150, (3, False): 80, (3, True): 32}
"""Along the longest side, by the dimension of the space and whether the platform turns."""


@dataclass(frozen=True)
class Slice:
    """The plane of two axes through `centre` (space) [m]; x and y are the middles of its cells."""

    axes: tuple[int, int]
    centre: tuple[float, ...]
    x: Array
    y: Array

    def poses(self, turn: Array) -> Array:
        """Poses (rows, columns, d) of all cells, turned alike by `turn` (d - space) [rad]."""
        columns, rows = np.meshgrid(self.x, self.y)
        poses = np.empty((*rows.shape, len(self.centre) + len(turn)))
        poses[...] = (*self.centre, *turn)
        poses[..., self.axes[0]], poses[..., self.axes[1]] = columns, rows
        return poses

    @property
    def title(self) -> str:
        """Its axes, and the height at which it lies; nothing for the plane of a planar machine."""
        rest = [k for k in range(len(self.centre)) if k not in self.axes]
        names = "".join(AXES[k] for k in self.axes)
        heights = ", ".join(f"{AXES[k]} = {self.centre[k] * 1e3:.4g} mm" for k in rest)
        return f"{names} at {heights}" if rest else ""


@dataclass(frozen=True)
class Panel:
    """The quality (rows, columns) of a slice; `orientation` in words, "" for points."""

    machine: Machine
    plane: Slice
    orientation: str
    quality: PoseQuality

    @property
    def title(self) -> str:
        """Which slice and orientation it is."""
        return ", ".join(filter(None, [self.plane.title, self.orientation]))


@dataclass(frozen=True)
class LagPanel:
    """I_F (rows, columns) [N] of a slice, upright, with the bases `lag` [m] behind."""

    machine: Machine
    plane: Slice
    lag: float
    force: Array

    @property
    def title(self) -> str:
        """Which slice it is."""
        return ", ".join(filter(None, [self.plane.title, "upright" * self.machine.is_rigid]))


def slices(machine: Machine) -> list[Slice]:
    """xy; in space xz and yz as well: near-square cells over the whole frame."""
    size, most = machine.frame.size, CELLS[machine.space, machine.is_rigid]
    cell = max(size) / most
    counts = [max(1, round(side / cell)) for side in size]
    middles = [(np.arange(n) + 0.5) * side / n for side, n in zip(size, counts, strict=True)]
    return [
        Slice((a, b), machine.target.centre, middles[a], middles[b])
        for a, b in combinations(range(machine.space), 2)
    ]


def panels(machine: Machine, progress: Progress) -> list[Panel]:
    """All slices upright, then all at the worst of the wanted rotations, if there are any."""
    upright = np.zeros(machine.dof - machine.space)
    turns = list(_turns(machine))
    planes = slices(machine)
    found, done, total = [], 0, len(planes) * (1 + len(turns))
    for words, choice in (("upright", [upright]), (_turned_words(machine), turns)):
        for plane in planes if choice else []:
            qualities = []
            for turn in choice:
                progress("mapping", done / total)
                qualities.append(pose_quality(machine, plane.poses(turn)))
                done += 1
            orientation = words if machine.is_rigid else ""
            found.append(Panel(machine, plane, orientation, reduce(worse, qualities)))
    return found


def lag_panels(machine: Machine, lag: float, progress: Progress) -> list[LagPanel]:
    """All slices upright with late bases; none where no base moves."""
    if not machine.rails:
        return []
    found = []
    planes = slices(machine)
    upright = np.zeros(machine.dof - machine.space)
    for number, plane in enumerate(planes):
        progress("mapping late bases", number / len(planes))
        poses = plane.poses(upright)
        force = lagging_force(machine, poses.reshape(-1, machine.dof), lag)
        found.append(LagPanel(machine, plane, lag, force.reshape(poses.shape[:-1])))
    return found


def worse(one: PoseQuality, other: PoseQuality) -> PoseQuality:
    """The worse of two at every pose; not defined where either is not."""
    return PoseQuality(
        margin=np.minimum(one.margin, other.margin),
        zero_margin=np.minimum(one.zero_margin, other.zero_margin),
        force=np.minimum(one.force, other.force),
        tension_factor=np.minimum(one.tension_factor, other.tension_factor),
        needed_tension=np.maximum(one.needed_tension, other.needed_tension),
        closure=one.closure & other.closure,
        conditioning=np.minimum(one.conditioning, other.conditioning),
    )


def _turns(machine: Machine) -> Iterator[Array]:
    """The wanted rotations (d - space) [rad] that are tried; none where none are wanted."""
    if machine.target.rotation:
        grid = target_grid(machine, [1] * machine.space, wanted_turns(machine))
        yield from grid.poses()[:, machine.space :]


def _turned_words(machine: Machine) -> str:
    return f"worst within ±{np.degrees(machine.target.rotation):.4g}°"
