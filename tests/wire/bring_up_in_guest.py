"""The executable and the simulated drives on vcan: run by test_bring_up_on_vcan.py in the guest.

Runs of the executable, as they are named: `stopped` goes from power-on to work and softly back,
`killed` is killed while it pulls the cables, `unplugged` loses an interface then. Prints what each
was like, as JSON.

    python tests/wire/bring_up_in_guest.py PROGRAM BENCH RUN...
"""

import ctypes
import fcntl
import json
import pickle
import shutil
import socket
import struct
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import NamedTuple

from turnbuckle.lab.bus_tap import SetpointWatch
from turnbuckle.lab.drives.simulated_clock import SimulatedClock
from turnbuckle.lab.live.simulated import Application, Bench, open_port
from turnbuckle.lab.live.telemetry import Telemetry, running
from turnbuckle.lab.lockstep import State
from turnbuckle.lab.machine_sim import SimulatedMachine

UNPLUGGED = "vcan1"
HERE = Path("/run")
SHARED = Path("/dev/shm/turnbuckle-vcan")
LOOKS = 20
"""Cycles between two looks at what the program does."""
WORK = 200
"""Cycles of work before the stop."""
AFTERWARDS = 120
"""Cycles in which drives have to notice that nobody commands them any more."""
CURRENT_AND_FUTURE = 3
SIOCGIFFLAGS, SIOCSIFFLAGS, IFF_UP = 0x8913, 0x8914, 1

Script = Iterator[None]
"""What is done in a run; goes on every LOOKS cycles."""


class DriveSeen(NamedTuple):
    """What became of a drive."""

    power: str
    error: int  # the newest; 0 for none
    torque: float  # N m


@dataclass
class Told:
    """What a run was like."""

    states: list[str] = field(default_factory=list)
    status: int = 0
    said: str = ""
    cause: str = ""
    pulled: bool = False
    """Whether every cable was pulled before the run was ended."""
    drives: list[DriveSeen] = field(default_factory=list)
    setpoints: int = 0
    findings: list[str] = field(default_factory=list)
    """What was wrong with them."""


class Run:
    """One run of the executable, on drives that stay as they are from one run to the next."""

    process: "subprocess.Popen[bytes]"

    def __init__(self, world: SimulatedMachine) -> None:
        self.world, self.told = world, Told()
        self._telemetry: Telemetry | None = None

    def start(self, program: Path, clock: str) -> None:
        """Start the executable, which lives by a clock."""
        SHARED.unlink(missing_ok=True)
        pairs = zip(self.world.buses, interfaces(self.world), strict=True)
        buses = [f"--bus={bus.name}=socketcan:{interface}" for bus, interface in pairs]
        options = ["--arm", "--seal", f"--clock={clock}", f"--telemetry={SHARED}"]
        with (HERE / "said").open("wb") as said:
            self.process = subprocess.Popen([program, *buses, *options], stdout=said, stderr=said)

    def look(self) -> None:
        """Keep the states there are, and why the last one is."""
        if self._telemetry is None:
            self._telemetry = running(SHARED)
        cycle = None if self._telemetry is None else self._telemetry.latest()
        if self._telemetry is None or cycle is None:
            return
        state = State(int(cycle["state"])).name
        if self.told.states[-1:] != [state]:
            self.told.states.append(state)
            self.told.cause = self._telemetry.status()["cause"].decode()

    def await_state(self, name: str) -> Script:
        """Until the supervisor is in a state."""
        return self._await(lambda: self.told.states[-1:] == [name])

    def await_pull(self) -> Script:
        """Until every cable drive pulls."""
        yield from self._await(self._pulls)
        self.told.pulled = self._pulls()

    def await_end(self) -> Script:
        """Until the program has ended."""
        while self.process.poll() is None:
            self.look()
            yield

    def await_cycles(self, count: int) -> Script:
        """So many cycles of the drives."""
        end = self.world.time + (count - 0.5) * self.world.period
        while self.world.time < end:
            yield

    def look_at_drives(self) -> None:
        """Keep what the drives do now."""
        self.told.drives = [
            DriveSeen(drive.servo.power.name, drive.read(0x1003, 1), drive.servo.torque)
            for drive in self.world.drives
        ]

    def finish(self) -> Told:
        """What the run was like, once the program has ended."""
        self.told.status = self.process.wait()
        self.told.said = (HERE / "said").read_text()
        return self.told

    def _await(self, done: Callable[[], bool]) -> Script:
        """Until something is so; not beyond a fault, or the end of the program."""
        while self.process.poll() is None and self.told.states[-1:] != ["FAULT"] and not done():
            self.look()
            yield

    def _pulls(self) -> bool:
        cables = len(self.world.zeros)
        return all(drive.servo.torque > 0.0 for drive in self.world.drives[:cables])


