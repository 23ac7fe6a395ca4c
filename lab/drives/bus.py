"""A simulated CAN bus: its drives, the frames on it, and what can go wrong with a frame."""

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum

from lab.drives.drive import SYNC, Drive
from lab.drives.node import Frame
from lab.drives.setup import Setup


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


class SimulatedBus:
    """Drives on one bus; whoever else is on it calls send and take."""

    def __init__(self, name: str, setups: list[Setup]) -> None:
        self.name = name
        self.drives: list[Drive] = []
        self.listeners: list[Listener] = []
        self._disturbances: dict[int, deque[Disturbance]] = {}
        self._late: list[tuple[int, Frame, Drive | None]] = []
        self._cycle = 0
        self._answers: list[Frame] = []
        self._sent: list[tuple[Frame, Drive]] = []
        for setup in setups:
            self.add(setup)

    def add(self, setup: Setup) -> Drive:
        """Put another drive on the bus; its node may be taken already, which is a fault."""
        drive = Drive(setup, lambda frame: self._sent.append((frame, drive)))
        self.drives.append(drive)
        return drive

    def drive(self, node: int) -> Drive:
        """The first drive with this number."""
        return next(drive for drive in self.drives if drive.node == node)

    def disturb(self, cob: int, disturbance: Disturbance, count: int = 1) -> None:
        """Let this happen to the next `count` frames of a COB-ID."""
        self._disturbances.setdefault(cob, deque()).extend([disturbance] * count)

    def send(self, frame: Frame, after: float = 0.0) -> None:
        """Put a frame on the bus, as its master; `after` so many seconds, which none needs yet."""
        self._carry(frame, None)
        self._arbitrate()

    def intrude(self, frame: Frame) -> None:
        """Fault: somebody who does not belong there puts a frame on the bus."""
        self._answers.append(frame)
        self.send(frame)

    def take(self) -> list[Frame]:
        """What the drives have sent since the last call, in the order on the bus."""
        self._arbitrate()
        answers, self._answers = self._answers, []
        return answers

    def next_cycle(self) -> None:
        """A control cycle is over: late frames come nearer."""
        self._cycle += 1
        if self._late:
            due = [late for late in self._late if late[0] <= self._cycle]
            self._late = [late for late in self._late if late[0] > self._cycle]
            for _, frame, sender in due:
                self._deliver(frame, sender)

    def _arbitrate(self) -> None:
        """Frames that wait at the same time go out by their identifiers."""
        while self._sent:
            waiting, self._sent = self._sent, []
            if len(waiting) > 1:
                waiting.sort(key=_identifier)
            for frame, sender in waiting:
                self._carry(frame, sender)

    def _carry(self, frame: Frame, sender: Drive | None) -> None:
        if frame.cob in self._disturbances:
            self._disturb(frame, sender)
        else:
            self._deliver(frame, sender)

    def _disturb(self, frame: Frame, sender: Drive | None) -> None:
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

    def _deliver(self, frame: Frame, sender: Drive | None) -> None:
        for listener in self.listeners:
            listener(frame, sender is not None)
        if sender is not None:
            self._answers.append(frame)
        cob, data = frame
        for drive in self.drives:
            if drive is not sender:
                drive.receive(cob, data)


def _identifier(waiting: tuple[Frame, Drive]) -> int:
    return waiting[0].cob


__all__ = ["SYNC", "Disturbance", "Frame", "Mishap", "SimulatedBus"]
