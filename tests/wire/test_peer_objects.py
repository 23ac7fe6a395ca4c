"""Objects and SDO server of the drives by another hand, against CiA 301 and the EPOS4's table."""

from __future__ import annotations

import struct

import pytest
from peer_bench import Bench, Refused, bytes_of, drive, varied
from peer_drives import MILLISECOND, Library, Timing, Upload, Variation

TOGGLE, COMMAND = 0x05030000, 0x05040001
READ_ONLY, NO_OBJECT, NO_SUB = 0x06010002, 0x06020000, 0x06090011
LENGTH, TOO_LONG, TOO_SHORT = 0x06070010, 0x06070012, 0x06070013
RANGE, TOO_HIGH, TOO_LOW, STATE = 0x06090030, 0x06090031, 0x06090032, 0x08000022

NAME = b"Servo drive of the other hand"

# index, sub, bytes, writable, value after power on; from the table of an EPOS4 50/5.
TABLE = [
    (0x1000, 0, 4, False, 0x00020192),
    (0x1001, 0, 1, False, 0),
    (0x1003, 0, 1, True, 0),
    (0x1003, 5, 4, False, 0),
    (0x1005, 0, 4, False, 0x80),
    (0x1014, 0, 4, False, 0x81),
    (0x1016, 0, 1, False, 2),
    (0x1016, 1, 4, True, 0),
    (0x1016, 2, 4, True, 0),
    (0x1017, 0, 2, True, 0),
    (0x1018, 1, 4, False, 0xFB),
    (0x1018, 2, 4, False, 0x61500000),
    (0x1018, 3, 4, False, 0x01700000),
    (0x1029, 1, 1, True, 0),
    (0x1200, 1, 4, False, 0x601),
    (0x1200, 2, 4, False, 0x581),
    *((0x1400 + n, 1, 4, True, 0x201 + 0x100 * n) for n in range(4)),
    *((0x1400 + n, 2, 1, True, 255) for n in range(4)),
    *((0x1800 + n, 1, 4, True, 0x40000181 + 0x100 * n | bool(n) << 31) for n in range(4)),
    *((0x1800 + n, 2, 1, True, 255) for n in range(4)),
    *((0x1800 + n, 3, 2, True, 10) for n in range(4)),
    (0x1600, 1, 4, True, 0x60400010),
    (0x1603, 12, 4, True, 0),
    (0x1A00, 1, 4, True, 0x60410010),
    (0x2000, 0, 1, True, 1),
    (0x2001, 0, 1, True, 0),
    (0x2200, 1, 2, False, 480),
    *((0x3000, sub, 4, True, None) for sub in (1, 2, 3)),
    (0x3001, 1, 4, True, 3000),
    (0x3001, 2, 4, True, 6000),
    (0x3001, 3, 1, True, 1),
    (0x3001, 4, 2, True, 40),
    (0x3001, 5, 4, True, 30_000),
    (0x3002, 1, 4, True, None),
    (0x3002, 2, 2, True, None),
    (0x3010, 1, 4, True, 500),
    (0x30B0, 0, 4, True, 0),
    (0x30B1, 0, 4, True, 0),
    (0x30B2, 0, 2, True, 500),
    (0x30D0, 0, 4, False, 0),
    (0x30D1, 1, 4, False, 0),
    (0x30D1, 2, 4, False, 0),
    (0x30D2, 1, 2, False, 0),
    (0x30D3, 1, 4, False, 0),
    (0x3200, 1, 2, False, 0),
    (0x3200, 2, 2, False, 0),
    (0x3201, 1, 2, False, None),
    (0x3202, 1, 1, False, 3),
    (0x6007, 0, 2, True, 3),
    (0x603F, 0, 2, False, 0),
    (0x6040, 0, 2, True, 0),
    (0x6041, 0, 2, False, 0x0040),
    (0x605A, 0, 2, True, 6),
    (0x605B, 0, 2, True, 0),
    (0x605C, 0, 2, True, 1),
    (0x605E, 0, 2, True, 2),
    (0x6060, 0, 1, True, 1),
    (0x6061, 0, 1, False, 1),
    (0x6062, 0, 4, False, 0),
    (0x6064, 0, 4, False, 0),
    (0x6065, 0, 4, True, 2000),
    (0x6066, 0, 2, True, 0),
    (0x606B, 0, 4, False, 0),
    (0x606C, 0, 4, False, 0),
    (0x6071, 0, 2, True, 0),
    (0x6076, 0, 4, False, 90_000),  # 3000 mA * 30 000 uNm/A
    (0x6077, 0, 2, False, 0),
    (0x607A, 0, 4, True, 0),
    (0x607D, 1, 4, True, 0),
    (0x607D, 2, 4, True, 0),
    (0x607F, 0, 4, True, 50_000),
    (0x6080, 0, 4, True, 50_000),
    (0x6081, 0, 4, True, 1000),
    (0x6083, 0, 4, True, 10_000),
    (0x6084, 0, 4, True, 10_000),
    (0x6085, 0, 4, True, 10_000),
    (0x6098, 0, 1, True, 7),
    (0x6099, 1, 4, True, 100),
    (0x6099, 2, 4, True, 10),
    (0x609A, 0, 4, True, 1000),
    (0x60A8, 0, 4, False, 0x00B50000),
    (0x60A9, 0, 4, False, 0x00B44700),
    (0x60B0, 0, 4, True, 0),
    (0x60B1, 0, 4, True, 0),
    (0x60B2, 0, 2, True, 0),
    (0x60C2, 1, 1, True, 0),
    (0x60C2, 2, 1, True, -3),
    (0x60E3, 0, 1, False, 4),
    (0x60FD, 0, 4, False, 0),
    (0x60FE, 1, 4, True, 0),
    (0x6502, 0, 4, False, 0x3A5),
]
MISSING = (0x6072, 0x6073, 0x6075, 0x60E0, 0x60E1, 0x1006, 0x100C, 0x2345, 0x0005)


