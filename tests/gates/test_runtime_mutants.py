"""A few mutants of the runtime are noticed by its tests (`make mutants`: hundreds are)."""

import json
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

from turnbuckle.lab.mutants.draw import drawn, sources
from turnbuckle.lab.mutants.mutation import Mutation, mutations
from turnbuckle.lab.mutants.report import judge
from turnbuckle.lab.mutants.trial import SURVIVES, Verdict

ROOT = Path(__file__).parents[2]
COUNT, SEED = 4, 4
#: In a process of its own: the tests of a mutant run in forks of it.
TRY = """
import json, sys
from pathlib import Path
from turnbuckle.lab.mutants.kept import Verdicts
from turnbuckle.lab.mutants.mutation import Mutation
from turnbuckle.lab.mutants.run import UnchangedFails, unchanged_passes, verdicts
from turnbuckle.lab.mutants.suites import JOURNEY, suite_of
from turnbuckle.lab.mutants.trial import prepare
given = json.load(sys.stdin)
try:
    unchanged_passes(given["unchanged"])
except UnchangedFails as error:
    sys.exit(str(error))
if given["tests"] is None:
    prepare()
def suite(file):
    quick = [test for test in suite_of(file) if test not in JOURNEY]
    return quick if given["tests"] is None else given["tests"]
told = []
mutants = [Mutation(*each) for each in given["mutants"]]
verdicts(mutants, Verdicts(Path(given["kept"])), 1, lambda *each: told.append(each), suite)
print(json.dumps(told))
"""


def tried(
    folder: Path,
    mutants: Sequence[Mutation],
    tests: Sequence[str] | None = None,
    unchanged: Sequence[str] = (),
) -> list[tuple[Mutation, Verdict]]:
    """Mutants and what became of them before some tests, or before those of their files."""
    given = {"mutants": mutants, "tests": tests, "unchanged": unchanged}
    given["kept"] = str(folder / "verdicts.json")
    done = subprocess.run(
        [sys.executable, "-c", TRY],
        input=json.dumps(given),
        capture_output=True,
        text=True,
        cwd=ROOT,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return [(Mutation(*each), Verdict(*verdict)) for each, verdict in json.loads(done.stdout)]


@pytest.fixture(scope="module")
def deadly() -> Mutation:
    """The gate answers nothing."""
    found = mutations("core/torque_gate.c", sources()["core/torque_gate.c"])
    return next(each for each in found if each.old.startswith("*setpoint = ") and not each.new)


def test_mutants_drawn_at_random_are_noticed(tmp_path: Path) -> None:
    results = tried(tmp_path, drawn(COUNT, SEED))
    assert len(results) == COUNT
    assert judge(results) == []


def always(folder: Path, outcome: str) -> str:
    """A test that does not look at anything."""
    path = folder / "test_nothing.py"
    path.write_text(f"def test_nothing():\n    assert {outcome}\n")
    return str(path)


def test_a_mutant_that_no_test_looks_at_survives_and_is_told(
    tmp_path: Path, deadly: Mutation
) -> None:
    for tests in ([], [always(tmp_path, "True")]):
        results = tried(tmp_path, [deadly], tests)
        assert results == [(deadly, SURVIVES)]
        assert any("survives" in complaint for complaint in judge(results))


def test_tests_that_fail_without_a_mutant_are_told(tmp_path: Path) -> None:
    with pytest.raises(AssertionError, match="test_nothing fails on the unchanged runtime"):
        tried(tmp_path, [], unchanged=[always(tmp_path, "False")])
