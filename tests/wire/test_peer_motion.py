"""Motors of the drives by another hand: torque, position, homing, encoder and their faults."""

from __future__ import annotations

import math
import struct
from typing import Any

import pytest
from peer_bench import CSP, ENABLE, HOMING, SHUTDOWN, START, SWITCH_ON, Bench, drive
from peer_drives import (
    MICROSECOND,
    MILLISECOND,
    SECOND,
    Bus,
    EncoderFault,
    Frame,
    Library,
    Power,
    TorqueFault,
    Variation,
)

RATED = 0.09  # N m
TURN = 2 * math.pi


@pytest.fixture(scope="module")
def library() -> Library:
    return Library()


def position(bench: Bench) -> int:
    return bench.peer.object(0, 0x6064)


@pytest.mark.parametrize(
    ("target", "torque"),
    [(0, 0.0), (1, 0.001), (-500, -0.5), (1000, 1.0), (2000, 2.0), (2001, 2.0), (-32768, -2.0)],
)
def test_torque_is_per_mille_of_the_rated_up_to_the_current_limit(
    library: Library, target: int, torque: float
) -> None:
    bench = Bench(library).enabled()
    status = bench.command(ENABLE, target)
    assert bench.peer.torque(0) == pytest.approx(torque * RATED)
    assert bench.peer.object(0, 0x6077) == round(torque * 1000)
    assert bench.peer.object(0, 0x30D1, 2) == round(torque * 3000)
    assert bool(status & 0x0800) == (abs(target) > 2000)


def test_there_is_no_torque_outside_operation_enabled(library: Library) -> None:
    bench = Bench(library).ready()
    for word in (0, SHUTDOWN, SWITCH_ON):
        bench.command(word, 1000)
        assert bench.peer.torque(0) == 0
    bench.command(ENABLE, 1000)
    assert bench.peer.torque(0) == pytest.approx(RATED)
    bench.command(SWITCH_ON, 1000, cycles=500)
    assert bench.peer.power(0) == Power.SWITCHED_ON
    assert bench.peer.torque(0) == 0


def test_the_offset_adds_and_halt_takes_the_torque_away(library: Library) -> None:
    bench = Bench(library).enabled()
    bench.write(0x60B2, 0, 100)
    bench.command(ENABLE, 200)
    assert bench.peer.torque(0) == pytest.approx(0.3 * RATED)
    bench.command(ENABLE | 0x100, 200)
    assert bench.peer.torque(0) == 0


def test_a_long_overload_is_cut_to_the_nominal_current(library: Library) -> None:
    bench = Bench(library).enabled()
    bench.command(ENABLE, 2000, cycles=100)
    assert bench.peer.torque(0) == pytest.approx(2 * RATED)
    bench.command(ENABLE, 2000, cycles=2000)
    assert bench.peer.object(0, 0x3200, 1) == pytest.approx(100, abs=2)
    assert bench.status() & 0x0800


def test_a_free_rotor_gains_speed_by_torque_and_inertia(library: Library) -> None:
    bench = Bench(library, [drive(friction=0.0)]).enabled()
    for _ in range(100):
        bench.cycle(struct.pack("<Hh", ENABLE, 100))
    rate = 0.1 * RATED / 1.4e-5 * 0.099
    assert bench.peer.object(0, 0x606C) == pytest.approx(rate * 60 / TURN, rel=0.05)


@pytest.mark.parametrize("start", [0, 12345, 2**31 - 3, -(2**31), -1])
def test_positions_wrap_at_32_bits_wherever_they_start(library: Library, start: int) -> None:
    bench = Bench(library, [drive(initial_count=start)])
    assert position(bench) == start
    for step in (1, 5, -7):
        bench.peer.turn(0, bench.peer.now, 0.0)
        bench.peer.turn(0, bench.peer.now + 1, (step + 0.5) / 2000 * TURN)
        bench.peer.run(bench.peer.now + 1)
        bench.peer.turn(0, bench.peer.now + 1, (step + 0.5) / 2000 * TURN)
        expected = (start + step + 2**31) % 2**32 - 2**31
        assert position(bench) == expected


def test_a_coupled_motor_moves_on_between_the_calls(library: Library) -> None:
    bench = Bench(library)
    now = bench.peer.now
    bench.peer.turn(0, now, 1.0)
    bench.peer.turn(0, now + MILLISECOND, 1.5)
    for at, angle in ((0.25, 1.125), (1.0, 1.5), (2.0, 2.0)):
        bench.peer.run(now + round(at * MILLISECOND))
        assert bench.peer.angle(0) == pytest.approx(angle)
        assert position(bench) == math.floor(angle / TURN * 2000)


