"""Loops of bounded length: evaluated as the C runs, and never longer than they say."""

import casadi as ca
import numpy as np
import pytest
from built import answered, built

from turnbuckle.codegen.accuracy import measure
from turnbuckle.codegen.bind import REALS
from turnbuckle.codegen.composite import Loop, Procedure, cost, fingerprint, loop
from turnbuckle.codegen.evaluate import DOUBLE, evaluate, extended
from turnbuckle.codegen.lower import lower
from turnbuckle.codegen.simplify import simplify
from turnbuckle.codegen.verify import call
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import (
    EPSILON,
    ModelFunction,
    Output,
    Repeat,
    Retry,
    Status,
    Verdict,
    carried,
    make_input,
    scalar_output,
    vector_output,
)
from turnbuckle.model.symbolic.scalar import where

#: Newton's method halves a start that is far too large in every step, then doubles the digits.
ENOUGH = 40
FALLBACK = -1.0


def prepared(repeat: Repeat) -> Loop:
    return loop(repeat, lambda part: simplify(lower(part)))


def newton(most: int = ENOUGH, name: str = "root", within: float = 4.0) -> Loop:
    """Square root by Newton's method; the state remembers the estimate before."""
    argument = make_input("square", (1,), "1", [-10.0], [1e4])
    (square,) = argument.scalars()
    start = [
        vector_output("estimate", "1", [square + 1]),
        scalar_output("before", "1", square + 2),
    ]
    begin = ModelFunction(
        f"{name}_begin",
        "A start above the root",
        "",
        (argument,),
        tuple(start),
        (Verdict(square < 0, Status.OUT_OF_DOMAIN, "no real root"),),
    )
    state = carried(start)
    estimate = state[0].scalars()[0]
    better = (estimate + square / estimate) / 2
    done = ca.fabs(better - estimate) <= within * EPSILON * estimate
    step = ModelFunction(
        f"{name}_step",
        "Newton's step",
        "",
        (argument, state[0]),
        (
            vector_output("estimate", "1", [better]),
            Output("before", (), "1", [estimate]),
            scalar_output("done", "1", where(done, 1, 0)),
        ),
    )
    finish = ModelFunction(
        f"{name}_finish",
        "The last two estimates",
        "",
        state,
        (vector_output("root", "1", [state[0].scalars()[0], state[1].scalars()[0]], FALLBACK),),
    )
    return prepared(Repeat(name, "Square root", "Heron", begin, step, finish, most))


def squares(count: int = 2000) -> np.ndarray:
    numbers = np.random.default_rng(3).uniform(-10.0, 1e4, (count, 1))
    numbers[:4, 0] = 0.0, 1.0, 1e-30, 1e4
    return numbers


@pytest.mark.parametrize("precision", REALS)
def test_the_c_of_a_loop_is_its_evaluation_to_the_bit(precision: str, stock: Machine) -> None:
    item = newton()
    generated = built(stock, [item], precision)
    answered(item, generated, [squares()])
    answer = call(generated.functions["root"], [squares().astype(REALS[precision])])
    fine = answer["status"] == Status.OK
    numbers = squares().astype(REALS[precision])[fine, 0]
    assert fine.sum() > 1900
    assert np.allclose(answer["root"][fine, 0], np.sqrt(numbers), rtol=1e-6, atol=1e-6)


def test_with_more_bits_a_loop_is_nearer_the_exact_result() -> None:
    numbers = np.random.default_rng(4).uniform(1.0, 1e4, (200, 1))
    root = evaluate(newton(), [numbers], extended(DOUBLE.epsilon)).outputs[0][0]
    assert np.all(abs((root * root).high - numbers[:, 0]) <= 4 * DOUBLE.epsilon * numbers[:, 0])
    assert np.any(root.low != 0)


@pytest.mark.parametrize("precision", REALS)
def test_a_loop_that_is_never_done_stops_at_its_bound_and_says_so(
    precision: str, stock: Machine
) -> None:
    item = newton(most=7, within=-1.0)
    generated = built(stock, [item], precision)
    answered(item, generated, [squares()])
    status = call(generated.functions["root"], [squares().astype(REALS[precision])])["status"]
    assert set(status) == {Status.INACCURATE, Status.OUT_OF_DOMAIN}


