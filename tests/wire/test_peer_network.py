"""NMT, heartbeats and emergencies of the drives by another hand, against CiA 301."""

from __future__ import annotations

import itertools
from typing import Any

import pytest
from peer_bench import (
    CSP,
    ENABLE,
    FAULT_RESET,
    PRE_OPERATIONAL,
    RESET_COMMUNICATION,
    RESET_NODE,
    START,
    STOP,
    Bench,
    Refused,
    drive,
    varied,
)
from peer_drives import MILLISECOND, Bus, Frame, Library, Nmt, PeerDrives, Power, Variation

MASTER = 0x7F


@pytest.fixture(scope="module")
def library() -> Library:
    return Library()


@pytest.fixture
def bench(library: Library) -> Bench:
    return Bench(library)


def times(bench: Bench, identifier: int) -> list[float]:
    """Of arrival, ms."""
    return [time / MILLISECOND for time, frame in bench.heard if frame.id == identifier]


@pytest.mark.parametrize(
    ("command", "state"),
    [(START, Nmt.OPERATIONAL), (STOP, Nmt.STOPPED), (PRE_OPERATIONAL, Nmt.PRE_OPERATIONAL)],
)
@pytest.mark.parametrize("before", [START, STOP, PRE_OPERATIONAL])
def test_each_state_is_reached_from_each(
    bench: Bench, before: int, command: int, state: Nmt
) -> None:
    bench.nmt(before)
    bench.nmt(command, node=1)
    assert bench.peer.nmt(0) == state


@pytest.mark.parametrize("data", [b"\1", b"\1\2", b"\1\1\0", b"\3\1", b""])
def test_a_command_that_is_not_for_it_moves_no_drive(bench: Bench, data: bytes) -> None:
    bench.send(0, data)
    bench.wait(1)
    assert bench.peer.nmt(0) == Nmt.PRE_OPERATIONAL


def test_a_drive_boots_after_its_delay_and_is_pre_operational_without_heartbeats(
    library: Library,
) -> None:
    bench = Bench(library, [drive(boot_delay=300 * MILLISECOND)], boot=False)
    bench.wait(299)
    assert bench.heard == [] and bench.peer.nmt(0) == Nmt.INITIALISING
    bench.wait(1000)
    assert bench.heard == [(300 * MILLISECOND + 56_000, Frame(0x701, b"\0"))]
    assert bench.peer.nmt(0) == Nmt.PRE_OPERATIONAL


@pytest.mark.parametrize("command", [RESET_NODE, RESET_COMMUNICATION])
def test_a_reset_boots_again(bench: Bench, command: int) -> None:
    bench.nmt(command)
    assert bench.peer.nmt(0) == Nmt.INITIALISING
    bench.wait(20)
    assert bench.frames(0x701) == [Frame(0x701, b"\0")] * 2
    assert bench.peer.nmt(0) == Nmt.PRE_OPERATIONAL


def test_a_drive_that_restarts_boots_twice_and_forgets(library: Library) -> None:
    restless = varied(restarts=1, restart_after=5 * MILLISECOND)
    bench = Bench(library, [restless], boot=False)
    bench.wait(12)
    bench.write(0x6098, 0, 37)
    bench.wait(100)
    assert bench.frames(0x701) == [Frame(0x701, b"\0")] * 2
    first, second = times(bench, 0x701)
    assert second - first == pytest.approx(5 + 10)
    assert bench.read(0x6098) == 7


@pytest.mark.parametrize(("percent", "period"), [(0, 20), (50, 10), (200, 40)])
def test_heartbeats_come_in_their_period_with_the_state(
    library: Library, percent: int, period: int
) -> None:
    bench = Bench(library, [varied(heartbeat_percent=percent)])
    bench.write(0x1017, 0, 20)
    bench.wait(200)
    bench.nmt(START)
    bench.wait(200)
    bench.nmt(STOP)
    bench.wait(200)
    beats = [frame.data[0] for frame in bench.frames(0x701)][1:]
    assert [state for state, _ in itertools.groupby(beats)] == [0x7F, 0x05, 0x04]
    between = [b - a for a, b in itertools.pairwise(times(bench, 0x701)[1:])]
    assert all(abs(one - period) < 0.2 for one in between)
    assert abs(len(beats) - 600 / period) <= 2


def test_no_heartbeats_after_a_period_of_zero(bench: Bench) -> None:
    bench.write(0x1017, 0, 10)
    bench.wait(50)
    bench.write(0x1017, 0, 0)
    bench.wait(1)
    count = len(bench.heard)
    bench.wait(100)
    assert len(bench.heard) == count


