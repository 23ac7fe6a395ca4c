"""Simulated time for the program: the other end of runtime/port/linux/simulated_clock.h.

The program says until when it sleeps and how many frames it has sent. When these have come, however
long that takes the computer, simulated time passes, and the program is told how many frames have
been sent to it meanwhile.
"""

import select
import socket
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from struct import Struct
from typing import Protocol

import can

from turnbuckle.lab.drives.bus import SYNC, SimulatedBus
from turnbuckle.lab.drives.node import Frame
from turnbuckle.lab.drives.runner import is_for_drives

POLL = 0.02
"""Seconds of the computer's time between two looks at what does not wake us."""
NANO = 1e-9


class Simulation(Protocol):
    """What is simulated."""

    buses: list[SimulatedBus]

    @property
    def time(self) -> float:
        """Now [s]."""

    def run_until(self, time: float) -> None:
        """Let time [s] pass."""


@dataclass
class Line:
    """A bus of the program, and the frames that have gone over its port since it connected."""

    port: can.BusABC
    bus: SimulatedBus
    waiting: list[Frame] = field(default_factory=list)
    """Frames of the program that are not on the bus yet."""
    received: int = 0
    sent: int = 0
    is_gone: bool = False
    """The port has no other end any more."""

    def begin(self) -> None:
        """Forget what was on its way before there was a program."""
        self.receive()
        self.bus.take()
        self.waiting.clear()
        self.received = self.sent = 0

    def receive(self) -> None:
        """Read what has come."""
        while (message := self._next()) is not None:
            self.received += 1
            if is_for_drives(message):
                self.waiting.append(Frame(message.arbitration_id, bytes(message.data)))

    def _next(self) -> can.Message | None:
        try:
            return None if self.is_gone else self.port.recv(timeout=0)
        except can.CanOperationError:
            self.is_gone = True
            return None

    def send(self, frame: Frame) -> None:
        """Let a frame arrive at the program, where somebody is there to take it."""
        if self.is_gone:
            return
        message = can.Message(arbitration_id=frame.cob, data=frame.data, is_extended_id=False)
        try:
            self.port.send(message, timeout=0)
            self.sent += 1
        except can.CanOperationError:
            return


class SimulatedClock:
    """Keeps the time of one program after the other; `path` is what they take for --clock."""

    def __init__(
        self, simulation: Simulation, ports: Sequence[can.BusABC], compute_time: float = 0.0
    ) -> None:
        """ports: one for each bus, in its order, all of them files.

        compute_time [s] passes until frames leave a program that computes them, all but SYNC.
        """
        self._simulation, self._compute_time = simulation, compute_time
        self._lines = [Line(port, bus) for port, bus in zip(ports, simulation.buses, strict=True)]
        self._moment = Struct(f"=q{len(self._lines)}Q")
        self._now = 0  # ns
        self._listener = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self._listener.bind("")  # a name that nobody has, and that is no file
        self._listener.listen()
        self.path = self._listener.getsockname().replace(b"\0", b"@").decode()

    def close(self) -> None:
        """Give the name back; a program that comes later finds nobody."""
        self._listener.close()

    def run(self, is_over: Callable[[], bool]) -> None:
        """Keep the time of the next program from its beginning to its end, or until it is over."""
        connection = self._await_program(is_over)
        if connection is None:
            return
        with connection:
            while not is_over() and self._serve(connection):
                pass

    def unplug(self, bus: int) -> None:
        """Fault: take the port of a bus away."""
        self._lines[bus].is_gone = True
        self._lines[bus].port.shutdown()

    def _await_program(self, is_over: Callable[[], bool]) -> socket.socket | None:
        while not is_over():
            self._receive()
            files = [line.port.fileno() for line in self._lines if not line.is_gone]
            ready, _, _ = select.select([self._listener.fileno(), *files], [], [], POLL)
            if self._listener.fileno() in ready:
                self._begin()
                return self._listener.accept()[0]
        return None

    def _begin(self) -> None:
        for line in self._lines:
            line.begin()
        self._now = max(self._now, round(self._simulation.time / NANO))

    def _serve(self, connection: socket.socket) -> bool:
        """Answer once, if the program asks; whether it still runs."""
        if not is_readable(connection, POLL):
            self._receive()  # commands: the program opens or closes its adapters
            return True
        try:
            asked = connection.recv(self._moment.size + 1)
            if len(asked) == self._moment.size:
                connection.send(self._answer(connection, asked))
                return True
        except ConnectionError:  # it was killed
            pass
        self._receive()  # its last frames
        self._put_on_buses()
        return False

    def _answer(self, connection: socket.socket, asked: bytes) -> bytes:
        until, *sent = self._moment.unpack(asked)
        for line, count in zip(self._lines, sent, strict=True):
            self._await_frames(connection, line, count)
        self._put_on_buses()
        self._let_time_pass(until)
        return self._moment.pack(self._now, *(line.sent for line in self._lines))

    def _await_frames(self, connection: socket.socket, line: Line, count: int) -> None:
        """Read until so many frames have come; a program that says more meanwhile has ended."""
        line.receive()
        while line.received < count and not line.is_gone:
            ready, _, _ = select.select([line.port.fileno(), connection.fileno()], [], [])
            if connection.fileno() in ready:
                return
            line.receive()

    def _let_time_pass(self, until: int) -> None:
        if until > self._now:
            self._simulation.run_until(until * NANO)
            self._now = until
        for line in self._lines:
            for frame in line.bus.take():
                line.send(frame)

    def _receive(self) -> None:
        for line in self._lines:
            line.receive()

    def _put_on_buses(self) -> None:
        """In the order of the buses, whichever frames came first."""
        for line in self._lines:
            for frame in line.waiting:
                line.bus.send(frame, 0.0 if frame.cob == SYNC else self._compute_time)
            line.waiting.clear()


def is_readable(file: socket.socket, seconds: float) -> bool:
    """Whether there is something to read, now or within a time."""
    return bool(select.select([file], [], [], seconds)[0])
