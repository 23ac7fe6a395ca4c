"""Faults of a simulated encoder: what it counts while its motor turns."""

from math import pi

import pytest

from turnbuckle.lab.drives.motion import Encoder

INCREMENTS = 4096
TURN = 2.0 * pi
CYCLE = 1e-3


def counted(encoder: Encoder, *turns: float) -> list[int]:
    """What it counts, cycle by cycle, in the middle of the increments at these turns."""
    counts = []
    for turn in turns:
        encoder.turn((turn + 0.5 / INCREMENTS) * TURN, CYCLE)
        counts.append(encoder.count)
    return counts


@pytest.fixture
def encoder() -> Encoder:
    """One that stands where it counts nothing."""
    encoder = Encoder(INCREMENTS)
    encoder.turn(0.0, CYCLE)
    return encoder


@pytest.mark.parametrize("scale", [0.0, -1.0, 0.5, 2.0])
def test_a_scale_holds_from_where_the_motor_is(encoder: Encoder, scale: float) -> None:
    assert counted(encoder, 0.25) == [1024]
    encoder.distort(scale)
    assert counted(encoder, 0.25, 0.5) == [1024, pytest.approx(1024 * (1 + scale), abs=1)]


def test_an_encoder_that_slips_does_so_while_it_turns_and_not_while_it_stands(
    encoder: Encoder,
) -> None:
    encoder.slip(-4)
    assert counted(encoder, 0.0, 0.25, 0.25, 0.25, 0.5) == [0, 1020, 1020, 1020, 2040]


def test_a_jump_stays(encoder: Encoder) -> None:
    encoder.jump(100)
    assert counted(encoder, 0.0, 0.25) == [100, 1124]


def test_power_on_ends_every_fault(encoder: Encoder) -> None:
    encoder.slip(3)
    encoder.distort(2.0)
    encoder.jump(7)
    encoder.restart()
    encoder.turn(0.0, CYCLE)
    assert counted(encoder, 0.0, 0.25) == [0, 1024]
