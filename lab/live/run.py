"""Runs a machine's program, with real adapters or with simulated drives, and tells what it does."""

from __future__ import annotations

import os
import signal
import subprocess
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, ExitStack, contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from turnbuckle.codegen.processes import hear_of_death
from turnbuckle.lab.live import LiveError
from turnbuckle.lab.live.identity import refuse_other
from turnbuckle.lab.live.program import build_program
from turnbuckle.lab.live.telemetry import Telemetry, default_path
from turnbuckle.model.machine import Machine

if TYPE_CHECKING:
    from turnbuckle.lab.live.simulated import Bench

POLL = 0.05
"""Seconds between two looks at the telemetry."""
LOOKED_BACK = 2048
"""Cycles that are read at most in one look."""
Say = Callable[[str], None]
FAULT = "FAULT"


class Voices(NamedTuple):
    """Where it is told what happens, and what is wrong."""

    say: Say
    complain: Say


@dataclass(frozen=True)
class Order:
    """What the user wants of a run."""

    buses: Sequence[str] = ()
    """NAME=ADAPTER:DEVICE, as the program takes them."""
    simulated: bool = False
    wire: str = "ordinary"
    """What simulated wires are like: one of WIRES."""
    arm: bool = False
    seconds: float | None = None
    record: Path | None = None
    telemetry: Path | None = None
    program: Path | None = None
    precision: str = "double"
    further: Sequence[str] = field(default_factory=tuple)
    """Options that are handed to the program as they are."""


def run_machine(machine: Machine, order: Order, voices: Voices) -> int:
    """Run the program until it ends; its exit status: 0 stopped as asked, 1 by a fault.

    A fault ends a run in simulation, or one of so many seconds; any other waits for a reset. Ctrl-C
    stops the machine softly, once more at once. Raises LiveError for what cannot be run.
    """
    if order.program is None:
        program = build_program(machine, order.precision)
    else:
        program = order.program.resolve()
        refuse_other(program, machine)
    telemetry = order.telemetry or default_path(machine.name)
    with ExitStack() as stack:
        reach = [f"--bus={bus}" for bus in order.buses]
        if order.simulated:
            reach = stack.enter_context(simulated(machine, order, telemetry))
        process = start(program, [*reach, *arguments(machine, order)])
        stack.callback(finish, process)
        ends_at_fault = order.simulated or order.seconds is not None
        return follow(process, telemetry, voices, ends_at_fault)


def simulated(machine: Machine, order: Order, telemetry: Path) -> AbstractContextManager[list[str]]:
    """The program's options for simulated drives: see simulated_drives."""
    from turnbuckle.lab.drives.wire import WIRES  # here: real drives need no Python
    from turnbuckle.lab.live.simulated import simulated_drives

    bench = bench_of(machine)._replace(conditions=WIRES[order.wire])
    return simulated_drives(bench, telemetry, order.buses)


def bench_of(machine: Machine) -> Bench:
    """What simulated drives simulate; MachineError for a machine that cannot be simulated."""
    from turnbuckle.codegen.bind import load
    from turnbuckle.lab.demo import plan_task, plant_of
    from turnbuckle.lab.live.simulated import Bench

    if machine.plant is None and not machine.rails:
        return Bench(machine, None, None)
    plant = plant_of(machine)
    return Bench(machine, plant, plan_task(load(machine.path)))


def arguments(machine: Machine, order: Order) -> list[str]:
    """The command line of the program, but for how it reaches its drives."""
    words = []
    if order.arm:
        words.append("--arm")
    if order.seconds is not None:
        words.append(f"--cycles={max(1, round(order.seconds * machine.control.rate))}")
    if order.record is not None:
        words.append(f"--record={order.record}")
    if order.telemetry is not None:
        words.append(f"--telemetry={order.telemetry}")
    return [*words, *order.further]


def start(program: Path, words: Sequence[str]) -> subprocess.Popen[bytes]:
    """Start the program out of reach of the terminal's Ctrl-C, which is handed on once instead.

    When this process dies, the program stops softly: nobody would watch it any more.
    """
    return subprocess.Popen(
        [program, *words],
        process_group=0,
        preexec_fn=partial(hear_of_death, signal.SIGTERM),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )


