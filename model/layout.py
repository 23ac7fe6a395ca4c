"""What must hold of the places in a machine file: dimensions, bases, rails, pulleys, target."""

import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import product
from typing import Any

from turnbuckle.model.base import Base, Coordinates, FixedBase, PlaneBase, RailBase, leader
from turnbuckle.model.directions import dot, rank
from turnbuckle.model.machine import Machine
from turnbuckle.model.partial import value_at
from turnbuckle.model.problem import FOUND_NOTHING, Location, Problem, key_path, problem_at, shown
from turnbuckle.model.pulley import PulleyTable
from turnbuckle.model.rounding import ROUNDING
from turnbuckle.model.table import WrongKey

# Two cables nearer than this angle [rad] are parallel on any machine that can be built.
PARALLEL = 1e-9
# A carriage that moves less than this [m] is none.
LEAST_TRAVEL = 1e-3
# A rotation vector of pi is as far as a platform can turn; its derivative is lost soon beyond.
MOST_ROTATION = math.pi
SAMPLES_PER_SIDE = 5

Found = Iterator[Problem]
Tables = dict[str, Any]
WORDS = {2: "two", 3: "three"}
PLACES = (
    ("base",),
    ("rail", "from"),
    ("rail", "to"),
    ("plane", "corner"),
    ("plane", "along"),
    ("plane", "across"),
)
"""Where a table of a cable says where its base is."""


def dimension_problems(machine: Machine, tables: Tables) -> Found:
    """Points and vectors with another number of entries than the kind's space has."""
    for location, vector in _vectors(machine):
        if len(vector) != machine.space:
            allowed = f"an array of {WORDS[machine.space]}, one entry an axis of {machine.kind}"
            yield problem_at(tables, location, allowed)


def unjudged(machine: Machine) -> list[Location]:
    """Where vectors are of which nobody knows how long they should be: the kind is wrong."""
    with suppress(WrongKey):
        assert machine.space
        return []
    return [location for location, _ in _vectors(machine)]


def _vectors(machine: Machine) -> Iterator[tuple[Location, Coordinates]]:
    """Where the file holds points, sizes and directions, and these."""
    yield from _held(machine, [("frame", "size"), ("target", "size"), ("target", "centre")])
    for i in _numbers(machine, "walls"):
        yield from _held(machine, [("wall", i, "point"), ("wall", i, "normal")])
    yield from _base_points(machine)
    yield from _held(machine, [("cable", i, "anchor") for i in _numbers(machine, "cables")])
    for location, _ in _pulley_tables(machine):
        yield from _held(machine, [(*location, "contact"), (*location, "axis")])
    for i, key, _ in _movable(machine):
        yield from _held(machine, [("cable", i, key, "heading")])


def _held(machine: Machine, locations: Iterable[Location]) -> Iterator[tuple[Location, Any]]:
    """What the machine holds at locations where it holds something, right as far as is known."""
    for location in locations:
        with suppress(WrongKey):
            held = value_at(machine, location)
            if held is not None:
                yield location, held


def _numbers(machine: Machine, tables: str) -> range:
    """Numbers of the cables or walls; none where these are wrong."""
    with suppress(WrongKey):
        return range(len(getattr(machine, tables)))
    return range(0)


def _movable(machine: Machine) -> Iterator[tuple[int, str, RailBase | PlaneBase]]:
    """The bases that move, with the number of their cable and the key of their table."""
    for i in _numbers(machine, "cables"):
        for location, base in _held(machine, [("cable", i, "rail"), ("cable", i, "plane")]):
            yield i, str(location[-1]), base


def _base_points(machine: Machine) -> Iterator[tuple[Location, Coordinates]]:
    """Where the file places bases, and the place."""
    for i in _numbers(machine, "cables"):
        yield from _held(machine, [("cable", i, *place) for place in PLACES])