@pytest.fixture(scope="module")
def library() -> Library:
    return Library()


@pytest.fixture
def bench(library: Library) -> Bench:
    return Bench(library)


def asked(bench: Bench, command: int, index: int = 0, sub: int = 0, data: bytes = b"") -> bytes:
    return bench.request(struct.pack("<BHB", command, index, sub) + data)


def aborted(answer: bytes) -> int:
    assert answer[0] == 0x80
    return int.from_bytes(answer[4:], "little")


def refusal(bench: Bench, index: int, sub: int, value: int) -> int:
    with pytest.raises(Refused) as refused:
        bench.write(index, sub, value)
    return refused.value.code


def test_every_object_has_its_size_access_and_value(bench: Bench) -> None:
    for index, sub, size, writable, value in TABLE:
        answer = asked(bench, 0x40, index, sub)
        assert answer[0] == {1: 0x4F, 2: 0x4B, 4: 0x43}[size], f"{index:04X}:{sub}"
        signed = value is not None and value < 0
        read = int.from_bytes(answer[4 : 4 + size], "little", signed=signed)
        if value is not None:
            assert read == value, f"{index:04X}:{sub}"
        if not writable:
            again = asked(bench, 0x23 | 4 - size << 2, index, sub, answer[4:])
            assert aborted(again) == READ_ONLY, f"{index:04X}:{sub}"


def test_what_can_be_written_keeps_its_value(bench: Bench) -> None:
    for index, sub, value in [
        (0x1017, 0, 1234),
        (0x1016, 1, 0x7F0064),
        (0x1029, 1, 2),
        (0x3001, 1, 2500),
        (0x3001, 2, 5000),
        (0x30B0, 0, -123456),
        (0x30B2, 0, 777),
        (0x6007, 0, 1),
        (0x605A, 0, 2),
        (0x605B, 0, 1),
        (0x605C, 0, 0),
        (0x605E, 0, 1),
        (0x6060, 0, 8),
        (0x6065, 0, 0xFFFFFFFF - (1 << 32)),
        (0x6071, 0, -1000),
        (0x607A, 0, -(1 << 31)),
        (0x6085, 0, 5000),
        (0x6098, 0, -4),
        (0x6099, 1, 50),
        (0x609A, 0, 100),
    ]:
        bench.write(index, sub, value)
        assert bench.read(index, sub) == value, f"{index:04X}:{sub}"


