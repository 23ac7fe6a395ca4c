"""The picture of a run: the machine to scale with the path, the walls, forces and tensions."""

from collections.abc import Sequence
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.patches import Polygon, Rectangle
from numpy.typing import ArrayLike

from turnbuckle.lab.bench import Reals, Recording
from turnbuckle.lab.pictures import write_picture
from turnbuckle.lab.summary import penetration
from turnbuckle.lab.task import TURN, Phase, Task
from turnbuckle.model.machine import Machine, Wall
from turnbuckle.model.reference.kinematics import anchor_points

MM = 1e3
CABLES = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#8C564B", "#7F7F7F"]
AXES = "xyz"
View = tuple[int, int]
"""Two axes, that to the right first."""
VIEWS: dict[int, list[View]] = {2: [(0, 1)], 3: [(0, 1), (0, 2)]}
"""From where a machine is seen, by the dimension of its space."""
FADED = {2: 0.35, 3: 0.15}
"""Opacity of the poses that the machine has been in, by the dimension of the space."""
ARROW = 0.14
"""Length of an arrow for the wanted force, over the longest side of the frame."""
EDGE_ON = 1e-9
"""By which the normal of a wall that is seen edge-on may be shorter than one."""
WALLS = ["#B22222", "#4B0082", "#006D5B", "#8B5A00"]
INK, FAINT, PAPER = "#222222", "#9AA0A6", "#F4F5F7"
STYLE: dict[Any, Any] = {
    "font.size": 11,
    "axes.titlesize": 12,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": FAINT,
    "axes.grid": True,
    "grid.color": "#E3E5E8",
    "legend.frameon": False,
}


def draw(machine: Machine, recording: Recording, path: Path) -> None:
    """Draw a run into a PNG file of 1600 x 1000 pixels; FileError when it cannot be written."""
    with rc_context(STYLE):
        room = ConstrainedLayoutEngine(rect=(0.0, 0.0, 1.0, 0.98))  # for titles side by side
        figure = Figure(figsize=(16, 10), dpi=100, layout=room)
        heights = [5.4, 1.5, *[1.5] * machine.is_rigid, 2.3]
        rows = figure.add_gridspec(len(heights), 2, height_ratios=heights, width_ratios=[1.5, 1])
        views = VIEWS[machine.space]
        places = rows[0, 0].subgridspec(1, len(views))
        for view, place in zip(views, places, strict=True):  # type: ignore[call-overload]
            draw_machine(figure.add_subplot(place), machine, recording, view)
        beside = figure.add_subplot(rows[0, 1])
        if recording.task.wall_phases:
            draw_walls(beside, machine, recording)
        else:
            draw_turn(beside, recording)
        forces = figure.add_subplot(rows[1, :])
        draw_forces(forces, recording)
        if machine.is_rigid:
            draw_moments(figure.add_subplot(rows[2, :], sharex=forces), recording)
        draw_tensions(figure.add_subplot(rows[-1, :], sharex=forces), machine, recording)
        write_picture(figure, path)


def draw_machine(axes: Axes, machine: Machine, recording: Recording, view: View) -> None:
    """Frame, target, walls, bases and cables at a few poses, and the path, to scale, as they look
    along the axis that a view leaves out."""
    width, height = MM * seen(machine.frame.size, view)
    axes.add_patch(Rectangle((0, 0), width, height, facecolor=PAPER, edgecolor=FAINT, lw=1.5))
    draw_target(axes, machine, view)
    for wall, colour in zip(machine.walls, WALLS * len(machine.walls), strict=False):
        draw_wall(axes, machine, wall, colour, view)
    *others, last = shown_cycles(recording)
    for cycle in others:
        draw_cables(axes, machine, recording, cycle, view, alpha=FADED[machine.space])
    axes.plot(*(MM * seen(recording.position, view).T), color=INK, lw=1.6)
    axes.plot(*(MM * seen(recording.path, view).T), color=FAINT, ls="--", lw=1.2)
    draw_cables(axes, machine, recording, last, view, alpha=1.0)
    scale = MM * ARROW * max(machine.frame.size) / machine.target.force
    draw_force(axes, recording, last, view, scale)
    x, y = (AXES[axis] for axis in view)
    axes.set(aspect="equal", xlabel=f"{x} [mm]", ylabel=f"{y} [mm]")
    if view == (0, 1):
        axes.set_title(f"{machine.name}: the handle's path (dashed: the hand's)")
    axes.set(xlim=(-0.05 * width, 1.05 * width), ylim=(-0.06 * height, 1.06 * height))
    axes.grid(False)


