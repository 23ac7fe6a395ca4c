"""Runs a recording again through the C of its machine, and compares every order to the bit."""

import ctypes
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from turnbuckle.codegen.accuracy_cache import measured_accuracy
from turnbuckle.codegen.bind import folder_of, pointer
from turnbuckle.codegen.compile import compile_library
from turnbuckle.codegen.controller import RUNTIME_CORE
from turnbuckle.codegen.generate import render
from turnbuckle.codegen.identity import machine_hash
from turnbuckle.codegen.model import build_model
from turnbuckle.codegen.struct_layout import Layouts, layouts_in
from turnbuckle.lab.flight import FlightError
from turnbuckle.lab.flight.recording import Recording, Records, Segment

SHIM = Path(__file__).parent / "replay_shim.c"
#: Topics of a machine's C that no running program calls.
DESIGN = ("tb_comparison.c", "tb_quality.c")


@dataclass(frozen=True)
class Difference:
    """The first order that is not the recorded one."""

    cycle: int
    field: str
    recorded: object
    computed: object

    def __str__(self) -> str:
        return (
            f"cycle {self.cycle}: {self.field} was {self.recorded} when recorded,"
            f" now it is {self.computed}"
        )


@dataclass(frozen=True)
class Replay:
    """What came out: the cycles that matched, and the first difference, if any."""

    matched: int
    difference: Difference | None


class Supervisor:
    """The compiled supervisor of a machine."""

    def __init__(self, library: Path) -> None:
        """Load what was compiled of supervisor_sources."""
        self._library = ctypes.CDLL(str(library))
        self._library.shim_replay.restype = None
        self.layouts = layouts_in(self._library, "tb_recording_layout")

    def run(self, segment: Segment) -> Records:
        """The cycles of a segment, with what is ordered when they are run again."""
        memory, again = segment.before.copy(), np.zeros_like(segment.cycles)
        recorded = np.ascontiguousarray(segment.cycles)
        count = ctypes.c_size_t(len(recorded))
        self._library.shim_replay(pointer(memory), count, pointer(recorded), pointer(again))
        return again


def supervisor_sources(folder: Path, core: Path = RUNTIME_CORE) -> list[Path]:
    """The C of a machine, in `folder`, and the runtime's core, as far as they order anything."""
    generated = [path for path in sorted(folder.glob("*.c")) if path.name not in DESIGN]
    return [*generated, *sorted(core.glob("*.c")), SHIM]


def compile_supervisor(folder: Path, precision: str, core: Path = RUNTIME_CORE) -> Supervisor:
    """The supervisor of a machine whose C is in `folder`; core: the runtime's."""
    sources = supervisor_sources(folder, core)
    return Supervisor(compile_library(sources, [folder, core], precision))


def replay(recording: Recording) -> Replay:
    """Run a recording again through the C that its machine file makes today.

    Raises FlightError where that is not the C which recorded.
    """
    machine = recording.machine
    model = build_model(machine)
    refuse_other_hash(recording, machine_hash(model))
    accuracies = measured_accuracy(machine, model.items())
    folder = folder_of(machine, render(model, accuracies))
    return run_again(recording, compile_supervisor(folder, recording.precision))


def refuse_other_hash(recording: Recording, wanted: str) -> None:
    """Refuse a machine file that has changed since, or that a changed generator reads."""
    if recording.hash != wanted:
        raise FlightError(
            f"{recording.path}: of machine hash {recording.hash}; {recording.machine.path} has"
            f" {wanted}: use the machine file, and the version of turnbuckle, that the program was"
            " made from"
        )


def run_again(recording: Recording, supervisor: Supervisor) -> Replay:
    """Run a recording through a compiled supervisor, until the first difference.

    What has no checksum is not run: the C believes the memory that it is given.
    """
    refuse_other_layouts(recording, supervisor.layouts)
    matched = 0
    for segment in recording.segments:
        if not segment.whole:
            continue
        again = supervisor.run(segment)
        difference = first_difference(segment, again["orders"])
        if difference is not None:
            return Replay(matched + difference.cycle - segment.first, difference)
        matched += len(segment.cycles)
    return Replay(matched, None)


def refuse_other_layouts(recording: Recording, wanted: Layouts) -> None:
    """Refuse C that lays its memory or a cycle out otherwise than the C that recorded."""
    for name in ("supervisor", "recorded_cycle"):
        other = first_other(f"tb_{name}", recording.layouts.struct(name), wanted.struct(name))
        if other:
            raise FlightError(
                f"{recording.path}: {other} is laid out otherwise in this version of turnbuckle;"
                " replay it with the version that recorded it"
            )


def first_other(name: str, recorded: np.dtype[Any], now: np.dtype[Any]) -> str:
    """The first member that is of another type or at another place; empty where there is none."""
    recorded, now = recorded.base, now.base
    if recorded == now:
        return ""
    there = places_in(now)
    for member, (layout, at) in places_in(recorded).items():
        other, place = there.get(member, (layout, -1))
        if at != place:
            return f"{name}.{member}"
        if found := first_other(f"{name}.{member}", layout, other):
            return found
    return name


def places_in(layout: np.dtype[Any]) -> dict[str, tuple[np.dtype[Any], int]]:
    """Type and place [bytes] of every member."""
    return {name: (kind, at) for name, (kind, at, *_) in (layout.fields or {}).items()}


def first_difference(segment: Segment, computed: Records) -> Difference | None:
    """The first cycle of a segment with another order, and its first field."""
    recorded = segment.cycles["orders"]
    found = [
        (int(np.argmax(unlike)), name, pair)
        for name, *pair in leaves("", recorded, computed)
        if (unlike := differs(*pair)).any()
    ]
    if not found:
        return None
    cycle, name, (before, now) = min(found, key=lambda one: one[0])
    entry = np.argwhere(differs_by_entry(before[cycle], now[cycle]))[0]
    place = "".join(f"[{i}]" for i in entry)
    one, other = before[cycle][tuple(entry)], now[cycle][tuple(entry)]
    return Difference(int(segment.numbers[cycle]), f"{name}{place}", one.item(), other.item())


def leaves(
    name: str, recorded: NDArray[Any], computed: NDArray[Any]
) -> Iterator[tuple[str, NDArray[Any], NDArray[Any]]]:
    """Every number of a struct, with its name; padding is none."""
    fields = recorded.dtype.names
    if fields is None:
        yield name, recorded, computed
        return
    for field in fields:
        inner = f"{name}.{field}" if name else field
        yield from leaves(inner, recorded[field], computed[field])


def differs_by_entry(one: NDArray[Any], other: NDArray[Any]) -> NDArray[np.bool_]:
    """Where the bits of two arrays differ: NaN is like NaN, 0 is not like -0."""
    bits = np.dtype(f"u{one.dtype.itemsize}")
    pair = [np.ascontiguousarray(array).view(bits) for array in (one, other)]
    return np.asarray(pair[0] != pair[1]).reshape(np.shape(one))


def differs(one: NDArray[Any], other: NDArray[Any]) -> NDArray[np.bool_]:
    """In which cycles (first axis) the bits of two arrays differ."""
    return np.asarray(differs_by_entry(one, other).reshape(len(one), -1).any(axis=1))
