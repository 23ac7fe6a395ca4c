"""What must hold of the places in a machine file: dimensions, bases, rails, pulleys, target."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

from turnbuckle.model.base import Base, Coordinates, FixedBase, PlaneBase, RailBase, leader
from turnbuckle.model.directions import dot, rank
from turnbuckle.model.problem import FOUND_NOTHING, Location, Problem, key_path, problem_at, shown

if TYPE_CHECKING:
    from turnbuckle.model.machine import Machine

# A product of two rounded numbers may miss an exact limit by this much.
ROUNDING = 4 * sys.float_info.epsilon
# Two cables nearer than this angle [rad] are parallel on any machine that can be built.
PARALLEL = 1e-9
# A rotation vector of pi is as far as a platform can turn; its derivative is lost soon beyond.
MOST_ROTATION = math.pi
SAMPLES_PER_SIDE = 5

Found = Iterator[Problem]
Tables = dict[str, Any]
WORDS = {2: "two", 3: "three"}


def dimension_problems(machine: Machine, tables: Tables) -> Found:
    """Points and vectors with another number of entries than the kind's space has."""
    for location, vector in _vectors(machine):
        if len(vector) != machine.space:
            allowed = f"an array of {WORDS[machine.space]}, one entry an axis of {machine.kind}"
            yield problem_at(tables, location, allowed)


def _vectors(machine: Machine) -> Iterator[tuple[Location, tuple[float, ...]]]:
    """Where the file holds points, sizes and directions, and these."""
    yield ("frame", "size"), machine.frame.size
    yield ("target", "size"), machine.target.size
    yield ("target", "centre"), machine.target.centre
    for i, wall in enumerate(machine.walls):
        yield ("wall", i, "point"), wall.point
        yield ("wall", i, "normal"), wall.normal
    yield from _base_points(machine)
    for i, cable in enumerate(machine.cables):
        if cable.anchor is not None:
            yield ("cable", i, "anchor"), cable.anchor
    for location, table in _pulley_tables(machine):
        for key in ("contact", "axis"):
            vector = getattr(table, key)
            if vector is not None:
                yield (*location, key), vector
    for i, key, base in _movable(machine):
        if base.heading is not None:
            yield ("cable", i, key, "heading"), base.heading


def _movable(machine: Machine) -> Iterator[tuple[int, str, RailBase | PlaneBase]]:
    """The bases that move, with the number of their cable and the key of their table."""
    for i, cable in enumerate(machine.cables):
        if cable.rail is not None:
            yield i, "rail", cable.rail
        if cable.plane is not None:
            yield i, "plane", cable.plane


def _base_points(machine: Machine) -> Iterator[tuple[Location, tuple[float, ...]]]:
    """Where the file places bases, and the place."""
    for i, cable in enumerate(machine.cables):
        if cable.fixed is not None:
            yield ("cable", i, "base"), cable.fixed
        if cable.rail is not None:
            yield ("cable", i, "rail", "from"), cable.rail.start
            yield ("cable", i, "rail", "to"), cable.rail.end
        if cable.plane is not None:
            yield ("cable", i, "plane", "corner"), cable.plane.corner
            yield ("cable", i, "plane", "along"), cable.plane.along
            yield ("cable", i, "plane", "across"), cable.plane.across


def _pulley_tables(machine: Machine) -> Iterator[tuple[Location, Any]]:
    if machine.pulley is not None:
        yield ("pulley",), machine.pulley
    for i, cable in enumerate(machine.cables):
        if cable.pulley is not None:
            yield ("cable", i, "pulley"), cable.pulley


def one_base_each(machine: Machine, tables: Tables) -> Found:
    """Every cable names one of base, rail and plane."""
    allowed = "one of base, rail and plane"
    for i in range(len(machine.cables)):
        named = [key for key in ("base", "rail", "plane") if key in tables["cable"][i]]
        if not named:
            yield Problem(key_path(("cable", i)), "neither base nor rail nor plane", allowed)
        elif len(named) > 1:
            yield Problem(key_path(("cable", i)), f"both {' and '.join(named)}", allowed)


def bases_in_the_frame(machine: Machine, tables: Tables) -> Found:
    """Bases stay inside the frame."""
    for location, point in _base_points(machine):
        if not all(0 <= x <= limit for x, limit in zip(point, machine.frame.size, strict=True)):
            yield problem_at(tables, location, f"a point inside the frame, {_frame(tables)}")


def _frame(tables: Tables) -> str:
    return f"from the origin to frame.size = {shown(tables['frame']['size'])}"