def test_csp_follows_its_target_and_stays_there_against_a_load(library: Library) -> None:
    bench = Bench(library).enabled(CSP)
    start = position(bench)
    for k in range(1, 301):
        bench.command(ENABLE, start + 10 * k, cycles=1)
    bench.command(ENABLE, start + 3000, cycles=200)
    assert position(bench) == pytest.approx(start + 3000, abs=3)
    assert bench.status() & 0x3000 == 0x1000
    assert bench.peer.object(0, 0x6062) == start + 3000


@pytest.mark.parametrize("start", [2**31 - 500, -(2**31) + 500])
def test_csp_follows_across_the_end_of_32_bits(library: Library, start: int) -> None:
    bench = Bench(library, [drive(initial_count=start)]).enabled(CSP)
    sign = 1 if start > 0 else -1
    for k in range(1, 151):
        target = (start + sign * 10 * k + 2**31) % 2**32 - 2**31
        bench.command(ENABLE, target, cycles=1)
    bench.command(ENABLE, target, cycles=100)
    assert abs(position(bench) - target) <= 3
    assert (position(bench) > 0) != (start > 0)


def test_csp_interpolates_over_the_period_set(library: Library) -> None:
    bench = Bench(library)
    assert bench.request(struct.pack("<BHBB", 0x2F, 0x60C2, 1, 10))[0] == 0x60
    bench.enabled(CSP)
    start = position(bench)
    bench.send(0x201, struct.pack("<Hi", ENABLE, start + 400))
    bench.wait(1)
    bench.send(0x80)
    bench.wait(0)
    demands = []
    for _ in range(12):
        bench.wait(1)
        demands.append(bench.peer.object(0, 0x6062) - start)
    assert demands == pytest.approx([40 * k for k in range(1, 11)] + [400, 400], abs=1)


def test_a_target_too_far_off_is_a_following_error(library: Library) -> None:
    bench = Bench(library).enabled(CSP)
    bench.command(ENABLE, position(bench) + 5000, cycles=5)
    assert bench.frames(0x81)[0].data[:3] == b"\x11\x86\x21"
    bench.wait(500)
    assert bench.peer.power(0) == Power.FAULT


def test_csp_entered_without_a_target_near_the_position_is_a_following_error(
    library: Library,
) -> None:
    bench = Bench(library, [drive(initial_count=100_000)]).enabled()
    bench.write(0x6060, 0, CSP)
    bench.wait(500)
    assert bench.peer.power(0) == Power.FAULT
    assert bench.frames(0x81)[0].data[:2] == b"\x11\x86"


STOPPED: dict[str, Any] = {"stop_low": -1.0, "stop_high": 2.0}


def homing(library: Library, method: int, **settings: Any) -> Bench:
    """Ready to home at 60 rpm with 500 mA."""
    bench = Bench(library, [drive(**{**STOPPED, **settings})])
    bench.write(0x6098, 0, method)
    bench.write(0x6099, 1, 60)
    bench.enabled(HOMING)
    assert bench.status() & 0x3400 == 0x0400, "not started"
    return bench


@pytest.mark.parametrize("start", [0, 2**31 - 100])
@pytest.mark.parametrize(("method", "stop"), [(-3, 2.0), (-4, -1.0)])
def test_homing_ends_at_the_stop_its_method_seeks(
    library: Library, method: int, stop: float, start: int
) -> None:
    bench = homing(library, method, initial_count=start)
    bench.write(0x30B0, 0, 1000)
    status = [bench.command(ENABLE | 0x10, cycles=1) for _ in range(500)]
    assert status[20] & 0x3400 == 0, "under way"
    done = next(k for k, one in enumerate(status) if one & 0x3400 == 0x1400)
    assert done > abs(stop) / TURN / 1.0 * 1000 - 20, "no sooner than 1 turn/s allows"
    assert all(one & 0x2000 == 0 for one in status)
    assert all(one & 0xB400 == 0x9400 for one in status[done:])
    assert bench.peer.angle(0) == pytest.approx(stop, abs=0.01)
    assert position(bench) == pytest.approx(1000, abs=2)
    assert bench.command(ENABLE) & 0x9400 == 0x9400, "without bit 4 too"


