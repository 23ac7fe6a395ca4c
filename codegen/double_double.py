"""Arithmetic with 106 significant bits on NumPy arrays, from error-free transformations.

Only + - * / and sqrt of doubles, which IEEE 754 fixes to the bit: the same result on any machine.
Algorithms: Dekker 1971; Hida, Li, Bailey 2001.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
_SPLITTER = 134217729.0  # 2^27 + 1


def two_sum(a: Array, b: Array) -> tuple[Array, Array]:
    """a + b as a rounded sum and its exact error."""
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


def two_product(a: Array, b: Array) -> tuple[Array, Array]:
    """a b as a rounded product and its exact error."""
    product = a * b
    high_a, low_a = _split(a)
    high_b, low_b = _split(b)
    error = ((high_a * high_b - product) + high_a * low_b + low_a * high_b) + low_a * low_b
    return product, np.where(np.isfinite(product), error, 0.0)


def _split(a: Array) -> tuple[Array, Array]:
    scaled = _SPLITTER * a
    high = scaled - (scaled - a)
    return high, a - high


class DoubleDouble:
    """An unevaluated sum high + low with |low| at most half a unit in the last place of high."""

    __slots__ = ("high", "low")

    def __init__(self, high: Any, low: Any = 0.0) -> None:
        self.high: Array = np.asarray(high, dtype=np.float64)
        self.low: Array = np.asarray(low, dtype=np.float64)

    def spread(self, count: int) -> "DoubleDouble":
        """One number as `count` equal ones; so many numbers as they are."""
        return DoubleDouble(*(np.broadcast_to(part, (count,)) for part in (self.high, self.low)))

    def __getitem__(self, places: NDArray[np.int_]) -> "DoubleDouble":
        return DoubleDouble(self.high[places], self.low[places])

    def __neg__(self) -> "DoubleDouble":
        return DoubleDouble(-self.high, -self.low)

    def __add__(self, other: "DoubleDouble") -> "DoubleDouble":
        high, low = two_sum(self.high, other.high)
        tail, rest = two_sum(self.low, other.low)
        high, low = two_sum(high, low + tail)
        return _normalised(high, low + rest)

    def __sub__(self, other: "DoubleDouble") -> "DoubleDouble":
        return self + (-other)

    def __mul__(self, other: "DoubleDouble") -> "DoubleDouble":
        high, low = two_product(self.high, other.high)
        return _normalised(high, low + (self.high * other.low + self.low * other.high))

    def __truediv__(self, other: "DoubleDouble") -> "DoubleDouble":
        first = self.high / other.high
        rest = self - other * DoubleDouble(first)
        second = rest.high / other.high
        rest = rest - other * DoubleDouble(second)
        return _normalised(*two_sum(first, second)) + DoubleDouble(rest.high / other.high)

    def __abs__(self) -> "DoubleDouble":
        return choose(self.high < 0, -self, self)

    def sqrt(self) -> "DoubleDouble":
        """Square root: the rounded root and one Newton correction."""
        root = np.sqrt(self.high)
        rest = self - DoubleDouble(root) * DoubleDouble(root)
        safe = np.where(root > 0, root, 1.0)
        return _normalised(*two_sum(root, np.where(root > 0, rest.high / (2 * safe), 0.0)))

    def __lt__(self, other: "DoubleDouble") -> Any:
        return (self.high < other.high) | ((self.high == other.high) & (self.low < other.low))

    def __le__(self, other: "DoubleDouble") -> Any:
        return (self.high < other.high) | ((self.high == other.high) & (self.low <= other.low))

    def __eq__(self, other: object) -> Any:
        assert isinstance(other, DoubleDouble)
        return (self.high == other.high) & (self.low == other.low)

    def __ne__(self, other: object) -> Any:
        return ~(self == other)

    __hash__ = None  # type: ignore[assignment]  # equality is entry by entry


def _normalised(high: Array, low: Array) -> DoubleDouble:
    total = high + low
    return DoubleDouble(total, np.where(np.isfinite(total), low - (total - high), 0.0))


def choose(condition: NDArray[np.bool_], yes: DoubleDouble, no: DoubleDouble) -> DoubleDouble:
    """Entry by entry the one or the other."""
    return DoubleDouble(
        np.where(condition, yes.high, no.high), np.where(condition, yes.low, no.low)
    )
