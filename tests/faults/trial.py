"""Faults at one moment: strike, look at the machine in every cycle until it is over."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import dist, isnan

from catalogue import Fault
from journey import Bench
from supervised import Phase

from turnbuckle.lab.drives.power import MOVING
from turnbuckle.lab.lockstep import Lockstep, Request, State

AFTERWARDS = 20
"""Cycles for which a machine without torque is looked at."""
TRANSPORT = 3
"""SYNCs from an order to the drive that obeys."""
LONGEST = 12_000
"""Cycles of a trial, at most."""


@dataclass
class Outcome:
    """What a fault led to.

    Cycles are counted from the strike: 1 is the first after it. Torques in N m, of the drives and
    not of what the master believes; lengths in m, tensions in N.
    """

    states: list[str] = field(default_factory=list)
    """From the strike on."""
    causes: list[int] = field(default_factory=list)
    """tb_cause, from the strike on."""
    culprit: int = 0
    detail: int = 0
    reacted: int | None = None
    """Cycle in which the cause was told."""
    quiet: int | None = None
    """Cycle from which on no drive had torque until the end."""
    off: int | None = None
    """The same for no drive was switched on."""
    cycles: int = 0
    alone: int = 0
    """Cycles in a row in which a cable was pulled and another one was not."""
    behind: float = 0.0
    """By how much any cable was pulled more than the ramps of its stop let it."""
    highest: float = 0.0
    """Tension of any cable."""
    astray: float = 0.0
    """Between the handle and where the hand wants it."""
    handle: float = 0.0
    """Speed of the handle [m/s]."""
    carriage: float = 0.0
    """Speed of any carriage [m/s]."""
    off_track: float = 0.0
    """Between any carriage and where it is led, until a stop leads it no more."""
    rolled: float = 0.0
    """How far any carriage got after the reaction."""
    findings: list[str] = field(default_factory=list)
    """Of the watch on the setpoints."""


class Ramps:
    """How much torque every cable may have at most while a stop goes on."""

    def __init__(self, bench: Bench) -> None:
        machine, supervision = bench.machine, bench.machine.supervision
        self._half = supervision.stop_time * machine.control.rate / 2
        self._rest = machine.tension.min * machine.drum.radius
        self._step = machine.cable_motor.torque_rate_limit / machine.control.rate
        self._state: State | None = None
        self._cycles = 0
        self._begun: list[float] = []

    def behind(self, state: State, torques: list[float]) -> float:
        """How much more the cables are pulled, in the next cycle of a stop."""
        if state is not self._state:
            self._state, self._cycles, self._begun = state, 0, torques
        self._cycles += 1
        return max(now - self._most(begun) for now, begun in zip(torques, self._begun, strict=True))

    def _most(self, begun: float) -> float:
        cycles = max(0, self._cycles - TRANSPORT)
        if self._state is State.SOFT_STOP:
            rest = min(begun, self._rest)
            to_rest = rest + (begun - rest) * (1.0 - cycles / self._half)
            return max(0.0, to_rest if cycles <= self._half else rest * (2.0 - cycles / self._half))
        return max(0.0, begun - cycles * self._step)


Blow = tuple[int, Fault]
"""A fault, and the cycles after the begin of the trial in which it strikes."""


class Trial:
    """A machine that is struck, cycle by cycle."""

    def __init__(self, bench: Bench, *blows: Blow) -> None:
        self.outcome = Outcome()
        self._bench, self._blows = bench, blows
        self._lockstep: Lockstep = bench.lockstep
        self._machine = bench.lockstep.machine
        self._cables = self._machine.drives[: len(self._machine.world.tensions)]
        self._standing = 0
        self._alone = 0
        self._ready = 0
        self._ramps = Ramps(bench)
        self._handle = self._machine.world.position
        self._rails = self._machine.world.rails
        self._left: list[float] | None = None
        self.was = bench.state
        self.cause = int(self._lockstep.view["cause"])
        self._pull = 1.1 * bench.machine.tension.min * bench.machine.drum.radius

    def run(self, horizon: int, until_ready: bool = False, least: int = AFTERWARDS) -> Outcome:
        """Strike, then run until the machine is off for a while, and for `least` cycles; one that
        does not react, for so many cycles, or until it is ready."""
        self._ask_to_arm()
        for cycle in range(1, LONGEST + 1):
            self._cycle(cycle)
            if cycle >= least and self._is_over(cycle, horizon, until_ready):
                break
        self.outcome.findings = self._bench.watch.findings + self._observed()
        return self.outcome

    def _observed(self) -> list[str]:
        """What the observer of the wire says of one fault, unless it keeps the master from sending:
        of that the document promises what the drives do."""
        faults = [fault for _, fault in self._blows]
        if len(faults) > 1 or any(fault.stands_still or fault.deaf for fault in faults):
            return []
        return [f"observer: {words}" for words in self._bench.observer.findings]

    def _ask_to_arm(self) -> None:
        """A request that stands, to see that nothing arms again by itself."""
        ready = self.was is State.CONFIGURE and self._bench.phase == Phase.READY
        arms = self.outcome.reacted is not None or not ready
        self._lockstep.requests = Request.ARM if arms else Request(0)

    def _cycle(self, cycle: int) -> None:
        for begin, fault in self._blows:
            self._strike(fault, cycle - 1 - begin)
        if self._standing:
            self._standing -= 1
            self._lockstep.stand_still()
            self._lockstep.missed += 1
        else:
            self._lockstep.cycle()
        self.outcome.cycles = cycle
        self._listen(cycle)
        self._measure(cycle)

    def _strike(self, fault: Fault, since: int) -> None:
        if since == 0:
            fault.strike(self._lockstep)
            self._standing += fault.stands_still
        if since >= 0:
            fault.each(self._lockstep, since)

    def _listen(self, cycle: int) -> None:
        """What the supervisor says."""
        outcome, view = self.outcome, self._lockstep.view
        state, cause = State(int(view["state"])).name, int(view["cause"])
        if not outcome.states or outcome.states[-1] != state:
            outcome.states.append(state)
        if not outcome.causes or outcome.causes[-1] != cause:
            outcome.causes.append(cause)
        if outcome.reacted is None and cause != self.cause:
            outcome.reacted = cycle
            outcome.culprit, outcome.detail = int(view["culprit"]), int(view["detail"])
            self._ask_to_arm()

    def _measure(self, cycle: int) -> None:
        """What the machine does."""
        outcome, world = self.outcome, self._machine.world
        drives = self._machine.drives
        outcome.quiet = since(cycle, outcome.quiet, not any(each.servo.torque for each in drives))
        still = all(each.servo.power not in MOVING for each in drives)
        outcome.off = since(cycle, outcome.off, still)
        outcome.highest = max(outcome.highest, world.highest_tension)
        outcome.astray = max(outcome.astray, dist(world.position, self._machine.hand_goal))
        moved, self._handle = dist(world.position, self._handle), world.position
        outcome.handle = max(outcome.handle, moved / self._machine.period)
        self._compare_cables()
        self._follow_carriages(world.rails)

    def _follow_carriages(self, rails: list[float]) -> None:
        outcome = self.outcome
        led = [float(place) for place in self._lockstep.view["led"]]
        period = self._machine.period
        outcome.carriage = max(outcome.carriage, farthest(rails, self._rails) / period)
        self._rails = rails
        if not isnan(led[0]):
            outcome.off_track = max(outcome.off_track, farthest(rails, led))
        if outcome.reacted is not None:
            self._left = self._left or rails
            outcome.rolled = max(outcome.rolled, farthest(rails, self._left))

    def _compare_cables(self) -> None:
        outcome = self.outcome
        torques = [abs(each.servo.torque) for each in self._cables]
        self._alone = self._alone + 1 if max(torques) > self._pull and not min(torques) else 0
        outcome.alone = max(outcome.alone, self._alone)
        if outcome.reacted is None:
            return
        state = self._bench.state
        outcome.behind = max(outcome.behind, self._ramps.behind(state, torques))

    def _is_over(self, cycle: int, horizon: int, until_ready: bool) -> bool:
        outcome = self.outcome
        rested = outcome.off is not None and cycle - outcome.off >= AFTERWARDS
        if self._standing > LONGEST:
            return rested
        state = self._bench.state
        if outcome.reacted is None and self.was < State.SOFT_STOP:
            self._ready += self._bench.phase == Phase.READY
            return cycle >= horizon and (self._ready >= AFTERWARDS or not until_ready)
        done = state is State.FAULT or (state is State.CONFIGURE and self.was > State.CONFIGURE)
        return done and rested


def since(cycle: int, before: int | None, holds: bool) -> int | None:
    """Cycle from which on something holds."""
    return (cycle if before is None else before) if holds else None


def farthest(rails: Sequence[float], others: Sequence[float]) -> float:
    """Largest distance [m] of any carriage from another place on its rail."""
    return max(abs(one - other) for one, other in zip(rails, others, strict=True))
