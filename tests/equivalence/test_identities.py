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
from unmeasured import machine_named

from turnbuckle.codegen.evaluate import Arithmetic, evaluate
from turnbuckle.codegen.ir import Routine
from turnbuckle.codegen.lower import lower
from turnbuckle.codegen.model import Model
from turnbuckle.codegen.simplify import simplify
from turnbuckle.model.base import BaseMotion
from turnbuckle.model.machine import Machine
from turnbuckle.model.pulley import Pulley
from turnbuckle.model.symbolic import forward_kinematics, kinematics, scalar, span
from turnbuckle.model.symbolic.function import Input, ModelFunction, make_input, matrix_output
from turnbuckle.model.symbolic.scalar import Matrix

x, y = sp.symbols("x y", positive=True)
s1, s2, s3, s4 = RAILS = sp.symbols("s1:5", positive=True)
POSE = [x, y]
#: Cables of the general machine.
CABLES = 5
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
    return evaluated(routine, {"pose": POSE, "rails": list(RAILS)})


def evaluated(routine: Routine, by_name: dict[str, list[Any]]) -> sp.Matrix:
    """First output of a routine on symbols."""
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


def general_machine(monkeypatch: pytest.MonkeyPatch) -> Machine:
    """A planar rigid machine whose anchors and bases are anywhere: Yoon Fig. 2."""
    machine = machine_named("kinematics_planar_rigid")
    axes = ((1.0, 0.0), (0.0, 1.0))
    anywhere = [
        BaseMotion((0.0, 0.0), tuple(enumerate(axes, 2 * cable))) for cable in range(CABLES)
    ]
    monkeypatch.setattr(Machine, "base_motions", tuple(anywhere))
    monkeypatch.setattr(Machine, "pulleys", (None,) * CABLES)
    monkeypatch.setattr(Machine, "anchors", ((0.0, 0.0),) * CABLES)
    return machine


def symbols(name: str, count: int) -> tuple[Input, list[sp.Symbol]]:
    """An argument, and what it is for SymPy."""
    return make_input(name, (count,), "m", [0.0], [1.0]), list(sp.symbols(f"{name}1:{count + 1}"))


def proven(inputs: list[tuple[Input, list[sp.Symbol]]], rows: Matrix) -> sp.Matrix:
    """A matrix of the model on SymPy's symbols, by way of the operations of its C."""
    arguments = tuple(entry for entry, _ in inputs)
    function = ModelFunction("proven", "", "", arguments, (matrix_output("rows", "1", rows),))
    by_name: dict[str, list[Any]] = {entry.name: known for entry, known in inputs}
    return evaluated(simplify(lower(function)), by_name)


def general_place() -> tuple[list[tuple[Input, list[sp.Symbol]]], sp.Matrix, sp.Matrix]:
    """Arguments centre, arms R p_i and bases; cable vectors and arms as rows."""
    centre, arms, bases = (
        symbols("c", 2),
        symbols("p", 2 * CABLES),
        symbols("b", 2 * CABLES),
    )
    arm_rows = sp.Matrix(CABLES, 2, arms[1])
    vectors = (
        sp.Matrix(CABLES, 2, bases[1]) - arm_rows - sp.ones(CABLES, 1) * sp.Matrix([centre[1]])
    )
    return [centre, arms, bases], vectors, arm_rows


def test_the_length_jacobian_of_a_rigid_platform_is_that_of_equation_5(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    machine = general_machine(monkeypatch)
    inputs, vectors, arm_rows = general_place()
    centre, arms, bases = (entry for entry, _ in inputs)
    arms_of = [arms.scalars()[2 * i : 2 * i + 2] for i in range(CABLES)]
    jacobian = kinematics.length_jacobian(machine, centre.scalars(), arms_of, bases.scalars())
    moments = [
        arm_rows[i, 0] * vectors[i, 1] - arm_rows[i, 1] * vectors[i, 0] for i in range(CABLES)
    ]
    # eq. 5: A l' = B x' with A = diag(l_i), rows of B: -[l_i', (R p_i x l_i)']
    rows = -vectors.row_join(sp.Matrix(moments))
    lengths = [sp.sqrt(vectors[i, 0] ** 2 + vectors[i, 1] ** 2) for i in range(CABLES)]
    assert is_zero(sp.diag(*lengths) * proven(inputs, jacobian) - rows)


def test_the_length_rates_of_moving_bases_are_those_of_equation_3(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    machine = general_machine(monkeypatch)
    inputs, vectors, _ = general_place()
    centre, arms, bases = (entry for entry, _ in inputs)
    held = [
        [c + p for c, p in zip(centre.scalars(), arms.scalars()[2 * i : 2 * i + 2], strict=True)]
        for i in range(CABLES)
    ]
    jacobian = proven(inputs, kinematics.rail_jacobian(machine, held, bases.symbols))
    for i in range(CABLES):
        length = sp.sqrt(vectors[i, 0] ** 2 + vectors[i, 1] ** 2)
        wanted = sp.zeros(1, 2 * CABLES)
        # eq. 3: l_i l_i' = l_i . b_i' - ...: a base adds its own speed along the cable
        wanted[0, 2 * i], wanted[0, 2 * i + 1] = vectors[i, 0], vectors[i, 1]
        assert is_zero(length * jacobian[i, :] - wanted)


def length_gradient(pulley: Pulley, reach: Input) -> tuple[Matrix, Matrix]:
    """Gradient of a cable's length by its anchor, and the unit vector towards the pulley."""
    cable = span.span(pulley, reach.scalars(), [0] * reach.size, casadi.atan2)
    gradient = kinematics.derivative([cable.length], reach.symbols)
    return kinematics.as_rows(gradient), [cable.ray]


@pytest.mark.parametrize("winds", [1, -1])
def test_over_a_planar_pulley_the_gradient_is_minus_the_tangent(winds: int) -> None:
    reach, known = symbols("d", 2)
    gradient, ray = length_gradient(Pulley(0.125, winds, (0.6, 0.8)), reach)
    difference = proven([(reach, known)], gradient) + proven([(reach, known)], ray)
    assert is_zero(difference)


def test_over_a_swivelling_pulley_the_gradient_is_minus_the_tangent() -> None:
    reach, known = symbols("d", 3)
    gradient, ray = length_gradient(Pulley(0.125, axis=(0.0, 0.0, 1.0)), reach)
    difference = proven([(reach, known)], gradient) + proven([(reach, known)], ray)
    across, along, _ = known
    # with the swivel arm h for sqrt(x^2 + y^2)
    arm = sp.symbols("h", positive=True)
    assert is_zero(difference.subs(along, sp.sqrt(arm**2 - across**2)))
