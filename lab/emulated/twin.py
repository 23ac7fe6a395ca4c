"""The same runtime twice, on this computer and on an emulated processor, and every bit compared.

A Twin takes the place of the library in a Lockstep: the simulated machine runs once, on the answers
of this computer. As long as they are those of the processor, the machine would do the same with it.
"""

import ctypes
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeVar, cast

import numpy as np

from turnbuckle.codegen.bind import Generated, pointer
from turnbuckle.codegen.struct_layout import ROW
from turnbuckle.lab.emulated.processor import Processor
from turnbuckle.lab.emulated.target import Target
from turnbuckle.lab.lockstep import FRAME, BusState, Lockstep, layouts_of, load
from turnbuckle.lab.machine_sim import SimulatedMachine

Answer = list[tuple[str, bytes]]
"""What is answered to a request: names and bytes."""


WIDEST = 8
"""Bytes of a number."""


class Difference(AssertionError):
    """The processor has answered otherwise than this computer."""


class Twin:
    """Both builds of the runtime, called as lab.lockstep calls one.

    The processor computes while the simulation goes on: an answer is read, and compared, before the
    next request. Raises Difference at the first bit that differs, with the number of its cycle.
    """

    def __init__(self, host: ctypes.CDLL, target: Target) -> None:
        self.host, self.target = host, target
        self.frames = 0
        """Frames that were compared."""
        self.cycles = 0
        """Cycles that were compared, each with its view."""
        layouts = layouts_of(host)
        self._view = np.zeros(1, layouts.struct("view"))
        self._wishes = layouts.struct("wishes").itemsize
        self._expected: Answer = []
        rows = ctypes.c_uint32.in_dll(host, "shim_layout_rows").value
        described = bytes((ctypes.c_char * (rows * ROW.itemsize)).in_dll(host, "shim_layout"))
        self._compare("the layout of tb_view", described, target.facts().layout)

    def shim_adopt(self, memory: Any) -> None:
        """Both have just been started: nothing is to be handed over."""

    def shim_sync(self, memory: Any, sent: Any, room: int) -> int:
        """Send SYNC."""
        self.compare_last()
        self.target.ask_sync()
        count: int = self.host.shim_sync(memory, sent, room)
        self._expected = [("frames", bytes(memoryview(sent)[: count * FRAME.size]))]
        return count

    def shim_run(self, memory: Any, wishes: Any, missed: int, sent: Any, room: int) -> int:
        """Run the cycle."""
        self.compare_last()
        self.target.ask_run(ctypes.string_at(wishes, self._wishes), missed)
        count: int = self.host.shim_run(memory, wishes, missed, sent, room)
        self.host.shim_look(memory, pointer(self._view))
        frames = bytes(memoryview(sent)[: count * FRAME.size])
        self._expected = [("view", self._view.tobytes()), ("frames", frames)]
        return count

    def shim_give(self, memory: Any, packed: bytes, count: int) -> int:
        """Let frames arrive."""
        self.compare_last()
        self.target.ask_give(packed)
        taken: int = self.host.shim_give(memory, packed, count)
        self._expected = [("taken", taken.to_bytes(4, "little"))]
        return taken

    def shim_look(self, memory: Any, view: Any) -> None:
        """What this computer sees of the last cycle; compared when the cycle was run."""
        self.host.shim_look(memory, view)

    def shim_set_bus(self, memory: Any, bus: int, state: int, full: int) -> None:
        """Fault: bring a bus into a state."""
        self.compare_last()
        self.target.set_bus(bus, BusState(state), bool(full))
        self.host.shim_set_bus(memory, bus, state, full)

    def compare_last(self) -> None:
        """Read what the processor has answered to the last request."""
        expected, self._expected = self._expected, []
        for name, here in expected:
            if name == "view":
                self._compare_views(here, self.target.read_view())
                self.cycles += 1
            elif name == "frames":
                self._compare("the frames sent", here, self.target.read_sent())
                self.frames += len(here) // FRAME.size
            else:
                there = self.target.read_word().to_bytes(4, "little")
                self._compare("the number of frames taken", here, there)

    def _compare_views(self, here: bytes, there: bytes) -> None:
        if here == there:
            return
        views = [np.frombuffer(each, self._view.dtype)[0] for each in (here, there)]
        for name in self._view.dtype.names or ():
            ours, theirs = (np.atleast_1d(view[name]) for view in views)
            for i, entries in enumerate(zip(ours, theirs, strict=True)):
                self._compare(f"{name}[{i}]", *(entry.tobytes() for entry in entries))

    def _compare(self, name: str, here: bytes, there: bytes) -> None:
        if here != there:
            bits = [
                each[::-1].hex() if len(each) <= WIDEST else each.hex() for each in (here, there)
            ]
            raise Difference(
                f"cycle {self.cycles}: {name}: here {bits[0]}, on the processor {bits[1]}"
            )


SomeTwin = TypeVar("SomeTwin", bound=Twin)


@contextmanager
def twins(
    generated: Generated,
    machine: SimulatedMachine,
    processor: Processor,
    image: Path,
    kind: type[SomeTwin],
) -> Iterator[tuple[Lockstep, SomeTwin]]:
    """A machine at power-on, its master on this computer and, from an image, on a processor."""
    lockstep = Lockstep(generated, machine)
    with Target(processor, image, lockstep.view.dtype.itemsize) as target:
        twin = kind(load(generated), target)
        lockstep.exchange_runtime(cast(ctypes.CDLL, twin))
        yield lockstep, twin
