"""The slcan driver on a serial line: against python-can, against adapters, and when they fail."""

import os
import signal
import time
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import can
import pytest
from can.interfaces.slcan import slcanBus
from can_ports import Frame, Result, Slcan, State, same
from frames import any_frames
from hypothesis import given, settings
from hypothesis import strategies as st
from serial_line import Adapter, FarEnd, SerialLine, connected

PATIENCE = 5.0
"""s, after which what did not come will not."""
MOST_BYTES_A_CALL = 4 * 1024
"""That one call reads, frames or not."""
MESSAGE = can.Message(arbitration_id=0x201, data=[15, 0, 232, 3], is_extended_id=False)
LINE = b"t20140F00E803\r"
SILENT_ADAPTER = 0.4
"""s, that an adapter which says nothing is given at least to answer."""


@dataclass(frozen=True)
class Wire:
    """Our port and python-can, joined by a serial cable."""

    port: Slcan
    peer: slcanBus


def arrived(port: Slcan, count: int) -> list[can.Message]:
    """The next frames at our port."""
    found: list[can.Message] = []
    end = time.monotonic() + PATIENCE
    while len(found) < count and time.monotonic() < end:
        found += port.waiting()
    return found


@pytest.fixture(scope="module")
def wire() -> Iterator[Wire]:
    """An open port, and python-can's slcan bus at the other end."""
    with SerialLine() as ours, SerialLine() as theirs, connected(ours, theirs):
        port = Slcan()
        assert port.open(ours.path) is Result.OK
        with slcanBus(theirs.path, sleep_after_open=0) as peer:
            while peer.recv(0.05):
                pass
            yield Wire(port, peer)
        port.close()


@pytest.fixture
def line() -> Iterator[SerialLine]:
    """A serial line."""
    with SerialLine() as made:
        yield made


@pytest.fixture
def opened(line: SerialLine) -> Iterator[Slcan]:
    """A port whose far end says nothing but what the test lets it say."""
    port = Slcan()
    assert port.open(line.path) is Result.OK
    line.read()
    yield port
    port.close()


@settings(max_examples=60)
@given(messages=st.lists(any_frames(), min_size=1, max_size=20))
def test_python_can_receives_what_we_send(wire: Wire, messages: list[can.Message]) -> None:
    for message in messages:
        assert wire.port.send(message) is Result.OK
    for message in messages:
        received = wire.peer.recv(PATIENCE)
        assert received is not None and same(received, message)


@settings(max_examples=60)
@given(messages=st.lists(any_frames(), min_size=1, max_size=20))
def test_we_receive_what_python_can_sends(wire: Wire, messages: list[can.Message]) -> None:
    for message in messages:
        wire.peer.send(message)
    received = arrived(wire.port, len(messages))
    assert len(received) == len(messages)
    assert all(same(one, other) for one, other in zip(received, messages, strict=True))


def adapter_that(opens: SerialLine, stack: ExitStack, **answers: bytes) -> Adapter:
    """An adapter that acknowledges every command, but for those named."""
    named = {name.encode(): answer for name, answer in answers.items()}
    adapter = Adapter(opens, named, b"\r")
    stack.enter_context(FarEnd({opens: adapter}))
    return adapter


@pytest.mark.parametrize(
    ("bit_rate", "command"),
    [(10_000, b"S0"), (125_000, b"S4"), (500_000, b"S6"), (800_000, b"S7"), (1_000_000, b"S8")],
)
def test_opening_closes_the_bus_sets_the_bit_rate_and_opens_it(
    line: SerialLine, bit_rate: int, command: bytes
) -> None:
    with ExitStack() as stack:
        adapter = adapter_that(line, stack)
        port = Slcan()
        assert port.open(line.path, bit_rate) is Result.OK
        assert port.state is State.ERROR_ACTIVE and port.answers
        assert adapter.heard == [b"C", b"C", command, b"O"]
        port.close()
        assert port.send(MESSAGE) is Result.CLOSED


