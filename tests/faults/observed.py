"""The stock machine with the observer on its wires, and what was heard there, frame by frame."""

from collections.abc import Callable
from typing import NamedTuple

from forked import in_a_fork
from journey import NEAR_THEIR_STOPS
from observer import Observer

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.drives.bus import Listener, SimulatedBus
from turnbuckle.lab.drives.node import Frame
from turnbuckle.lab.drives.power import Power
from turnbuckle.lab.drives.wire import Conditions
from turnbuckle.lab.lockstep import Lockstep, Request, State
from turnbuckle.lab.machine_sim import SimulatedMachine

BEFORE = 10
"""Cycles that a tape begins before something is done."""
READY = 4
"""TB_PHASE_READY."""
FORCE = (2.0, -3.0)
"""What the application wants in RUN [N]."""
LONGEST = 20_000
"""Cycles from a moment to the next, at most."""


class Heard(NamedTuple):
    """A frame that had arrived on a bus at a time [s]."""

    time: float
    bus: int
    frame: Frame


class Observed:
    """A machine, and the observer that hears it; `frames`: all that was on the wires."""

    def __init__(self, generated: Generated, conditions: Conditions | None = None) -> None:
        machine = generated.machine
        simulated = SimulatedMachine(
            machine,
            plant_of(machine),
            plan_task(generated),
            NEAR_THEIR_STOPS,
            conditions or Conditions(),
        )
        self.lockstep = Lockstep(generated, simulated)
        self.observer = Observer(machine, simulated.buses, self.lockstep.taps)
        self.frames: list[Heard] = []
        for number, bus in enumerate(simulated.buses):
            bus.listeners.append(self._record(number, bus))

    def _record(self, number: int, bus: SimulatedBus) -> Listener:
        def listen(frame: Frame, from_drive: bool) -> None:
            self.frames.append(Heard(bus.time, number, frame))

        return listen

    def until(self, reached: Callable[[], bool], more: int = 0) -> None:
        """Run until something is so, and so many cycles more."""
        lockstep = self.lockstep
        for _ in range(LONGEST):
            if reached():
                break
            lockstep.cycle()
            lockstep.requests = Request(0)
        else:
            raise AssertionError(f"was not reached: {lockstep.view}")
        lockstep.run(more)

    def until_state(self, state: State, more: int = 0) -> None:
        """Run until a state of the supervisor is reached, and so many cycles more."""
        self.until(lambda: self.lockstep.state is state, more)

    def ask(self, request: Request) -> None:
        """Ask the supervisor for something, once."""
        self.lockstep.requests = request
        self.lockstep.cycle()
        self.lockstep.requests = Request(0)

    def get_ready(self) -> None:
        """To where the machine waits to be armed."""
        lockstep = self.lockstep
        self.until(
            lambda: lockstep.state is State.CONFIGURE and lockstep.view["phase"] == READY, 20
        )

    def work(self) -> None:
        """The hand moves, the application wants a force."""
        self.lockstep.machine.begin_task()
        self.lockstep.force = FORCE

    def after(self, act: Callable[[Lockstep], None], cycles: int) -> tuple[list[str], State]:
        """What the observer finds within so many cycles after something was done, and the state of
        the supervisor then; done in a copy."""

        def run() -> tuple[list[str], State]:
            act(self.lockstep)
            self.lockstep.run(cycles)
            return list(self.observer.findings), self.lockstep.state

        return in_a_fork(run)

    def frames_after(self, act: Callable[[Lockstep], None], cycles: int) -> list[Heard]:
        """What is heard a moment before something is done, and so many cycles after; done in a
        copy."""

        def run() -> list[Heard]:
            begin = len(self.frames)
            self.lockstep.run(BEFORE)
            act(self.lockstep)
            self.lockstep.run(cycles)
            return self.frames[begin:]

        return in_a_fork(run)


def ready(bench: Observed) -> None:
    """Waiting to be armed."""
    bench.get_ready()


def winding(bench: Observed) -> None:
    """HOME: cables are wound in."""
    bench.ask(Request.ARM)
    bench.until_state(State.HOME, 60)


def homing(bench: Observed) -> None:
    """HOME: bases go to their stops."""
    base = bench.lockstep.machine.drives[-1].servo
    bench.until(lambda: base.homing is not None, 20)


def sweeping(bench: Observed) -> None:
    """HOME: bases sweep."""
    bases = [drive.servo for drive in bench.lockstep.machine.drives[4:]]
    bench.until(lambda: all(base.homing is None for base in bases))
    bench.until(lambda: all(base.power is Power.ENABLED for base in bases), 500)


def closing(bench: Observed) -> None:
    """TENSION."""
    bench.until_state(State.TENSION, 50)


def working(bench: Observed) -> None:
    """RUN."""
    bench.until_state(State.RUN, 100)
    bench.work()
    bench.lockstep.run(600)


def relaxing(bench: Observed) -> None:
    """SOFT_STOP, the first half."""
    bench.ask(Request.STOP)
    bench.lockstep.run(60)


def slackening(bench: Observed) -> None:
    """SOFT_STOP, the second half."""
    bench.lockstep.run(120)


MOMENTS = (ready, winding, homing, sweeping, closing, working, relaxing, slackening)
"""In the order in which one machine goes through them."""
