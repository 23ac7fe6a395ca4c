"""Serial lines without hardware: pseudo-terminals, and adapters at their far ends."""

import os
import select
import threading
import tty
from collections.abc import Callable
from types import TracebackType
from typing import Self

RESET_COMMUNICATION = b"t000282"
"""The beginning of the line that resets a drive's communication; its node follows."""


class SerialLine:
    """A serial line: a device for a program to open, and its far end for the test."""

    def __init__(self) -> None:
        self.far_end, self._near_end = os.openpty()
        tty.setraw(self._near_end)
        os.set_blocking(self.far_end, False)
        self.path = os.ttyname(self._near_end)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.hang_up()
        if self._near_end >= 0:
            os.close(self._near_end)
            self._near_end = -1

    def read(self, seconds: float = 0.0) -> bytes:
        """What has arrived at the far end, waiting for it at most some seconds."""
        ready, _, _ = select.select([self.far_end], [], [], seconds)
        return os.read(self.far_end, 1 << 16) if ready else b""

    def write(self, text: bytes) -> None:
        """Let text arrive at the program."""
        assert os.write(self.far_end, text) == len(text)

    def waits_to_be_read(self, seconds: float) -> bool:
        """Whether the program has left something unread, or some comes within some seconds."""
        return bool(select.select([self._near_end], [], [], seconds)[0])

    def hang_up(self) -> None:
        """Pull the plug."""
        if self.far_end >= 0:
            os.close(self.far_end)
            self.far_end = -1


class FarEnd(threading.Thread):
    """Serves the far ends of some lines until it is told to stop."""

    def __init__(self, serve: dict[SerialLine, Callable[[bytes], None]]) -> None:
        super().__init__(daemon=True)
        self._serve = serve
        self._stop_reading, self._stop_writing = os.pipe()

    def __enter__(self) -> Self:
        self.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        os.write(self._stop_writing, b".")
        self.join()
        os.close(self._stop_reading)
        os.close(self._stop_writing)

    def run(self) -> None:
        """Hand what arrives at a line to whom it concerns."""
        ends = {line.far_end: (line, serve) for line, serve in self._serve.items()}
        while True:
            ready, _, _ = select.select([*ends, self._stop_reading], [], [])
            if self._stop_reading in ready:
                return
            for end in ready:
                line, serve = ends[end]
                serve(line.read())


def connected(one: SerialLine, other: SerialLine) -> FarEnd:
    """A cable between two lines."""
    return FarEnd({one: other.write, other: one.write})


class Adapter:
    """An adapter that answers each command as it is told to, and keeps what it heard.

    answers: to the commands that begin with these letters; otherwise: to all others.
    """

    def __init__(self, line: SerialLine, answers: dict[bytes, bytes], otherwise: bytes) -> None:
        self.heard: list[bytes] = []
        self._line, self._answers, self._otherwise = line, answers, otherwise
        self._begun = b""

    def __call__(self, text: bytes) -> None:
        """Take what arrived."""
        *lines, self._begun = (self._begun + text).split(b"\r")
        for command in lines:
            self.heard.append(command)
            self.hear(command)

    def hear(self, command: bytes) -> None:
        """Answer a command."""
        self._line.write(self._answers.get(command[:1], self._otherwise))


class BootingDrives(Adapter):
    """An adapter with drives behind it that boot when they are told to, and do nothing else.

    spoken: what becomes of a line that the adapter writes, without its end.
    """

    def __init__(
        self,
        line: SerialLine,
        end: bytes = b"\r",
        spoken: Callable[[bytes], bytes] = lambda text: text,
    ) -> None:
        super().__init__(line, {}, b"")
        self._end, self._spoken = end, spoken

    def hear(self, command: bytes) -> None:
        """Acknowledge; a drive whose communication is reset boots."""
        self._line.write(self._end)
        if command.startswith(RESET_COMMUNICATION):
            node = command[len(RESET_COMMUNICATION) :].lower()
            self._line.write(self._spoken(b"t7" + node + b"100") + self._end)
