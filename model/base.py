"""Where the pulleys are: bases that stay, slide on rails or move in planes; coupled carriages."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from pydantic import Field

from turnbuckle.model.quantity import Point, UnitVector
from turnbuckle.model.table import Table
from turnbuckle.model.words import Identifier

Coordinates = tuple[float, ...]
HEADING = (
    "plain numbers, one an axis: where the cable should head, seen from the platform, while the"
    " base follows it; square to the rail or plane by default"
)


@dataclass(frozen=True)
class FixedBase:
    """A base that stays at `position` [m]."""

    position: Coordinates


class RailBase(Table):
    """A base that slides on a straight rail; rail coordinate s [m] counts from `start`."""

    start: Point = Field(alias="from", description="where the rail begins, one length an axis")
    end: Point = Field(alias="to", description="where the rail ends, one length an axis")
    follows: Identifier | None = Field(
        None, description="the drive of the cable whose carriage also moves this one, if any"
    )
    heading: UnitVector | None = Field(None, description=HEADING)

    @property
    def length(self) -> float:
        """Length of the rail [m]."""
        return math.dist(self.start, self.end)

    @property
    def direction(self) -> Coordinates:
        """Unit vector e from `start` to `end`."""
        return _unit(self.start, self.end)


class PlaneBase(Table):
    """A base that moves in a parallelogram; both of its coordinates [m] count from `corner`."""

    corner: Point = Field(description="where both coordinates are zero, one length an axis")
    along: Point = Field(description="where the first coordinate ends, one length an axis")
    across: Point = Field(description="where the second coordinate ends, one length an axis")
    heading: UnitVector | None = Field(None, description=HEADING)

    @property
    def lengths(self) -> tuple[float, float]:
        """Ranges of the two coordinates [m]."""
        return math.dist(self.corner, self.along), math.dist(self.corner, self.across)

    @property
    def directions(self) -> tuple[Coordinates, Coordinates]:
        """Unit vectors of the two coordinates."""
        return _unit(self.corner, self.along), _unit(self.corner, self.across)


Base = FixedBase | RailBase | PlaneBase


@dataclass(frozen=True)
class BaseMotion:
    """How a pulley point follows the rail coordinates: b = start + sum of s_k e over `travel`.

    start [m]; travel: pairs (k, e) of a rail coordinate's number and a unit vector; heading: unit
    vector from the platform that the cable should take, () for square to the travel.
    """

    start: Coordinates
    travel: tuple[tuple[int, Coordinates], ...] = ()
    heading: Coordinates = ()

    def point(self, rails: Sequence[float]) -> Coordinates:
        """The pulley point b [m] at rail coordinates s [m]."""
        return tuple(
            start + sum(rails[k] * direction[axis] for k, direction in self.travel)
            for axis, start in enumerate(self.start)
        )


@dataclass(frozen=True)
class RailCoordinate:
    """One actuated coordinate of bases: it goes from 0 to `length` [m] and moves these cables."""

    length: float
    cables: tuple[int, ...]


def leader(bases: Sequence[Base], drives: Sequence[str], cable: int) -> int | None:
    """The cable whose carriage moves that of `cable` in the end; None in a cycle or for no cable.

    bases, drives: of all cables.
    """
    seen: set[int] = set()
    while cable not in seen:
        seen.add(cable)
        base = bases[cable]
        if not isinstance(base, RailBase) or base.follows is None:
            return cable
        if base.follows not in drives:
            return None
        cable = drives.index(base.follows)
    return None


@cache
def motions(
    bases: tuple[Base, ...], drives: tuple[str, ...]
) -> tuple[tuple[BaseMotion, ...], tuple[RailCoordinate, ...]]:
    """How every base moves, and the rail coordinates, numbered in the order of the cables."""
    numbers: dict[int, int] = {}
    ranges: list[float] = []
    moved: list[list[int]] = []
    for cable, base in enumerate(bases):
        if leader(bases, drives, cable) == cable:
            numbers[cable] = len(ranges)
            ranges += _ranges(base)
            moved += [[] for _ in _ranges(base)]
    result = []
    for cable, base in enumerate(bases):
        lead = leader(bases, drives, cable)
        assert lead is not None  # load_machine has seen to it
        first = numbers[lead]
        start, directions = _line(base)
        heading = () if isinstance(base, FixedBase) else base.heading or ()
        result.append(BaseMotion(start, tuple(enumerate(directions, first)), heading))
        for number in range(first, first + len(directions)):
            moved[number].append(cable)
    rails = [RailCoordinate(r, tuple(m)) for r, m in zip(ranges, moved, strict=True)]
    return tuple(result), tuple(rails)


def _ranges(base: Base) -> list[float]:
    if isinstance(base, FixedBase):
        return []
    return [base.length] if isinstance(base, RailBase) else list(base.lengths)


def _line(base: Base) -> tuple[Coordinates, tuple[Coordinates, ...]]:
    """Where a base starts and the directions it can go."""
    if isinstance(base, FixedBase):
        return base.position, ()
    if isinstance(base, RailBase):
        return base.start, (base.direction,)
    return base.corner, base.directions


def _unit(start: Coordinates, end: Coordinates) -> Coordinates:
    length = math.dist(start, end)
    return tuple((b - a) / length for a, b in zip(start, end, strict=True))
