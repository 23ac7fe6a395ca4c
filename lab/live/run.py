"""Runs a machine's program, with real adapters or with simulated drives, and tells what it does."""

import ctypes
import signal
import subprocess
import time
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path

from lab.live import LiveError
from lab.live.identity import refuse_other
from lab.live.program import build_program
from lab.live.simulated import Bench, simulated_drives
from lab.live.telemetry import Telemetry, default_path
from lab.live.words import STATES, word
from model.machine import Machine

POLL = 0.05
"""Seconds between two looks at the telemetry."""
LOOKED_BACK = 2048
"""Cycles that are read at most in one look."""
Say = Callable[[str], None]
SET_DEATH_SIGNAL = 1
"""PR_SET_PDEATHSIG of prctl(2)"""


@dataclass(frozen=True)
class Order:
    """What the user wants of a run."""

    buses: Sequence[str] = ()
    """NAME=ADAPTER:DEVICE, as the program takes them."""
    simulated: bool = False
    pace: int = 1
    arm: bool = False
    seconds: float | None = None
    record: Path | None = None
    telemetry: Path | None = None
    program: Path | None = None
    precision: str = "double"
    further: Sequence[str] = field(default_factory=tuple)
    """Options that are handed to the program as they are."""


def run_machine(machine: Machine, order: Order, say: Say) -> int:
    """Run the program until it ends; its exit status: 0 stopped as asked, 1 by a fault.

    Ctrl-C stops the machine softly, once more at once. Raises LiveError for what cannot be run.
    """
    if order.program is None:
        program = build_program(machine, order.precision)
    else:
        program = order.program.resolve()
        refuse_other(program, machine)
    telemetry = order.telemetry or default_path(machine.name)
    with ExitStack() as stack:
        buses = order.buses
        if order.simulated:
            drives = simulated_drives(bench_of(machine), order.pace, telemetry, order.buses)
            buses = stack.enter_context(drives)
        process = start(program, arguments(machine, order, buses))
        stack.callback(finish, process)
        return follow(process, telemetry, say)


def bench_of(machine: Machine) -> Bench:
    """What simulated drives simulate; MachineError for a machine that cannot be simulated."""
    from codegen.bind import load
    from lab.demo import plan_task, plant_of

    plant = plant_of(machine)
    return Bench(machine, plant, plan_task(load(machine.path)))


def arguments(machine: Machine, order: Order, buses: Sequence[str]) -> list[str]:
    """The command line of the program."""
    words = [f"--bus={bus}" for bus in buses]
    if order.arm:
        words.append("--arm")
    if order.pace != 1:
        words.append(f"--pace={order.pace}")
    if order.seconds is not None:
        words.append(f"--cycles={max(1, round(order.seconds * machine.control.rate))}")
    if order.record is not None:
        words.append(f"--record={order.record}")
    if order.telemetry is not None:
        words.append(f"--telemetry={order.telemetry}")
    return [*words, *order.further]


def start(program: Path, words: Sequence[str]) -> "subprocess.Popen[bytes]":
    """Start the program out of reach of the terminal's Ctrl-C, which is handed on once instead.

    When this process dies, the program stops softly: nobody would watch it any more.
    """
    libc = ctypes.CDLL(None)

    def stop_with_parent() -> None:
        libc.prctl(SET_DEATH_SIGNAL, signal.SIGTERM)

    return subprocess.Popen(
        [program, *words], process_group=0, preexec_fn=stop_with_parent, stdin=subprocess.DEVNULL
    )


def finish(process: "subprocess.Popen[bytes]") -> None:
    """Leave no program behind, whatever went wrong here."""
    if process.poll() is None:
        process.send_signal(signal.SIGTERM)
        process.wait()


def follow(process: "subprocess.Popen[bytes]", path: Path, say: Say) -> int:
    """Tell states as they change until the program ends; its exit status."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    teller = Teller(process.pid, path, say)
    while (status := process.poll()) is None:
        try:
            teller.look()
            time.sleep(POLL)
        except KeyboardInterrupt:
            say("stopping; once more stops at once")
            process.send_signal(signal.SIGINT)
    teller.look()
    if status < 0:
        raise LiveError(f"the program was ended by {signal.Signals(-status).name}")
    return status


class Teller:
    """Tells the states of one program as they change, and what it does in them."""

    def __init__(self, pid: int, path: Path, say: Say) -> None:
        self._pid, self._path, self._say = pid, path, say
        self._telemetry: Telemetry | None = None
        self._next = 0
        self._state, self._doing = "", ""

    def look(self) -> None:
        """Read all cycles since the last look."""
        if self._telemetry is None:
            self._telemetry = telemetry_of(self._pid, self._path)
        if self._telemetry is not None:
            self._tell_news(self._telemetry)

    def _tell_news(self, telemetry: Telemetry) -> None:
        status = telemetry.status()
        published = int(status["published"])
        for number in range(max(self._next, published - LOOKED_BACK), published):
            if (cycle := telemetry.cycle(number)) is not None:
                self._tell(telemetry, number, word(STATES, int(cycle["state"])), "")
        if published > self._next:
            doing = status["doing"].decode(errors="replace")
            self._tell(telemetry, published - 1, self._state, doing)
        self._next = published

    def _tell(self, telemetry: Telemetry, number: int, state: str, doing: str) -> None:
        """A line where the state is new, or what is done in it."""
        new_state, new_doing = state != self._state, doing not in ("", self._doing)
        if new_state or new_doing:
            seconds = float(telemetry.counts["period"]) * number
            self._say(f"{seconds:9.3f} s  {state if new_state else '':10} {doing}".rstrip())
            self._state, self._doing = state, doing


def telemetry_of(pid: int, path: Path) -> Telemetry | None:
    """The file once it is that of our program, not of one before it."""
    try:
        telemetry = Telemetry(path)
    except LiveError:
        return None
    if telemetry.counts["pid"] != pid:
        telemetry.close()
        return None
    return telemetry
