"""The shared file of a running program: runtime/port/linux/telemetry.h, in Python.

Neither side waits for the other: what is read while it was being written is read again.
"""

import fcntl
import mmap
import os
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from turnbuckle.codegen.struct_layout import ROW, Layout, LayoutError, Layouts, read_layouts
from turnbuckle.lab.live import LiveError, NothingYetError

FOLDER = Path("/dev/shm")
MAGIC, VERSION = b"TBTELEM\0", 4
ATTEMPTS = 10_000
"""How often a copy is tried again that was written meanwhile; one writing takes about 1 us."""

SIZES = ("dof", "cables", "drives", "buses")
Record = np.void
Request = Literal["arm", "stop", "reset"]

BEGINNING: Layout = np.dtype(
    [
        ("magic", "S8"),
        *((name, np.uint32) for name in ("version", "bytes", "layout_at", "layout_rows")),
    ]
)
"""Of tb_telemetry_header; the file describes the rest of itself, tb_layout_row for row."""
READ: dict[str, tuple[str, ...]] = {
    "histogram": ("bins", "count", "most", "sum"),
    "telemetry_header": (
        *("machine", "hash", *SIZES, "rails", "status_at", "cycles_at", "slots", "inbox_at"),
        *("pid", "simulated", "period", "tension_min", "tension_max"),
        *("edges", "drive_names", "bus_names"),
    ),
    "telemetry_bus": (
        *("bits", "state", "sent", "received", "refused", "lost", "malformed", "bus_off"),
        "bit_rate",
    ),
    "loop_times": ("missed", "longest_gap", "lateness", "computing"),
    "telemetry_status": ("sequence", "published", "times", "buses", "doing", "cause"),
    "telemetry_drive": (
        *("position", "torque", "ordered_torque", "statusword", "error_code"),
        *("power", "mode", "missed", "silent", "task"),
    ),
    "telemetry_cycle": (
        *(
            "sequence",
            "number",
            "state",
            "phase",
            "cause",
            "pose",
            "velocity",
            "residual",
            "wanted_force",
        ),
        *("delivered_force", "tension", "slack", "drives"),
    ),
    "telemetry_inbox": (
        *("arm", "stop", "reset", "force_sequence", "force", "hand_sequence", "hand_force"),
    ),
}
"""Members that are read or written, by struct."""


