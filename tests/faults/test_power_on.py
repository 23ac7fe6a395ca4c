"""What is wrong with an encoder or a motor from power-on on is found in HOME, or does no harm."""

import os

import pytest
from catalogue import FAULTS, Fault
from forked import in_a_fork
from journey import Journey, moment_of
from trial import Outcome, Trial
from verdict import CAUSES, motion

from lab.lockstep import Lockstep, Request

READY = moment_of("CONFIGURE READY")
HOMED = 11_000
"""Cycles from a request to arm until the machine has been in RUN for a while."""

TOLD = {
    "cable_2: encoder stands": {"CALIBRATION"},
    "cable_2: encoder reversed": {"CALIBRATION", "WRONG_WAY"},
    "cable_2: encoder counts half": {"CALIBRATION"},
    "cable_2: encoder counts double": {"CALIBRATION"},
    "cable_2: encoder slips": {"CALIBRATION"},
    "cable_2: encoder slips back": {"CALIBRATION"},
    "cable_2: motor gives no torque": {"CALIBRATION"},
    "cable_2: motor gives twice its torque": set(),
    "cable_2: motor gives its torque reversed": {"CABLE_SLACK", "WRONG_WAY", "CALIBRATION"},
    "base_2: encoder stands": {"BASE_BLOCKED"},
    "base_2: encoder reversed": {"WRONG_WAY"},
    "base_2: encoder counts half": {"CALIBRATION", "BASE_BLOCKED"},
    "base_2: encoder counts double": {"CALIBRATION"},
    "base_2: encoder slips": {"CALIBRATION"},
    "base_2: encoder slips back": {"CALIBRATION"},
    "base_2: motor gives no torque": {"BASE_BLOCKED"},
    "base_2: motor gives twice its torque": set(),
    "base_2: motor gives its torque reversed": {"WRONG_WAY"},
}
"""Causes that may be told of a fault; none: the machine works."""
FOR_ALL = ("cable_2: encoder stands", "base_2: encoder slips")
LATE = {"CALIBRATION"}
"""Known when HOME ends, after ten thousand cycles: `make campaign` waits for all of these."""
WRONG = [
    fault
    for fault in FAULTS
    if fault.name in TOLD
    and (os.environ.get("EVERY_MOMENT") or TOLD[fault.name] != LATE or fault.name in FOR_ALL)
]


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
