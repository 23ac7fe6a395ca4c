"""The wire of the drives by another hand: bits, times and order, against ISO 11898-1 by hand."""

from __future__ import annotations

import itertools
import random

import pytest
from peer_bench import START, Bench, drive
from peer_drives import (
    MICROSECOND,
    MILLISECOND,
    Bus,
    BusVariation,
    Frame,
    Library,
    PeerDrives,
    Timing,
)

GENERATOR = 0xC599  # x^15 + x^14 + x^10 + x^8 + x^7 + x^4 + x^3 + 1


@pytest.fixture(scope="module")
def library() -> Library:
    return Library()


def text_of(frame: Frame) -> str:
    """The bits from start of frame to the last of the data, as ISO 11898-1 draws them."""
    length = len(frame.data) if frame.length is None else frame.length
    remote = str(int(frame.remote))
    if frame.extended:
        base, rest = frame.id >> 18, frame.id & 0x3FFFF
        head = f"0{base:011b}11{rest:018b}{remote}00{length:04b}"
    else:
        head = f"0{frame.id:011b}{remote}00{length:04b}"
    return head + "".join(f"{byte:08b}" for byte in ([] if frame.remote else frame.data))


def remainder(text: str) -> int:
    """Of the division of text * x^15 by the generator."""
    value = int(text, 2) << 15
    while value.bit_length() > 15:
        value ^= GENERATOR << value.bit_length() - 16
    return value


def stuffed(text: str) -> str:
    """With a complement after any five equal bits, the stuffed ones counted too."""
    out = ""
    for bit in text:
        out += bit
        if out[-5:] in ("00000", "11111"):
            out += "1" if bit == "0" else "0"
    return out


def some_frames() -> list[Frame]:
    chance = random.Random(402)
    frames = []
    for extended, remote, size in itertools.product((False, True), (False, True), range(9)):
        for _ in range(20):
            identifier = chance.getrandbits(29 if extended else 11)
            data = bytes(chance.choice((0, 0xFF, chance.getrandbits(8))) for _ in range(size))
            sent = b"" if remote else data
            frames.append(Frame(identifier, sent, extended, remote, size if remote else None))
    return frames


@pytest.mark.parametrize(
    ("frame", "crc", "bits"),
    [
        # SYNC: 0 00010000000 000 0000, remainder 001110000000101. After its first 1 there are 16
        # zeros, which take 3 stuff bits, and between 111 and 101 there are 7, which take 1: 47 + 4.
        (Frame(0x080), 0b001110000000101, 51),
        # Identifier 0: 34 zeros with the remainder 0; a stuff bit after each of 6 fives.
        (Frame(0x000), 0, 34 + 6 + 13),
    ],
)
def test_frames_worked_by_hand_have_their_check_sequence_and_length(
    library: Library, frame: Frame, crc: int, bits: int
) -> None:
    assert library.crc(frame) == crc
    assert library.bits(frame) == bits


def test_any_frame_has_the_remainder_and_the_stuff_bits_of_the_standard(library: Library) -> None:
    for frame in some_frames():
        text = text_of(frame)
        crc = remainder(text)
        assert library.crc(frame) == crc
        assert library.bits(frame) == len(stuffed(text + f"{crc:015b}")) + 13


def test_a_frame_is_never_shorter_than_unstuffed_nor_longer_than_the_bound(
    library: Library,
) -> None:
    for frame in some_frames():
        size = len(frame.data)
        least, most = (67, 80) if frame.extended else (47, 55)
        worst = most + (0 if frame.remote else 10 * size)
        assert least + 8 * size <= library.bits(frame) <= worst == library.bits_worst(frame)


def test_the_bound_is_nearly_met_by_the_worst_pattern(library: Library) -> None:
    """Five equal bits, then four and four: after each stuff bit four of its own value."""
    patterns = (b"\x3c\x3c\x3c\x3c\x3c\x3c\x3c\x3c", b"\x0f" * 8, b"\x78" * 8, b"\xf0" * 8)
    longest = max(
        library.bits(Frame(identifier, data)) for identifier in range(0x800) for data in patterns
    )
    assert 135 - 6 <= longest <= 135


