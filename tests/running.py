"""The executable of the stock machine as tests run it: on serial lines, watched by telemetry."""

import os
import subprocess
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from lab.drives.slcan_adapter import SlcanAdapter
from lab.live import LiveError
from lab.live.telemetry import Record, Telemetry

BUSES = ("cable1", "cable2", "base")
PATIENCE = 60.0
"""Seconds after which a test gives up; nothing takes that long."""


class Lines:
    """Serial adapters, one a bus, with nobody behind them: what arrives is thrown away."""

    def __init__(self) -> None:
        self.adapters = [SlcanAdapter() for _ in BUSES]
        self._over = threading.Event()
        self._readers = [
            threading.Thread(target=self._read, args=[adapter]) for adapter in self.adapters
        ]
        for reader in self._readers:
            reader.start()

    @property
    def options(self) -> list[str]:
        """The buses, as the program takes them."""
        return [
            f"--bus={bus}=slcan:{adapter.path}"
            for bus, adapter in zip(BUSES, self.adapters, strict=True)
        ]

    def unplug(self, bus: int) -> None:
        """Take a line away."""
        self._over.set()
        for reader in self._readers:
            reader.join()
        self.adapters[bus].shutdown()

    def close(self) -> None:
        """Take all lines away."""
        for bus in range(len(BUSES)):
            self.unplug(bus)

    def _read(self, adapter: SlcanAdapter) -> None:
        while not self._over.is_set():
            adapter.recv(timeout=0.02)


@contextmanager
def silent_lines() -> Iterator[Lines]:
    """Lines without drives, while the context lasts."""
    lines = Lines()
    try:
        yield lines
    finally:
        lines.close()


class Running:
    """A program that runs, with what it writes."""

    def __init__(self, process: "subprocess.Popen[str]", telemetry: Telemetry) -> None:
        self.process, self.telemetry = process, telemetry

    def latest(self) -> Record:
        """The last cycle; waits for the first one."""
        while (cycle := self.telemetry.latest()) is None:
            time.sleep(0.005)
        return cycle

    def await_cycles(self, count: int) -> None:
        """Wait until so many more cycles have run."""
        last = int(self.latest()["number"]) + count
        begin = time.monotonic()
        while int(self.latest()["number"]) < last:
            assert self.process.poll() is None, self.process.communicate()
            assert time.monotonic() - begin < PATIENCE, "the program does not go on"
            time.sleep(0.005)

    def await_state(self, state: int) -> None:
        """Wait until the supervisor is in a state."""
        begin = time.monotonic()
        while int(self.latest()["state"]) != state:
            assert self.process.poll() is None, self.process.communicate()
            assert time.monotonic() - begin < PATIENCE, f"state {self.latest()['state']} stays"
            time.sleep(0.005)

    def end(self, signal: int) -> tuple[int, str, str]:
        """Send a signal; status, stdout and stderr of the program."""
        self.process.send_signal(signal)
        out, err = self.process.communicate(timeout=PATIENCE)
        return self.process.returncode, out, err


@contextmanager
def running(
    program: Path, options: Sequence[str], wrapper: Sequence[str] = ()
) -> Iterator[Running]:
    """The program with some options, from its first cycle until the end of the context."""
    path = shared_file()
    command = [*wrapper, str(program), f"--telemetry={path}", *options]
    with subprocess.Popen(
        command, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        try:
            yield Running(process, opened(path, process))
        finally:
            process.kill()
            path.unlink(missing_ok=True)


def shared_file() -> Path:
    """A place for telemetry of this process alone."""
    path = Path(f"/dev/shm/turnbuckle-test-{os.getpid()}")
    path.unlink(missing_ok=True)
    return path


def opened(path: Path, process: "subprocess.Popen[str]") -> Telemetry:
    """The telemetry, as soon as the program has begun."""
    while process.poll() is None:
        try:
            telemetry = Telemetry(path)
        except LiveError:
            time.sleep(0.005)
            continue
        return telemetry
    raise AssertionError(process.communicate())
