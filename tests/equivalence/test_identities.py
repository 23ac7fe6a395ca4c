"""SymPy proves what the model claims: its Jacobians are Yoon's, its structure matrix is eq. 21.

What is proven about a function is proven about the operations that are printed as its C: the
generator's own evaluation runs on SymPy's symbols in place of numbers.
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import casadi
import numpy as np
import pytest
import sympy as sp

from codegen.evaluate import Arithmetic, evaluate
from codegen.generate import Model
from codegen.ir import Routine
from model.machine import Machine
from model.symbolic import forward_kinematics, scalar

x, y = sp.symbols("x y", positive=True)
s1, s2, s3, s4 = RAILS = sp.symbols("s1:5", positive=True)
POSE = [x, y]
SYMBOLIC = Arithmetic(
    "symbolic", lambda value: value, np.where, np.frompyfunc(sp.sqrt, 1, 1), epsilon=0.0
)


@pytest.fixture
def frame(stock: Machine) -> tuple[sp.Rational, sp.Rational]:
    """Width and height of the stock machine's frame, exactly."""
    width, height = (sp.Rational(str(size)) for size in stock.frame.size)
    return width, height


@pytest.fixture
def base_points(frame: tuple[sp.Rational, sp.Rational]) -> sp.Matrix:
    """Pulley points of Yoon Fig. 9: bottom, right, top, left."""
    width, height = frame
    return sp.Matrix([[s1, 0], [width, s2], [s3, height], [0, s4]])


@pytest.fixture
def symbolic_algebra(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """The model's formulas on SymPy's symbols."""
    scalar.sqrt.register(sp.Basic, sp.sqrt)
    monkeypatch.setattr(casadi, "SX", sp.Integer)
    monkeypatch.setattr(casadi, "fmin", sp.Min)
    yield


def printed(model: Model, name: str) -> sp.Matrix:
    """First output of a routine, from the operations that become its C."""
    routine = next(item for item in model.items() if item.function.name == name)
    assert isinstance(routine, Routine)
    by_name = {"pose": POSE, "rails": list(RAILS)}
    inputs: list[Any] = [np.array([by_name[p.name]], dtype=object) for p in routine.function.inputs]
    (entries,) = evaluate(replace(routine, verdicts=[]), inputs, SYMBOLIC).outputs
    exact = [sp.nsimplify(np.ravel(entry)[0], rational=True) for entry in entries]
    rows, columns = (*routine.function.outputs[0].shape, 1)[:2]
    return sp.Matrix(rows, columns, exact)


def is_zero(matrix: sp.Matrix) -> bool:
    return all(sp.simplify(entry) == 0 for entry in matrix)


def cable_lengths(base_points: sp.Matrix) -> sp.Matrix:
    """Yoon eq. 18."""
    return sp.Matrix([sp.sqrt((b - x) ** 2 + (c - y) ** 2) for b, c in base_points.tolist()])


def test_lengths_are_equation_18(stock_model: Model, base_points: sp.Matrix) -> None:
    lengths = printed(stock_model, "cable_lengths")
    assert is_zero(lengths.applyfunc(lambda length: length**2) - squared(base_points))


def squared(base_points: sp.Matrix) -> sp.Matrix:
    return cable_lengths(base_points).applyfunc(lambda length: length**2)


def test_the_length_jacobian_is_that_of_equations_5_and_20(
    stock_model: Model, base_points: sp.Matrix
) -> None:
    jacobian = printed(stock_model, "length_jacobian")
    lengths = cable_lengths(base_points)
    # eq. 5: A l' = B c' with A = diag(l_i), rows of B: -(b_i - c)'; eq. 20 is B for this machine
    rows = -(base_points - sp.ones(4, 1) * sp.Matrix([POSE]))
    assert is_zero(sp.diag(*lengths) * jacobian - rows)
    assert is_zero(jacobian - lengths.jacobian(POSE))


def test_the_rail_jacobian_is_the_derivative_of_equation_18(
    stock_model: Model, base_points: sp.Matrix
) -> None:
    jacobian = printed(stock_model, "rail_jacobian")
    assert is_zero(jacobian - cable_lengths(base_points).jacobian(RAILS))


def test_the_structure_matrix_is_equation_21_and_minus_the_transposed_jacobian(
    stock_model: Model, base_points: sp.Matrix, frame: tuple[sp.Rational, sp.Rational]
) -> None:
    structure = printed(stock_model, "structure_matrix")
    width, height = frame
    l1, l2, l3, l4 = cable_lengths(base_points)
    equation_21 = sp.Matrix(
        [
            [(s1 - x) / l1, (width - x) / l2, (s3 - x) / l3, -x / l4],
            [-y / l1, (s2 - y) / l2, (height - y) / l3, (s4 - y) / l4],
        ]
    )
    assert is_zero(structure - equation_21)
    assert is_zero(structure.T + cable_lengths(base_points).jacobian(POSE))


@pytest.mark.usefixtures("symbolic_algebra")
def test_the_closed_form_finds_the_pose_of_exact_lengths(
    stock: Machine, base_points: sp.Matrix
) -> None:
    points = base_points.tolist()
    pose, _ = forward_kinematics.multilateration(points, list(cable_lengths(base_points)))
    assert is_zero(sp.Matrix(pose) - sp.Matrix(POSE))


@pytest.mark.usefixtures("symbolic_algebra")
def test_a_gauss_newton_step_stays_at_the_pose_of_exact_lengths(base_points: sp.Matrix) -> None:
    lengths = list(cable_lengths(base_points))
    pose, distances = forward_kinematics.gauss_newton_step(base_points.tolist(), lengths, POSE)
    assert pose == POSE and distances == lengths


def test_a_wrong_sign_is_no_identity(stock_model: Model, base_points: sp.Matrix) -> None:
    structure = printed(stock_model, "structure_matrix")
    assert not is_zero(structure.T - cable_lengths(base_points).jacobian(POSE))