def travel_has_length(machine: Machine, tables: Tables) -> Found:
    """Rails and planes are of some size, and the sides of a plane are not parallel."""
    for i, cable in enumerate(machine.cables):
        if cable.rail is not None and cable.rail.start == cable.rail.end:
            allowed = "an end other than the rail's from"
            yield problem_at(tables, ("cable", i, "rail", "to"), allowed)
        if cable.plane is not None and not _spans(cable.plane):
            allowed = "a point off the line through the plane's corner and along"
            yield problem_at(tables, ("cable", i, "plane", "across"), allowed)


def _spans(plane: PlaneBase) -> bool:
    if plane.corner in (plane.along, plane.across):
        return False
    return rank(plane.directions, PARALLEL) == 2


def headings(machine: Machine, tables: Tables) -> Found:
    """A cable cannot head along the rail that its base slides on."""
    for i, key, base in _movable(machine):
        directions = [base.direction] if isinstance(base, RailBase) else list(base.directions)
        if base.heading is not None and rank([base.heading, directions[0]], PARALLEL) < 2:
            allowed = f"a direction that is not along the {key}"
            yield problem_at(tables, ("cable", i, key, "heading"), allowed)


def coupled_rails(machine: Machine, tables: Tables) -> Found:
    """A carriage follows that of another cable on a rail, not longer than its own, in no cycle."""
    drives = [cable.drive for cable in machine.cables]
    bases = [cable.rail for cable in machine.cables]
    for i, rail in enumerate(bases):
        if rail is None or rail.follows is None:
            continue
        location = ("cable", i, "rail", "follows")
        others = [d for d, b in zip(drives, bases, strict=True) if b is not None and b is not rail]
        if rail.follows not in others:
            allowed = f"the drive of another cable with a rail: {', '.join(others) or 'none here'}"
            yield problem_at(tables, location, allowed)
        elif (lead := leader([b or FixedBase(()) for b in bases], drives, i)) is None:
            allowed = "a chain that ends at a rail with a drive of its own, no cycle"
            yield problem_at(tables, location, allowed)
        elif (longest := bases[lead]) and longest.length > rail.length * (1 + ROUNDING):
            allowed = f"a rail of at most this one's {rail.length * 1e3:g} mm"
            found = f"{shown(rail.follows)}, led by a rail of {longest.length * 1e3:g} mm"
            yield Problem(key_path(location), found, allowed)


def anchors(machine: Machine, tables: Tables) -> Found:
    """A rigid platform has an anchor for every cable, a point has none."""
    for i, cable in enumerate(machine.cables):
        if machine.is_rigid and cable.anchor is None:
            allowed = "where the platform holds the cable, from its centre, one length an axis"
            yield Problem(key_path(("cable", i, "anchor")), FOUND_NOTHING, allowed)
        if not machine.is_rigid and cable.anchor is not None:
            allowed = f"no anchor: the platform of {machine.kind} is a point"
            yield problem_at(tables, ("cable", i, "anchor"), allowed)
    if machine.is_rigid and not any(any(cable.anchor or ()) for cable in machine.cables):
        found = "every anchor at the platform's centre"
        yield Problem("cable", found, "anchors off the centre, or a kind whose platform is a point")


def platform(machine: Machine, tables: Tables) -> Found:
    """Keys of rotation are due for rigid kinds, and out of place for points."""
    table = machine.platform
    if machine.is_rigid and table is None:
        yield Problem("platform", FOUND_NOTHING, f"a table, because of the kind {machine.kind}")
    if table is not None and not machine.is_rigid:
        allowed = f"no such table, because the platform of {machine.kind} is a point"
        yield Problem("platform", "a table", allowed)
    elif table is not None and table.rotation > MOST_ROTATION * (1 + ROUNDING):
        yield problem_at(tables, ("platform", "rotation"), "an angle of at most 180 deg")
    for key in ("moment", "rotation"):
        if getattr(machine.target, key) and not machine.is_rigid:
            allowed = f"no such key, because the platform of {machine.kind} is a point"
            yield problem_at(tables, ("target", key), allowed)
    if table is not None and machine.target.rotation > table.rotation * (1 + ROUNDING):
        limit = shown(tables["platform"]["rotation"])
        yield problem_at(tables, ("target", "rotation"), f"at most platform.rotation = {limit}")


def pulleys(machine: Machine, tables: Tables) -> Found:
    """Planar pulleys wind and have a first contact, spatial ones have an axis."""
    for location, table in _pulley_tables(machine):
        held: Any = tables
        for part in location:
            held = held[part]
        wrong = ("axis",) if machine.space == 2 else ("winds", "contact")
        for key in wrong:
            if key in held:
                allowed = f"no such key for the kind {machine.kind}"
                yield problem_at(tables, (*location, key), allowed)
        if machine.space == 3 and table.axis is None:
            allowed = "three plain numbers, the direction in which the cable runs into the pulley"
            yield Problem(key_path((*location, "axis")), FOUND_NOTHING, allowed)