def _pulley_tables(machine: Machine) -> Iterator[tuple[Location, PulleyTable]]:
    of_cables = [("cable", i, "pulley") for i in _numbers(machine, "cables")]
    yield from _held(machine, [("pulley",), *of_cables])


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
    for i, key, base in _movable(machine):
        with suppress(WrongKey):
            if isinstance(base, RailBase) and base.length < LEAST_TRAVEL:
                allowed = "an end other than the rail's from, by 1 mm at least"
                yield problem_at(tables, ("cable", i, key, "to"), allowed)
            if isinstance(base, PlaneBase) and not _spans(base):
                allowed = "a point off the line through the plane's corner and along"
                yield problem_at(tables, ("cable", i, key, "across"), allowed)


def _spans(plane: PlaneBase) -> bool:
    return min(plane.lengths) >= LEAST_TRAVEL and rank(plane.directions, PARALLEL) == 2


def headings(machine: Machine, tables: Tables) -> Found:
    """A cable cannot head along the rail that its base slides on."""
    for i, key, base in _movable(machine):
        with suppress(WrongKey):
            along = base.direction if isinstance(base, RailBase) else base.directions[0]
            if base.heading is not None and rank([base.heading, along], PARALLEL) < 2:
                allowed = f"a direction that is not along the {key}"
                yield problem_at(tables, ("cable", i, key, "heading"), allowed)


def coupled_rails(machine: Machine, tables: Tables) -> Found:
    """A carriage follows that of another cable on a rail, not longer than its own, in no cycle."""
    drives = [cable.drive for cable in machine.cables]
    rails = [cable.rail for cable in machine.cables]
    for i, rail in enumerate(rails):
        with suppress(WrongKey):
            if rail is not None and rail.follows is not None:
                yield from _coupled(tables, i, rails, drives)


def _coupled(tables: Tables, i: int, rails: Sequence[RailBase | None], drives: list[str]) -> Found:
    """What is wrong with the carriage of a cable, which follows another."""
    location, rail = ("cable", i, "rail", "follows"), rails[i]
    assert rail is not None
    others = [d for d, r in zip(drives, rails, strict=True) if r is not None and r is not rail]
    if rail.follows not in others:
        allowed = f"the drive of another cable with a rail: {', '.join(others) or 'none here'}"
        yield problem_at(tables, location, allowed)
    elif (lead := leader([r or FixedBase(()) for r in rails], drives, i)) is None:
        allowed = "a chain that ends at a rail with a drive of its own, no cycle"
        yield problem_at(tables, location, allowed)
    elif (longest := rails[lead]) and longest.length > rail.length * (1 + ROUNDING):
        allowed = f"a rail of at most this one's {rail.length * 1e3:g} mm"
        found = f"{shown(rail.follows)}, led by a rail of {longest.length * 1e3:g} mm"
        yield Problem(key_path(location), found, allowed)


def anchors(machine: Machine, tables: Tables) -> Found:
    """A rigid platform has an anchor for every cable, a point has none."""
    for i, cable in enumerate(machine.cables):
        with suppress(WrongKey):
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
    wrong = ("axis",) if machine.space == 2 else ("winds", "contact")
    for location, table in _pulley_tables(machine):
        for key in wrong:
            if key in table.model_fields_set:
                allowed = f"no such key for the kind {machine.kind}"
                yield problem_at(tables, (*location, key), allowed)
        with suppress(WrongKey):
            if machine.space == 3 and table.axis is None:
                allowed = (
                    "three plain numbers, the direction in which the cable runs into the pulley"
                )
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


def walls_in_the_frame(machine: Machine, tables: Tables) -> Found:
    """Some of the frame is on the free side of a wall, and the wall is within reach."""
    for i, wall in enumerate(machine.walls):
        with suppress(WrongKey):
            corners = product(*((0.0, side) for side in machine.frame.size))
            depths = [dot(_minus(corner, wall.point), wall.normal) for corner in corners]
            if not min(depths) <= 0 < max(depths):
                allowed = f"a wall through the frame, {_frame(tables)}"
                yield problem_at(tables, ("wall", i, "point"), allowed)


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
        plain = machine.dof == 2
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
