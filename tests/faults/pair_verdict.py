"""What docs/safety.md promises for two faults in one run, and what of it failed.

Which of two faults is told is not asked: either may hide the other. What drives, cables, carriages
and handle do is.
"""

from catalogue import ALWAYS, HEARTBEAT_LOST
from pairs import Pair
from trial import TRANSPORT, Outcome
from verdict import CAUSES, HARD, NUMBERS, SLOWEST_BUS, motion

from turnbuckle.lab.lockstep import State

STOPS = ("SOFT_STOP", "HARD_STOP", "FAULT")
DETECTED = int(NUMBERS["TB_MISSED_LIMIT"] + 1) * SLOWEST_BUS
"""Cycles in which a drive without power is seen, at the latest: it is silent."""


def complaints(pair: Pair, outcome: Outcome) -> list[str]:
    """What is not as promised, in words."""
    return [
        *outcome.findings,
        *way(pair, outcome),
        *end(pair, outcome),
        *alone(pair, outcome),
        *motion(outcome, pair.faults),
    ]


def way(pair: Pair, outcome: Outcome) -> list[str]:
    """Nothing arms again, no stop becomes a weaker one, and the first cause stands."""
    found = []
    states = outcome.states
    if pair.moment.state <= State.CONFIGURE and "HOME" in states:
        found.append("arms by itself")
    begun = next((number for number, each in enumerate(states) if each in STOPS), len(states))
    stopped = [each for each in states[begun:] if each != "CONFIGURE"]
    if stopped != sorted(stopped, key=lambda each: STOPS.index(each) if each in STOPS else -1):
        found.append(f"goes through {', '.join(states)}")
    causes = [CAUSES[each] for each in outcome.causes if CAUSES[each] not in ("NONE", "REQUESTED")]
    if len(causes) > 1:
        found.append(f"the first cause does not stand: {causes}")
    return found


def end(pair: Pair, outcome: Outcome) -> list[str]:
    """No drive has torque, and then is on, in time, if there was a reason."""
    killed = is_killed(pair)
    if outcome.reacted is None and pair.moment.state < State.SOFT_STOP and not killed:
        return []
    if outcome.quiet is None or outcome.off is None:
        what = "has torque" if outcome.quiet is None else "is on"
        return [f"a drive {what} in the end"]
    bound = latest(pair, outcome)
    found = []
    if outcome.quiet > bound:
        found.append(f"torque until cycle {outcome.quiet}, not {bound}")
    if outcome.off > bound + TRANSPORT * SLOWEST_BUS:
        found.append(f"switched on until cycle {outcome.off}, not {bound}")
    return found


def latest(pair: Pair, outcome: Outcome) -> int:
    """Cycle from which on no drive has torque: a stop from the reaction, and once more from a fault
    that keeps a drive from hearing it."""
    soft = "SOFT_STOP" in outcome.states
    ramp = int(NUMBERS["TB_STOP_CYCLES"]) if soft else HARD
    transport = TRANSPORT * SLOWEST_BUS
    bound = (outcome.reacted or 0) + ramp + transport + standing(pair)
    blows = ((0, pair.first), (pair.between, pair.second))
    deaf = [begin for begin, fault in blows if fault.deaf]
    if any(fault.brakes for fault in pair.faults):
        bound += int(NUMBERS["TB_HEARTBEAT_TIMEOUT"])
    if deaf:
        waits = int(NUMBERS["TB_HEARTBEAT_TIMEOUT"]) if soft else 0
        bound = max(bound, *deaf) + transport + waits + HEARTBEAT_LOST
    return bound


def alone(pair: Pair, outcome: Outcome) -> list[str]:
    """A cable pulls alone only until it is known that another one cannot, and let go."""
    bound = DETECTED + HARD + TRANSPORT + standing(pair)
    bound += HEARTBEAT_LOST if any(fault.deaf for fault in pair.faults) else 0
    too_long = outcome.alone > bound
    return [f"a cable is pulled alone for {outcome.alone} cycles, not {bound}"] if too_long else []


def standing(pair: Pair) -> int:
    """Cycles in which the master does nothing."""
    return sum(fault.stands_still % ALWAYS for fault in pair.faults)


def is_killed(pair: Pair) -> bool:
    """Whether the master does nothing any more."""
    return any(fault.stands_still == ALWAYS for fault in pair.faults)
