"""`KEY=LOW..HIGH`: what is understood, and what is refused and how it is worded."""

from decimal import Decimal
from pathlib import Path

import pytest

from turnbuckle.lab.design import DesignError
from turnbuckle.lab.design.document import Document
from turnbuckle.lab.design.vary import Range, parse_ranges

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"


@pytest.fixture(scope="module")
def document() -> Document:
    """The stock machine's file."""
    return Document.read(STOCK)


def parsed(argument: str, document: Document) -> Range:
    """The one range of an argument."""
    (range_,) = parse_ranges([argument], document)
    return range_


def test_a_range_is_in_the_unit_of_the_file(document: Document) -> None:
    range_ = parsed("frame.size[1]=0.5 m..1e3 mm", document)
    assert range_.location == ("frame", "size", 0)
    assert (range_.low, range_.high) == (Decimal("500"), Decimal("1000"))
    assert range_.unit == "mm"
    assert range_.count is None


def test_keys_are_those_of_error_messages_and_count_from_one(document: Document) -> None:
    range_ = parsed("cable[3].rail.to[2]=0 mm..1 mm:7", document)
    assert range_.location == ("cable", 2, "rail", "to", 1)
    assert range_.count == 7


def test_numbers_may_end_or_begin_with_a_point(document: Document) -> None:
    range_ = parsed("tension.max=.5 N...7 N", document)
    assert (range_.low, range_.high) == (Decimal("0.5"), Decimal("0.7"))


def test_values_have_few_digits_and_stay_in_the_range(document: Document) -> None:
    range_ = parsed("tension.max=0.1234567891 N..8 N", document)
    assert range_.rounded(range_.value(0.0)) == range_.low
    assert range_.rounded(range_.value(1.0)) == range_.high
    third = range_.rounded(range_.value(1 / 3))
    assert abs(float(third) - (range_.share(third) * 7.8765432109 + 0.1234567891)) < 1e-12
    assert len(third.as_tuple().digits) <= 8


def test_keys_joined_by_commas_change_in_proportion(document: Document) -> None:
    range_ = parsed("tension.max,cable_motor.torque_limit,tension.min=8 N..12 N", document)
    assert range_.changes(Decimal("12")) == {
        ("tension", "max"): "12 N",
        ("cable_motor", "torque_limit"): "66 mN*m",
        ("tension", "min"): "3.6 N",
    }


def test_coordinates_that_are_zero_together_change_together(document: Document) -> None:
    range_ = parsed("cable[4].rail.from[1],cable[4].rail.to[1]=0 mm..50 mm", document)
    assert set(range_.changes(Decimal("20")).values()) == {"20 mm"}


@pytest.mark.parametrize(
    ("argument", "words"),
    [
        ("tension.maxx=1 N..2 N", ["--vary tension.maxx", "no such key", "mean tension.max?"]),
        ("cable[9].base[1]=1 mm..2 mm", ["--vary cable[9].base[1]", "no such key"]),
        ("=1 N..2 N", ['found "=1 N..2 N"', "KEY=LOW..HIGH"]),
        ("tension.max", ['found "tension.max"', "KEY=LOW..HIGH"]),
        ("tension.max=8 N", ['found "tension.max=8 N"', "KEY=LOW..HIGH"]),
        ("tension.max=8..15", ["tension.max", '"8", a number without a unit', '"10 N"']),
        ("tension.max=8 N..15", ['"15", a number without a unit']),
        ("tension.max=8 kg..9 kg", ['"8 kg", a mass', "a force with its unit"]),
        ("tension.max=8 quux..9 quux", ['"8 quux", whose unit is unknown']),
        ("tension.max=nan N..9 N", ['"nan N"', "a finite number"]),
        ("tension.max=15 N..8 N", ["15 N..8 N", "LOW less than HIGH"]),
        ("tension.max=8 N..8000 mN", ["LOW less than HIGH"]),
        ("tension=1 N..2 N", ["found a table", "such as tension.min"]),
        ("frame.size=1 m..2 m", ['found ["711.8 mm", "461.8 mm"]', "such as frame.size[1]"]),
        ("machine.name=1 N..2 N", ['found "yoon2023"', "a key that is a quantity"]),
        ("wall[1].normal[1]=1 N..2 N", ["found -1", "a key that is a quantity"]),
        ("tension.max=8 N..9 N:1", ['found "1"', "a COUNT of at least 2"]),
        ("tension.max=8 N..9 N:many", ['found "many"', "a COUNT of at least 2"]),
        ("cable[1].rail.from[1],tension.max=1 mm..2 mm", ["found 0 mm", "not zero"]),
        ("tension.max,tension.max=8 N..9 N", ["a key twice"]),
    ],
)
def test_a_wrong_range_is_refused_in_words(
    argument: str, words: list[str], document: Document
) -> None:
    with pytest.raises(DesignError) as caught:
        parse_ranges([argument], document)
    message = str(caught.value)
    assert message.startswith(f"{STOCK}: --vary")
    assert "\n" not in message
    for word in words:
        assert word in message


def test_a_key_may_vary_once_only(document: Document) -> None:
    arguments = ["tension.max=8 N..9 N", "tension.min,tension.max=1 N..2 N"]
    with pytest.raises(DesignError, match="a key twice"):
        parse_ranges(arguments, document)
