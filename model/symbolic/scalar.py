"""Scalar operations the model is written in.

The model's formulas take and return plain lists of scalars, so that the same Python function runs
on CasADi symbols (to generate code) and on SymPy symbols (to prove identities). Only the square
root needs to know which of the two it got; the SymPy proof registers its own.
"""

from functools import reduce, singledispatch
from operator import add
from typing import Any, TypeAlias

import casadi as ca

Scalar: TypeAlias = Any
Vector: TypeAlias = list[Any]
Matrix: TypeAlias = list[list[Any]]


@singledispatch
def sqrt(value: Scalar) -> Scalar:
    """Square root of a scalar of whichever algebra it belongs to."""
    return ca.sqrt(value)


def where(condition: Scalar, yes: Scalar, no: Scalar) -> Scalar:
    """`yes` where the condition holds, otherwise `no`; the arm not taken has no influence."""
    return ca.if_else(condition, yes, no)


def clamp(value: Scalar, low: Scalar, high: Scalar) -> Scalar:
    """The nearest point of [low, high]."""
    return ca.fmin(ca.fmax(value, low), high)


def any_of(conditions: list[Scalar]) -> Scalar:
    """Whether one of the conditions holds."""
    return reduce(ca.logic_or, conditions)


def all_of(conditions: list[Scalar]) -> Scalar:
    """Whether every condition holds."""
    return reduce(ca.logic_and, conditions)


def largest(values: list[Scalar]) -> Scalar:
    """Largest of the values."""
    return reduce(ca.fmax, values)


def smallest(values: list[Scalar]) -> Scalar:
    """Smallest of the values."""
    return reduce(ca.fmin, values)


def total(values: list[Scalar]) -> Scalar:
    """Sum, added from the left: the order of the generated C."""
    return reduce(add, values)
