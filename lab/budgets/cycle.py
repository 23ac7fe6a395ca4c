"""Instructions of whole control cycles in RUN on a Cortex-M4F, and of the controller step in them.

The runtime is brought up on an emulated processor. What its memory holds before the two steps of a
cycle, SYNC and the run, goes to a second emulator, which makes the step and counts.
"""

import ctypes
from bisect import bisect_right
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.benchmark.cortex_m4.emulator import RAM, Emulator
from turnbuckle.lab.emulated.processor import M4F
from turnbuckle.lab.emulated.target import Target
from turnbuckle.lab.emulated.twin import Twin, twins
from turnbuckle.lab.lockstep import State
from turnbuckle.lab.machine_sim import SimulatedMachine

FLASH, FLASH_SIZE = 0x0, 0x100000
"""Where mps2.ld puts the program."""
STEP = "tb_controller_step"
LONGEST = 60_000
"""Cycles from power-on to RUN, at most."""
GROUPS, APART, COUNTED = 12, 50, 4
"""Groups of cycles of work that are counted, those in between, and how many are in a group: bases
have a SYNC in every second or fourth cycle."""


@dataclass(frozen=True)
class Moment:
    """Before a step of the master."""

    function: str
    variables: bytes
    """All of the program's."""
    wishes: bytes
    """What is handed to the function; empty where nothing is."""


@dataclass(frozen=True)
class Counts:
    """Instructions."""

    cycles: list[int]
    """Of every cycle: SYNC, and the run with all that it calls."""
    steps: list[int]
    """Of the controller step in every cycle."""
    by_function: Counter[str]
    """Of every function itself, in all cycles."""
    stack: int
    """Bytes of the stack that were used from power-on to the end, the lockstep's own among them."""


class Watched(Twin):
    """A Twin that keeps the moments before the steps of the master."""

    def __init__(self, host: ctypes.CDLL, target: Target) -> None:
        super().__init__(host, target)
        self.keeps = False
        """Whether moments are kept from now on."""
        self.moments: list[Moment] = []

    def shim_sync(self, memory: Any, sent: Any, room: int) -> int:
        """Send SYNC."""
        self._keep("tb_master_sync", b"")
        return super().shim_sync(memory, sent, room)

    def shim_run(self, memory: Any, wishes: Any, missed: int, sent: Any, room: int) -> int:
        """Run the cycle."""
        self._keep("tb_master_run", ctypes.string_at(wishes, self._wishes))
        return super().shim_run(memory, wishes, missed, sent, room)

    def _keep(self, function: str, wishes: bytes) -> None:
        if self.keeps:
            self.compare_last()
            self.moments.append(Moment(function, self.target.variables(), wishes))


class CycleCounter(Emulator):
    """A program that makes steps of the master, and counts what they take."""

    def __init__(self, image: Path, master: int) -> None:
        """master: address of the tb_master."""
        super().__init__(image, [(FLASH, FLASH_SIZE)])
        self.by_function: Counter[str] = Counter()
        self.in_step = 0
        """Instructions of the controller step, since it was set to 0."""
        self._master = master
        named = sorted((address & ~1, name) for name, address in self._symbols.items())
        self._addresses = [address for address, _ in named]
        self._names = [name for _, name in named]
        self._begins, self._ends, self._before = self._symbols[STEP] & ~1, 0, 0

    def make(self, moment: Moment) -> int:
        """Make a step of the master; returns the instructions it took."""
        self.put(RAM, moment.variables)
        self.free_all()
        wishes = [self.place(moment.wishes), 0] if moment.wishes else []
        return self.call(moment.function, self._master, *wishes)

    def _on_block(self, _cpu: object, address: int, size: int, _data: object) -> None:
        if address == self._begins:
            self._ends, self._before = self.return_address & ~1, self._count
        elif address == self._ends:
            self.in_step += self._count - self._before
            self._ends = 0
        before = self._count
        super()._on_block(_cpu, address, size, _data)
        self.by_function[self._name_at(address)] += self._count - before

    def _name_at(self, address: int) -> str:
        name: str = self._names[bisect_right(self._addresses, address) - 1]
        return name


def count_cycles(generated: Generated, machine: SimulatedMachine, image: Path) -> Counts:
    """Bring a machine up from power-on, let it work, and count; RuntimeError where it fails.

    image: the lockstep's, of this machine.
    """
    with twins(generated, machine, M4F, image, Watched) as (lockstep, twin):
        if lockstep.bring_up(LONGEST) is not State.RUN:
            raise RuntimeError(f"{generated.machine.name} does not come to RUN: {lockstep.view}")
        machine.begin_task(repeat=True)
        for _ in range(GROUPS):
            twin.keeps = False
            lockstep.run(APART)
            twin.keeps = True
            lockstep.run(COUNTED)
        twin.compare_last()
        facts = twin.target.facts()
    counter = CycleCounter(image, facts.master)
    return counted(counter, twin.moments, facts.stack)


def counted(counter: CycleCounter, moments: Sequence[Moment], stack: int) -> Counts:
    """Count the steps of some cycles, two a cycle."""
    cycles, steps = [], []
    for pair in zip(moments[::2], moments[1::2], strict=True):
        counter.in_step = 0
        cycles.append(sum(counter.make(moment) for moment in pair))
        steps.append(counter.in_step)
    return Counts(cycles, steps, counter.by_function, stack)
