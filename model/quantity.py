"""Quantities with units: text such as "21 g*cm^2" in a machine file, SI floats inside."""

import math
import re
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Annotated, Literal

from pydantic import BeforeValidator, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

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
# Beyond these a value is a slip of the pen, and its square would leave single precision.
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


@dataclass(frozen=True)
class Quantity:
    """What a key accepts: the kind of quantity, its SI unit, an example and the sign.

    per_angle: whether it is one per angle, of which "/rad" may be left out; clearly: what to say to
    who gives another kind of quantity.
    """

    what: str
    si: str
    example: str
    sign: Sign = "greater than zero"
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
        if quantity.number and abs(quantity.number.adjusted()) > MOST_DIGITS:
            raise self._of_no_size()
        magnitude = Fraction(quantity.number) * its.size / target.size
        if magnitude and not SMALLEST <= abs(magnitude) <= LARGEST:
            raise self._of_no_size()
        return float(magnitude)

    def _fits(self, its: Dimension, due: Dimension) -> bool:
        turned = tuple(n * (base != "rad") for base, n in zip(BASES, its, strict=True))
        return its == due or (self.per_angle and turned == due and its[ANGLE] == -1)

    def _check_sign(self, quantity: Written) -> None:
        below = quantity.number < 0 and self.sign != "any"
        if below or (not quantity.number and self.sign == "greater than zero"):
            raise refusal(self.allowed)

    def _of_no_size(self) -> PydanticCustomError:
        return refusal(f"{self.allowed}, of a size from {SMALLEST:g} to {LARGEST:g} {self.si}")

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


_LENGTH = "a length", "m", "5 mm"
Coordinate = Annotated[float, Quantity(*_LENGTH, sign="any")]
Length = Annotated[float, Quantity(*_LENGTH)]
LengthOrZero = Annotated[float, Quantity(*_LENGTH, sign="not negative")]
Force = Annotated[float, Quantity("a force", "N", "10 N")]
ForceOrZero = Annotated[float, Quantity("a force", "N", "3 N", sign="not negative")]
Mass = Annotated[float, Quantity("a mass", "kg", "0.1 kg")]
Torque = Annotated[float, Quantity("a torque", "N*m", "55 mN*m")]
TorqueOrZero = Annotated[float, Quantity("a torque", "N*m", "1 mN*m", sign="not negative")]
TorqueRate = Annotated[float, Quantity("a torque per time", "N*m/s", "20 N*m/s")]
Inertia = Annotated[float, Quantity("a moment of inertia", "kg*m^2", "21 g*cm^2")]
RotaryDamping = Annotated[
    float,
    Quantity("a rotary damping", "N*m*s", "0.05 g*m^2/s", sign="not negative", per_angle=True),
]
Frequency = Annotated[
    float, Quantity("a frequency", "Hz", "1 kHz", clearly="cycles, not angle, per second")
]
Stiffness = Annotated[float, Quantity("a stiffness", "N/m", "3560 N/m")]
StiffnessOrZero = Annotated[float, Quantity("a stiffness", "N/m", "300 N/m", sign="not negative")]
IntegralGain = Annotated[
    float, Quantity("an integral gain", "N/(m*s)", "30000 N/(m*s)", sign="not negative")
]
Damping = Annotated[float, Quantity("a damping", "N*s/m", "5 N*s/m", sign="not negative")]
Angle = Annotated[float, Quantity("an angle", "rad", "45 deg")]
AngleOrZero = Annotated[float, Quantity("an angle", "rad", "20 deg", sign="not negative")]
BitRate = Annotated[float, Quantity("a bit rate", "bit/s", "1 Mbit/s", clearly="bits per second")]
Current = Annotated[float, Quantity("a current", "A", "2.27 A")]
TorqueConstant = Annotated[
    float, Quantity("a torque constant", "N*m/A", "114 mN*m/A", per_angle=True)
]
Speed = Annotated[float, Quantity("a speed", "m/s", "50 mm/s")]
Acceleration = Annotated[float, Quantity("an acceleration", "m/s^2", "0.5 m/s^2")]
Duration = Annotated[float, Quantity("a time", "s", "20 ms")]
Point = Annotated[tuple[Coordinate, ...], _array("lengths", '["0 mm", "461.8 mm"]')]
Size = Annotated[tuple[Length, ...], _array("lengths", '["506 mm", "284 mm"]')]
UnitVector = Annotated[tuple[float, ...], BeforeValidator(_unit_vector)]