def alone(library: Library, timing: Timing | None = None, rate: int = 1_000_000) -> PeerDrives:
    """A bus with one drive that does not speak by itself after its boot-up."""
    peer = PeerDrives(library, [Bus(bit_rate=rate)], [drive()], timing)
    peer.run(20 * MILLISECOND)
    peer.received(0)
    return peer


@pytest.mark.parametrize(("rate", "bit"), [(1_000_000, 1000), (500_000, 2000), (125_000, 8000)])
def test_a_frame_takes_its_bits_and_its_answer_comes_after_the_gap(
    library: Library, rate: int, bit: int
) -> None:
    peer = alone(library, rate=rate)
    request = Frame(0x601, bytes([0x40, 0x18, 0x10, 1, 0, 0, 0, 0]))
    peer.send(0, request)
    start = peer.now
    ((arrival, answer),) = (peer.wait(50 * MILLISECOND), peer.received(0))[1]
    asked, answered = library.bits(request), library.bits(answer)
    assert arrival - start == bit * (asked + answered - 3)


def test_frames_of_the_worst_kind_take_the_bound(library: Library) -> None:
    peer = alone(library, Timing(worst=True))
    peer.send(0, Frame(0x601, bytes([0x40, 0x18, 0x10, 1, 0, 0, 0, 0])))
    start = peer.now
    ((arrival, _),) = (peer.wait(5 * MILLISECOND), peer.received(0))[1]
    assert arrival - start == (135 + 135 - 3) * MICROSECOND


def test_a_frame_under_way_is_not_interrupted_and_then_the_lowest_identifier_goes(
    library: Library,
) -> None:
    peer = alone(library)
    start = peer.now
    for identifier, time in ((0x700, 0), (0x300, 1), (0x080, 2), (0x181, 3)):
        peer.inject(0, Frame(identifier, bytes(8)), start + time)
    peer.send(0, Frame(0x100, bytes(8)), start + 4)  # handed in last, but the master's and lower
    peer.wait(2 * MILLISECOND)
    times = {frame.id: time for time, frame in peer.received(0)}
    assert list(times) == [0x700, 0x300, 0x080, 0x181], "one other node keeps its own order"
    between = library.bits(Frame(0x100, bytes(8))) + library.bits(Frame(0x300, bytes(8)))
    assert times[0x300] - times[0x700] == between * MICROSECOND


def test_drives_that_answer_one_sync_go_in_the_order_of_their_identifiers(library: Library) -> None:
    bench = Bench(library, [drive(node=node) for node in (5, 3, 9, 1)])
    for number in range(4):
        bench.configure(number=number)
    bench.nmt(START)
    bench.heard.clear()
    bench.cycle()
    assert [frame.id for _, frame in bench.heard] == [0x181, 0x183, 0x185, 0x189]
    gaps = [later - earlier for (earlier, _), (later, _) in itertools.pairwise(bench.heard)]
    lengths = [library.bits(frame) * MICROSECOND for _, frame in bench.heard]
    assert gaps == lengths[1:], "back to back"


def test_a_standard_frame_wins_over_an_extended_one_and_over_a_remote_request(
    library: Library,
) -> None:
    for rival in (Frame(0x123 << 18, b"\0", extended=True), Frame(0x123, remote=True, length=1)):
        peer = alone(library)
        peer.inject(0, Frame(0x7FF), peer.now)
        peer.send(0, Frame(0x123, b"\1"), peer.now + 1)
        peer.inject(0, rival, peer.now + 1)
        peer.wait(MILLISECOND)
        times = {frame: time for time, frame in peer.received(0)}
        between = (library.bits(Frame(0x123, b"\1")) + library.bits(rival)) * MICROSECOND
        assert times[rival] - times[Frame(0x7FF)] == between


def test_the_masters_frames_go_in_the_order_it_handed_them_in(library: Library) -> None:
    peer = alone(library)
    peer.send(0, Frame(0x700, b"\0"))
    peer.send(0, Frame(0x601, bytes([0x40, 0x18, 0x10, 1, 0, 0, 0, 0])))
    peer.send(0, Frame(0x000, bytes([0x02, 0])))  # stops the drive, but after it was asked
    peer.wait(2 * MILLISECOND)
    assert [frame.id for _, frame in peer.received(0)] == [0x581]
    assert peer.waiting(0) == 0


