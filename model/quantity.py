"""Quantities with units: text such as "21 g*cm^2" in a machine file, SI floats inside."""

import math
import re
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cache
from typing import Annotated, Literal

from pydantic import BeforeValidator, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, core_schema

from turnbuckle.model.problem import refusal, shown
from turnbuckle.model.units import (
    BASES,
    NUMBER,
    WITHOUT_UNIT,
    Dimension,
    QuantityError,
    Written,
    in_bases,
    unit,
    written,
)

Sign = Literal["any", "not negative", "greater than zero"]

NOT_FINITE_QUANTITY = re.compile(r"[+-]?(?:nan|inf|infinity)(?:\s.*)?", re.IGNORECASE)
# Sizes of quantities of which nothing else is known; squares stay within single precision.
SMALLEST, LARGEST = 1e-12, 1e9
# The exact fraction of a number beyond this power of ten would fill the memory.
MOST_DIGITS = 400
ANGLE = BASES.index("rad")

#: What a quantity in these units is, for those who mistook one for another.
MEANINGS = {
    "m": "a length",
    "m^2": "an area",
    "kg": "a mass",
    "s": "a time",
    "Hz": "a frequency",
    "rad": "an angle",
    "rad^2": "a solid angle",
    "rad/s": "a speed of rotation",
    "m/s": "a speed",
    "m/s^2": "an acceleration",
    "N": "a force",
    "N*m": "a torque",
    "N/m": "a stiffness",
    "N*s/m": "a damping",
    "N*m*s": "a rotary damping",
    "kg*m^2": "a moment of inertia",
    "W": "a power",
    "A": "a current",
    "V": "a voltage",
    "bit": "an amount of data",
    "bit/s": "a bit rate",
}


@cache
def _meanings() -> dict[Dimension, str]:
    return {unit(name).dimension: what for name, what in MEANINGS.items()}


def meaning(name: str) -> str:
    """What a quantity in this unit is; QuantityError where there is no such unit."""
    dimension = unit(name).dimension
    return _meanings().get(dimension) or f"a quantity in {in_bases(dimension) or 'no unit'}"


def _float(number: Decimal, size: Fraction) -> float:
    """The float nearest to so many units of a size; infinite or zero beyond all floats."""
    if abs(number.adjusted()) > MOST_DIGITS:
        return 0.0 if number.adjusted() < 0 else math.inf
    try:
        return float(Fraction(number) * size)
    except OverflowError:
        return math.inf


@dataclass(frozen=True)
class Quantity:
    """What a key accepts: the kind of quantity, its SI unit, an example, the sign and the size.

    least, most: of the size, in SI units; beyond it a value is a slip of the pen, and products of
    such values might leave single precision. per_angle: whether it is one per angle, of which
    "/rad" may be left out. clearly: what to say to who gives another kind of quantity.
    """

    what: str
    si: str
    example: str
    sign: Sign = "greater than zero"
    least: float = SMALLEST
    most: float = LARGEST
    per_angle: bool = False
    clearly: str = ""

    @property
    def allowed(self) -> str:
        """The wording of what is allowed here."""
        sign = "" if self.sign == "any" else f", {self.sign}"
        return f'{self.what} with its unit{sign}, such as "{self.example}"'

    def parse(self, value: object) -> float:
        """Text of the machine file -> SI float; raises the refusal to show to the user."""
        if isinstance(value, bool) or not isinstance(value, str | int | float):
            raise refusal(self.allowed)
        if not isinstance(value, str):
            raise refusal(self.allowed, f"{shown(value)}, {WITHOUT_UNIT}")
        if NOT_FINITE_QUANTITY.fullmatch(value.strip()):
            raise refusal(f"a finite number: {self.allowed}")
        try:
            return self._in_si(written(value), shown(value))
        except QuantityError as error:
            found = f"{shown(value)}, {error.remark}" if error.remark else ""
            hint = f"; {error.hint}" if error.hint else ""
            raise refusal(f"{self.allowed}{hint}", found) from None

    def _in_si(self, quantity: Written, found: str) -> float:
        if not math.isfinite(float(quantity.number)):
            raise refusal(f"a finite number: {self.allowed}")
        its, target = unit(quantity.unit), unit(self.si)
        if not self._fits(its.dimension, target.dimension):
            clearly = f" ({self.clearly})" if self.clearly else ""
            raise refusal(f"{self.allowed}{clearly}", f"{found}, {meaning(quantity.unit)}")
        self._check_sign(quantity)
        magnitude = _float(quantity.number, its.size / target.size)
        # Where zero may be, what is next to it may be too: a coordinate that a search has found.
        least = self.least if self.sign == "greater than zero" else min(self.least, SMALLEST)
        if quantity.number and not least <= abs(magnitude) <= self.most:
            sizes = f"of a size from {least:g} to {self.most:g} {self.si}"
            raise refusal(f"{self.allowed}, {sizes}")
        return magnitude

    def _fits(self, its: Dimension, due: Dimension) -> bool:
        turned = tuple(n * (base != "rad") for base, n in zip(BASES, its, strict=True))
        return its == due or (self.per_angle and turned == due and its[ANGLE] == -1)

    def _check_sign(self, quantity: Written) -> None:
        below = quantity.number < 0 and self.sign != "any"
        if below or (not quantity.number and self.sign == "greater than zero"):
            raise refusal(self.allowed)

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.parse)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        return {"type": "string", "pattern": rf"^\s*{NUMBER}\s*\S+.*$", "examples": [self.example]}


