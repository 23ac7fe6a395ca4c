"""The C of machines that are not the stock one agrees with the reference as well."""

from pathlib import Path

import pytest

from codegen import accuracy, accuracy_cache
from codegen.verify import verify

MACHINES = sorted((Path(__file__).parents[1] / "machines").glob("*.toml"))
POINTS = 250


@pytest.mark.parametrize("machine", MACHINES, ids=lambda path: path.stem)
def test_the_c_of_another_machine_agrees_with_the_reference(
    machine: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    # a shorter search finds lower bounds for the headers, if any; they must not be kept
    monkeypatch.setattr(accuracy_cache, "CACHE", tmp_path)
    monkeypatch.setattr(accuracy, "FIRST_POINTS", 1024)
    monkeypatch.setattr(accuracy, "ROUNDS", 0)
    monkeypatch.setattr(accuracy, "MOST_WORK", 4e6)
    report = verify(machine, points=POINTS, seed=5)
    assert report.passed, "\n".join(str(row) for row in report.failures())


def test_verify_covers_every_function_in_both_precisions(stock_file: Path) -> None:
    heard: list[tuple[str, int, int]] = []
    report = verify(stock_file, points=100, progress=lambda *told: heard.append(told))
    functions = {row.function for row in report.rows}
    assert {row.precision for row in report.rows} == {"double", "float"}
    assert {name for name, _, _ in heard} == functions
    assert [done for _, done, _ in heard] == list(range(heard[0][2]))
    assert report.to_json()["passed"] == report.passed
