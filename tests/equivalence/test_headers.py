"""The errors that the headers state hold on fresh points of the working domain."""

import numpy as np
import pytest

from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.bind import REALS, Generated
from turnbuckle.codegen.judges import JUDGES
from turnbuckle.codegen.judges.problem import Problem
from turnbuckle.codegen.model import Model
from turnbuckle.codegen.samples import Sampler
from turnbuckle.codegen.verify import call, drawn
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import Status

POINTS = 20_000
#: Tensions are judged by the condition of each problem instead, in test_tension.
UNCONDITIONED = [
    name
    for name in JUDGES
    if not name.startswith(("distribute_", "least_norm_", "served_", "zero_", "tension_"))
    and not name.startswith(("kernel_", "reduced_", "largest_"))
]


@pytest.mark.parametrize("precision", REALS)
def test_no_error_is_larger_than_the_header_says(
    precision: str,
    stock: Machine,
    stock_model: Model,
    stock_accuracies: dict[str, Accuracy],
    request: pytest.FixtureRequest,
) -> None:
    generated: Generated = request.getfixturevalue("double" if precision == "double" else "single")
    epsilon = float(np.finfo(REALS[precision]).eps)
    sampler = Sampler(stock, 81, POINTS)
    broken = []
    for function in (item.function for item in stock_model.items()):
        if function.name not in UNCONDITIONED:
            continue
        given = [
            drawn(sampler, function.name, p).reshape(POINTS, *p.shape).astype(REALS[precision])
            for p in function.inputs
        ]
        names = [p.name for p in function.inputs]
        wide = {n: a.astype(np.longdouble) for n, a in zip(names, given, strict=True)}
        with np.errstate(all="ignore"):
            wanted = JUDGES[function.name](Problem(stock, epsilon, wide).at_first())
        answer = call(generated.functions[function.name], given)
        right = wanted.allowed[np.arange(POINTS), answer["status"]]
        decided = right & (np.sum(wanted.allowed, axis=1) == 1)
        usable = decided & (answer["status"] <= Status.INFEASIBLE)
        assert np.mean(usable) > 0.5, function.name
        for output, reference in wanted.values.items():
            error = np.abs(answer[output] - reference)[usable]
            # constants that the generator folds are rounded once, the reference's are not
            folded = 4 * epsilon * float(np.max(np.abs(reference[usable]), initial=0))
            bound = stock_accuracies[function.name].results[output][precision].bound + folded
            if not np.all(error <= bound):
                broken.append(f"{function.name}.{output}: {np.max(error):.2g}, not {bound:.2g}")
    assert not broken, "\n".join(broken)