def test_homing_pushes_with_its_threshold_and_no_more(library: Library) -> None:
    bench = homing(library, -3)
    most = 0.0
    for _ in range(500):
        bench.command(ENABLE | 0x10, cycles=1)
        most = max(most, bench.peer.torque(0))
    threshold = 0.5 * 0.030
    assert threshold <= most < 1.4 * threshold


def test_a_higher_threshold_pushes_harder(library: Library) -> None:
    bench = homing(library, -4)
    bench.write(0x30B2, 0, 2000)
    least = 0.0
    for _ in range(500):
        bench.command(ENABLE | 0x10, cycles=1)
        least = min(least, bench.peer.torque(0))
    assert -1.4 * 0.06 < least <= -0.06


def test_after_the_stop_the_motor_moves_by_the_home_offset(library: Library) -> None:
    bench = homing(library, -4)
    bench.write(0x30B1, 0, 200)
    status = [bench.command(ENABLE | 0x10, cycles=1) for _ in range(800)]
    assert any(one & 0x3400 == 0x1000 for one in status), "attained, still moving"
    assert status[-1] & 0xB400 == 0x9400
    assert bench.peer.angle(0) == pytest.approx(-1.0 + 200 / 2000 * TURN, abs=0.02)
    assert position(bench) == pytest.approx(0, abs=3)


@pytest.mark.parametrize("method", [35, 37])
def test_homing_here_sets_the_position_without_a_move(library: Library, method: int) -> None:
    bench = homing(library, method, initial_count=777)
    bench.write(0x30B0, 0, -5000)
    status = bench.command(ENABLE | 0x10)
    assert status & 0xB400 == 0x9400
    assert position(bench) == -5000 and bench.peer.angle(0) == 0


def test_homing_without_bit_4_or_with_halt_is_interrupted(library: Library) -> None:
    for word in (ENABLE, ENABLE | 0x110):
        bench = homing(library, -3)
        bench.command(ENABLE | 0x10, cycles=50)
        assert bench.command(word, cycles=50) & 0xB400 == 0x0400
        angle = bench.peer.angle(0)
        bench.wait(100)
        assert bench.peer.angle(0) == pytest.approx(angle, abs=0.01)


def test_a_method_without_its_switch_is_a_homing_error(library: Library) -> None:
    assert homing(library, 17).command(ENABLE | 0x10) & 0x3000 == 0x2000


def test_homing_that_started_anew_has_lost_its_reference(library: Library) -> None:
    bench = homing(library, 37)
    assert bench.command(ENABLE | 0x10) & 0x8000
    bench.write(0x6098, 0, -3)
    bench.command(ENABLE)
    assert not bench.command(ENABLE | 0x10) & 0x8000


@pytest.mark.parametrize(("code", "kept"), [(0x2310, True), (0x7380, False), (0x738A, False)])
def test_some_errors_take_the_reference_with_their_reset(
    library: Library, code: int, kept: bool
) -> None:
    bench = homing(library, 37)
    bench.command(ENABLE | 0x10)
    bench.peer.fail(0, code)
    bench.command(0)
    assert bool(bench.command(0x80) & 0x8000) == kept


def turned(bench: Bench, angle: float, duration: int = 100) -> None:
    """The shaft turns to an angle and stays."""
    bench.peer.turn(0, bench.peer.now, bench.peer.angle(0))
    bench.peer.turn(0, bench.peer.now + duration * MILLISECOND, angle)
    bench.wait(duration)
    bench.peer.turn(0, bench.peer.now + MICROSECOND, angle)
    bench.peer.wait(MICROSECOND)


@pytest.mark.parametrize(
    ("fault", "value", "change"),
    [
        (EncoderFault.GOOD, 0.0, 1000),
        (EncoderFault.REVERSED, 0.0, -1000),
        (EncoderFault.FROZEN, 0.0, 0),
        (EncoderFault.JUMP, 300.0, 1300),
        (EncoderFault.SLIP, 50.0, 1005),
        (EncoderFault.SCALED, 1.1, 1100),
    ],
)
def test_an_encoder_fault_begins_where_the_encoder_is(
    library: Library, fault: EncoderFault, value: float, change: int
) -> None:
    bench = Bench(library, [drive(initial_count=10)])
    turned(bench, TURN)
    assert position(bench) == pytest.approx(2010, abs=1)
    bench.peer.vary(0, Variation(encoder=fault, encoder_value=value))
    turned(bench, 1.5 * TURN)
    assert position(bench) == pytest.approx(2010 + change, abs=1)
    assert bench.peer.angle(0) == pytest.approx(1.5 * TURN)
    bench.peer.vary(0)
    turned(bench, 2 * TURN)
    assert position(bench) == pytest.approx(3010 + change, abs=2)


