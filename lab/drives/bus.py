"""A simulated CAN bus: its drives, the frames on it, and what can go wrong with a frame."""

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from math import inf
from random import Random
from typing import NamedTuple

from turnbuckle.lab.drives.drive import SYNC, Drive
from turnbuckle.lab.drives.node import Frame
from turnbuckle.lab.drives.setup import Setup
from turnbuckle.lab.drives.wire import Wire, is_cyclic, phase_of

ROUNDING = 1e-9
"""By which a sum of frames may miss a time [s]."""


class Mishap(Enum):
    """What can happen to a frame."""

    DROP = "is lost"
    DUPLICATE = "comes twice"
    DELAY = "comes so many cycles later"
    CORRUPT = "has bits flipped"
    SHORTEN = "has lost its last byte"


@dataclass(frozen=True)
class Disturbance:
    """What happens to one frame."""

    mishap: Mishap
    cycles: int = 0
    """Of a delay."""
    flips: bytes = b""
    """Bits that are flipped in the data, from its first byte on."""

    def flipped(self, frame: Frame) -> Frame:
        """The frame with its bits flipped."""
        flips = self.flips.ljust(len(frame.data), b"\0")
        data = bytes(a ^ b for a, b in zip(frame.data, flips, strict=False))
        return Frame(frame.cob, data)


Listener = Callable[[Frame, bool], None]
"""Told of every frame on the wire, and whether a drive sent it."""


class Intruder:
    """Somebody on the bus who is no drive of it."""


Sender = Drive | Intruder | None
"""Who sent a frame; None for the master."""


class Waiting(NamedTuple):
    """A frame that waits for its turn on the wire."""

    ready: float
    """When it may be sent [s]."""
    cob: int
    number: int
    """Of all frames; what is ready in the same moment keeps its order."""
    frame: Frame
    sender: Sender


