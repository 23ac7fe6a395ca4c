"""Yoon et al. 2023, Figs 4 and 6: tension factor and isotropic force of fixed and movable bases."""

from functools import partial

import numpy as np

from turnbuckle.lab.figures.drawing import PULLEYS, picture, plane_map, show_map
from turnbuckle.lab.figures.findings import Drawn, Finding
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.workspace.feasible import ball_margin, feasible
from turnbuckle.model.workspace.force import isotropic_force, isotropic_force_eq17, tension_factor
from turnbuckle.model.workspace.rows import Array
from turnbuckle.model.workspace.structures import structures

#: Poses of a picture along x and y; the numbers are from the audited grid, borders included.
PICTURE, AUDITED = (253, 142), (101, 57)
SCREEN = (0.506, 0.284)
NO_RAILS = np.zeros(0)


def screen(machine: Machine, counts: tuple[int, int]) -> tuple[Array, Array]:
    """Coordinates [m] of a grid over the screen in the machine's frame, borders included."""
    centre = machine.target.centre
    x, y = (
        np.linspace(c - side / 2, c + side / 2, n)
        for c, side, n in zip(centre, SCREEN, counts, strict=True)
    )
    return x, y


def at(machine: Machine, poses: Array) -> Array:
    """Structure matrices at poses, movable bases where they belong."""
    rails = base_targets(machine, poses) if machine.rails else NO_RAILS
    return structures(machine, poses, rails)


def factor(machine: Machine, poses: Array) -> Array:
    """Tension factor, NaN outside the workspace."""
    return tension_factor(at(machine, poses), machine.tension.min, machine.tension.max)


def force(machine: Machine, poses: Array) -> Array:
    """Isotropic force [N], NaN outside the workspace."""
    s, bounds = at(machine, poses), (machine.tension.min, machine.tension.max)
    inside = feasible(ball_margin(s, *bounds), s, machine.tension.max)
    return np.where(inside, isotropic_force(s, *bounds), np.nan)


def fig4(diagonal: Machine, orthogonal: Machine) -> Drawn:
    """Fixed pulleys in the corners (top) and in the middle of the sides (bottom)."""
    with picture("yoon_fig4.png", 12, 7.4) as figure:
        axes = figure.subplots(2, 2)
        for row, machine in zip(axes, (diagonal, orthogonal), strict=True):
            draw_pair(row, machine, "abcd"[2 * (machine is orthogonal) :])
            bases = 1e3 * np.array([motion.start for motion in machine.base_motions])
            for panel in row:
                panel.plot(*bases.T, **PULLEYS)
    return Drawn(
        "yoon_fig4.png",
        "Tension factor and isotropic force with fixed pulleys, T from 3 to 10 N;"
        " white: outside the wrench-feasible workspace for zero wrench.",
        (
            *fig4_findings(diagonal, "diagonal", "5.98 N"),
            *fig4_findings(orthogonal, "orthogonal", "7.00 N"),
        ),
    )


def draw_pair(row: Array, machine: Machine, letters: str) -> None:
    """Tension factor on the left, isotropic force on the right."""
    xs, ys = screen(machine, PICTURE)
    maps = (
        (factor, "tension factor", 0.3, 1.0),
        (force, "isotropic force [N]", 0.0, 7.0),
    )
    for panel, letter, (measure, label, low, high) in zip(row, letters, maps, strict=False):
        image = plane_map(xs, ys, partial(measure, machine))
        show_map(panel, image, SCREEN, label, low, high)
        panel.set_title(f"({letter}) {label.split(' [')[0]}")


def fig4_findings(machine: Machine, name: str, published: str) -> tuple[Finding, ...]:
    """Centre and share of the screen."""
    centre = at(machine, np.array([machine.target.centre]))
    bounds = machine.tension.min, machine.tension.max
    exact = float(isotropic_force(centre, *bounds)[0])
    xs, ys = screen(machine, AUDITED)
    margins = plane_map(xs, ys, lambda poses: force(machine, poses))
    factors = plane_map(xs, ys, lambda poses: factor(machine, poses))
    share = float(np.mean(~np.isnan(margins)))
    where = f"Fig. 4, {name}"
    return (
        Finding(where, "isotropic force at the centre", published, f"{exact:.12f} N"),
        Finding(where, "share of the screen that holds the zero wrench (101 x 57 poses)",
                "not printed", f"{share:.1%}",
                "the paper only says that the diagonal workspace is the larger one; it is"),
        Finding(where, "lowest tension factor in the workspace", "0.3",
                f"{np.nanmin(factors):.4f}",
                "0.3 is T_min / T_max, which the bounds on T0 impose"),
        *eq17_finding(machine, where),
    )  # fmt: skip


def eq17_finding(machine: Machine, where: str) -> tuple[Finding, ...]:
    """How far eq. 17 is below the facets."""
    xs, ys = screen(machine, AUDITED)
    x, y = np.meshgrid(xs, ys)
    s = at(machine, np.stack([x.ravel(), y.ravel()], axis=-1))
    bounds = machine.tension.min, machine.tension.max
    short = isotropic_force(s, *bounds) - isotropic_force_eq17(s, *bounds)
    rounding = 1e3 * np.finfo(float).eps * machine.tension.max
    share = float(np.sum(short > rounding) / np.sum(~np.isnan(short)))
    if share == 0:
        what = "isotropic force of eq. 17 against that of the facets"
        return (Finding(where, what, "taken for the same", "the same at all poses"),)
    return (
        Finding(where, "isotropic force of eq. 17 against that of the facets",
                "taken for the same",
                f"lower at {share:.0%} of the poses, by up to {max(0.0, np.nanmax(short)):.3f} N",
                "eq. 17 looks at four parallelograms of tension margins, which lie within the set"
                " of feasible forces; the maps above are exact"),
    )  # fmt: skip


def fig6(machine: Machine) -> Drawn:
    """Movable bases in the orthogonal configuration."""
    with picture("yoon_fig6.png", 12, 4.0) as figure:
        draw_pair(figure.subplots(1, 2), machine, "ab")
    xs, ys = screen(machine, AUDITED)
    factors = plane_map(xs, ys, lambda poses: factor(machine, poses))
    forces = plane_map(xs, ys, lambda poses: force(machine, poses))
    return Drawn(
        "yoon_fig6.png",
        "The same with movable bases, every cable square to its rail.",
        (
            Finding("Fig. 6", "tension factor on the screen", "1", spread(factors, "")),
            Finding("Fig. 6", "isotropic force on the screen", "7 N", spread(forces, " N")),
        ),
    )


def spread(values: Array, unit: str) -> str:
    """Least and largest value."""
    low, high = np.nanmin(values), np.nanmax(values)
    return f"{low:.12g} to {high:.12g}{unit}"
