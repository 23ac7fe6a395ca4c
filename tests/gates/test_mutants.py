"""A changed operator, constant, index or comparison in any generated function is noticed.

One mutation of a kind goes into every function at once, and every function must be found wrong.
"""

import re
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.model import Model
from turnbuckle.codegen.verify import Trial

POINTS = 250
FUNCTION = re.compile(r"^tb_status tb_(\w+)\([^{;]*\)\n\{\n(.*?)^\}", re.M | re.S)
#: The guard of the arguments has tests of its own (totality); mutations go behind it.
GUARD = re.compile(r".*?return TB_OUT_OF_DOMAIN;\n    \}\n", re.S)


def last(pattern: str, replacement: str) -> Callable[[str], str]:
    """Replace the last occurrence: close to the results, where a mutation cannot be dead."""

    def mutate(code: str) -> str:
        found = list(re.finditer(pattern, code))
        if not found:
            return code
        place = found[-1]
        return code[: place.start()] + place.expand(replacement) + code[place.end() :]

    return mutate


#: Residuals are zero up to rounding, and so are some refusals: changing one by little, or its sign,
#: changes nothing.
RESULT = r"(\w+(?<!residual)\[\d+\]) = (?!TB_C\(0\.0\);)(.*);"
MUTATIONS = {
    "sum becomes difference": last(r" \+ ", " - "),
    "product becomes sum": last(r" \* ", " + "),
    "another entry is read": last(r"(?<== )(.*\w)\[0\]", r"\1[1]"),
    "a result is scaled": last(RESULT, r"\1 = (\2) * TB_C(1.0000001);"),
    "a result is negated": last(RESULT, r"\1 = -(\2);"),
    "fine becomes infeasible": last(r"\bTB_OK;", "TB_INFEASIBLE;"),
}


#: The quick attempt may give up anywhere: a mutant that always does costs time only. The last
#: product of the solvers and of the zero-wrench tension is the tolerance of their own check; so is
#: the last sum of pose_quality, in a way that one pose in ten thousand goes (test_pose_quality).
HARMLESS = {
    "sum becomes difference": {"least_norm_tension_quick", "pose_quality"},
    "product becomes sum": {
        "least_norm_tension_quick",
        "least_norm_tension",
        "zero_wrench_tension",
        "pose_quality",
    },
    # in eq. 10 it is in the pivots, which only tell singular poses
    "another entry is read": {"least_norm_tension_quick", "wrench_share_eq10"},
}


def mutated(source: str, mutate: Callable[[str], str]) -> tuple[str, set[str]]:
    """C with every function mutated, and the names of those in which something changed."""
    changed: set[str] = set()

    def one(function: re.Match[str]) -> str:
        name, body = function.groups()
        guard = GUARD.match(body)
        start = guard.end() if guard else 0
        fresh = body[:start] + mutate(body[start:])
        if fresh != body:
            changed.add(name)
        return function.group().replace(body, fresh)

    return FUNCTION.sub(one, source), changed


@pytest.fixture(scope="module")
def trial(double: Generated, stock_model: Model, stock_accuracies: dict[str, Accuracy]) -> Trial:
    return Trial(double, stock_model, stock_accuracies, POINTS, seed=11)


def unnoticed(trial: Trial, folder: Path, names: set[str]) -> set[str]:
    trial.generated = Generated(trial.machine, folder, "double")
    return {name for name in names if all(row.ok for row in trial.rows(name))}


@pytest.mark.parametrize("kind", MUTATIONS)
def test_a_mutation_of_any_function_is_noticed(
    kind: str, trial: Trial, stock_folder: Path, tmp_path: Path
) -> None:
    folder = Path(shutil.copytree(stock_folder, tmp_path / "mutant"))
    changed: set[str] = set()
    for path in folder.glob("*.c"):
        text, names = mutated(path.read_text(), MUTATIONS[kind])
        path.write_text(text)
        changed |= names
    assert len(changed) >= 8
    assert unnoticed(trial, folder, changed) <= HARMLESS.get(kind, set())


def test_unchanged_c_is_not_found_wrong(trial: Trial, stock_folder: Path) -> None:
    names = set(trial.generated.functions)
    assert unnoticed(trial, stock_folder, names) == names
