"""A flight recording: the file that runtime/core/recorder.h describes, read into NumPy arrays.

The arrays mirror the C structs of the machine that recorded. Whatever is wrong with a file is a
FlightError that names the file, what was found and what is allowed.
"""

import re
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.bind import REALS
from turnbuckle.codegen.controller import layouts
from turnbuckle.lab.flight import FlightError
from turnbuckle.model.machine import Machine, load_machine
from turnbuckle.places import MACHINES

Layout = np.dtype[np.void]
Records = NDArray[np.void]

MAGIC, END_MAGIC = b"TBFLIGHT", b"TBLANDED"
VERSION = 1
BYTE_ORDER = 0x01020304
PRECISIONS = {np.dtype(real).itemsize: name for name, real in REALS.items()}
HEADER: Layout = np.dtype(
    [
        ("magic", "S8"),
        *(
            (name, np.uint32)
            for name in (
                "version",
                "byte_order",
                "real_size",
                "head_size",
                "supervisor_size",
                "observation_size",
                "orders_size",
                "cycle_size",
                "segments",
                "segment_cycles",
            )
        ),
        ("machine", "S64"),
        ("hash", "S64"),
    ]
)

END: Layout = np.dtype([("magic", "S8"), ("checksum", np.uint32), ("reserved", np.uint32)])
SEGMENT: Layout = np.dtype([("first", np.uint64), ("count", np.uint32), ("reserved", np.uint32)])


@dataclass(frozen=True)
class Segment:
    """Cycles without a gap. before: the supervisor's memory at the first, as bytes."""

    first: int
    before: NDArray[np.uint8]
    cycles: Records

    @property
    def numbers(self) -> NDArray[np.int64]:
        """Number of every cycle."""
        return self.first + np.arange(len(self.cycles), dtype=np.int64)


@dataclass(frozen=True)
class Recording:
    """A recording of a known machine, oldest segment first."""

    path: Path
    machine: Machine
    hash: str
    precision: str
    segments: list[Segment]

    @property
    def cycles(self) -> Records:
        """The cycles of all segments: fields `seen` and `orders`."""
        return np.concatenate([segment.cycles for segment in self.segments])

    @property
    def numbers(self) -> NDArray[np.int64]:
        """Number of every cycle; one that was skipped has none."""
        return np.concatenate([segment.numbers for segment in self.segments])


def read_recording(path: Path, file: Path | None = None) -> Recording:
    """Read a recording; without a machine file that of its name, here or among the stock ones.

    Raises FlightError for what is no whole recording of this machine, OSError, MachineError.
    """
    content = path.read_bytes()
    header = header_of(path, content)
    machine = load_machine(file or machine_file(path, text(header, "machine")))
    refuse_other_name(path, header, machine)
    precision = PRECISIONS[int(header["real_size"])]
    cycle = cycle_layout(machine, precision)
    refuse_other_sizes(path, header, cycle, machine)
    segments = list(segments_of(path, content, header, cycle))
    return Recording(path, machine, text(header, "hash"), precision, segments)


def header_of(path: Path, content: bytes) -> Any:
    """The header of a file that is whole."""
    if not content.startswith(MAGIC):
        raise FlightError(f"{path}: no flight recording: it does not begin with {MAGIC.decode()}")
    if len(content) < HEADER.itemsize:
        raise truncated(path, content)
    header = np.frombuffer(content, HEADER, 1)[0]
    if header["byte_order"] == np.uint32(BYTE_ORDER).byteswap():
        raise FlightError(
            f"{path}: recorded by a computer with the other byte order; read it there"
        )
    if header["version"] != VERSION or header["byte_order"] != BYTE_ORDER:
        raise FlightError(
            f"{path}: a recording of version {header['version']}; allowed: {VERSION}, of the"
            " turnbuckle that wrote it"
        )
    refuse_damage(path, content)
    if int(header["real_size"]) not in PRECISIONS:
        raise FlightError(f"{path}: real numbers of {header['real_size']} bytes; allowed: 4 or 8")
    return header


def refuse_damage(path: Path, content: bytes) -> None:
    """Refuse a file without its end, or with other bytes than were written."""
    if len(content) < HEADER.itemsize + END.itemsize:
        raise truncated(path, content)
    end = np.frombuffer(content[-END.itemsize :], END)[0]
    if end["magic"] != END_MAGIC:
        raise truncated(path, content)
    if zlib.crc32(content[: -END.itemsize]) != end["checksum"]:
        raise FlightError(
            f"{path}: damaged: its checksum is not that of its content; copy it again"
        )


def truncated(path: Path, content: bytes) -> FlightError:
    """The refusal of a file that does not end as a recording does."""
    return FlightError(
        f"{path}: cut off after {len(content)} bytes: the end of the recording is missing;"
        " copy it again"
    )


def text(header: Any, name: str) -> str:
    """A text of the header."""
    return bytes(header[name]).decode("ascii", errors="replace")


