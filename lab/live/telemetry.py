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

from turnbuckle.lab.live import LiveError, NothingYetError

FOLDER = Path("/dev/shm")
MAGIC, VERSION = b"TBTELEM\0", 3
NAME, TEXT = 32, 1024
LARGEST_COUNT = 4096
"""Of anything that a header counts but bytes and cycles: no machine has as many."""
ATTEMPTS = 10_000
"""How often a copy is tried again that was written meanwhile; one writing takes about 1 us."""

SIZES = ("dof", "cables", "drives", "buses")
Record = np.void
Request = Literal["arm", "stop", "reset"]

COUNTS = np.dtype(
    [
        ("magic", "S8"),
        ("version", "<u4"),
        ("bytes", "<u4"),
        ("machine", f"S{NAME}"),
        ("hash", f"S{NAME}"),
        *((name, "<u4") for name in ("dof", "cables", "rails", "drives", "buses", "bins")),
        *((name, "<u4") for name in ("status_at", "status_bytes", "cycles_at", "cycle_bytes")),
        *((name, "<u4") for name in ("slots", "inbox_at", "inbox_bytes", "pid", "simulated")),
        ("has_rails", "<u4"),
        ("period", "<f8"),
        ("tension_min", "<f8"),
        ("tension_max", "<f8"),
    ],
    align=True,
)
"""The beginning of the header, the same for every machine."""

DRIVE = np.dtype(
    [
        ("position", "<f8"),
        ("torque", "<f8"),
        ("ordered_torque", "<f8"),
        ("statusword", "<u2"),
        ("error_code", "<u2"),
        *((name, "u1") for name in ("power", "mode", "homing", "fresh", "missed", "silent")),
        *((name, "u1") for name in ("task", "progress", "goal")),
        ("reserved", "u1", 3),
    ],
    align=True,
)

BUS = np.dtype(
    [
        ("bits", "<u8"),
        *((name, "<u4") for name in ("state", "sent", "received", "refused", "lost", "malformed")),
        *((name, "<u4") for name in ("bus_errors", "bus_off", "bit_rate", "divider")),
    ]
)


class Layout(NamedTuple):
    """The parts of a machine's file."""

    names: np.dtype[Any]
    status: np.dtype[Any]
    cycle: np.dtype[Any]
    inbox: np.dtype[Any]


def layout_of(counts: Record) -> Layout:
    """The parts of the file whose header begins with these counts."""
    dof, cables, rails, drives, buses, bins = (
        int(counts[name]) for name in ("dof", "cables", "rails", "drives", "buses", "bins")
    )
    histogram = np.dtype(
        [
            ("bins", "<u8", bins),
            ("count", "<u8"),
            *((name, "<i8") for name in ("least", "most", "sum")),
        ]
    )
    return Layout(
        names=np.dtype(
            [
                ("edges", "<i8", bins - 1),
                ("drives", f"S{NAME}", drives),
                ("buses", f"S{NAME}", buses),
            ]
        ),
        status=np.dtype(
            [
                ("sequence", "<u8"),
                ("published", "<u8"),
                ("missed", "<u8"),
                ("longest_gap", "<u8"),
                ("lateness", histogram),
                ("computing", histogram),
                ("buses", BUS, buses),
                ("doing", f"S{TEXT}"),
                ("cause", f"S{TEXT}"),
            ],
            align=True,
        ),
        cycle=np.dtype(
            [
                ("sequence", "<u8"),
                ("number", "<u8"),
                ("time", "<i8"),
                ("missed", "<u4"),
                ("requests", "<u4"),
                *((name, "u1") for name in ("state", "phase", "cause", "beat")),
                ("status", "<i4"),
                ("pose", "<f8", dof),
                ("velocity", "<f8", dof),
                ("residual", "<f8"),
                *((name, "<f8", dof) for name in ("force", "wanted_force", "delivered_force")),
                ("tension", "<f8", cables),
                ("slack", "<f8", cables),
                ("rail_target", "<f8", rails),
                ("drives", DRIVE, drives),
            ],
            align=True,
        ),
        inbox=np.dtype(
            [
                *((name, "<u4") for name in ("arm", "stop", "reset", "reserved")),
                ("force_sequence", "<u8"),
                ("force", "<f8", dof),
                ("hand_sequence", "<u8"),
                ("hand_force", "<f8", dof),
            ],
            align=True,
        ),
    )


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
        self.counts = self._counts()
        layout = self._layout()
        self.names = self._part(layout.names, COUNTS.itemsize)[0].copy()
        self._status = self._part(layout.status, self._at("status"))
        self._cycles = self._part(layout.cycle, self._at("cycles"), int(self.counts["slots"]))
        self._inbox = self._part(layout.inbox, self._at("inbox"))

    def _counts(self) -> Record:
        magic = self._memory[: len(MAGIC)]
        if magic == bytes(len(MAGIC)):
            raise nothing_yet(self.path)
        if len(self._memory) < COUNTS.itemsize or magic != MAGIC:
            raise foreign(self.path, "something else")
        counts: Record = self._part(COUNTS, 0)[0].copy()
        if counts["version"] != VERSION:
            raise LiveError(
                f"{self.path}: found telemetry of version {counts['version']}; allowed: {VERSION},"
                " that of this turnbuckle: build the program anew"
            )
        return counts

    def _layout(self) -> Layout:
        """The parts of the file, which are where this module believes that they are."""
        for name, least in (("bins", 2), ("rails", 1), *((name, 1) for name in SIZES)):
            if not least <= int(self.counts[name]) <= LARGEST_COUNT:
                raise foreign(self.path, f"{name} = {self.counts[name]}")
        if not int(self.counts["slots"]):
            raise foreign(self.path, "slots = 0")
        layout = layout_of(self.counts)
        self._check(layout)
        return layout

    def _at(self, part: str) -> int:
        return int(self.counts[f"{part}_at"])

    def _part(self, dtype: np.dtype[Any], begin: int, count: int = 1) -> NDArray[Any]:
        return np.frombuffer(self._memory, dtype, count, begin)

    def _check(self, layout: Layout) -> None:
        """What the C wrote about its layout is what this module believes."""
        counts = self.counts
        believed = {
            "bytes": len(self._memory),
            "status_at": COUNTS.itemsize + layout.names.itemsize,
            "status_bytes": layout.status.itemsize,
            "cycle_bytes": layout.cycle.itemsize,
            "inbox_bytes": layout.inbox.itemsize,
            "cycles_at": int(counts["status_at"]) + layout.status.itemsize,
            "inbox_at": int(counts["cycles_at"]) + int(counts["slots"]) * layout.cycle.itemsize,
        }
        for name, bytes_ in believed.items():
            if int(counts[name]) != bytes_:
                raise foreign(self.path, f"{name} = {counts[name]} where {bytes_} is due")
        if (due := believed["inbox_at"] + layout.inbox.itemsize) != len(self._memory):
            raise foreign(self.path, f"{len(self._memory)} bytes where {due} are due")

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
        return [name.decode(errors="backslashreplace") for name in self.names["drives"]]

    @property
    def bus_names(self) -> list[str]:
        """Names of the buses."""
        return [name.decode(errors="backslashreplace") for name in self.names["buses"]]

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
    cycles = sum(int(later[count]) - int(earlier[count]) for count in ("published", "missed"))
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
