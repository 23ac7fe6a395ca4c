"""The campaign as a table for people: a line a fault, a column a moment."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path

from catalogue import FAULTS, Fault
from journey import NAMES
from pairs import LATER, pair
from trial import Outcome
from verdict import BOUNDS, CAUSES, measured

from turnbuckle.model.files import write_whole

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
Run = tuple[Outcome, Sequence[Fault]]
"""What came of some faults."""


def keep(moment: str, outcomes: Outcomes) -> None:
    """Keep what was found at a moment, and write the table of all that is known."""
    found = {name: asdict(outcome) for name, outcome in outcomes.items()}
    write_whole(RESULTS / f"{moment}.json", json.dumps(found))
    write_whole(TABLE, table(kept(), kept_pairs()))


def keep_pairs(part: str, outcomes: Pairs) -> None:
    """Keep what came of a part of the pairs of faults, and write the document again."""
    found = {seed: asdict(outcome) for seed, outcome in outcomes.items()}
    write_whole(PAIRS / f"{part}.json", json.dumps(found))
    write_whole(TABLE, table(kept(), kept_pairs()))


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
        "time and stays within its bounds, and the first cause stands. What was reached, by the",
        "names that safety.md has for its bounds (N, m, m/s):",
    ]


def summary(campaign: Mapping[str, Outcomes], pairs: Pairs) -> list[str]:
    """What was reached of every bound, by single faults and by pairs."""
    by_name = {fault.name: fault for fault in FAULTS}
    single = [
        (outcome, (by_name[name],))
        for outcomes in campaign.values()
        for name, outcome in outcomes.items()
    ]
    twice = [(outcome, pair(seed).faults) for seed, outcome in pairs.items()]
    lines = ["| | a fault | a pair | at most |", "|---|---|---|---|"]
    lines.append(f"| runs | {len(single)} | {len(twice)} | |")
    lines.append(f"| with a reaction | {reactions(single)} | {reactions(twice)} | |")
    reached = most(single), most(twice)
    for name, bound in BOUNDS.items():
        cells = [f"{each.get(name, 0.0):.3g}" for each in reached]
        lines.append(f"| {name} | {' | '.join(cells)} | {bound:.3g} |")
    return lines


def reactions(runs: Sequence[Run]) -> int:
    """How many led to one."""
    return sum(outcome.reacted is not None for outcome, _ in runs)


def most(runs: Sequence[Run]) -> dict[str, float]:
    """The largest that was reached of every bound."""
    found: dict[str, float] = {}
    for outcome, faults in runs:
        for name, value in measured(outcome, faults).items():
            found[name] = max(found.get(name, 0.0), value)
    return found


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