@dataclass(frozen=True)
class Whole:
    """What a key of a whole number accepts: its meaning and its bounds."""

    what: str
    least: int
    most: int

    @property
    def allowed(self) -> str:
        """The wording of what is allowed here."""
        return f"{self.what}, a whole number from {self.least} to {self.most}"

    def parse(self, value: object) -> int:
        """Number of the machine file; raises the refusal to show to the user."""
        if isinstance(value, bool) or not isinstance(value, int):
            raise refusal(self.allowed)
        if not self.least <= value <= self.most:
            raise refusal(self.allowed)
        return value

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.parse)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        return {"type": "integer", "minimum": self.least, "maximum": self.most}


def _array(what: str, example: str) -> BeforeValidator:
    """Refuses anything but an array of two or three, before its entries are looked at."""

    def check(value: object) -> object:
        if isinstance(value, list) and len(value) in (2, 3):
            return value
        raise refusal(f"an array of two or three {what}, such as {example}")

    return BeforeValidator(check)


def _unit_vector(value: object) -> tuple[float, ...]:
    """Two or three plain numbers -> the vector of length 1 along them."""
    allowed = "two or three plain numbers, finite and not all zero, such as [-1, 0]"
    try:
        entries = [_plain_number(entry) for entry in (value if isinstance(value, list) else [])]
    except (ValueError, OverflowError):
        raise refusal(allowed) from None
    largest = max(map(abs, entries), default=0.0)
    if len(entries) not in (2, 3) or not 0 < largest < math.inf:
        raise refusal(allowed)
    length = math.hypot(*(entry / largest for entry in entries))
    # Adding zero makes a plain zero of a negative one.
    return tuple(entry / largest / length + 0.0 for entry in entries)


def _plain_number(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        raise ValueError(value)
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(value)
    return number


def _length(sign: Sign = "greater than zero") -> Quantity:
    """From a micrometre to ten kilometres."""
    return Quantity("a length", "m", "5 mm", sign, least=1e-6, most=1e4)


def _force(example: str, sign: Sign = "greater than zero") -> Quantity:
    return Quantity("a force", "N", example, sign, least=1e-6, most=1e6)


def _torque(example: str, sign: Sign = "greater than zero") -> Quantity:
    return Quantity("a torque", "N*m", example, sign, least=1e-9, most=1e6)


def _stiffness(example: str, sign: Sign = "greater than zero") -> Quantity:
    return Quantity("a stiffness", "N/m", example, sign, least=1e-6, most=1e9)


def _angle(example: str, sign: Sign = "greater than zero") -> Quantity:
    return Quantity("an angle", "rad", example, sign, least=1e-6, most=1e3)


Coordinate = Annotated[float, _length("any")]
Length = Annotated[float, _length()]
LengthOrZero = Annotated[float, _length("not negative")]
Force = Annotated[float, _force("10 N")]
ForceOrZero = Annotated[float, _force("3 N", "not negative")]
Mass = Annotated[float, Quantity("a mass", "kg", "0.1 kg", least=1e-6, most=1e6)]
Torque = Annotated[float, _torque("55 mN*m")]
TorqueOrZero = Annotated[float, _torque("1 mN*m", "not negative")]
TorqueRate = Annotated[
    float, Quantity("a torque per time", "N*m/s", "20 N*m/s", least=1e-6, most=1e9)
]
Inertia = Annotated[
    float, Quantity("a moment of inertia", "kg*m^2", "21 g*cm^2", least=1e-12, most=1e6)
]
RotaryDamping = Annotated[
    float,
    Quantity(
        "a rotary damping",
        "N*m*s",
        "0.05 g*m^2/s",
        "not negative",
        least=1e-12,
        most=1e6,
        per_angle=True,
    ),
]
Frequency = Annotated[
    float,
    Quantity(
        "a frequency",
        "Hz",
        "1 kHz",
        least=1e-3,
        most=1e5,
        clearly="cycles, not angle, per second",
    ),
]
Stiffness = Annotated[float, _stiffness("3560 N/m")]
StiffnessOrZero = Annotated[float, _stiffness("300 N/m", "not negative")]
IntegralGain = Annotated[
    float,
    Quantity("an integral gain", "N/(m*s)", "30000 N/(m*s)", "not negative", least=1e-6, most=1e12),
]
Damping = Annotated[
    float, Quantity("a damping", "N*s/m", "5 N*s/m", "not negative", least=1e-6, most=1e9)
]
Angle = Annotated[float, _angle("45 deg")]
AngleOrZero = Annotated[float, _angle("20 deg", "not negative")]
BitRate = Annotated[float, Quantity("a bit rate", "bit/s", "1 Mbit/s", clearly="bits per second")]
Current = Annotated[float, Quantity("a current", "A", "2.27 A", least=1e-3, most=1e3)]
TorqueConstant = Annotated[
    float,
    Quantity("a torque constant", "N*m/A", "114 mN*m/A", least=1e-6, most=1e3, per_angle=True),
]
Speed = Annotated[float, Quantity("a speed", "m/s", "50 mm/s", least=1e-6, most=1e3)]
Acceleration = Annotated[
    float, Quantity("an acceleration", "m/s^2", "0.5 m/s^2", least=1e-6, most=1e6)
]
Delay = Annotated[float, Quantity("a time", "s", "40 us", least=1e-6, most=0.1)]
Duration = Annotated[float, Quantity("a time", "s", "20 ms", least=1e-6, most=3600.0)]
Point = Annotated[tuple[Coordinate, ...], _array("lengths", '["0 mm", "461.8 mm"]')]
Size = Annotated[tuple[Length, ...], _array("lengths", '["506 mm", "284 mm"]')]
UnitVector = Annotated[tuple[float, ...], BeforeValidator(_unit_vector)]
