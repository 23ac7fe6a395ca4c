"""Forward-mode dual numbers on NumPy arrays: a value and one derivative of it."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]


@dataclass(frozen=True)
class Dual:
    """value + rate * e with e * e = 0."""

    value: Array
    rate: Array

    def __add__(self, other: "Dual") -> "Dual":
        return Dual(self.value + other.value, self.rate + other.rate)

    def __sub__(self, other: "Dual") -> "Dual":
        return Dual(self.value - other.value, self.rate - other.rate)

    def __mul__(self, other: "Dual") -> "Dual":
        return Dual(self.value * other.value, self.value * other.rate + self.rate * other.value)

    def sqrt(self) -> "Dual":
        root = np.sqrt(self.value)
        return Dual(root, self.rate / (2 * root))


def arctan2(y: Dual, x: Dual) -> Dual:
    square = x.value**2 + y.value**2
    return Dual(np.arctan2(y.value, x.value), (x.value * y.rate - y.value * x.rate) / square)


def constant(value: float) -> Dual:
    return Dual(np.asarray(value), np.asarray(0.0))


def dot(a: list[Dual], b: list[Dual]) -> Dual:
    products = [x * y for x, y in zip(a, b, strict=True)]
    return sum(products[1:], products[0])


def vector(values: tuple[float, ...]) -> list[Dual]:
    return [constant(value) for value in values]
