"""A flight recording: the file that runtime/core/recorder.h describes, read into NumPy arrays.

The arrays are the C structs of the machine that recorded, as the file itself describes them.
Whatever is wrong with a file is a FlightError that names the file, what was found and what is
allowed.
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
from turnbuckle.codegen.struct_layout import ROW, Layout, LayoutError, Layouts, read_layouts
from turnbuckle.lab.flight import FlightError
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.places import MACHINES

Records = NDArray[np.void]

MAGIC = b"TBFLIGHT"
VERSION = 3
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
                "layout_rows",
                "layout_checksum",
                "head_size",
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
"""tb_recording_header, the only layout that this module knows by itself."""
READ: dict[str, tuple[str, ...]] = {
    "segment_head": ("first", "count", "checksum"),
    "supervisor": (),
    "recorded_cycle": ("seen", "orders"),
    "drive_report": (
        *("position", "torque", "statusword", "error_code", "power", "mode", "homing", "fresh"),
        *("missed", "late", "silent", "task", "progress", "failure", "index", "subindex", "detail"),
    ),
    "bus_report": ("state", "refused", "stranger", "malformed"),
    "observation": (
        *("drives", "buses", "force", "hand_force", "hand_force_fresh", "requests", "missed"),
    ),
    "drive_order": ("torque", "position", "goal"),
    "outputs": (
        *("pose", "velocity", "residual", "wanted_force", "delivered_force", "tension"),
        *("disturbance", "rail_target", "rail_force", "gate", "status"),
    ),
    "orders": (
        *("drives", "controller", "slack", "beat", "state", "phase", "cause", "culprit"),
        *("index", "subindex", "failure", "detail"),
    ),
}
"""Members that are read, by struct."""
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
    layouts: Layouts
    segments: list[Segment]
    flaws: Sequence[str] = ()

    @property
    def precision(self) -> str:
        """ "double" or "float" """
        return precision_of(self.layouts)

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
    layouts = layouts_of(path, content, header)
    machine = load_machine(file or machine_file(path, text(header, "machine")))
    refuse_other_name(path, header, machine)
    refuse_other_counts(path, layouts, machine)
    places = places_of(path, content, header, layouts)
    segments, flaws = salvaged(places, len(content))
    if not segments:
        raise FlightError(f"{path}: {'; '.join(flaws) or 'nothing was recorded'}")
    return Recording(path, machine, text(header, "hash"), layouts, segments, flaws)


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
    return header


def layouts_of(path: Path, content: bytes, header: Any) -> Layouts:
    """What the file says of its structs; FlightError where it lacks what is to be read."""
    rows = int(header["layout_rows"])
    if len(content) < HEADER.itemsize + rows * ROW.itemsize:
        raise FlightError(f"{path}: cut off after {len(content)} bytes, before the first cycle")
    description = np.frombuffer(content, ROW, rows, HEADER.itemsize)
    if zlib.crc32(description.tobytes()) != header["layout_checksum"]:
        raise FlightError(f"{path}: damaged: the description of its structs has another checksum")
    layouts = None
    try:
        layouts = read_layouts(description)
        for struct, members in READ.items():
            layouts.struct(struct, *members)
    except LayoutError as error:
        version = f" of version {layouts.version}" if layouts and layouts.version else ""
        raise FlightError(
            f"{path}: recorded by a program{version}: {error}, which this turnbuckle reads; use the"
            " turnbuckle that the program was made with"
        ) from None
    if layouts.structs["drive_report"]["position"].itemsize not in PRECISIONS:
        raise FlightError(f"{path}: its positions are no real numbers")
    return layouts


def precision_of(layouts: Layouts) -> str:
    """The precision of the program that described its structs: "double" or "float"."""
    return PRECISIONS[layouts.structs["drive_report"]["position"].itemsize]


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


def refuse_other_counts(path: Path, layouts: Layouts, machine: Machine) -> None:
    """Refuse a machine file that has other numbers of drives, buses or directions of force."""
    seen, orders = layouts.structs["observation"], layouts.structs["orders"]
    found = [
        *(seen[name].shape for name in ("drives", "buses", "force")),
        *(orders[name].shape for name in ("drives", "slack")),
    ]
    drives, cables = drive_count(machine), len(machine.cables)
    wanted = [(n,) for n in (drives, len(machine.buses), machine.dof, drives, cables)]
    if found != wanted:
        raise FlightError(
            f"{path}: of a machine with {counted(found)}; {machine.path} has {counted(wanted)}: the"
            " machine file has changed since"
        )


def counted(shapes: Sequence[tuple[int, ...]]) -> str:
    """Shapes of drives, buses, force, drives and cables in words."""
    drives, buses, force, _, cables = (shape[0] if shape else 0 for shape in shapes)
    return f"{drives} drives, {buses} buses, {cables} cables, {force} degrees of freedom"


@dataclass(frozen=True)
class Places:
    """Where the segments are in the bytes of a file."""

    content: bytes
    begin: int
    """Bytes before the first segment."""
    head: int
    """Bytes of a segment before its cycles."""
    memory: int
    """Bytes of the supervisor's memory among these."""
    segment: Layout
    """Of what is before the memory."""
    cycle: Layout
    size: int
    """Bytes of a segment."""
    cycles: int
    """Most in a segment."""
    used: int
    ended: bool


