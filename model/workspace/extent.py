"""How far a machine's workspace reaches, whatever its target is."""

from itertools import product
from typing import NamedTuple

import numpy as np

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.workspace.feasible import wrench_closure
from turnbuckle.model.workspace.grid import frame_grid
from turnbuckle.model.workspace.inscribed import Inscribed, largest_circle, largest_screen
from turnbuckle.model.workspace.quality import wanted_margin
from turnbuckle.model.workspace.rows import Array
from turnbuckle.model.workspace.structures import structures
from turnbuckle.model.workspace.summary import fine_grid
from turnbuckle.model.workspace.tension_capable import CapableRegion, capable_region

CELLS = {2: 100, 3: 20}  # along the longest side of the frame, by the dimension of its space
INSCRIBED_CELLS = 60
ROWS = 1 << 14  # poses at a time


class Extent(NamedTuple):
    """theoretical: share of the frame, upright, where every wrench is feasible without a T_max.

    circle and screen: the largest with the wanted force and moment at every wanted rotation, the
    screen with the target's sides in proportion; None for machines in space, and where there is
    none. capable: the tension capable workspace, where its boundary has a closed form, else None.
    """

    theoretical: float
    circle: Inscribed | None
    screen: Inscribed | None
    capable: CapableRegion | None


def workspace_extent(machine: Machine) -> Extent:
    """All of it; the largest circle and screen take some seconds."""
    circle = screen = None
    if machine.space == 2:
        box = (0.0, 0.0), machine.frame.size
        width, height = machine.target.size

        def margin(positions: Array) -> Array:
            return least_margin(machine, positions)

        circle = largest_circle(margin, *box, cells=INSCRIBED_CELLS)
        screen = largest_screen(margin, *box, width / height, cells=INSCRIBED_CELLS)
    return Extent(theoretical_share(machine), circle, screen, tension_capable(machine))


def least_margin(machine: Machine, positions: Array) -> Array:
    """The least margin (rows) [N] of what is wanted over all rotations, positions (rows, space)."""
    turns = np.array(list(product(*fine_grid(machine).axes[machine.space :])), np.float64)
    poses = np.empty((len(turns), len(positions), machine.dof))
    poses[..., : machine.space] = positions
    poses[..., machine.space :] = turns[:, None]
    return np.asarray(np.min(wanted_margin(machine, poses), axis=0))


def theoretical_share(machine: Machine) -> float:
    """Share of the frame, upright, that is theoretical workspace."""
    size = machine.frame.size
    cell = max(size) / CELLS[machine.space]
    grid = frame_grid(machine, [max(1, round(side / cell)) for side in size])
    inside = sum(
        int(np.sum(wrench_closure(structures(machine, poses, base_targets(machine, poses)))))
        for poses in grid.tiles(ROWS)
    )
    return inside / grid.size


def tension_capable(machine: Machine) -> CapableRegion | None:
    """The TCW of a planar point with three or four fixed pulleys at corners, and T_min = 0."""
    fixed = not machine.rails and not any(machine.pulleys)
    if machine.is_rigid or machine.space != 2 or not fixed or machine.tension.min > 0:
        return None
    pulleys = [motion.start for motion in machine.base_motions]
    try:
        return capable_region(pulleys, machine.target.force / machine.tension.max)
    except ValueError:  # five pulleys, or one inside the polygon of the others
        return None
