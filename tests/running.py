"""The executable of the stock machine as tests run it: on serial lines, in simulated time unless a
test is about the computer's, watched by telemetry."""

import os
import subprocess
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from turnbuckle.lab.drives.bus import SimulatedBus
from turnbuckle.lab.drives.simulated_clock import SimulatedClock, Simulation
from turnbuckle.lab.drives.slcan_adapter import SlcanAdapter
from turnbuckle.lab.live import LiveError
from turnbuckle.lab.live.telemetry import Record, Telemetry

BUSES = ("cable1", "cable2", "base")
PATIENCE = 600.0
"""Seconds after which a test gives up; nothing takes that long, on no computer."""


class NoDrives:
    """Buses with nobody on them, in simulated time."""

    def __init__(self) -> None:
        self.buses = [SimulatedBus(name, []) for name in BUSES]
        self.time = 0.0

    def run_until(self, time: float) -> None:
        """Nothing happens."""
        self.time = time


class Lines:
    """Serial adapters, one a bus, with a simulation behind them: without one, with no drives."""

    def __init__(self, simulation: Simulation | None = None) -> None:
        self.adapters = [SlcanAdapter() for _ in BUSES]
        self.clock = SimulatedClock(simulation or NoDrives(), self.adapters)
        self._over, self._halt, self._halted, self._go_on = (threading.Event() for _ in range(4))
        self._keeper = threading.Thread(target=self._keep_time)
        self._keeper.start()

    @property
    def options(self) -> list[str]:
        """Buses and clock, as the program takes them."""
        return [*self.real_time_options, f"--clock={self.clock.path}"]

    @property
    def real_time_options(self) -> list[str]:
        """The buses alone; what arrives is thrown away."""
        return [
            f"--bus={bus}=slcan:{adapter.path}"
            for bus, adapter in zip(BUSES, self.adapters, strict=True)
        ]

    @contextmanager
    def standstill(self) -> Iterator[None]:
        """No time passes while the context lasts."""
        self._go_on.clear()
        self._halt.set()
        self._halted.wait()
        try:
            yield
        finally:
            self._halt.clear()
            self._halted.clear()
            self._go_on.set()

    def unplug(self, bus: int) -> None:
        """Take a line away."""
        with self.standstill():
            self.clock.unplug(bus)

    def stop(self) -> None:
        """End the simulation."""
        self._over.set()
        self._keeper.join()
        self.clock.close()

    def close(self) -> None:
        """End the simulation, and take all lines away."""
        self.stop()
        for adapter in self.adapters:
            adapter.shutdown()

    def _keep_time(self) -> None:
        while not self._is_over():
            self.clock.run(self._is_over)

    def _is_over(self) -> bool:
        if self._halt.is_set():
            self._halted.set()
            self._go_on.wait()
        return self._over.is_set()


@contextmanager
def silent_lines(simulation: Simulation | None = None) -> Iterator[Lines]:
    """Lines without drives, while the context lasts."""
    lines = Lines(simulation)
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
    program: Path, options: Sequence[str], wrapper: Sequence[str] = (), keep: bool = False
) -> Iterator[Running]:
    """The program with some options, from its first cycle until the end of the context; beyond it
    its telemetry may be kept."""
    path = shared_file()
    command = [*wrapper, str(program), f"--telemetry={path}", *options]
    with subprocess.Popen(
        command, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        try:
            yield Running(process, opened(path, process))
        finally:
            process.kill()
            if not keep:
                path.unlink(missing_ok=True)


def shared_file(keep: bool = False) -> Path:
    """A place for telemetry of this process alone, empty unless what is there is kept."""
    path = Path(f"/dev/shm/turnbuckle-test-{os.getpid()}")
    if not keep:
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
