"""What a run on the bench amounts to, in a few numbers."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from turnbuckle.lab.bench import Reals, Recording
from turnbuckle.lab.task import TENSIONING
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import Status


@dataclass(frozen=True)
class Summary:
    """Numbers of one run, after the tensioning; None where a machine has no such thing."""

    tour_error: float
    """Handle off the hand's path while it moves freely, rms [m]."""
    tour_force: float
    """Force on the hand while it moves freely, rms [N]; nothing was asked for."""
    turn_error: float
    """Delivered minus wanted force while the application's force turns, rms [N]."""
    wall_error: float | None
    """Delivered minus wanted force while the hand rests against a wall, rms [N]."""
    penetration: float | None
    """Deepest in any wall [m]; negative if none was reached."""
    lowest_tension: float
    """Of any cable [N]."""
    highest_tension: float
    """Of any cable [N]."""
    base_lag: float | None
    """Largest distance of a base from its target [m]."""
    pose_error: float
    """Largest error of the computed pose [m]."""
    infeasible: int
    """Cycles in which the wanted force was more than the cables have."""
    failed: int
    """Cycles that failed."""


def summarise(machine: Machine, recording: Recording) -> Summary:
    """The numbers of a recording."""
    outputs, running = recording.outputs, recording.time >= TENSIONING
    tour, turn = (recording.during(recording.task.phase(name)) for name in ("tour", "turn"))
    pressing = _pressing(recording)
    force_error = _norms(recording.cable_force - outputs.wanted_force)
    lag = np.abs(recording.rails - outputs.rail_target)[running]
    depth = penetration(machine, recording.position)
    return Summary(
        tour_error=_rms(_norms(recording.position - recording.path)[tour]),
        tour_force=_rms(force_error[tour]),
        turn_error=_rms(force_error[turn]),
        wall_error=_rms(force_error[pressing]) if pressing.any() else None,
        penetration=float(depth.max()) if depth.size else None,
        lowest_tension=float(recording.lowest_tension[running].min()),
        highest_tension=float(recording.highest_tension[running].max()),
        base_lag=float(lag.max()) if lag.size else None,
        pose_error=float(_norms(outputs.pose - recording.position).max()),
        infeasible=int((outputs.status == Status.INFEASIBLE).sum()),
        failed=int((outputs.status > Status.INFEASIBLE).sum()),
    )


def penetration(machine: Machine, position: Reals) -> Reals:
    """Depth [m] (k, walls) of positions [m] (k, 2) in every wall, negative outside."""
    points = np.array([wall.point for wall in machine.walls]).reshape(-1, 2)
    normals = np.array([wall.normal for wall in machine.walls]).reshape(-1, 2)
    depths: Reals = ((points - position[:, None, :]) * normals).sum(axis=-1)
    return depths


def _pressing(recording: Recording) -> NDArray[np.bool_]:
    pressing = np.zeros(len(recording.time), dtype=bool)
    for phase in recording.task.wall_phases:
        pressing |= recording.during(phase)
    return pressing


def _norms(vectors: NDArray[Any]) -> Reals:
    norms: Reals = np.linalg.norm(vectors, axis=-1)
    return norms


def _rms(values: Reals) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