def places_of(path: Path, content: bytes, header: Any, layouts: Layouts) -> Places:
    """The places that a header tells of; FlightError where its numbers contradict each other."""
    head, size, cycles = (
        int(header[name]) for name in ("head_size", "segment_size", "segment_cycles")
    )
    segment, memory, cycle = (
        layouts.struct(name) for name in ("segment_head", "supervisor", "recorded_cycle")
    )
    least = segment.itemsize + memory.itemsize
    if head < least or size < head + cycles * cycle.itemsize or not cycles:
        raise FlightError(
            f"{path}: damaged: {cycles} cycles of {cycle.itemsize} bytes behind {head} bytes do not"
            f" fit into the {size} bytes of a segment, as its header says"
        )
    begin = HEADER.itemsize + int(header["layout_rows"]) * ROW.itemsize
    used, ended = int(header["segments"]), bool(header["ended"])
    return Places(content, begin, head, memory.itemsize, segment, cycle, size, cycles, used, ended)


def salvaged(places: Places, size: int) -> tuple[list[Segment], list[str]]:
    """What is whole of all segments, oldest first; and in words what is not."""
    found: list[Segment] = []
    cut = damaged = 0
    begins = range(places.begin, places.begin + places.used * places.size, places.size)
    for number, at in enumerate(begins):
        if at >= size:
            cut += places.used - number
            break
        segment = segment_at(places, at)
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


def segment_at(places: Places, at: int) -> Segment | None:
    """The whole cycles of the segment that begins there; None where it is damaged."""
    content, begin, cycle = places.content, at + places.head, places.cycle
    if begin > len(content):
        return Segment(0, np.zeros(0, np.uint8), np.zeros(0, cycle), whole=False)
    head = np.frombuffer(content, places.segment, 1, at)[0]
    first, count, checksum = (int(head[name]) for name in READ["segment_head"])
    if count > places.cycles or first > LARGEST_NUMBER:
        return None
    there = min(count, (len(content) - begin) // cycle.itemsize)
    end = begin + there * cycle.itemsize
    if there == count and checksum_of(content, places.segment, at, end) != checksum:
        return None
    before = np.frombuffer(content, np.uint8, places.memory, at + places.segment.itemsize)
    return Segment(first, before, np.frombuffer(content, cycle, there, begin), there == count)


def checksum_of(content: bytes, segment: Layout, at: int, end: int) -> int:
    """CRC-32 of a segment: memory and cycles, then the number of the first and the count."""
    view = memoryview(content)
    head = view[at : at + segment.fields["checksum"][1]]  # type: ignore[index]
    return zlib.crc32(head, zlib.crc32(view[at + segment.itemsize : end]))


def drive_count(machine: Machine) -> int:
    """TB_DRIVES."""
    return len(machine.cables) + len(machine.rails)
