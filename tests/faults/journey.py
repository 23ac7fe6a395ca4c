"""One machine on its way from power-on to FAULT, and the moments at which faults strike it."""

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from observer import Observer
from supervised import Phase

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.bus_tap import SetpointWatch
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.drives.wire import Conditions
from turnbuckle.lab.lockstep import Lockstep, Request, State
from turnbuckle.lab.machine_sim import ORDINARY, SimulatedMachine
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]

NEAR_THEIR_STOPS = [0.012, 0.010, 0.011, 0.009]
"""Rail coordinates [m] in which the bases were left: their homing is short."""
FORCE = (2.0, -3.0)
"""What the application wants in RUN [N]."""
LONGEST = 10_000
"""Cycles from a moment to the next, at most."""


@dataclass
class Bench:
    """A machine in lockstep, the watch on its setpoints, and an observer of the wire who knows
    docs/safety.md alone."""

    machine: Machine
    lockstep: Lockstep
    watch: SetpointWatch
    observer: Observer

    @property
    def state(self) -> State:
        """State of the supervisor."""
        return self.lockstep.state

    @property
    def phase(self) -> int:
        """tb_phase."""
        return int(self.lockstep.view["phase"])


def power_on(generated: Generated, conditions: Conditions) -> Bench:
    """The stock machine when its supply has just come."""
    machine, task = generated.machine, plan_task(generated)
    simulated = SimulatedMachine(machine, plant_of(machine), task, NEAR_THEIR_STOPS, conditions)
    lockstep, watch = Lockstep(generated, simulated), SetpointWatch(machine)
    lockstep.taps.append(watch)
    bench = Bench(machine, lockstep, watch, Observer(machine, simulated.buses, lockstep.taps))
    return bench


def go_on(bench: Bench) -> None:
    """Nothing is asked for."""


def arm(bench: Bench) -> None:
    """Ask for HOME."""
    bench.lockstep.requests = Request.ARM


def work(bench: Bench) -> None:
    """The hand begins to move, the application wants a force."""
    bench.lockstep.machine.begin_task()
    bench.lockstep.force = FORCE


def stop(bench: Bench) -> None:
    """Ask for a soft stop."""
    bench.lockstep.requests = Request.STOP


def fail(bench: Bench) -> None:
    """A drive fails, other than those the faults strike."""
    bench.lockstep.machine.drives[0].raise_error(0x4380)


@dataclass(frozen=True)
class Moment:
    """When a fault strikes: so many cycles after a state and phase were reached."""

    state: State
    phase: Phase
    cycles: int
    begin: Callable[[Bench], None] = field(default=go_on, repr=False)
    """What has to be done at the moment before to get here."""

    @property
    def name(self) -> str:
        """As the table calls it: the state, and the phase where the state has more than one."""
        several = self.state in (State.CONFIGURE, State.HOME)
        return f"{self.state.name} {self.phase.name}" if several else self.state.name


MOMENTS = (
    Moment(State.INIT, Phase.NONE, 100),
    Moment(State.IDENTIFY, Phase.NONE, 5),
    Moment(State.CONFIGURE, Phase.CONTRACT, 100),
    Moment(State.CONFIGURE, Phase.READY, 20),
    Moment(State.HOME, Phase.TIGHTEN, 60, arm),
    Moment(State.HOME, Phase.TRY_BASES, 10),
    Moment(State.HOME, Phase.BASE_HOMING, 100),
    Moment(State.HOME, Phase.SWEEP, 500),
    Moment(State.TENSION, Phase.APPROACH, 50),
    Moment(State.RUN, Phase.NONE, 900, work),
    Moment(State.SOFT_STOP, Phase.RELAX, 60, stop),
    Moment(State.HARD_STOP, Phase.SLACKEN, 0, fail),
    Moment(State.FAULT, Phase.NONE, 20),
)
"""In the order in which one machine goes through them."""
NAMES = tuple(each.name for each in MOMENTS)
ALSO_IN_ITS_STATE = ("CONFIGURE CONTRACT", "HOME TIGHTEN", "HOME TRY_BASES", "HOME SWEEP")
"""Moments beside another one of the same state."""
BEFORE_SERVICE = NAMES[:3]
"""The drives are being set up."""
SERVICE = NAMES[3:11]
"""The drives answer SYNC, and the supervisor looks for what is wrong with them."""
POWERED = NAMES[4:11]
"""The cable drives are switched on."""
GUIDED = NAMES[7:11]
"""The bases are homed and led."""


class Journey:
    """A machine that is brought to one moment after the other; back to an earlier one with a new
    machine."""

    def __init__(self, generated: Generated, conditions: Conditions = ORDINARY) -> None:
        self._generated, self._conditions = generated, conditions
        self._next = 0
        self._bench = power_on(generated, conditions)

    def at(self, moment: Moment) -> Bench:
        """The machine at a moment: for forks only, so that it stays there."""
        number = MOMENTS.index(moment)
        if number + 1 < self._next:
            self._next, self._bench = 0, power_on(self._generated, self._conditions)
        while self._next <= number:
            reach(self._bench, MOMENTS[self._next])
            self._next += 1
        return self._bench


def reach(bench: Bench, moment: Moment) -> None:
    """From the moment before to this one."""
    lockstep = bench.lockstep
    moment.begin(bench)
    for _ in range(LONGEST):
        if (bench.state, bench.phase) == (moment.state, moment.phase):
            break
        lockstep.cycle()
        lockstep.requests = Request(0)
    else:
        raise AssertionError(f"{moment.name} was not reached: {lockstep.view}")
    lockstep.run(moment.cycles)
    assert (bench.state, bench.phase) == (moment.state, moment.phase), lockstep.view
    assert bench.watch.findings == []


def moment_of(name: str) -> Moment:
    """The moment of that name."""
    return MOMENTS[NAMES.index(name)]


def stock() -> Generated:
    """The stock machine."""
    machine = load_machine(ROOT / "machines" / "yoon2023.toml")
    return Generated(machine, ROOT / "generated" / "yoon2023", "double")
