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


def constant(value: float) -> Dual:
    return Dual(np.asarray(value), np.asarray(0.0))


def variables(values: Array, moving: int) -> list[Dual]:
    """The entries (k, m) of an argument as dual numbers, of which one moves at rate one."""
    return [
        Dual(column, np.full(len(values), float(i == moving))) for i, column in enumerate(values.T)
    ]
