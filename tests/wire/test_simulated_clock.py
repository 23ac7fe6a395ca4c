"""Simulated time: program and simulation wait for each other's frames, whatever the computer does,
and the program says so when the simulation is gone."""

import hashlib
import os
import random
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from queue import SimpleQueue

import can
import pytest
from running import BUSES, PATIENCE, Lines, NoDrives, running, shared_file, silent_lines

from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.compile import compile_program
from turnbuckle.lab.bus_tap import Fingerprint
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.drives.simulated_clock import Line, SimulatedClock
from turnbuckle.lab.drives.slcan_adapter import SlcanAdapter, encode
from turnbuckle.lab.live.program import FOLDERS, compile_machine
from turnbuckle.lab.live.simulated import Application, Bench
from turnbuckle.lab.live.telemetry import Telemetry
from turnbuckle.lab.machine_sim import SimulatedMachine
from turnbuckle.places import RUNTIME

PORT = RUNTIME / "port" / "linux"
CYCLES = 700
"""From power-on to cables that are pulled."""
BUSY = 8
"""Processes that take the computer's time."""


@pytest.fixture(scope="module")
def program(stock_folder: Path) -> Path:
    """The executable of the stock machine."""
    return compile_machine(stock_folder)


Seed = Callable[[str, str, str], Path]


@pytest.fixture
def seeded(stock_folder: Path, tmp_path: Path) -> Seed:
    """The executable with other words in a file of its Linux port."""

    def compiled(file: str, right: str, wrong: str) -> Path:
        text = (PORT / file).read_text()
        assert right in text
        (tmp_path / file).write_text(text.replace(right, wrong))
        folders = [stock_folder, *FOLDERS]
        sources = [path for each in folders for path in sorted(each.glob("*.c"))]
        sources = [tmp_path / file if path == PORT / file else path for path in sources]
        return compile_program(sources, [tmp_path, *folders])

    return compiled


@pytest.fixture(scope="module")
def bench(double: Generated) -> Bench:
    """The stock machine."""
    return Bench(double.machine, plant_of(double.machine), plan_task(double))


class Witness(Application):
    """Keeps a digest of all frames until a time; what a program sends at its end may come too late
    on a busy computer."""

    def __init__(self, world: SimulatedMachine, path: Path) -> None:
        super().__init__(world, path)
        self._frames = Fingerprint(world.buses)
        self.digest = ""

    def run_until(self, time: float) -> None:
        """Let simulated time [s] pass."""
        super().run_until(time)
        if not self.digest and time > CYCLES * 1e-3:
            self.digest = self._frames.hexdigest()


def story(
    program: Path,
    bench: Bench,
    adapter: type[SlcanAdapter] = SlcanAdapter,
    clock: type[SimulatedClock] = SimulatedClock,
    disturbed: Callable[[int], None] = lambda pid: None,
) -> str:
    """A digest of every frame on the buses and of every cycle of the program, to the bit."""
    path = shared_file()
    witness = Witness(bench.power_on(), path)
    adapters = [adapter() for _ in BUSES]
    keeper = clock(witness, adapters, bench.machine.supervision.compute_time)
    pairs = zip(BUSES, adapters, strict=True)
    buses = [f"--bus={bus}=slcan:{each.path}" for bus, each in pairs]
    words = ["--arm", f"--cycles={CYCLES}", f"--telemetry={path}", f"--clock={keeper.path}"]
    with subprocess.Popen([program, *buses, *words], stdout=subprocess.DEVNULL) as process:
        disturbed(process.pid)
        keeper.run(lambda: process.poll() is not None)
    keeper.close()
    for each in adapters:
        each.shutdown()
    return witness.digest + digest_of_cycles(path)


def digest_of_cycles(path: Path) -> str:
    """Of the telemetry that a program has left."""
    telemetry = Telemetry(path)
    published = int(telemetry.status()["published"])
    assert published >= CYCLES and telemetry.status()["times"]["missed"] == 0
    cycles = (telemetry.cycle(number) for number in range(published))
    digest = hashlib.blake2b(b"".join(cycle.tobytes() for cycle in cycles if cycle is not None))
    telemetry.close()
    return digest.hexdigest()


@pytest.fixture(scope="module")
def undisturbed(program: Path, bench: Bench) -> str:
    """The digest of a run in peace."""
    return story(program, bench)