def machine_file(path: Path, name: str) -> Path:
    """The file of a machine: machines/<name>.toml in this folder, or a stock one."""
    if re.fullmatch("[a-z][a-z0-9_]*", name):
        for folder in (Path("machines"), MACHINES):
            if (folder / f"{name}.toml").exists():
                return folder / f"{name}.toml"
    raise FlightError(f"{path}: of machine {name!r}; found no machines/{name}.toml: name its file")


def refuse_other_name(path: Path, header: Any, machine: Machine) -> None:
    """Refuse a machine file of another machine."""
    name = text(header, "machine")
    if name != machine.name:
        raise FlightError(f"{path}: of machine {name}; {machine.path} is {machine.name}")


def refuse_other_sizes(path: Path, header: Any, cycle: Layout, machine: Machine) -> None:
    """Refuse structs that are not what this version and this machine file make them."""
    found = [int(header[f"{name}_size"]) for name in ("observation", "orders", "cycle")]
    wanted = [cycle["seen"].itemsize, cycle["orders"].itemsize, cycle.itemsize]
    if found != wanted:
        raise FlightError(
            f"{path}: observation, orders and cycle take {found} bytes; {machine.path} and this"
            f" version of turnbuckle make them {wanted}: one of them has changed since"
        )


def segments_of(path: Path, content: bytes, header: Any, cycle: Layout) -> Iterator[Segment]:
    """The segments between header and end."""
    at, end = HEADER.itemsize, len(content) - END.itemsize
    head, memory = int(header["head_size"]), int(header["supervisor_size"])
    for _ in range(int(header["segments"])):
        if at + head > end:
            raise inconsistent(path)
        first, count, _ = np.frombuffer(content, SEGMENT, 1, at)[0]
        before = np.frombuffer(content, np.uint8, memory, at + SEGMENT.itemsize)
        if count > header["segment_cycles"] or at + head + int(count) * cycle.itemsize > end:
            raise inconsistent(path)
        yield Segment(int(first), before, np.frombuffer(content, cycle, int(count), at + head))
        at += head + int(count) * cycle.itemsize
    if at != end:
        raise inconsistent(path)


def inconsistent(path: Path) -> FlightError:
    """The refusal of a file whose numbers contradict its size."""
    return FlightError(f"{path}: damaged: its segments do not fill it")


def cycle_layout(machine: Machine, precision: str) -> Layout:
    """tb_recorded_cycle of runtime/core/recorder.h."""
    return np.dtype(
        [("seen", observation(machine, precision)), ("orders", orders(machine, precision))],
        align=True,
    )


def observation(machine: Machine, precision: str) -> Layout:
    """tb_observation of runtime/core/supervisor.h."""
    real, d = REALS[precision], machine.dof
    report = [
        ("position", real),
        ("torque", real),
        ("statusword", np.uint16),
        ("error_code", np.uint16),
        ("error_class", np.uint8),
        ("power", np.uint8),
        ("mode", np.uint8),
        ("homing", np.uint8),
        ("fresh", np.uint8),
        ("age", np.uint8),
        ("missed", np.uint8),
        ("late", np.uint8),
        ("silent", np.uint8),
        ("task", np.uint8),
        ("progress", np.uint8),
        ("failure", np.uint8),
        ("subindex", np.uint8),
        ("index", np.uint16),
        ("detail", np.uint32),
    ]
    bus = [(name, np.uint8) for name in ("state", "refused", "stranger", "malformed")]
    fields = [
        ("drives", np.dtype(report, align=True), drive_count(machine)),
        ("buses", np.dtype(bus, align=True), len(machine.buses)),
        ("force", real, d),
        ("hand_force", real, d),
        ("hand_force_fresh", np.uint32),
        ("requests", np.uint32),
        ("missed", np.uint32),
    ]
    return np.dtype(in_arrays(fields), align=True)


def orders(machine: Machine, precision: str) -> Layout:
    """tb_orders of runtime/core/supervisor.h."""
    real = REALS[precision]
    order = [
        ("torque", real),
        ("position", real),
        ("goal", np.uint8),
        ("mode", np.uint8),
        ("task", np.uint8),
        ("home", np.uint8),
    ]
    _, outputs, _ = layouts(machine, precision)
    fields = [
        ("drives", np.dtype(order, align=True), drive_count(machine)),
        ("controller", outputs),
        ("slack", real, len(machine.cables)),
        ("beat", np.uint8),
        ("state", np.uint8),
        ("phase", np.uint8),
        ("cause", np.uint8),
        ("culprit", np.uint16),
        ("index", np.uint16),
        ("subindex", np.uint8),
        ("failure", np.uint8),
        ("detail", np.uint32),
    ]
    return np.dtype(in_arrays(fields), align=True)


def in_arrays(fields: list[tuple[Any, ...]]) -> list[tuple[Any, ...]]:
    """Fields with the length of an array made its shape: NumPy takes a length of 1 for none."""
    return [(name, kind, *((n,) for n in length)) for name, kind, *length in fields]


def drive_count(machine: Machine) -> int:
    """TB_DRIVES."""
    return len(machine.cables) + len(machine.rails)
