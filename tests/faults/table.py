"""The campaign as a table for people: a line a fault, a column a moment."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path

from catalogue import FAULTS
from journey import NAMES
from pairs import LATER, pair
from trial import Outcome
from verdict import BOUNDS, CAUSES

from codegen.bind import keep_text

BUILD = Path(__file__).parents[2] / "build"
RESULTS = BUILD / "fault_campaign"
"""One file a moment."""
PAIRS = RESULTS / "pairs"
TABLE = BUILD / "fault_campaign.md"
REACTIONS = {"SOFT_STOP": "soft", "HARD_STOP": "hard", "FAULT": "refuse"}
NO_FAULT = ("NONE", "REQUESTED")

Outcomes = Mapping[str, Outcome]
"""Of a moment, by the faults' names."""
Pairs = Mapping[int, Outcome]
"""By their seeds."""


def keep(moment: str, outcomes: Outcomes) -> None:
    """Keep what was found at a moment, and write the table of all that is known."""
    found = {name: asdict(outcome) for name, outcome in outcomes.items()}
    keep_text(RESULTS / f"{moment}.json", json.dumps(found))
    keep_text(TABLE, table(kept(), kept_pairs()))


def keep_pairs(part: str, outcomes: Pairs) -> None:
    """Keep what came of a part of the pairs of faults, and write the document again."""
    found = {seed: asdict(outcome) for seed, outcome in outcomes.items()}
    keep_text(PAIRS / f"{part}.json", json.dumps(found))
    keep_text(TABLE, table(kept(), kept_pairs()))


def kept_pairs() -> dict[int, Outcome]:
    """What came of the pairs of faults that were tried."""
    parts = [json.loads(path.read_text()) for path in sorted(PAIRS.glob("*.json"))]
    return {int(seed): Outcome(**each) for part in parts for seed, each in part.items()}


def kept() -> dict[str, Outcomes]:
    """What was found at the moments that were tried."""
    found: dict[str, Outcomes] = {}
    for moment in NAMES:
        path = RESULTS / f"{moment}.json"
        if path.exists():
            values = json.loads(path.read_text())
            found[moment] = {name: Outcome(**each) for name, each in values.items()}
    return found


def table(campaign: Mapping[str, Outcomes], pairs: Pairs) -> str:
    """The document."""
    lines = [*head(campaign, pairs), "", *summary(campaign, pairs), "", *LEGEND, ""]
    lines.append(f"| fault | {' | '.join(campaign)} |")
    lines.append("|---" * (1 + len(campaign)) + "|")
    for fault in FAULTS:
        cells = [cell(outcomes[fault.name]) for outcomes in campaign.values()]
        lines.append(f"| {fault.name} | {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def head(campaign: Mapping[str, Outcomes], pairs: Pairs) -> list[str]:
    """What was done."""
    runs = len(FAULTS) * len(campaign)
    return [
        "<!-- Written by make campaign. -->",
        "# Fault campaign",
        "",
        f"**{runs} runs** of a fault ({len(FAULTS)}) at a moment ({len(campaign)}) of the stock",
        "machine, each in lockstep with simulated drives on wires on which frames take their time.",
        "`make campaign` runs them all, `make test` every fault at one moment of each state. Each",
        "is judged by [safety.md](safety.md): cause, culprit, reaction and cycles; the first cause",
        "stands; a standing request to arm does nothing; no setpoint beyond its limits or rate is",
        "on the wire; in the end no drive has torque, by the drive's own state; cables, carriages",
        "and handle stay within their bounds.",
        "",
        f"**{len(pairs)} pairs of faults** strike at random moments, at once or up to {LATER}",
        "cycles one after the other; `make test` runs them all. They are judged by what drives,",
        "cables, carriages and handle do: whichever of two faults is told, everything is off in",
        "time and stays within its bounds, and the first cause stands. `FOREIGN`: something else",
        "than the controller pulls or leads.",
    ]


MEASURES = (
    ("largest tension [N]", "highest", 1.0, "TENSION"),
    ("handle from where the hand wants it [mm]", "astray", 1e3, "HANDLE"),
    ("fastest handle [m/s]", "handle", 1.0, "HANDLE_SPEED"),
    ("fastest carriage [m/s]", "carriage", 1.0, "CARRIAGE_SPEED"),
    ("carriage off its track [mm]", "off_track", 1e3, "OFF_TRACK"),
    ("carriage goes on in a stop [mm]", "rolled", 1e3, "ROLLED"),
)
"""Words, name in Outcome, scale from SI, bound of safety.md."""


def summary(campaign: Mapping[str, Outcomes], pairs: Pairs) -> list[str]:
    """What was found, of single faults and of pairs, in short."""
    foreign = {fault.name for fault in FAULTS if fault.strong}
    groups: list[list[Outcome]] = [[], [], [], []]
    for outcomes in campaign.values():
        for name, outcome in outcomes.items():
            groups[2 * (name in foreign)].append(outcome)
    for seed, outcome in pairs.items():
        groups[2 * pair(seed).is_foreign + 1].append(outcome)
    lines = [
        "| | faults | pairs | at most | faults, FOREIGN | pairs, FOREIGN | at most |",
        "|---|---|---|---|---|---|---|",
        line("runs", [str(len(group)) for group in groups], ["", ""]),
        line("with a reaction", [reactions(group) for group in groups], ["", ""]),
    ]
    for words, name, scale, bound in MEASURES:
        most = [max((getattr(each, name) for each in group), default=0.0) for group in groups]
        allowed = [BOUNDS[bound], BOUNDS.get(f"{bound}_FOREIGN", BOUNDS[bound])]
        lines.append(
            line(
                words,
                [f"{scale * each:.3g}" for each in most],
                [f"{scale * each:.3g}" for each in allowed],
            )
        )
    return lines


def line(words: str, values: Sequence[str], bounds: Sequence[str]) -> str:
    """A line of the summary: values of four groups, bounds of two."""
    cells = [words, *values[:2], bounds[0], *values[2:], bounds[1]]
    return f"| {' | '.join(cells)} |"


def reactions(outcomes: Sequence[Outcome]) -> str:
    """How many led to one."""
    return str(sum(each.reacted is not None for each in outcomes))


LEGEND = (
    "`DRIVE_SILENT hard 3, 6`: that cause, a hard stop in cycle 3 after the strike, no torque",
    "in any drive from cycle 6 on. `-`: the machine goes on, or stays in the stop that it was",
    'in. A fault stands unless its name says "once".',
)


def cell(outcome: Outcome) -> str:
    """An outcome in a few words."""
    if outcome.reacted is None:
        return "-"
    cause = next(CAUSES[each] for each in outcome.causes if CAUSES[each] not in NO_FAULT)
    stops = [REACTIONS[each] for each in outcome.states if each in REACTIONS]
    return f"{cause} {stops[0]} {outcome.reacted}, {outcome.quiet}"
