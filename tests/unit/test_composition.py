"""Functions made of calls in sequence: locals, faults, calls that are not always made."""

from dataclasses import replace

import casadi as ca
import numpy as np
import pytest
from built import answered, built
from numpy.typing import NDArray
from test_sweep import COLUMNS, ROWS, longest_sum

from turnbuckle.codegen.bind import REALS
from turnbuckle.codegen.chain import Chain, chain
from turnbuckle.codegen.composite import Item, cost, fingerprint, most_visits
from turnbuckle.codegen.model import lowered
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.composition import Call, Composition
from turnbuckle.model.symbolic.function import (
    ModelFunction,
    Output,
    Status,
    Verdict,
    carried,
    make_input,
    scalar_output,
    vector_output,
)
from turnbuckle.model.symbolic.scalar import where

FALLBACK = -2.0


def roots() -> ModelFunction:
    """Square roots of two numbers; a negative one is a fault, small ones are infeasible."""
    pair = make_input("pair", (2,), "1", [-4.0], [4.0])
    values = pair.scalars()
    return ModelFunction(
        "roots",
        "Square roots",
        "",
        (pair,),
        (vector_output("root", "1", [ca.sqrt(value) for value in values], FALLBACK),),
        (
            Verdict(ca.logic_or(values[0] < 0, values[1] < 0), Status.OUT_OF_DOMAIN, "negative"),
            Verdict(values[0] < 0.25, Status.INFEASIBLE, "small"),
        ),
    )


def composition(given: str = "above") -> Composition:
    """Fourth roots of two numbers, minus one where the first square root exceeds its limit."""
    pair = make_input("pair", (2,), "1", [-4.0], [4.0])
    (root,) = carried([Output("root", (2,), "1", [ca.SX(0)] * 2)])
    above = scalar_output("above", "1", root.scalars()[0] - 1)
    limit = ModelFunction("limit", "How far the first exceeds 1", "", (root,), (above,))
    fourth, above_too = carried([Output("fourth", (2,), "1", [ca.SX(0)] * 2), above])
    lower = [where(above_too.scalars()[0] > 0, x - 1, x) for x in fourth.scalars()]
    result = vector_output("result", "1", lower, FALLBACK)
    last = ModelFunction("last", "All", "", (pair, fourth, above_too), (result,))
    calls = (
        Call("roots"),
        Call(limit),
        Call("roots", {"pair": "root", "root": "fourth"}, given=given),
        Call(last),
    )
    return Composition("fourths", "Fourth roots", "trial", (pair,), calls)


def item(given: str = "above") -> tuple[Item, Chain]:
    called = lowered(roots())
    return called, chain(composition(given), {"roots": called}, lowered)


def pairs() -> NDArray[np.float64]:
    return np.random.default_rng(2).uniform(-0.2, 4.0, (2000, 2))


@pytest.mark.parametrize("given", ["", "above"])
@pytest.mark.parametrize("precision", REALS)
def test_the_c_of_a_composition_is_its_evaluation_to_the_bit(
    precision: str, given: str, stock: Machine
) -> None:
    items = item(given)
    answered(items[1], built(stock, list(items), precision), [pairs()])


def test_calls_are_made_in_turn_and_where_they_should_be(stock: Machine) -> None:
    given = pairs()
    answer = built(stock, list(item()), "double").fourths(given)
    fine = np.all(given >= 0, axis=1)
    assert np.all(answer.status[~fine] == Status.OUT_OF_DOMAIN)
    assert np.all(answer[~fine] == FALLBACK)
    above = given[:, :1] > 1
    wanted = np.where(above, np.sqrt(np.sqrt(np.abs(given))) - 1, 0.0)
    assert np.array_equal(np.asarray(answer)[fine], wanted[fine])
    assert np.array_equal(answer.status[fine] == Status.INFEASIBLE, given[fine, 0] < 0.25)


def test_arguments_out_of_their_domain_are_refused(stock: Machine) -> None:
    answer = built(stock, list(item()), "double").fourths([[1.0, 5.0], [np.nan, 1.0]])
    assert list(answer.status) == [Status.OUT_OF_DOMAIN] * 2
    assert np.all(np.asarray(answer) == FALLBACK)


def test_the_same_argument_is_guarded_once(stock: Machine) -> None:
    called, fourths = item()
    folder = built(stock, [called, fourths], "double").folder
    assert (folder / "tb_tension.c").read_text().count("pair[0] >= -TB_C(4.0)") == 1


def test_a_composition_may_have_a_sweep_of_its_own(stock: Machine) -> None:
    matrix = make_input("matrix", (ROWS, COLUMNS), "1", [-4.0], [4.0])
    (length,) = carried([scalar_output("length", "1", ca.SX(0))])
    double = scalar_output("double_length", "1", 2 * length.scalars()[0])
    last = ModelFunction("twice", "Twice", "", (length,), (double,))
    whole = Composition("doubled", "", "", (matrix,), (Call(longest_sum()), Call(last)))
    doubled = chain(whole, {}, lowered)
    matrices = np.random.default_rng(5).uniform(-1.0, 3.1, (100, ROWS, COLUMNS))
    answered(doubled, built(stock, [doubled], "float"), [matrices])
    assert most_visits(doubled) == 10


def test_two_compositions_may_share_a_part(stock: Machine) -> None:
    called, fourths = item()
    again = replace(composition(), name="again")
    both: list[Item] = [called, fourths, chain(again, {"roots": called}, lowered)]
    library = built(stock, both, "double")
    assert np.array_equal(library.again(pairs()), library.fourths(pairs()))
    code = (library.folder / "tb_tension.c").read_text()
    assert code.count("static tb_status tb_limit(") == 1


def test_two_parts_of_one_name_are_refused(stock: Machine) -> None:
    called, fourths = item()
    limit = composition().calls[1].function
    assert isinstance(limit, ModelFunction)
    other = Call(replace(limit, verdicts=(Verdict(ca.SX(0), Status.SINGULAR, "never"),)))
    whole = replace(composition(), name="again")
    calls = (whole.calls[0], other, *whole.calls[2:])
    again = chain(replace(whole, calls=calls), {"roots": called}, lowered)
    with pytest.raises(ValueError, match="tb_limit stands for two functions"):
        built(stock, [called, fourths, again], "double")


def test_all_calls_cost_and_count() -> None:
    called, fourths = item()
    assert cost(fourths)["sqrt"] == 2 * cost(called)["sqrt"] == 4
    assert fingerprint(fourths) != fingerprint(item(given="")[1])


def test_calls_that_do_not_fit_are_refused() -> None:
    called, _ = item()
    whole = composition()
    known = {"roots": called}
    for calls, complaint in (
        ((Call("roots", {"pair": "nothing"}),), r"roots: nothing \(2,\) is none of"),
        ((Call("roots"), Call("roots")), "roots: there is a root already"),
        ((Call("roots", given="pair"),), "roots: pair is no number"),
    ):
        with pytest.raises(ValueError, match=complaint):
            chain(Composition(whole.name, "", "", whole.inputs, calls), known, lowered)
