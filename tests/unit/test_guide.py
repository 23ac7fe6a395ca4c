"""What leads the bases: how fast its references move, when a base has arrived, when it is lost."""

from ctypes import byref, c_double, c_size_t
from functools import cache
from typing import Any

import numpy as np
import pytest
from canopen_c import MACHINE, RUNTIME, Canopen
from safety_table import constants

NUMBERS = constants(MACHINE)
LAG, LAG_CYCLES = NUMBERS["TB_RAIL_LAG_LIMIT"], int(NUMBERS["TB_RAIL_LAG_CYCLES"])
RAILS = 4
HOME = [0.25, 0.125, 0.375, 0.5]
"""Where the bases are [m]."""


@cache
def library() -> Canopen:
    """The guide of the stock machine."""
    return Canopen([RUNTIME / "core" / "guide.c", *sorted(MACHINE.glob("*.c"))])


class Guide:
    """tb_guide, which has taken over every base where it is."""

    def __init__(self) -> None:
        self.c = library()
        self.memory = self.c.new("tb_guide")
        self.c.tb_guide_start(byref(self.memory))
        for rail, position in enumerate(HOME):
            self.c.tb_guide_take(byref(self.memory), c_size_t(rail), c_double(position))

    def step(self, rails: list[float], targets: list[float], speed: float = 0.0) -> list[float]:
        """One cycle; torques [N m]."""
        torque = reals([0.0] * RAILS)
        given = reals(rails), reals(targets), c_double(speed), torque
        self.c.tb_guide_step(byref(self.memory), *given)
        return list(torque)

    def has_arrived(self, rails: list[float], targets: list[float], distance: float) -> bool:
        """Whether every base is where it should be."""
        given = reals(rails), reals(targets), c_double(distance)
        return bool(self.c.tb_guide_has_arrived(byref(self.memory), *given))

    def lost(self) -> int | None:
        """The base that is lost, if one is."""
        rail = c_size_t(99)
        found = self.c.tb_guide_has_lost(byref(self.memory), byref(rail))
        return rail.value if found else None


def reals(values: list[float]) -> Any:
    """For C."""
    return (c_double * RAILS)(*values)


def moved(rail: int, distance: float) -> list[float]:
    """Where the bases are when one has moved so far."""
    return [position + distance * (rail == k) for k, position in enumerate(HOME)]


@pytest.mark.parametrize("rail", range(RAILS))
@pytest.mark.parametrize("way", [-1, 1])
def test_a_reference_moves_no_faster_than_it_may_and_stops_at_its_target(
    rail: int, way: int
) -> None:
    guide = Guide()
    places = []
    for _ in range(4):
        guide.step(HOME, moved(rail, way * 2.5e-3), speed=1.0)
        places.append(list(guide.memory.reference))
    expected = [moved(rail, way * step) for step in (1e-3, 2e-3, 2.5e-3, 2.5e-3)]
    assert np.allclose(places, expected, rtol=0, atol=1e-12)


def test_a_base_that_is_taken_over_again_begins_at_rest() -> None:
    guide, there = Guide(), moved(1, 0.001)
    for _ in range(50):
        guide.step(there, HOME)
    guide.c.tb_guide_take(byref(guide.memory), c_size_t(1), c_double(there[1]))
    assert guide.step(there, there) == [0.0] * RAILS


def test_a_base_that_is_where_it_should_be_is_not_pushed_and_another_is_pushed_back() -> None:
    guide = Guide()
    assert guide.step(HOME, HOME) == [0.0] * RAILS
    torque = guide.step(moved(2, 1e-3), HOME)
    assert torque[2] < 0.0
    assert [*torque[:2], torque[3]] == [0.0] * 3


@pytest.mark.parametrize("rail", range(RAILS))
def test_a_base_has_arrived_within_the_distance_and_its_reference_within_a_tenth(rail: int) -> None:
    # 2^-4 m: every sum below is exact.
    distance, beyond = 0.0625, np.nextafter(0.0625, 1.0)
    guide = Guide()
    for way in (-1, 1):
        assert guide.has_arrived(moved(rail, way * distance), HOME, distance)
        assert not guide.has_arrived(moved(rail, way * 1.01 * beyond), HOME, distance)
    guide.memory.reference[rail] += 0.0062
    assert guide.has_arrived(HOME, HOME, distance)
    guide.memory.reference[rail] += 0.0001
    assert not guide.has_arrived(HOME, HOME, distance)
    assert Guide().has_arrived(HOME, HOME, 0.0)


@pytest.mark.parametrize("rail", range(RAILS))
def test_a_base_is_lost_after_lagging_for_so_many_cycles_in_a_row(rail: int) -> None:
    guide = Guide()
    for away, cycles in ((1.001 * LAG, LAG_CYCLES), (0.999 * LAG, 1), (-1.001 * LAG, LAG_CYCLES)):
        for _ in range(cycles):
            guide.step(moved(rail, away), HOME)
            assert guide.lost() is None
    guide.step(moved(rail, -1.001 * LAG), HOME)
    assert guide.lost() == rail


def test_a_base_that_is_taken_over_again_begins_anew() -> None:
    guide = Guide()
    for _ in range(LAG_CYCLES + 1):
        guide.step(moved(1, 1.001 * LAG), HOME)
    assert guide.lost() == 1
    guide.c.tb_guide_take(byref(guide.memory), c_size_t(1), c_double(HOME[1]))
    assert guide.lost() is None
    assert guide.step(HOME, HOME) == [0.0] * RAILS
