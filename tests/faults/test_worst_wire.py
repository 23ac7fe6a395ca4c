"""The same on a wire at the worst that its proof allows: long, late and foreign frames."""

from random import Random

import pytest
from catalogue import FAULTS, Fault
from forked import in_a_fork
from journey import NAMES, Bench, Journey, Moment, moment_of, stock
from pair_verdict import complaints as complaints_of_pair
from pairs import outcomes, pair
from trial import Outcome, Trial
from verdict import complaints, expected

from turnbuckle.lab.drives.wire import Conditions

TRIED = [moment_of(name) for name in ("HOME SWEEP", "TENSION", "RUN")]
FAULTS_EACH, PAIRS_EACH = 25, 15
#: The answers to twice as many SYNCs do not fit on a cable bus at its worst: drives are late there.
CROWDING = {"bus cable1: SYNC doubled always", "bus cable2: SYNC doubled always"}


@pytest.fixture(scope="module")
def worst_journey() -> Journey:
    """The stock machine on such a wire."""
    return Journey(stock(), Conditions(worst=True))


def tried(bench: Bench, fault: Fault, moment: Moment) -> Outcome:
    """What a fault leads to at a moment, in a fork."""
    wanted = expected(fault, moment)
    return in_a_fork(lambda: Trial(bench, (0, fault)).run(wanted.horizon, wanted.until_ready))


@pytest.mark.parametrize("moment", TRIED, ids=lambda moment: moment.name)
def test_faults_lead_to_the_same_on_the_worst_wire(worst_journey: Journey, moment: Moment) -> None:
    bench = worst_journey.at(moment)
    faults = Random(NAMES.index(moment.name)).sample(FAULTS, FAULTS_EACH)
    wrong = {
        fault.name: found
        for fault in faults
        if fault.name not in CROWDING
        and (found := complaints(expected(fault, moment), tried(bench, fault, moment)))
    }
    pairs = [each for each in map(pair, range(2000)) if each.moment is moment][:PAIRS_EACH]
    for each, outcome in outcomes(bench, pairs):
        if found := complaints_of_pair(each, outcome):
            wrong[str(each)] = found
    assert wrong == {}