def seen(vectors: ArrayLike, view: View) -> Reals:
    """Vectors (..., 2), of vectors (..., space or more), as they are seen in a view."""
    return np.asarray(vectors)[..., list(view)]


def draw_target(axes: Axes, machine: Machine, view: View) -> None:
    """The rectangle or box the user needs."""
    (x, y), (width, height) = seen(machine.target.centre, view), seen(machine.target.size, view)
    left, top = MM * (x - width / 2), MM * (y + height / 2)
    size = MM * width, MM * height
    place = left, top - size[1]
    axes.add_patch(Rectangle(place, *size, facecolor="white", edgecolor=FAINT, lw=1.0))
    text = f"target {size[0]:g} × {size[1]:g} mm"
    height = top - 6 if machine.space == 2 else 6.0  # within a small box cables hide it
    anchor = "top" if machine.space == 2 else "bottom"
    axes.text(MM * x, height, text, color="#6B7075", ha="center", va=anchor, size=10)


def draw_wall(axes: Axes, machine: Machine, wall: Wall, colour: str, view: View) -> None:
    """What lies behind a wall that is seen edge-on, within the frame, and its surface."""
    point, normal = seen(wall.point, view), seen(wall.normal, view)
    inside = behind(seen(machine.frame.size, view), point, normal)
    if len(inside) < 3 or abs(np.linalg.norm(normal) - 1.0) > EDGE_ON:
        return
    axes.add_patch(Polygon(MM * inside, facecolor=colour, alpha=0.08))
    depth = (point - inside) @ normal
    surface = inside[np.argsort(depth)[:2]]
    axes.plot(*(MM * surface.T), color=colour, lw=1.8)
    start, end = surface[np.lexsort(surface.T[::-1])]
    (nx, ny), (x, y) = normal, MM * (start + 0.14 * (end - start))
    angle = (np.degrees(np.arctan2(nx, -ny)) + 90) % 180 - 90
    axes.text(
        x - 16 * nx,
        y - 16 * ny,
        f"wall {wall.name}",
        color=colour,
        rotation=angle,
        ha="center",
        va="center",
    )


def behind(size: Reals, point: Reals, normal: Reals) -> Reals:
    """Corners [m] (k, 2) of the part of a frame of some size [m] (2) that lies behind a wall."""
    width, height = size
    frame = np.array([(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)])
    depths = (point - frame) @ normal
    corners = []
    for here, there, depth, next_depth in zip(
        frame, np.roll(frame, -1, axis=0), depths, np.roll(depths, -1), strict=True
    ):
        if depth >= 0.0:
            corners.append(here)
        if (depth >= 0.0) != (next_depth >= 0.0):
            corners.append(here + (there - here) * depth / (depth - next_depth))
    return np.array(corners).reshape(-1, 2)


