"""Yoon et al. 2023, Table I and Fig. 17: the Z-width that the table's own k, b and m give."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes

from turnbuckle.lab.figures.drawing import picture
from turnbuckle.lab.figures.findings import Drawn, Finding
from turnbuckle.model.machine import Machine, Wall

#: Where the table states the Z-width, and what is drawn [Hz].
STATED, DRAWN = np.array([0.5, 4.0]), np.geomspace(0.3, 10.0, 200)
WALL, FREE, PRINTED = "#0072B2", "#E69F00", "#222222"
Reals = npt.NDArray[np.float64]


class FreeSpace(NamedTuple):
    """What Table I prints of a direction beside the wall, which is in the machine file."""

    wall: str
    """Name of the machine's wall there."""
    mass: float
    """[kg]"""
    damping: float
    """[N s/m]"""
    z_width: tuple[float, float]
    """At STATED [dB]."""

    def impedance(self, frequency: Reals) -> Reals:
        """|m s + b| at frequencies [Hz], in dB of 1 N s/m."""
        return decibels(np.abs(2j * np.pi * frequency * self.mass + self.damping))


TABLE = {
    "x": FreeSpace("right", 0.1039, 2.873, (47.84, 27.39)),
    "y": FreeSpace("top", 0.0413, 2.703, (49.19, 31.40)),
}


def decibels(ratio: Reals) -> Reals:
    """A ratio of magnitudes in dB."""
    return 20 * np.log10(ratio)


def wall_impedance(wall: Wall, frequency: Reals) -> Reals:
    """|k / s + b| at frequencies [Hz], in dB of 1 N s/m."""
    return decibels(np.abs(wall.stiffness / (2j * np.pi * frequency) + wall.damping))


def z_width(wall: Wall, free: FreeSpace) -> Reals:
    """From free space up to the wall at STATED [dB]."""
    return wall_impedance(wall, STATED) - free.impedance(STATED)


def rendered_stiffness(wall: Wall, free: FreeSpace) -> Reals:
    """Stiffness [N/m] of the wall that would give what is printed, at each of STATED."""
    magnitude = 10 ** ((free.impedance(STATED) + np.array(free.z_width)) / 20)
    return np.asarray(2 * np.pi * STATED * np.sqrt(magnitude**2 - wall.damping**2))


def table1(machine: Machine) -> Drawn:
    """The models of wall and free space, and the Z-width that is printed between them."""
    walls = {wall.name: wall for wall in machine.walls}
    rows = [(name, walls[free.wall], free) for name, free in TABLE.items()]
    with picture("yoon_table1.png", 12, 4.0) as figure:
        for panel, row in zip(figure.subplots(1, 2, sharey=True), rows, strict=True):
            draw(panel, *row)
    return Drawn(
        "yoon_table1.png",
        "Impedance of wall (k/s + b) and free space (ms + b) with the numbers of Table I; arrows:"
        " the Z-width that the table prints, from free space up.",
        tuple(finding for row in rows for finding in findings(*row)),
    )


def draw(axes: Axes, name: str, wall: Wall, free: FreeSpace) -> None:
    """Both models over frequency, and what is printed."""
    axes.semilogx(DRAWN, wall_impedance(wall, DRAWN), color=WALL, label="wall, k/s + b")
    axes.semilogx(DRAWN, free.impedance(DRAWN), color=FREE, label="free space, ms + b")
    for frequency, low, printed in zip(STATED, free.impedance(STATED), free.z_width, strict=True):
        arrow = {"arrowstyle": "->", "color": PRINTED, "shrinkA": 0, "shrinkB": 0}
        axes.annotate("", (frequency, low + printed), (frequency, low), arrowprops=arrow)
        axes.text(1.06 * frequency, low + printed / 2, f"{printed:.2f} dB", color=PRINTED)
    axes.set_title(f"{name} direction")
    axes.set_xlabel("frequency [Hz]")
    axes.set_xticks([0.5, 1, 2, 4, 10], ["0.5", "1", "2", "4", "10"])
    axes.minorticks_off()
    if name == "x":
        axes.set_ylabel("impedance [dB of 1 N s/m]")
        axes.legend()


def findings(name: str, wall: Wall, free: FreeSpace) -> tuple[Finding, Finding]:
    """The table's dB from its own numbers, and the unit of its stiffness."""
    where, computed = f"Table I, {name}", z_width(wall, free)
    stiffness = rendered_stiffness(wall, free)
    return (
        Finding(where, "stiffness of the wall", f"{wall.stiffness:.0f} N/mm",
                f"{wall.stiffness:.0f} N/m",
                "in N/mm the Z-width would be 60 dB more than here"),
        Finding(where, "Z-width at 0.5 and 4 Hz from the table's own k, b and m",
                " and ".join(f"{value:.2f} dB" for value in free.z_width),
                " and ".join(f"{value:.2f} dB" for value in computed),
                "the table does not agree with itself; what it prints follows from a wall of"
                f" {stiffness[0]:.0f} and {stiffness[1]:.0f} N/m, less than the one commanded"),
    )  # fmt: skip
