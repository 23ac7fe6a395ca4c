"""A machine's findings as a folder: maps, numbers as JSON, a report in Markdown."""

import json
from collections.abc import Sequence
from math import isfinite
from typing import Any

from turnbuckle.lab.analysis.figures import Findings, figures
from turnbuckle.lab.analysis.plots import Quantity
from turnbuckle.model.workspace.words import (
    coverage_in_words,
    demand_in_words,
    motors_in_words,
    pose_in_words,
)

MANIFEST = "analysis.json"
REPORT = "report.md"
FIRST = 3  # maps before the numbers


def verdict(findings: Findings) -> str:
    """Whether to cut metal, in a few sentences."""
    machine, target, capable = findings.machine, findings.target, findings.extent.capable
    answer = "Yes" if target.passed else "No"
    parts = [
        f"{answer}: {coverage_in_words(machine, target.coverage)}",
        motors_in_words(machine, target.actuators),
    ]
    if capable is not None:
        parts.append(str(capable))
    return "\n".join(part[0].upper() + part[1:] + "." for part in parts)


def rows(findings: Findings) -> list[tuple[str, str]]:
    """The numbers as words: label and value."""
    machine, coverage = findings.machine, findings.target.coverage
    shown = [(figure.words, figure.shown(findings)) for figure in figures(machine)]
    return [
        *shown,
        ("worst pose", pose_in_words(machine, coverage.worst)),
        ("possible there", demand_in_words(machine, coverage.possible)),
    ]


def as_json(findings: Findings, files: Sequence[str]) -> str:
    """All numbers, SI units; null where there is no number, or none that is finite."""
    machine, target, extent = findings.machine, findings.target, findings.extent
    content = {
        "machine": machine.name,
        "kind": machine.kind,
        "passed": target.passed,
        "wanted": {
            "force": machine.target.force,
            "moment": machine.target.moment,
            "rotation": machine.target.rotation,
        },
        "grid": list(target.coverage.counts),
        "poses_on_pulleys": target.coverage.undefined,
        "numbers": {f.key: or_null(f.value(findings)) for f in figures(machine)},
        "worst_pose": list(target.coverage.worst),
        "possible_at_worst_pose": or_null(target.coverage.possible),
        "circle": _inscribed(extent.circle),
        "screen": _inscribed(extent.screen),
        "tension_capable": None
        if extent.capable is None
        else {
            "ratio": extent.capable.ratio,
            "area": extent.capable.area,
            "share": extent.capable.share,
            "best_ratio": extent.capable.best_ratio,
        },
        "lag": target.lagging.lag if target.lagging else None,
        "files": list(files),
    }
    return json.dumps(content, indent=2) + "\n"


def as_markdown(findings: Findings, maps: Sequence[Quantity]) -> str:
    """The report, the most useful maps first."""
    machine = findings.machine
    lines = [f"# {machine.name}", "", f"{machine.kind}, {machine.source}.", ""]
    answer, _, rest = verdict(findings).partition(":")
    lines += [f"**{answer}**:{rest}", ""]
    lines += [line for quantity in maps[:FIRST] for line in _picture(quantity)]
    lines += table(["", machine.name], [list(row) for row in rows(findings)])
    lines += ["", *(line for quantity in maps[FIRST:] for line in _picture(quantity))]
    return "\n".join([*lines, *_method(findings)]) + "\n"


def table(header: Sequence[str], cells: Sequence[Sequence[str]]) -> list[str]:
    """The lines of a table in Markdown."""
    rule = ["---"] + ["--:"] * (len(header) - 1)
    return [f"| {' | '.join(row)} |" for row in [header, rule, *cells]]


def _picture(quantity: Quantity) -> list[str]:
    return [f"![{quantity.title}]({quantity.name}.png)", ""]


def _method(findings: Findings) -> list[str]:
    target = findings.target
    grid = " x ".join(map(str, target.coverage.counts))
    lines = [
        "## How this was found",
        "",
        f"Shares, least and mean values are over {grid} poses that span the target, its border and"
        " corners included; between them nothing was looked at. A pose counts as served when the"
        " facets of the set of wrenches say that every wanted force, together with every wanted"
        " moment, is feasible within the tension bounds. The isotropic force comes without a"
        " moment. Cables are straight and without mass.",
    ]
    if findings.machine.target.rotation:
        lines += [
            "",
            "The platform is turned by every combination of angles about its axes, each from minus"
            " to plus the wanted rotation.",
        ]
    if target.lagging:
        lines += [
            "",
            "Bases are at the targets that the controller gives them; late ones are where they"
            f" belong for a hand {target.lagging.lag * 1e3:g} mm away, in whichever direction is"
            " worst, the platform upright.",
        ]
    return lines


def _inscribed(shape: Any) -> dict[str, Any] | None:
    if shape is None:
        return None
    return {"centre": list(shape.centre), "half_size": list(shape.half_size)}


def or_null(value: float) -> float | None:
    """A number as JSON can hold it: null for NaN and infinities."""
    return value if isfinite(value) else None
