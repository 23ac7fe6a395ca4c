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
    tour_turn: float | None
    """Handle turned off the hand's path while it moves freely, rms [rad]."""
    tour_moment: float | None
    """Moment on the hand while it moves freely, rms [N m]; nothing was asked for."""
    moment_error: float | None
    """Delivered minus wanted moment while the application's force and moment turn, rms [N m]."""
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
    """Largest error of the computed position [m]."""
    rotation_error: float | None
    """Largest error of the computed rotation [rad]."""
    slack: int
    """Cycles in which a cable hung slack."""
    infeasible: int
    """Cycles in which the wanted force was more than the cables have."""
    failed: int
    """Cycles that failed."""


def summarise(machine: Machine, recording: Recording) -> Summary:
    """The numbers of a recording."""
    outputs, running = recording.outputs, recording.time >= TENSIONING
    tour, turn = (recording.during(recording.task.phase(name)) for name in ("tour", "turn"))
    pressing = _pressing(recording)
    space, rigid = machine.space, machine.is_rigid
    force_error, moment_error = _halves(recording.cable_force - outputs.wanted_force, space)
    off_path, off_turn = _halves(recording.position - recording.path, space)
    pose_error, rotation_error = _halves(outputs.pose - recording.position, space)
    lag = np.abs(recording.rails - outputs.rail_target)[running]
    depth = penetration(machine, recording.position)
    return Summary(
        tour_error=_rms(off_path[tour]),
        tour_force=_rms(force_error[tour]),
        turn_error=_rms(force_error[turn]),
        tour_turn=_rms(off_turn[tour]) if rigid else None,
        tour_moment=_rms(moment_error[tour]) if rigid else None,
        moment_error=_rms(moment_error[turn]) if rigid else None,
        wall_error=_rms(force_error[pressing]) if pressing.any() else None,
        penetration=float(depth.max()) if depth.size else None,
        lowest_tension=float(recording.lowest_tension[running].min()),
        highest_tension=float(recording.highest_tension[running].max()),
        base_lag=float(lag.max()) if lag.size else None,
        pose_error=float(pose_error.max()),
        rotation_error=float(rotation_error.max()) if rigid else None,
        slack=int((recording.lowest_tension[running] <= 0.0).sum()),
        infeasible=int((outputs.status == Status.INFEASIBLE).sum()),
        failed=int((outputs.status > Status.INFEASIBLE).sum()),
    )


def penetration(machine: Machine, position: Reals) -> Reals:
    """Depth [m] (k, walls) of poses (k, d) [m, rad] in every wall, negative outside."""
    space = machine.space
    points = np.array([wall.point for wall in machine.walls]).reshape(-1, space)
    normals = np.array([wall.normal for wall in machine.walls]).reshape(-1, space)
    depths: Reals = ((points - position[:, None, :space]) * normals).sum(axis=-1)
    return depths


def _pressing(recording: Recording) -> NDArray[np.bool_]:
    pressing = np.zeros(len(recording.time), dtype=bool)
    for phase in recording.task.wall_phases:
        pressing |= recording.during(phase)
    return pressing


def _halves(vectors: NDArray[Any], space: int) -> tuple[Reals, Reals]:
    """Norms (k) of what vectors (k, d) say of translations, and of rotations."""
    return _norms(vectors[:, :space]), _norms(vectors[:, space:])


def _norms(vectors: NDArray[Any]) -> Reals:
    norms: Reals = np.linalg.norm(vectors, axis=-1)
    return norms


def _rms(values: Reals) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
