"""Quantities become the SI floats that were meant, whatever unit they are written in."""

import math
from collections.abc import Callable
from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic_core import PydanticCustomError

from turnbuckle.model import quantity
from turnbuckle.model.quantity import LARGEST, SMALLEST, Quantity

KINDS = [
    part
    for kind in vars(quantity).values()
    for part in getattr(kind, "__metadata__", ())
    if isinstance(part, Quantity)
]
"""Every kind of quantity that a key of a machine file may be."""
LENGTH = Quantity("a length", "m", "5 mm", sign="any")
# quantity -> units and what one of them is in SI, exactly
UNITS: dict[str, dict[str, str]] = {
    "m": {"m": "1", "mm": "1e-3", "cm": "1e-2", "µm": "1e-6", "km": "1e3", "inch": "0.0254"},
    "N": {"N": "1", "kN": "1e3", "kg*m/s^2": "1", "mN*m / m": "1e-3"},
    "N*m": {"N*m": "1", "mN*m": "1e-3", "N m": "1", "N*cm": "1e-2", "J": "1", "mNm": "1e-3"},
    "N*m*s": {"N*m*s": "1", "g*m^2/s": "1e-3", "kg*m**2/s": "1", "mNms": "1e-3", "Nm s": "1"},
    "kg*m^2": {"kg*m^2": "1", "g*cm^2": "1e-7", "kg*cm^2": "1e-4", "gcm2": "1e-7", "g·cm²": "1e-7"},
    "Hz": {"Hz": "1", "kHz": "1e3", "1/s": "1", "s^-1": "1", "1/ms": "1e3"},
    "N/m": {"N/m": "1", "N/mm": "1e3", "kg/s^2": "1"},
    "N/(m*s)": {"N/(m*s)": "1", "N/m/s": "1", "kN/(m s)": "1e3", "kg/s^3": "1"},
    "N*s/m": {"N*s/m": "1", "N/(m/s)": "1", "kg/s": "1"},
    "kg": {"kg": "1", "g": "1e-3"},
}
WRITTEN = [(si, unit, one) for si, units in UNITS.items() for unit, one in units.items()]
MEASURES = st.decimals(Decimal("1e-3"), Decimal("1e4"), allow_nan=False, places=4)


@pytest.mark.parametrize(("si", "unit", "one"), WRITTEN)
@given(number=MEASURES)
def test_a_quantity_is_the_float_nearest_to_what_was_written(
    si: str, unit: str, one: str, number: Decimal
) -> None:
    quantity = Quantity("a quantity", si, "", sign="any")
    assert quantity.parse(f"{number} {unit}".replace(".", ",")) == float(number * Decimal(one))
    assert quantity.parse(f"{number} {unit}") == float(number * Decimal(one))


@given(st.floats(SMALLEST, LARGEST) | st.floats(-LARGEST, -SMALLEST) | st.just(0.0))
def test_a_float_written_with_its_unit_comes_back_unchanged(value: float) -> None:
    assert LENGTH.parse(f"{value!r} m") == value


@given(st.floats(1e-3, 1e3))
def test_units_convert_back_and_forth_within_rounding(value: float) -> None:
    there = Quantity("a length", "inch", "").parse(f"{value!r} m")
    assert math.isclose(LENGTH.parse(f"{there!r} inch"), value, rel_tol=4e-16)


@pytest.mark.parametrize(
    "text", ["5mm", " 5 mm ", "+5 mm", "5. mm", "0.5e+1 mm", "5E0 mm", "5,0 mm"]
)
def test_a_number_may_be_written_in_any_usual_way(text: str) -> None:
    assert LENGTH.parse(text) == 5e-3


@pytest.mark.parametrize(
    ("name", "accepted"),
    [
        ("rotary damping", ("N*m*s", "N*m*s/rad")),
        ("torque constant", ("N*m/A", "N*m/(rad*A)", "V*s/rad", "V*s")),
        ("torque", ("N*m",)),
    ],
)
def test_an_angle_may_be_left_out_where_a_quantity_is_one_per_angle(
    name: str, accepted: tuple[str, ...], parses: Callable[[Quantity, str], bool]
) -> None:
    kind = next(q for q in KINDS if q.what == f"a {name}")
    damping, constant = ["N*m*s", "N*m*s/rad", "N*m*s*rad"], ["N*m/A", "N*m/(rad*A)"]
    units = [*damping, *constant, "V*s/rad", "V*s", "V*s*rad", "N*m", "N*m/rad"]
    assert tuple(unit for unit in units if parses(kind, f"1 {unit}")) == accepted


def test_a_speed_constant_in_turns_is_what_it_is_in_radians() -> None:
    constant = next(q for q in KINDS if q.what == "a torque constant")
    assert math.isclose(constant.parse("2.9 mV/rpm"), 2.9e-3 * 60 / (2 * math.pi), rel_tol=1e-15)


@given(st.text(max_size=90) | st.from_regex(r"\A[0-9eE+.-]{1,9} ?[a-zA-Zµ°/*^() 0-9-]{0,9}\Z"))
def test_no_text_gets_past_as_anything_but_a_finite_number(text: str) -> None:
    try:
        value = LENGTH.parse(text)
    except PydanticCustomError:
        return
    assert value == 0 or SMALLEST <= abs(value) <= LARGEST


@pytest.mark.parametrize(
    ("sign", "accepted"),
    [("any", (-1, 0, 1)), ("not negative", (0, 1)), ("greater than zero", (1,))],
)
def test_each_sign_lets_through_what_it_says(
    sign: str, accepted: tuple[int, ...], parses: Callable[[Quantity, str], bool]
) -> None:
    quantity = Quantity("a length", "m", "", sign=sign)  # type: ignore[arg-type]
    assert tuple(n for n in (-1, 0, 1) if parses(quantity, f"{n} m")) == accepted


@pytest.fixture
def parses() -> Callable[[Quantity, str], bool]:
    def check(quantity: Quantity, text: str) -> bool:
        try:
            quantity.parse(text)
        except PydanticCustomError:
            return False
        return True

    return check
