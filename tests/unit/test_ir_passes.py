"""Lowering and simplification: exact, and sparing."""

import casadi as ca
import numpy as np
import pytest

from turnbuckle.codegen.evaluate import DOUBLE, evaluate
from turnbuckle.codegen.ir import Op, Routine
from turnbuckle.codegen.item import cost, fingerprint
from turnbuckle.codegen.lower import LoweringError, lower
from turnbuckle.codegen.simplify import simplify
from turnbuckle.model.symbolic.function import ModelFunction, make_input, vector_output
from turnbuckle.model.symbolic.scalar import Vector


def function_of(build: object) -> ModelFunction:
    """A function of two numbers a and b."""
    argument = make_input("ab", (2,), "1", [-10.0], [10.0])
    a, b = argument.scalars()
    values: Vector = build(a, b)  # type: ignore[operator]
    return ModelFunction("tried", "", "", (argument,), (vector_output("out", "1", values),))


def computed(routine: Routine, a: float, b: float) -> list[float]:
    outputs = evaluate(routine, [np.array([[a, b]])], DOUBLE).outputs
    return [float(np.ravel(value)[0]) for value in outputs[0]]


@pytest.mark.parametrize(
    ("build", "wanted"),
    [
        (lambda a, b: [a + b, a - b, a * b, a / b], [5.0, 1.0, 6.0, 1.5]),
        (lambda a, b: [ca.fmin(a, b), ca.fmax(a, b), ca.sqrt(a * a), -a], [2.0, 3.0, 3.0, -3.0]),
        (lambda a, b: [ca.if_else(a > b, a, b), ca.fabs(b - a)], [3.0, 1.0]),
        (lambda a, b: [a**2, 2 * b, 1 / b], [9.0, 4.0, 0.5]),
    ],
)
def test_every_operation_survives_lowering_and_simplifying(
    build: object, wanted: list[float]
) -> None:
    lowered = lower(function_of(build))
    assert computed(lowered, 3.0, 2.0) == wanted
    assert computed(simplify(lowered), 3.0, 2.0) == wanted


def test_an_operation_without_a_c_counterpart_is_refused_by_name() -> None:
    with pytest.raises(LoweringError, match=r"tried: CasADi operation .* no C counterpart"):
        lower(function_of(lambda a, b: [ca.sin(a) + b]))


def test_equal_expressions_are_computed_once() -> None:
    routine = simplify(lower(function_of(lambda a, b: [(a + b) * (b + a), (a + b) - 1])))
    assert cost(routine)["add"] == 2 and cost(routine)["mul"] == 1


def test_two_divisions_by_one_number_share_a_reciprocal() -> None:
    routine = simplify(lower(function_of(lambda a, b: [a / b, (a + 1) / b])))
    assert cost(routine)["div"] == 1


def test_neutral_elements_cost_nothing() -> None:
    routine = simplify(lower(function_of(lambda a, b: [a * 1 + 0, b / 1 - 0, 0 * a])))
    assert cost(routine) == {}
    assert all(node.op in (Op.INPUT, Op.CONSTANT) for node in routine.nodes)


def test_the_fingerprint_tells_a_changed_constant() -> None:
    one, other = (
        simplify(lower(function_of(lambda a, b, factor=factor: [factor * a + b])))
        for factor in (2.5, 2.5000000001)
    )
    assert fingerprint(one) != fingerprint(other)