def interfaces(world: SimulatedMachine) -> list[str]:
    """One a bus."""
    return [f"vcan{number}" for number in range(len(world.buses))]


def stopped(run: Run) -> Script:
    """From power-on to work, and softly back."""
    yield from run.await_state("RUN")
    yield from run.await_cycles(WORK)
    yield from run.await_pull()
    run.process.terminate()
    yield from run.await_end()
    run.look_at_drives()


def killed(run: Run) -> Script:
    """Killed while it pulls the cables."""
    yield from run.await_state("HOME")
    yield from run.await_pull()
    run.process.kill()
    run.process.wait()
    yield from run.await_cycles(AFTERWARDS)
    run.look_at_drives()


def unplugged(run: Run) -> Script:
    """An interface goes down while the cables are pulled."""
    yield from run.await_state("HOME")
    yield from run.await_pull()
    take_down(UNPLUGGED)
    yield from run.await_state("HARD_STOP")
    yield from run.await_cycles(AFTERWARDS)
    run.look_at_drives()
    for _ in range(2):  # at once: it would wait for drives that are out of its reach
        run.process.terminate()
        yield from run.await_cycles(LOOKS)
    yield from run.await_end()


def take_down(interface: str) -> None:
    """What `ip link set INTERFACE down` does."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as control:
        request = struct.pack("16sH14x", interface.encode(), 0)
        (flags,) = struct.unpack("16xH14x", fcntl.ioctl(control, SIOCGIFFLAGS, request))
        request = struct.pack("16sH14x", interface.encode(), flags & ~IFF_UP)
        fcntl.ioctl(control, SIOCSIFFLAGS, request)


class Stage(Application):
    """The drives' application, and the script of a run."""

    def __init__(self, world: SimulatedMachine, script: Script) -> None:
        super().__init__(world, SHARED)
        self._script = script
        self._stretch = LOOKS * world.period
        self._next = self.time + self._stretch
        self._is_over = False

    def run_until(self, time: float) -> None:
        """Let simulated time [s] pass; every LOOKS cycles the script goes on."""
        super().run_until(time)
        if self.time >= self._next - 1e-9 and not self._is_over:
            self._next += self._stretch
            self._is_over = next(self._script, self) is self

    def play(self, clock: SimulatedClock) -> None:
        """Keep the program's time while it runs, then go on without it to the script's end."""
        clock.run(lambda: self._is_over)
        while not self._is_over:
            self.run_until(self._next)


RUNS = {script.__name__: script for script in (stopped, killed, unplugged)}


def main() -> None:
    """Run scripts one after the other."""
    program = Path(shutil.copy(sys.argv[1], HERE / "turnbuckle"))
    bench: Bench = pickle.loads(Path(sys.argv[2]).read_bytes())
    world = bench.power_on()
    ports = [open_port(interface) for interface in interfaces(world)]
    ctypes.CDLL(None).mlockall(CURRENT_AND_FUTURE)  # nothing is read from the host from here on
    told = {}
    for script in (RUNS[name] for name in sys.argv[3:]):
        watch = SetpointWatch(bench.machine)
        watch.listen(world.buses)
        run = Run(world)
        stage = Stage(world, script(run))
        clock = SimulatedClock(stage, ports, bench.machine.supervision.compute_time)
        run.start(program, clock.path)
        stage.play(clock)
        clock.close()
        run.told.setpoints, run.told.findings = watch.seen, watch.findings
        told[script.__name__] = asdict(run.finish())
    for port in ports:
        port.shutdown()
    print(json.dumps(told))


if __name__ == "__main__":
    main()
