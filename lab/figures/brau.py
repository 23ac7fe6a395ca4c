"""Brau, Lallemand and Gosselin, Figs 3 to 8: workspaces and tensions of point platforms."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.patches import Circle, Polygon

from turnbuckle.lab.figures.drawing import (
    BOUNDARY,
    CAPABLE,
    INCAPABLE,
    PULLEYS,
    cells,
    line_colours,
    picture,
    plane_map,
    set_millimetres,
)
from turnbuckle.lab.figures.findings import Drawn, Finding
from turnbuckle.model.machine import Machine
from turnbuckle.model.workspace.feasible import wrench_closure
from turnbuckle.model.workspace.force import isotropic_force
from turnbuckle.model.workspace.max_tension import (
    max_tension_adjacent,
    max_tension_eq12,
    max_tension_eq17,
)
from turnbuckle.model.workspace.rows import Array
from turnbuckle.model.workspace.structures import structures
from turnbuckle.model.workspace.tension_capable import (
    CapableRegion,
    capable_ratio_eq23,
    capable_region,
    largest_circle_eq22,
)

NO_RAILS = np.zeros(0)
FORCE = 10.0  # N, of Figs 4 and 5
LEVELS = (10, 10.5, 11, 12, 14, 17, 20, 25, 30)  # N, lines of equal tension
FINE = 400  # cells along a side of a picture


def pulleys(machine: Machine) -> Array:
    """Places of the fixed pulleys (n, space) [m]."""
    return np.array([motion.start for motion in machine.base_motions])


def ratio(machine: Machine, poses: Array) -> Array:
    """Largest F / t_max in every direction (rows), t_min = 0, by the facets."""
    return isotropic_force(structures(machine, poses, NO_RAILS), 0.0, 1.0)


def fig3(five: Machine) -> Drawn:
    """Theoretical workspaces of three and of four of five pulleys."""
    points = pulleys(five)
    chosen = ((1, 2, 4), (0, 1, 2, 3))
    xs, ys = cells(five.frame.size, (FINE, FINE))
    shares = []
    with picture("brau_fig3.png", 9, 4.6) as figure:
        for axes, cables in zip(figure.subplots(1, 2), chosen, strict=True):

            def closed(poses: Array, cables: tuple[int, ...] = cables) -> Array:
                s = structures(five, poses, NO_RAILS)[..., list(cables)]
                return wrench_closure(s).astype(float)

            image = plane_map(xs, ys, closed)
            shares.append(float(np.mean(image)))
            show_region(axes, image, five.frame.size)
            axes.add_patch(Polygon(1e3 * points[list(cables)], fill=False, **BOUNDARY))
            axes.plot(*(1e3 * points.T), **PULLEYS)
            for number, (x, y) in enumerate(1e3 * points, start=1):
                axes.annotate(f"$A_{number}$", (x, y), (6, 6), textcoords="offset points")
            axes.set_title("cables " + ", ".join(str(c + 1) for c in cables))
    return Drawn(
        "brau_fig3.png",
        "Theoretical workspace with three and with four of five motors: computed point by point"
        " (colour), and the polygon of the pulleys (line).",
        (
            Finding("Fig. 3", "workspace of cables 2, 3, 5", "triangle A2 A3 A5",
                    f"{shares[0]:.1%} of the square; the triangle is 50 %"),
            Finding("Fig. 3", "workspace of cables 1 to 4", "square A1 A2 A3 A4, much larger",
                    f"{shares[1]:.1%} of the square"),
        ),
    )  # fmt: skip


def show_region(axes: Axes, image: Array, size: tuple[float, ...]) -> None:
    """Poses inside (1) and outside (0) in two colours."""
    width, height = 1e3 * size[0], 1e3 * size[1]
    colours = ListedColormap([INCAPABLE, CAPABLE])
    axes.imshow(image, origin="lower", extent=(0, width, 0, height), cmap=colours, vmin=0, vmax=1)
    axes.grid(False)
    set_millimetres(axes)


def fig4_and_5(square: Machine) -> tuple[Drawn, Drawn]:
    """Lines of equal maximum tension of every cable: the largest, the second and the right one."""
    xs, ys = cells(square.frame.size, (FINE, FINE))
    first = tension_maps(square, xs, ys, max_tension_eq12)
    second = tension_maps(square, xs, ys, max_tension_eq17)
    exact = tension_maps(square, xs, ys, max_tension_adjacent)
    draw_lines("brau_fig4.png", square, xs, ys, first)
    draw_lines("brau_fig5.png", square, xs, ys, second, exact)
    limit = 2 * FORCE
    wrong, right = (float(np.mean(np.max(each, axis=0) <= limit)) for each in (second, exact))
    return (
        Drawn(
            "brau_fig4.png",
            "Largest tension of each cable over all pairs that contain it (eq. 17 as printed)"
            " for 10 N in every direction.",
            (
                Finding("Fig. 4", "largest tension on the diagonals", "without limit",
                        f"up to {np.max(first):.0f} N on a grid of {FINE} x {FINE}",
                        "pairs of opposite cables are counted, which nobody would use"),
            ),
        ),
        Drawn(
            "brau_fig5.png",
            "The second largest (solid), the paper's remedy, and the largest over neighbouring"
            " cables (dashed), which is exact.",
            (
                Finding("Fig. 5", "poses where 10 N needs at most 20 N, 400 x 400 cells",
                        "not printed", f"{wrong:.1%} by the second largest, {right:.1%} exactly",
                        "off the centre the second largest is not the tension that is needed:"
                        " the pair across the largest gap decides"),
            ),
        ),
    )  # fmt: skip


def tension_maps(machine: Machine, xs: Array, ys: Array, rule: object) -> list[Array]:
    """Largest tension of every cable [N] over the square."""
    assert callable(rule)

    def measure(poses: Array) -> Array:
        return np.asarray(rule(structures(machine, poses, NO_RAILS), FORCE))

    x, y = np.meshgrid(xs, ys)
    values = measure(np.stack([x.ravel(), y.ravel()], axis=-1))
    return [column.reshape(x.shape) for column in values.T]


def draw_lines(
    name: str,
    machine: Machine,
    xs: Array,
    ys: Array,
    maps: list[Array],
    exact: list[Array] | None = None,
) -> None:
    """Contours of one panel a cable."""
    with picture(name, 9, 9) as figure:
        panels = figure.subplots(2, 2).ravel()
        for cable, (axes, image) in enumerate(zip(panels, maps, strict=True)):
            lines = axes.contour(
                1e3 * xs, 1e3 * ys, image, LEVELS, colors=line_colours(len(LEVELS))
            )
            axes.clabel(lines, fmt="%g N", fontsize=8)
            if exact:
                axes.contour(
                    1e3 * xs, 1e3 * ys, exact[cable], LEVELS, colors="#222222", linestyles="--",
                    linewidths=0.8,
                )  # fmt: skip
            axes.plot(*(1e3 * pulleys(machine).T), **PULLEYS)
            axes.set_title(f"cable {cable + 1}")
            set_millimetres(axes)


def fig6(triangle: Machine) -> Drawn:
    """Tension capable workspace of the triangle, with its arcs and the largest circle."""
    wanted = triangle.target.force / triangle.tension.max
    points = pulleys(triangle)
    region = capable_region(points, wanted)
    circumradius = float(np.linalg.norm(points[0] - points.mean(axis=0)))
    radius = largest_circle_eq22(circumradius, wanted)
    with picture("brau_fig6.png", 6.4, 5.6) as figure:
        axes = figure.subplots()
        share = draw_capable(axes, triangle, region, wanted, (FINE, FINE))
        centre = 1e3 * points.mean(axis=0)
        axes.add_patch(Circle(tuple(centre), 1e3 * radius, fill=False, color="#009E73", lw=2.2))
    printed = capable_region(points, 1.0)
    return Drawn(
        "brau_fig6.png",
        "Tension capable workspace of three cables for 10 N and 20 N at most: point by point"
        " (colour), its arcs (blue), the largest circle of eq. 22 (green).",
        (
            Finding("Fig. 6", "workspace for 10 N with a limit of 10 N", "drawn, not empty",
                    f"empty ({printed})" if not printed.arcs else f"{printed.share:.1%}",
                    "F / t_max = 1 asks for neighbouring cables at 90 degrees; an equilateral"
                    " triangle gives at best sqrt(3)/2. Another limit was drawn; here 20 N"),
            Finding("Fig. 6", "share of the triangle for 10 N with 20 N", "not printed",
                    f"{region.share:.2%} by the arcs, {share:.2%} point by point",
                    "arcs and points agree, as the paper found"),
            Finding("Fig. 6, eq. 22", "largest circle, in circumradii", "eq. 22",
                    f"{radius / circumradius:.6f}", "eq. 22 is right; r is the circumradius"),
        ),
    )  # fmt: skip


def draw_capable(
    axes: Axes, machine: Machine, region: CapableRegion, wanted: float, counts: tuple[int, int]
) -> float:
    """Capable poses and the boundary; returns their share of the theoretical workspace."""
    xs, ys = cells(machine.frame.size, counts)
    ratios = plane_map(xs, ys, lambda poses: ratio(machine, poses))
    inside = plane_map(
        xs,
        ys,
        lambda poses: wrench_closure(structures(machine, poses, NO_RAILS)).astype(float),
    )
    capable = (ratios >= wanted).astype(float)
    show_region(axes, capable, machine.frame.size)
    for arc in region.arcs:
        axes.plot(*(1e3 * arc.points(np.linspace(0, 1, 100)).T), **BOUNDARY)
    axes.plot(*(1e3 * pulleys(machine).T), **PULLEYS)
    return float(np.sum(capable) / np.sum(inside))


def fig7(tetrahedron: Machine) -> Drawn:
    """Tension capable workspace of the tetrahedron, in slices and in space."""
    wanted = tetrahedron.target.force / tetrahedron.tension.max
    axes_of_grid = cells(tetrahedron.frame.size, (60, 60, 60))
    x, y, z = np.meshgrid(*axes_of_grid, indexing="ij")
    poses = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=-1)
    s = structures(tetrahedron, poses, NO_RAILS)
    exact, rule = isotropic_force(s, 0.0, 1.0), capable_ratio_eq23(s)
    capable, closed = exact >= wanted, wrench_closure(s)
    with picture("brau_fig7.png", 7, 6.2) as figure:
        axes = figure.add_subplot(projection="3d")
        shown = poses[capable][:: max(1, int(np.sum(capable)) // 9000)]
        axes.scatter(*(1e3 * shown.T), s=3, c=1e3 * shown[:, 2], cmap="viridis", alpha=0.5)
        corners = 1e3 * pulleys(tetrahedron)
        for i in range(4):
            for j in range(i):
                axes.plot(*corners[[i, j]].T, color="#222222", lw=1)
        axes.set(xlabel="x [mm]", ylabel="y [mm]", zlabel="z [mm]")
        axes.set_box_aspect(tetrahedron.frame.size)
    centre = np.array([tetrahedron.target.centre])
    best = float(capable_ratio_eq23(structures(tetrahedron, centre, NO_RAILS))[0])
    gap = float(np.max(np.abs(exact - rule)))
    return Drawn(
        "brau_fig7.png",
        "Tension capable workspace of four cables from a regular tetrahedron, 10 N with 20 N.",
        (
            Finding("Fig. 7", "share of the tetrahedron for 10 N with 20 N", "not printed",
                    f"{np.sum(capable) / np.sum(closed):.1%} of {np.sum(closed)} points"),
            Finding("Fig. 7, eq. 23", "largest F / t_max in the centre",
                    "eq. 23 with max: larger values count",
                    f"{best:.10f} (sqrt(2/3) = {np.sqrt(2 / 3):.10f})",
                    "eq. 23 must take the smallest triple; with it, it agrees with the facets"
                    f" to {gap:.0e} everywhere"),
        ),
    )  # fmt: skip


def fig8(square: Machine) -> Drawn:
    """Tension capable workspace of the square, on the paper's grid and by its arcs."""
    wanted = square.target.force / square.tension.max
    region = capable_region(pulleys(square), wanted)
    with picture("brau_fig8.png", 6.4, 5.8) as figure:
        axes = figure.subplots()
        share = draw_capable(axes, square, region, wanted, (FINE, FINE))
    inner = np.linspace(0, square.frame.size[0], 52)[1:-1]
    papers = float(np.mean(plane_map(inner, inner, lambda p: ratio(square, p)) >= wanted))
    rule = plane_map(inner, inner, lambda p: second_largest(square, p))
    by_rule = float(np.mean(rule <= square.target.force / wanted))
    exact = 1 - 2 * (np.pi / 3 - np.sqrt(3) / 2)
    return Drawn(
        "brau_fig8.png",
        "Tension capable workspace of four cables from a square, 5 N with 10 N at most.",
        (
            Finding("Fig. 8", "share of the square by area", "not printed",
                    f"{region.share:.6%} by the arcs, {share:.2%} on {FINE} x {FINE} cells",
                    f"1 - 2 (pi/3 - sqrt(3)/2) = {exact:.6%}"),
            Finding("Fig. 8", "share of the paper's 50 x 50 points", "not printed",
                    f"{papers:.1%}",
                    f"the second largest of Fig. 5 would call {by_rule:.1%} of them capable"),
        ),
    )  # fmt: skip


def second_largest(machine: Machine, poses: Array) -> Array:
    """Largest tension [N] of any cable by the paper's rule, for the wanted force."""
    s = structures(machine, poses, NO_RAILS)
    return np.asarray(np.max(max_tension_eq17(s, machine.target.force), axis=-1))
