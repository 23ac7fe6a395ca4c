"""The SDO client against python canopen's server, and against servers that misbehave."""

import struct
from collections.abc import Iterator
from ctypes import byref, c_uint8, c_void_p
from typing import Any

import canopen
import pytest
from canopen.objectdictionary import datatypes
from canopen_c import Frame, canopen_c, read
from canopen_peer import UNSIGNED, Change, Wire, dictionary, variable
from hypothesis import given
from hypothesis import strategies as st

C = canopen_c()
NODE, TIMEOUT = 5, 20
MOST_OWED = 255
"""Late answers that a client still expects."""
TEXT, NUMBER, READ_ONLY, WRITE_ONLY, RECORD = 0x2000, 0x2001, 0x2002, 0x2003, 0x2004
ABORT_TOGGLE, ABORT_TIMEOUT, ABORT_COMMAND = 0x05030000, 0x05040000, 0x05040001
ABORT_MEMORY, ABORT_LENGTH, ABORT_GENERAL = 0x05040005, 0x06070010, 0x08000000
ANY_BYTES = st.binary(min_size=1, max_size=200)


def as_it_is(frame: Frame) -> Frame:
    """A wire without a fault."""
    return frame


class Server:
    """A node with an SDO server, and our client of it."""

    def __init__(self) -> None:
        objects = dictionary(
            variable(TEXT, 0, datatypes.DOMAIN),
            variable(NUMBER, 0, datatypes.UNSIGNED16),
            variable(READ_ONLY, 0, datatypes.UNSIGNED8, "ro"),
            variable(WRITE_ONLY, 0, datatypes.UNSIGNED8, "wo"),
            *(variable(RECORD, sub, UNSIGNED[size]) for sub, size in ((1, 1), (2, 2), (3, 4))),
        )
        self.node, self.wire = canopen.LocalNode(NODE, objects), Wire()
        self.wire.add_node(self.node)
        self.client = C.new("tb_sdo_client")
        self.requests: list[Frame] = []
        self._kept: Any = None
        C.tb_sdo_start(byref(self.client), NODE, TIMEOUT)

    def begin_download(self, index: int, subindex: int, data: bytes) -> None:
        """Begin to write."""
        self._kept = (c_uint8 * max(len(data), 1))(*data)
        C.tb_sdo_download(byref(self.client), index, subindex, self._kept, len(data))

    def begin_upload(self, index: int, subindex: int, room: int) -> None:
        """Begin to read; two bytes beyond the room watch over it."""
        self._kept = (c_uint8 * (room + 2))(*bytes(room), 0xA5, 0x5A)
        C.tb_sdo_upload(byref(self.client), index, subindex, self._kept, room)

    def download(self, index: int, subindex: int, data: bytes, change: Change = as_it_is) -> str:
        """Write an object: the name of the result."""
        self.begin_download(index, subindex, data)
        return self.run(change)

    def upload(
        self, index: int, subindex: int, room: int = 300, change: Change = as_it_is
    ) -> tuple[str, bytes]:
        """Read an object: the name of the result, and the bytes."""
        self.begin_upload(index, subindex, room)
        result = self.run(change)
        assert bytes(self._kept[room:]) == b"\xa5\x5a", "written beyond its room"
        return result, bytes(self._kept[: self.client.done])

    def request(self) -> Frame | None:
        """The next frame of the client."""
        frame = C.new("tb_can_frame")
        if not C.tb_sdo_frame(byref(self.client), byref(frame)):
            return None
        self.requests.append(read(frame))
        return self.requests[-1]

    def answer(self, frame: Frame) -> bool:
        """A frame for the client."""
        return bool(C.tb_sdo_take(byref(self.client), byref(C.frame(frame))))

    def run(self, change: Change = as_it_is) -> str:
        """To the end; `change` makes of every answer what reaches the client."""
        while (frame := self.request()) is not None:
            self.wire.give(frame)
            for one in map(change, self.wire.take()):
                assert one is None or self.answer(one)
        return self.result

    @property
    def result(self) -> str:
        """Where the transfer is."""
        results = ["IDLE", "BUSY", "DONE", "REFUSED", "BROKEN", "SILENT"]
        return next(n for n in results if getattr(C, f"TB_SDO_{n}") == self.client.result)

    def aborted_with(self) -> int:
        """The abort code that was sent last."""
        assert self.requests[-1].data[0] == 0x80
        code: int = struct.unpack("<I", self.requests[-1].data[4:])[0]
        assert self.node.sdo.last_received_error == code
        return code


