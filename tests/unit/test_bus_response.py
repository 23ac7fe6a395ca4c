"""Response times and loads: the published method's numbers for CANopen drives at 1 Mbit/s."""

import pytest

from turnbuckle.model.bus.frames import Pace, cyclic, messages
from turnbuckle.model.bus.response import (
    Message,
    frame_bits,
    recovery_bits,
    response_time,
    utilisation,
)
from turnbuckle.model.bus.tables import Drive


def drives(count: int) -> list[Drive]:
    rows = [{"name": f"d{node}", "bus": "b", "node": node} for node in range(1, count + 1)]
    return [Drive.model_validate(row) for row in rows]


def pace(sync: float) -> Pace:
    """A quiet bus: SDO every 10 ms, heartbeats and emergencies every 100 ms, prompt drives."""
    return Pace(1e6, sync, cycle=0.01, heartbeat=0.1, drive_heartbeat=0.1, sdo_timeout=0.5)


def response(name: str, count: int, sync: float) -> int | None:
    among = messages(drives(count), pace(sync))
    return response_time(next(m for m in among if m.name == name), among)


@pytest.mark.parametrize(
    ("size", "bits"),
    [(0, 55), (1, 65), (2, 75), (3, 85), (4, 95), (5, 105), (6, 115), (7, 125), (8, 135)],
)
def test_the_longest_frame_has_every_stuff_bit(size: int, bits: int) -> None:
    stuffed = 34 + 8 * size  # bits from start of frame to the CRC, of which every fifth may follow
    assert frame_bits(size) == stuffed + 13 + (stuffed - 1) // 4 == bits


@pytest.mark.parametrize(
    ("count", "sync", "load"),
    [(2, 1e-3, 0.515), (3, 1e-3, 0.745), (4, 1e-3, 0.975), (4, 2e-3, 0.4875), (8, 4e-3, 0.47375)],
)
def test_sync_and_pdos_load_the_bus_by_so_much(count: int, sync: float, load: float) -> None:
    assert utilisation(cyclic(drives(count), pace(sync))) == pytest.approx(load)


def test_two_drives_at_1_khz_fit() -> None:
    assert utilisation(messages(drives(2), pace(1e-3))) == pytest.approx(0.547, abs=5e-4)
    assert response("d2 answer", 2, 1e-3) == 730
    assert response("d2 command", 2, 1e-3) == 920


def test_four_drives_at_1_khz_do_not() -> None:
    assert utilisation(messages(drives(4), pace(1e-3))) > 1
    last = response("d4 command", 4, 1e-3)
    assert last is not None and last > 1000
    assert response("master heartbeat", 4, 1e-3) is None


def test_four_drives_at_500_hz_fit() -> None:
    last = response("d4 command", 4, 2e-3)
    assert last is not None and last <= 2000


def test_the_least_urgent_frame_waits_for_no_other_and_the_most_urgent_for_one() -> None:
    urgent, patient = Message("urgent", 1, 0, 1000, 1000), Message("patient", 2, 8, 1000, 1000)
    assert response_time(urgent, [urgent, patient]) == 135 + 55
    assert response_time(patient, [urgent, patient]) == 55 + 135


def test_jitter_counts_in_full_and_lets_frames_crowd() -> None:
    low = Message("low", 2, 0, 1000, 1000)
    for jitter, frames in ((0, 1), (904, 1), (905, 2)):
        high = Message("high", 1, 4, 1000, 1000, jitter)
        assert response_time(low, [high, low]) == frames * 95 + 55
        assert response_time(high, [high, low]) == jitter + 55 + 95


def test_an_error_costs_its_flags_and_the_longest_frame_again() -> None:
    assert recovery_bits(messages(drives(2), pace(1e-3))) == 31 + 135


def test_periods_are_rounded_down_and_delays_up_to_whole_bits() -> None:
    slow = Pace(125e3, 1 / 300, 0.01, 0.1, 0.1, 0.5, delay=41e-6)
    sync, answer = cyclic(drives(1), slow)[:2]
    assert (sync.period, answer.jitter) == (416, 6)
