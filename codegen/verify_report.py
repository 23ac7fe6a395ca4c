"""A report of the verification for a reader: a table, sentences, JSON."""

import json
import math
from typing import Any

from rich.table import Table
from rich.text import Text

from turnbuckle.codegen.verify import Report, Row

# Errors larger than these are shown as larger.
LARGEST_SHARE, LARGEST_ULP = 9.99, 1e5


def json_text(report: Report) -> str:
    """The whole report as JSON."""
    return json.dumps(_finite(report.to_json()), indent=2)


def _finite(content: Any) -> Any:
    """Plain data as JSON can hold it: null in place of infinities and NaN."""
    if isinstance(content, dict):
        return {key: _finite(value) for key, value in content.items()}
    if isinstance(content, list):
        return [_finite(value) for value in content]
    return None if isinstance(content, float) and not math.isfinite(content) else content


def table(report: Report) -> Table:
    """A line for every result: worst errors in each precision, and their share of the allowed."""
    precisions = list(dict.fromkeys(row.precision for row in report.rows))
    shown = Table(box=None, padding=(0, 1, 0, 0), title=f"{report.machine}: worst errors, SI units")
    shown.add_column("function", overflow="fold")
    shown.add_column("output", overflow="fold")
    for heading in [h for precision in precisions for h in (precision, "ulp")] + ["share"]:
        shown.add_column(heading, justify="right", no_wrap=True)
    for (function, output), rows in _results(report).items():
        cells = [cell for name in precisions for cell in _errors(rows.get(name))]
        worst = max(row.share for row in rows.values())
        share = f"{worst:.0%}" if worst <= LARGEST_SHARE else f">{LARGEST_SHARE:.0%}"
        style = "" if all(row.ok for row in rows.values()) else "bold red"
        shown.add_row(Text(function), Text(output), *cells, share, style=style)
    shown.caption = "share: the worst error's part of what is allowed at its point"
    return shown


def _results(report: Report) -> dict[tuple[str, str], dict[str, Row]]:
    """Rows by function and output, then by precision; without what was refused as it should be."""
    results: dict[tuple[str, str], dict[str, Row]] = {}
    for row in report.rows:
        if not row.ok or not row.output.endswith(" (refused)"):
            results.setdefault((row.function, row.output), {})[row.precision] = row
    return results


def _errors(row: Row | None) -> tuple[str, str]:
    """Worst absolute error, and worst in units in the last place (useless near a result of 0)."""
    if row is None:
        return "", ""
    ulp = f"{row.worst_ulp:.3g}" if row.worst_ulp < 999.5 else f"{row.worst_ulp:.0f}"
    return (
        f"{row.worst_absolute:.1e}",
        ulp if row.worst_ulp < LARGEST_ULP else f">{LARGEST_ULP:.0e}".replace("e+0", "e"),
    )


def failure(row: Row) -> str:
    """What is wrong with one result."""
    reasons = []
    if not row.share <= 1:
        reasons.append(f"error {row.worst_absolute:.2e}, {row.share:.3g} times what is allowed")
    if row.disagreements:
        reasons.append(f"{row.disagreements} wrong answers ({row.first_disagreement})")
    return f"FAILED {row.function}, {row.output}, {row.precision}: {'; '.join(reasons)}"


def verdict(report: Report) -> str:
    """Whether the C is what the reference computes, and at how many points it was asked."""
    agrees = "agrees with" if report.passed else "DIFFERS FROM"
    points = sum(row.points for row in report.rows)
    return (
        f"{report.machine}, machine hash {report.hash}: the C {agrees} the reference;"
        f" {len(report.rows)} comparisons at {points} points in all"
    )