def test_the_bound_is_in_the_c_and_in_its_comment(stock: Machine) -> None:
    folder = built(stock, [newton()], "double").folder
    assert f"steps < {ENOUGH} &&" in (folder / "tb_tension.c").read_text()
    assert f"At most {ENOUGH} steps." in (folder / "tb_tension.h").read_text()
    assert "_step" not in (folder / "tb_tension.h").read_text()


def test_every_step_costs_and_the_bound_counts() -> None:
    short, long = newton(most=10), newton(most=20)
    assert cost(long)["div"] - cost(short)["div"] == 10 * cost(short.step)["div"]
    assert fingerprint(short) != fingerprint(long)


def test_the_error_of_a_loop_is_measured(stock: Machine, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        "turnbuckle.codegen.samples.Sampler.argument", lambda self, *_: squares(self.count)
    )
    found = measure(stock, newton()).results["root"]
    assert 0 < found["double"].error < 1e-10 < found["float"].error < 1.0


def halved() -> Loop:
    """Serves a square of at most 100 in place of a larger one, by halving it."""
    argument = make_input("square", (1,), "1", [-10.0], [1e4])
    (square,) = argument.scalars()
    start = [vector_output("served", "1", [square])]
    state = carried(start)
    (served,) = state[0].scalars()
    fits = served <= 100
    begin = ModelFunction("halved_begin", "", "", (argument,), tuple(start))
    outputs = (
        vector_output("served", "1", [where(fits, served, served / 2)]),
        scalar_output("done", "1", where(fits, 1, 0)),
    )
    step = ModelFunction("halved_step", "", "", state, outputs)
    too_large = Verdict(square > 100, Status.INFEASIBLE, "too large")
    results = (vector_output("halved", "1", [served]),)
    finish = ModelFunction("halved_finish", "", "", (argument, *state), results, (too_large,))
    return prepared(Repeat("halved", "", "", begin, step, finish, 6))


@pytest.mark.parametrize("precision", REALS)
def test_a_loop_can_be_an_attempt_and_a_substitute(precision: str, stock: Machine) -> None:
    """Large squares take the first attempt too many steps, the largest ones the substitute."""
    picky, patient, substitute = newton(most=6, name="picky"), newton(), halved()
    retry = Retry("served_root", "", "", ("picky", "root"), "halved", "square")
    item = Procedure(retry, (picky, patient), substitute)
    generated = built(stock, [picky, patient, substitute, item], precision)
    answered(item, generated, [squares()])
    answer = call(generated.functions["served_root"], [squares().astype(REALS[precision])])
    assert set(answer["status"]) == {
        Status.OK,
        Status.INFEASIBLE,
        Status.INACCURATE,
        Status.OUT_OF_DOMAIN,
    }
    served = answer["root"][answer["status"] == Status.INFEASIBLE, 0]
    assert np.all((served**2 > 49) & (served**2 < 101))


def swapped() -> Repeat:
    """Two numbers change places once."""
    argument = make_input("pair", (2,), "1", [0.0], [1.0])
    start = [vector_output("a", "1", argument.scalars()), scalar_output("turns", "1", ca.SX(0))]
    state = carried(start)
    a, turns = state[0].scalars(), state[1].scalars()[0]
    begin = ModelFunction("swap_begin", "", "", (argument,), tuple(start))
    outputs = (vector_output("a", "1", a[::-1]), scalar_output("done", "1", ca.SX(1)))
    step = ModelFunction("swap_step", "", "", state[:1], outputs)
    finish = ModelFunction("swap_finish", "", "", state, (vector_output("b", "1", [*a, turns]),))
    return Repeat("swap", "", "", begin, step, finish, 3)


def test_a_state_entry_that_another_one_needs_is_not_overwritten(stock: Machine) -> None:
    answer = built(stock, [prepared(swapped())], "double").swap([0.25, 0.75])
    assert list(answer) == [0.75, 0.25, 0.0]


def test_parts_that_do_not_fit_together_are_refused() -> None:
    good = swapped()
    strange = ModelFunction("strange", "", "", carried([scalar_output("c", "1", ca.SX(0))]), ())
    for part in ("step", "finish"):
        parts = {"begin": good.begin, "step": good.step, "finish": good.finish, part: strange}
        with pytest.raises(ValueError, match=r"strange: c \(\) is none of"):
            prepared(Repeat("bad", "", "", **parts, most=3))
