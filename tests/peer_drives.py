"""Drives by another hand (wire/peer_drives/peer_drives.h is the manual), compiled and bound.

Times are nanoseconds; all else has the units of the header. What is left out is zero, as there.
"""

from __future__ import annotations

import ctypes
import enum
import hashlib
import os
import subprocess
import tempfile
from collections.abc import Sequence
from ctypes import POINTER, Structure, byref, c_bool, c_double, c_int32, c_int64, c_size_t
from ctypes import c_uint8 as u8
from ctypes import c_uint16 as u16
from ctypes import c_uint32 as u32
from ctypes import c_uint64 as u64
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

SOURCES = Path(__file__).parent / "wire" / "peer_drives"
BUILD = Path(__file__).parents[1] / "build" / "peer_drives"
FLAGS = ("-std=c11", "-O2", "-Wall", "-Wextra", "-Werror", "-fPIC", "-shared")

MICROSECOND = 1_000
MILLISECOND = 1_000_000
SECOND = 1_000_000_000


class Upload(enum.IntEnum):
    EXACT, NO_SIZE, PADDED, SEGMENTED, SEGMENTED_NO_SIZE = range(5)


class EncoderFault(enum.IntEnum):
    GOOD, REVERSED, FROZEN, JUMP, SLIP, SCALED = range(6)


class TorqueFault(enum.IntEnum):
    GOOD, NOT_GIVEN, DOUBLED = range(3)


class Acknowledgement(enum.IntEnum):
    Z, CR, NONE = range(3)


class Nmt(enum.IntEnum):
    INITIALISING = 0x00
    STOPPED = 0x04
    OPERATIONAL = 0x05
    PRE_OPERATIONAL = 0x7F


class Power(enum.IntEnum):
    NOT_READY = 0
    SWITCH_ON_DISABLED = 1
    READY = 2
    SWITCHED_ON = 3
    OPERATION_ENABLED = 4
    QUICK_STOP = 5
    FAULT_REACTION = 6
    FAULT = 7


class RawFrame(Structure):
    _fields_: ClassVar[Any] = [
        ("id", u32),
        ("length", u8),
        ("extended", c_bool),
        ("remote", c_bool),
        ("data", u8 * 8),
    ]


class Variation(Structure):
    _fields_: ClassVar[Any] = [
        ("upload", u32),
        ("segment_bytes", u32),
        ("fill", u32),
        ("restarts", u32),
        ("restart_after", c_int64),
        ("heartbeat_percent", u32),
        ("status_set", u32),
        ("status_toggle", u32),
        ("burst_period", c_int64),
        ("burst_count", u32),
        ("inhibit_jitter", c_int64),
        ("any_order", c_bool),
        ("transition_delay", c_int64),
        ("reaction_is_command", c_bool),
        ("rated_torque", u32),
        ("misread_index", u32),
        ("misread_sub", u32),
        ("misread_xor", u32),
        ("remote_clear", c_bool),
        ("missing", c_bool),
        ("toggle_error", c_bool),
        ("abort_index", u32),
        ("abort_sub", u32),
        ("abort_code", u32),
        ("mode_display", c_int32),
        ("status_forced", u32),
        ("encoder", u32),
        ("encoder_value", c_double),
        ("torque", u32),
        ("torque_hidden", c_bool),
    ]


class Drive(Structure):
    variation: Variation
    _fields_: ClassVar[Any] = [
        ("bus", u32),
        ("node", u32),
        ("counts_per_turn", u32),
        ("nominal_current", u32),
        ("current_limit", u32),
        ("torque_constant", u32),
        ("vendor", u32),
        ("product", u32),
        ("revision", u32),
        ("serial", u32),
        ("initial_count", c_int32),
        ("rotor_inertia", c_double),
        ("tuned_inertia", c_double),
        ("friction", c_double),
        ("stop_low", c_double),
        ("stop_high", c_double),
        ("boot_delay", c_int64),
        ("variation", Variation),
    ]