def pulley_contacts(machine: Machine, tables: Tables) -> Found:
    """A pulley in the middle of the frame has no side that is away from the middle."""
    middle = [rail.length / 2 for rail in machine.rails]
    for i, (cable, motion) in enumerate(zip(machine.cables, machine.base_motions, strict=True)):
        table = cable.pulley or machine.pulley
        if machine.space == 2 and table is not None and table.contact is None:
            gap = math.dist(motion.point(middle), machine.frame.centre)
            if gap <= PARALLEL * max(machine.frame.size):
                location = ("cable", i, "pulley", "contact")
                found = f"{FOUND_NOTHING}, and the base is in the middle of the frame"
                allowed = "two plain numbers, from the pulley's centre to where the cable touches"
                yield Problem(key_path(location), found, allowed)


def target_in_the_frame(machine: Machine, tables: Tables) -> Found:
    """The target lies inside the frame."""
    for centre, size, limit in zip(
        machine.target.centre, machine.target.size, machine.frame.size, strict=True
    ):
        slack = ROUNDING * limit
        if centre - size / 2 < -slack or centre + size / 2 > limit + slack:
            found = " of size ".join(shown(tables["target"][key]) for key in ("centre", "size"))
            yield Problem("target.centre", found, f"a target inside the frame, {_frame(tables)}")
            return


def cables_span(machine: Machine, tables: Tables) -> Found:
    """Somewhere in the target the cables pull in all directions that the platform can move."""
    if all(_rank(machine, pose) < machine.dof for pose in _target_samples(machine)):
        plain = machine.kind == "planar-point"
        found = "parallel" if plain else f"pulling in fewer than {machine.dof} directions"
        yield Problem(
            "cable",
            f"{len(machine.cables)} cables, {found} wherever in the target the platform is",
            f"bases whose cables pull in {machine.dof} independent directions",
        )


def bases_off_one_line(machine: Machine, tables: Tables) -> Found:
    """Fixed bases of a point platform on one line (plane) leave its side of it unknown."""
    points = [cable.fixed for cable in machine.cables if cable.fixed is not None]
    if machine.rails or machine.is_rigid:
        return
    apart = [_minus(point, points[0]) for point in points]
    if rank(apart, PARALLEL * max(machine.frame.size)) < machine.space:
        where = "line" if machine.space == 2 else "plane"
        yield Problem(
            "cable",
            f"{len(points)} bases on one {where}",
            f"bases off one {where}, so that the lengths tell on which side the platform is",
        )


def _target_samples(machine: Machine) -> Iterator[tuple[float, ...]]:
    fractions = [k / (SAMPLES_PER_SIDE - 1) - 0.5 for k in range(SAMPLES_PER_SIDE)]
    sides = zip(machine.target.centre, machine.target.size, strict=True)
    axes = [[centre + u * size for u in fractions] for centre, size in sides]
    return product(*axes)


def _rank(machine: Machine, position: Coordinates) -> int:
    """Rank of the structure matrix (Yoon eq. 7), upright, movable bases at the foot of the pose."""
    columns = []
    for cable, anchor in zip(machine.cables, machine.anchors, strict=True):
        point = [x + p for x, p in zip(position, anchor, strict=True)]
        ray = _minus(_nearest(cable.base, point), point)
        length = math.hypot(*ray)
        if length > 0:
            ray = tuple(x / length for x in ray)
            arm = [p / machine.lever for p in anchor]
            columns.append([*ray, *_moment(arm, ray)] if machine.is_rigid else ray)
    return rank(columns, PARALLEL)


def _moment(arm: Sequence[float], ray: Coordinates) -> Coordinates:
    if len(arm) == 2:
        return (arm[0] * ray[1] - arm[1] * ray[0],)
    turns = ((1, 2), (2, 0), (0, 1))
    return tuple(arm[i] * ray[j] - arm[j] * ray[i] for i, j in turns)


def _nearest(base: Base, point: Sequence[float]) -> Coordinates:
    """The base's position [m] nearest to `point` on its rail; the middle of a plane."""
    if isinstance(base, FixedBase):
        return base.position
    if isinstance(base, PlaneBase):
        return tuple((a + b) / 2 for a, b in zip(base.along, base.across, strict=True))
    way = min(max(dot(_minus(point, base.start), base.direction), 0.0), base.length)
    return tuple(x + way * e for x, e in zip(base.start, base.direction, strict=True))


def _minus(first: Sequence[float], second: Sequence[float]) -> Coordinates:
    return tuple(a - b for a, b in zip(first, second, strict=True))
