"""Lines of slcan: written as python-can writes them, read however they are cut and broken."""

import ctypes
from collections.abc import Iterator
from enum import IntEnum

import can
import pytest
from can_ports import FD, Frame, frame_of, library, message_of, same
from frames import any_frames
from hypothesis import given
from hypothesis import strategies as st

LONGEST = 143


class Item(IntEnum):
    """tb_slcan_item."""

    NOTHING = 0
    FRAME = 1
    DONE = 2
    FAILED = 3
    STATUS = 4
    ECHO = 5
    MALFORMED = 6


class Reader:
    """tb_slcan_reader, with the memory behind it watched."""

    def __init__(self, most_data: int = 64) -> None:
        self._library = library(most_data)
        self._size = self._library.size_of_reader()
        self._memory = (ctypes.c_uint8 * (self._size + 64))(*[0xA5] * (self._size + 64))
        self._library.tb_slcan_start(self._memory)

    def items(self, characters: bytes) -> Iterator[tuple[Item, can.Message | None]]:
        """What the characters complete, in order."""
        for character in characters:
            frame = Frame()
            item = Item(self._library.tb_slcan_read(self._memory, character, ctypes.byref(frame)))
            if item is not Item.NOTHING:
                yield item, message_of(frame) if item is Item.FRAME else None
        assert bytes(self._memory[self._size :]) == b"\xa5" * 64

    @property
    def status(self) -> int:
        """The adapter's status: the last byte that is used."""
        return int(self._memory[LONGEST + 1])


def line_of(message: can.Message) -> bytes:
    line = ctypes.create_string_buffer(LONGEST)
    length = library().tb_slcan_write(ctypes.byref(frame_of(message)), line)
    return line.raw[:length]


def only_item(characters: bytes) -> Item:
    ((item, _),) = Reader().items(characters)
    return item


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (b"t0801AB\r", can.Message(arbitration_id=0x80, data=[0xAB], is_extended_id=False)),
        (b"T1FFFFFFF0\r", can.Message(arbitration_id=0x1FFFFFFF)),
        (
            b"r7FF8\r",
            can.Message(arbitration_id=0x7FF, is_remote_frame=True, dlc=8, is_extended_id=False),
        ),
        (b"R000000010\r", can.Message(arbitration_id=1, is_remote_frame=True)),
        (
            b"d1239" + b"5A" * 12 + b"\r",
            can.Message(arbitration_id=0x123, data=[0x5A] * 12, is_fd=True, is_extended_id=False),
        ),
        (
            b"B00000123F" + b"00" * 64 + b"\r",
            can.Message(arbitration_id=0x123, data=[0] * 64, is_fd=True, bitrate_switch=True),
        ),
    ],
)
def test_a_frame_is_the_line_that_the_dialect_says(line: bytes, message: can.Message) -> None:
    assert line_of(message) == line
    ((item, read),) = Reader().items(line.lower().replace(line[:1].lower(), line[:1], 1))
    assert item is Item.FRAME and read is not None and same(read, message)


@given(
    st.lists(any_frames(), max_size=8),
    st.sampled_from([b"", b"0F5a"]),
    st.sampled_from([b"\r", b"\r\n", b"\n", b"\r\n\n"]),
)
def test_what_is_written_is_read_with_any_stamp_and_end_of_line(
    messages: list[can.Message], stamp: bytes, end: bytes
) -> None:
    text = b"".join(line_of(message)[:-1] + stamp + end for message in messages)
    read = list(Reader().items(text))
    assert [item for item, _ in read] == [Item.FRAME] * len(messages)
    for (_, found), message in zip(read, messages, strict=True):
        assert found is not None and same(found, message)


@given(any_frames(), st.data())
def test_a_line_with_any_one_character_changed_is_malformed_or_a_frame(
    message: can.Message, data: st.DataObject
) -> None:
    line = bytearray(line_of(message)[:-1])
    place = data.draw(st.integers(0, len(line) - 1))
    line[place] = data.draw(st.integers(0, 255).filter(lambda code: code not in b"\r\n\a"))
    assert only_item(bytes(line) + b"\r") in (Item.FRAME, Item.MALFORMED)


