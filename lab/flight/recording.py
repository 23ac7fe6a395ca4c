"""A flight recording: the file that runtime/core/recorder.h describes, read into NumPy arrays.

The arrays mirror the C structs of the machine that recorded. Whatever is wrong with a file is a
FlightError that names the file, what was found and what is allowed.
"""

import re
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.bind import REALS
from turnbuckle.codegen.controller import layouts
from turnbuckle.lab.flight import FlightError
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.places import MACHINES

Layout = np.dtype[np.void]
Records = NDArray[np.void]

MAGIC = b"TBFLIGHT"
VERSION = 2
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
                "segment_size",
                "segment_cycles",
                "segments",
                "ended",
            )
        ),
        ("machine", "S64"),
        ("hash", "S64"),
    ]
)

SEGMENT: Layout = np.dtype([("first", np.uint64), ("count", np.uint32), ("checksum", np.uint32)])
LARGEST_NUMBER = 1 << 62
"""Of a cycle: no machine runs that long."""


@dataclass(frozen=True)
class Segment:
    """Cycles without a gap. before: the supervisor's memory at the first, as bytes.

    whole: its checksum was right; without its end it has none.
    """

    first: int
    before: NDArray[np.uint8]
    cycles: Records
    whole: bool = True

    @property
    def numbers(self) -> NDArray[np.int64]:
        """Number of every cycle."""
        return self.first + np.arange(len(self.cycles), dtype=np.int64)


@dataclass(frozen=True)
class Recording:
    """A recording of a known machine, oldest segment first. flaws: in words, what is not in it."""

    path: Path
    machine: Machine
    hash: str
    precision: str
    segments: list[Segment]
    flaws: Sequence[str] = ()

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

    Of a recording that was cut off or damaged that is read which is whole. Raises FlightError for
    what is no recording of this machine or has no whole cycle, OSError, MachineError.
    """
    content = path.read_bytes()
    header = header_of(path, content)
    machine = load_machine(file or machine_file(path, text(header, "machine")))
    refuse_other_name(path, header, machine)
    precision = PRECISIONS[int(header["real_size"])]
    cycle = cycle_layout(machine, precision)
    refuse_other_sizes(path, header, cycle, machine)
    places = places_of(path, content, header)
    segments, flaws = salvaged(places, cycle, len(content))
    if not segments:
        raise FlightError(f"{path}: {'; '.join(flaws) or 'nothing was recorded'}")
    return Recording(path, machine, text(header, "hash"), precision, segments, flaws)


def header_of(path: Path, content: bytes) -> Any:
    """The header of a file that a program of this version wrote."""
    if not content.startswith(MAGIC):
        raise FlightError(f"{path}: no flight recording: it does not begin with {MAGIC.decode()}")
    if len(content) < HEADER.itemsize:
        raise FlightError(f"{path}: cut off after {len(content)} bytes, before the first cycle")
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
    if int(header["real_size"]) not in PRECISIONS:
        raise FlightError(f"{path}: real numbers of {header['real_size']} bytes; allowed: 4 or 8")
    return header


def text(header: Any, name: str) -> str:
    """A text of the header."""
    return bytes(header[name]).decode("ascii", errors="backslashreplace")


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
        raise FlightError(f"{path}: of machine {name!r}; {machine.path} is {machine.name!r}")


def refuse_other_sizes(path: Path, header: Any, cycle: Layout, machine: Machine) -> None:
    """Refuse structs that are not what this version and this machine file make them."""
    found = [int(header[f"{name}_size"]) for name in ("observation", "orders", "cycle")]
    wanted = [cycle["seen"].itemsize, cycle["orders"].itemsize, cycle.itemsize]
    if found != wanted:
        raise FlightError(
            f"{path}: observation, orders and cycle take {found} bytes; {machine.path} and this"
            f" version of turnbuckle make them {wanted}: one of them has changed since"
        )


@dataclass(frozen=True)
class Places:
    """Where the segments are in the bytes of a file."""

    content: bytes
    head: int
    """Bytes of a segment before its cycles."""
    memory: int
    """Bytes of the supervisor's memory among these."""
    size: int
    """Bytes of a segment."""
    cycles: int
    """Most in a segment."""
    used: int
    ended: bool


