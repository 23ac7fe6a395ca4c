"""One call for a map gives what the functions it stands for give one by one."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from turnbuckle.codegen.bind import Generated, generate_into_cache
from turnbuckle.codegen.hard_cases import HardSampler
from turnbuckle.codegen.judges.tensions import TENSION_ROUNDINGS
from turnbuckle.codegen.samples import Sampler
from turnbuckle.codegen.verify import verify
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.symbolic.function import Status
from turnbuckle.model.symbolic.tension import QUICK_TOLERANCE

POINTS = 20_000


@pytest.fixture(scope="module")
def without_pretension(tmp_path_factory: pytest.TempPathFactory, stock_file: Path) -> Path:
    """The stock machine with cables that may go slack."""
    path = tmp_path_factory.mktemp("slack") / "slack.toml"
    text = stock_file.read_text()
    assert 'min = "3 N"' in text
    path.write_text(text.replace('min = "3 N"', 'min = "0 N"').replace("yoon2023", "slack"))
    return path


@pytest.fixture
def without_guesses(stock: Machine, stock_folder: Path, tmp_path: Path) -> Generated:
    """The stock machine's C with guesses of T0 that always fail their check."""
    folder = Path(shutil.copytree(stock_folder, tmp_path / "generated"))
    path, limit = folder / "tb_quality.c", f"TB_C({QUICK_TOLERANCE * stock.tension.max!r})"
    text = path.read_text()
    assert text.count(f"{limit} * TB_EPSILON") == 1
    path.write_text(text.replace(f"{limit} * TB_EPSILON", f"-{limit}"))
    return Generated(stock, folder, "double")


def assert_same_quality(generated: Generated, sampler: Sampler) -> None:
    factor, force, both = (
        getattr(generated, name)(sampler.pose, sampler.rails)
        for name in ("tension_factor", "isotropic_force", "pose_quality")
    )
    assert np.array_equal(both.status, factor.status)
    bounds = generated.machine.tension
    rounding = TENSION_ROUNDINGS * np.finfo(both.factor.dtype).eps * bounds.max / bounds.min
    assert np.all(np.abs(both.factor - factor) <= rounding)
    compared = both.status <= Status.INFEASIBLE
    assert np.mean(compared) > 0.8
    assert np.array_equal(both.force[compared], force[compared])
    assert np.array_equal(both.force, np.maximum(both.margin, 0))


@pytest.mark.parametrize("precision", ["double", "single"])
def test_factor_and_force_are_those_of_their_own_functions(
    precision: str, request: pytest.FixtureRequest
) -> None:
    generated: Generated = request.getfixturevalue(precision)
    assert_same_quality(generated, HardSampler(generated.machine, 3, POINTS))


def test_where_every_guess_fails_the_exact_solve_answers_the_same(
    without_guesses: Generated, double: Generated
) -> None:
    sampler = HardSampler(double.machine, 5, POINTS)
    assert_same_quality(without_guesses, sampler)
    guessed, exact = (
        generated.pose_quality(sampler.pose, sampler.rails).factor
        for generated in (double, without_guesses)
    )
    assert np.any(guessed != exact)


def test_outside_the_workspace_the_margin_says_how_far(double: Generated) -> None:
    sampler = HardSampler(double.machine, 4, POINTS)
    both = double.pose_quality(sampler.pose, sampler.rails)
    outside = both.status == Status.INFEASIBLE
    assert np.any(outside)
    assert np.all(both.margin[outside] < 0) and np.all(both.factor[outside] == 0)


def test_without_pretension_there_is_a_margin_but_no_factor(without_pretension: Path) -> None:
    machine = load_machine(without_pretension)
    generated = Generated(machine, generate_into_cache(machine), "double")
    middle = np.array(machine.target.centre)
    both = generated.pose_quality(middle, generated.base_targets(middle))
    assert both.status == Status.OK
    assert both.margin == pytest.approx(machine.tension.max, rel=1e-12)
    assert both.factor == 0


def test_without_pretension_the_c_agrees_with_the_reference(without_pretension: Path) -> None:
    report = verify(without_pretension, points=400, seed=5)
    rows = [row for row in report.rows if row.function == "pose_quality"]
    assert rows and all(row.ok for row in rows), "\n".join(map(str, rows))
