"""The compiled C and the generator's own evaluation agree to the bit, whichever compiler."""

from pathlib import Path

import numpy as np
import pytest

from turnbuckle.codegen.bind import REALS, Generated
from turnbuckle.codegen.evaluate import DOUBLE, FLOAT, evaluate
from turnbuckle.codegen.hard_cases import HardSampler
from turnbuckle.codegen.model import Model
from turnbuckle.codegen.verify import call
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import Status

POINTS = 3000
ARITHMETIC = {"double": DOUBLE, "float": FLOAT}


@pytest.mark.parametrize("precision", REALS)
def test_the_c_is_what_the_generator_evaluates_to_the_bit(
    precision: str, stock: Machine, stock_model: Model, request: pytest.FixtureRequest
) -> None:
    generated: Generated = request.getfixturevalue("double" if precision == "double" else "single")
    sampler = HardSampler(stock, 61, POINTS)
    for item in stock_model.items():
        function = item.function
        arguments = [
            sampler.argument(function.name, p.name, p.size).astype(REALS[precision])
            for p in function.inputs
        ]
        computed = evaluate(item, arguments, ARITHMETIC[precision])
        shaped = [a.reshape(-1, *p.shape) for a, p in zip(arguments, function.inputs, strict=True)]
        answer = call(generated.functions[function.name], shaped)
        usable = answer["status"] <= Status.INFEASIBLE
        assert usable.any(), function.name
        for output, entries in zip(function.outputs, computed.outputs, strict=True):
            wanted = np.stack(np.broadcast_arrays(*entries), axis=-1)
            given = answer[output.name].reshape(POINTS, -1)
            same = (given == wanted) | ~usable[:, None]
            assert np.all(same), f"{function.name}.{output.name}"


@pytest.mark.parametrize("precision", REALS)
def test_gcc_and_clang_give_the_same_bits(
    precision: str,
    stock: Machine,
    stock_folder: Path,
    request: pytest.FixtureRequest,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    by_gcc: Generated = request.getfixturevalue("double" if precision == "double" else "single")
    monkeypatch.setenv("CC", "clang")
    by_clang = Generated(stock, stock_folder, precision)
    assert by_clang.library != by_gcc.library
    sampler = HardSampler(stock, 62, POINTS)
    for name, function in by_gcc.functions.items():
        arguments = [
            sampler.argument(name, p.name, p.size).reshape(-1, *p.shape) for p in function.inputs
        ]
        one, other = (call(g.functions[name], arguments) for g in (by_gcc, by_clang))
        for output, values in one.items():
            assert values.tobytes() == other[output].tobytes(), f"{name}.{output}"
