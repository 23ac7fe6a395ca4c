"""The C of machines that are not the stock one agrees with the reference as well."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from built import optimised

import turnbuckle.codegen.verify
from turnbuckle.codegen import accuracy, accuracy_cache
from turnbuckle.codegen.accuracy import Accuracy
from turnbuckle.codegen.bind import REALS, Generated, folder_of
from turnbuckle.codegen.generate import render
from turnbuckle.codegen.model import Model, build_model
from turnbuckle.codegen.verify import Row, Trial, verify
from turnbuckle.model.reading import load_machine

MACHINES = sorted((Path(__file__).parents[1] / "machines").glob("*.toml"))
POINTS = 100
#: Topics that a structure matrix is given to: of machines with as many cables in as many
#: dimensions, one is enough.
OF_A_STRUCTURE = ("tension", "comparison")


def first_alike(paths: list[Path]) -> set[Path]:
    """The first machine of every kind with every number of cables."""
    machines = {path: load_machine(path) for path in reversed(paths)}
    return set({(m.kind, len(m.cables)): path for path, m in machines.items()}.values())


FIRST_ALIKE = first_alike(MACHINES)


@pytest.fixture
def quick_compiler() -> Iterator[None]:
    """It optimises nothing."""
    with optimised("-O0"):
        yield


@pytest.fixture
def short_search(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """It finds lower bounds for the headers, if any; they must not be kept."""
    monkeypatch.setattr(accuracy_cache, "CACHE", tmp_path)
    monkeypatch.setattr(accuracy, "FIRST_POINTS", 1024)
    monkeypatch.setattr(accuracy, "ROUNDS", 0)
    monkeypatch.setattr(accuracy, "MOST_WORK", 4e6)


@pytest.mark.parametrize("path", MACHINES, ids=lambda path: path.stem)
@pytest.mark.usefixtures("quick_compiler", "short_search")
def test_the_c_of_another_machine_agrees_with_the_reference(path: Path) -> None:
    model = build_model(load_machine(path))
    left_out = () if path in FIRST_ALIKE else OF_A_STRUCTURE
    rows = judged(model, [topic for topic in model.topics if topic not in left_out])
    assert rows
    assert all(row.ok for row in rows), "\n".join(str(row) for row in rows if not row.ok)


def judged(model: Model, topics: list[str]) -> list[Row]:
    """All the C of a machine compiled, that of some topics tried."""
    items = [item for topic in topics for item in model.topics[topic]]
    accuracies = {item.function.name: Accuracy() for item in model.items()}
    # those of a structure are judged by the condition of each problem, whatever a header says
    stated = [x for topic in topics if topic not in OF_A_STRUCTURE for x in model.topics[topic]]
    accuracies |= accuracy_cache.measured_accuracy(model.machine, stated)
    folder = folder_of(model.machine, render(model, accuracies))
    return [
        row
        for precision in REALS
        for row in tried(
            Trial(Generated(model.machine, folder, precision), model, accuracies, POINTS, seed=5),
            {item.function.name for item in items},
        )
    ]


def tried(trial: Trial, names: set[str]) -> list[Row]:
    """What is found for some functions, second names included."""
    chosen = [name for name in trial.generated.functions if trial.aliases.get(name, name) in names]
    return [row for name in chosen for row in trial.rows(name)]


def test_verify_covers_every_function_in_both_precisions(stock_file: Path) -> None:
    heard: list[tuple[str, int, int]] = []
    report = verify(stock_file, points=100, progress=lambda *told: heard.append(told))
    functions = {row.function for row in report.rows}
    assert {row.precision for row in report.rows} == {"double", "float"}
    assert {name for name, _, _ in heard} == functions
    assert [done for _, done, _ in heard] == list(range(heard[0][2]))
    assert report.to_json()["passed"] == report.passed


def test_points_in_blocks_on_all_cores_are_all_judged(
    stock_file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = verify(stock_file, points=100)
    monkeypatch.setattr(turnbuckle.codegen.verify, "BLOCK", 40)
    parts = verify(stock_file, points=100)
    assert parts.passed
    for one, several in zip(whole.rows, parts.rows, strict=True):
        assert (one.function, one.output, one.precision) == (
            several.function,
            several.output,
            several.precision,
        )
        refused = "(refused)" in one.output or one.function == "observe_disturbance"
        assert refused or one.points == several.points
