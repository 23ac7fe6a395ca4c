"""Where a drive is in a cycle in which it may have told nothing."""

import ctypes

import pytest
import supervised
from safety_table import constants
from supervised import DRIVES, Report

SPEED = 1e-4
"""Of the drive [m a cycle]."""
ROOM = 4096
"""More bytes than tb_measurement takes."""


class Measurement:
    """tb_measurement."""

    def __init__(self) -> None:
        self._library = supervised.stock_library()
        self._library.tb_measured_position.restype = ctypes.c_double
        self._memory = ctypes.create_string_buffer(ROOM)

    def take(self, position: float | None, age: int = 0) -> float:
        """One cycle, with a message that answers the SYNC `age` cycles ago; the position then."""
        reports = (Report * DRIVES)()
        for report in reports:
            report.fresh = int(position is not None)
            report.position, report.age = position or 0.0, age
        self._library.tb_measurement_take(self._memory, reports, ctypes.c_uint32(0))
        return float(self._library.tb_measured_position(self._memory, ctypes.c_size_t(0)))


@pytest.mark.parametrize("ages", [(0,), (1,), (0, 1), (1, 1, 0)], ids=str)
def test_a_steady_drive_is_where_it_is_however_late_its_answers_come(ages: tuple[int, ...]) -> None:
    """SYNC in every second cycle; the answer comes in its cycle or in the one after it."""
    measurement = Measurement()
    for cycle in range(40):
        age = ages[cycle // 2 % len(ages)]
        told = SPEED * (cycle - age) if cycle % 2 == age else None
        position = measurement.take(told, age)
        if cycle > 4:
            assert position == pytest.approx(SPEED * cycle, abs=1e-15)


def test_an_age_that_cannot_be_leaves_the_position_finite() -> None:
    measurement = Measurement()
    for cycle in range(5):
        assert abs(measurement.take(SPEED * cycle, 200)) < 1.0


def test_of_two_messages_for_one_sync_the_second_may_differ_by_a_cycles_motion() -> None:
    most = supervised.PERIOD * constants(supervised.STOCK)["TB_CABLE_SPEED_LIMIT"]
    for share, is_taken in ((0.99, True), (1.01, False)):
        measurement = Measurement()
        measurement.take(0.0, 1)
        measurement.take(0.0, 1)
        assert (measurement.take(share * most, 2) != 0.0) is is_taken


def test_the_first_position_may_be_anywhere_within_a_thousand_kilometres() -> None:
    farthest = 1e6
    assert Measurement().take(farthest) == farthest
    assert abs(Measurement().take(1.000001 * farthest)) < farthest
