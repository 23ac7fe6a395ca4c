"""A search may give up now and then; one that does so more often is found out."""

import numpy as np
import pytest
from unmeasured import GEOMETRY, Unmeasured, geometry, items, machine_named

from turnbuckle.codegen.accuracy import Accuracy, WorstCase
from turnbuckle.codegen.judges import JUDGES
from turnbuckle.codegen.judges.problem import GIVES_UP, Problem
from turnbuckle.codegen.verify import Row, Trial, call
from turnbuckle.model.symbolic.function import Status

NAME, POINTS = "kinematics_planar_rigid", 500


@pytest.fixture(scope="module")
def trial() -> Trial:
    """The search for a pose from a guess; no error is granted beside the judge's."""
    machine = machine_named(NAME)
    model = Unmeasured(machine, items(machine, GEOMETRY))
    generated = geometry(NAME)
    nothing = {
        item.function.name: Accuracy(
            {out.name: {"double": WorstCase(0.0, out.unit, ())} for out in item.function.outputs}
        )
        for item in model.items()
    }
    return Trial(generated, model, nothing, POINTS, seed=3)


def judged(trial: Trial, share: float) -> list[Row]:
    """What is found where the C gives up at a share of the points at which it may."""
    function = trial.targets["forward_kinematics"]
    called = trial.generated.functions["forward_kinematics"]
    arguments = trial.arguments(function)
    names = [port.name for port in called.inputs]
    wide = [given.astype(np.longdouble) for given in arguments]
    problem = Problem(trial.machine, trial.epsilon, dict(zip(names, wide, strict=True)))
    with np.errstate(all="ignore"):
        wanted = JUDGES["forward_kinematics"](problem)
        answer = call(called, arguments)
        may = np.flatnonzero(wanted.allowed[:, Status.INACCURATE])
        given_up = may[: int(share * len(wanted.allowed))]
        answer["status"][given_up] = Status.INACCURATE
        for output in function.outputs:
            answer[output.name][given_up] = output.fallback
        return trial.compare(called, function, answer, wanted)


def test_a_search_that_gives_up_now_and_then_is_fine(trial: Trial) -> None:
    assert all(row.ok for row in judged(trial, GIVES_UP / 2))


def test_a_search_that_gives_up_often_is_found_out(trial: Trial) -> None:
    rows = judged(trial, 2 * GIVES_UP)
    assert not any(row.ok for row in rows)
    assert "are given up" in rows[0].first_disagreement
