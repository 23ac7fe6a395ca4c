"""The picture of a recording: states, pose, tensions and closure over time, for print."""

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from turnbuckle.lab.flight.recording import Recording
from turnbuckle.lab.flight.table import along, in_words, times
from turnbuckle.lab.pictures import write_picture
from turnbuckle.lab.plots import CABLES, FAINT, INK, MM, STYLE

DASHES: list[Any] = ["-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (1, 1))]
PAPER: dict[Any, Any] = STYLE | {
    "font.size": 8,
    "axes.titlesize": 9,
    "legend.fontsize": 7.5,
    "lines.linewidth": 1.0,
}
Outputs = dict[str, NDArray[Any]]
STATES = ["#F4F5F7", "#DDE3EA"]
FAULT = "#F6D5CF"
LETTER = 0.012
"""Share of the time axis that a letter takes."""


def draw(recording: Recording, path: Path) -> None:
    """Draw a recording into a PNG file, as wide as a page's text; FileError where it cannot."""
    time, controller = times(recording), recording.cycles["orders"]["controller"]
    out = {name: where_it_runs(controller, name) for name in ("pose", "residual")}
    with rc_context(PAPER):
        figure = Figure(figsize=(6.3, 7.0), dpi=200, layout="constrained")
        axes = figure.subplots(5, 1, sharex=True, height_ratios=[0.5, 2, 2, 1.6, 1.6])
        draw_states(axes[0], recording, time)
        draw_pose(axes[1], recording, time, out)
        draw_ordered(axes[2], recording, time)
        draw_reported(axes[3], recording, time)
        draw_residual(axes[4], recording, time, out)
        mark_cause(axes, recording, time)
        figure.align_ylabels()
        axes[-1].set(xlabel="time since the first recorded cycle [s]", xlim=(time[0], time[-1]))
        write_picture(figure, path)


def where_it_runs(out: NDArray[Any], name: str) -> NDArray[Any]:
    """An output of the controller; NaN while it does not run and all its outputs are 0."""
    idle = ~(out["pose"].any(axis=1) | out["tension"].any(axis=1))
    return np.where(idle.reshape(-1, *[1] * (out[name].ndim - 1)), np.nan, out[name])


def draw_states(axes: Axes, recording: Recording, time: NDArray[np.float64]) -> None:
    """A band for every state, named where there is room."""
    numbers = recording.cycles["orders"]["state"]
    names = in_words(numbers, recording.layouts, "state")
    changes = np.flatnonzero(np.diff(numbers)) + 1
    for turn, (begin, end) in enumerate(pairwise([0, *changes, len(numbers) - 1])):
        name = str(names[begin])
        colour = FAULT if name in ("fault", "hard stop") else STATES[turn % 2]
        axes.axvspan(time[begin], time[end], facecolor=colour, edgecolor=FAINT, lw=0.5)
        if time[end] - time[begin] > LETTER * (len(name) + 1) * (time[-1] - time[0]):
            middle = (time[begin] + time[end]) / 2
            axes.text(middle, 0.5, name, ha="center", va="center", size=7.5)
    axes.set(title=f"{recording.machine.name}: state", ylim=(0, 1), yticks=[])
    axes.grid(visible=False)


def draw_pose(axes: Axes, recording: Recording, time: NDArray[np.float64], out: Outputs) -> None:
    """Position of the platform, and its turn beside it where it turns."""
    machine = recording.machine
    for i, (name, values) in enumerate(along(machine, "pose", out["pose"], "m", "rad")):
        label = name.split("_")[1] if i < machine.space else name.split("_", 1)[1]
        scale = MM if i < machine.space else 1000.0
        line(axes, recording, time, scale * values, i, label.removesuffix("_rad"))
    axes.set(title="Pose", ylabel="mm or mrad" if machine.dof > machine.space else "mm")
    legend(axes, machine.dof)


def draw_ordered(axes: Axes, recording: Recording, time: NDArray[np.float64]) -> None:
    """What is ordered of the cable drives, as tension, with the bounds."""
    machine, order = recording.machine, recording.cycles["orders"]["drives"]
    for i, cable in enumerate(machine.cables):
        tension = order["torque"][:, i] / machine.drum.radius
        line(axes, recording, time, tension, i, cable.drive)
    for value in (machine.tension.min, machine.tension.max):
        axes.axhline(value, color=INK, ls=":", lw=0.8)
    axes.set(title="Ordered tensions", ylabel="N")
    legend(axes, len(machine.cables))


def draw_reported(axes: Axes, recording: Recording, time: NDArray[np.float64]) -> None:
    """What the cable drives report, as tension."""
    machine, report = recording.machine, recording.cycles["seen"]["drives"]
    for i, cable in enumerate(machine.cables):
        line(axes, recording, time, report["torque"][:, i] / machine.drum.radius, i, cable.drive)
    axes.set(title="Tensions that the drives report", ylabel="N")


def draw_residual(
    axes: Axes, recording: Recording, time: NDArray[np.float64], out: Outputs
) -> None:
    """By how much the measured lengths disagree, and what that would make of each cable."""
    for i, cable in enumerate(recording.machine.cables):
        slack = recording.cycles["orders"]["slack"][:, i]
        line(axes, recording, time, MM * slack, i, cable.drive)
    axes.plot(*broken(recording, time, MM * out["residual"]), color=INK, lw=1.2)
    axes.set(title="Closure residual (black), slack it would mean in a cable", ylabel="mm")


def mark_cause(axes: NDArray[Any], recording: Recording, time: NDArray[np.float64]) -> None:
    """A line where a cause was latched, named on top."""
    numbers = recording.cycles["orders"]["cause"]
    names = in_words(numbers, recording.layouts, "cause")
    new = np.flatnonzero((numbers[1:] != 0) & (np.diff(numbers.astype(int)) != 0)) + 1
    for index in new:
        for each in axes:
            each.axvline(time[index], color="#B22222", lw=0.9)
        right = time[index] > (time[0] + time[-1]) / 2
        axes[0].annotate(
            f"{names[index]} ",
            (time[index], 1.08),
            xycoords=("data", "axes fraction"),
            ha="right" if right else "left",
            color="#B22222",
            size=7.5,
        )


def line(
    axes: Axes,
    recording: Recording,
    time: NDArray[np.float64],
    values: NDArray[Any],
    index: int,
    label: str,
) -> None:
    """A curve told from the others by colour and by dashes, in print without colours too."""
    axes.plot(
        *broken(recording, time, values),
        color=CABLES[index % len(CABLES)],
        ls=DASHES[index % len(DASHES)],
        label=label,
    )


def broken(
    recording: Recording, time: NDArray[np.float64], values: NDArray[Any]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Times and values with a gap where cycles were not recorded."""
    gaps = np.flatnonzero(np.diff(recording.numbers) > 1) + 1
    return np.insert(time, gaps, np.nan), np.insert(values.astype(float), gaps, np.nan)


def legend(axes: Axes, columns: int) -> None:
    """The legend in one line above the axes, on the right."""
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 0.97), borderaxespad=0.0, ncols=columns)