def watched(bench: Bench, milliseconds: int = 30) -> Bench:
    """The drive watches the master, which beats for a while and then no more."""
    bench.write(0x1016, 1, MASTER << 16 | milliseconds)
    for _ in range(10):
        bench.send(0x700 + MASTER, b"\5")
        bench.wait(20)
    return bench


def test_a_master_that_was_never_heard_is_not_missed(bench: Bench) -> None:
    bench.write(0x1016, 1, MASTER << 16 | 30)
    bench.wait(500)
    assert bench.frames(0x81) == []


def test_a_heartbeat_missed_is_an_emergency_after_the_time_set(bench: Bench) -> None:
    watched(bench)
    assert bench.frames(0x81) == [], "20 ms is not 30 ms"
    last = bench.peer.counted(0).last_heartbeat / MILLISECOND
    bench.wait(100)
    assert bench.frames(0x81) == [Frame(0x81, b"\x30\x81\x11\0\0\0\0\0")], "once"
    assert 30 < times(bench, 0x81)[0] - last < 30.3
    assert bench.read(0x1001) == 0x11 and bench.read(0x603F, signed=False) == 0x8130
    assert bench.read(0x1003, 0) == 1 and bench.read(0x1003, 1) == 0x8130
    assert bench.peer.counted(0).heartbeats == 10


def test_only_the_node_watched_counts(bench: Bench) -> None:
    watched(bench)
    for _ in range(4):
        bench.send(0x700 + 5, b"\5")
        bench.wait(10)
    assert len(bench.frames(0x81)) == 1


@pytest.mark.parametrize(
    ("behaviour", "state"),
    [(0, Nmt.PRE_OPERATIONAL), (1, Nmt.OPERATIONAL), (2, Nmt.STOPPED)],
)
def test_after_a_missed_heartbeat_the_state_is_that_of_1029(
    bench: Bench, behaviour: int, state: Nmt
) -> None:
    bench.write(0x1029, 1, behaviour)
    bench.nmt(START)
    watched(bench)
    assert bench.peer.nmt(0) == Nmt.OPERATIONAL
    bench.wait(50)
    assert bench.peer.nmt(0) == state


@pytest.mark.parametrize(
    ("option", "as_command", "state"),
    [
        (0, False, Power.OPERATION_ENABLED),
        (1, False, Power.FAULT),
        (2, False, Power.FAULT),
        (3, False, Power.FAULT),
        (0, True, Power.OPERATION_ENABLED),
        (1, True, Power.FAULT),
        (2, True, Power.SWITCH_ON_DISABLED),
        (3, True, Power.QUICK_STOP),
    ],
)
def test_after_a_missed_heartbeat_the_drive_reacts_as_6007_says(
    library: Library, option: int, as_command: bool, state: Power
) -> None:
    bench = Bench(library, [varied(reaction_is_command=as_command)])
    bench.write(0x6007, 0, option)
    watched(bench.enabled())
    bench.wait(50)
    assert bench.peer.power(0) == state
    assert bench.peer.nmt(0) == Nmt.PRE_OPERATIONAL


def test_the_fault_of_a_missed_heartbeat_is_reset_only_after_reset_communication(
    library: Library,
) -> None:
    bench = watched(Bench(library).enabled())
    bench.wait(50)
    for _ in range(2):
        bench.write(0x6040, 0, 0)
        bench.write(0x6040, 0, FAULT_RESET)
        bench.wait(5)
    assert bench.peer.power(0) == Power.FAULT
    bench.nmt(RESET_COMMUNICATION)
    bench.wait(20)
    assert bench.peer.power(0) == Power.FAULT
    bench.write(0x6040, 0, 0)
    bench.write(0x6040, 0, FAULT_RESET)
    bench.wait(2)
    assert bench.peer.power(0) == Power.SWITCH_ON_DISABLED
    assert bench.read(0x1016, 1) == 0, "what was not stored is gone"


def test_a_stop_or_reset_of_communication_is_a_lost_connection_too(library: Library) -> None:
    for command in (STOP, RESET_COMMUNICATION):
        bench = Bench(library)
        bench.write(0x6007, 0, 2)
        bench.enabled().nmt(command)
        assert bench.peer.power(0) == Power.SWITCH_ON_DISABLED


def test_pre_operational_leaves_the_power_on_but_clears_the_remote_bit(library: Library) -> None:
    bench = Bench(library).enabled()
    assert bench.read(0x6041) & 0x0200
    bench.nmt(PRE_OPERATIONAL)
    assert bench.peer.power(0) == Power.OPERATION_ENABLED
    assert not bench.read(0x6041) & 0x0200


