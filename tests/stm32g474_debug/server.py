"""Takes OpenOCD's connection and moves the pins as it says."""

import socket
import threading
from collections.abc import Callable
from pathlib import Path

from stm32g474 import Chip

from stm32g474_debug.port import DebugPort
from stm32g474_debug.taps import PORT_ID, Taps

#: How long an exchange with the probe takes [ns]: a frame of USB while the processor stands still,
#: an eighth of one while it runs, when every microsecond has to be emulated.
FRAME, MICROFRAME = 1_000_000, 125_000
#: Characters of remote_bitbang: TCK, TMS and TDI from the lowest bit up are in the digits.
FIRST, LAST, READ, QUIT = ord("0"), ord("7"), ord("R"), ord("Q")
#: What TDO is without power: pulled up.
PULLED_UP = ord("1")


class DebugServer:
    """A probe with a chip on its wires, for one OpenOCD at a time until it is closed.

    `cut`: asked every half a millisecond; as soon as it says so, the power of the chip goes.
    `returns`: it is there again for the next OpenOCD.
    """

    def __init__(
        self,
        chip: Chip,
        folder: Path,
        *,
        cut: Callable[[Chip], bool] = lambda chip: False,
        returns: bool = False,
        port_id: int = PORT_ID,
    ) -> None:
        self.chip, self._cut, self._returns = chip, cut, returns
        self.port = DebugPort(chip, self._glance)
        self._taps = Taps(self.port, port_id)
        self._clock = 0
        #: What went wrong in the model itself.
        self.broken: BaseException | None = None
        self.place = folder / "probe"
        self._listener = socket.socket(socket.AF_UNIX)
        self._listener.bind(str(self.place))
        self._listener.listen()
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def close(self) -> None:
        """No more connections; raises what went wrong in the model."""
        self._listener.shutdown(socket.SHUT_RDWR)
        self._thread.join()
        self._listener.close()
        if self.broken:
            raise self.broken

    def __enter__(self) -> "DebugServer":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _glance(self) -> None:
        if self._cut(self.chip):
            self.chip.power_cut()

    def _serve(self) -> None:
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                return
            with connection:
                if self._returns and not self.chip.powered:
                    self.chip.reset("power")
                    self._cut = lambda chip: False
                try:
                    self._talk(connection)
                except ConnectionError:
                    pass
                except BaseException as error:
                    self.broken = error
                    return

    def _talk(self, connection: socket.socket) -> None:
        while data := connection.recv(65536):
            self.port.pass_time(FRAME if self.chip.halted else MICROFRAME)
            answer = self._answer(data)
            if answer:
                connection.sendall(answer)
            if data[-1] == QUIT:
                return

    def _answer(self, data: bytes) -> bytes:
        if not self.chip.powered:
            return bytes([PULLED_UP]) * data.count(READ)
        answer, taps = bytearray(), self._taps
        for each in data:
            if FIRST <= each <= LAST:
                pins = each - FIRST
                if pins & 4 and not self._clock:
                    taps.clock(pins >> 1 & 1, pins & 1)
                self._clock = pins & 4
            elif each == READ:
                answer.append(FIRST + taps.tdo)
        return bytes(answer)
