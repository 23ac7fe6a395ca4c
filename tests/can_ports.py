"""The CAN ports of the runtime, called from Python; frames as messages of python-can."""

import ctypes
from collections.abc import Iterator, Sequence
from enum import IntEnum
from functools import cache
from pathlib import Path

import can

from turnbuckle.codegen.compile import compile_library

ROOT = Path(__file__).parents[1]
CAN = ROOT / "runtime" / "can"

EXTENDED, REMOTE, FD, BIT_RATE_SWITCH = 1, 2, 4, 8


class Result(IntEnum):
    """tb_can_result."""

    OK = 0
    EMPTY = 1
    FULL = 2
    CLOSED = 3
    REFUSED = 4
    NO_DEVICE = 5
    NO_PERMISSION = 6
    BUSY = 7
    NOT_CAN = 8
    DOWN = 9
    BIT_RATE = 10
    UNSUPPORTED = 11


class State(IntEnum):
    """tb_can_state."""

    ERROR_ACTIVE = 0
    ERROR_WARNING = 1
    ERROR_PASSIVE = 2
    BUS_OFF = 3
    NOT_OPEN = 4


class Frame(ctypes.Structure):
    """tb_can_frame."""

    _fields_ = (
        ("id", ctypes.c_uint32),
        ("flags", ctypes.c_uint8),
        ("length", ctypes.c_uint8),
        ("data", ctypes.c_uint8 * 64),
    )


class Statistics(ctypes.Structure):
    """tb_can_statistics."""

    _fields_ = (
        *((name, ctypes.c_uint32) for name in ("sent", "received", "refused", "lost")),
        *((name, ctypes.c_uint32) for name in ("malformed", "bus_errors", "bus_off")),
        ("bits", ctypes.c_uint64),
    )


class PortHead(ctypes.Structure):
    """tb_can_port: the beginning of every driver's struct."""

    _fields_ = (("driver", ctypes.c_void_p), ("statistics", Statistics))


class Filter(ctypes.Structure):
    """tb_can_filter."""

    _fields_ = (("id", ctypes.c_uint32), ("mask", ctypes.c_uint32), ("extended", ctypes.c_bool))


class SocketcanOptions(ctypes.Structure):
    """tb_socketcan_options."""

    _fields_ = (
        ("filters", ctypes.POINTER(Filter)),
        ("count", ctypes.c_uint32),
        ("fd", ctypes.c_bool),
    )


@cache
def library(most_data: int = 64) -> ctypes.CDLL:
    """All ports, compiled with room for so many bytes in a frame."""
    sources = [*sorted(CAN.glob("*.c")), Path(__file__).with_name("can_ports.c")]
    compiled = compile_library(sources, [CAN], defines=[f"TB_CAN_MOST_DATA={most_data}u"])
    loaded = ctypes.CDLL(str(compiled))
    loaded.tb_can_result_text.restype = ctypes.c_char_p
    loaded.tb_can_is_frame.restype = ctypes.c_bool
    loaded.slcan_answers.restype = ctypes.c_bool
    return loaded


def frame_of(message: can.Message) -> Frame:
    """A message of python-can as the runtime's frame."""
    flags = EXTENDED * message.is_extended_id + REMOTE * message.is_remote_frame
    flags += FD * message.is_fd + BIT_RATE_SWITCH * message.bitrate_switch
    frame = Frame(message.arbitration_id, flags, message.dlc)
    ctypes.memmove(frame.data, bytes(message.data), len(message.data))
    return frame


def message_of(frame: Frame) -> can.Message:
    """The runtime's frame as a message of python-can."""
    remote = bool(frame.flags & REMOTE)
    return can.Message(
        arbitration_id=frame.id,
        is_extended_id=bool(frame.flags & EXTENDED),
        is_remote_frame=remote,
        is_fd=bool(frame.flags & FD),
        bitrate_switch=bool(frame.flags & BIT_RATE_SWITCH),
        dlc=frame.length,
        data=None if remote else bytes(frame.data[: frame.length]),
        check=True,
    )