def test_a_jump_comes_once_though_other_things_vary(library: Library) -> None:
    bench = Bench(library)
    jump = Variation(encoder=EncoderFault.JUMP, encoder_value=100)
    bench.peer.vary(0, jump)
    jump.status_set = 0x80
    bench.peer.vary(0, jump)
    assert position(bench) == 100


class Owner(Bench):
    """A bench whose first motor is moved by its owner's physics."""

    motor_angle = 0.0
    motor_rate = 0.0


def turned_by_owner(bench: Owner, word: int, target: int, cycles: int, load: float) -> None:
    """Cycles in which the owner has the motor, at 1 kHz: inertia, a constant load, an end stop."""
    peer, inertia = bench.peer, 2.0e-5
    for _ in range(cycles):
        bench.motor_rate += (peer.torque(0) - load) / inertia * 1e-3
        bench.motor_angle += bench.motor_rate * 1e-3
        if bench.motor_angle > 3.0:
            bench.motor_angle, bench.motor_rate = 3.0, 0.0
        peer.turn(0, peer.now + MILLISECOND, bench.motor_angle)
        bench.command(word, target, cycles=1)


def test_csp_and_homing_work_on_a_motor_that_its_owner_turns(library: Library) -> None:
    bench = Owner(library, [drive(tuned_inertia=2.0e-5)])
    bench.write(0x6098, 0, -3)
    bench.peer.turn(0, bench.peer.now, 0.0)
    bench.enabled(CSP)
    turned_by_owner(bench, ENABLE, 0, cycles=200, load=0.005)
    for target in range(0, 401, 5):
        turned_by_owner(bench, ENABLE, target, cycles=1, load=0.005)
    turned_by_owner(bench, ENABLE, 400, cycles=400, load=0.005)
    assert position(bench) == pytest.approx(400, abs=5)
    assert bench.peer.torque(0) == pytest.approx(0.005, abs=0.002)
    bench.write(0x6060, 0, HOMING)
    turned_by_owner(bench, ENABLE, 400, cycles=5, load=0.0)
    turned_by_owner(bench, ENABLE | 0x10, 400, cycles=900, load=0.0)
    assert bench.status() & 0xB400 == 0x9400
    assert bench.motor_angle == pytest.approx(3.0, abs=0.05)


@pytest.mark.parametrize("hidden", [False, True])
@pytest.mark.parametrize(("fault", "gain"), [(TorqueFault.NOT_GIVEN, 0), (TorqueFault.DOUBLED, 2)])
def test_a_torque_fault_shows_in_the_drives_figures_unless_hidden(
    library: Library, fault: TorqueFault, gain: int, hidden: bool
) -> None:
    bench = Bench(library).enabled()
    bench.peer.vary(0, Variation(torque=fault, torque_hidden=hidden))
    bench.command(ENABLE, 500)
    assert bench.peer.torque(0) == pytest.approx(0.5 * gain * RATED)
    assert bench.peer.object(0, 0x6077) == 500 * (1 if hidden else gain)


def test_eight_drives_on_four_buses_run_for_a_second_without_a_setpoint_lost(
    library: Library,
) -> None:
    buses = [Bus(bit_rate=1_000_000) for _ in range(4)]
    bench = Bench(library, [drive(node=k + 1, bus=k // 2) for k in range(8)], buses=buses)
    for number in range(8):
        bench.configure(number=number)
    for number in range(0, 8, 2):
        bench.nmt(START, number=number)
    peer = bench.peer
    begin = peer.now
    for k in range(1000):
        for bus in range(4):
            peer.send(bus, Frame(0x80))
        for number in range(8):
            word = (SHUTDOWN, SWITCH_ON, ENABLE)[min(k // 5, 2)]
            peer.send(number // 2, Frame(0x201 + number, struct.pack("<Hh", word, k % 100)))
        peer.run(begin + (k + 1) * SECOND // 1000)
    for number in range(8):
        assert peer.power(number) == Power.OPERATION_ENABLED
        counted = peer.counted(number)
        assert (counted.syncs, counted.setpoints) == (1000, 1000)
        assert (counted.lost, counted.doubled, counted.dropped) == (0, 0, 0)
    assert [peer.bus_counted(bus).collisions for bus in range(4)] == [0] * 4
