"""A machine whose every number is a little different: what is made of a number changes with it."""

from collections.abc import Iterator
from itertools import count
from typing import Any, get_args

from turnbuckle.model.machine import Machine
from turnbuckle.model.quantity import UnitVector
from turnbuckle.model.table import Table

#: Between the factors of two numbers: far above rounding, far too little to change a decision.
STEP = 2.0**-30
_DIRECTION = get_args(UnitVector)[1]


def varied(machine: Machine) -> Machine:
    """The machine with every number times a factor of its own; zero stays zero.

    Lengths along one axis share a factor, so that what coincides or lies in line still does.
    Directions stay.
    """
    factors = (1 + number * STEP for number in count(1))
    axes = (next(factors),) * 3
    result: Machine = _varied(machine, axes, factors)
    return result


def _varied(value: Any, axes: tuple[float, ...], factors: Iterator[float]) -> Any:
    """A part of the machine, varied."""
    match value:
        case float():
            return value * next(factors)
        case (float(), *_):
            return tuple(entry * factor for entry, factor in zip(value, axes, strict=False))
        case tuple():
            return tuple(_varied(entry, axes, factors) for entry in value)
        case Table():
            parts = {
                name: getattr(value, name)
                if _DIRECTION in field.metadata
                else _varied(getattr(value, name), axes, factors)
                for name, field in type(value).model_fields.items()
            }
            return type(value).model_construct(**parts)
    return value