# Code, error register by class (bit 0 generic, 1 current, 2 voltage, 3 temperature,
# 4 communication, 5 profile, 7 maker), whether the motor is stopped by a ramp first.
ERRORS = [
    (0x1000, 0x01, False),
    (0x2310, 0x03, False),
    (0x3210, 0x05, False),
    (0x3220, 0x05, False),
    (0x4210, 0x09, False),
    (0x5280, 0x01, False),
    (0x6320, 0x01, True),
    (0x7380, 0x81, False),
    (0x8611, 0x21, True),
    (0x8A80, 0x21, True),
    (0x8A88, 0x21, False),
    (0x8120, 0x11, True),
]


@pytest.mark.parametrize(("code", "register", "ramped"), ERRORS)
def test_an_error_of_the_drive_is_an_emergency_and_a_fault(
    library: Library, code: int, register: int, ramped: bool
) -> None:
    bench = Bench(library).enabled(CSP)
    turning = bench.peer.object(0, 0x6064)
    for _ in range(200):
        turning += 30
        bench.command(ENABLE, turning, cycles=1)
    bench.peer.fail(0, code)
    bench.wait(1)
    assert bench.frames(0x81) == [
        Frame(0x81, code.to_bytes(2, "little") + bytes([register, *[0] * 5]))
    ]
    assert bench.peer.power(0) == (Power.FAULT_REACTION if ramped else Power.FAULT)
    bench.wait(400)
    assert bench.peer.power(0) == Power.FAULT
    assert abs(bench.peer.torque(0)) == 0


def test_a_warning_is_no_fault(library: Library) -> None:
    bench = Bench(library).enabled()
    bench.peer.fail(0, 0xFF01)
    assert bench.command(ENABLE) & 0x00EF == 0x00A7
    assert bench.peer.power(0) == Power.OPERATION_ENABLED


def test_a_reset_of_the_fault_is_told_by_an_empty_emergency(bench: Bench) -> None:
    bench.peer.fail(0, 0x2310)
    bench.wait(1)
    bench.write(0x6040, 0, FAULT_RESET)
    bench.wait(1)
    assert bench.frames(0x81)[-1] == Frame(0x81, bytes(8))
    assert bench.read(0x1001) == 0


def test_the_history_has_the_newest_five_first_and_zero_clears_it(bench: Bench) -> None:
    codes = [0x2310, 0x3210, 0x4210, 0x5280, 0x6320, 0x7380]
    for code in codes:
        bench.peer.fail(0, code)
    bench.wait(1)
    assert bench.read(0x1003) == 5
    assert [bench.read(0x1003, sub) for sub in range(1, 6)] == codes[:0:-1]
    with pytest.raises(Refused):
        bench.write(0x1003, 0, 2)
    bench.write(0x1003, 0, 0)
    assert [bench.read(0x1003, sub) for sub in range(6)] == [0] * 6


def test_bursts_of_warnings_come_in_their_period(library: Library) -> None:
    bench = Bench(library, [varied(burst_period=50 * MILLISECOND, burst_count=4)])
    bench.wait(480)
    frames = [frame.data[:2] for frame in bench.frames(0x81)]
    assert frames == ([b"\x01\xff"] * 4 + [b"\0\0"]) * 9
    assert bench.peer.power(0) == Power.SWITCH_ON_DISABLED


def test_a_drive_without_power_is_silent_and_boots_when_it_comes_back(library: Library) -> None:
    bench = Bench(library, [drive(), drive(node=2)])
    bench.write(0x1017, 0, 10, number=1)
    bench.peer.vary(1, Variation(missing=True))
    bench.wait(2)
    count = len(bench.frames(0x702))
    bench.wait(100)
    assert len(bench.frames(0x702)) == count
    bench.peer.vary(1)
    bench.wait(20)
    assert bench.frames(0x702)[count:] == [Frame(0x702, b"\0")]


def test_buses_are_apart(library: Library) -> None:
    buses = [Bus(bit_rate=1_000_000), Bus(bit_rate=500_000)]
    peer = PeerDrives(library, buses, [drive(node=1, bus=0), drive(node=1, bus=1)])
    peer.run(50 * MILLISECOND)
    peer.send(1, Frame(0, b"\1\0"))
    peer.wait(5 * MILLISECOND)
    assert peer.nmt(0) == Nmt.PRE_OPERATIONAL and peer.nmt(1) == Nmt.OPERATIONAL
    assert [frame.id for _, frame in peer.received(0)] == [0x701]


@pytest.mark.parametrize(
    "settings",
    [{"node": 0}, {"node": 128}, {"bus": 1}, {"counts_per_turn": 2001}, {"rotor_inertia": 0.0}],
)
def test_drives_that_cannot_be_are_refused(library: Library, settings: dict[str, Any]) -> None:
    with pytest.raises(ValueError):
        PeerDrives(library, [Bus(bit_rate=1_000_000)], [drive(**{"node": 1, **settings})])
