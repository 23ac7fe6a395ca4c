"""Units are what a peer takes them for; what is unclear is refused with what to write instead."""

import math
from decimal import Decimal
from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any

import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st

from turnbuckle.model import units
from turnbuckle.model.units import (
    BASES,
    PREFIXED,
    PREFIXES,
    UNITS,
    QuantityError,
    Unit,
    unit,
    written,
)

#: Names that the peer knows under another.
ELSEWHERE = {"bps": "bit/s", "Bit": "bit", "gf": "gram_force", "ozf": "ounce_force", "rev": "turn"}
#: What the peer writes with other letters.
RUN_TOGETHER = {
    **{
        f"{p}N{a}m": f"{p}N*{a}m" for p, a in product(("", "m", "µ", "u", "k", "c"), ("", "c", "m"))
    },
    **{f"{p}Nms": f"{p}N*m*s" for p in ("", "m", "µ", "k")},
    **{f"{m}m": f"{m[:-1]}*{m[-1]}m" for m in ("gc", "gm", "kgc", "kgm")},
    "kgm": "kg*m",
}
NAMES = sorted({*BASES, *UNITS, *(prefix + name for prefix in PREFIXES for name in PREFIXED)})


@cache
def peer() -> "pint.UnitRegistry[Any]":
    return pint.UnitRegistry(non_int_type=Decimal)


@cache
def of_the_peer(text: str) -> Unit:
    """The unit as the peer understands it; `text` has the peer's names."""
    quantity = peer().Quantity(Decimal(1), text).to_root_units()
    powers = dict(quantity.unit_items())
    root = {"kilogram": "kg", "gram": "kg", "meter": "m", "second": "s", "ampere": "A"}
    root |= {"radian": "rad", "bit": "bit"}
    dimension = {root[str(name)]: int(float(str(power))) for name, power in powers.items()}
    grams = dimension.get("kg", 0) if "gram" in powers else 0
    size = Fraction(quantity.magnitude) / 1000**grams
    return Unit(size, tuple(dimension.get(base, 0) for base in BASES))


def of(name: str) -> str:
    """The peer's name of a unit."""
    for known, other in ELSEWHERE.items():
        if name.endswith(known) and name.removesuffix(known) in ("", *PREFIXES):
            return name.removesuffix(known) + other
    return name


def assert_same(ours: Unit, theirs: Unit) -> None:
    assert ours.dimension == theirs.dimension
    assert math.isclose(ours.size / theirs.size, 1, rel_tol=1e-15)


@pytest.mark.parametrize("name", NAMES)
def test_a_unit_is_what_a_peer_takes_it_for(name: str) -> None:
    assert_same(unit(name), of_the_peer(of(name)))


@pytest.mark.parametrize(("text", "apart"), RUN_TOGETHER.items())
def test_units_run_together_are_those_of_the_product(text: str, apart: str) -> None:
    assert_same(unit(text), of_the_peer(apart))
    assert_same(unit(f"{text}²/s"), of_the_peer(f"{apart}**2/s"))


FACTORS = st.tuples(st.sampled_from(NAMES), st.integers(-4, 4).filter(bool))


def spelled(name: str, power: int, way: str) -> str:
    """A factor in one of the ways to write it."""
    if power == 1:
        return name
    if way == "²":
        return name + str(power).translate(str.maketrans("-1234", "⁻¹²³⁴"))
    return f"{name}{way}{power}"


@given(
    above=st.lists(FACTORS, min_size=1, max_size=3),
    below=st.lists(FACTORS, max_size=3),
    sign=st.sampled_from(["*", "·", " ", " * ", "⋅"]),
    way=st.sampled_from(["^", "**", "²", ""]),
)
def test_products_and_quotients_are_what_a_peer_takes_them_for(
    above: list[tuple[str, int]], below: list[tuple[str, int]], sign: str, way: str
) -> None:
    text = sign.join(spelled(*factor, way) for factor in above)
    plain = "*".join(f"({of(name)})**({power})" for name, power in above)
    if below:
        text += f" / ({sign.join(spelled(*factor, way) for factor in below)})"
        plain += "/(" + "*".join(f"({of(name)})**({power})" for name, power in below) + ")"
    if len(text) <= units.LONGEST:
        assert_same(unit(text), of_the_peer(plain))