def finish(process: subprocess.Popen[bytes]) -> None:
    """Leave no program behind, whatever went wrong here."""
    if process.poll() is None:
        process.send_signal(signal.SIGTERM)
        process.wait()


def follow(
    process: subprocess.Popen[bytes], path: Path, voices: Voices, ends_at_fault: bool
) -> int:
    """Tell states and causes as they change until the program ends; its exit status."""
    teller, relay = Teller(process.pid, path, voices.say), Relay(process, voices)
    with stop_signals() as asked:
        handed_on = 0
        while (status := process.poll()) is None:
            relay.carry(teller.look)
            if ends_at_fault and teller.state == FAULT:
                process.terminate()
                ends_at_fault = False
            while handed_on < len(asked):
                voices.say("stopping; once more stops at once")
                process.send_signal(signal.SIGINT)
                handed_on += 1
            time.sleep(POLL)
        relay.carry(teller.look)
    if status < 0:
        raise LiveError(f"the program was ended by {signal.Signals(-status).name}")
    return status


@contextmanager
def stop_signals() -> Iterator[list[int]]:
    """Ctrl-C and SIGTERM as they come, while the context lasts."""
    asked: list[int] = []
    before = {
        number: signal.signal(number, lambda number, frame: asked.append(number))
        for number in (signal.SIGINT, signal.SIGTERM)
    }
    try:
        yield asked
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


class Relay:
    """Hands on what a program writes, in the order in which it happened: states, report, cause."""

    def __init__(self, process: subprocess.Popen[bytes], voices: Voices) -> None:
        assert process.stdout is not None and process.stderr is not None
        self._out, self._err = process.stdout, process.stderr
        self._voices = voices
        for stream in (self._out, self._err):
            os.set_blocking(stream.fileno(), False)

    def carry(self, look: Callable[[], None]) -> None:
        """Hand on what there is; what the program says last was read first."""
        complaints, report = self._err.read(), self._out.read()
        look()
        for words, voice in ((report, self._voices.say), (complaints, self._voices.complain)):
            if words:
                voice(words.decode(errors="replace").removesuffix("\n"))


class Teller:
    """Tells the states of one program as they change, what it does in them, and why it stops."""

    def __init__(self, pid: int, path: Path, say: Say) -> None:
        self._pid, self._path, self._say = pid, path, say
        self._telemetry: Telemetry | None = None
        self._next = 0
        self.state = ""
        """The last one that was told."""
        self._doing = self._cause = ""

    def look(self) -> None:
        """Read all cycles since the last look."""
        if self._telemetry is None:
            self._telemetry = telemetry_of(self._pid, self._path)
        if self._telemetry is not None:
            self._tell_news(self._telemetry)

    def _tell_news(self, telemetry: Telemetry) -> None:
        status = telemetry.status()
        published = int(status["published"])
        doing, cause = (status[name].decode(errors="replace") for name in ("doing", "cause"))
        for number in range(max(self._next, published - LOOKED_BACK), published):
            if (cycle := telemetry.cycle(number)) is not None:
                seconds = float(telemetry.counts["period"]) * number
                self._tell_state(seconds, telemetry.layouts.name("state", cycle["state"]))
                self._tell_cause(seconds, cause if cycle["cause"] else "")
        if published > self._next:
            self._tell_doing(float(telemetry.counts["period"]) * (published - 1), doing)
        self._next = published

    def _tell_state(self, seconds: float, state: str) -> None:
        if state != self.state:
            self.state = state
            self._say(f"{seconds:9.3f} s  {state}")

    def _tell_cause(self, seconds: float, cause: str) -> None:
        if cause != self._cause:
            self._cause = cause
            self._say_more(seconds, cause)

    def _tell_doing(self, seconds: float, doing: str) -> None:
        if doing != self._doing:
            self._doing = doing
            self._say_more(seconds, doing)

    def _say_more(self, seconds: float, words: str) -> None:
        if words:
            self._say(f"{seconds:9.3f} s  {'':10} {words}")


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
