"""The campaign as a table for people: a line a fault, a column a moment."""

import json
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path

from catalogue import FAULTS
from journey import NAMES
from trial import Outcome
from verdict import ASTRAY, CAUSES, MARGIN, STRONG, TENSION_MAX

from codegen.bind import keep_text

BUILD = Path(__file__).parents[2] / "build"
RESULTS = BUILD / "fault_campaign"
"""One file a moment."""
TABLE = BUILD / "fault_campaign.md"
REACTIONS = {"SOFT_STOP": "soft", "HARD_STOP": "hard", "FAULT": "refuse"}
NO_FAULT = ("NONE", "REQUESTED")

Outcomes = Mapping[str, Outcome]
"""Of a moment, by the faults' names."""


def keep(moment: str, outcomes: Outcomes) -> None:
    """Keep what was found at a moment, and write the table of all that is known."""
    found = {name: asdict(outcome) for name, outcome in outcomes.items()}
    keep_text(RESULTS / f"{moment}.json", json.dumps(found))
    keep_text(TABLE, table(kept()))


def kept() -> dict[str, Outcomes]:
    """What was found at the moments that were tried."""
    found: dict[str, Outcomes] = {}
    for moment in NAMES:
        path = RESULTS / f"{moment}.json"
        if path.exists():
            values = json.loads(path.read_text())
            found[moment] = {name: Outcome(**each) for name, each in values.items()}
    return found


def table(campaign: Mapping[str, Outcomes]) -> str:
    """The document."""
    lines = [*head(campaign), "", f"| fault | {' | '.join(campaign)} |"]
    lines.append("|---" * (1 + len(campaign)) + "|")
    for fault in FAULTS:
        cells = [cell(outcomes[fault.name]) for outcomes in campaign.values()]
        lines.append(f"| {fault.name} | {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def head(campaign: Mapping[str, Outcomes]) -> list[str]:
    """What was done and found, in short."""
    pairs = [each for outcomes in campaign.values() for each in outcomes.values()]
    reacted = sum(each.reacted is not None for each in pairs)
    weak = {fault.name for fault in FAULTS if not fault.strong}
    pulled = [o.highest for all_ in campaign.values() for name, o in all_.items() if name in weak]
    return [
        "<!-- Written by make campaign. -->",
        "# Fault campaign",
        "",
        f"**{len(pairs)} pairs** of a fault ({len(FAULTS)}) and a moment ({len(campaign)}) of the",
        f"stock machine, each in lockstep with simulated drives; {reacted} lead to a reaction,",
        "the others must change nothing. `make campaign` runs them all, `make test` every fault at",
        "one moment of each state. Each is judged by [safety.md](safety.md): cause, culprit,",
        "reaction and cycles; the first cause stands; a standing request to arm does nothing;",
        "no setpoint beyond its limits or rate is on the wire; in the end no drive has torque, by",
        "the drive's own state.",
        "",
        f"Largest tension: {max(pulled):.1f} N, of {TENSION_MAX:.0f} N and {MARGIN:.0f} N for",
        f"inertia; {max(each.highest for each in pairs):.1f} N of {STRONG:.0f} N where a flipped",
        "setpoint, a hook or a base that does not see where it is pulls. Furthest that the handle",
        f"got from where the hand wants it: {1e3 * max(each.astray for each in pairs):.0f} mm",
        f"of {1e3 * ASTRAY:.0f} mm.",
        "",
        "`DRIVE_SILENT hard 3, 6`: that cause, a hard stop in cycle 3 after the strike, no torque",
        "in any drive from cycle 6 on. `-`: the machine goes on, or stays in the stop that it was",
        'in. A fault stands unless its name says "once".',
    ]


def cell(outcome: Outcome) -> str:
    """An outcome in a few words."""
    if outcome.reacted is None:
        return "-"
    cause = next(CAUSES[each] for each in outcome.causes if CAUSES[each] not in NO_FAULT)
    stops = [REACTIONS[each] for each in outcome.states if each in REACTIONS]
    return f"{cause} {stops[0]} {outcome.reacted}, {outcome.quiet}"
