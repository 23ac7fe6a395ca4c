"""Simulated drives in a process of their own: behind serial CAN adapters on pseudo-terminals, or on
interfaces of the kernel.

The process is also the machine's application: it measures the hand, and once the machine runs it
lets the hand begin its task and asks for the task's forces, all by way of the shared file.
"""

import multiprocessing
import os
import signal
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection
from pathlib import Path
from typing import NamedTuple

import can
from can.interfaces.socketcan import SocketcanBus

from lab.drives.runner import Runner
from lab.drives.slcan_adapter import SlcanAdapter
from lab.live import LiveError
from lab.live.telemetry import Telemetry
from lab.live.words import STATES
from lab.machine_sim import SimulatedMachine
from lab.task import Task
from model.machine import Machine, Plant

PATIENCE = 120
"""Seconds that the other process may take to begin."""
LOOKS = 20
"""Cycles between two looks at what the machine does."""
RUNNING = STATES.index("RUN")
SOCKETCAN = "socketcan:"


class Bench(NamedTuple):
    """What is simulated."""

    machine: Machine
    plant: Plant
    task: Task
    rails: Sequence[float] | None = None
    """Where the bases were left [m] (m); None for anywhere."""

    def power_on(self) -> SimulatedMachine:
        """The machine, switched on now."""
        return SimulatedMachine(self.machine, self.plant, self.task, self.rails)


@contextmanager
def simulated_drives(
    bench: Bench, pace: int, telemetry: Path, buses: Sequence[str] = ()
) -> Iterator[list[str]]:
    """Every bus as the program takes it, while the context lasts.

    buses: NAME=socketcan:INTERFACE for those that are interfaces of the kernel; the others are
    serial lines. Raises LiveError where it does not begin.
    """
    on = interfaces(buses, [bus.name for bus in bench.machine.buses])
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(
        target=simulate, args=(theirs, bench, pace, telemetry, on), daemon=True
    )
    process.start()
    theirs.close()
    try:
        yield first_words(ours)
    finally:
        ours.close()  # the other process ends when nobody listens
        process.join()


def first_words(ours: Connection) -> list[str]:
    """The buses that the other process has opened."""
    try:
        if ours.poll(PATIENCE):
            words: list[str] | str = ours.recv()
            if isinstance(words, str):
                raise LiveError(words)
            return words
    except EOFError:
        pass
    raise LiveError("the simulated drives did not start")


def simulate(
    parent: Connection, bench: Bench, pace: int, telemetry: Path, on: dict[str, str]
) -> None:
    """Run the drives of a machine until the parent is gone; Ctrl-C is the parent's affair."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    take_priority()
    world = bench.power_on()
    names = [bus.name for bus in world.buses]
    try:
        ports = [open_port(on.get(name)) for name in names]
    except LiveError as error:
        parent.send(str(error))
        return
    parent.send([f"{name}={way_to(port)}" for name, port in zip(names, ports, strict=True)])
    Runner(Application(world, telemetry), ports, pace).run(parent.poll)
    for port in ports:
        port.shutdown()


def interfaces(buses: Sequence[str], names: Sequence[str]) -> dict[str, str]:
    """Interface of every bus that has one, from NAME=socketcan:INTERFACE."""
    found = {}
    for bus in buses:
        name, _, way = bus.partition("=")
        if name not in names:
            raise LiveError(
                f"--bus {bus}: found the bus {name!r}; allowed: one of {', '.join(names)}"
            )
        found[name] = way.removeprefix(SOCKETCAN)
    return found


def open_port(interface: str | None) -> can.BusABC:
    """An interface of the kernel, or without one a new serial line.

    Raises LiveError for an interface that cannot be opened.
    """
    if interface is None:
        return SlcanAdapter()
    try:
        return SocketcanBus(interface)
    except OSError as error:
        raise LiveError(
            f"{interface}: {error.strerror}; allowed: a CAN interface that is up, such as"
            f" sudo ip link add {interface} type vcan && sudo ip link set {interface} up"
        ) from error


def way_to(port: can.BusABC) -> str:
    """How the program gets at the other end of a port."""
    if isinstance(port, SlcanAdapter):
        return f"slcan:{port.path}"
    assert isinstance(port, SocketcanBus)
    return f"{SOCKETCAN}{port.channel}"


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
