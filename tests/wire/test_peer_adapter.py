"""The serial adapter of the drives by another hand: the Lawicel protocol and its dialects."""

from __future__ import annotations

import re
from typing import Any

import pytest
from peer_bench import drive
from peer_drives import (
    MICROSECOND,
    MILLISECOND,
    Acknowledgement,
    Bus,
    BusVariation,
    Frame,
    Library,
    PeerDrives,
)

ASK = b"t6018" + b"4018100100000000" + b"\r"
ANSWER = b"t5818" + b"43181001FB000000"
RATES = (10, 20, 50, 100, 125, 250, 500, 800, 1000)


@pytest.fixture(scope="module")
def library() -> Library:
    return Library()


def behind(library: Library, rate: int = 1_000_000, **settings: Any) -> PeerDrives:
    """A drive behind an adapter that is still closed."""
    bus = Bus(bit_rate=rate, adapter=True, variation=BusVariation(**settings))
    peer = PeerDrives(library, [bus], [drive()])
    peer.run(1 * MILLISECOND)
    return peer


def say(peer: PeerDrives, text: bytes) -> bytes:
    """What comes back within 20 ms."""
    peer.write(0, text)
    peer.wait(20 * MILLISECOND)
    return peer.read_all(0)


def opened(library: Library, **settings: Any) -> PeerDrives:
    peer = behind(library, **settings)
    say(peer, b"S8\rO\r")
    return peer


@pytest.mark.parametrize(
    ("command", "answer"),
    [
        (b"\r", b"\r"),
        (b"V\r", b"V1013\r"),
        (b"N\r", b"NP402\r"),
        (b"S6\r", b"\r"),
        (b"S8\rL\r", b"\r\r"),
        (b"O\r", b"\a"),  # no bit rate yet
        (b"S9\r", b"\a"),
        (b"S\r", b"\a"),
        (b"C\r", b"\a"),  # not open
        (b"F\r", b"\a"),  # not open
        (b"Z1\r", b"\r"),
        (b"M00000000\r", b"\r"),
        (b"t1230\r", b"\a"),  # not open
        (b"?\r", b"\a"),
    ],
)
def test_a_closed_adapter_answers_as_the_manual_of_lawicel_says(
    library: Library, command: bytes, answer: bytes
) -> None:
    assert say(behind(library), command) == answer


@pytest.mark.parametrize(
    ("command", "answer"),
    [
        (b"S8\r", b"\a"),
        (b"O\r", b"\a"),
        (b"Z1\r", b"\a"),
        (b"F\r", b"F00\r"),
        (b"C\r", b"\r"),
        (b"t1230\r", b"z\r"),
        (b"t12321122\r", b"z\r"),
        (b"T0000012380011223344556677\r", b"Z\r"),
        (b"r1234\r", b"z\r"),
        (b"R000001238\r", b"Z\r"),
        (b"t1239001122334455667788\r", b"\a"),  # length
        (b"t8000\r", b"\a"),  # identifier
        (b"T200000000\r", b"\a"),
        (b"t12321\r", b"\a"),  # too short
        (b"t1231112\r", b"\a"),  # too long
        (b"t12G0\r", b"\a"),
    ],
)
def test_an_open_adapter_answers_as_the_manual_of_lawicel_says(
    library: Library, command: bytes, answer: bytes
) -> None:
    peer = opened(library)
    assert say(peer, command) == answer


def test_frames_pass_both_ways(library: Library) -> None:
    peer = opened(library)
    assert say(peer, ASK) == b"z\r" + ANSWER + b"\r"


def test_a_closed_adapter_hears_nothing_and_the_boot_up_of_one_drive_waits_for_it(
    library: Library,
) -> None:
    peer = behind(library)
    peer.wait(100 * MILLISECOND)
    assert peer.read_all(0) == b""
    assert say(peer, b"S8\rO\r") == b"\r\r" + b"t701100\r"


@pytest.mark.parametrize("digit", range(9))
def test_each_bit_rate_has_its_digit_and_another_one_hears_nothing(
    library: Library, digit: int
) -> None:
    for rate in RATES:
        peer = behind(library, rate=rate * 1000)
        say(peer, b"S%d\rO\r" % digit)
        peer.wait(50 * MILLISECOND)
        answered = say(peer, ASK)
        peer.wait(200 * MILLISECOND)
        answered += peer.read_all(0)
        assert (ANSWER in answered) == (rate == RATES[digit])


