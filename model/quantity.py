"""Quantities with units: text such as "21 g*cm^2" in a machine file, SI floats inside."""

import math
import re
from dataclasses import dataclass
from decimal import Decimal
from functools import cache
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import BeforeValidator, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, core_schema

from turnbuckle.model.problem import refusal, shown

if TYPE_CHECKING:
    import pint

Sign = Literal["any", "not negative", "greater than zero"]

NUMBER = r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]{1,9})?"
NOT_FINITE = r"[+-]?(?:nan|inf|infinity)"
FACTOR = r"[A-Za-zµμ_]+(?:\^-?[1-4])?"
BETWEEN = r"(?:\s*[*/]\s*|\s+)"
GROUP = rf"(?:{FACTOR}|\(\s*{FACTOR}(?:{BETWEEN}{FACTOR})*\s*\))"
# pint evaluates what it reads, so only a unit of this plain shape is ever handed to it.
UNIT = rf"(?:1\s*/\s*)?{GROUP}(?:{BETWEEN}{GROUP})*"
QUANTITY = re.compile(rf"(?P<number>{NUMBER})\s*(?P<unit>{UNIT})")
WITHOUT_UNIT = re.compile(NUMBER)
NOT_FINITE_QUANTITY = re.compile(rf"{NOT_FINITE}(?:\s.*)?", re.IGNORECASE)
LONGEST = 80
# Beyond these a value is a slip of the pen, and its square would leave single precision.
SMALLEST, LARGEST = 1e-12, 1e9


@cache
def _registry() -> "pint.UnitRegistry[Any]":
    """One registry; decimal, so that "711.8 mm" is the float 0.7118 and nothing beside it."""
    import pint  # takes as long as all the rest, and who has a machine already needs no unit

    return pint.UnitRegistry(non_int_type=Decimal)


@cache
def _unit(text: str) -> Any:
    """The pint unit; raises whatever pint raises where it knows no such unit."""
    return _registry().parse_units(text)


@dataclass(frozen=True)
class Quantity:
    """What a key accepts: the kind of quantity, its SI unit, an example and the sign."""

    what: str
    si: str
    example: str
    sign: Sign = "greater than zero"

    @property
    def allowed(self) -> str:
        """The wording of what is allowed here."""
        sign = "" if self.sign == "any" else f", {self.sign}"
        return f'{self.what} with its unit{sign}, such as "{self.example}"'

    def parse(self, value: object) -> float:
        """Text of the machine file -> SI float; raises the refusal to show to the user."""
        number, unit = self._split(value)
        if not math.isfinite(float(number)):
            raise refusal(f"a finite number: {self.allowed}")
        magnitude = self._in_si(Decimal(number), unit, shown(value))
        self._check_size(magnitude)
        return magnitude

    def _split(self, value: object) -> tuple[str, str]:
        if isinstance(value, bool) or not isinstance(value, str | int | float):
            raise refusal(self.allowed)
        if not isinstance(value, str) or WITHOUT_UNIT.fullmatch(value.strip()):
            raise refusal(self.allowed, f"{shown(value)}, a number without a unit")
        text = value.strip().replace("**", "^")
        if NOT_FINITE_QUANTITY.fullmatch(text):
            raise refusal(f"a finite number: {self.allowed}")
        match = QUANTITY.fullmatch(text) if len(text) <= LONGEST else None
        if match is None:
            raise refusal(self.allowed)
        return match["number"], match["unit"]

    def _in_si(self, number: Decimal, unit: str, found: str) -> float:
        import pint

        try:
            return self._converted(number, _unit(unit), found)
        except (pint.PintError, AssertionError, TypeError):
            # The last two are pint's answers to units such as dBm, which are logarithms.
            raise refusal(self.allowed, f"{found}, whose unit is unknown") from None

    def _converted(self, number: Decimal, unit: Any, found: str) -> float:
        target = _unit(self.si)
        if unit.dimensionality != target.dimensionality:
            dimension = str(unit.dimensionality or "no dimension")
            raise refusal(f"{self.allowed} ({target.dimensionality})", f"{found} ({dimension})")
        quantity = _registry().Quantity(number, unit)
        # To pint angles and bits are plain numbers: 1 rad/s and 1 bit/s would pass for 1 Hz.
        counted = dict(quantity.to_root_units().unit_items()).keys()
        if self.si == "Hz" and counted & {"radian", "bit"}:
            raise refusal(f"{self.allowed} (cycles, not angle, per second)")
        if self.si == "rad" and "radian" not in counted:
            raise refusal(f"{self.allowed} (an angle)", f"{found}, which is no angle")
        if self.si == "bit/s" and "bit" not in counted:
            raise refusal(f"{self.allowed} (bits per second)")
        return float(quantity.to(target).magnitude)

    def _check_size(self, magnitude: float) -> None:
        below = magnitude < 0 and self.sign != "any"
        if below or (magnitude == 0 and self.sign == "greater than zero"):
            raise refusal(self.allowed)
        if magnitude != 0 and not SMALLEST <= abs(magnitude) <= LARGEST:
            raise refusal(f"{self.allowed}, of a size from {SMALLEST:g} to {LARGEST:g} {self.si}")

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
    float, Quantity("a rotary damping", "N*m*s/rad", "0.05 g*m^2/s", sign="not negative")
]
Frequency = Annotated[float, Quantity("a frequency", "Hz", "1 kHz")]
Stiffness = Annotated[float, Quantity("a stiffness", "N/m", "3560 N/m")]
StiffnessOrZero = Annotated[float, Quantity("a stiffness", "N/m", "300 N/m", sign="not negative")]
IntegralGain = Annotated[
    float, Quantity("an integral gain", "N/(m*s)", "30000 N/(m*s)", sign="not negative")
]
Damping = Annotated[float, Quantity("a damping", "N*s/m", "5 N*s/m", sign="not negative")]
Angle = Annotated[float, Quantity("an angle", "rad", "45 deg")]
AngleOrZero = Annotated[float, Quantity("an angle", "rad", "20 deg", sign="not negative")]
BitRate = Annotated[float, Quantity("a bit rate", "bit/s", "1 Mbit/s")]
Current = Annotated[float, Quantity("a current", "A", "2.27 A")]
TorqueConstant = Annotated[float, Quantity("a torque constant", "N*m/A", "114 mN*m/A")]
Speed = Annotated[float, Quantity("a speed", "m/s", "50 mm/s")]
Acceleration = Annotated[float, Quantity("an acceleration", "m/s^2", "0.5 m/s^2")]
Duration = Annotated[float, Quantity("a time", "s", "20 ms")]
Point = Annotated[tuple[Coordinate, ...], _array("lengths", '["0 mm", "461.8 mm"]')]
Size = Annotated[tuple[Length, ...], _array("lengths", '["506 mm", "284 mm"]')]
UnitVector = Annotated[tuple[float, ...], BeforeValidator(_unit_vector)]