def test_closing_closes_the_bus_of_the_adapter(line: SerialLine, opened: Slcan) -> None:
    opened.close()
    opened.close()
    assert line.read(PATIENCE) == b"C\r"
    assert opened.receive() is Result.CLOSED


def test_an_adapter_that_says_nothing_is_taken_but_said_to_be_silent(opened: Slcan) -> None:
    assert opened.state is State.ERROR_ACTIVE
    assert not opened.answers


@pytest.mark.parametrize("end", [b"\r", b"\r\n", b"\n\r", b"\r\r\n"])
@pytest.mark.parametrize("word", [b"", b"z"])
def test_an_adapter_is_understood_however_it_acknowledges(
    line: SerialLine, end: bytes, word: bytes
) -> None:
    with FarEnd({line: Adapter(line, {}, word + end)}):
        port = Slcan()
        assert port.open(line.path) is Result.OK
        assert port.answers
        line.write(LINE[:-1] + end)
        assert len(arrived(port, 1)) == 1
        assert port.receive() is Result.EMPTY and port.statistics.malformed == 0
        port.close()


@pytest.mark.parametrize("answer", [b"\r\n", b"\a\n", b""])
def test_an_adapter_that_repeats_commands_is_judged_by_its_answer(
    line: SerialLine, answer: bytes
) -> None:
    with FarEnd({line: Adapter(line, {b"S": b"S8\r\n" + answer, b"O": b"O\r\n\r\n"}, b"C\r\n")}):
        port = Slcan()
        assert port.open(line.path) is (Result.BIT_RATE if b"\a" in answer else Result.OK)
        line.write(b"F\r\nt0000\r\nF\r\n")
        received = arrived(port, 1) if b"\a" not in answer else []
        assert len(received) == (b"\a" not in answer) and port.statistics.malformed == 0
        port.close()


def test_opening_step_by_step_never_waits_and_ends_as_opening_at_once_does(
    line: SerialLine,
) -> None:
    port, steps = Slcan(), 0
    result = port.begin(line.path)
    while result is Result.EMPTY:
        assert port.state is State.NOT_OPEN and port.send(MESSAGE) is Result.CLOSED
        result, steps = port.proceed(), steps + 1
    assert result is Result.OK and port.state is State.ERROR_ACTIVE
    assert steps > 100, "opening waited for the adapter"
    assert port.proceed() is Result.OK
    assert line.read() == b"C\rC\rS8\rO\r"
    port.close()


@pytest.mark.parametrize("heard", [b"C\rC\r", b"C\rC\rS8\r", b"C\rC\rS8\rO\r"])
def test_a_line_that_hangs_up_while_it_is_opened_is_closed(line: SerialLine, heard: bytes) -> None:
    port, text = Slcan(), b""
    result = port.begin(line.path)
    while text != heard and result is Result.EMPTY:
        result = port.proceed()
        text += line.read()
    line.hang_up()
    while result is Result.EMPTY:
        result = port.proceed()
    assert result is Result.CLOSED and port.state is State.NOT_OPEN
    assert held(line.path) == 1, "the port holds what has gone, beside the near end"


def held(path: str) -> int:
    """Descriptors of this process for a device."""
    files = Path("/proc/self/fd")
    links = [os.readlink(file) for file in files.iterdir() if file.is_symlink()]
    return sum(link.split()[0] == path for link in links)


def test_signals_do_not_shorten_the_wait_for_an_adapter(line: SerialLine) -> None:
    port = Slcan()
    before = signal.signal(signal.SIGALRM, lambda *_: None)
    signal.setitimer(signal.ITIMER_REAL, 0.002, 0.002)
    begin = time.monotonic()
    try:
        assert port.open(line.path) is Result.OK
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert time.monotonic() - begin > SILENT_ADAPTER
    port.close()


