"""Maps of a machine as PNG, for print and for grey: light is good, dark bad, hatched impossible."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
from matplotlib import rc_context
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Polygon, Rectangle
from matplotlib.patheffects import AbstractPathEffect, withStroke
from matplotlib.ticker import MaxNLocator

from turnbuckle.lab.analysis.slices import AXES, LagPanel, Panel, Slice
from turnbuckle.lab.pictures import png_of
from turnbuckle.lab.plots import FAINT, INK, MM, STYLE
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.reference.kinematics import base_points
from turnbuckle.model.workspace.rows import Array

DPI = 200
WIDTH, PANEL_WIDTH, MARGIN = 6.3, 3.4, 1.3  # inches: of one map, of one of many; for bar and legend
TARGET = "#D55E00"
COLOURS, LIMIT_WIDTH = "cividis", 2.2
LINES = 6
LEAST_SPAN = 1e-6  # of the colours: what differs less is rounding
Strokes = list[AbstractPathEffect]
OUTLINE: Strokes = [withStroke(linewidth=3.4, foreground="white")]
DARK_OUTLINE: Strokes = [withStroke(linewidth=LIMIT_WIDTH + 1.6, foreground="black")]
PRINT: dict[Any, Any] = STYLE | {
    "font.size": 9,
    "axes.titlesize": 9.5,
    "axes.grid": False,
    "hatch.linewidth": 0.5,
    "hatch.color": "#666666",
    "legend.fontsize": 8.5,
}
AnyPanel = Panel | LagPanel
Span = tuple[float, float]


@dataclass(frozen=True)
class Quantity:
    """What a map shows: name of the file, title, label with unit, and the values of a panel.

    Hatched, in words `no`: values that are not finite, and those below `least`. limit: a line at
    this value, in words `limit_words`. low_is_good turns the colours round. The colours span the
    values, from `low` to `high` where these are given.
    """

    name: str
    title: str
    label: str
    values: Callable[[Any], Array]
    no: str
    limit: float | None = None
    limit_words: str = ""
    least: float = -np.inf
    low_is_good: bool = False
    low: float | None = None
    high: float | None = None

    def impossible(self, panel: AnyPanel) -> npt.NDArray[np.bool_]:
        """Which cells are hatched."""
        values = self.values(panel)
        return ~np.isfinite(values) | (values < self.least)


@dataclass(frozen=True)
class Mark:
    """A position [m] to point out."""

    position: tuple[float, ...]
    words: str


@dataclass(frozen=True)
class Outline:
    """A closed line (k, 2) [m] in the plane of a planar machine."""

    points: Array
    words: str
    colour: str
    style: str


def draw(
    quantity: Quantity,
    panels: Sequence[AnyPanel],
    marks: Sequence[Mark] = (),
    outlines: Sequence[Outline] = (),
) -> bytes:
    """The map of a quantity as PNG, one axes a panel, a column for every plane."""
    columns = len({panel.plane.axes for panel in panels})
    rows = -(-len(panels) // columns)
    span = span_of(quantity, panels)
    with rc_context(PRINT):
        figure = Figure(figsize=_size(panels, rows, columns), dpi=DPI, layout="constrained")
        grid = figure.subplots(rows, columns, squeeze=False)
        for axes, panel in zip(grid.flat, panels, strict=False):
            _draw_values(axes, quantity, panel, span)
            _draw_machine(axes, panel.machine, panel.plane)
            for line in outlines:
                axes.plot(*(MM * line.points.T), path_effects=OUTLINE, **_look(line))
            for mark in marks:
                _draw_mark(axes, panel.plane, mark)
            axes.set_title(panel.title)
        _draw_bar(figure, grid, quantity, span)
        title = {"x": 0.01, "y": 1.0, "ha": "left", "va": "bottom"}
        figure.suptitle(quantity.title, fontsize=11.5, fontweight="bold", **title)
        handles = list(_legend(quantity, panels, marks, outlines))
        figure.legend(handles=handles, loc="outside lower center", ncols=2 if columns == 1 else 3)
        return png_of(figure, bbox_inches="tight", metadata={"Software": None})


def _size(panels: Sequence[AnyPanel], rows: int, columns: int) -> tuple[float, float]:
    """Width and height [inches]: every row as high as its highest panel needs."""
    width = WIDTH if columns == 1 else columns * PANEL_WIDTH
    across = (width - 1.1) / columns - 0.55
    shapes = [np.ptp(panel.plane.y) / max(np.ptp(panel.plane.x), 1e-9) for panel in panels]
    return width, MARGIN + rows * (across * max(shapes) + 0.4)


def span_of(quantity: Quantity, panels: Sequence[AnyPanel]) -> Span:
    """What the colours span: the finite values of all panels, and the limit."""
    parts = [quantity.values(panel).ravel() for panel in panels]
    values = np.concatenate([*parts, [quantity.limit or 0.0]])
    values = values[np.isfinite(values)]
    low = float(np.min(values)) if quantity.low is None else quantity.low
    high = float(np.max(values)) if quantity.high is None else quantity.high
    if high - low > LEAST_SPAN:
        return low, high
    return (low - 1.0 if quantity.low is None else low), high + 1.0


def _draw_values(axes: Axes, quantity: Quantity, panel: AnyPanel, span: Span) -> None:
    """Colours, hatches where it is impossible, lines of equal values, the limit."""
    x, y, values = MM * panel.plane.x, MM * panel.plane.y, quantity.values(panel)
    shown = np.ma.masked_invalid(values)
    extent = [MM * panel.machine.frame.size[k] for k in panel.plane.axes]
    axes.add_patch(Rectangle((0, 0), *extent, facecolor="#E6E6E6", zorder=0))
    axes.pcolormesh(x, y, shown, norm=Normalize(*span), cmap=_colours(quantity), rasterized=True)
    no = quantity.impossible(panel)
    if np.any(no):
        axes.contourf(x, y, no, levels=[0.5, 1.5], colors="none", hatches=["////"])
    if shown.count() and np.ptp(shown.compressed()) > 1e-6 * (span[1] - span[0]):
        _draw_lines(axes, quantity, (x, y, shown), span)


def _draw_lines(axes: Axes, quantity: Quantity, field: Any, span: Span) -> None:
    """Lines of equal values with their numbers, and a broad one at the limit."""
    levels = MaxNLocator(LINES).tick_values(*span)
    levels = [level for level in levels if level != quantity.limit]
    lines = axes.contour(*field, levels=levels, colors="black", linewidths=0.6)
    for text in axes.clabel(lines, fontsize=7, fmt="%g"):
        text.set_path_effects([withStroke(linewidth=1.6, foreground="white")])
    if quantity.limit is not None:
        limit = axes.contour(
            *field, levels=[quantity.limit], colors="white", linewidths=LIMIT_WIDTH
        )
        limit.set_path_effects(DARK_OUTLINE)


def _colours(quantity: Quantity) -> str:
    return COLOURS + "_r" * quantity.low_is_good


def _draw_machine(axes: Axes, machine: Machine, plane: Slice) -> None:
    """Frame, target, rails, and the bases as they are for the middle of the target."""
    a, b = plane.axes
    width, height = (MM * machine.frame.size[k] for k in plane.axes)
    axes.add_patch(Rectangle((0, 0), width, height, fill=False, edgecolor=INK, lw=1.2))
    corner = [MM * (machine.target.centre[k] - machine.target.size[k] / 2) for k in plane.axes]
    size = [MM * machine.target.size[k] for k in plane.axes]
    target = Rectangle((corner[0], corner[1]), *size, fill=False, edgecolor=TARGET, lw=1.8)
    target.set_path_effects(OUTLINE)
    axes.add_patch(target)
    for outline in _travels(machine):
        axes.add_patch(
            Polygon(MM * outline[:, plane.axes], closed=True, fill=False, edgecolor=FAINT, lw=3.5)
        )
    middle = np.zeros(machine.dof)
    middle[: machine.space] = machine.target.centre
    bases = MM * base_points(machine, base_targets(machine, middle))
    axes.plot(
        bases[:, a],
        bases[:, b],
        "s",
        color=INK,
        ms=7,
        mec="white",
        mew=0.8,
        clip_on=False,
        zorder=5,
    )
    pad = 0.04 * max(width, height)
    axes.set(xlim=(-pad, width + pad), ylim=(-pad, height + pad), aspect="equal")
    axes.set(xlabel=f"{AXES[a]} [mm]", ylabel=f"{AXES[b]} [mm]")


def _travels(machine: Machine) -> Iterator[Array]:
    """Outlines (k, space) [m] of where movable bases can be."""
    for motion in machine.base_motions:
        start = np.asarray(motion.start)
        ways = [machine.rails[k].length * np.asarray(e) for k, e in motion.travel]
        if len(ways) == 1:
            yield np.stack([start, start + ways[0]])
        elif len(ways) == 2:
            along, across = ways
            yield np.stack([start, start + along, start + along + across, start + across])


def _look(line: Outline) -> dict[str, Any]:
    return {"color": line.colour, "ls": line.style, "lw": 1.6}


def _draw_mark(axes: Axes, plane: Slice, mark: Mark) -> None:
    x, y = (MM * mark.position[k] for k in plane.axes)
    axes.plot(x, y, clip_on=False, zorder=6, **MARKER)


MARKER: dict[str, Any] = {
    "marker": "X", "ms": 9, "color": "white", "mec": "black", "mew": 1.1, "ls": "none",
}  # fmt: skip


def _draw_bar(figure: Figure, grid: Any, quantity: Quantity, span: Span) -> None:
    beyond = "max" if quantity.low_is_good else "neither"
    bar = figure.colorbar(
        ScalarMappable(Normalize(*span), _colours(quantity)),
        ax=grid,
        label=quantity.label,
        extend=beyond,
    )
    if quantity.limit is not None:
        line = bar.ax.axhline(quantity.limit, color="white", lw=LIMIT_WIDTH)
        line.set_path_effects(DARK_OUTLINE)


def _legend(
    quantity: Quantity,
    panels: Sequence[AnyPanel],
    marks: Sequence[Mark],
    outlines: Sequence[Outline],
) -> Iterator[Artist]:
    machines = [panel.machine for panel in panels]
    yield Line2D([], [], color=TARGET, lw=1.8, label="target")
    where = "base (here for the target's middle)" if any(m.rails for m in machines) else "base"
    yield Line2D([], [], marker="s", color=INK, ls="none", ms=7, mec="white", label=where)
    if any(m.rails for m in machines):
        yield Line2D([], [], color=FAINT, lw=3.5, label="where bases can be")
    if quantity.limit is not None:
        yield Line2D(
            [], [], color="white", lw=LIMIT_WIDTH, path_effects=DARK_OUTLINE,
            label=quantity.limit_words,
        )  # fmt: skip
    if any(np.any(quantity.impossible(panel)) for panel in panels):
        yield Patch(facecolor="#E6E6E6", edgecolor="#666666", hatch="////", label=quantity.no)
    for mark in marks:
        yield Line2D([], [], label=mark.words, **MARKER)
    for line in outlines:
        yield Line2D([], [], label=line.words, path_effects=OUTLINE, **_look(line))