def same(one: can.Message, other: can.Message) -> bool:
    """Whether two messages are one frame, whenever and wherever they were seen."""
    return one.equals(other, timestamp_delta=None, check_channel=False, check_direction=False)


class Port:
    """A port of any driver; its memory is that of the C struct and nothing else."""

    def __init__(self, size: int) -> None:
        self.memory = (ctypes.c_uint64 * ((size + 7) // 8))()
        self._call = library()

    @property
    def statistics(self) -> Statistics:
        """The counters of the port: a view, not a copy."""
        statistics: Statistics = PortHead.from_buffer(self.memory).statistics
        return statistics

    @property
    def state(self) -> State:
        """How the bus is."""
        return State(self._call.port_state(self.memory))

    def send(self, message: can.Message) -> Result:
        """Send a frame."""
        return self.send_frame(frame_of(message))

    def send_frame(self, frame: Frame) -> Result:
        """Send a frame that may be none."""
        return Result(self._call.port_send(self.memory, ctypes.byref(frame)))

    def receive(self) -> can.Message | Result:
        """The frame that has waited longest, or why there is none."""
        frame = Frame()
        result = Result(self._call.port_receive(self.memory, ctypes.byref(frame)))
        return message_of(frame) if result is Result.OK else result

    def waiting(self) -> Iterator[can.Message]:
        """All frames that wait."""
        while isinstance(message := self.receive(), can.Message):
            yield message

    def close(self) -> None:
        """Give the device back."""
        self._call.port_close(self.memory)


class Loopback(Port):
    """A bus in memory."""

    def __init__(self) -> None:
        super().__init__(library().size_of_loopback())
        self._call.tb_loopback_open(self.memory)

    def take(self) -> can.Message | Result:
        """Peer: the frame that was sent first."""
        frame = Frame()
        result = Result(self._call.tb_loopback_take(self.memory, ctypes.byref(frame)))
        return message_of(frame) if result is Result.OK else result

    def give(self, message: can.Message) -> Result:
        """Peer: let a frame arrive."""
        return Result(self._call.tb_loopback_give(self.memory, ctypes.byref(frame_of(message))))

    def set_state(self, state: State) -> None:
        """Fault: bring the bus into a state."""
        self._call.tb_loopback_set_state(self.memory, state)

    def set_full(self, full: bool) -> None:
        """Fault: refuse every frame."""
        self._call.tb_loopback_set_full(self.memory, full)


class Slcan(Port):
    """A bus behind an adapter on a serial line."""

    def __init__(self) -> None:
        super().__init__(library().size_of_slcan())

    def open(self, path: str | Path, bit_rate: int = 1_000_000) -> Result:
        """Open the adapter; bit rate in bit/s."""
        return Result(self._call.tb_slcan_open(self.memory, str(path).encode(), bit_rate))

    def begin(self, path: str | Path, bit_rate: int = 1_000_000) -> Result:
        """Begin to open the adapter, without waiting; EMPTY: it is under way."""
        return Result(self._call.tb_slcan_begin(self.memory, str(path).encode(), bit_rate))

    def proceed(self) -> Result:
        """Go on with it."""
        return Result(self._call.tb_slcan_proceed(self.memory))

    @property
    def answers(self) -> bool:
        """Whether the adapter acknowledged commands."""
        return bool(self._call.slcan_answers(self.memory))


class Socketcan(Port):
    """An interface of the kernel."""

    def __init__(self) -> None:
        super().__init__(library().size_of_socketcan())

    def open(self, name: str, filters: Sequence[Filter] = (), fd: bool = False) -> Result:
        """Open the interface."""
        options = SocketcanOptions((Filter * len(filters))(*filters), len(filters), fd)
        answer = self._call.tb_socketcan_open(self.memory, name.encode(), ctypes.byref(options))
        return Result(answer)
