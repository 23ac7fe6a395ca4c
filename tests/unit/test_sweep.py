"""Sweeps over subsets of the cables: every subset is visited, in C as in the evaluation."""

from dataclasses import replace
from itertools import combinations

import casadi as ca
import numpy as np
import pytest
from built import answered, built
from numpy.typing import NDArray

from turnbuckle.codegen.accuracy import FEWEST_POINTS, FIRST_POINTS, MOST_WORK, affordable
from turnbuckle.codegen.bind import REALS
from turnbuckle.codegen.composite import cost, fingerprint, most_visits
from turnbuckle.codegen.enumeration import Enumeration, enumeration
from turnbuckle.codegen.evaluate import DOUBLE, evaluate, extended
from turnbuckle.codegen.model import lowered
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import (
    Output,
    Status,
    Verdict,
    make_input,
    scalar_output,
    vector_output,
)
from turnbuckle.model.symbolic.linear import dot
from turnbuckle.model.symbolic.scalar import Vector, where
from turnbuckle.model.symbolic.sweep import Ports, Scheme, Subset, Sweep, make_sweep

ROWS, COLUMNS = 3, 5
PAIRS = tuple(combinations(range(COLUMNS), 2))


def longest_sum(size: int = 2) -> Sweep:
    """Of all sums of `size` columns the longest: its square, and the numbers of the columns."""
    matrix = make_input("matrix", (ROWS, COLUMNS), "1", [-4.0], [4.0])
    state = (scalar_output("square", "1", ca.SX(-1)), vector_output("best", "1", [ca.SX(0)] * size))

    def visit(subset: Subset, known: Ports) -> dict[str, Vector]:
        total = [sum(row[1:], row[0]) for row in subset.columns.rows()]
        (before,) = known["square"].scalars()
        longer = dot(total, total) > before
        pairs = zip(subset.numbers.scalars(), known["best"].scalars(), strict=True)
        return {
            "square": [where(longer, dot(total, total), before)],
            "best": [where(longer, a, b) for a, b in pairs],
        }

    def finish(known: Ports) -> tuple[tuple[Output, ...], tuple[Verdict, ...]]:
        (square,) = known["square"].scalars()
        results = (
            scalar_output("length", "1", ca.sqrt(square)),
            vector_output("columns", "1", known["best"].scalars()),
        )
        return results, (Verdict(square < 9, Status.INFEASIBLE, "all sums are short"),)

    scheme = Scheme((matrix,), "matrix", size, state, visit, finish)
    sweep = make_sweep("longest", "Longest sum", "trial", scheme)
    broken = Verdict(matrix.scalars()[0] > 3, Status.SINGULAR, "the first entry exceeds 3")
    return replace(sweep, begin=replace(sweep.begin, verdicts=(broken,)))


def item(size: int = 2) -> Enumeration:
    return enumeration(longest_sum(size), lowered)


def matrices(count: int = 300) -> NDArray[np.float64]:
    return np.random.default_rng(5).uniform(-1.6, 3.1, (count, ROWS, COLUMNS))


@pytest.mark.parametrize("precision", REALS)
def test_the_c_of_a_sweep_is_its_evaluation_to_the_bit(precision: str, stock: Machine) -> None:
    answered(item(), built(stock, [item()], precision), [matrices()])


@pytest.mark.parametrize("size", [1, 2, 4])
def test_the_c_finds_the_best_of_all_subsets(size: int, stock: Machine) -> None:
    given = matrices()
    answer = built(stock, [item(size)], "double").longest(given)
    table = np.array(list(combinations(range(COLUMNS), size)))
    lengths = np.linalg.norm(given[:, :, table].sum(axis=-1), axis=1)
    fine = answer.status <= Status.INFEASIBLE
    assert 0 < fine.sum() < len(given)
    assert np.allclose(answer.length[fine], lengths.max(axis=1)[fine], rtol=1e-14)
    assert np.array_equal(answer.columns[fine], table[lengths.argmax(axis=1)][fine])
    assert np.array_equal(answer.status[fine] == Status.INFEASIBLE, lengths.max(1)[fine] < 3)


def test_a_shorter_table_finds_less(stock: Machine) -> None:
    """The negative control: the answers depend on every row of the table."""
    short = enumeration(replace(longest_sum(), subsets=PAIRS[:-1]), lowered)
    found, all_found = (
        built(stock, [each], "double").longest(matrices()).length for each in (short, item())
    )
    assert np.any(found < all_found)


def test_the_table_is_in_the_c_and_the_number_of_visits_in_its_comment(stock: Machine) -> None:
    folder = built(stock, [item()], "double").folder
    code = (folder / "tb_tension.c").read_text()
    assert "static const unsigned char subsets[10][2] = {{0,1}, {0,2}," in code
    assert "for (int k = 0; k < 10; k++)" in code
    header = (folder / "tb_tension.h").read_text()
    assert "Visits 10 subsets of the cables." in header
    assert "longest_visit" not in header


def test_every_visit_costs() -> None:
    short = enumeration(replace(longest_sum(), subsets=PAIRS[:4]), lowered)
    difference = cost(item())["mul"] - cost(short)["mul"]
    assert difference == (most_visits(item()) - 4) * cost(short.visit)["mul"] > 0
    assert fingerprint(short) != fingerprint(item())


def test_with_more_bits_a_sweep_is_nearer_the_exact_result() -> None:
    flat = matrices().reshape(-1, ROWS * COLUMNS)
    wide = evaluate(item(), [flat], extended(DOUBLE.epsilon)).outputs
    exact, near = wide[0][0], evaluate(item(), [flat], DOUBLE).outputs[0][0]
    assert np.any(exact.low != 0)
    assert np.max(np.abs(exact.high - near)) < 1e-14


def test_a_long_sweep_is_tried_at_fewer_points() -> None:
    assert affordable(item(), FIRST_POINTS) == FIRST_POINTS
    long = enumeration(replace(longest_sum(), subsets=PAIRS * 64), lowered)
    operations = sum(cost(long).values())
    assert affordable(long, FIRST_POINTS) == int(MOST_WORK / operations) < FIRST_POINTS
    longer = enumeration(replace(longest_sum(), subsets=PAIRS * 6400), lowered)
    assert affordable(longer, FIRST_POINTS) == FEWEST_POINTS


def test_parts_that_do_not_fit_together_are_refused() -> None:
    good = longest_sum()
    with pytest.raises(ValueError, match="are not 2 of 5 columns"):
        enumeration(replace(good, subsets=((0, 1), (3, 5))), lowered)
    strange = replace(good.finish, inputs=(make_input("other", (2,), "1", [0.0], [0.0]),))
    with pytest.raises(ValueError, match=r"longest_finish: other \(2,\) is none of"):
        enumeration(replace(good, finish=strange), lowered)
    mixed = replace(good.finish, outputs=(scalar_output("numbers", "1", ca.SX(0)),))
    with pytest.raises(ValueError, match="another port has the name numbers"):
        enumeration(replace(good, finish=mixed), lowered)
    doubtful = replace(good.visit, verdicts=good.finish.verdicts)
    with pytest.raises(ValueError, match="only longest_finish may find the problem infeasible"):
        enumeration(replace(good, visit=doubtful), lowered)
