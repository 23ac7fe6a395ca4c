"""How the papers' figures are drawn: maps to scale, readable in print."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import colormaps, rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from turnbuckle.lab.pictures import png_of
from turnbuckle.lab.plots import STYLE
from turnbuckle.model.files import write_whole
from turnbuckle.model.workspace.rows import Array

FOLDER = Path(__file__).parents[3] / "docs" / "figures"
PULLEYS: dict[str, Any] = {
    "color": "#222222",
    "marker": "s",
    "ls": "",
    "ms": 7,
    "clip_on": False,
    "zorder": 5,
}
BOUNDARY: dict[str, Any] = {"color": "#0072B2", "lw": 2.2}
CAPABLE, INCAPABLE = "#E69F00", "#E3E5E8"
#: Maps go from dark to light, so that they tell the same in grey.
COLOURS = "viridis"


def line_colours(count: int) -> Array:
    """Colours of so many lines on white paper, from dark to lighter."""
    return np.asarray(colormaps["plasma"](np.linspace(0.0, 0.8, count)))


@contextmanager
def picture(name: str, width: float, height: float) -> Iterator[Figure]:
    """A figure of this size [inch], written to docs/figures when it is drawn."""
    with rc_context(STYLE):
        figure = Figure(figsize=(width, height), dpi=110, layout="constrained")
        yield figure
        write_whole(FOLDER / name, png_of(figure))


def cells(size: Sequence[float], counts: Sequence[int]) -> tuple[Array, ...]:
    """Middles of so many cells [m] along each side of a box from the origin."""
    pairs = zip(size, counts, strict=True)
    return tuple(np.asarray((np.arange(n) + 0.5) * (side / n)) for side, n in pairs)


def plane_map(xs: Array, ys: Array, measure: Callable[[Array], Array]) -> Array:
    """`measure` of the points (x, y), as an image (len(ys), len(xs))."""
    x, y = np.meshgrid(xs, ys)
    return measure(np.stack([x.ravel(), y.ravel()], axis=-1)).reshape(x.shape)


def show_map(
    axes: Axes, image: Array, size: Sequence[float], label: str, low: float, high: float
) -> None:
    """A map over the rectangle from the origin, with its scale; white where undefined."""
    mm = [1e3 * side for side in size]
    shown = axes.imshow(
        image, origin="lower", extent=(0, mm[0], 0, mm[1]), cmap=COLOURS, vmin=low, vmax=high
    )
    axes.grid(False)
    axes.figure.colorbar(shown, ax=axes, label=label, shrink=0.85)
    set_millimetres(axes)


def set_millimetres(axes: Axes) -> None:
    """Axes to scale, in millimetres."""
    axes.set_aspect("equal")
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("y [mm]")
