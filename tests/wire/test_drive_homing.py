"""Homing of a simulated drive: against a mechanical stop, or here."""

import pytest
from peer import Bench, booted, command, enable, running, write

from turnbuckle.lab.drives.motion import Run
from turnbuckle.lab.drives.power import Power

ENABLE, START = 0x0F, 0x1F


def ready_to_home(method: int, stop: float | None, offset: int = 0, position: int = 0) -> Bench:
    """An enabled drive in homing mode."""
    bench = booted(stop=stop)
    node = running(bench, mode=6)
    write(node, 0x6098, 0, method)
    write(node, 0x30B1, 0, offset)
    write(node, 0x30B0, 0, position)
    write(node, 0x30B2, 0, 400)
    enable(bench)
    return bench


def run(word: int) -> int:
    """Bits 13, 12, 10 of a statusword."""
    return word >> 11 & 0b110 | word >> 10 & 1


def finish(bench: Bench) -> None:
    """Wait until home is found."""
    bench.wait_for(lambda: run(command(bench, START)) == 0b011, 5.0)


@pytest.mark.parametrize(("method", "stop"), [(-3, 8.0), (-4, -8.0)])
def test_the_stop_is_home(method: int, stop: float) -> None:
    bench = ready_to_home(method, stop, position=1234)
    assert run(command(bench, ENABLE)) == 0b001
    assert run(command(bench, START)) == 0b000
    bench.wait(0.3)
    assert bench.rotors[0].speed == pytest.approx(stop / abs(stop) * 100 * 0.10472, rel=0.05)
    finish(bench)
    assert bench.rotors[0].angle == pytest.approx(stop, abs=2e-3)
    assert bench.drive.read(0x6064) == pytest.approx(1234, abs=1)
    assert bench.drive.read(0x6041) & 1 << 15
    bench.wait(0.3)
    assert bench.rotors[0].angle == pytest.approx(stop, abs=2e-3)
    assert run(command(bench, ENABLE)) == 0b011


def test_home_may_be_away_from_the_stop() -> None:
    bench = ready_to_home(-4, -8.0, offset=500)
    finish(bench)
    assert bench.drive.servo.homing is not None
    assert bench.drive.read(0x6064) == pytest.approx(0, abs=3)
    assert bench.rotors[0].angle == pytest.approx(-8.0 + 500 / 4096 * 6.2832, abs=0.01)


def test_home_may_be_here() -> None:
    bench = ready_to_home(37, None, position=-77)
    bench.rotors[0].angle = 3.0
    bench.wait(0.05)
    finish(bench)
    bench.wait(0.5)
    assert bench.drive.read(0x6064) == pytest.approx(-77, abs=2)


def test_a_run_is_interrupted_when_its_bit_is_taken_away() -> None:
    bench = ready_to_home(-4, -80.0)
    command(bench, START)
    bench.wait(0.3)
    assert run(command(bench, ENABLE)) == 0b001
    bench.wait(0.3)
    assert abs(bench.rotors[0].speed) < 0.2
    assert not bench.drive.read(0x6041) & 1 << 15


def test_without_a_stop_it_never_ends_and_a_failed_run_is_told() -> None:
    bench = ready_to_home(-4, None)
    command(bench, START)
    bench.wait(5.0)
    assert bench.drive.servo.homing is not None
    assert bench.drive.servo.homing.run is Run.RUNNING
    bench.drive.servo.homing.fail()
    assert run(command(bench, START)) & 0b100


def test_the_threshold_is_the_most_that_presses_on_the_stop() -> None:
    bench = ready_to_home(-4, -2.0)
    command(bench, START)
    pressed = 0.0
    for _ in range(1000):
        bench.advance()
        pressed = min(pressed, bench.drive.servo.torque)
        if bench.drive.servo.homing and bench.drive.servo.homing.home is not None:
            break
    assert pressed == pytest.approx(-0.4 * 0.03, rel=1e-6)


def test_an_error_of_the_sensor_loses_home() -> None:
    bench = ready_to_home(37, None)
    finish(bench)
    bench.drive.raise_error(0x7380)
    bench.wait(0.01)
    assert bench.drive.servo.power is Power.FAULT and not bench.drive.read(0x6041) & 1 << 15


def test_an_encoder_counts_from_wherever_it_was_switched_on() -> None:
    bench = booted()
    bench.rotors[0].angle = 123.4
    bench.drive.switch_on()
    bench.wait(0.3)
    assert bench.drive.read(0x6064) == 0
    bench.rotors[0].angle += 6.283186
    bench.wait(0.01)
    assert bench.drive.read(0x6064) == pytest.approx(4096, abs=1)


def test_an_encoder_can_freeze_and_jump() -> None:
    bench = booted()
    bench.drive.servo.encoder.jump(1000)
    bench.wait(0.001)
    assert bench.drive.read(0x6064) == 1000
    bench.drive.servo.encoder.distort(0.0)
    bench.rotors[0].angle = 9.0
    bench.wait(0.01)
    assert bench.drive.read(0x6064) == 1000
