"""Yoon et al. 2023, Figs 4 and 6: tension factor and isotropic force, from the generated C."""

from typing import NamedTuple

import numpy as np

from turnbuckle.codegen.bind import Generated, generate_into_cache
from turnbuckle.codegen.pose_map import PoseMap, target_grid
from turnbuckle.lab.figures.drawing import PULLEYS, picture, show_map
from turnbuckle.lab.figures.findings import Drawn, Finding
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import Status
from turnbuckle.model.workspace.rows import Array

#: Poses of a picture along x and y; the numbers are from the audited grid, borders included.
PICTURE, AUDITED = (253, 142), (101, 57)
SCREEN = (0.506, 0.284)


class Maps(NamedTuple):
    """What the generated C says of a grid over the screen, NaN outside the workspace."""

    factor: Array
    """Tension factor (rows, columns)."""
    force: Array
    """Isotropic force (rows, columns) [N]."""


def generated(machine: Machine) -> Generated:
    """The machine's C in double precision."""
    return Generated(machine, generate_into_cache(machine), "double")


def maps(machine: Machine, counts: tuple[int, int]) -> Maps:
    """Maps of so many poses along x and y; movable bases are where they belong."""
    tiles = list(PoseMap(generated(machine)).tiles(target_grid(machine, *counts)))
    factor = np.concatenate([tile.factor for tile in tiles])
    force = np.concatenate([tile.margin for tile in tiles])
    inside = force >= 0
    return Maps(np.where(inside, factor, np.nan), np.where(inside, force, np.nan))


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
    drawn = maps(machine, PICTURE)
    images = (
        (drawn.factor, "tension factor", 0.3, 1.0),
        (drawn.force, "isotropic force [N]", 0.0, 7.0),
    )
    for panel, letter, (image, label, low, high) in zip(row, letters, images, strict=False):
        show_map(panel, image, SCREEN, label, low, high)
        panel.set_title(f"({letter}) {label.split(' [')[0]}")


def fig4_findings(machine: Machine, name: str, published: str) -> tuple[Finding, ...]:
    """Centre and share of the screen."""
    no_rails = np.zeros(0)
    exact = float(generated(machine).isotropic_force(np.array(machine.target.centre), no_rails))
    audited = maps(machine, AUDITED)
    share = float(np.mean(~np.isnan(audited.force)))
    where = f"Fig. 4, {name}"
    return (
        Finding(where, "isotropic force at the centre", published, f"{exact:.12f} N"),
        Finding(where, "share of the screen that holds the zero wrench (101 x 57 poses)",
                "not printed", f"{share:.1%}",
                "the paper only says that the diagonal workspace is the larger one; it is"),
        Finding(where, "lowest tension factor in the workspace", "0.3",
                f"{np.nanmin(audited.factor):.4f}",
                "0.3 is T_min / T_max, which the bounds on T0 impose"),
        *eq17_finding(machine, where),
    )  # fmt: skip


def eq17_finding(machine: Machine, where: str) -> tuple[Finding, ...]:
    """How far eq. 17 is below the facets."""
    grid = target_grid(machine, *AUDITED)
    c, poses = generated(machine), grid.poses(range(grid.rows))
    by_facets, by_eq17 = (
        np.where(found.status == Status.OK, found, np.nan)
        for found in (f(poses, np.zeros(0)) for f in (c.isotropic_force, c.isotropic_force_eq17))
    )
    short = by_facets - by_eq17
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
    audited = maps(machine, AUDITED)
    return Drawn(
        "yoon_fig6.png",
        "The same with movable bases, every cable square to its rail.",
        (
            Finding("Fig. 6", "tension factor on the screen", "1", spread(audited.factor, "")),
            Finding("Fig. 6", "isotropic force on the screen", "7 N", spread(audited.force, " N")),
        ),
    )


def spread(values: Array, unit: str) -> str:
    """Least and largest value."""
    low, high = np.nanmin(values), np.nanmax(values)
    return f"{low:.12g} to {high:.12g}{unit}"
