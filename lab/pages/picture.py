"""The picture of a machine: frame, rails, bases, cables and target, seen flat or in space."""

from itertools import product
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.reference.kinematics import anchor_points, base_points

Array = NDArray[np.float64]
MM = 1e3
INK, CABLE, TARGET, RAIL = "#263238", "#1565c0", "#2e7d32", "#b0bec5"


def draw_machine(machine: Machine) -> Figure:
    """The machine with its platform upright in the middle of the target, and the bases for that."""
    figure = Figure(figsize=(6.4, 4.8), dpi=110, layout="constrained")
    flat = machine.space == 2
    axes: Any = figure.add_subplot() if flat else figure.add_subplot(projection="3d")
    for line in box(machine.frame.size, machine.frame.centre):
        axes.plot(*line.T, color=INK, lw=1)
    for line in box(machine.target.size, machine.target.centre):
        axes.plot(*line.T, color=TARGET, lw=1.4, ls="--")
    draw_cables(axes, machine)
    axes.set(xlabel="x [mm]", ylabel="y [mm]", aspect="equal")
    if not flat:
        axes.set(zlabel="z [mm]")
    return figure


def draw_cables(axes: Any, machine: Machine) -> None:
    """Rails, cables with their numbers, and the platform that they hold."""
    pose = np.zeros(machine.dof)
    pose[: machine.space] = machine.target.centre
    bases = MM * base_points(machine, base_targets(machine, pose))
    anchors = MM * anchor_points(machine, pose)
    for motion in machine.base_motions:
        for rail, direction in motion.travel:
            ends = np.array([[0.0], [machine.rails[rail].length]]) * direction + motion.start
            axes.plot(*(MM * ends).T, color=RAIL, lw=6, solid_capstyle="round", zorder=1)
    for number, (base, anchor) in enumerate(zip(bases, anchors, strict=True), 1):
        axes.plot(*np.stack([base, anchor]).T, color=CABLE, lw=1.6)
        axes.plot(*base[:, None], "s", color=INK, ms=7)
        axes.text(*(0.88 * base + 0.12 * anchor), f" {number}", color=CABLE)
    axes.plot(*anchors.T, "o", color=CABLE, ms=5)


def box(size: tuple[float, ...], centre: tuple[float, ...]) -> list[Array]:
    """Edges (2, space) [mm] of a rectangle or box [m]."""
    corners = [np.array(signs) for signs in product((-0.5, 0.5), repeat=len(size))]
    return [
        MM * (np.stack([a, b]) * size + centre)
        for number, a in enumerate(corners)
        for b in corners[number + 1 :]
        if np.abs(a - b).sum() == 1
    ]
