"""Yoon et al. 2023, Fig. 5: isotropic force in the force polygon, from the generated C."""

from itertools import product

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon
from scipy.spatial import ConvexHull

from turnbuckle.codegen.bind import Generated, generate_into_cache
from turnbuckle.lab.figures.drawing import picture
from turnbuckle.lab.figures.findings import Drawn, Finding
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.control import base_targets

#: The pose of the diagram, from the centre of the target [m].
AWAY = np.array([0.12, 0.01])
CABLE, PAIR, EXACT, EQ17 = "#222222", "#0072B2", "#009E73", "#E69F00"
Reals = npt.NDArray[np.float64]


class Diagram:
    """Forces at one pose of a machine of planar points, in the frame's axes [N]."""

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        c = Generated(machine, generate_into_cache(machine), "double")
        pose = np.array(machine.target.centre) + AWAY
        arguments = [pose, base_targets(machine, pose) if machine.rails else np.zeros(0)]
        left = machine.tension.max - np.asarray(c.zero_wrench_tension(*arguments))
        structure = np.asarray(c.structure_matrix(*arguments))
        self.arrows: Reals = (structure * left).T
        """What is left of every cable's tension, along the cable (n, 2)."""
        bounds = (machine.tension.min, machine.tension.max)
        corners = np.array(list(product(bounds, repeat=len(self.arrows)))) @ structure.T
        self.polygon: Reals = corners[ConvexHull(corners).vertices]
        """Corners of all the forces that the cables can give (m, 2)."""
        self.exact = float(c.isotropic_force(*arguments))
        self.eq17 = float(c.isotropic_force_eq17(*arguments))

    def parallelograms(self) -> list[Reals]:
        """Of neighbouring arrows, four corners each."""
        around = self.arrows[np.argsort(np.arctan2(*self.arrows.T[::-1]))]
        pairs = zip(around, np.roll(around, -1, axis=0), strict=True)
        return [np.array([0 * a, a, a + b, b]) for a, b in pairs]


def fig5(machines: tuple[Machine, Machine]) -> Drawn:
    """Fixed pulleys in the corners (left), and bases that follow (right), at the same pose."""
    diagrams = [Diagram(machine) for machine in machines]
    with picture("yoon_fig5.png", 12, 5.4) as figure:
        for panel, diagram in zip(
            figure.subplots(1, 2, sharex=True, sharey=True), diagrams, strict=True
        ):
            draw(panel, diagram)
    return Drawn(
        "yoon_fig5.png",
        "Isotropic force 120 mm right of the centre and 10 mm above it, from the generated C: what"
        " is left of the tensions (arrows), parallelograms of neighbours (blue) with the circle of"
        " eq. 17 (orange), all forces that the cables can give (green) with the exact circle.",
        tuple(finding(diagram) for diagram in diagrams),
    )


def draw(axes: Axes, diagram: Diagram) -> None:
    """The diagram of one machine."""
    for corners in diagram.parallelograms():
        axes.add_patch(Polygon(corners, fc=f"{PAIR}22", ec=PAIR, lw=1))
    axes.add_patch(Polygon(diagram.polygon, fc="none", ec=EXACT, lw=1.8, label="all forces"))
    for radius, colour, style, label in (
        (diagram.exact, EXACT, "-", "exact"),
        (diagram.eq17, EQ17, "--", "eq. 17"),
    ):
        text = f"{label}: {radius:.2f} N"
        axes.add_patch(Circle((0, 0), radius, fc="none", ec=colour, ls=style, lw=2, label=text))
    for arrow in diagram.arrows:
        axes.annotate("", arrow, (0, 0), arrowprops={"arrowstyle": "-|>", "color": CABLE, "lw": 2})
    axes.set_title(diagram.machine.name)
    axes.set_xlabel("force along x [N]")
    axes.set_ylabel("force along y [N]")
    axes.set_aspect("equal")
    axes.set(xlim=(-15, 19), ylim=(-10, 10))
    axes.legend(loc="lower right")


def finding(diagram: Diagram) -> Finding:
    """Both radii."""
    same = np.isclose(diagram.eq17, diagram.exact, rtol=1e-9, atol=0)
    return Finding(
        "Fig. 5",
        f"isotropic force of eq. 17 at the pose of the diagram, {diagram.machine.name}",
        "not printed",
        f"{diagram.eq17:.3f} N",
        "the same as that of the facets"
        if same
        else f"the polygon of all forces has {diagram.exact:.3f} N",
    )
