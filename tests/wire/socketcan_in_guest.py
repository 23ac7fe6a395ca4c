"""The SocketCAN driver on a kernel that has CAN: run by test_socketcan.py inside the guest.

Not collected by itself: it needs vcan0 to vcan2, root, interfaces that it may take down, and a
serial port that nobody listens to.
"""

import ctypes
import fcntl
import os
import socket
import struct
import subprocess
import termios
import time
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path

import can
import pytest
from can_ports import CAN, ROOT, Filter, Frame, Result, Slcan, Socketcan, State, same
from running import BUSES, Running, running
from serial_line import SerialLine, connected

from turnbuckle.codegen.compile import compile_library
from turnbuckle.lab import lockstep
from turnbuckle.lab.live.program import compile_machine
from turnbuckle.places import RUNTIME

PATIENCE = 10.0
"""s, after which what did not come will not: the guest is slow."""
SERIAL_PORT = "/dev/ttyS1"
LINE_DISCIPLINE_SLCAN = 17
TIOCSETD = 0x5423
ERROR_FLAG = 0x20000000
CONTROLLER, BUS_OFF, RESTARTED, NO_ACKNOWLEDGE = 0x04, 0x40, 0x100, 0x20

FRAMES = [
    can.Message(arbitration_id=0x201, data=[15, 0, 232, 3], is_extended_id=False),
    can.Message(arbitration_id=0x7FF, data=range(8), is_extended_id=False),
    can.Message(arbitration_id=0, is_extended_id=False),
    can.Message(arbitration_id=0x1FFFFFFF, data=[1]),
    can.Message(arbitration_id=0x12345, is_remote_frame=True, dlc=4),
    can.Message(arbitration_id=0x701, is_remote_frame=True, is_extended_id=False),
]
FD_FRAMES = [
    can.Message(arbitration_id=0x123, data=range(length), is_fd=True, bitrate_switch=fast)
    for length in (0, 8, 12, 64)
    for fast in (False, True)
]


def ip(*arguments: str) -> None:
    """Set up an interface."""
    subprocess.run(["busybox", "ip", *arguments], check=True)


def arrived(port: Socketcan | Slcan, count: int) -> list[can.Message]:
    """The next frames at our port."""
    found: list[can.Message] = []
    end = time.monotonic() + PATIENCE
    while len(found) < count and time.monotonic() < end:
        found += port.waiting()
    return found


@pytest.fixture
def port() -> Iterator[Socketcan]:
    """Our port on vcan0."""
    made = Socketcan()
    assert made.open("vcan0") is Result.OK
    yield made
    made.close()


@pytest.fixture
def peer() -> Iterator[can.BusABC]:
    """python-can on vcan0."""
    with can.Bus(interface="socketcan", channel="vcan0", fd=True) as made:
        yield made


@pytest.fixture
def raw() -> Iterator[socket.socket]:
    """A raw socket on vcan0."""
    with socket.socket(socket.PF_CAN, socket.SOCK_RAW, socket.CAN_RAW) as made:
        made.bind(("vcan0",))
        yield made


def error_frame(kind: int, controller: int = 0) -> bytes:
    """What a CAN controller's driver tells about an error."""
    return struct.pack("=IB3x8B", ERROR_FLAG | kind, 8, 0, controller, *[0] * 6)


def test_python_can_receives_what_we_send(port: Socketcan, peer: can.BusABC) -> None:
    for message in FRAMES:
        assert port.send(message) is Result.OK
    for message in FRAMES:
        received = peer.recv(PATIENCE)
        assert received is not None and same(received, message)
    assert port.statistics.sent == len(FRAMES)


def test_we_receive_what_python_can_sends_and_nothing_of_our_own(
    port: Socketcan, peer: can.BusABC
) -> None:
    assert port.send(FRAMES[0]) is Result.OK
    for message in FRAMES:
        peer.send(message)
    received = arrived(port, len(FRAMES))
    assert all(same(one, other) for one, other in zip(received, FRAMES, strict=True))
    assert port.receive() is Result.EMPTY
    assert port.statistics.received == len(FRAMES)


