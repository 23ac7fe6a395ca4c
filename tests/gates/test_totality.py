"""Whatever a generated function is given, it answers: a status, and numbers."""

from itertools import combinations
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from turnbuckle.codegen.bind import REALS, Generated, GeneratedFunction
from turnbuckle.codegen.model import Model
from turnbuckle.codegen.samples import Sampler
from turnbuckle.codegen.verify import call
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import ModelFunction, Status

BASE_POINTS = 12
EXTREMES = ["nan", "inf", "-inf", "1e30", "-1e30", "largest", "smallest", "0", "-0.0", "1", "-1"]


def extreme(text: str, real: Any) -> Any:
    if text == "largest":
        return np.finfo(real).max
    if text == "smallest":
        return np.finfo(real).smallest_subnormal
    return real(text)


def model_function(model: Model, name: str) -> ModelFunction:
    target = model.aliases().get(name, name)
    return next(item.function for item in model.items() if item.function.name == target)


def ordinary(machine: Machine, function: ModelFunction, real: Any) -> NDArray[Any]:
    """All entries of all arguments side by side (points, entries)."""
    sampler = Sampler(machine, 5, BASE_POINTS)
    columns = [sampler.argument(function.name, p.name, p.size) for p in function.inputs]
    return np.concatenate(columns, axis=1).astype(real)


def spoiled(points: NDArray[Any], real: Any) -> NDArray[Any]:
    """Every entry, every pair of entries and all entries of the points at every extreme."""
    count, entries = points.shape
    places = [[entry] for entry in range(entries)]
    places += [list(pair) for pair in combinations(range(entries), 2)]
    places += [list(range(entries)), list(range(0, entries, 2))]
    blocks = []
    for text in EXTREMES:
        for turn, place in enumerate(places):
            # pairs are many: one point each does
            block = points.copy() if len(place) == 1 else points[[turn % count]]
            block[:, place] = extreme(text, real)
            blocks.append(block)
    return np.concatenate(blocks)


def answer(
    called: GeneratedFunction, function: ModelFunction, points: NDArray[Any]
) -> dict[str, NDArray[Any]]:
    splits = np.cumsum([port.size for port in function.inputs])[:-1]
    parts = np.split(points, splits, axis=1)
    return call(
        called,
        [part.reshape(-1, *p.shape) for part, p in zip(parts, function.inputs, strict=True)],
    )


@pytest.mark.parametrize("precision", REALS)
def test_no_argument_makes_a_function_answer_anything_but_numbers(
    precision: str, stock: Machine, stock_model: Model, request: pytest.FixtureRequest
) -> None:
    generated: Generated = request.getfixturevalue("double" if precision == "double" else "single")
    real = REALS[precision]
    broken = []
    for name, called in generated.functions.items():
        function = model_function(stock_model, name)
        points = spoiled(ordinary(stock, function, real), real)
        given = answer(called, function, points)
        status = given.pop("status")
        assert np.all((status >= 0) & (status < len(Status))), name
        finite = np.all(np.isfinite(points), axis=1)
        assert np.all(status[~finite] == Status.OUT_OF_DOMAIN), name
        for output, values in given.items():
            stray = ~np.all(np.isfinite(values.reshape(len(points), -1)), axis=1)
            if stray.any():
                first = int(np.argmax(stray))
                broken.append(
                    f"{name}.{output} is not a number at {points[first].tolist()}, "
                    f"status {Status(int(status[first])).name} ({stray.sum()} times)"
                )
    assert not broken, "\n".join(broken)


def test_a_function_that_passes_a_nan_on_would_be_noticed(
    stock: Machine, stock_model: Model, double: Generated
) -> None:
    function = model_function(stock_model, "motor_torques")
    points = spoiled(ordinary(stock, function, np.float64), np.float64)
    unguarded = points * stock.drum.radius
    assert np.isnan(unguarded).any()
    assert not np.isnan(answer(double.functions["motor_torques"], function, points)["torque"]).any()