class SimulatedBus:
    """Drives on one bus; whoever else is on it calls send and take.

    With a wire, frames take their time: they move in run_until, one after the other, the most
    urgent of those that wait first. Frames of the master keep their order, as in an adapter.
    Without a wire frames take no time at all: that is for tests of single drives.
    """

    def __init__(self, name: str, setups: list[Setup], wire: Wire | None = None) -> None:
        self.name = name
        self.drives: list[Drive] = []
        self.listeners: list[Listener] = []
        self.time = 0.0
        """Until when frames have moved [s]."""
        self._wire = wire
        self._chance = Random(f"{name} {wire.conditions.seed if wire else 0}")
        self._disturbances: dict[int, deque[Disturbance]] = {}
        self._late: list[tuple[int, Frame, Sender]] = []
        self._cycle = 0
        self._began = 0.0
        self._answers: list[Frame] = []
        self._number = 0
        self._masters: deque[Waiting] = deque()
        self._others: list[Waiting] = []
        self._on_wire: Waiting | None = None
        self._free = 0.0
        """When the wire is free again [s]."""
        self._phase: int | None = None
        self._is_quiet = True
        """No frame outside the cycle has come since the last phase began."""
        for setup in setups:
            self.add(setup)

    def add(self, setup: Setup) -> Drive:
        """Put another drive on the bus; its node may be taken already, which is a fault."""
        drive = Drive(setup, lambda frame: self._queue(frame, drive))
        self.drives.append(drive)
        return drive

    def drive(self, node: int) -> Drive:
        """The first drive with this number."""
        return next(drive for drive in self.drives if drive.node == node)

    def disturb(self, cob: int, disturbance: Disturbance, count: int = 1) -> None:
        """Let this happen to the next `count` frames of a COB-ID."""
        self._disturbances.setdefault(cob, deque()).extend([disturbance] * count)

    def send(self, frame: Frame, after: float = 0.0) -> None:
        """Hand a frame to the master's controller, so long [s] from now."""
        if self._wire is None:
            self._carry(frame, None)
            self._arbitrate()
        else:
            self._let_foreign_go_first(frame, self.time + after)
            self._masters.append(self._waiting(self.time + after, frame, None))

    def intrude(self, frame: Frame) -> None:
        """Fault: somebody who does not belong there puts a frame on the bus."""
        self._queue(frame, Intruder())
        self._arbitrate()

    def take(self) -> list[Frame]:
        """What has reached the master since the last call, in the order on the bus."""
        self._arbitrate()
        answers, self._answers = self._answers, []
        return answers

    def run_until(self, time: float) -> None:
        """Let frames move until then [s]."""
        while self._on_wire is not None or self._begin_frame(time):
            if self._free > time + ROUNDING:
                break
            self.time = self._free
            sent, self._on_wire = self._on_wire, None
            assert sent is not None
            self._carry(sent.frame, sent.sender)
        self.time = time

    def next_cycle(self) -> None:
        """A control cycle is over: late frames come nearer."""
        self._cycle += 1
        self._began = self.time
        if self._late:
            due = [late for late in self._late if late[0] <= self._cycle]
            self._late = [late for late in self._late if late[0] > self._cycle]
            for _, frame, sender in due:
                self._deliver(frame, sender)

    # -- turns on the wire --------------------------------------------------------------------

    def _queue(self, frame: Frame, sender: Sender) -> None:
        delay = 0.0 if self._wire is None else self._wire.delay(frame, self._chance)
        self._others.append(self._waiting(self.time + delay, frame, sender))
        self._is_quiet = self._is_quiet and is_cyclic(frame)

    def _waiting(self, ready: float, frame: Frame, sender: Sender) -> Waiting:
        self._number += 1
        return Waiting(ready, frame.cob, self._number, frame, sender)

    def _begin_frame(self, before: float) -> bool:
        """Put the frame whose turn is next on the wire; False when there is none by then."""
        first = min((waiting.ready for waiting in self._others), default=inf)
        if self._masters:
            first = min(first, self._masters[0].ready)
        start = max(first, self._free)
        if start >= before - ROUNDING:
            return False
        self._on_wire = self._next(start)
        assert self._wire is not None
        self._free = start + self._wire.duration(self._on_wire.frame, self._chance)
        return True

    def _next(self, time: float) -> Waiting:
        """The most urgent frame of those that are ready."""
        ready = [waiting for waiting in self._others if waiting.ready <= time]
        if self._masters and self._masters[0].ready <= time:
            ready.append(self._masters[0])
        chosen = min(ready, key=_urgency)
        if chosen.sender is None:
            self._masters.popleft()
        else:
            self._others.remove(chosen)
        return chosen

    def _let_foreign_go_first(self, frame: Frame, time: float) -> None:
        """At the worst a foreign frame is on the wire when a phase of the cycle begins."""
        assert self._wire is not None
        phase = phase_of(frame)
        if phase is None:
            self._is_quiet = False
        elif phase != self._phase:
            if self._wire.conditions.worst and self._is_quiet:
                self._free = max(self._free, time) + self._wire.foreign
            self._is_quiet = not any(not is_cyclic(waiting.frame) for waiting in self._others)
        self._phase = phase if phase is not None else self._phase

    def _arbitrate(self) -> None:
        """Without a wire, frames that wait at the same time go out by their identifiers."""
        while self._wire is None and self._others:
            waiting, self._others = self._others, []
            if len(waiting) > 1:
                waiting.sort(key=_urgency)
            for each in waiting:
                self._carry(each.frame, each.sender)

    # -- arrival ------------------------------------------------------------------------------

    def _carry(self, frame: Frame, sender: Sender) -> None:
        if frame.cob in self._disturbances:
            self._disturb(frame, sender)
        else:
            self._deliver(frame, sender)

    def _disturb(self, frame: Frame, sender: Sender) -> None:
        queue = self._disturbances[frame.cob]
        disturbance = queue.popleft()
        if not queue:
            del self._disturbances[frame.cob]
        match disturbance.mishap:
            case Mishap.DUPLICATE:
                self._deliver(frame, sender)
                self._deliver(frame, sender)
            case Mishap.DELAY:
                self._late.append((self._cycle + disturbance.cycles, frame, sender))
            case Mishap.CORRUPT:
                self._deliver(disturbance.flipped(frame), sender)
            case Mishap.SHORTEN:
                self._deliver(Frame(frame.cob, frame.data[:-1]), sender)

    def _deliver(self, frame: Frame, sender: Sender) -> None:
        for listener in self.listeners:
            listener(frame, isinstance(sender, Drive))
        if sender is not None:
            self._answers.append(frame)
        cob, data = frame
        since = self.time - self._began
        for drive in self.drives:
            if drive is not sender:
                drive.receive(cob, data, since)


def _urgency(waiting: Waiting) -> tuple[int, int]:
    return waiting.cob, waiting.number


__all__ = ["SYNC", "Disturbance", "Frame", "Mishap", "SimulatedBus"]