@given(any_frames(), st.data())
def test_a_line_that_is_cut_is_never_a_frame(message: can.Message, data: st.DataObject) -> None:
    line = line_of(message)[:-1]
    cut = line[: data.draw(st.integers(1, len(line) - 1))]
    assert only_item(cut + b"\r") is Item.MALFORMED


@given(st.binary(max_size=400))
def test_a_line_feed_behind_every_line_changes_nothing(noise: bytes) -> None:
    fed = noise.replace(b"\r", b"\r\n").replace(b"\a", b"\a\n")
    plain, with_feeds = ([item for item, _ in Reader().items(text)] for text in (noise, fed))
    assert plain == with_feeds


def test_a_line_without_an_end_is_malformed_at_once_and_again_now_and_then() -> None:
    reader = Reader()
    found = [list(reader.items(b"x" * length)) for length in (LONGEST, 1, 16_383, 1, 16_384)]
    malformed = [(Item.MALFORMED, None)]
    assert found == [[], malformed, [], malformed, malformed]
    assert list(reader.items(b"\rz\r")) == [(Item.DONE, None)]


@given(st.binary(max_size=400), any_frames())
def test_whatever_came_before_the_next_line_is_read(noise: bytes, message: can.Message) -> None:
    *_, (item, read) = Reader().items(noise + b"\r" + line_of(message))
    assert item is Item.FRAME and read is not None and same(read, message)


@pytest.mark.parametrize(
    ("characters", "item"),
    [
        (b"\r", Item.DONE),
        (b"z\r", Item.DONE),
        (b"Z\r", Item.DONE),
        (b"\r\n", Item.DONE),
        (b"\nz\r\n", Item.DONE),
        (b"Z\n", Item.DONE),
        (b"\a", Item.FAILED),
        (b"\a\n", Item.FAILED),
        (b"S8\r", Item.ECHO),
        (b"C\r\n", Item.ECHO),
        (b"O\n", Item.ECHO),
        (b"F\r", Item.ECHO),
        (b"S9\r", Item.MALFORMED),
        (b"CC\r", Item.MALFORMED),
        (b"C\a", Item.MALFORMED),
        (b"z \r", Item.MALFORMED),
        (b"F24\r", Item.STATUS),
        (b"F2\r", Item.MALFORMED),
        (b"F123\r", Item.MALFORMED),
        (b"zz\r", Item.MALFORMED),
        (b"V1013\r", Item.MALFORMED),
        (b"t8000\r", Item.MALFORMED),
        (b"T200000000\r", Item.MALFORMED),
        (b"t0019\r", Item.MALFORMED),
        (b"t0011AB1\r", Item.MALFORMED),
        (b"r001200\r", Item.MALFORMED),
        (b"t0010\a", Item.MALFORMED),
        (b"t" + b"0" * LONGEST + b"\r", Item.MALFORMED),
        (b"x" * 10_000 + b"\r", Item.MALFORMED),
    ],
)
def test_answers_and_broken_lines_are_told_apart(characters: bytes, item: Item) -> None:
    assert only_item(characters) is item


def test_the_status_is_kept_until_the_next() -> None:
    reader = Reader()
    for characters, status in ((b"F24\r", 0x24), (b"F\r", 0x24), (b"FfF\r", 0xFF), (b"F00\r", 0)):
        list(reader.items(characters))
        assert reader.status == status


def test_what_is_no_frame_is_no_line() -> None:
    line = ctypes.create_string_buffer(LONGEST)
    assert library().tb_slcan_write(ctypes.byref(Frame(0x800, 0, 0)), line) == 0


@pytest.mark.parametrize("code", "9ABCDEF")
def test_a_frame_that_does_not_fit_is_malformed_and_the_next_is_read(code: str) -> None:
    data = library().tb_can_length_of_code(int(code, 16)) * b"5A"
    reader, classic = Reader(most_data=8), b"t1238" + b"5A" * 8 + b"\r"
    items = [item for item, _ in reader.items(b"d123" + code.encode() + data + b"\r" + classic)]
    assert items == [Item.MALFORMED, Item.FRAME]
    ((item, message),) = reader.items(b"d1238" + b"5A" * 8 + b"\r")
    assert item is Item.FRAME and message is not None and message.is_fd
    frame, line = Frame(0x123, FD, 12), ctypes.create_string_buffer(LONGEST)
    assert library(8).tb_slcan_write(ctypes.byref(frame), line) == 0