def test_what_there_is_not_is_told_apart_from_a_missing_part(bench: Bench) -> None:
    for index in MISSING:
        assert aborted(asked(bench, 0x40, index, 0)) == NO_OBJECT
        assert aborted(asked(bench, 0x23, index, 0)) == NO_OBJECT
    for index, sub in ((0x1018, 5), (0x6040, 1), (0x1016, 3), (0x1600, 13)):
        assert aborted(asked(bench, 0x40, index, sub)) == NO_SUB
        assert aborted(asked(bench, 0x23, index, sub)) == NO_SUB


@pytest.mark.parametrize(
    ("index", "sub", "value", "code"),
    [
        (0x1029, 1, 3, TOO_HIGH),
        (0x6007, 0, 4, TOO_HIGH),
        (0x6007, 0, -1, TOO_LOW),
        (0x605A, 0, 3, RANGE),
        (0x6060, 0, 7, RANGE),
        (0x6060, 0, 0, TOO_LOW),
        (0x6060, 0, 11, TOO_HIGH),
        (0x6098, 0, 3, RANGE),
        (0x6098, 0, 38, TOO_HIGH),
        (0x60C2, 1, 101, TOO_HIGH),
        (0x1003, 0, 1, RANGE),
        (0x6085, 0, 0, TOO_LOW),
    ],
)
def test_values_out_of_range_are_refused_and_change_nothing(
    bench: Bench, index: int, sub: int, value: int, code: int
) -> None:
    before = bench.peer.object(0, index, sub)
    size = 1 if index in (0x60C2, 0x1003, 0x1029, 0x6060, 0x6098) else bytes_of(index, sub)
    data = (value & (1 << 8 * size) - 1).to_bytes(size, "little")
    assert aborted(asked(bench, 0x23 | 4 - size << 2, index, sub, data)) == code
    assert bench.peer.object(0, index, sub) == before


def test_a_download_of_another_length_is_refused(bench: Bench) -> None:
    assert aborted(asked(bench, 0x2F, 0x6040)) == TOO_SHORT
    assert aborted(asked(bench, 0x23, 0x6040)) == TOO_LONG
    assert aborted(asked(bench, 0x21, 0x6040, 0, struct.pack("<I", 3))) == TOO_LONG
    assert aborted(asked(bench, 0x27, 0x607A)) == TOO_SHORT


def test_a_download_without_its_size_takes_the_objects(bench: Bench) -> None:
    assert asked(bench, 0x22, 0x6071, 0, struct.pack("<hH", -5, 0xFFFF))[0] == 0x60
    assert bench.read(0x6071) == -5


def test_parameters_of_the_motor_stay_while_the_power_stage_is_on(library: Library) -> None:
    bench = Bench(library).enabled()
    assert refusal(bench, 0x3001, 5, 1) == STATE
    assert refusal(bench, 0x3000, 1, 1) == STATE
    bench.write(0x3001, 2, 100)
    bench.command(0)
    bench.write(0x3001, 5, 1000)


def test_the_rated_torque_follows_current_and_torque_constant(bench: Bench) -> None:
    bench.write(0x3001, 1, 5000)
    bench.write(0x3001, 5, 91_476)
    assert bench.read(0x6076) == 457_380  # as published for such a drive


def segments(bench: Bench) -> bytes:
    """An upload in progress to its end, as CiA 301 has it."""
    data, toggle = b"", 0
    while True:
        answer = asked(bench, 0x60 | toggle)
        assert answer[0] & 0xF0 == toggle and not answer[0] & 0xE0
        data += answer[1 : 8 - (answer[0] >> 1 & 7)]
        if answer[0] & 1:
            return data
        toggle ^= 0x10


