"""What varies in a design search: `KEY=LOW..HIGH`, such as `tension.max=8 N..15 N`.

Keys are those of error messages: `cable[2].base[1]` is the first coordinate of the second cable's
base. `KEY,KEY,...=LOW..HIGH` changes several in proportion, the range being that of the first.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Context, Decimal, localcontext

from pydantic_core import PydanticCustomError

from turnbuckle.lab.design import DesignError
from turnbuckle.lab.design.document import Changes, Document, Location, as_written
from turnbuckle.model.problem import Problem, nearest, shown
from turnbuckle.model.quantity import Quantity, meaning
from turnbuckle.model.units import Written

FORM = re.compile(r"(?P<keys>[^=]+)=(?P<low>.+?)\.\.(?P<high>[^:]+)(?::(?P<count>.*))?")
FORM_IN_WORDS = 'KEY=LOW..HIGH, such as "tension.max=8 N..15 N"'
FEWEST = 2
"""A range is divided into at least so many values: both its ends."""
RESOLUTION = Decimal("1e-6")
"""Values differ by at least about this share of their range, and so have few digits."""
IN_PROPORTION = Context(prec=15)
"""Digits of a value that follows another: as many as a double holds."""


@dataclass(frozen=True)
class Follower:
    """A quantity that keeps its proportion to another."""

    location: Location
    ratio: Decimal
    unit: str


@dataclass(frozen=True)
class Range:
    """A quantity that varies from `low` to `high`, both in the file's own unit for it."""

    key: str
    location: Location
    low: Decimal
    high: Decimal
    unit: str
    count: int | None
    """Values to try, ends included, where the user says so."""
    followers: tuple[Follower, ...]

    @property
    def locations(self) -> tuple[Location, ...]:
        """All that varies, in proportion."""
        return self.location, *(follower.location for follower in self.followers)

    def value(self, share: float) -> Decimal:
        """The value at a share of the range, 0 for `low` and 1 for `high`."""
        value = self.low + (self.high - self.low) * Decimal(share)
        return min(max(value, self.low), self.high)

    def rounded(self, value: Decimal) -> Decimal:
        """A value in few digits; the ends of the range as they are."""
        if value in (self.low, self.high):
            return value
        step = ((self.high - self.low) * RESOLUTION).adjusted()
        return min(max(value.quantize(Decimal(1).scaleb(step)), self.low), self.high)

    def share(self, value: Decimal) -> float:
        """The share of the range at which a value lies, beyond 0 and 1 when it is outside."""
        return float((value - self.low) / (self.high - self.low))

    def changes(self, value: Decimal) -> Changes:
        """What the file says at this value."""
        with localcontext(IN_PROPORTION):
            return {self.location: in_words(value, self.unit)} | {
                other.location: in_words(other.ratio * value, other.unit)
                for other in self.followers
            }


def in_words(number: Decimal, unit: str) -> str:
    """A quantity as a machine file writes it."""
    return f"{number.normalize() + 0:f} {unit}"


def parse_ranges(arguments: Sequence[str], document: Document) -> tuple[Range, ...]:
    """The ranges of all --vary; DesignError where one is wrong or two name the same key."""
    ranges = tuple(_parse(argument, document) for argument in arguments)
    keys: set[Location] = set()
    for range_ in ranges:
        for location in range_.locations:
            if location in keys:
                raise _refused(document, range_.key, "a key twice", "every key once")
            keys.add(location)
    return ranges


def _parse(argument: str, document: Document) -> Range:
    match = FORM.fullmatch(argument.strip())
    if match is None:
        raise _refused(document, "", shown(argument), FORM_IN_WORDS)
    keys = [key.strip() for key in match["keys"].split(",")]
    (location, first), *others = (_quantity(key, document) for key in keys)
    low, high = (_bound(match[end], keys[0], first, document) for end in ("low", "high"))
    if low >= high:
        found = f"{match['low'].strip()}..{match['high'].strip()}"
        raise _refused(document, keys[0], found, "LOW..HIGH with LOW less than HIGH")
    followers = tuple(_follower(place, other, first, keys[0], document) for place, other in others)
    count = _count(match["count"], keys[0], document)
    return Range(keys[0], location, low, high, first.unit, count, followers)


def _quantity(key: str, document: Document) -> tuple[Location, Written]:
    """Where a key is and what it says now."""
    values = document.values()
    quantities = [name for name, (_, value) in values.items() if as_written(value)]
    if key not in values:
        hint = nearest(key, quantities) or f", such as {quantities[0]}"
        raise _refused(document, key, "no such key", f"a key of the file that is a quantity{hint}")
    location, value = values[key]
    written = as_written(value)
    if written is None:
        inside = [name for name in quantities if name.startswith(key)]
        hint = f", such as {inside[0]}" if inside else ""
        raise _refused(document, key, shown(value), f"a key that is a quantity{hint}")
    return location, written


def _follower(
    location: Location, other: Written, first: Written, key: str, document: Document
) -> Follower:
    """A quantity in its present proportion to the first; equal ones stay equal, at zero too."""
    if other == first:
        return Follower(location, Decimal(1), other.unit)
    if not first.number:
        allowed = "a first key that is not zero, because the others change in proportion to it"
        raise _refused(document, key, in_words(first.number, first.unit), allowed)
    with localcontext(IN_PROPORTION):
        return Follower(location, other.number / first.number, other.unit)


def _bound(text: str, key: str, present: Written, document: Document) -> Decimal:
    """One end of a range, in the unit of the file."""
    what, example = meaning(present.unit), in_words(present.number, present.unit)
    try:
        value = Quantity(what, present.unit, example, sign="any").parse(text.strip())
    except PydanticCustomError as error:
        context = error.context or {}
        found = context["found"] or shown(text.strip())
        raise _refused(document, key, found, context["allowed"]) from None
    return Decimal(repr(value))


def _count(text: str | None, key: str, document: Document) -> int | None:
    if text is None:
        return None
    if not re.fullmatch("[0-9]{1,9}", text.strip()) or int(text) < FEWEST:
        found, allowed = shown(text.strip()), f"a COUNT of at least {FEWEST}: KEY=LOW..HIGH:COUNT"
        raise _refused(document, key, found, allowed)
    return int(text)


def _refused(document: Document, key: str, found: str, allowed: str) -> DesignError:
    return DesignError(f"{document.path}: {Problem(f'--vary {key}'.strip(), found, allowed)}")