def test_candump_and_cansend_agree(port: Socketcan) -> None:
    with subprocess.Popen(
        ["candump", "-n", "2", "-L", "vcan0"], stdout=subprocess.PIPE, text=True
    ) as dump:
        subprocess.run(["cansend", "vcan0", "181#1700112233445566"], check=True)
        (received,) = arrived(port, 1)
        assert received.data.hex() == "1700112233445566"
        end = time.monotonic() + PATIENCE
        while dump.poll() is None and time.monotonic() < end:
            port.send(FRAMES[0])
            time.sleep(0.1)
        assert dump.stdout is not None
        assert "201#0F00E803" in dump.stdout.read()


def test_fd_frames_cross_where_they_are_asked_for(peer: can.BusABC) -> None:
    port = Socketcan()
    assert port.open("vcan0", fd=True) is Result.OK
    for message in FD_FRAMES:
        assert port.send(message) is Result.OK
        peer.send(message)
    for message, received in zip(FD_FRAMES, arrived(port, len(FD_FRAMES)), strict=True):
        seen = peer.recv(PATIENCE)
        assert seen is not None and same(seen, message) and same(received, message)
    port.close()


def test_fd_frames_are_refused_and_not_seen_where_they_are_not(
    port: Socketcan, peer: can.BusABC
) -> None:
    assert port.send(FD_FRAMES[0]) is Result.REFUSED
    peer.send(FD_FRAMES[0])
    peer.send(FRAMES[0])
    (received,) = arrived(port, 1)
    assert same(received, FRAMES[0])


def test_an_interface_for_classic_frames_alone_is_refused_for_fd() -> None:
    ip("link", "set", "vcan1", "down")
    ip("link", "set", "vcan1", "mtu", "16", "up")
    port = Socketcan()
    assert port.open("vcan1", fd=True) is Result.REFUSED
    assert port.open("vcan1") is Result.OK
    port.close()


def test_what_is_no_frame_is_refused(port: Socketcan) -> None:
    assert port.send_frame(Frame(0x800, 0, 0)) is Result.REFUSED
    assert port.send_frame(Frame(1, 0, 9)) is Result.REFUSED


def test_filters_let_through_what_they_name(peer: can.BusABC) -> None:
    port = Socketcan()
    filters = [Filter(0x181, 0x7FF, False), Filter(0x580, 0x780, False), Filter(0x181, 0x1FF, True)]
    assert port.open("vcan0", filters) is Result.OK
    passing = [(0x181, False), (0x5FF, False), (0x581, False), (0x10181, True)]
    stopped = [(0x182, False), (0x201, False), (0x10182, True), (0x580, True)]
    for number, extended in [*stopped, *passing, *stopped]:
        peer.send(can.Message(arbitration_id=number, is_extended_id=extended))
    received = [(m.arbitration_id, m.is_extended_id) for m in arrived(port, len(passing))]
    assert received == passing
    assert port.receive() is Result.EMPTY
    assert Socketcan().open("vcan0", filters * 11) is Result.REFUSED
    port.close()


def test_hundreds_of_frames_are_received_in_order(port: Socketcan, peer: can.BusABC) -> None:
    for number in range(200):
        peer.send(can.Message(arbitration_id=number, is_extended_id=False))
    assert [m.arbitration_id for m in arrived(port, 200)] == list(range(200))
    assert port.statistics.lost == 0


def test_frames_that_the_kernel_had_no_room_for_are_counted_as_lost(
    port: Socketcan, raw: socket.socket
) -> None:
    sent = 2000
    for _ in range(sent):
        raw.send(struct.pack("=IB3x8B", 0x181, 8, *range(8)))
    received = sum(1 for _ in port.waiting())
    assert 0 < received < sent
    for _ in range(3):
        raw.send(struct.pack("=IB3x8B", 0x182, 8, *range(8)))
    assert len(arrived(port, 3)) == 3
    assert port.statistics.lost == sent - received