def test_nothing_moves_without_a_node_that_acknowledges(library: Library) -> None:
    peer = PeerDrives(library, [Bus(bit_rate=1_000_000)], [drive(boot_delay=50 * MILLISECOND)])
    assert peer.send(0, Frame(0x123))
    peer.run(49 * MILLISECOND)
    assert peer.waiting(0) == 1 and peer.bus_counted(0).frames == 0
    peer.run(51 * MILLISECOND)
    assert peer.waiting(0) == 0 and peer.bus_counted(0).frames == 2


def test_a_full_queue_takes_no_more(library: Library) -> None:
    peer = PeerDrives(library, [Bus(bit_rate=1_000_000)], [drive(boot_delay=50 * MILLISECOND)])
    taken = [peer.send(0, Frame(0x123)) for _ in range(70)]
    assert taken == [True] * 64 + [False] * 6


@pytest.mark.parametrize("frame", [Frame(0x800), Frame(1, bytes(9)), Frame(1 << 29, extended=True)])
def test_what_is_no_frame_is_not_taken(library: Library, frame: Frame) -> None:
    assert not alone(library).send(0, frame)


def test_two_drives_with_one_number_destroy_each_others_answers(library: Library) -> None:
    twins = [drive(serial=1), drive(serial=2)]
    bench = Bench(library, twins)
    assert len(bench.frames(0x701)) == 1, "equal boot-ups pass as one"
    bench.send(0x601, bytes([0x40, 0x18, 0x10, 1, 0, 0, 0, 0]))
    bench.wait(2)
    assert len(bench.frames(0x581)) == 1, "and equal answers"
    bench.send(0x601, bytes([0x40, 0x18, 0x10, 4, 0, 0, 0, 0]))
    bench.wait(20)
    assert len(bench.frames(0x581)) == 1, "but not unequal ones"
    assert bench.peer.bus_counted(0).collisions == 32


def test_a_time_message_and_a_foreign_heartbeat_come_in_their_period(library: Library) -> None:
    strange = BusVariation(
        time_period=10 * MILLISECOND,
        foreign_period=5 * MILLISECOND,
        foreign_node=99,
        foreign_state=5,
    )
    bench = Bench(library, buses=[Bus(bit_rate=1_000_000, variation=strange)])
    bench.heard.clear()
    bench.wait(100)
    assert len(bench.frames(0x100)) == 10 and len(bench.frames(0x100)[0].data) == 6
    assert bench.frames(0x763) == [Frame(0x763, b"\5")] * 20


def test_a_master_hears_its_own_sync_only_where_that_is_asked_for(library: Library) -> None:
    for echo in (False, True):
        bench = Bench(library, buses=[Bus(bit_rate=1_000_000)])
        bench.peer.vary_bus(0, BusVariation(echo_sync=echo))
        bench.send(0x80)
        bench.send(0x201, bytes(2))
        bench.wait(1)
        assert bench.frames(0x80) == [Frame(0x80)] * echo
        assert bench.frames(0x201) == []


def test_time_stops_where_something_arrives(library: Library) -> None:
    peer = alone(library)
    request = Frame(0x601, bytes([0x40, 0x18, 0x10, 1, 0, 0, 0, 0]))
    peer.send(0, request)
    reached = peer.run_to_arrival(peer.now + MILLISECOND)
    ((arrival, _),) = peer.received(0)
    assert reached == arrival
    assert peer.run_to_arrival(reached + MILLISECOND) == reached + MILLISECOND


def test_the_same_seed_gives_the_same_times_and_another_one_others(library: Library) -> None:
    def times(seed: int) -> list[tuple[int, Frame]]:
        timing = Timing(seed=seed, answer_delay=100 * MICROSECOND, sdo_delay=MILLISECOND)
        bench = Bench(library, timing=timing).ready()
        for _ in range(20):
            bench.cycle()
        return bench.heard

    assert times(1) == times(1)
    assert [time for time, _ in times(1)] != [time for time, _ in times(2)]