@pytest.fixture
def server() -> Server:
    """A server and a client of it."""
    return Server()


def answers(*frames: bytes) -> Iterator[Frame]:
    """Frames of the server."""
    return (Frame(0x580 + NODE, frame.ljust(8, b"\0")) for frame in frames)


# ---- Transfers ----


@given(st.binary(max_size=200))
def test_bytes_of_any_length_are_written(data: bytes) -> None:
    server = Server()
    assert server.download(TEXT, 0, data) == "DONE"
    assert server.node.data_store[TEXT][0] == data
    assert server.client.done == len(data)
    segments = 0 if 1 <= len(data) <= 4 else max(-(-len(data) // 7), 1)
    assert len(server.requests) == 1 + segments


@given(ANY_BYTES)
def test_bytes_of_any_length_are_read(data: bytes) -> None:
    server = Server()
    server.node.data_store[TEXT] = {0: data}
    assert server.upload(TEXT, 0) == ("DONE", data)


@given(ANY_BYTES)
def test_an_object_that_just_fits_is_read(data: bytes) -> None:
    server = Server()
    server.node.data_store[TEXT] = {0: data}
    assert server.upload(TEXT, 0, room=len(data)) == ("DONE", data)


@given(ANY_BYTES)
def test_an_object_of_a_length_that_the_server_does_not_tell_is_read(data: bytes) -> None:
    server, first = Server(), True

    def untold(frame: Frame) -> Frame:
        nonlocal first
        changed, first = first, False
        return Frame(frame.id, bytes([0x40]) + frame.data[1:4] + bytes(4)) if changed else frame

    server.node.data_store[TEXT] = {0: data}
    result = server.upload(TEXT, 0, change=untold if len(data) > 4 else as_it_is)
    assert result == ("DONE", data)


@pytest.mark.parametrize(("subindex", "size"), [(1, 1), (2, 2), (3, 4)])
def test_numbers_go_in_one_frame_each_way(server: Server, subindex: int, size: int) -> None:
    data = bytes(range(1, size + 1))
    assert server.download(RECORD, subindex, data) == "DONE"
    assert server.upload(RECORD, subindex, room=4) == ("DONE", data)
    commands = {1: 0x2F, 2: 0x2B, 4: 0x23}
    assert [frame.data[0] for frame in server.requests] == [commands[size], 0x40]
    assert {frame.id for frame in server.requests} == {0x600 + NODE}


def test_an_expedited_answer_without_a_size_holds_four_bytes(server: Server) -> None:
    server.begin_upload(TEXT, 0, 4)
    server.request()
    for frame in answers(b"\x42\x00\x20\x00abcd"):
        server.answer(frame)
    assert (server.result, server.client.done, server.client.sized) == ("DONE", 4, 0)


@pytest.mark.parametrize(
    ("first", "last", "size", "sized"),
    [
        (b"\x41\x00\x20\x00\x02", 0x0B, 2, 1),  # told twice
        (b"\x41\x00\x20\x00\x02", 0x01, 2, 1),  # told at first, the segment does not
        (b"\x40\x00\x20\x00", 0x0B, 2, 1),  # the segment alone tells
        (b"\x40\x00\x20\x00", 0x01, 7, 0),  # nobody tells
    ],
)
def test_a_short_object_in_segments_has_the_size_that_is_told(
    server: Server, first: bytes, last: int, size: int, sized: int
) -> None:
    server.begin_upload(TEXT, 0, 8)
    for frame in answers(first, bytes([last]) + b"abcdefg"):
        server.request()
        server.answer(frame)
    assert (server.result, server.client.done, server.client.sized) == ("DONE", size, sized)
    assert bytes(server._kept[:size]) == b"abcdefg"[:size]


# ---- Aborts and time-outs ----


@pytest.mark.parametrize(
    ("index", "subindex", "code"),
    [(0x3000, 0, 0x06020000), (RECORD, 9, 0x06090011), (WRITE_ONLY, 0, 0x06010001)],
)
def test_an_abort_of_a_read_tells_its_code(
    server: Server, index: int, subindex: int, code: int
) -> None:
    assert server.upload(index, subindex)[0] == "REFUSED"
    assert server.client.code == code


@pytest.mark.parametrize(
    ("index", "subindex", "data", "code"),
    [
        (0x3000, 0, b"\1", 0x06020000),
        (READ_ONLY, 0, b"\1", 0x06010002),
        (NUMBER, 0, b"\1", 0x06070010),
        (NUMBER, 0, b"123456789", 0x06070010),
    ],
)
def test_an_abort_of_a_write_tells_its_code(
    server: Server, index: int, subindex: int, data: bytes, code: int
) -> None:
    assert server.download(index, subindex, data) == "REFUSED"
    assert server.client.code == code


@pytest.mark.parametrize("answered", [0, 1, 2, 3])
def test_a_server_that_falls_silent_is_given_up_in_time(server: Server, answered: int) -> None:
    left = answered

    def falls_silent(frame: Frame) -> Frame | None:
        nonlocal left
        left -= 1
        return frame if left >= 0 else None

    assert server.download(TEXT, 0, bytes(30), falls_silent) == "BUSY"
    for _ in range(TIMEOUT):
        C.tb_sdo_tick(byref(server.client))
        assert (server.result, server.request()) == ("BUSY", None)
    C.tb_sdo_tick(byref(server.client))
    assert server.result == "SILENT"
    server.run()
    assert server.aborted_with() == ABORT_TIMEOUT


def test_every_answer_starts_the_time_anew(server: Server) -> None:
    server.begin_download(TEXT, 0, bytes(70))
    while (request := server.request()) is not None:
        for _ in range(TIMEOUT):
            C.tb_sdo_tick(byref(server.client))
        server.wire.give(request)
        for frame in server.wire.take():
            server.answer(frame)
    assert server.result == "DONE"


def test_a_request_that_never_gets_its_turn_is_given_up_too(server: Server) -> None:
    server.begin_upload(TEXT, 0, 4)
    for _ in range(TIMEOUT + 1):
        C.tb_sdo_tick(byref(server.client))
    assert server.result == "SILENT"


# ---- Servers that misbehave ----


def spoiled(number: int, byte: int, flip: int) -> Change:
    """Flips bits in a byte of one of the answers."""
    count = -1

    def change(frame: Frame) -> Frame:
        nonlocal count
        count += 1
        data = bytearray(frame.data)
        if count == number:
            data[byte] ^= flip
        return Frame(frame.id, bytes(data))

    return change


@pytest.mark.parametrize("segment", [1, 2, 3])
@pytest.mark.parametrize("way", ["download", "upload"])
def test_a_toggle_bit_that_does_not_alternate_is_an_error(
    server: Server, way: str, segment: int
) -> None:
    change = spoiled(segment, 0, 0x10)
    if way == "download":
        assert server.download(TEXT, 0, bytes(28), change) == "BROKEN"
    else:
        server.node.data_store[TEXT] = {0: bytes(28)}
        assert server.upload(TEXT, 0, change=change)[0] == "BROKEN"
    assert server.aborted_with() == server.client.code == ABORT_TOGGLE


@pytest.mark.parametrize("byte", [1, 2, 3])
@pytest.mark.parametrize("size", [4, 20])
def test_an_answer_about_another_object_is_an_error(server: Server, byte: int, size: int) -> None:
    assert server.download(TEXT, 0, bytes(size), spoiled(0, byte, 0x01)) == "BROKEN"
    assert server.aborted_with() == ABORT_GENERAL


@pytest.mark.parametrize(
    ("answer", "flip"), [(0, 0x20), (0, 0x40), (0, 0xA0), (1, 0x20), (1, 0x40), (1, 0xE0)]
)
def test_an_answer_of_another_kind_is_an_error(server: Server, answer: int, flip: int) -> None:
    assert server.download(TEXT, 0, bytes(20), spoiled(answer, 0, flip)) == "BROKEN"
    assert server.aborted_with() == ABORT_COMMAND


@pytest.mark.parametrize("told", [26, 28, 21, 20, 34])
def test_a_length_that_was_not_kept_is_an_error(server: Server, told: int) -> None:
    server.node.data_store[TEXT] = {0: bytes(27)}
    assert server.upload(TEXT, 0, change=spoiled(0, 4, 27 ^ told))[0] == "BROKEN"
    assert server.aborted_with() == ABORT_LENGTH


@pytest.mark.parametrize(("size", "room"), [(4, 3), (28, 27), (28, 4)])
def test_an_object_that_does_not_fit_is_refused(server: Server, size: int, room: int) -> None:
    server.node.data_store[TEXT] = {0: bytes(size)}
    assert server.upload(TEXT, 0, room=room)[0] == "BROKEN"
    assert server.aborted_with() == ABORT_MEMORY


def test_an_object_of_untold_length_that_does_not_fit_is_refused(server: Server) -> None:
    server.node.data_store[TEXT] = {0: bytes(28)}
    assert server.upload(TEXT, 0, room=27, change=spoiled(0, 0, 0x01))[0] == "BROKEN"
    assert server.aborted_with() == ABORT_MEMORY


def test_segments_without_data_do_not_go_on_for_ever(server: Server) -> None:
    server.begin_upload(TEXT, 0, 28)
    server.request()
    for frame in answers(b"\x40\x00\x20\x00", b"\x0e"):
        server.answer(frame)
        server.request()
    assert server.result == "BROKEN"


@pytest.mark.parametrize("length", [0, 4, 7])
def test_an_answer_of_another_length_is_malformed_and_ignored(server: Server, length: int) -> None:
    server.begin_upload(NUMBER, 0, 4)
    server.request()
    assert not server.answer(Frame(0x580 + NODE, bytes(length)))
    assert server.result == "BUSY"


@given(st.lists(st.binary(min_size=8, max_size=8), max_size=20), st.booleans(), st.integers(0, 40))
def test_no_answer_leads_beyond_the_room_or_out_of_the_protocol(
    frames: list[bytes], reads: bool, size: int
) -> None:
    server = Server()
    if reads:
        server.begin_upload(TEXT, 0, size)
    else:
        server.begin_download(TEXT, 0, bytes(size))
    for frame in answers(*frames):
        server.request()
        server.answer(frame)
        assert server.client.done <= size
        assert not reads or bytes(server._kept[size:]) == b"\xa5\x5a"


# ---- Two servers with one number ----


def test_a_second_answer_to_one_request_is_counted(server: Server) -> None:
    server.begin_download(NUMBER, 0, b"\1\2")
    server.wire.give(server.request() or Frame(0, b""))
    (frame,) = server.wire.take()
    assert server.answer(frame) and server.answer(frame)
    assert (server.result, server.client.extra) == ("DONE", 1)


def test_a_second_answer_is_known_though_the_next_request_is_out(server: Server) -> None:
    server.begin_download(NUMBER, 0, b"\1\2")
    server.wire.give(server.request() or Frame(0, b""))
    (late,) = server.wire.take()
    server.answer(late)
    server.begin_upload(NUMBER, 0, 4)
    request = server.request()
    assert server.answer(late)
    assert (server.result, server.client.extra) == ("BUSY", 1)
    server.wire.give(request or Frame(0, b""))
    server.answer(server.wire.take()[0])
    assert (server.result, server.client.extra) == ("DONE", 1)


def test_the_late_answer_to_a_transfer_that_was_given_up_is_no_second_drive(
    server: Server,
) -> None:
    server.begin_upload(NUMBER, 0, 4)
    server.request()
    C.tb_sdo_cancel(byref(server.client))
    server.begin_upload(RECORD, 1, 4)
    assert (server.request() or Frame(0, b"")).data[0] == 0x80  # the abort goes first
    server.request()
    for frame in answers(b"\x4b\x01\x20\x00\1\2", b"\x4f\x04\x20\x01\7"):
        server.answer(frame)
    assert (server.result, server.client.extra) == ("DONE", 0)
    for frame in answers(b"\x4f\x04\x20\x01\7"):
        server.answer(frame)
    assert server.client.extra == 1


@pytest.mark.parametrize("late", [1, 2, MOST_OWED])
def test_late_answers_to_requests_that_were_repeated_are_no_second_drive(
    server: Server, late: int
) -> None:
    for _ in range(late):
        server.begin_upload(NUMBER, 0, 4)
        while server.request() is not None:
            pass
        for _ in range(TIMEOUT + 1):
            C.tb_sdo_tick(byref(server.client))
    server.begin_upload(NUMBER, 0, 4)
    while server.request() is not None:
        pass
    for frame in answers(*[b"\x4b\x01\x20\x00\1\2"] * (late + 1)):
        server.answer(frame)
    assert (server.result, server.client.extra) == ("DONE", 0)
    for frame in answers(b"\x4b\x01\x20\x00\1\2"):
        server.answer(frame)
    assert server.client.extra == 1


def test_more_late_answers_than_are_counted_are_no_second_drive(server: Server) -> None:
    for _ in range(MOST_OWED + 1):
        server.begin_upload(NUMBER, 0, 4)
        while server.request() is not None:
            pass
        C.tb_sdo_cancel(byref(server.client))
    server.begin_upload(NUMBER, 0, 4)
    while server.request() is not None:
        pass
    for frame in answers(*[b"\x4b\x01\x20\x00\1\2"] * (MOST_OWED + 1)):
        server.answer(frame)
    assert (server.result, server.client.extra) == ("DONE", 0)


def test_a_transfer_that_was_not_begun_owes_no_answer(server: Server) -> None:
    server.begin_upload(NUMBER, 0, 4)
    C.tb_sdo_cancel(byref(server.client))
    assert server.request() is None
    for frame in answers(b"\x4b\x01\x20\x00\1\2"):
        server.answer(frame)
    assert server.client.extra == 1


# ---- Words ----

EPOS4 = c_void_p(C.variable("tb_drives")[0].kind)
OF_EPOS4 = (0x06010003, 0x06010004, 0x0F00FFBE, 0x0F00FFBF, 0x0F00FFC0)
ABORT_CODES = [*canopen.SdoAbortedError.CODES, *OF_EPOS4]


def test_every_abort_code_has_words_of_its_own() -> None:
    words = [C.text("tb_drive_kind_abort_text", EPOS4, code) for code in ABORT_CODES]
    assert len(set(words)) == len(ABORT_CODES)
    assert "unknown abort code" not in words


def test_a_code_nobody_described_is_unknown() -> None:
    assert C.text("tb_drive_kind_abort_text", EPOS4, 0x12345678) == "unknown abort code"
    assert {C.text("tb_sdo_abort_text", code) for code in OF_EPOS4} == {"unknown abort code"}
