"""The picture of a run: the machine to scale with the path, the walls, forces and tensions."""

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Polygon, Rectangle

from turnbuckle.lab.bench import Reals, Recording
from turnbuckle.lab.pictures import write_picture
from turnbuckle.lab.summary import penetration
from turnbuckle.lab.task import Phase
from turnbuckle.model.machine import Machine, Wall

MM = 1e3
CABLES = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#8C564B", "#7F7F7F"]
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
        figure = Figure(figsize=(16, 10), dpi=100, layout="constrained")
        rows = figure.add_gridspec(3, 2, height_ratios=[5.4, 1.5, 2.3], width_ratios=[1.5, 1])
        draw_machine(figure.add_subplot(rows[0, 0]), machine, recording)
        beside = figure.add_subplot(rows[0, 1])
        if recording.task.wall_phases:
            draw_walls(beside, machine, recording)
        else:
            draw_turn(beside, recording)
        forces = figure.add_subplot(rows[1, :])
        draw_forces(forces, recording)
        draw_tensions(figure.add_subplot(rows[2, :], sharex=forces), machine, recording)
        write_picture(figure, path)


def draw_machine(axes: Axes, machine: Machine, recording: Recording) -> None:
    """Frame, target, walls, bases and cables at a few poses, and the path, to scale."""
    width, height = (MM * side for side in machine.frame.size)
    axes.add_patch(Rectangle((0, 0), width, height, facecolor=PAPER, edgecolor=FAINT, lw=1.5))
    draw_target(axes, machine)
    for wall, colour in zip(machine.walls, WALLS * len(machine.walls), strict=False):
        draw_wall(axes, machine, wall, colour)
    *others, last = shown_cycles(recording)
    for cycle in others:
        draw_cables(axes, machine, recording, cycle, alpha=0.35)
    axes.plot(*(MM * recording.position.T), color=INK, lw=1.6)
    axes.plot(*(MM * recording.path.T), color=FAINT, ls="--", lw=1.2)
    draw_cables(axes, machine, recording, last, alpha=1.0)
    draw_force(axes, recording, last)
    axes.set(aspect="equal", xlabel="x [mm]", ylabel="y [mm]")
    axes.set_title(f"{machine.name}: path of the handle (dashed: where the hand wants to go)")
    axes.set(xlim=(-0.05 * width, 1.05 * width), ylim=(-0.06 * height, 1.06 * height))
    axes.grid(False)


def draw_target(axes: Axes, machine: Machine) -> None:
    """The rectangle the user needs."""
    (x, y), (width, height) = machine.target.centre, machine.target.size
    left, top = MM * (x - width / 2), MM * (y + height / 2)
    size = MM * width, MM * height
    place = left, top - size[1]
    axes.add_patch(Rectangle(place, *size, facecolor="white", edgecolor=FAINT, lw=1.0))
    text = f"target {size[0]:g} × {size[1]:g} mm"
    axes.text(MM * x, top - 6, text, color="#6B7075", ha="center", va="top", size=10)


def draw_wall(axes: Axes, machine: Machine, wall: Wall, colour: str) -> None:
    """What lies behind a wall, within the frame, and its surface."""
    inside = behind(machine, wall)
    if len(inside) < 3:
        return
    axes.add_patch(Polygon(MM * inside, facecolor=colour, alpha=0.08))
    depth = (np.array(wall.point) - inside) @ np.array(wall.normal)
    surface = inside[np.argsort(depth)[:2]]
    axes.plot(*(MM * surface.T), color=colour, lw=1.8)
    start, end = surface[np.lexsort(surface.T[::-1])]
    (nx, ny), (x, y) = wall.normal, MM * (start + 0.14 * (end - start))
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


def behind(machine: Machine, wall: Wall) -> Reals:
    """Corners [m] (k, 2) of the part of the frame that lies behind a wall."""
    (width, height), normal = machine.frame.size, np.array(wall.normal)
    frame = np.array([(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)])
    depths = (np.array(wall.point) - frame) @ normal
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
    diagonal = recording.position[tour].sum(axis=1)
    phases = recording.task.wall_phases[:1] or (recording.task.phase("turn"),)
    pressed = np.flatnonzero(recording.during(phases[0]))
    corners = [int(tour[diagonal.argmin()]), int(tour[diagonal.argmax()])]
    return [*corners, int(pressed[len(pressed) * 3 // 4])]


def draw_cables(
    axes: Axes, machine: Machine, recording: Recording, cycle: int, alpha: float
) -> None:
    """Rails, bases and cables of one pose, and the handle."""
    x, y = MM * recording.position[cycle]
    rails = recording.rails[cycle]
    for motion, colour in zip(machine.base_motions, CABLES * len(machine.cables), strict=False):
        point = motion.point(rails)
        for k, direction in motion.travel:
            reach = machine.rails[k].length * np.array(direction)
            ends = MM * (np.array(motion.start) + np.outer([0.0, 1.0], reach))
            axes.plot(*ends.T, color=FAINT, lw=3.5, solid_capstyle="round", zorder=1)
        axes.plot([x, MM * point[0]], [y, MM * point[1]], color=colour, alpha=alpha, lw=1.8)
        axes.plot(MM * point[0], MM * point[1], "s", color=colour, alpha=alpha, ms=11)
    axes.plot(x, y, "o", color=INK, alpha=alpha, ms=9)


def draw_force(axes: Axes, recording: Recording, cycle: int) -> None:
    """The force of the cables on the handle, as an arrow."""
    position, force = MM * recording.position[cycle], recording.cable_force[cycle]
    size = float(np.linalg.norm(force))
    tip = position + 14.0 * force
    axes.annotate("", tip, position, arrowprops={"arrowstyle": "-|>", "color": INK, "lw": 2})
    axes.annotate(
        f"{size:.1f} N",
        tip,
        xytext=22.0 * force / max(size, 1e-9),
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
        depth, force = depths[:, index], recording.cable_force @ np.array(wall.normal)
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
    """The application's turning force, wanted and delivered, as a curve in the plane."""
    turn = recording.during(recording.task.phase("turn"))
    axes.plot(*recording.cable_force[turn].T, color=CABLES[0], lw=1.6)
    axes.plot(*recording.outputs.wanted_force[turn].T, color=INK, ls="--", lw=1.2)
    axes.set(aspect="equal", xlabel="force along x [N]", ylabel="force along y [N]")
    axes.set_title("The application's force, turned once around (dashed: wanted)")


def draw_forces(axes: Axes, recording: Recording) -> None:
    """Force on the handle over time, wanted and delivered, with the phases of the task."""
    for index, (name, colour) in enumerate([("x", CABLES[0]), ("y", CABLES[1])]):
        delivered, wanted = recording.cable_force, recording.outputs.wanted_force
        axes.plot(recording.time, delivered[:, index], color=colour, lw=1.3, label=f"along {name}")
        axes.plot(recording.time, wanted[:, index], color=INK, ls="--", lw=1.0)
    axes.set_title("Force on the handle, delivered by the cables (dashed: wanted)")
    axes.set_ylabel("force [N]")
    axes.margins(y=0.25)
    axes.tick_params(labelbottom=False)
    legend_above(axes, 2)
    for phase in recording.task.phases:
        shade(axes, phase)


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
