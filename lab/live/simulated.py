"""Simulated drives in a process of their own, behind serial CAN adapters on pseudo-terminals.

The process is also the machine's application: it measures the hand, and once the machine runs it
lets the hand begin its task and asks for the task's forces, all by way of the shared file.
"""

import multiprocessing
import os
import signal
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection
from pathlib import Path

from codegen.bind import load
from lab.demo import plan_task, plant_of
from lab.drives.runner import Runner
from lab.drives.slcan_adapter import SlcanAdapter
from lab.live import LiveError
from lab.live.telemetry import Telemetry
from lab.live.words import STATES
from lab.machine_sim import SimulatedMachine
from model.machine import Machine, load_machine

PATIENCE = 120
"""Seconds that the other process may take to begin."""
LOOKS = 20
"""Cycles between two looks at what the machine does."""
RUNNING = STATES.index("RUN")


@contextmanager
def simulated_drives(machine: Machine, pace: int, telemetry: Path) -> Iterator[list[str]]:
    """NAME=slcan:LINE of every bus, as the program takes it, while the context lasts.

    Raises MachineError for a machine that cannot be simulated, LiveError where it does not begin.
    """
    plant_of(machine)
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(
        target=simulate, args=(theirs, machine.path, pace, telemetry), daemon=True
    )
    process.start()
    theirs.close()
    try:
        lines = first_words(ours)
        yield [f"{bus.name}=slcan:{line}" for bus, line in zip(machine.buses, lines, strict=True)]
    finally:
        ours.close()  # the other process ends when nobody listens
        process.join()


def first_words(ours: Connection) -> list[str]:
    """The lines that the other process has opened."""
    try:
        if ours.poll(PATIENCE):
            lines: list[str] = ours.recv()
            return lines
    except EOFError:
        pass
    raise LiveError("the simulated drives did not start")


def simulate(parent: Connection, file: Path, pace: int, telemetry: Path) -> None:
    """Run the drives of a machine until the parent is gone; Ctrl-C is the parent's affair."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    take_priority()
    machine = load_machine(file)
    world = SimulatedMachine(machine, plant_of(machine), plan_task(load(file)))
    adapters = [SlcanAdapter() for _ in world.buses]
    parent.send([adapter.path for adapter in adapters])
    Runner(Application(world, telemetry), adapters, pace).run(parent.poll)
    for adapter in adapters:
        adapter.shutdown()


def take_priority() -> None:
    """Drives do not wait for other programs: go before them, where that is permitted."""
    with suppress(PermissionError):
        os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(1))


class Application:
    """A simulated machine with what belongs to it beside its drives: force sensor and task."""

    def __init__(self, world: SimulatedMachine, path: Path) -> None:
        self.buses, self.period = world.buses, world.period
        self._world, self._path = world, path
        self._telemetry: Telemetry | None = None
        self._begun = False
        self._cycles = 0

    def advance(self) -> None:
        """Let one control cycle pass."""
        self._world.advance()
        if self._cycles % LOOKS == 0:
            self._look()
        self._cycles += 1
        if self._telemetry is not None:
            self._telemetry.push_hand_force(self._world.world.hand_force)
            if self._begun:
                self._telemetry.push_force(self._world.task_force)

    def _look(self) -> None:
        """Find the program; begin the task when it runs the machine."""
        if self._telemetry is None:
            self._telemetry = running(self._path)
        elif not self._begun:
            cycle = self._telemetry.latest()
            if cycle is not None and cycle["state"] == RUNNING:
                self._world.begin_task()
                self._begun = True


def running(path: Path) -> Telemetry | None:
    """The telemetry of a program that runs; None while there is none."""
    try:
        telemetry = Telemetry(path)
    except LiveError:
        return None
    if telemetry.ended:
        telemetry.close()
        return None
    return telemetry