class BusVariation(Structure):
    _fields_: ClassVar[Any] = [
        ("acknowledgement", u32),
        ("lower_case", c_bool),
        ("line_feed", c_bool),
        ("timestamps", c_bool),
        ("pieces", c_bool),
        ("piece_delay", c_int64),
        ("stale", c_bool),
        ("echo_frames", c_bool),
        ("latency", c_int64),
        ("echo_sync", c_bool),
        ("time_period", c_int64),
        ("foreign_period", c_int64),
        ("foreign_node", u32),
        ("foreign_state", u32),
    ]


class Bus(Structure):
    variation: BusVariation
    _fields_: ClassVar[Any] = [
        ("bit_rate", u32),
        ("adapter", c_bool),
        ("variation", BusVariation),
    ]


class Timing(Structure):
    _fields_: ClassVar[Any] = [
        ("answer_delay", c_int64),
        ("sdo_delay", c_int64),
        ("setpoint_deadline", c_int64),
        ("seed", u64),
        ("worst", c_bool),
    ]


class Config(Structure):
    _fields_: ClassVar[Any] = [
        ("bus_count", u32),
        ("drive_count", u32),
        ("buses", POINTER(Bus)),
        ("drives", POINTER(Drive)),
        ("timing", Timing),
    ]


class Counters(Structure):
    syncs: int
    setpoints: int
    late: int
    doubled: int
    lost: int
    latest_setpoint: int
    short_pdos: int
    heartbeats: int
    last_heartbeat: int
    last_sync: int
    dropped: int
    transitions: int
    _fields_: ClassVar[Any] = [
        ("syncs", u64),
        ("setpoints", u64),
        ("late", u64),
        ("doubled", u64),
        ("lost", u64),
        ("latest_setpoint", c_int64),
        ("short_pdos", u64),
        ("heartbeats", u64),
        ("last_heartbeat", c_int64),
        ("last_sync", c_int64),
        ("dropped", u64),
        ("transitions", u32),
    ]


class BusCounters(Structure):
    frames: int
    busy: int
    collisions: int
    overflows: int
    _fields_: ClassVar[Any] = [
        ("frames", u64),
        ("busy", c_int64),
        ("collisions", u64),
        ("overflows", u64),
    ]


@dataclass(frozen=True)
class Frame:
    """A frame; of a remote one, `length` is the length asked for."""

    id: int
    data: bytes = b""
    extended: bool = False
    remote: bool = False
    length: int | None = None

    def raw(self) -> RawFrame:
        length = len(self.data) if self.length is None else self.length
        return RawFrame(
            self.id, length, self.extended, self.remote, (u8 * 8)(*self.data.ljust(8, b"\0")[:8])
        )


def frame_of(raw: RawFrame) -> Frame:
    data = b"" if raw.remote else bytes(raw.data[: raw.length])
    return Frame(raw.id, data, raw.extended, raw.remote, raw.length if raw.remote else None)


def sources() -> list[Path]:
    """The C files of the drives, in order."""
    return sorted(SOURCES.glob("*.c"))


def compiled() -> Path:
    """The shared library of the drives; compiled when its sources are others than before."""
    digest = hashlib.sha256(" ".join(FLAGS).encode())
    for path in sorted(SOURCES.glob("*.[ch]")):
        digest.update(path.name.encode() + path.read_bytes())
    library = BUILD / f"{digest.hexdigest()[:16]}.so"
    if not library.exists():
        BUILD.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=BUILD) as scratch:
            fresh = Path(scratch) / "peer.so"
            command = ["gcc", *FLAGS, "-o", str(fresh), *map(str, sources()), "-lm"]
            subprocess.run(command, check=True)
            os.replace(fresh, library)
    return library