def places_of(path: Path, content: bytes, header: Any) -> Places:
    """The places that a header tells of; FlightError where its numbers contradict each other."""
    head, memory, size, cycle, cycles = (
        int(header[name])
        for name in (
            "head_size",
            "supervisor_size",
            "segment_size",
            "cycle_size",
            "segment_cycles",
        )
    )
    if head < SEGMENT.itemsize or size < head + cycles * cycle or not cycles:
        raise FlightError(
            f"{path}: damaged: {cycles} cycles of {cycle} bytes behind {head} bytes do not fit into"
            f" the {size} bytes of a segment, as its header says"
        )
    memory = min(memory, head - SEGMENT.itemsize)
    used, ended = int(header["segments"]), bool(header["ended"])
    return Places(content, head, memory, size, cycles, used, ended)


def salvaged(places: Places, cycle: Layout, size: int) -> tuple[list[Segment], list[str]]:
    """What is whole of all segments, oldest first; and in words what is not."""
    found: list[Segment] = []
    cut = damaged = 0
    begins = range(HEADER.itemsize, HEADER.itemsize + places.used * places.size, places.size)
    for number, at in enumerate(begins):
        if at >= size:
            cut += places.used - number
            break
        segment = segment_at(places, cycle, at)
        cut += segment is not None and not segment.whole
        damaged += segment is None
        if segment is not None and len(segment.cycles):
            found.append(segment)
    flaws = []
    if cut:
        flaws.append(f"cut off after {size} bytes: {some(cut, 'segment')} not whole, or not there")
    if damaged:
        flaws.append(f"damaged: {some(damaged, 'segment')} left out")
    if not places.ended:
        flaws.append("it was not ended: the program still runs, or was killed with its writer")
    return sorted(found, key=lambda segment: segment.first), flaws


def some(count: int, what: str) -> str:
    """A number of things, with its verb."""
    return f"{count} {what} is" if count == 1 else f"{count} {what}s are"


def segment_at(places: Places, cycle: Layout, at: int) -> Segment | None:
    """The whole cycles of the segment that begins there; None where it is damaged."""
    content, begin = places.content, at + places.head
    if begin > len(content):
        return Segment(0, np.zeros(0, np.uint8), np.zeros(0, cycle), whole=False)
    first, count, checksum = np.frombuffer(content, SEGMENT, 1, at)[0].tolist()
    if count > places.cycles or first > LARGEST_NUMBER:
        return None
    there = min(count, (len(content) - begin) // cycle.itemsize)
    end = begin + there * cycle.itemsize
    if there == count and checksum_of(content, at, end) != checksum:
        return None
    before = np.frombuffer(content, np.uint8, places.memory, at + SEGMENT.itemsize)
    return Segment(first, before, np.frombuffer(content, cycle, there, begin), there == count)


def checksum_of(content: bytes, at: int, end: int) -> int:
    """CRC-32 of a segment: memory and cycles, then the number of the first and the count."""
    view = memoryview(content)
    head = view[at : at + SEGMENT.fields["checksum"][1]]  # type: ignore[index]
    return zlib.crc32(head, zlib.crc32(view[at + SEGMENT.itemsize : end]))


def cycle_layout(machine: Machine, precision: str) -> Layout:
    """tb_recorded_cycle of runtime/core/recorder.h."""
    return np.dtype(
        [("seen", observation(machine, precision)), ("orders", orders(machine, precision))],
        align=True,
    )


def observation(machine: Machine, precision: str) -> Layout:
    """tb_observation of runtime/core/cycle.h."""
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
    """tb_orders of runtime/core/cycle.h."""
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
