"""The equations on a machine's page give what the reference computes, with numbers put in."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from numpy.typing import NDArray

from turnbuckle.lab.pages.equations import Equation, Names, equations
from turnbuckle.lab.pages.machine import SECTIONS, machine_page
from turnbuckle.lab.pages.tex import rounded, tex_of
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference import kinematics, statics

Array = NDArray[np.float64]
MACHINES = sorted((Path(__file__).parents[2] / "machines").glob("*.toml"))
ROUNDING = 1e-12
#: Relative error of a number that is printed.
PRINTED = 1e-8


class Case:
    """A machine at a pose away from the middle, with tensions."""

    def __init__(self, machine: Machine) -> None:
        self.machine, self.equations = machine, equations(machine)
        draw = np.random.default_rng(7)
        target = machine.target
        centre = np.asarray(target.centre) + draw.uniform(-0.4, 0.4, machine.space) * target.size
        turn = draw.uniform(-0.2, 0.2, machine.dof - machine.space)
        self.pose = np.concatenate([centre, turn])
        self.rails = np.array([draw.uniform(0, rail.length) for rail in machine.rails])
        self.tension = draw.uniform(machine.tension.min, machine.tension.max, len(machine.cables))

    def values(self, found: list[Equation]) -> dict[str, Array]:
        """Every equation with numbers put in, one after the other, by key."""
        names = Names(self.machine)
        symbols = [*names.position, *names.turn, *names.rails, *names.tensions]
        known = dict(zip(symbols, [*self.pose, *self.rails, *self.tension], strict=True))
        values = {}
        for equation in found:
            compute: Callable[..., Array] = sp.lambdify(list(known), equation.value, "numpy")
            values[equation.key] = np.asarray(compute(*known.values()), float)
            known |= dict(zip(equation.symbols, values[equation.key].ravel(), strict=False))
        return values

    def expected(self) -> dict[str, NDArray[np.floating]]:
        """What the reference computes of the same."""
        machine, pose, rails = self.machine, self.pose, self.rails
        result = {
            "bases": kinematics.base_points(machine, rails),
            "lengths": kinematics.cable_lengths(machine, pose, rails)[:, None],
            "structure": kinematics.structure_matrix(machine, pose, rails),
            "jacobian": kinematics.length_jacobian(machine, pose, rails),
        }
        if machine.rails:
            force = statics.rail_forces(machine, pose, rails, self.tension)
            result["rail_jacobian"] = kinematics.rail_jacobian(machine, pose, rails)
            result["rail_forces"] = force[:, None]
        if machine.is_rigid:
            held = kinematics.anchor_points(machine, pose)
            result["arms"] = held - pose[: machine.space]
        return result

    def wrong(self, found: list[Equation], tolerance: float) -> set[str]:
        """Equations that give something else than the reference."""
        values = self.values(found)
        return {
            key
            for key, wanted in self.expected().items()
            if not np.allclose(values[key], wanted, rtol=tolerance, atol=tolerance)
        }


@pytest.fixture(scope="module", params=MACHINES, ids=lambda path: path.stem)
def case(request: pytest.FixtureRequest) -> Case:
    """Every stock machine."""
    return Case(load_machine(request.param))


def test_the_equations_give_what_the_reference_computes(case: Case) -> None:
    assert case.wrong(case.equations, ROUNDING) == set()


def test_the_numbers_are_printed_with_enough_digits(case: Case) -> None:
    printed = [
        replace(equation, value=equation.value.applyfunc(rounded)) for equation in case.equations
    ]
    assert case.wrong(printed, PRINTED) == set()


def test_every_equation_is_on_the_page_and_its_latex_is_whole(case: Case) -> None:
    page = machine_page(case.machine)
    shown = {key for keys in SECTIONS.values() for key in keys}
    for equation in case.equations:
        tex = tex_of(equation)
        assert equation.key in shown and tex in page
        assert tex.count("{") == tex.count("}")
        assert tex.count(r"\left") == tex.count(r"\right")
        assert tex.count(r"\begin") == tex.count(r"\end") == 1
        assert equation.name or all(str(symbol) in tex for symbol in equation.symbols)


@pytest.mark.parametrize("key", ["bases", "lengths", "structure", "jacobian", "rail_forces"])
def test_a_wrong_sign_is_noticed(key: str, stock: Machine) -> None:
    def seeded(equation: Equation) -> Equation:
        return replace(equation, value=-equation.value) if equation.key == key else equation

    assert key in Case(stock).wrong([*map(seeded, equations(stock))], ROUNDING)


def test_numbers_of_another_machine_are_noticed() -> None:
    one, other = (load_machine(path) for path in MACHINES if path.stem.startswith("yoon_fixed"))
    assert "lengths" in Case(one).wrong(equations(other), ROUNDING)


def test_numbers_printed_with_too_few_digits_are_noticed(stock: Machine) -> None:
    def coarse(value: sp.Expr) -> sp.Expr:
        return value.xreplace({n: sp.Rational(f"{float(n):.3g}") for n in value.atoms(sp.Rational)})

    found = [replace(each, value=each.value.applyfunc(coarse)) for each in equations(stock)]
    assert "lengths" in Case(stock).wrong(found, PRINTED)
