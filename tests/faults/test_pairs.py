"""Two faults, at once or one after the other, whenever: the machine is judged by what it does.

One run again: PAIR=1234 .venv/bin/python -m pytest tests/faults/test_pairs.py
"""

import os
from collections.abc import Iterator

import pytest
from journey import MOMENTS, Journey, Moment
from pair_verdict import complaints
from pairs import Pair, outcomes, pair
from safety_table import DOCUMENT
from table import keep_pairs

SEEDS = range(2000)
ONE = os.environ.get("PAIR")
TRIED = SEEDS if os.environ.get("WHOLE_CAMPAIGN") else SEEDS[::4]
"""`make campaign` tries all."""
TOGETHER = 120
"""Runs of one test, at most."""
COMMITTED = DOCUMENT.with_name("fault-campaign.md")


def parts() -> Iterator[tuple[str, list[Pair]]]:
    """Pairs of one moment each, and what they are called."""
    pairs = [pair(seed) for seed in ([int(ONE)] if ONE else TRIED)]
    for moment in MOMENTS:
        there = [each for each in pairs if each.moment is moment]
        for begin in range(0, len(there), TOGETHER):
            yield f"{moment.name} from {begin}", there[begin : begin + TOGETHER]


PARTS = dict(parts())


@pytest.mark.parametrize("part", PARTS)
def test_two_faults_leave_the_machine_within_its_bounds(journey: Journey, part: str) -> None:
    pairs = PARTS[part]
    moment: Moment = pairs[0].moment
    found = outcomes(journey.at(moment), pairs)
    if TRIED is SEEDS and not ONE:
        keep_pairs(part, {each.seed: outcome for each, outcome in found})
    wrong = {str(each): what for each, outcome in found if (what := complaints(each, outcome))}
    assert wrong == {}


def test_the_committed_document_is_of_so_many_pairs() -> None:
    assert f"**{len(SEEDS)} pairs of faults**" in COMMITTED.read_text()