def test_no_name_is_that_of_two_units() -> None:
    named = [*BASES, *UNITS, *(prefix + name for prefix in PREFIXES for name in PREFIXED)]
    twice = {name for name in named if named.count(name) > 1}
    assert twice == {"kg"}  # a thousand grams, and so defined
    together = [name for name in NAMES if units.RUN_TOGETHER.fullmatch(name)]
    assert not together


@pytest.mark.parametrize(
    ("text", "number", "rest"),
    [
        ("1,5 m", "1.5", "m"),
        ("0,125 m", "0.125", "m"),
        ("-12,3456 m", "-12.3456", "m"),
        ("1234,567 m", "1234.567", "m"),
        ("−5·m", "-5", "*m"),
        ("5\u00a0mm", "5", "mm"),
        ("1 1/s", "1", "1/s"),
        (",5e3mm", "0.5e3", "mm"),
    ],
)
def test_a_number_is_read_as_data_sheets_write_it(text: str, number: str, rest: str) -> None:
    assert written(text) == (Decimal(number), rest)


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("1,500 m", 'write "1.500 m" or "1500 m"'),
        ("-100,250e3 m", 'write "-100.250e3 m" or "-100250e3 m"'),
        ("1,500,000 m", "write digits and a decimal point only, such as 1234.5"),
        ("1.500,5 m", "write digits and a decimal point only, such as 1234.5"),
        ("1 500 m", "write digits and a decimal point only, such as 1234.5"),
        ("1'500 m", "write digits and a decimal point only, such as 1234.5"),
        ("1_500 m", "write digits and a decimal point only, such as 1234.5"),
        ("5", ""),
        ("m", ""),
        ("1e1e1 m", ""),
        ("5 " + "m" * 80, ""),
    ],
)
def test_a_number_that_may_mean_two_things_is_refused(text: str, hint: str) -> None:
    with pytest.raises(QuantityError) as caught:
        unit(written(text).unit)
    assert caught.value.hint == hint


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("mil", "write deg, mrad or mm"),
        ("grad", "write deg or gon"),
        ("oz-in", "write ozf*in"),
        ("N-m", "write N*m"),
        ("N/m s", "N/(m*s)"),
        ("KHz", "did you mean kHz?"),
        ("mhz", "did you mean MHz or mHz?"),
        ("newton", ""),
        ("1", ""),
        ("m^5", ""),
        ("m^1.5", ""),
        ("m/", ""),
        ("(m", ""),
        ("m)", ""),
        ("()", ""),
        ("/m", ""),
        ("m^", ""),
        ("m//s", ""),
        ("m**", ""),
        ("2 m", ""),
        ("m;s", ""),
        ("(" * 40 + ")" * 40, ""),
    ],
)
def test_a_unit_that_is_none_or_unclear_is_refused(text: str, hint: str) -> None:
    with pytest.raises(QuantityError) as caught:
        unit(text)
    assert hint in caught.value.hint
    assert bool(hint) == bool(caught.value.hint)


@given(st.text(max_size=90) | st.text("mNs*/^()-² 1kµ", max_size=20))
def test_any_text_is_a_unit_or_none(text: str) -> None:
    try:
        assert unit(text).size > 0
    except QuantityError:
        return


@pytest.mark.parametrize(
    ("text", "bases"),
    [("N", "kg*m/s^2"), ("N/(m*A)", "kg/(s^2*A)"), ("Hz", "1/s"), ("deg", "rad"), ("m/mm", "")],
)
def test_a_dimension_is_told_in_base_units(text: str, bases: str) -> None:
    assert units.in_bases(unit(text).dimension) == bases