def test_frames_and_answers_of_before_do_not_disturb_opening(line: SerialLine) -> None:
    with ExitStack() as stack:
        adapter_that(line, stack, C=b"t10021122\rz\r\a", S=b"t1000\r\r")
        line.write(b"1122\r\a\at20100\r")
        port = Slcan()
        assert port.open(line.path) is Result.OK
        assert port.answers
        assert port.statistics.malformed == 0 and port.receive() is Result.EMPTY
        port.close()


@pytest.mark.parametrize(("command", "result"), [("S", Result.BIT_RATE), ("O", Result.REFUSED)])
def test_an_adapter_that_refuses_is_refused(line: SerialLine, command: str, result: Result) -> None:
    with ExitStack() as stack:
        adapter_that(line, stack, **{command: b"\a"})
        port = Slcan()
        assert port.open(line.path) is result
        assert port.state is State.NOT_OPEN


@pytest.mark.parametrize("bit_rate", [0, 83_300, 750_000, 2_000_000])
def test_a_bit_rate_that_the_dialect_lacks_is_refused(line: SerialLine, bit_rate: int) -> None:
    assert Slcan().open(line.path, bit_rate) is Result.BIT_RATE


def test_what_is_no_device_is_told_apart(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    assert Slcan().open(tmp_path / "missing") is Result.NO_DEVICE
    assert Slcan().open(tmp_path / "file" / "inside") is Result.NO_DEVICE
    assert Slcan().open(tmp_path / "file") is Result.NOT_CAN
    assert Slcan().open(tmp_path) is Result.NOT_CAN
    assert Slcan().open("/dev/null") is Result.NOT_CAN


def test_a_line_that_another_program_holds_is_busy(line: SerialLine, opened: Slcan) -> None:
    assert Slcan().open(line.path) is Result.BUSY
    assert opened.send(MESSAGE) is Result.OK
    opened.close()
    again = Slcan()
    assert again.open(line.path) is Result.OK
    again.close()


def opened_by_nobody(path: str) -> int:
    """What opening answers to a user without rights."""
    child = os.fork()
    if child == 0:
        os.setgroups([])
        os.setgid(65534)
        os.setuid(65534)
        os._exit(Slcan().open(path))
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def test_a_line_that_this_user_may_not_use_is_no_permission(line: SerialLine) -> None:
    os.chmod(line.path, 0o600)
    if os.geteuid() == 0:
        assert opened_by_nobody(line.path) == Result.NO_PERMISSION
    else:
        os.chmod(line.path, 0)
        assert Slcan().open(line.path) is Result.NO_PERMISSION


@pytest.mark.parametrize("first", ["send", "receive"])
def test_a_line_that_hangs_up_is_lost_until_it_is_opened_again(
    line: SerialLine, opened: Slcan, first: str
) -> None:
    line.hang_up()
    if first == "send":
        assert opened.send(MESSAGE) is Result.CLOSED
    assert opened.receive() is Result.CLOSED
    assert opened.send(MESSAGE) is Result.CLOSED
    assert opened.state is State.NOT_OPEN
    opened.close()
    assert Slcan().open(line.path) is not Result.OK


def test_frames_that_came_before_the_hang_up_are_not_lost(line: SerialLine, opened: Slcan) -> None:
    line.write(LINE * 3)
    assert len(arrived(opened, 3)) == 3
    line.hang_up()
    assert opened.receive() is Result.CLOSED


def test_a_line_that_nobody_reads_refuses_frames_and_never_breaks_one(
    line: SerialLine, opened: Slcan
) -> None:
    sent = 0
    while opened.send(MESSAGE) is Result.OK:
        sent += 1
    assert opened.send(MESSAGE) is Result.FULL
    assert opened.statistics.sent == sent and opened.statistics.refused == 2
    text = b""
    while part := line.read(0.1):
        text += part
    assert opened.send(MESSAGE) is Result.OK
    while part := line.read(0.1):
        text += part
    assert text == LINE * (sent + 1)


@pytest.mark.parametrize("end", [b"\r", b"\r\n", b"0F5a\r\n"])
def test_frames_are_read_however_the_line_cuts_them(
    line: SerialLine, opened: Slcan, end: bytes
) -> None:
    text = LINE[:-1] + end
    for place in range(1, len(text)):
        line.write(text + text[:place])
        found = arrived(opened, 1)
        found += opened.waiting()
        line.write(text[place:])
        assert len(found + arrived(opened, 2 - len(found))) == 2
    assert opened.receive() is Result.EMPTY and opened.statistics.malformed == 0


def test_hundreds_of_frames_are_read_at_once_and_in_order(line: SerialLine, opened: Slcan) -> None:
    line.write(b"".join(b"t%03X0\r" % number for number in range(600)))
    assert [message.arbitration_id for message in arrived(opened, 600)] == list(range(600))


def test_broken_lines_are_counted_and_skipped(line: SerialLine, opened: Slcan) -> None:
    line.write(b"t2\r" + LINE + b"noise\xff\x00\r" + LINE + b"t20140F\a" + LINE)
    assert len(arrived(opened, 3)) == 3
    assert opened.statistics.malformed == 3


@pytest.mark.parametrize("end", [b"\r\n", b"\n"])
def test_broken_lines_are_counted_once_each_whatever_ends_them(
    line: SerialLine, opened: Slcan, end: bytes
) -> None:
    line.write(end.join([b"t2", LINE[:-1], b"", b"noise\xff\x00", LINE[:-1], b"x" * 400, LINE]))
    assert len(arrived(opened, 3)) == 3
    assert opened.statistics.malformed == 3


def test_noise_without_an_end_of_a_line_is_counted(line: SerialLine, opened: Slcan) -> None:
    line.write(b"\xc3" * 1000)
    assert opened.receive() is Result.EMPTY
    assert opened.statistics.malformed == 1


def test_an_adapter_that_never_stops_talking_does_not_hold_up_a_cycle(
    line: SerialLine, opened: Slcan
) -> None:
    assert os.write(line.far_end, b"\r" * 60_000) > 2 * MOST_BYTES_A_CALL
    assert opened.receive() is Result.EMPTY
    assert line.waits_to_be_read(PATIENCE)


def test_trouble_that_the_adapter_reports_becomes_the_state_of_the_bus(
    line: SerialLine, opened: Slcan
) -> None:
    def after(answer: bytes) -> tuple[State, bytes]:
        line.write(answer)
        while opened.receive() is not Result.EMPTY:
            pass
        return opened.state, line.read(0.05)

    assert after(b"\a") == (State.ERROR_ACTIVE, b"F\r")
    assert after(b"\a\a") == (State.ERROR_ACTIVE, b"")
    assert after(b"F04\r") == (State.ERROR_WARNING, b"F\r")
    assert after(b"FA4\r") == (State.ERROR_PASSIVE, b"F\r")
    assert after(b"F09\r") == (State.ERROR_ACTIVE, b"")
    assert opened.statistics.refused == 3
    assert opened.statistics.bus_errors == 1 and opened.statistics.lost == 1


def test_what_is_no_frame_is_refused_and_not_written(line: SerialLine, opened: Slcan) -> None:
    assert opened.send_frame(Frame(0x800, 0, 0)) is Result.REFUSED
    assert line.read(0.05) == b""


def test_statistics_stop_at_their_largest_value(line: SerialLine, opened: Slcan) -> None:
    for name in ("sent", "received", "malformed"):
        setattr(opened.statistics, name, 2**32 - 1)
    opened.send(MESSAGE)
    line.write(b"x\r" + LINE)
    assert len(arrived(opened, 1)) == 1
    counted = opened.statistics
    assert counted.sent == counted.received == counted.malformed == 2**32 - 1
