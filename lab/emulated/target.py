"""A program on an emulated Cortex-M that runs a machine's runtime, cycle by cycle, on request.

The program is firmware/lockstep.c. It reads requests from a named pipe, by semihosting, and writes
its answers to another: no clock is involved, two runs give the same bytes. A request is two words,
what is asked and a number, and what goes with it.
"""

import os
import signal
import subprocess
import time
from dataclasses import dataclass
from enum import IntEnum
from functools import partial
from pathlib import Path
from select import select
from struct import Struct
from tempfile import TemporaryDirectory
from types import TracebackType

from turnbuckle.codegen.processes import hear_of_death
from turnbuckle.lab.emulated.processor import Processor
from turnbuckle.lab.lockstep import FRAME, BusState

EMULATOR = "qemu-system-arm"
REQUEST = Struct("<II")
WORD = Struct("<I")
FACTS = Struct("<4I")
AT_ONCE = 65536
"""Bytes read at once."""
LOOKS = 0.5
"""Seconds between two looks whether the emulator still runs, while no answer comes."""
PATIENCE = 120
"""Seconds that an answer may take."""


def emulator_command(processor: Processor, image: Path) -> list[str]:
    """What starts the emulator with an image; the image reads and writes in the working folder."""
    quiet = ["-display", "none", "-monitor", "none", "-serial", "none"]
    files = ["-semihosting-config", "enable=on,target=native"]
    return [EMULATOR, "-M", processor.board, *quiet, *files, "-kernel", str(image)]


class TargetError(RuntimeError):
    """The emulator, or the program in it, has ended or does not answer."""


class Command(IntEnum):
    """What the program is asked."""

    SYNC = 0
    RUN = 1
    GIVE = 2
    SET_BUS = 3
    DESCRIBE = 4
    SAVE = 5
    END = 6


@dataclass(frozen=True)
class Facts:
    """What the program says about itself."""

    part: int
    """PARTNO of the processor's CPUID."""
    layout: bytes
    """The rows that describe tb_wishes, tb_view and the enumerations."""
    stack: int
    """Bytes of the stack that have been in use."""
    master: int
    """Address of the tb_master."""


class Target:
    """A machine's master on an emulated processor.

    Every request is made by ask_..., and answered once: the answers are read in the same order. A
    context manager: the emulator ends with it.
    """

    def __init__(self, processor: Processor, image: Path, view_size: int) -> None:
        """Start the emulator; view_size: of tb_view [B]."""
        self._view_size = view_size
        self._folder = TemporaryDirectory(prefix="turnbuckle-target-")
        pipes = [Path(self._folder.name) / name for name in ("to_target", "from_target")]
        for pipe in pipes:
            os.mkfifo(pipe)
        self._emulator = subprocess.Popen(
            emulator_command(processor, image),
            cwd=self._folder.name,
            stdin=subprocess.DEVNULL,
            preexec_fn=partial(hear_of_death, signal.SIGKILL),
        )
        # Open for both, a pipe waits for nobody at its other end.
        self._to, self._from = (os.open(pipe, os.O_RDWR) for pipe in pipes)
        self._arrived = bytearray()

    def ask_sync(self) -> None:
        """Send SYNC; answered by read_sent()."""
        self._ask(Command.SYNC)

    def ask_run(self, wishes: bytes, missed: int) -> None:
        """Run the cycle with a tb_wishes; answered by read_view() and read_sent()."""
        self._ask(Command.RUN, missed, wishes)

    def ask_give(self, packed: bytes) -> None:
        """Let frames arrive; answered by read_word(), the number for which there was room."""
        self._ask(Command.GIVE, len(packed) // FRAME.size, packed)

    def set_bus(self, bus: int, state: BusState, full: bool) -> None:
        """Fault: bring a bus into a state. Not answered."""
        self._ask(Command.SET_BUS, bus | state << 8 | full << 16)

    def facts(self) -> Facts:
        """What the program says about itself, when all answers have been read."""
        self._ask(Command.DESCRIBE)
        identity, size, stack, master = FACTS.unpack(self._read(FACTS.size))
        return Facts(identity >> 4 & 0xFFF, self._read(size), stack, master)

    def variables(self) -> bytes:
        """All its variables, as they are in its memory, when all answers have been read."""
        self._ask(Command.SAVE)
        return self._read(self.read_word())

    def read_sent(self) -> bytes:
        """The frames that were sent, packed."""
        return self._read(self.read_word() * FRAME.size)

    def read_view(self) -> bytes:
        """The tb_view of a cycle."""
        return self._read(self._view_size)

    def read_word(self) -> int:
        """A number."""
        word: int = WORD.unpack(self._read(WORD.size))[0]
        return word

    def close(self) -> None:
        """End the emulator."""
        self._emulator.kill()
        self._emulator.wait()
        os.close(self._to)
        os.close(self._from)
        self._folder.cleanup()

    def __enter__(self) -> "Target":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _ask(self, command: Command, number: int = 0, more: bytes = b"") -> None:
        os.write(self._to, REQUEST.pack(command, number) + more)

    def _read(self, size: int) -> bytes:
        until = time.monotonic() + PATIENCE
        while len(self._arrived) < size:
            if select([self._from], [], [], LOOKS)[0]:
                self._arrived += os.read(self._from, AT_ONCE)
            elif (status := self._emulator.poll()) is not None:
                raise TargetError(f"the emulated program has ended with status {status}")
            elif time.monotonic() > until:
                raise TargetError(f"the emulated program has not answered for {PATIENCE} s")
        answer = bytes(self._arrived[:size])
        del self._arrived[:size]
        return answer
