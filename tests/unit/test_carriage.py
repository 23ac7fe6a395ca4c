"""A carriage that is pushed in vain, or gains speed against the push."""

from ctypes import byref
from functools import cache

import pytest
from canopen_c import MACHINE, RUNTIME, Canopen
from safety_table import constants

NUMBERS = constants(MACHINE)
LIMIT, TRAVEL = NUMBERS["TB_RAIL_TORQUE_LIMIT"], NUMBERS["TB_BLOCKED_TRAVEL"]
CYCLES = int(NUMBERS["TB_BLOCKED_CYCLES"])
GAINED = 0.05 * NUMBERS["TB_RAIL_SPEED_LIMIT"]
"""Speed against the push [m/s] that is too much."""


@cache
def library() -> Canopen:
    """The watch on carriages of the stock machine."""
    return Canopen([RUNTIME / "core" / "carriage.c", *sorted(MACHINE.glob("*.c"))])


class Carriage:
    """tb_carriage."""

    def __init__(self) -> None:
        self.c = library()
        self.memory, self.motion = self.c.new("tb_carriage"), self.c.new("tb_carriage_motion")
        self.c.tb_carriage_rest(byref(self.memory))

    def look(self, torque: float, position: float = 0.3, speed: float = 0.0) -> str:
        """One cycle with a share of the largest torque: the cause that is found."""
        self.motion.torque, self.motion.position = torque * LIMIT, position
        self.motion.speed = speed
        found = self.c.tb_carriage_look(byref(self.memory), byref(self.motion))
        return next(name for name, code in self.c.constants("TB_CAUSE_").items() if code == found)

    def push(self, cycles: int, torque: float = 1.0) -> None:
        """So many cycles in which nothing is found and nothing moves."""
        assert {self.look(torque) for _ in range(cycles)} == {"TB_CAUSE_NONE"}


@pytest.mark.parametrize("way", [-1.0, 1.0])
def test_a_carriage_that_stands_for_too_long_at_the_limit_is_blocked(way: float) -> None:
    carriage = Carriage()
    carriage.push(CYCLES, way)
    assert carriage.look(way) == "TB_CAUSE_BASE_BLOCKED"


@pytest.mark.parametrize("pause", [0.0, 0.49, 0.51, 0.94, -1.0])
def test_after_a_pause_the_cycles_count_anew(pause: float) -> None:
    carriage = Carriage()
    carriage.push(CYCLES)
    carriage.push(1, pause)
    carriage.push(CYCLES)
    assert carriage.look(1.0) == "TB_CAUSE_BASE_BLOCKED"


@pytest.mark.parametrize("way", [-1.0, 1.0])
def test_a_carriage_that_moves_is_not_blocked(way: float) -> None:
    carriage = Carriage()
    carriage.push(CYCLES)
    assert carriage.look(1.0, 0.3 + 1.01 * way * TRAVEL) == "TB_CAUSE_NONE"
    for _ in range(CYCLES):
        assert carriage.look(1.0, 0.3 + 1.99 * way * TRAVEL) == "TB_CAUSE_NONE"
    assert carriage.look(1.0, 0.3 + 1.99 * way * TRAVEL) == "TB_CAUSE_BASE_BLOCKED"


def test_just_the_travel_is_motion() -> None:
    carriage = Carriage()
    assert {carriage.look(1.0, 0.0) for _ in range(CYCLES)} == {"TB_CAUSE_NONE"}
    assert carriage.look(1.0, TRAVEL) == "TB_CAUSE_NONE"


@pytest.mark.parametrize("way", [-1.0, 1.0])
def test_speed_gained_against_a_push_is_the_wrong_way(way: float) -> None:
    carriage = Carriage()
    assert carriage.look(0.6 * way, speed=0.0) == "TB_CAUSE_NONE"
    assert carriage.look(0.6 * way, speed=-GAINED * way) == "TB_CAUSE_NONE"
    assert carriage.look(0.6 * way, speed=-1.01 * GAINED * way) == "TB_CAUSE_WRONG_WAY"


@pytest.mark.parametrize("way", [-1.0, 1.0])
def test_speed_that_was_there_before_or_is_lost_is_not_gained_against_the_push(way: float) -> None:
    of_push = ((-1.0, -1.0 - 0.99 * GAINED), (1.0, 1.0 - 2 * GAINED), (2 * GAINED, 0.0))
    for before, after in of_push:
        carriage = Carriage()
        assert carriage.look(0.6 * way, speed=before * way) == "TB_CAUSE_NONE"
        assert carriage.look(0.6 * way, speed=after * way) == "TB_CAUSE_NONE"
    assert carriage.look(-0.6 * way, speed=-2.0 * way) == "TB_CAUSE_NONE"