SIGNATURES: dict[str, tuple[Any, list[Any]]] = {
    "peer_new": (ctypes.c_void_p, [POINTER(Config)]),
    "peer_free": (None, [ctypes.c_void_p]),
    "peer_run": (c_int64, [ctypes.c_void_p, c_int64]),
    "peer_run_to_arrival": (c_int64, [ctypes.c_void_p, c_int64]),
    "peer_send": (c_bool, [ctypes.c_void_p, u32, c_int64, POINTER(RawFrame)]),
    "peer_inject": (c_bool, [ctypes.c_void_p, u32, c_int64, POINTER(RawFrame)]),
    "peer_receive": (c_bool, [ctypes.c_void_p, u32, POINTER(RawFrame), POINTER(c_int64)]),
    "peer_write": (None, [ctypes.c_void_p, u32, ctypes.c_char_p, c_size_t]),
    "peer_read": (c_size_t, [ctypes.c_void_p, u32, ctypes.c_char_p, c_size_t]),
    "peer_torque": (c_double, [ctypes.c_void_p, u32]),
    "peer_turn": (None, [ctypes.c_void_p, u32, c_int64, c_double]),
    "peer_angle": (c_double, [ctypes.c_void_p, u32]),
    "peer_vary": (None, [ctypes.c_void_p, u32, POINTER(Variation)]),
    "peer_vary_bus": (None, [ctypes.c_void_p, u32, POINTER(BusVariation)]),
    "peer_raise": (None, [ctypes.c_void_p, u32, u16]),
    "peer_nmt_state": (u32, [ctypes.c_void_p, u32]),
    "peer_power_state": (u32, [ctypes.c_void_p, u32]),
    "peer_object": (c_bool, [ctypes.c_void_p, u32, u16, u8, POINTER(c_int64)]),
    "peer_counted": (Counters, [ctypes.c_void_p, u32]),
    "peer_bus_counted": (BusCounters, [ctypes.c_void_p, u32]),
    "peer_waiting": (c_size_t, [ctypes.c_void_p, u32]),
    "peer_frame_bits": (u32, [POINTER(RawFrame)]),
    "peer_frame_bits_worst": (u32, [POINTER(RawFrame)]),
    "peer_frame_crc": (u16, [POINTER(RawFrame)]),
}


class Library:
    """The compiled drives; from another shared library those with a defect seeded."""

    def __init__(self, shared: Path | None = None) -> None:
        self.c = ctypes.CDLL(str(shared or compiled()))
        for name, (result, arguments) in SIGNATURES.items():
            function = getattr(self.c, name)
            function.restype = result
            function.argtypes = arguments

    def bits(self, frame: Frame) -> int:
        """Bits on the wire, the 3 between frames included."""
        return int(self.c.peer_frame_bits(byref(frame.raw())))

    def bits_worst(self, frame: Frame) -> int:
        """The most that a frame of this kind and length can take."""
        return int(self.c.peer_frame_bits_worst(byref(frame.raw())))

    def crc(self, frame: Frame) -> int:
        """The check sequence, 15 bits."""
        return int(self.c.peer_frame_crc(byref(frame.raw())))


