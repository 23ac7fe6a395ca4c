"""A quantity of a machine file as text, such as "21 g*cm^2" -> its value in SI units and dimension.

Values are exact fractions: what is written becomes the nearest float, whatever its unit.

To add a unit, add a row to UNITS: its name, and what one of it is in units that are there already;
and its name to PREFIXED where k, m and the others may stand before it. tests/unit/test_units.py
then compares it with a peer. A base unit of a new dimension goes into BASES instead.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cache
from typing import NamedTuple

#: SI base units. Angles and bits count: 1 rad/s is no 1 Hz, 1 bit/s neither.
BASES = ("kg", "m", "s", "A", "rad", "bit")
#: Name -> what one of it is; as data sheets, drawings and drives have them.
UNITS = {
    "g": ("1/1000", "kg"),
    "t": ("1000", "kg"),
    "lb": ("0.45359237", "kg"),
    "oz": ("1/16", "lb"),
    "inch": ("0.0254", "m"),
    "in": ("1", "inch"),
    "ft": ("12", "inch"),
    "min": ("60", "s"),
    "h": ("60", "min"),
    "Hz": ("1", "1/s"),
    "N": ("1", "kg*m/s^2"),
    "gf": ("0.00980665", "N"),
    "lbf": ("453.59237", "gf"),
    "ozf": ("1/16", "lbf"),
    "J": ("1", "N*m"),
    "W": ("1", "J/s"),
    "V": ("1", "W/A"),
    "turn": ("6.2831853071795864769252867665590057683943", "rad"),
    "rev": ("1", "turn"),
    "rpm": ("1", "rev/min"),
    "deg": ("1/360", "turn"),
    "°": ("1", "deg"),
    "gon": ("1/400", "turn"),
    "arcmin": ("1/60", "deg"),
    "arcsec": ("1/60", "arcmin"),
    "sr": ("1", "rad^2"),
    "byte": ("8", "bit"),
    "bps": ("1", "bit/s"),
    "Bit": ("1", "bit"),
}
PREFIXES = {"G": 9, "M": 6, "k": 3, "d": -1, "c": -2, "m": -3, "µ": -6, "μ": -6, "u": -6, "n": -9}
PREFIXED = ("m", "g", "s", "A", "rad", "bit", "Hz", "N", "gf", "J", "W", "V", "bps", "Bit")
#: Words run together in data sheets: mNm, Ncm, Nms, gcm2. A power is that of the last unit.
RUN_TOGETHER = re.compile(
    "(?P<force>[GMkdcmµμun]?N)(?P<arm>[cm]?m)(?P<time>s?)|(?P<mass>k?g)(?P<reach>[cm]m|(?<=kg)m)"
)
#: Units that mean different things to different people, and what to write in their place.
UNCLEAR = {
    "mil": "a mil is 1/6400 of a turn, or 1/6000, or 1/1000 inch: write deg, mrad or mm",
    "mils": "a mil is 1/6400 of a turn, or 1/6000, or 1/1000 inch: write deg, mrad or mm",
    "grad": "a grad is 1/360 of a turn, or 1/400: write deg or gon",
    "gm": "write g, or g*m for a gram times a metre",
    "kp": "write kgf",
    "oz-in": "write ozf*in",
    "lb-in": "write lbf*in",
    "lb-ft": "write lbf*ft",
}
WITHOUT_UNIT = "a number without a unit"
DIVISOR = "put all that is divided by in parentheses, such as N/(m*s)"
DIGITS = "write digits and a decimal point only, such as 1234.5"

WORD = r"[A-Za-zµμ°]+"
NUMBER = r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]{1,9})?"
QUANTITY = re.compile(rf"(?P<number>{NUMBER})(?P<unit>(?![0-9.,'’_]|\s+(?:[02-9]|1[0-9])).*)")
#: Digits in groups, as many write large numbers.
GROUPS = re.compile(r"[+-]?[0-9]+(?:[.,'’_\s][0-9]+)+(?![0-9]).*")
#: A comma and three digits: a thousand to some, a decimal fraction to others.
THOUSANDS = re.compile(r"[+-]?[1-9][0-9]{0,2},[0-9]{3}(?![0-9]).*")
TOKEN = re.compile(rf"\s*([*/()]|{WORD}(?:-{WORD})?|\^?-?[0-9]+|\S)")
POWER = re.compile(r"\^?-?[1-4]")
LONGEST = 80

SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
SIGNS = str.maketrans({"−": "-", "·": "*", "⋅": "*", "∙": "*"})

Dimension = tuple[int, ...]


class QuantityError(ValueError):
    """Text that is no quantity; `remark`: what is odd about it, `hint`: what to write instead."""

    def __init__(self, remark: str = "", hint: str = "") -> None:
        super().__init__(remark or hint or "no number with a unit")
        self.remark, self.hint = remark, hint


class Written(NamedTuple):
    """A quantity as written: its number, and its unit as the user spells it."""

    number: Decimal
    unit: str


@dataclass(frozen=True)
class Unit:
    """A unit: what one of it is in SI base units, and the powers of BASES it is made of."""

    size: Fraction
    dimension: Dimension

    def __mul__(self, other: "Unit") -> "Unit":
        powers = zip(self.dimension, other.dimension, strict=True)
        return Unit(self.size * other.size, tuple(a + b for a, b in powers))

    def __pow__(self, power: int) -> "Unit":
        return Unit(self.size**power, tuple(a * power for a in self.dimension))


ONE = Unit(Fraction(1), (0,) * len(BASES))


def written(text: str) -> Written:
    """The number and the unit in a text; QuantityError where that is no number with a unit.

    A decimal comma is read where it cannot separate thousands.
    """
    text = text.strip().translate(SIGNS)
    match = QUANTITY.fullmatch(text) if len(text) <= LONGEST else None
    if match is None:
        raise QuantityError(hint=DIGITS if GROUPS.fullmatch(text) else "")
    number, unit_name = match["number"], match["unit"].strip()
    if not unit_name:
        raise QuantityError(WITHOUT_UNIT)
    if THOUSANDS.fullmatch(number):
        either = [f'"{number.replace(",", sign)} {unit_name}"' for sign in (".", "")]
        raise QuantityError("whose comma may mean two things", f"write {either[0]} or {either[1]}")
    return Written(Decimal(number.replace(",", ".")), unit_name)


def in_bases(dimension: Dimension) -> str:
    """A dimension as a unit: `kg*m/s^2`; "" for none."""
    above = [_power(base, n) for base, n in zip(BASES, dimension, strict=True) if n > 0]
    below = [_power(base, -n) for base, n in zip(BASES, dimension, strict=True) if n < 0]
    divisor = f"({'*'.join(below)})" if len(below) > 1 else "".join(below)
    product = "*".join(above) or ("1" if below else "")
    return f"{product}/{divisor}" if below else product


def _power(base: str, power: int) -> str:
    return base if power == 1 else f"{base}^{power}"


@cache
def unit(text: str) -> Unit:
    """The unit that a text names; QuantityError where there is none, or more than one."""
    text = re.sub("[⁻⁰¹²³⁴-⁹]+", lambda found: f"^{found[0].translate(SUPERSCRIPTS)}", text)
    text = text.translate(SIGNS).replace("**", "^")
    if not text.strip() or len(text) > LONGEST:
        raise QuantityError()
    tokens = _Tokens(text)
    result = _product(tokens)
    if tokens.next:
        raise QuantityError()
    return result


class _Tokens:
    """The words and signs of a unit, from left to right; `next` is "" after the last."""

    def __init__(self, text: str) -> None:
        self._tokens: Iterator[str] = (match[1] for match in TOKEN.finditer(text))
        self.next = ""
        self.take()

    def take(self) -> str:
        """The next one, which then is behind."""
        taken, self.next = self.next, next(self._tokens, "")
        return taken


def _product(tokens: _Tokens) -> Unit:
    """Factors in a row, up to the end or a closing parenthesis."""
    result, divided = _first(tokens), False
    while tokens.next not in ("", ")"):
        if tokens.next == "/":
            tokens.take()
            result, divided = result * _factor(tokens) ** -1, True
        elif divided:
            raise QuantityError("in which it is unclear what is divided by", DIVISOR)
        else:
            if tokens.next == "*":
                tokens.take()
            result *= _factor(tokens)
    return result


def _first(tokens: _Tokens) -> Unit:
    """The first factor of a product; 1 before a slash is one."""
    if tokens.next != "1":
        return _factor(tokens)
    tokens.take()
    if tokens.next != "/":
        raise QuantityError()
    return ONE


def _factor(tokens: _Tokens) -> Unit:
    """A word or a product in parentheses, and its power."""
    token = tokens.take()
    if token == "(":
        result = _product(tokens)
        if tokens.take() != ")":
            raise QuantityError()
        return result ** _exponent(tokens)
    _refuse_unclear(token)
    *first, last = _split(token)
    result = _named(last) ** _exponent(tokens)
    for name in first:
        result *= _named(name)
    return result


def _refuse_unclear(token: str) -> None:
    """Words that are no unit, or not one alone."""
    if token in UNCLEAR:
        raise QuantityError("whose unit is unclear", UNCLEAR[token])
    if not re.fullmatch(WORD, token):
        joined = re.fullmatch(rf"{WORD}-{WORD}", token)
        raise QuantityError(hint=f"write {token.replace('-', '*')}" if joined else "")


def _exponent(tokens: _Tokens) -> int:
    if not POWER.fullmatch(tokens.next):
        return 1
    return int(tokens.take().removeprefix("^"))


def _split(word: str) -> list[str]:
    """The units of a word: one, or several that are run together."""
    match = RUN_TOGETHER.fullmatch(word)
    return [part for part in match.groups() if part] if match else [word]


@cache
def _named(name: str) -> Unit:
    """The unit of one name."""
    if name in BASES:
        return Unit(Fraction(1), tuple(int(base == name) for base in BASES))
    if name in UNITS:
        size, of = UNITS[name]
        return Unit(Fraction(size), ONE.dimension) * unit(of)
    prefix, rest = name[:1], name[1:]
    if prefix in PREFIXES and rest in PREFIXED:
        return Unit(Fraction(10) ** PREFIXES[prefix], ONE.dimension) * _named(rest)
    meant = [known for known in _names() if known.casefold() == name.casefold()]
    raise QuantityError(
        "whose unit is unknown", f"did you mean {' or '.join(meant)}?" if meant else ""
    )


def _names() -> Iterator[str]:
    """Every name of a unit, with its prefixes."""
    yield from (*BASES, *UNITS)
    yield from (prefix + name for name in PREFIXED for prefix in PREFIXES if prefix != "μ")
