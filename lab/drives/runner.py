"""Simulated buses in real time: behind python-can ones, for masters that keep their own time.

The runtime's program lives by the simulation's instead: simulated_clock.py. Here simulated time is
wall time divided by `pace`: with a pace of 5 a master has to run five times slower than on real
drives, and the computer has five times as long for the physics.
"""

import select
import time
from collections.abc import Callable, Sequence
from typing import Protocol

import can

from turnbuckle.lab.drives.bus import SimulatedBus
from turnbuckle.lab.drives.node import Frame

CATCH_UP = 20
"""Cycles that are made up for at once; what is missing beyond them is given up."""
POLL = 100e-6
"""Time between two looks at a port that cannot be waited for [s]."""


class Simulation(Protocol):
    """What is run."""

    buses: list[SimulatedBus]
    period: float

    def advance(self) -> None:
        """Let one control cycle pass."""


class Runner:
    """Carries frames between ports and simulated buses, and lets simulated time pass."""

    def __init__(
        self, simulation: Simulation, ports: Sequence[can.BusABC], pace: float = 1.0
    ) -> None:
        """ports: one for each bus, in its order."""
        self._simulation = simulation
        self._pairs = list(zip(ports, simulation.buses, strict=True))
        self._interval = simulation.period * pace
        self._files = [file_of(port) for port in ports]
        self.skipped = 0
        """Cycles that were given up, because the computer was too slow."""

    def run(self, is_over: Callable[[], bool]) -> None:
        """Run until it is over."""
        due = time.monotonic() + self._interval
        while not is_over():
            self._exchange(due - time.monotonic())
            due = self._catch_up(due)

    def _catch_up(self, due: float) -> float:
        """Run the cycles that are due; when the next one is."""
        now = time.monotonic()
        behind = int((now - due) / self._interval) - CATCH_UP
        if behind > 0:
            self.skipped += behind
            due += behind * self._interval
        while due <= now:
            self._simulation.advance()
            self._answer()
            self._exchange(0.0)
            due += self._interval
        return due

    def _waiting(self, seconds: float) -> list[tuple[can.BusABC, SimulatedBus]]:
        """Where frames have come, or do within the time."""
        if min(self._files) < 0:
            time.sleep(max(0.0, min(seconds, POLL)))
            return self._pairs
        ready, _, _ = select.select(self._files, [], [], max(0.0, seconds))
        return [self._pairs[self._files.index(file)] for file in ready]

    def _exchange(self, seconds: float) -> None:
        """Hand the drives what comes, and back what they answer; wait for it if there is time."""
        for port, bus in self._waiting(seconds):
            while (message := receive(port)) is not None:
                if is_for_drives(message):
                    bus.send(Frame(message.arbitration_id, bytes(message.data)))
                    self._answer()

    def _answer(self) -> None:
        for port, bus in self._pairs:
            for cob, data in bus.take():
                send(port, can.Message(arbitration_id=cob, data=data, is_extended_id=False))


def file_of(port: can.BusABC) -> int:
    """What can be waited for; -1 for a port that has no file."""
    try:
        return port.fileno()
    except NotImplementedError:
        return -1


def receive(port: can.BusABC) -> can.Message | None:
    """The next frame; None when there is none, or the interface was taken down."""
    try:
        return port.recv(timeout=0)
    except can.CanOperationError:
        return None


def send(port: can.BusABC, message: can.Message) -> None:
    """Send a frame; a port without room loses it, as a bus without a listener does."""
    try:
        port.send(message, timeout=0)
    except can.CanOperationError:
        return


def is_for_drives(message: can.Message) -> bool:
    """Whether it is a frame that CANopen drives look at."""
    return not (message.is_extended_id or message.is_remote_frame or message.is_error_frame)