class PeerDrives:
    """Drives on their buses, switched on at time 0."""

    def __init__(
        self,
        library: Library,
        buses: Sequence[Bus],
        drives: Sequence[Drive],
        timing: Timing | None = None,
    ) -> None:
        """Raises ValueError for a configuration outside the ranges of the header."""
        self.c = library.c
        self.now = 0
        config = Config(
            len(buses),
            len(drives),
            (Bus * len(buses))(*buses),
            (Drive * len(drives))(*drives),
            timing or Timing(),
        )
        self.handle = self.c.peer_new(byref(config))
        if not self.handle:
            raise ValueError("no such drives or buses")

    def __del__(self) -> None:
        self.c.peer_free(self.handle)

    def run(self, until: int) -> int:
        """Lets time pass; the time reached."""
        self.now = int(self.c.peer_run(self.handle, until))
        return self.now

    def wait(self, duration: int) -> int:
        """The same from now."""
        return self.run(self.now + duration)

    def run_to_arrival(self, until: int) -> int:
        """The same, no further than to where the master has something to fetch."""
        self.now = int(self.c.peer_run_to_arrival(self.handle, until))
        return self.now

    def send(self, bus: int, frame: Frame, time: int | None = None) -> bool:
        """Hands a frame to the master's controller, now or later; False when there is no room."""
        at = self.now if time is None else time
        return bool(self.c.peer_send(self.handle, bus, at, byref(frame.raw())))

    def inject(self, bus: int, frame: Frame, time: int | None = None) -> bool:
        """The same for another node of the bus."""
        at = self.now if time is None else time
        return bool(self.c.peer_inject(self.handle, bus, at, byref(frame.raw())))

    def receive(self, bus: int) -> tuple[int, Frame] | None:
        """Time and frame of the next that arrived at the master."""
        raw, time = RawFrame(), c_int64()
        if not self.c.peer_receive(self.handle, bus, byref(raw), byref(time)):
            return None
        return time.value, frame_of(raw)

    def received(self, bus: int) -> list[tuple[int, Frame]]:
        """All of them."""
        arrived = []
        while (item := self.receive(bus)) is not None:
            arrived.append(item)
        return arrived

    def write(self, bus: int, text: bytes) -> None:
        """What the master writes to its adapter."""
        self.c.peer_write(self.handle, bus, text, len(text))

    def read(self, bus: int, room: int = 4096) -> bytes:
        """The next piece from the adapter."""
        buffer = ctypes.create_string_buffer(room)
        count = self.c.peer_read(self.handle, bus, buffer, room)
        return buffer.raw[:count]

    def read_all(self, bus: int) -> bytes:
        """All there is from the adapter."""
        text = b""
        while piece := self.read(bus):
            text += piece
        return text

    def torque(self, drive: int) -> float:
        """N m at the shaft."""
        return float(self.c.peer_torque(self.handle, drive))

    def turn(self, drive: int, time: int, angle: float) -> None:
        """The shaft is at an angle, rad, at a time."""
        self.c.peer_turn(self.handle, drive, time, angle)

    def angle(self, drive: int) -> float:
        """Of the shaft now, rad."""
        return float(self.c.peer_angle(self.handle, drive))

    def vary(self, drive: int, variation: Variation | None = None) -> None:
        """The drive behaves so from now on; plainly by default."""
        self.c.peer_vary(self.handle, drive, byref(variation or Variation()))

    def vary_bus(self, bus: int, variation: BusVariation | None = None) -> None:
        """The same of a bus or its adapter."""
        self.c.peer_vary_bus(self.handle, bus, byref(variation or BusVariation()))

    def fail(self, drive: int, code: int) -> None:
        """The drive finds an error."""
        self.c.peer_raise(self.handle, drive, code)

    def nmt(self, drive: int) -> Nmt:
        return Nmt(self.c.peer_nmt_state(self.handle, drive))

    def power(self, drive: int) -> Power:
        return Power(self.c.peer_power_state(self.handle, drive))

    def object(self, drive: int, index: int, sub: int = 0) -> int:
        """What an object holds, without SDO. Raises KeyError when there is none."""
        value = c_int64()
        if not self.c.peer_object(self.handle, drive, index, sub, byref(value)):
            raise KeyError(f"{index:04X}:{sub}")
        return value.value

    def counted(self, drive: int) -> Counters:
        """What the drive saw since power on."""
        counters: Counters = self.c.peer_counted(self.handle, drive)
        return counters

    def bus_counted(self, bus: int) -> BusCounters:
        counters: BusCounters = self.c.peer_bus_counted(self.handle, bus)
        return counters

    def waiting(self, bus: int) -> int:
        """Frames of the master still to be sent."""
        return int(self.c.peer_waiting(self.handle, bus))
