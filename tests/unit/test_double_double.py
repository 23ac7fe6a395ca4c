"""Arithmetic with 106 bits against exact fractions."""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from turnbuckle.codegen.double_double import DoubleDouble, choose, two_product, two_sum

RANDOM = np.random.default_rng(1)
A, B = RANDOM.standard_normal((2, 200)) * 10.0 ** RANDOM.integers(-8, 8, (2, 200))
ULP = Fraction(1, 2**100)


def exact(number: DoubleDouble, k: int) -> Fraction:
    return Fraction(float(number.high[k])) + Fraction(float(number.low[k]))


@pytest.mark.parametrize(
    "operation",
    [lambda a, b: a + b, lambda a, b: a - b, lambda a, b: a * b, lambda a, b: a / b],
    ids=["sum", "difference", "product", "quotient"],
)
def test_operations_are_right_to_a_hundred_bits(operation: Callable[[Any, Any], Any]) -> None:
    wide = operation(DoubleDouble(A, A * 1e-17), DoubleDouble(B, B * 1e-17))
    for k in range(len(A)):
        one, other = (Fraction(v) + Fraction(v * 1e-17) for v in (float(A[k]), float(B[k])))
        wanted = operation(one, other)
        size = abs(one) + abs(other) if wanted == one + other or wanted == one - other else wanted
        assert abs(exact(wide, k) - wanted) <= ULP * abs(size)


def test_the_error_free_transformations_lose_nothing() -> None:
    for transform, sign in ((two_sum, "+"), (two_product, "*")):
        rounded, rest = transform(A, B)
        for a, b, high, low in zip(A, B, rounded, rest, strict=True):
            one, other = Fraction(float(a)), Fraction(float(b))
            wanted = one + other if sign == "+" else one * other
            assert Fraction(float(high)) + Fraction(float(low)) == wanted


def test_a_root_squared_is_the_number() -> None:
    root = DoubleDouble(np.abs(A)).sqrt()
    for k in range(len(A)):
        number = Fraction(float(abs(A[k])))
        assert abs(exact(root, k) ** 2 - number) <= 8 * ULP * number


def test_the_root_of_zero_is_zero() -> None:
    assert DoubleDouble(np.zeros(1)).sqrt().high[0] == 0


def test_comparison_looks_at_the_low_part() -> None:
    one, more = DoubleDouble(np.ones(1)), DoubleDouble(np.ones(1), np.full(1, 1e-20))
    assert one < more and one <= more and not more < one
    assert one != more and one == DoubleDouble(np.ones(1)) and not bool(one == more)
    assert choose(np.array([True]), one, more).low[0] == 0