def shown_cycles(recording: Recording) -> list[int]:
    """Cycles whose pose is drawn: two far corners of the tour, and one with a force."""
    tour = np.flatnonzero(recording.during(recording.task.phase("tour")))
    diagonal = recording.position[tour, : recording.task.space].sum(axis=1)
    first_turn = turn_phases(recording.task)[0]
    pressed = np.flatnonzero(recording.during((*recording.task.wall_phases, first_turn)[0]))
    corners = [int(tour[diagonal.argmin()]), int(tour[diagonal.argmax()])]
    return [*corners, int(pressed[len(pressed) * 3 // 4])]


def draw_cables(
    axes: Axes, machine: Machine, recording: Recording, cycle: int, view: View, alpha: float
) -> None:
    """Rails, bases and cables of one pose, and the handle with its arms."""
    x, y = MM * seen(recording.position[cycle], view)
    rails = recording.rails[cycle]
    anchors = MM * seen(anchor_points(machine, recording.position[cycle]), view)
    colours = CABLES * len(machine.cables)
    for motion, (a, b), colour in zip(machine.base_motions, anchors, colours, strict=False):
        base_x, base_y = MM * seen(motion.point(rails), view)
        for k, direction in motion.travel:
            reach = machine.rails[k].length * np.array(direction)
            ends = MM * seen(np.array(motion.start) + np.outer([0.0, 1.0], reach), view)
            axes.plot(*ends.T, color=FAINT, lw=3.5, solid_capstyle="round", zorder=1)
        axes.plot([a, base_x], [b, base_y], color=colour, alpha=alpha, lw=1.8)
        axes.plot(base_x, base_y, "s", color=colour, alpha=alpha, ms=11)
        if machine.is_rigid:
            axes.plot([x, a], [y, b], color=INK, alpha=alpha, lw=3.0, solid_capstyle="round")
    axes.plot(x, y, "o", color=INK, alpha=alpha, ms=9)


def draw_force(axes: Axes, recording: Recording, cycle: int, view: View, scale: float) -> None:
    """The force of the cables on the handle, as an arrow of `scale` [mm/N]."""
    position = MM * seen(recording.position[cycle], view)
    force = seen(recording.cable_force[cycle], view)
    size = float(np.linalg.norm(force))
    tip = position + scale * force
    axes.annotate(
        "", tuple(tip), tuple(position), arrowprops={"arrowstyle": "-|>", "color": INK, "lw": 2}
    )
    axes.annotate(
        f"{size:.1f} N",
        tuple(tip),
        xytext=tuple(22.0 * force / max(size, 1e-9)),
        textcoords="offset points",
        ha="center",
        va="center",
        bbox={"facecolor": "white", "alpha": 0.8, "lw": 0, "pad": 1.0},
    )


def draw_walls(axes: Axes, machine: Machine, recording: Recording) -> None:
    """Force of every wall, as delivered, against how deep the handle is in it."""
    depths = MM * penetration(machine, recording.position)
    for index, (wall, colour) in enumerate(zip(machine.walls, WALLS * 4, strict=False)):
        inside = depths[:, index] > 0.0
        depth = depths[:, index]
        force = recording.cable_force[:, : machine.space] @ np.array(wall.normal)
        label = f"wall {wall.name}, delivered by the cables"
        axes.plot(depth[inside], force[inside], ".", ms=2, color=colour, alpha=0.6, label=label)
        for phase in recording.task.wall_phases:
            if phase.name == f"wall {wall.name}":
                held = recording.during(phase)
                axes.plot(
                    depth[held].mean(), force[held].mean(), "o", ms=9, mfc="none", color=colour
                )
        reach = np.array([0.0, 1.08 * depth.max(initial=0.0)])
        label = f"k x with k = {wall.stiffness:g} N/m"
        axes.plot(reach, wall.stiffness * reach / MM, color=colour, ls="--", lw=1.4, label=label)
    axes.set(xlabel="penetration x [mm]", ylabel="force out of the wall [N]")
    axes.set_title("Wall force against penetration (circle: hand at rest)")
    axes.legend(loc="upper left", markerscale=5)


def draw_turn(axes: Axes, recording: Recording) -> None:
    """The application's turning force, wanted and delivered, as a curve in every plane."""
    views = list(combinations(range(recording.task.space), 2))
    turns = turn_phases(recording.task)
    for view, phase, colour in zip(views, turns, CABLES, strict=False):
        turn = recording.during(phase)
        names = " and ".join(AXES[axis] for axis in view)
        delivered = seen(recording.cable_force[turn], view)
        axes.plot(*delivered.T, color=colour, lw=1.6, label=f"along {names}")
        axes.plot(*seen(recording.outputs.wanted_force[turn], view).T, color=INK, ls="--", lw=1.2)
    if len(views) > 1:
        axes.set(xlabel="force along the first axis [N]", ylabel="force along the second axis [N]")
        axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    else:
        axes.set(xlabel="force along x [N]", ylabel="force along y [N]")
    axes.set_aspect("equal")
    axes.set_title("The application's force, turned (dashed: wanted)")


def turn_phases(task: Task) -> list[Phase]:
    """The turns of the application's force, in every plane, and of its moment, about every axis."""
    turn = task.phase("turn")
    count = round((turn.end - turn.begin) / TURN)
    begins = [turn.begin + number * TURN for number in range(count)]
    return [Phase("turn", begin, begin + TURN) for begin in begins]


def draw_forces(axes: Axes, recording: Recording) -> None:
    """Force on the handle over time, wanted and delivered, with the phases of the task."""
    space = recording.task.space
    draw_wrench(axes, recording, range(space), [f"along {name}" for name in AXES[:space]])
    axes.set_title("Force on the handle, delivered by the cables (dashed: wanted)")
    axes.set_ylabel("force [N]")
    for phase in recording.task.phases:
        shade(axes, phase)


def draw_moments(axes: Axes, recording: Recording) -> None:
    """Moment on the handle over time, wanted and delivered."""
    turns = range(recording.task.space, recording.task.dof)
    draw_wrench(axes, recording, turns, [f"about {name}" for name in AXES[-len(turns) :]])
    axes.set_title("Moment on the handle, delivered by the cables (dashed: wanted)")
    axes.set_ylabel("moment [N m]")
    for phase in recording.task.phases:
        axes.axvspan(phase.begin, phase.end, facecolor="#EAF5FC", edgecolor="white", lw=2)


def draw_wrench(
    axes: Axes, recording: Recording, rows: Sequence[int], names: Sequence[str]
) -> None:
    """Some rows of the wrench over time, wanted and delivered."""
    delivered, wanted = recording.cable_force, recording.outputs.wanted_force
    for row, name, colour in zip(rows, names, CABLES, strict=False):
        axes.plot(recording.time, delivered[:, row], color=colour, lw=1.3, label=name)
        axes.plot(recording.time, wanted[:, row], color=INK, ls="--", lw=1.0)
    axes.margins(y=0.25)
    axes.tick_params(labelbottom=False)
    legend_above(axes, len(rows))


def legend_above(axes: Axes, columns: int) -> None:
    """The legend in one line above the axes, on the right."""
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 0.99), borderaxespad=0.0, ncols=columns)


def shade(axes: Axes, phase: Phase) -> None:
    """A band over the time of a phase, named where there is room for it."""
    axes.axvspan(phase.begin, phase.end, facecolor="#EAF5FC", edgecolor="white", lw=2)
    if phase.end - phase.begin < 0.5:
        return
    axes.annotate(
        phase.name,
        ((phase.begin + phase.end) / 2, 0.97),
        xycoords=("data", "axes fraction"),
        ha="center",
        va="top",
        size=10,
        color="#4A5055",
    )


def draw_tensions(axes: Axes, machine: Machine, recording: Recording) -> None:
    """What the cables carry over time, with the bounds of the command."""
    for index, cable in enumerate(machine.cables):
        colour = CABLES[index % len(CABLES)]
        axes.plot(
            recording.time, recording.tensions[:, index], color=colour, lw=1.1, label=cable.drive
        )
    for name, value in (("min", machine.tension.min), ("max", machine.tension.max)):
        axes.axhline(value, color=INK, ls=":", lw=1.2)
        text = rf" $T_\mathrm{{{name}}}$ = {value:g} N"
        axes.text(recording.time[-1], value, text, va="center", clip_on=False)
    axes.set(xlabel="time [s]", ylabel="tension [N]", title="Cable tensions")
    axes.set_ylim(min(0.0, 1.1 * float(recording.tensions.min())), 1.1 * machine.tension.max)
    axes.set_xlim(0.0, float(recording.time[-1]))
    legend_above(axes, len(machine.cables))