def test_the_name_comes_in_segments(bench: Bench) -> None:
    assert asked(bench, 0x40, 0x1008) == struct.pack("<BHBI", 0x41, 0x1008, 0, len(NAME))
    assert segments(bench) == NAME


def test_a_segmented_download_sets_its_object(bench: Bench) -> None:
    for sized in (True, False):
        value = -77 - sized
        begin = struct.pack("<I", 4) if sized else b""
        assert asked(bench, 0x20 | sized, 0x607A, 0, begin)[0] == 0x60
        first, second = struct.pack("<i", value)[:3], struct.pack("<i", value)[3:]
        assert bench.request(bytes([0 << 4 | 4 << 1]) + first) == bytes([0x20]) + bytes(7)
        assert bench.peer.object(0, 0x607A) != value, "not before it is whole"
        assert bench.request(bytes([1 << 4 | 6 << 1 | 1]) + second) == bytes([0x30]) + bytes(7)
        assert bench.read(0x607A) == value


def test_a_wrong_toggle_bit_ends_the_transfer(bench: Bench) -> None:
    for first in (0x70, 0x60):
        asked(bench, 0x40, 0x1008)
        if first == 0x60:
            asked(bench, 0x60)
        answer = asked(bench, first)
        assert aborted(answer) == TOGGLE and answer[1:4] == b"\x08\x10\x00"
        assert aborted(asked(bench, 0x70)) == COMMAND, "it is over"
    asked(bench, 0x21, 0x607A, 0, struct.pack("<I", 4))
    assert aborted(bench.request(bytes([0x10 | 3 << 1 | 1, 1, 2, 3, 4]))) == TOGGLE
    assert bench.read(0x607A) == 0


def test_a_download_that_is_not_as_long_as_announced_is_refused(bench: Bench) -> None:
    asked(bench, 0x21, 0x607A, 0, struct.pack("<I", 4))
    assert aborted(bench.request(bytes([4 << 1 | 1, 1, 2, 3]))) == LENGTH
    asked(bench, 0x20, 0x607A)
    assert aborted(bench.request(bytes([2 << 1 | 1, 1, 2, 3, 4, 5]))) == TOO_LONG
    assert bench.read(0x607A) == 0


def test_segments_without_a_transfer_and_unknown_commands_are_refused(bench: Bench) -> None:
    for command in (0x00, 0x60, 0xA0, 0xC0, 0xE0):
        assert aborted(asked(bench, command, 0x6040)) == COMMAND


def test_an_abort_of_the_master_ends_the_transfer_without_an_answer(bench: Bench) -> None:
    asked(bench, 0x40, 0x1008)
    count = len(bench.frames(0x581))
    bench.send(0x601, struct.pack("<BHBI", 0x80, 0x1008, 0, 0x05040000))
    bench.wait(5)
    assert len(bench.frames(0x581)) == count
    assert aborted(asked(bench, 0x60)) == COMMAND


def test_a_request_of_another_length_or_in_stopped_is_not_answered(bench: Bench) -> None:
    count = len(bench.frames(0x581))
    bench.send(0x601, b"\x40\x00\x10\x00")
    bench.wait(5)
    bench.nmt(0x02)
    bench.send(0x601, b"\x40\x00\x10\x00\0\0\0\0")
    bench.wait(5)
    assert len(bench.frames(0x581)) == count


def test_stored_values_come_back_with_a_reset_and_factory_ones_after_a_restore(
    bench: Bench,
) -> None:
    bench.write(0x1017, 0, 500)
    bench.write(0x6098, 0, -4)
    assert aborted(asked(bench, 0x23, 0x1010, 1, b"evas")) == 0x08000020
    asked(bench, 0x23, 0x1010, 1, b"save")
    bench.write(0x6098, 0, 37)
    bench.write(0x1017, 0, 0)
    bench.nmt(0x82)
    bench.wait(20)
    assert (bench.read(0x1017), bench.read(0x6098)) == (500, 37), "only communication is reset"
    bench.nmt(0x81)
    bench.wait(20)
    assert bench.read(0x6098) == -4
    asked(bench, 0x23, 0x1011, 1, b"load")
    assert bench.read(0x6098) == -4
    bench.nmt(0x81)
    bench.wait(20)
    assert (bench.read(0x1017), bench.read(0x6098)) == (0, 7)