def test_an_adapter_that_only_listens_sends_and_acknowledges_nothing(library: Library) -> None:
    peer = behind(library)
    assert say(peer, b"S8\rL\r" + ASK) == b"\r\r\a"


@pytest.mark.parametrize(
    ("settings", "answer"),
    [
        ({"acknowledgement": Acknowledgement.CR}, b"\r" + ANSWER + b"\r"),
        ({"acknowledgement": Acknowledgement.NONE}, ANSWER + b"\r"),
        ({"lower_case": True}, b"z\r" + ANSWER.replace(b"FB", b"fb") + b"\r"),
        ({"line_feed": True}, b"z\r\n" + ANSWER + b"\r\n"),
        ({"echo_frames": True}, b"z\r" + ASK + ANSWER + b"\r"),
    ],
)
def test_each_dialect_says_the_same_in_its_own_way(
    library: Library, settings: dict[str, Any], answer: bytes
) -> None:
    assert say(opened(library, **settings), ASK) == answer


def test_without_acknowledgements_nothing_is_refused_aloud_either(library: Library) -> None:
    peer = behind(library, acknowledgement=Acknowledgement.NONE)
    assert say(peer, b"O\rS9\rS8\rO\rt9\r") == b"t701100\r"


def test_time_stamps_are_milliseconds_of_a_minute(library: Library) -> None:
    peer = behind(library)
    say(peer, b"Z1\rS8\rO\r")
    peer.run(60_005 * MILLISECOND - 300 * MICROSECOND)
    assert say(peer, ASK) == b"z\r" + ANSWER + b"0004\r"
    forced = opened(library, timestamps=True)
    assert re.fullmatch(rb"z\r" + ANSWER + rb"[0-9A-F]{4}\r", say(forced, ASK))


def test_a_line_in_pieces_comes_whole_in_the_end(library: Library) -> None:
    peer = opened(library, pieces=True, piece_delay=300 * MICROSECOND)
    pieces = []
    for _ in range(50):
        peer.write(0, ASK)
        for _ in range(300):
            peer.wait(50 * MICROSECOND)
            while piece := peer.read(0):
                pieces.append(piece)
    text = b"".join(pieces)
    assert text.count(ANSWER + b"\r") == 50 == text.count(b"z\r")
    cuts = {len(piece) for piece in pieces}
    assert min(cuts) == 1 and len(cuts) > 5 and len(pieces) > 200


def test_stale_bytes_are_there_before_the_first_answer(library: Library) -> None:
    peer = behind(library, stale=True)
    text = say(peer, b"S8\r")
    assert text.endswith(b"t18\r") and text.count(b"\r") == 2 and not text.startswith(b"\r")


def test_the_line_takes_its_latency(library: Library) -> None:
    peer = opened(library, latency=2 * MILLISECOND)
    start = peer.now
    peer.write(0, b"F\r")
    assert peer.run_to_arrival(start + 10 * MILLISECOND) == start + 2 * MILLISECOND
    assert peer.read_all(0) == b"F00\r"


def test_commands_may_come_byte_by_byte_and_a_line_without_end_is_cut(library: Library) -> None:
    peer = opened(library)
    for byte in ASK:
        peer.write(0, bytes([byte]))
    peer.wait(5 * MILLISECOND)
    assert peer.read_all(0) == b"z\r" + ANSWER + b"\r"
    assert say(peer, b"t" * 5000 + b"\r") == b"\a"
    assert say(peer, ASK).endswith(ANSWER + b"\r")


def test_extended_and_remote_frames_of_others_have_their_letters(library: Library) -> None:
    peer = opened(library)
    peer.inject(0, Frame(0x1234567, b"\xab", extended=True))
    peer.inject(0, Frame(0x123, remote=True, length=4))
    peer.inject(0, Frame(0x89ABCDE, extended=True, remote=True, length=0))
    peer.wait(2 * MILLISECOND)
    assert peer.read_all(0) == b"T012345671AB\rr1234\rR089ABCDE0\r"
