"""What is wrong with an encoder or a motor from power-on on is found in HOME, or does no harm."""

import os

import pytest
from catalogue import FAULTS, Fault
from forked import in_a_fork
from journey import Journey, moment_of
from trial import Outcome, Trial
from verdict import CAUSES, motion

from turnbuckle.lab.lockstep import Lockstep, Request

READY = moment_of("CONFIGURE READY")
HOMED = 11_000
"""Cycles from a request to arm until the machine has been in RUN for a while."""

SOON = {
    "cable_2: encoder reversed": {"WRONG_WAY"},
    "cable_2: motor gives its torque reversed": {"WRONG_WAY", "CABLE_SLACK"},
    "base_2: encoder stands": {"BASE_BLOCKED"},
    "base_2: encoder reversed": {"WRONG_WAY"},
    "base_2: motor gives no torque": {"BASE_BLOCKED"},
    "base_2: motor gives its torque reversed": {"WRONG_WAY"},
}
"""Causes that may be told, by the trial of directions or before it."""
LATE: dict[str, set[str]] = {
    "cable_2: encoder stands": {"CALIBRATION"},
    "cable_2: motor gives twice its torque": set(),
    "base_2: encoder slips": {"CALIBRATION", "BASE_BLOCKED"},
    "cable_2: encoder counts half": {"CALIBRATION"},
    "cable_2: encoder counts double": {"CALIBRATION"},
    "cable_2: encoder slips": {"CALIBRATION"},
    "cable_2: encoder slips back": {"CALIBRATION"},
    "cable_2: motor gives no torque": {"CALIBRATION"},
    "base_2: encoder counts half": {"CALIBRATION", "BASE_BLOCKED"},
    "base_2: encoder counts double": {"CALIBRATION"},
    "base_2: motor gives twice its torque": set(),
}
"""The same by the end of HOME, ten thousand cycles later; none: the machine works."""
OF_LATE = len(LATE) if os.environ.get("WHOLE_CAMPAIGN") else 3
"""How many of these are waited for."""
TOLD = {**SOON, **dict(list(LATE.items())[:OF_LATE])}
WRONG = [fault for fault in FAULTS if fault.name in TOLD]


def arm(lockstep: Lockstep) -> None:
    """Ask for HOME."""
    lockstep.requests = Request.ARM


ARMED = Fault("the machine is armed", strike=arm)


def brought_up(journey: Journey, fault: Fault) -> Outcome:
    """What comes of arming a machine with a fault."""
    bench = journey.at(READY)
    return in_a_fork(lambda: Trial(bench, (0, fault), (1, ARMED)).run(HOMED))


@pytest.mark.parametrize("fault", WRONG, ids=lambda fault: fault.name)
def test_a_machine_with_it_does_not_come_to_work_and_moves_nothing_far(
    journey: Journey, fault: Fault
) -> None:
    outcome = brought_up(journey, fault)
    told = {CAUSES[cause] for cause in outcome.causes} - {"NONE"}
    allowed = TOLD[fault.name]
    assert len(told) == (1 if allowed else 0) and told <= (allowed or told)
    assert outcome.states[-1] == ("FAULT" if allowed else "RUN")
    assert motion(outcome, (fault,)) == []
    assert outcome.quiet is not None or not allowed
