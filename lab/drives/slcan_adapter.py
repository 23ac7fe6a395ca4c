"""The adapter end of a serial line that speaks slcan: a simulated bus for whoever opens the line.

The line is a pseudo-terminal. The program at its other end (the runtime's slcan driver, or
python-can's "slcan" interface) sees an adapter: S0..S8 sets the bit rate, O opens, C closes, V and
N tell version and number, F the status; t and r are frames, T and R those with 29 bits.
"""

import os
import pty
import select
import tty
from typing import Any

import can

ACKNOWLEDGED, REFUSED = b"\r", b"\a"
ANSWERS = {b"V": b"V1013\r", b"N": b"N0001\r", b"F": b"F00\r"}
READ_AT_ONCE = 4096


class SlcanAdapter(can.BusABC):
    """A bus of python-can behind a pseudo-terminal; `path` is what its peer opens."""

    def __init__(self, path_of_link: str | None = None, **options: Any) -> None:
        self._line, self._peer = pty.openpty()
        tty.setraw(self._line)
        tty.setraw(self._peer)
        os.set_blocking(self._line, False)
        self.path = os.ttyname(self._peer)
        self.is_open = False
        self._text = b""
        self._frames: list[can.Message] = []
        super().__init__(channel=self.path, **options)

    def fileno(self) -> int:
        """For select: readable when the peer wrote something."""
        return self._line

    def send(self, msg: can.Message, timeout: float | None = None) -> None:
        """Let a frame arrive at the peer.

        Raises CanOperationError where none can: it has not opened the bus, or does not read.
        """
        if not self.is_open:
            raise can.CanOperationError(f"{self.path}: nobody has opened the bus")
        if not self._write(encode(msg)):
            raise can.CanOperationError(f"{self.path}: nobody reads")

    def shutdown(self) -> None:
        """Take the line away."""
        if not self._is_shutdown:
            super().shutdown()
            os.close(self._line)
            os.close(self._peer)

    def _recv_internal(self, timeout: float | None) -> tuple[can.Message | None, bool]:
        if not self._frames and (timeout == 0 or select.select([self._line], [], [], timeout)[0]):
            self._read()
        return (self._frames.pop(0) if self._frames else None), False

    def _read(self) -> None:
        try:
            text = os.read(self._line, READ_AT_ONCE)
        except BlockingIOError:
            return
        *lines, self._text = (self._text + text).split(b"\r")
        if lines:
            self._write(b"".join([self._obey(line) for line in lines]))

    def _obey(self, line: bytes) -> bytes:
        """Do what a line says; the answer to it."""
        letter = line[:1]
        if letter in b"tTrR" and letter:
            return self._take_frame(line)
        if letter in ANSWERS:
            return ANSWERS[letter]
        if letter in b"OC" and letter:
            self.is_open = letter == b"O"
            return ACKNOWLEDGED
        return ACKNOWLEDGED if letter in (b"S", b"s", b"Z", b"M", b"m", b"") else REFUSED

    def _take_frame(self, line: bytes) -> bytes:
        frame = decode(line)
        if frame is None or not self.is_open:
            return REFUSED
        self._frames.append(frame)
        return (b"Z" if frame.is_extended_id else b"z") + ACKNOWLEDGED

    def _write(self, data: bytes) -> bool:
        """Whether all of it went; a peer that does not read loses what is written."""
        try:
            return os.write(self._line, data) == len(data)
        except BlockingIOError:
            return False


def encode(message: can.Message) -> bytes:
    """A frame as a line."""
    letter = "r" if message.is_remote_frame else "t"
    if message.is_extended_id:
        start = f"{letter.upper()}{message.arbitration_id:08X}"
    else:
        start = f"{letter}{message.arbitration_id:03X}"
    data = "" if message.is_remote_frame else bytes(message.data).hex().upper()
    return f"{start}{message.dlc:X}{data}\r".encode()


def decode(line: bytes) -> can.Message | None:
    """A line without its end as a frame; None for one that is no frame."""
    extended, remote = line[:1] in b"TR", line[:1] in b"rR"
    digits = 8 if extended else 3
    try:
        identifier, length = int(line[1 : 1 + digits], 16), int(line[1 + digits : 2 + digits], 16)
        data = b"" if remote else bytes.fromhex(line[2 + digits :].decode("ascii"))
    except ValueError:
        return None
    if length > 8 or (not remote and len(data) != length):
        return None
    return can.Message(
        arbitration_id=identifier,
        is_extended_id=extended,
        is_remote_frame=remote,
        dlc=length,
        data=None if remote else data,
    )
