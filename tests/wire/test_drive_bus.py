"""The simulated bus: what can go wrong with frames, and two drives with one number."""

from struct import pack

import pytest
from peer import Bench, booted, command, read, remote, running, status

from turnbuckle.lab.drives.bus import Disturbance, Mishap
from turnbuckle.lab.drives.node import Frame
from turnbuckle.lab.drives.setup import Identity, Setup

SHUTDOWN = 0x06
TPDO, RPDO = 0x181, 0x201


@pytest.fixture
def bench() -> Bench:
    """One drive that runs."""
    bench = booted()
    running(bench)
    return bench


def test_a_frame_can_be_lost_on_either_side(bench: Bench) -> None:
    bench.bus.disturb(TPDO, Disturbance(Mishap.DROP), count=2)
    assert [len(bench.sync()) for _ in range(3)] == [0, 0, 1]
    bench.bus.disturb(RPDO, Disturbance(Mishap.DROP))
    assert command(bench, SHUTDOWN) & 0x4F == 0x40
    assert command(bench, SHUTDOWN) & 0x6F == 0x21


def test_a_frame_can_come_twice(bench: Bench) -> None:
    bench.bus.disturb(TPDO, Disturbance(Mishap.DUPLICATE))
    first, second = bench.sync()
    assert first == second


def test_a_frame_can_come_later(bench: Bench) -> None:
    bench.bus.disturb(TPDO, Disturbance(Mishap.DELAY, cycles=2))
    assert bench.sync() == []
    assert len(bench.wait(0.001)) == 1


def test_a_frame_can_be_corrupted(bench: Bench) -> None:
    bench.bus.disturb(TPDO, Disturbance(Mishap.CORRUPT, flips=b"\xff\xff"))
    intact = status(bench.sync())[0] ^ 0xFFFF
    assert intact == status(bench.sync())[0]


def test_two_drives_with_one_number_both_answer() -> None:
    bench = booted(1)
    twin = bench.bus.add(Setup(1))
    bench.rotors += bench.rotors
    assert [frame.data for frame in bench.wait(0.5)] == [b"\0"]
    assert len(bench.send(0x601, pack("<BHBI", 0x40, 0x1018, 1, 0))) == 2
    assert twin in bench.bus.drives


def test_an_identity_can_be_another() -> None:
    bench = Bench()
    bench.bus.add(Setup(5, identity=Identity(vendor=0x123)))
    bench.rotors += bench.rotors
    bench.wait(0.5)
    assert read(remote(bench, 5), 0x1018, 1) == 0x123


def test_answers_to_one_sync_come_in_the_order_of_their_identifiers() -> None:
    bench = booted(3, 1, 2)
    for drive in bench.bus.drives:
        assert drive.node in (1, 2, 3)
    bench.nmt(0x82)
    assert [frame.cob for frame in bench.wait(0.1)] == [0x701, 0x702, 0x703]


def test_a_listener_hears_every_frame_and_who_sent_it(bench: Bench) -> None:
    heard: list[tuple[Frame, bool]] = []
    bench.bus.listeners.append(lambda frame, drive: heard.append((frame, drive)))
    bench.sync()
    assert [(frame.cob, drive) for frame, drive in heard] == [(0x080, False), (TPDO, True)]


def test_two_benches_that_are_treated_the_same_say_the_same() -> None:
    def say() -> list[Frame]:
        bench = booted()
        running(bench)
        frames = []
        for cycle in range(200):
            bench.send(RPDO, pack("<Hh", (6, 7, 15)[min(cycle // 3, 2)], cycle))
            frames += bench.sync()
        return frames

    assert say() == say()
