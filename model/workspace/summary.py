"""A machine's target in numbers: is all of it served, how strongly, and by which motors."""

from dataclasses import dataclass
from math import comb
from typing import NamedTuple

import numpy as np

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.workspace.actuators import ActuatorChoice, choose_actuators
from turnbuckle.model.workspace.bases import lagging_force
from turnbuckle.model.workspace.grid import Grid, Progress, target_grid
from turnbuckle.model.workspace.quality import (
    PoseQuality,
    pose_quality,
    possible_share,
    wanted_margin,
)
from turnbuckle.model.workspace.rows import Array

# Poses along the longest side, by the dimension of the space and whether the platform turns.
PER_LONGEST_SIDE = {(2, False): 101, (2, True): 61, (3, False): 21, (3, True): 9}
TURNS = {2: 5, 3: 3}  # angles about every axis, by the dimension of the space
COARSE_COUNTS = [*((count, 3) for count in range(21, 2, -2)), (2, 2)]  # poses a side, angles
COARSE_FACETS = 1 << 18  # of all poses together: a quarter of a second
ROWS = 1 << 12  # poses at a time
EQUAL = 1e-9  # margins that differ by less of T_max are equal: rounding would choose the pose


class Coverage(NamedTuple):
    """How much of the target gets the wanted force and moment.

    counts: poses along each axis of the grid, angles last; undefined: those on a pulley, which are
    not served. worst: the pose with the least margin of the others; possible: the share of the
    wanted force and moment that is feasible there.
    """

    counts: tuple[int, ...]
    undefined: int
    share: float
    worst: tuple[float, ...]
    possible: float

    @property
    def complete(self) -> bool:
        """Whether every pose of the grid is served."""
        return self.share == 1


class Lagging(NamedTuple):
    """The target with bases `lag` [m] behind the hand, in the worst direction, platform upright.

    share: where the wanted force, without a moment, is feasible; least and mean I_F [N].
    """

    lag: float
    share: float
    least_force: float
    mean_force: float


@dataclass(frozen=True)
class TargetSummary:
    """Shares of the target's poses, and the least or mean of the fields of `PoseQuality`.

    Poses on a pulley are not served; least and mean are of the others, NaN where a measure is
    defined nowhere. lagging: None without movable bases.
    """

    coverage: Coverage
    zero_share: float
    closure_share: float
    least_force: float
    mean_force: float
    least_tension_factor: float
    least_conditioning: float
    actuators: ActuatorChoice
    lagging: Lagging | None

    @property
    def passed(self) -> bool:
        """Whether all of the target is served, by the machine's own motors."""
        return self.coverage.complete and self.actuators.sufficient


def fine_grid(machine: Machine) -> Grid:
    """The grid of the summary: near-square cells over the target, border and corners included."""
    cells = PER_LONGEST_SIDE[machine.space, machine.is_rigid] - 1
    longest = max(machine.target.size)
    counts = [max(2, round(cells * side / longest) + 1) for side in machine.target.size]
    return target_grid(machine, counts, wanted_turns(machine))


def coarse_grid(machine: Machine) -> Grid:
    """As many poses as take well below a second, up to 21 a side: corners, border and middle.

    Of a platform with very many cables that turns in space the corners alone.
    """
    facets = comb(len(machine.cables), machine.dof - 1)
    for count, angles in COARSE_COUNTS:
        grid = target_grid(machine, [count] * machine.space, _turns(machine, angles))
        if facets * grid.size <= COARSE_FACETS:
            break
    return grid


def wanted_turns(machine: Machine) -> int:
    """Angles looked at about every axis, over what the target asks for."""
    return _turns(machine, TURNS[machine.space])


def _turns(machine: Machine, wanted: int) -> int:
    """Angles about every axis: one where the target asks for no rotation."""
    return wanted if machine.target.rotation else 1


def coverage(machine: Machine, grid: Grid) -> Coverage:
    """How much of a grid over the target gets the wanted force and moment."""
    margins = [wanted_margin(machine, poses) for poses in grid.tiles(ROWS)]
    return _coverage(machine, grid, np.concatenate(margins))


def _coverage(machine: Machine, grid: Grid, margin: Array) -> Coverage:
    number = int(np.argmax(margin <= _least(margin) + EQUAL * machine.tension.max))
    (worst,) = grid.poses(number, number + 1)
    return Coverage(
        counts=grid.shape,
        undefined=int(np.sum(np.isnan(margin))),
        share=float(np.mean(margin >= 0)),
        worst=tuple(worst.tolist()),
        possible=float(possible_share(machine, worst)),
    )


def summarise_target(
    machine: Machine, grid: Grid, lag: float, progress: Progress | None = None
) -> TargetSummary:
    """The target in numbers; `lag` [m] of movable bases behind the hand."""
    quality = quality_over(machine, grid, progress)
    poses = grid.poses()
    return TargetSummary(
        coverage=_coverage(machine, grid, quality.margin),
        zero_share=float(np.mean(quality.zero_margin >= 0)),
        closure_share=float(np.mean(quality.closure)),
        least_force=_least(quality.force),
        mean_force=_mean(quality.force),
        least_tension_factor=_least(quality.tension_factor),
        least_conditioning=_least(quality.conditioning),
        actuators=choose_actuators(machine, poses, base_targets(machine, poses)),
        lagging=summarise_lag(machine, grid, lag) if machine.rails else None,
    )


def quality_over(machine: Machine, grid: Grid, progress: Progress | None = None) -> PoseQuality:
    """All measures of every pose of a grid (rows)."""
    parts = [pose_quality(machine, poses) for poses in grid.tiles(ROWS, progress)]
    return PoseQuality(*map(np.concatenate, zip(*parts, strict=True)))


def summarise_lag(machine: Machine, grid: Grid, lag: float) -> Lagging:
    """The positions of a grid with bases `lag` [m] behind."""
    positions = Grid(grid.axes[: machine.space]).poses()
    upright = np.zeros((len(positions), machine.dof))
    upright[:, : machine.space] = positions
    force = lagging_force(machine, upright, lag)
    enough = force >= machine.target.force * (1 - EQUAL)
    return Lagging(lag, float(np.mean(enough)), _least(force), _mean(force))


def _least(values: Array) -> float:
    known = values[~np.isnan(values)]
    return float(np.min(known)) if known.size else np.nan


def _mean(values: Array) -> float:
    known = values[~np.isnan(values)]
    return float(np.mean(known)) if known.size else np.nan
