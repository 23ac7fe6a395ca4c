"""Where movable bases should be for a pose, and what it costs when they lag behind the hand."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.stats import qmc

from turnbuckle.model.machine import Machine
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.workspace.force import isotropic_force, isotropic_limits
from turnbuckle.model.workspace.maximin import climb
from turnbuckle.model.workspace.rows import Array
from turnbuckle.model.workspace.structures import structures

SAMPLES = 1 << 11  # of all rail coordinates, to start from
STARTS = 4  # of them, the best
REACH = 0.1  # of the shortest rail: the first steps
DIFFERENCE = 1e-6  # of a rail, for slopes
EQUAL = 1e-9  # of the force: what the search leaves
AROUND = 16  # directions of lag in a plane

Rule = Callable[[Machine, Array], npt.NDArray[np.floating]]


class BestRails(NamedTuple):
    """rails (m) [m] and the isotropic force I_F [N] that they give: 0 where none is feasible.

    searched [N] is the largest that the global search came to by itself.
    """

    rails: Array
    force: float
    searched: float


def best_rails(machine: Machine, pose: npt.ArrayLike) -> BestRails:
    """The rail coordinates within their limits with the largest true I_F at a pose (dim).

    Global search over all rails at once: samples that fill the box, then climbs from the best.
    Often many places are equally good, as a cross of cables may be turned. If the one with the
    shortest cables is among them, it is returned: the feet of the perpendiculars, Yoon's orthogonal
    configuration. Deterministic. ValueError for a machine without rails.
    """
    if not machine.rails:
        raise ValueError(f"{machine.name} has no movable base")
    search = _Search(machine, np.asarray(pose, np.float64))
    samples = qmc.Sobol(len(machine.rails), rng=0).random(SAMPLES) * search.lengths
    order = np.argsort(search.forces(samples))
    found = np.stack([search.climbed(start) for start in samples[order[-STARTS:]]])
    forces = search.forces(found)
    searched = float(np.max(forces))
    shortest = np.asarray(base_targets(machine, search.pose), np.float64)
    force = float(search.forces(shortest[None])[0])
    if force >= (1 - EQUAL) * searched:
        return BestRails(shortest, force, searched)
    return BestRails(found[np.argmax(forces)], searched, searched)


class _Search:
    """The isotropic force at a pose as a function of the rail coordinates."""

    def __init__(self, machine: Machine, pose: Array) -> None:
        self.machine, self.pose = machine, pose
        self.bounds = machine.tension.min, machine.tension.max
        self.lengths = np.array([rail.length for rail in machine.rails])

    def forces(self, rails: Array) -> Array:
        """I_F (rows) [N] for rails (rows, m) [m]; 0 where it is not defined."""
        s = structures(self.machine, self.pose, rails)
        return np.nan_to_num(isotropic_force(s, *self.bounds, self.machine.space), nan=0.0)

    def limits(self, rails: Array) -> Array:
        """What every facet allows of I_F (rows, f) [N]: smooth almost everywhere."""
        s = structures(self.machine, self.pose, rails)
        return isotropic_limits(s, *self.bounds, self.machine.space)

    def climbed(self, start: Array) -> Array:
        """The best rails (m) near the given ones."""
        small = DIFFERENCE * self.lengths

        def values(rails: Array) -> Array:
            limits = self.limits(rails[None])[0]
            return np.where(np.isnan(limits), -self.bounds[1], limits)

        def slopes(rails: Array, _: Array) -> Array:
            sides = [self.limits(rails + side * np.diag(small)) for side in (1, -1)]
            return np.asarray((sides[0] - sides[1]).T / (2 * small))

        trust = REACH * float(np.min(self.lengths))
        return climb(values, slopes, start, trust, np.zeros(len(start)), self.lengths)[0]


def lagging_force(
    machine: Machine,
    poses: npt.ArrayLike,
    lag: float,
    rule: Rule = base_targets,
    directions: npt.ArrayLike | None = None,
) -> Array:
    """Least I_F (rows) [N] at poses (rows, dim) when the bases are where they should have been.

    The hand has moved on by `lag` [m] in the worst of the directions (k, space), by default
    `lag_directions`; `rule` gives the rail coordinates for a pose. NaN where the platform touches
    a pulley.
    """
    places = np.atleast_2d(np.asarray(poses, np.float64))
    ways = (
        lag_directions(machine.space) if directions is None else np.asarray(directions, np.float64)
    )
    least = np.full(len(places), np.inf)
    for way in ways:
        behind = places.copy()
        behind[:, : machine.space] -= lag * way
        s = structures(machine, places, rule(machine, behind))
        force = isotropic_force(s, machine.tension.min, machine.tension.max, machine.space)
        least = np.minimum(least, force)
    return least


def lag_directions(space: int) -> Array:
    """Unit vectors (k, space): 16 around a plane; in space 14, to faces and corners of a cube."""
    if space == 2:
        angle = 2 * np.pi * np.arange(AROUND) / AROUND
        return np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    cube = np.stack(np.meshgrid(*[[-1.0, 0.0, 1.0]] * 3), axis=-1).reshape(-1, 3)
    nonzero = np.count_nonzero(cube, axis=-1)
    ways = cube[(nonzero == 1) | (nonzero == 3)]
    return np.asarray(ways / np.linalg.norm(ways, axis=-1, keepdims=True))