@pytest.mark.parametrize(
    ("form", "command", "rest"),
    [
        (Upload.EXACT, 0x4B, b"\xee\xee"),
        (Upload.NO_SIZE, 0x42, b"\xee\xee"),
        (Upload.PADDED, 0x43, b"\0\0"),
    ],
)
def test_an_upload_can_be_answered_in_each_expedited_form(
    library: Library, form: Upload, command: int, rest: bytes
) -> None:
    bench = Bench(library, [varied(upload=form, fill=0xEE)])
    answer = asked(bench, 0x40, 0x1017)
    assert answer == struct.pack("<BHBH", command, 0x1017, 0, 0) + rest


@pytest.mark.parametrize("most", [0, 1, 3])
def test_an_upload_can_be_answered_in_segments_with_and_without_the_size(
    library: Library, most: int
) -> None:
    for form, head in (
        (Upload.SEGMENTED, struct.pack("<BHBI", 0x41, 0x1018, 1, 4)),
        (Upload.SEGMENTED_NO_SIZE, struct.pack("<BHBI", 0x40, 0x1018, 1, 0)),
    ):
        bench = Bench(library, [varied(upload=form, segment_bytes=most)])
        assert asked(bench, 0x40, 0x1018, 1) == head
        count = len(bench.frames(0x581))
        assert segments(bench) == struct.pack("<I", 0xFB)
        assert len(bench.frames(0x581)) - count == {0: 1, 1: 4, 3: 2}[most]


def test_answers_take_up_to_the_delay_given_and_the_worst_takes_all_of_it(
    library: Library,
) -> None:
    def delays(worst: bool) -> list[int]:
        timing = Timing(sdo_delay=10 * MILLISECOND, worst=worst, seed=3)
        bench = Bench(library, timing=timing)
        found = []
        for _ in range(40):
            start = bench.peer.now
            asked(bench, 0x40, 0x1000)
            found.append(bench.heard[-1][0] - start)
        return found

    spread = delays(False)
    assert min(spread) < 2 * MILLISECOND and 8 * MILLISECOND < max(spread) < 11 * MILLISECOND
    assert set(delays(True)) == {10 * MILLISECOND + (132 + 132) * 1000}


def test_requests_that_come_meanwhile_are_answered_in_their_order(library: Library) -> None:
    bench = Bench(library, timing=Timing(sdo_delay=5 * MILLISECOND, worst=True))
    for sub in (1, 2, 3):
        bench.send(0x601, struct.pack("<BHBI", 0x40, 0x1018, sub, 0))
    bench.wait(20)
    assert [frame.data[3] for frame in bench.frames(0x581)] == [1, 2, 3]


def test_an_illegal_drive_can_be_had_for_each_refusal(library: Library) -> None:
    def one(**settings: object) -> Bench:
        return Bench(library, [varied(**settings)])

    assert Bench(library, [drive(vendor=0x2F)]).read(0x1018, 1) == 0x2F
    assert one(rated_torque=12345).read(0x6076) == 12345
    wrong = one(misread_index=0x6085, misread_xor=4)
    wrong.write(0x6085, 0, 8)
    assert wrong.read(0x6085) == 12 and wrong.peer.object(0, 0x6085) == 8
    refusing = one(abort_index=0x6065, abort_code=0x08000000)
    assert refusal(refusing, 0x6065, 0, 1) == 0x08000000
    assert aborted(asked(refusing, 0x40, 0x6065)) == 0x08000000
    assert one(mode_display=-128).read(0x6061) == -128
    assert one(status_forced=0x0029).read(0x6041) == 0x0029
    toggling = one(toggle_error=True)
    asked(toggling, 0x40, 0x1008)
    assert asked(toggling, 0x60)[0] & 0x10
    silent = Bench(library, [drive(), drive(node=2, variation=Variation(missing=True))])
    assert len(silent.frames(0x701)) == 1 and silent.frames(0x702) == []
