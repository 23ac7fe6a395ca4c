"""Simulated drives in a process of their own: behind serial CAN adapters on pseudo-terminals, or on
interfaces of the kernel. The simulation is the program's clock.

The process is also the machine's application: it measures the hand, and once the machine runs it
lets the hand begin its task and asks for the task's forces, all by way of the shared file.
"""

import multiprocessing
import signal
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from multiprocessing.connection import Connection
from pathlib import Path
from typing import NamedTuple

import can
from can.interfaces.socketcan import SocketcanBus

from turnbuckle.lab.drives.simulated_clock import SimulatedClock
from turnbuckle.lab.drives.slcan_adapter import SlcanAdapter
from turnbuckle.lab.drives.wire import Conditions
from turnbuckle.lab.live import LiveError
from turnbuckle.lab.live.telemetry import Telemetry, running
from turnbuckle.lab.machine_sim import ORDINARY, SimulatedMachine
from turnbuckle.lab.task import Task
from turnbuckle.model.machine import Machine, Plant

PATIENCE = 120
"""Seconds that the other process may take to begin."""
LOOKS = 20
"""Cycles between two looks at what the machine does."""
SOCKETCAN = "socketcan:"


class Bench(NamedTuple):
    """What is simulated."""

    machine: Machine
    plant: Plant | None
    task: Task | None
    """Without plant and task a hand holds the platform fast and leads it."""
    rails: Sequence[float] | None = None
    """Where the bases were left [m] (m); None for anywhere."""
    conditions: Conditions = ORDINARY
    """What the wires are like."""

    def power_on(self) -> SimulatedMachine:
        """The machine, switched on now."""
        return SimulatedMachine(
            self.machine, self.plant, self.task, self.rails, conditions=self.conditions
        )


@contextmanager
def simulated_drives(
    bench: Bench, telemetry: Path, buses: Sequence[str] = ()
) -> Iterator[list[str]]:
    """The program's options for every bus and for its clock, while the context lasts.

    buses: NAME=socketcan:INTERFACE for those that are interfaces of the kernel; the others are
    serial lines. Raises LiveError where it does not begin.
    """
    on = interfaces(buses, [bus.name for bus in bench.machine.buses])
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=simulate, args=(theirs, bench, telemetry, on), daemon=True)
    process.start()
    theirs.close()
    try:
        yield first_words(ours)
    finally:
        ours.close()  # the other process ends when nobody listens
        process.join()


def first_words(ours: Connection) -> list[str]:
    """The options for what the other process has opened."""
    try:
        if ours.poll(PATIENCE):
            words: list[str] | str = ours.recv()
            if isinstance(words, str):
                raise LiveError(words)
            return words
    except EOFError:
        pass
    raise LiveError("the simulated drives did not start")


def simulate(parent: Connection, bench: Bench, telemetry: Path, on: dict[str, str]) -> None:
    """Run the drives of a machine for one program, or until the parent is gone; Ctrl-C is the
    parent's affair."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    world = bench.power_on()
    names = [bus.name for bus in world.buses]
    try:
        ports = [open_port(on.get(name)) for name in names]
    except LiveError as error:
        parent.send(str(error))
        return
    compute_time = bench.machine.supervision.compute_time
    clock = SimulatedClock(Application(world, telemetry), ports, compute_time)
    ways = [f"--bus={name}={way_to(port)}" for name, port in zip(names, ports, strict=True)]
    parent.send([*ways, f"--clock={clock.path}"])
    clock.run(parent.poll)
    clock.close()
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


class Application:
    """A simulated machine with what belongs to it beside its drives: force sensor and task."""

    def __init__(self, world: SimulatedMachine, path: Path) -> None:
        self.buses = world.buses
        self._world, self._path = world, path
        self._telemetry: Telemetry | None = None
        self._begun = False
        self._look_at = 0.0

    @property
    def time(self) -> float:
        """Simulated time [s]."""
        return self._world.time

    def run_until(self, time: float) -> None:
        """Let simulated time [s] pass; then tell the program forces as they are now."""
        self._world.run_until(time)
        if self.time >= self._look_at:
            self._look_at = self.time + LOOKS * self._world.period
            self._look()
        if self._telemetry is not None:
            self._telemetry.push_hand_force(self._world.world.hand_force)
            if self._begun:
                self._telemetry.push_force(self._world.task_force)

    def _look(self) -> None:
        """Find the program; begin the task when it runs the machine."""
        if self._telemetry is None:
            self._telemetry = running(self._path)
        elif not self._begun and (cycle := self._telemetry.latest()) is not None:
            layouts = self._telemetry.layouts
            if layouts.name("phase", cycle["phase"]) == "SWEEP":
                self._world.wander()
            if layouts.name("state", cycle["state"]) == "RUN":
                self._world.begin_task()
                self._begun = True