@pytest.mark.parametrize(
    ("kind", "controller", "state"),
    [
        (CONTROLLER, 0x04, State.ERROR_WARNING),
        (CONTROLLER, 0x08, State.ERROR_WARNING),
        (CONTROLLER, 0x10, State.ERROR_PASSIVE),
        (CONTROLLER, 0x2C, State.ERROR_PASSIVE),
        (BUS_OFF, 0, State.BUS_OFF),
        (BUS_OFF | CONTROLLER, 0x20, State.BUS_OFF),
        (NO_ACKNOWLEDGE, 0, State.ERROR_ACTIVE),
    ],
)
def test_error_frames_become_the_state_of_the_bus(
    port: Socketcan, raw: socket.socket, kind: int, controller: int, state: State
) -> None:
    raw.send(error_frame(kind, controller))
    assert port.receive() is Result.EMPTY
    assert port.state is state
    assert port.statistics.bus_errors == 1
    assert port.statistics.bus_off == (state is State.BUS_OFF)
    raw.send(error_frame(RESTARTED if kind & BUS_OFF else CONTROLLER, 0x40))
    assert port.receive() is Result.EMPTY
    assert port.state is State.ERROR_ACTIVE


def test_a_bus_that_is_off_takes_no_frame(
    port: Socketcan, raw: socket.socket, peer: can.BusABC
) -> None:
    raw.send(error_frame(BUS_OFF))
    assert port.receive() is Result.EMPTY
    assert port.send(FRAMES[0]) is Result.FULL
    assert port.statistics.refused == 1
    raw.send(error_frame(RESTARTED))
    assert port.receive() is Result.EMPTY
    assert port.send(FRAMES[1]) is Result.OK
    received = peer.recv(PATIENCE)
    while received is not None and received.is_error_frame:
        received = peer.recv(PATIENCE)
    assert received is not None and same(received, FRAMES[1])


def test_a_receive_buffer_that_ran_over_in_the_controller_is_a_loss(
    port: Socketcan, raw: socket.socket
) -> None:
    raw.send(error_frame(CONTROLLER, 0x01))
    assert port.receive() is Result.EMPTY
    assert port.statistics.lost == 1 and port.state is State.ERROR_ACTIVE


def test_error_frames_without_end_do_not_hold_up_a_cycle(
    port: Socketcan, raw: socket.socket
) -> None:
    for _ in range(100):
        raw.send(error_frame(NO_ACKNOWLEDGE))
    assert port.receive() is Result.EMPTY
    assert port.statistics.bus_errors == 4 * 16


@pytest.mark.parametrize("first", ["send", "receive"])
def test_an_interface_taken_down_is_lost_until_it_is_opened_again(
    port: Socketcan, first: str
) -> None:
    ip("link", "set", "vcan0", "down")
    try:
        if first == "send":
            assert port.send(FRAMES[0]) is Result.CLOSED
        assert port.receive() is Result.CLOSED
        assert port.state is State.NOT_OPEN
        assert Socketcan().open("vcan0") is Result.DOWN
    finally:
        ip("link", "set", "vcan0", "up")
    assert port.send(FRAMES[0]) is port.receive() is Result.CLOSED
    port.close()
    assert port.open("vcan0") is Result.OK


def test_an_interface_that_is_removed_is_lost() -> None:
    ip("link", "add", "vcan9", "type", "vcan")
    ip("link", "set", "vcan9", "up")
    port = Socketcan()
    assert port.open("vcan9") is Result.OK
    ip("link", "delete", "vcan9")
    assert port.send(FRAMES[0]) is Result.CLOSED
    assert port.receive() is Result.CLOSED
    assert port.open("vcan9") is Result.NO_DEVICE


def test_what_is_no_can_interface_is_told_apart() -> None:
    assert Socketcan().open("lo") is Result.NOT_CAN
    for name in ("can0", "", "no-such-interface-has-a-name-like-this", "vcan0vcan0vcan0v"):
        assert Socketcan().open(name) is Result.NO_DEVICE


class KernelSlcan:
    """An interface of the kernel's own slcan, on a serial line."""

    def __init__(self, line: SerialLine) -> None:
        before = set(os.listdir("/sys/class/net"))
        self._device = os.open(line.path, os.O_RDWR | os.O_NOCTTY)
        fcntl.ioctl(self._device, TIOCSETD, struct.pack("i", LINE_DISCIPLINE_SLCAN))
        (self.name,) = set(os.listdir("/sys/class/net")) - before
        ip("link", "set", self.name, "up")

    def close(self) -> None:
        """Give the line back; the interface goes."""
        os.close(self._device)


@pytest.fixture
def line() -> Iterator[SerialLine]:
    """A serial line."""
    with SerialLine() as made:
        yield made


