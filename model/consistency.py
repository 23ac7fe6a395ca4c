"""What must hold between the keys of a machine file, once each key is right by itself."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from model.problem import FOUND_NOTHING, Location, Problem, key_path, shown

if TYPE_CHECKING:
    from model.machine import Machine

MOST_CABLES = 16
MOST_WALLS = 16
# A product of two rounded numbers may miss an exact limit by this much.
ROUNDING = 4 * sys.float_info.epsilon
# Two cables nearer than this angle [rad] are parallel on any machine that can be built.
PARALLEL = 1e-9
SAMPLES_PER_SIDE = 5

Found = Iterator[Problem]
Tables = dict[str, Any]
XY = tuple[float, float]


def consistency_problems(machine: Machine, tables: Tables) -> list[Problem]:
    """All problems of a machine whose keys are right by themselves; `tables` is the TOML."""
    problems = [problem for rule in RULES for problem in rule(machine, tables)]
    # Directions are asked of bases that are known to exist and of rails that have a length.
    return problems or [
        *_parallel_cables(machine, tables),
        *_bases_on_one_line(machine, tables),
    ]


def _problem(tables: Tables, location: Location, allowed: str) -> Problem:
    """A problem whose `found` is what the file says at `location`."""
    value: Any = tables
    for part in location:
        value = value[part]
    return Problem(key_path(location), shown(value), allowed)


def _counts(machine: Machine, tables: Tables) -> Found:
    cables, fewest = len(machine.cables), machine.dof + 1
    if not fewest <= cables <= MOST_CABLES:
        allowed = f"{fewest} to {MOST_CABLES} cables for the kind {machine.kind}"
        yield Problem("cable", f"{cables} cables", allowed)
    if len(machine.walls) > MOST_WALLS:
        yield Problem("wall", f"{len(machine.walls)} walls", f"0 to {MOST_WALLS} walls")


def _bases(machine: Machine, tables: Tables) -> Found:
    for i, cable in enumerate(machine.cables):
        if cable.fixed is None and cable.rail is None:
            yield Problem(key_path(("cable", i)), "neither base nor rail", "either base or rail")
        elif cable.fixed is not None and cable.rail is not None:
            yield Problem(key_path(("cable", i)), "both base and rail", "either base or rail")
    for location, point in _base_points(machine):
        if not all(0 <= x <= limit for x, limit in zip(point, machine.frame.size, strict=True)):
            yield _problem(tables, location, f"a point inside the frame, {_frame(tables)}")


def _base_points(machine: Machine) -> Iterator[tuple[Location, XY]]:
    """Where the file places bases, and the place."""
    for i, cable in enumerate(machine.cables):
        if cable.fixed is not None:
            yield ("cable", i, "base"), cable.fixed
        if cable.rail is not None:
            yield ("cable", i, "rail", "from"), cable.rail.start
            yield ("cable", i, "rail", "to"), cable.rail.end


def _rail_lengths(machine: Machine, tables: Tables) -> Found:
    for i in machine.rail_cables:
        rail = machine.cables[i].rail
        if rail is not None and rail.start == rail.end:
            yield _problem(tables, ("cable", i, "rail", "to"), "an end other than the rail's from")


def _frame(tables: Tables) -> str:
    return f"from the origin to frame.size = {shown(tables['frame']['size'])}"


def _unique_names(machine: Machine, tables: Tables) -> Found:
    names = {
        ("cable", "drive"): [cable.drive for cable in machine.cables],
        ("wall", "name"): [wall.name for wall in machine.walls],
    }
    for (table, key), words in names.items():
        for i, word in enumerate(words):
            if word in words[:i]:
                first = key_path((table, words.index(word), key))
                allowed = f"a name that differs from {first}"
                yield Problem(key_path((table, i, key)), shown(word), allowed)


def _limits(machine: Machine, tables: Tables) -> Found:
    tension, motor = machine.tension, machine.cable_motor
    if tension.min >= tension.max:
        limit = shown(tables["tension"]["max"])
        yield _problem(tables, ("tension", "min"), f"a force below tension.max = {limit}")
    needed = tension.max * machine.drum.radius
    if motor.torque_limit < needed * (1 - ROUNDING):
        yield _problem(
            tables,
            ("cable_motor", "torque_limit"),
            f"at least tension.max times drum.radius = {needed * 1e3:g} mN*m",
        )


def _observer_share(machine: Machine, tables: Tables) -> Found:
    needed = machine.tension.max * machine.drum.radius
    limit = machine.cable_motor.torque_limit
    if machine.disturbance_observer and needed * (1 - ROUNDING) <= limit <= needed * (1 + ROUNDING):
        yield _problem(
            tables,
            ("cable_motor", "torque_limit"),
            f"more than tension.max times drum.radius = {needed * 1e3:g} mN*m, "
            "because disturbance_observer compensates with what is above",
        )


def _carriages(machine: Machine, tables: Tables) -> Found:
    if machine.plant is None or not machine.rail_cables:
        return
    first = key_path(("cable", machine.rail_cables[0], "rail"))
    for key in ("carriage_mass", "carriage_coulomb_friction", "carriage_viscous_friction"):
        if getattr(machine.plant, key) is None:
            allowed = f"a quantity with its unit, because of {first}"
            yield Problem(key_path(("plant", key)), FOUND_NOTHING, allowed)


def _rail_drive(machine: Machine, tables: Tables) -> Found:
    if machine.rail_cables and machine.rail_drive is None:
        first = key_path(("cable", machine.rail_cables[0], "rail"))
        yield Problem("rail_drive", FOUND_NOTHING, f"a table, because of {first}")
    if not machine.rail_cables and machine.rail_drive is not None:
        yield Problem("rail_drive", "a table", "no such table, because no cable has a rail")


def _observer(machine: Machine, tables: Tables) -> Found:
    observer = machine.disturbance_observer
    if observer and (observer.corner is None) == (observer.minus_3db is None):
        found = "both corner and minus_3db" if observer.corner else "neither corner nor minus_3db"
        yield Problem("disturbance_observer", found, "either corner or minus_3db")


def _cut_offs(machine: Machine, tables: Tables) -> Found:
    half = machine.control.rate / 2
    corners = {("control", "velocity_corner"): (machine.control.velocity_corner, half)}
    if machine.rail_drive:
        corners["rail_drive", "derivative_corner"] = machine.rail_drive.derivative_corner, half
    observer = machine.disturbance_observer
    if observer and observer.corner:
        corners["disturbance_observer", "corner"] = observer.corner, half
    elif observer and observer.minus_3db:
        limit = half * observer.cut_off / observer.pole_corner
        corners["disturbance_observer", "minus_3db"] = observer.minus_3db, limit
    for location, (corner, limit) in corners.items():
        if corner >= limit:
            reason = "so that the corner is below half of control.rate"
            allowed = f"a frequency below {limit:.4g} Hz, {reason}"
            yield _problem(tables, location, allowed)


def _target(machine: Machine, tables: Tables) -> Found:
    for centre, size, limit in zip(
        machine.target.centre, machine.target.size, machine.frame.size, strict=True
    ):
        slack = ROUNDING * limit
        if centre - size / 2 < -slack or centre + size / 2 > limit + slack:
            found = " of size ".join(shown(tables["target"][key]) for key in ("centre", "size"))
            yield Problem("target.centre", found, f"a target inside the frame, {_frame(tables)}")
            return


RULES = (
    _counts,
    _bases,
    _rail_lengths,
    _unique_names,
    _limits,
    _observer_share,
    _carriages,
    _rail_drive,
    _observer,
    _cut_offs,
    _target,
)


def _parallel_cables(machine: Machine, tables: Tables) -> Found:
    if all(_rank(machine, pose) < machine.dof for pose in _target_samples(machine)):
        yield Problem(
            "cable",
            f"{len(machine.cables)} cables, parallel wherever in the target the platform is",
            f"bases whose cables pull in {machine.dof} independent directions",
        )


def _bases_on_one_line(machine: Machine, tables: Tables) -> Found:
    points = np.array([cable.fixed for cable in machine.cables if cable.fixed is not None])
    if machine.rail_cables or len(points) < machine.dof:
        return
    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    if spread[-1] <= PARALLEL * max(machine.frame.size):
        yield Problem(
            "cable",
            f"{len(points)} bases on one line",
            "bases off one line, so that the lengths tell on which side the platform is",
        )


def _target_samples(machine: Machine) -> Iterator[XY]:
    (x, y), (width, height) = machine.target.centre, machine.target.size
    fractions = np.linspace(-0.5, 0.5, SAMPLES_PER_SIDE).tolist()
    return ((x + u * width, y + v * height) for u in fractions for v in fractions)


def _rank(machine: Machine, pose: XY) -> int:
    """Rank of the structure matrix (Yoon eq. 7), movable bases at the foot of the pose."""
    cables = [np.subtract(cable.base.nearest(pose), pose) for cable in machine.cables]
    directions = [cable / math.hypot(*cable) for cable in cables if cable.any()]
    return int(np.linalg.matrix_rank(directions, tol=PARALLEL)) if directions else 0
