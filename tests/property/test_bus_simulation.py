"""No frame on a simulated bus is ever later than the response time that is proven for it."""

from math import inf
from random import Random

import pytest
from bus_simulation import longest_responses
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from turnbuckle.model.bus.frames import Pace, messages
from turnbuckle.model.bus.response import Message, frame_bits, response_time, utilisation
from turnbuckle.model.bus.tables import Drive

DURATION = 60_000


@st.composite
def buses(draw: st.DrawFn) -> list[Message]:
    """Any messages that a bus has time for."""
    count = draw(st.integers(2, 7))
    identifiers = draw(st.lists(st.integers(1, 99), min_size=count, max_size=count, unique=True))
    found = []
    for identifier in identifiers:
        size = draw(st.integers(0, 8))
        least = frame_bits(size) * 2
        period = draw(st.integers(least, least * 12))
        jitter = draw(st.sampled_from([0, 0, period // 3, period]))
        found.append(Message(f"m{identifier}", identifier, size, period, period, jitter))
    assume(utilisation(found) < 1)
    return found


def bound(message: Message, among: list[Message]) -> float:
    """Its proven response time, inf where there is none."""
    found = response_time(message, among)
    return inf if found is None else found


@settings(max_examples=60, deadline=None)
@given(buses(), st.integers(0, 2**32))
def test_no_simulated_frame_is_later_than_its_bound(among: list[Message], seed: int) -> None:
    simulated = longest_responses(among, DURATION, Random(seed))
    for message, longest in zip(among, simulated, strict=True):
        assert longest <= bound(message, among)


@pytest.mark.parametrize(("drives", "sync"), [(2, 1e-3), (4, 2e-3)])
def test_no_frame_of_a_real_bus_is_later_than_its_bound(drives: int, sync: float) -> None:
    rows = [{"name": f"d{node}", "bus": "b", "node": node} for node in range(1, drives + 1)]
    on_bus = [Drive.model_validate(row) for row in rows]
    among = messages(on_bus, Pace(1e6, sync, 1e-3, 0.01, 0.02, 0.5, 40e-6, emergency=0.005))
    for seed in range(3):
        simulated = longest_responses(among, 300_000, Random(seed))
        for message, longest in zip(among, simulated, strict=True):
            assert longest <= bound(message, among)


# Davis et al. 2007, section 3.3: three messages of which the least urgent is latest in the second
# frame of a busy period; what the analysis of 1994 says of the first is too little.
DAVIS = [
    Message("A", 1, 7, 312, 312),
    Message("B", 2, 7, 438, 406),
    Message("C", 3, 7, 438, 406),
]


def first_of_a_busy_period(message: Message, among: list[Message]) -> int:
    """The response time of 1994: the first frame only. The seeded defect."""
    above = [other for other in among if other.identifier < message.identifier]
    waited = 0
    while True:
        longer = sum((waited // other.period + 1) * other.bits for other in above)
        if longer == waited:
            return waited + message.bits
        waited = longer


def test_the_simulation_catches_the_analysis_that_was_refuted() -> None:
    least_urgent = DAVIS[2]
    simulated = longest_responses(DAVIS, 2000, Random(0), phases=[0, 0, 0])[2]
    assert first_of_a_busy_period(least_urgent, DAVIS) < simulated
    assert simulated <= bound(least_urgent, DAVIS)
