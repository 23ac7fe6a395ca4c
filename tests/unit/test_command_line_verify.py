"""`turnbuckle verify`: what it shows of a report, and with which exit status."""

import json
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

import turnbuckle.codegen.verify
from turnbuckle.codegen.verify import POINTS, Report, Row
from turnbuckle.command_line import app

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
FINE = {
    precision: Row("cable_lengths", "length", precision, 100, error, 1.5, 2 * error, 0.5, 0)
    for precision, error in (("double", 1e-16), ("float", 1e-7))
}
REFUSED = Row("cable_lengths", "length (refused)", "double", 64, 0.0, 0.0, 0.0, 0.0, 0)
INACCURATE = Row("wrench", "wrench", "double", 100, float("inf"), float("nan"), 1e-9, 2e9, 0)
WRONG_STATUS = Row("wrench", "wrench", "double", 100, 0.0, 0.0, 1e-9, 0.0, 3, "point 7: OK")
NAN_SHARE = Row("wrench", "wrench", "double", 100, 0.0, 0.0, 1e-9, float("nan"), 0)


def run(
    monkeypatch: pytest.MonkeyPatch, rows: list[Row], *arguments: str
) -> tuple[Result, dict[str, Any]]:
    """Run the command on a report with these rows; what verification was asked for."""
    asked: dict[str, Any] = {}

    def verify(path: Path, points: int, progress: Any, **places: Path | None) -> Report:
        asked.update(path=path, points=points, **places)
        progress("wrench", 0, 2)
        return Report("yoon2023", "0123456789abcdef", 1, rows)

    monkeypatch.setattr(turnbuckle.codegen.verify, "verify", verify)
    return CliRunner().invoke(app, ["verify", str(STOCK), *arguments]), asked


def test_agreement_ends_with_success(monkeypatch: pytest.MonkeyPatch) -> None:
    result, asked = run(monkeypatch, [*FINE.values(), REFUSED])
    assert (result.exit_code, result.stderr) == (0, "")
    assert asked == {"path": STOCK, "points": POINTS, "folder": None, "built": None}
    assert "agrees with the reference" in result.stdout


def test_the_worst_errors_of_both_precisions_are_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    result, _ = run(monkeypatch, [*FINE.values(), REFUSED])
    (line,) = (line for line in result.stdout.splitlines() if line.startswith("cable_lengths"))
    assert line.split() == ["cable_lengths", "length", "1.0e-16", "1.5", "1.0e-07", "1.5", "50%"]


@pytest.mark.parametrize(
    ("row", "words"),
    [
        (INACCURATE, "error inf, 2e+09 times what is allowed"),
        (WRONG_STATUS, "3 wrong answers (point 7: OK)"),
        (NAN_SHARE, "error 0.00e+00, nan times what is allowed"),
    ],
)
def test_a_difference_is_told_and_ends_with_failure(
    monkeypatch: pytest.MonkeyPatch, row: Row, words: str
) -> None:
    result, _ = run(monkeypatch, [*FINE.values(), row])
    assert result.exit_code == 1
    assert f"FAILED wrench, wrench, double: {words}" in result.stdout
    assert result.stderr.count("\n") == 1


def test_a_refused_argument_is_shown_where_it_was_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    taken = Row("wrench", "wrench (refused)", "float", 64, 0.0, 0.0, 0.0, 0.0, 2, "taken")
    result, _ = run(monkeypatch, [*FINE.values(), REFUSED, taken])
    assert result.exit_code == 1
    assert "FAILED wrench, wrench (refused), float: 2 wrong answers (taken)" in result.stdout


def refuse_constant(text: str) -> None:
    """Infinity and NaN are no JSON."""
    raise AssertionError(text)


@pytest.mark.parametrize("rows", [[*FINE.values()], [INACCURATE], [NAN_SHARE]])
def test_the_json_report_is_json_and_nothing_else(
    monkeypatch: pytest.MonkeyPatch, rows: list[Row]
) -> None:
    result, _ = run(monkeypatch, rows, "--json")
    report = json.loads(result.stdout, parse_constant=refuse_constant)
    assert report["passed"] is all(row.ok for row in rows)
    assert result.exit_code == (0 if report["passed"] else 1)
    assert [row["function"] for row in report["rows"]] == [row.function for row in rows]


def test_the_number_of_points_can_be_chosen(monkeypatch: pytest.MonkeyPatch) -> None:
    _, asked = run(monkeypatch, [*FINE.values()], "--points", "7")
    assert asked["points"] == 7


def test_a_narrow_terminal_loses_no_number(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    longest = Row("distribute_tension_closest", "kkt_residual", "double", 1, 1e-16, 1e9, 1, 0.1, 0)
    result, _ = run(monkeypatch, [longest, *FINE.values()])
    assert "distribute_tension_closest kkt_residual 1.0e-16" in result.stdout
    assert max(map(len, result.stdout.splitlines()[:4])) <= 80