class SlowAdapter(SlcanAdapter):
    """An adapter whose line is slow, and whose answers come when everybody has gone on."""

    def __init__(self) -> None:
        super().__init__()
        self._late: SimpleQueue[bytes | None] = SimpleQueue()
        self._chance = random.Random(self.path)
        self._carrier = threading.Thread(target=self._carry)
        self._carrier.start()

    def send(self, msg: can.Message, timeout: float | None = None) -> None:
        """Let a frame arrive later."""
        if not self.is_open:
            raise can.CanOperationError("nobody has opened the bus")
        self._late.put(encode(msg))

    def shutdown(self) -> None:
        """Take the line away."""
        self._late.put(None)
        self._carrier.join()
        super().shutdown()

    def _carry(self) -> None:
        while (line := self._late.get()) is not None:
            time.sleep(self._chance.uniform(0.0, 0.002))
            os.write(self._line, line)

    def _read(self) -> None:
        if self._chance.random() < 0.5:  # looking once is not enough
            super()._read()


class HastyClock(SimulatedClock):
    """A simulation that does not wait for the program's frames."""

    def _await_frames(self, connection: object, line: Line, count: int) -> None:
        line.receive()


def test_frames_that_are_slow_on_their_way_are_waited_for(
    program: Path, bench: Bench, undisturbed: str
) -> None:
    assert story(program, bench, SlowAdapter) == undisturbed


def test_a_program_that_does_not_wait_for_frames_is_noticed(
    seeded: Seed, bench: Bench, undisturbed: str
) -> None:
    hasty = seeded("awaited_port.c", "awaited->received < awaited->promised", "false")
    assert story(hasty, bench, SlowAdapter) != undisturbed


def test_a_simulation_that_does_not_wait_for_frames_is_noticed(
    program: Path, bench: Bench, undisturbed: str
) -> None:
    assert story(program, bench, SlowAdapter, HastyClock) != undisturbed


@contextmanager
def busy_computer() -> Iterator[None]:
    """More to do than the computer has processors, while the context lasts."""
    command = [sys.executable, "-c", "while True: pass"]
    others = [subprocess.Popen(command) for _ in range(BUSY)]
    try:
        yield
    finally:
        for other in others:
            other.kill()
            other.wait()


def stop_now_and_then(pid: int) -> None:
    """Let a process stand still again and again, until it ends."""

    def disturb() -> None:
        chance = random.Random(1)
        try:
            while True:
                for number in (signal.SIGSTOP, signal.SIGCONT):
                    os.kill(pid, number)
                    time.sleep(chance.uniform(0.0, 0.02))
        except ProcessLookupError:
            return

    threading.Thread(target=disturb, daemon=True).start()


def test_a_busy_computer_that_stops_the_program_now_and_then_changes_no_bit(
    program: Path, bench: Bench, undisturbed: str
) -> None:
    with busy_computer():
        assert story(program, bench, disturbed=stop_now_and_then) == undisturbed


@pytest.fixture
def lines() -> Iterator[Lines]:
    """A serial line a bus."""
    with silent_lines() as lines:
        yield lines


def refused(program: Path, options: Sequence[str], status: int) -> str:
    """What a program says that ends by itself; it says one thing."""
    command: list[str | Path] = [program, *options, f"--telemetry={shared_file()}"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
    assert (done.returncode, done.stderr.count("\n")) == (status, 1), done
    return done.stderr


def test_a_clock_that_nobody_keeps_is_named(program: Path, lines: Lines, tmp_path: Path) -> None:
    for path, words in ((tmp_path / "none", "No such file"), ("@no-simulation", "refused")):
        said = refused(program, [*lines.real_time_options, f"--clock={path}"], 2)
        assert f"--clock {path}: " in said and words in said and "turnbuckle run --sim" in said


def test_a_simulation_that_ends_ends_the_program(
    program: Path, lines: Lines, tmp_path: Path
) -> None:
    record = tmp_path / "dump"
    options = [*lines.options, "--seal", f"--record={record}"]
    with running(program, options) as run:
        run.await_cycles(20)
        lines.stop()
        _out, err = run.process.communicate(timeout=PATIENCE)
    assert run.process.returncode == 1
    assert err.count("\n") == 1 and "the simulation has ended" in err
    assert record.stat().st_size > 0


def test_a_simulation_that_lets_no_time_pass_is_given_up(seeded: Seed, lines: Lines) -> None:
    hurried = seeded("simulated_clock.c", "PATIENCE 600", "PATIENCE 1")
    with lines.standstill():
        said = refused(hurried, lines.options, 2)
    assert "let no time pass for 1 s" in said


class Promising(NoDrives):
    """A simulation that tells of a frame that there is not."""

    clock: SimulatedClock

    def run_until(self, time: float) -> None:
        """Let simulated time [s] pass."""
        super().run_until(time)
        self.clock._lines[1].sent += 1


def test_frames_that_never_come_are_given_up_with_the_name_of_their_bus(seeded: Seed) -> None:
    hurried = seeded("awaited_port.c", "MOST_NAPS 6000000u", "MOST_NAPS 20u")
    promising = Promising()
    with silent_lines(promising) as lines:
        promising.clock = lines.clock
        said = refused(hurried, lines.options, 1)
    assert "frames of the simulation on the bus cable2 did not come" in said
