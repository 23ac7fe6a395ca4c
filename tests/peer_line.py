"""Serial lines between the program and the adapters of the drives by another hand, byte for byte.

Frames are counted as lines, either way, so that the simulation's clock knows when all are through.
"""

import os
import pty
import tty
from collections import deque
from typing import Any

import can
from peer_drives import PeerDrives

from turnbuckle.lab.drives.node import Frame

END, FRAMES = b"\r", b"tTrR"
READ_AT_ONCE = 4096
COUNTED = can.Message(is_error_frame=True)
"""A frame that the adapter has taken already."""
ARRIVED = Frame(0, b"")
"""A frame whose line is ready to be written."""


class PeerLine(can.BusABC):
    """The adapter's end of a line as SimulatedClock takes it: a port, and the bus behind it."""

    def __init__(self, peer: PeerDrives, number: int, **options: Any) -> None:
        self._peer, self._number = peer, number
        self._line, self._program = pty.openpty()
        tty.setraw(self._line)
        tty.setraw(self._program)
        os.set_blocking(self._line, False)
        self.path = os.ttyname(self._program)
        self._counted: deque[can.Message] = deque()
        self._begun = b""
        self._text = b""
        self._lines: deque[bytes] = deque()
        super().__init__(channel=self.path, **options)

    # -- from the program: a port ---------------------------------------------------------------

    def fileno(self) -> int:
        """For select: readable when the program wrote something."""
        return self._line

    def recv(self, timeout: float | None = None) -> can.Message | None:
        """One for every frame that the program has sent; the adapter takes the text itself."""
        try:
            text = os.read(self._line, READ_AT_ONCE)
        except BlockingIOError:
            text = b""
        if text:
            self._peer.write(self._number, text)
            *lines, self._begun = (self._begun + text).split(END)
            self._counted.extend(COUNTED for line in lines if line[:1] in FRAMES and line)
            self._answer()
        return self._counted.popleft() if self._counted else None

    def _answer(self) -> None:
        """What the adapter says at once; frames wait until they are taken."""
        self._fetch()
        if not self._lines:
            self._write(self._text)
            self._text = b""

    def shutdown(self) -> None:
        """Take the line away."""
        if not self._is_shutdown:
            super().shutdown()
            os.close(self._line)
            os.close(self._program)

    # -- to the program: a bus, and the port ----------------------------------------------------

    def take(self) -> list[Frame]:
        """One for every frame whose line has come from the adapter."""
        self._fetch()
        if not self._lines:
            self._answer()
        return [ARRIVED] * len(self._lines)

    def send(self, msg: can.Message, timeout: float | None = None) -> None:
        """Write the next line that holds a frame, with what the adapter said before it."""
        self._write(self._lines.popleft())
        if not self._lines:
            self._write(self._text)
            self._text = b""

    def _fetch(self) -> None:
        """Cut the adapter's text behind every line that holds a frame."""
        self._text += self._peer.read_all(self._number)
        at = 0
        while (end := self._text.find(END, at)) >= 0:
            begin = max(self._text.rfind(mark, 0, end) for mark in (END, b"\n", b"\a")) + 1
            at = end + 1
            if self._text[begin : begin + 1] in FRAMES and begin < end:
                self._lines.append(self._text[:at])
                self._text, at = self._text[at:], 0

    def _write(self, text: bytes) -> None:
        view = memoryview(text)
        while view:
            view = view[os.write(self._line, view) :]
