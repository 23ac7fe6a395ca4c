"""Every fault in every state of the supervisor, judged by docs/safety.md."""

import os
from math import ceil

import pytest
from catalogue import FAULTS, Fault
from forked import in_a_fork
from journey import ALSO_IN_ITS_STATE, MOMENTS, NAMES, Bench, Journey, Moment
from safety_table import DOCUMENT
from table import keep
from trial import Outcome, Trial
from verdict import complaints, expected

from turnbuckle.lab.lockstep import Request, State

WHOLE = "WHOLE_CAMPAIGN" in os.environ
"""`make campaign`: every fault at every moment; else half of them at one moment of each state."""
TRIED = [moment for moment in MOMENTS if WHOLE or moment.name not in ALSO_IN_ITS_STATE]
COMMITTED = DOCUMENT.with_name("fault-campaign.md")


def tried(bench: Bench, fault: Fault, moment: Moment) -> Outcome:
    """What a fault leads to at a moment, in a fork."""
    wanted = expected(fault, moment)
    return in_a_fork(lambda: Trial(bench, (0, fault)).run(wanted.horizon, wanted.until_ready))


@pytest.mark.parametrize("moment", TRIED, ids=lambda moment: moment.name)
def test_every_fault_leads_where_the_document_says(journey: Journey, moment: Moment) -> None:
    bench, faults = journey.at(moment), FAULTS if WHOLE else FAULTS[TRIED.index(moment) % 2 :: 2]
    outcomes = {fault.name: tried(bench, fault, moment) for fault in faults}
    if WHOLE:
        keep(moment.name, outcomes)
    wrong = {
        fault.name: found
        for fault in faults
        if (found := complaints(expected(fault, moment), outcomes[fault.name]))
    }
    assert wrong == {}


def test_the_committed_table_is_of_these_faults_and_moments() -> None:
    lines = COMMITTED.read_text().splitlines()
    first = next(number for number, line in enumerate(lines) if line.startswith("| fault |"))
    rows = [line.strip("| ").split(" | ") for line in lines[first:] if line.startswith("| ")]
    assert rows[0][1:] == list(NAMES)
    assert [row[0] for row in rows[1:]] == [fault.name for fault in FAULTS]
    assert any(f"**{len(FAULTS) * len(MOMENTS)} runs**" in line for line in lines)


CLEARED = [
    fault
    for fault in FAULTS
    if fault.name.startswith("cable_2: error")
    or fault.name.endswith(("flipped once, high", "switches it off once", "(SIGSTOP)"))
    or fault.name.endswith(("interrupted", "a turn", "pre-operational", "3 cycles left out"))
]
AGAIN = ("cable_2: error 2310, overcurrent", "base_2: supply interrupted", "(SIGSTOP)")
"""From these the machine is brought to RUN, from the others to where it can be armed."""


@pytest.mark.parametrize(
    "fault", [f for f in CLEARED if f.name.endswith(AGAIN)], ids=lambda f: f.name
)
def test_after_a_reset_the_machine_runs_again(journey: Journey, fault: Fault) -> None:
    bench = journey.at(RUN)
    assert in_a_fork(lambda: reset(bench, fault, armed=True)) is State.RUN


def test_a_reset_clears_every_fault_that_has_gone(journey: Journey) -> None:
    bench = journey.at(RUN)
    stuck = [
        fault.name
        for fault in CLEARED
        if in_a_fork(lambda fault=fault: reset(bench, fault, armed=False)) is not State.CONFIGURE  # type: ignore[misc]
    ]
    assert stuck == []


RUN = MOMENTS[NAMES.index("RUN")]


def reset(bench: Bench, fault: Fault, armed: bool) -> State:
    """The state after a fault, a reset and, if asked for, a request to arm."""
    wanted, lockstep = expected(fault, RUN), bench.lockstep
    outcome = Trial(bench, (0, fault)).run(wanted.horizon, wanted.until_ready)
    if outcome.reacted is None:  # a warning
        return State.CONFIGURE
    lockstep.requests = Request.RESET
    lockstep.run(2)
    lockstep.requests = Request(0)
    lockstep.run(700)
    if not armed or bench.state is not State.CONFIGURE:
        return bench.state
    let_the_hand_rest(bench)
    lockstep.requests = Request.ARM
    return lockstep.run_until([State.RUN, State.FAULT], 15_000)


def let_the_hand_rest(bench: Bench) -> None:
    """Wait until it has done all its task: a hand that moves fast keeps cables from being tight."""
    simulated = bench.lockstep.machine
    assert simulated.task is not None
    bench.lockstep.run(ceil(simulated.task.path.end / simulated.period))
