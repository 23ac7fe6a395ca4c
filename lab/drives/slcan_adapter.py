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
        """Let a frame arrive at the peer; before it opened the bus nothing does."""
        if self.is_open:
            self._write(encode(msg))

    def shutdown(self) -> None:
        """Take the line away."""
        if not self._is_shutdown:
            super().shutdown()
            os.close(self._line)
            os.close(self._peer)

    def _recv_internal(self, timeout: float | None) -> tuple[can.Message | None, bool]:
        if not self._frames and select.select([self._line], [], [], timeout)[0]:
            self._read()
        return (self._frames.pop(0) if self._frames else None), False

    def _read(self) -> None:
        *lines, self._text = (self._text + os.read(self._line, READ_AT_ONCE)).split(b"\r")
        for line in lines:
            self._obey(line)

    def _obey(self, line: bytes) -> None:
        letter = line[:1]
        if letter in b"tTrR" and letter:
            self._take_frame(line)
        elif letter in ANSWERS:
            self._write(ANSWERS[letter])
        elif letter in b"OC" and letter:
            self.is_open = letter == b"O"
            self._write(ACKNOWLEDGED)
        else:
            self._write(ACKNOWLEDGED if letter in (b"S", b"s", b"Z", b"M", b"m", b"") else REFUSED)

    def _take_frame(self, line: bytes) -> None:
        frame = decode(line)
        if frame is None or not self.is_open:
            self._write(REFUSED)
            return
        self._frames.append(frame)
        self._write((b"Z" if frame.is_extended_id else b"z") + ACKNOWLEDGED)

    def _write(self, data: bytes) -> None:
        """A peer that does not read loses what is written."""
        try:
            os.write(self._line, data)
        except BlockingIOError:
            return


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