class Telemetry:
    """The shared file of one program.

    Raises NothingYetError where there is none or only its beginning, LiveError for one of another
    version or layout.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._file, self._writable = open_file(path)
        try:
            access = mmap.ACCESS_WRITE if self._writable else mmap.ACCESS_READ
            self._memory = mmap.mmap(self._file, 0, access=access)
        except ValueError:
            os.close(self._file)
            raise nothing_yet(path) from None
        begins, self.layouts = self._description()
        self.counts = self._header(begins)
        status, cycle, inbox = (
            self.layouts.struct(f"telemetry_{name}") for name in ("status", "cycle", "inbox")
        )
        self._status = self._part(status, self._at("status"))
        self._cycles = self._part(cycle, self._at("cycles"), int(self.counts["slots"]))
        self._inbox = self._part(inbox, self._at("inbox"))

    def _description(self) -> tuple[Record, Layouts]:
        """The beginning of the header, and what the file says of its structs."""
        magic = self._memory[: len(MAGIC)]
        if magic == bytes(len(MAGIC)):
            raise nothing_yet(self.path)
        if len(self._memory) < BEGINNING.itemsize or magic != MAGIC:
            raise foreign(self.path, "something else")
        begins: Record = self._part(BEGINNING, 0)[0]
        if begins["version"] != VERSION:
            raise LiveError(
                f"{self.path}: found telemetry of version {begins['version']}; allowed: {VERSION},"
                " that of this turnbuckle: build the program anew"
            )
        rows, at = int(begins["layout_rows"]), int(begins["layout_at"])
        return begins, self._layouts(self._part(ROW, at, rows))

    def _layouts(self, rows: NDArray[Any]) -> Layouts:
        layouts = None
        try:
            layouts = read_layouts(rows)
            for struct, members in READ.items():
                layouts.struct(struct, *members)
        except LayoutError as error:
            version = f" of version {layouts.version}" if layouts and layouts.version else ""
            raise LiveError(
                f"{self.path}: written by a program{version}: {error}, which this turnbuckle reads;"
                " build the program anew"
            ) from None
        return layouts

    def _header(self, begins: Record) -> Record:
        """The header; LiveError where its numbers contradict the file or each other."""
        header: Record = self._part(self.layouts.struct("telemetry_header"), 0)[0].copy()
        if int(begins["bytes"]) != len(self._memory):
            raise foreign(self.path, f"{len(self._memory)} bytes where {begins['bytes']} are due")
        counts = zip(SIZES, self._described_sizes(), strict=True)
        for name, described in counts:
            if int(header[name]) != described:
                raise foreign(self.path, f"{name} = {header[name]} where {described} are described")
        if not int(header["slots"]):
            raise foreign(self.path, "slots = 0")
        return header

    def _described_sizes(self) -> tuple[int, ...]:
        """SIZES, as the arrays of the structs have them."""
        cycle, status = (self.layouts.struct(f"telemetry_{name}") for name in ("cycle", "status"))
        arrays = (cycle["pose"], cycle["tension"], cycle["drives"], status["buses"])
        return tuple(array.shape[0] if array.shape else 0 for array in arrays)

    def _at(self, part: str) -> int:
        return int(self.counts[f"{part}_at"])

    def _part(self, layout: Layout, begin: int, count: int = 1) -> NDArray[Any]:
        """A part of the file; LiveError where the file does not reach so far."""
        if begin + count * layout.itemsize > len(self._memory):
            raise foreign(
                self.path,
                f"{len(self._memory)} bytes where {begin + count * layout.itemsize} are due",
            )
        return np.frombuffer(self._memory, layout, count, begin)

    @property
    def machine(self) -> str:
        """Name of the machine that the program controls."""
        return str(self.counts["machine"].decode(errors="backslashreplace"))

    @property
    def hash(self) -> str:
        """Hash of the machine that the program controls."""
        return str(self.counts["hash"].decode(errors="backslashreplace"))

    @property
    def drive_names(self) -> list[str]:
        """Names of the drives: cable drives, then base drives."""
        return [name.decode(errors="backslashreplace") for name in self.counts["drive_names"]]

    @property
    def bus_names(self) -> list[str]:
        """Names of the buses."""
        return [name.decode(errors="backslashreplace") for name in self.counts["bus_names"]]

    @property
    def ended(self) -> bool:
        """Whether the program that wrote the file has ended, in whichever way: its lock is gone."""
        try:
            fcntl.flock(self._file, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        fcntl.flock(self._file, fcntl.LOCK_UN)
        return True

    def status(self) -> Record:
        """What is counted and told; published is 0 before the first cycle."""
        return self._whole(self._status, 0)

    def cycle(self, number: int) -> Record | None:
        """A control cycle; None when the ring has passed it."""
        record = self._whole(self._cycles, number % len(self._cycles))
        return record if int(record["sequence"]) == 2 * (number + 1) else None

    def latest(self) -> Record | None:
        """The last control cycle; None before the first."""
        for _ in range(ATTEMPTS):
            published = int(self.status()["published"])
            if not published:
                return None
            if (record := self.cycle(published - 1)) is not None:
                return record
        raise LiveError(f"{self.path}: its last cycle is not there")

    def _whole(self, part: NDArray[Any], at: int) -> Record:
        """A copy that nobody wrote to meanwhile."""
        for _ in range(ATTEMPTS):
            before = int(part["sequence"][at])
            copy: Record = part[at].copy()
            if before % 2 == 0 and before == int(part["sequence"][at]):
                return copy
        raise LiveError(f"{self.path}: its program stopped in the middle of writing")

    def ask(self, request: Request) -> None:
        """Ask once; the program acts on it in its next cycle."""
        self._permitted()
        self._inbox[request] += 1

    def asked(self, request: Request) -> int:
        """How often something was asked for."""
        return int(self._inbox[request][0])

    def push_force(self, force: ArrayLike) -> None:
        """The force [N] that the application wants; it counts for 20 cycles."""
        self._push("force", force)

    def push_hand_force(self, force: ArrayLike) -> None:
        """The measured force [N] of the hand on the handle; it counts for 20 cycles."""
        self._push("hand", force)

    def _push(self, which: str, force: ArrayLike) -> None:
        self._permitted()
        name = "force" if which == "force" else "hand_force"
        self._inbox[f"{which}_sequence"] += 1
        self._inbox[name] = force
        self._inbox[f"{which}_sequence"] += 1

    def _permitted(self) -> None:
        if not self._writable:
            raise LiveError(
                f"{self.path}: you may watch, but not send requests: that needs the right to write"
                " to the file"
            )

    def close(self) -> None:
        """Give the file back; copies stay valid."""
        del self._status, self._cycles, self._inbox
        self._memory.close()
        os.close(self._file)


def default_path(machine: str) -> Path:
    """Where the program of a machine writes its telemetry, unless told otherwise."""
    return FOLDER / f"turnbuckle-{machine}"


def running(path: Path) -> Telemetry | None:
    """The telemetry of a program that runs; None while there is none.

    Raises LiveError for a file that is no telemetry of ours.
    """
    try:
        telemetry = Telemetry(path)
    except NothingYetError:
        return None
    if telemetry.ended:
        telemetry.close()
        return None
    return telemetry


def open_file(path: Path) -> tuple[int, bool]:
    """A descriptor, and whether it may be written to."""
    for flags, writable in ((os.O_RDWR, True), (os.O_RDONLY, False)):
        try:
            return os.open(path, flags | os.O_CLOEXEC), writable
        except FileNotFoundError:
            raise nothing_yet(path) from None
        except IsADirectoryError:
            raise foreign(path, "a folder") from None
        except PermissionError:
            continue
    raise LiveError(f"{path}: no permission to read it")


def nothing_yet(path: Path) -> NothingYetError:
    """The file, or all that makes it one, is still to come."""
    return NothingYetError(
        f"{path}: no program has written telemetry here; start one with `turnbuckle run`"
    )


def foreign(path: Path, what: str) -> LiveError:
    """The file is not what a program of ours writes."""
    return LiveError(f"{path}: found {what}; allowed: telemetry of a turnbuckle program")


class Rate(NamedTuple):
    """What goes over a bus."""

    frames: float  # a second
    load: float  # share of the bit rate, stuff bits not counted


def rates(earlier: Record, later: Record, period: float) -> list[Rate]:
    """What went over every bus between two readings of the status; `period` [s] of one cycle."""
    cycles = sum(
        int(after) - int(before)
        for before, after in (
            (earlier["published"], later["published"]),
            (earlier["times"]["missed"], later["times"]["missed"]),
        )
    )
    seconds = max(1, cycles) * period
    found = []
    for before, after in zip(earlier["buses"], later["buses"], strict=True):
        frames, bits = (
            sum(int(after[count]) - int(before[count]) for count in counts) / seconds
            for counts in (("sent", "received"), ("bits",))
        )
        # A program that has just opened its file has not told the bit rate yet.
        found.append(Rate(frames, bits / max(1, int(after["bit_rate"]))))
    return found