@pytest.fixture
def behind(line: SerialLine) -> Iterator[KernelSlcan]:
    """An interface that is as slow as its serial line."""
    made = KernelSlcan(line)
    yield made
    made.close()


def test_frames_that_the_interface_does_not_take_are_refused_and_counted(
    line: SerialLine, behind: KernelSlcan
) -> None:
    port = Socketcan()
    assert port.open(behind.name) is Result.OK
    sent, end = 0, time.monotonic() + PATIENCE
    while port.statistics.refused < 50 and time.monotonic() < end:
        sent += port.send(FRAMES[0]) is Result.OK
    assert port.statistics.refused == 50
    assert port.statistics.sent == sent
    while port.send(FRAMES[0]) is Result.FULL and time.monotonic() < end:
        line.read()
    assert port.statistics.sent == sent + 1
    port.close()


def test_our_slcan_and_the_kernel_s_understand_each_other(
    line: SerialLine, behind: KernelSlcan
) -> None:
    with SerialLine() as ours, connected(line, ours):
        adapter, interface = Slcan(), Socketcan()
        assert adapter.open(ours.path) is Result.OK
        assert interface.open(behind.name) is Result.OK
        for message in FRAMES:
            assert adapter.send(message) is Result.OK
            assert interface.send(message) is Result.OK
        for port in (adapter, interface):
            received = arrived(port, len(FRAMES))
            assert all(same(one, other) for one, other in zip(received, FRAMES, strict=True))
        assert adapter.statistics.malformed == 0
        interface.close()
        adapter.close()


STOCK = ROOT / "generated" / "yoon2023"


@cache
def program() -> Path:
    """The executable of the stock machine."""
    return compile_machine(STOCK)


def await_that(run: Running, holds: Callable[[], bool]) -> None:
    """Wait until something is so."""
    end = time.monotonic() + 60
    while not holds():
        assert run.process.poll() is None, run.process.communicate()
        assert time.monotonic() < end, run.telemetry.status()["cause"]
        time.sleep(0.01)


def test_a_program_opens_an_interface_that_came_back_at_a_reset() -> None:
    pairs = zip(BUSES, ("vcan0", "vcan1", "vcan2"), strict=True)
    buses = [f"--bus={bus}=socketcan:{interface}" for bus, interface in pairs]

    def cause() -> str:
        text: str = run.telemetry.status()["cause"].decode()
        return text

    with running(program(), buses) as run:
        run.await_cycles(5)
        ip("link", "set", "vcan1", "down")
        run.await_state(lockstep.State.FAULT)
        await_that(run, lambda: cause().endswith("bring it back, then reset: that opens it again"))
        assert cause().startswith("bus cable2: ")
        run.telemetry.ask("reset")
        await_that(
            run, lambda: "socketcan:vcan1 cannot be opened again: the interface is" in cause()
        )
        ip("link", "set", "vcan1", "up")
        run.telemetry.ask("reset")
        await_that(run, lambda: "did not boot" in cause())
        assert [int(bus["state"]) for bus in run.telemetry.status()["buses"]] == [0, 0, 0]


@cache
def sealed_library() -> ctypes.CDLL:
    """The ports, and what a sealed program does with one at its end."""
    port = RUNTIME / "port" / "linux"
    own = [Path(__file__).with_name("sealed_close.c"), port / "seal.c", port / "say.c"]
    folders = [STOCK, CAN, RUNTIME / "core", port]
    return ctypes.CDLL(str(compile_library([*own, *sorted(CAN.glob("*.c"))], folders)))


def test_a_sealed_program_closes_a_serial_port_that_still_holds_bytes() -> None:
    watch = os.open(SERIAL_PORT, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    termios.tcflow(watch, termios.TCOOFF)
    port = Slcan()
    assert port.open(SERIAL_PORT) is Result.OK
    assert port.send(FRAMES[0]) is Result.OK
    assert waiting(watch) > 0
    child = os.fork()
    if child == 0:
        sealed_library().seal_and_close(port.memory)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    assert waiting(watch) == 0
    port.close()
    os.close(watch)


def waiting(device: int) -> int:
    """Bytes that a serial port has not sent yet."""
    (count,) = struct.unpack("i", fcntl.ioctl(device, termios.TIOCOUTQ, bytes(4)))
    return int(count)
