"""Processor time of one control cycle of the master at work: SYNC, answers, step, setpoints.

Buses are in memory, so what a real port adds is left out; what the buses in memory cost is not.
"""

import ctypes
import time
from dataclasses import dataclass
from pathlib import Path
from statistics import median

import numpy as np

from turnbuckle.codegen.bind import Generated, pointer
from turnbuckle.codegen.compile import compile_library
from turnbuckle.lab.benchmark.cycle.recording import Cycles, Recorder
from turnbuckle.lab.benchmark.native import ROOT
from turnbuckle.lab.benchmark.timing import Timing
from turnbuckle.lab.lockstep import CAN, FOLDERS, PORTABLE_CAN, layouts_of
from turnbuckle.model.machine import Machine

REPLAY = ROOT / "lab" / "benchmark" / "cycle" / "replay.c"


@dataclass(frozen=True)
class CycleRow:
    """One precision: time of a cycle, and the frames it handles."""

    precision: str
    timing: Timing
    frames: float  # a cycle, sent and received


class Replay:
    """The master of a machine, run on what was recorded."""

    def __init__(self, generated: Generated) -> None:
        self.precision = generated.precision
        self._library = replay_library(generated)
        self._memory = ctypes.create_string_buffer(self._library.shim_machine_size())
        self._view = np.zeros(1, layouts_of(self._library).struct("view"))

    def power_on(self) -> None:
        """Begin anew."""
        ctypes.memset(self._memory, 0, len(self._memory))
        self._library.shim_start(self._memory)

    def run(self, cycles: Cycles) -> int:
        """Run recorded cycles; the number of frames that the master sent."""
        count = len(cycles.arrived)
        arrays = pointer(cycles.wishes), pointer(cycles.arrived)
        sent: int = self._library.shim_replay(self._memory, *arrays, cycles.frames, count)
        return sent

    @property
    def end(self) -> bytes:
        """What is to be seen of the last cycle."""
        self._library.shim_look(self._memory, pointer(self._view))
        return self._view.tobytes()


def cycle_costs(machine: Machine, folder: Path, cycles: int, repetitions: int) -> list[CycleRow]:
    """Time a master in both precisions; RuntimeError where it does not do what it did before."""
    return [
        cycle_cost(Generated(machine, folder, precision), cycles, repetitions)
        for precision in ("double", "float")
    ]


def cycle_cost(generated: Generated, cycles: int, repetitions: int) -> CycleRow:
    """Record a master's bring-up and work, and time the work."""
    recorder = Recorder(generated)
    before, work = recorder.bring_up(), recorder.work(cycles)
    return time_work(Replay(generated), before, work, repetitions)


def time_work(replay: Replay, before: Cycles, work: Cycles, repetitions: int) -> CycleRow:
    """Run what was recorded before the work, then the work by the clock, so many times."""
    cycles = len(work.arrived)
    spent = []
    for _ in range(repetitions):
        replay.power_on()
        replay.run(before)
        begin = time.thread_time_ns()
        sent = replay.run(work)
        spent.append((time.thread_time_ns() - begin) / cycles)
        if replay.end != work.end:
            raise RuntimeError("the master's last cycle is not the one that was recorded")
    frames = (sent + int(work.arrived.sum())) / cycles
    return CycleRow(replay.precision, Timing(min(spent), median(spent)), frames)


def replay_library(generated: Generated) -> ctypes.CDLL:
    """The lockstep's runtime, with replay.c around it."""
    sources = [path for folder in FOLDERS for path in sorted(folder.glob("*.c"))]
    sources += [*sorted(generated.folder.glob("*.c")), *PORTABLE_CAN, REPLAY]
    include = [generated.folder, *FOLDERS, CAN]
    library = ctypes.CDLL(str(compile_library(sources, include, generated.precision)))
    library.shim_replay.argtypes = [*[ctypes.c_void_p] * 4, ctypes.c_size_t]
    library.shim_look.argtypes = [ctypes.c_void_p] * 2
    for name in ("replay", "machine_size"):
        getattr(library, f"shim_{name}").restype = ctypes.c_size_t
    return library
