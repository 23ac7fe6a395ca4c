"""What docs/safety.md and the machine file promise for a fault at a moment; what of it failed."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil

from catalogue import ALWAYS, HEARTBEAT_LOST, Fault, Sign
from journey import BEFORE_SERVICE, Moment
from safety_table import DOCUMENT, Row, bounds, constants, rows
from trial import TRANSPORT, Outcome

from turnbuckle.lab.lockstep import State

NUMBERS = constants(DOCUMENT.parents[1] / "generated" / "yoon2023")
TABLE = {row.cause: row for row in rows()}
CAUSES = ["NONE", *TABLE]
"""By tb_cause."""
ATTENTIVE = 60
"""Cycles for which a machine that is to go on is looked at."""
BEHIND = 0.001
"""Torque [N m] by which a cable may be behind the others in a stop: 2 % of its limit."""
HARD = ceil(NUMBERS["TB_TORQUE_LIMIT"] / NUMBERS["TB_TORQUE_STEP"])
"""Cycles of the ramp of a hard stop."""
DRIVES_ON_BUS = 6
"""Cycles until it is a drive's turn to be asked by SDO, and to answer, at most."""
CABLES = int(NUMBERS["TB_CABLES"])
SLOWEST_BUS = 2
"""Largest divider of the stock machine's buses."""
BOUNDS = bounds(NUMBERS)


@dataclass(frozen=True)
class Expected:
    """What must come of a fault at a moment; no signs: the machine goes on."""

    moment: Moment
    fault: Fault
    signs: tuple[Sign, ...]

    @property
    def until_ready(self) -> bool:
        """Set-up is followed to its end from where the contract is written."""
        return self.moment.name == BEFORE_SERVICE[-1]

    @property
    def horizon(self) -> int:
        """Cycles to look for the reaction."""
        return max([ATTENTIVE, *(self.latest(sign) + 1 for sign in self.signs)])

    def latest(self, sign: Sign) -> int:
        """Cycle in which the supervisor has reacted to a sign, at the latest."""
        names = {**NUMBERS, "divider": self.fault.divider, "DRIVES_ON_BUS": DRIVES_ON_BUS}
        after = int(eval(sign.after, {"__builtins__": {}}, names))
        return 1 + after + TABLE[sign.cause].cycles(NUMBERS, self.fault.divider)


def expected(fault: Fault, moment: Moment) -> Expected:
    """The signs of a fault that the supervisor looks for at a moment."""
    signs = tuple(
        sign
        for sign in fault.signs
        if moment.name in sign.moments
        and (moment.state.name in TABLE[sign.cause].states or moment.name in BEFORE_SERVICE)
    )
    return Expected(moment, fault, signs)


def complaints(wanted: Expected, outcome: Outcome) -> list[str]:
    """What is not as promised, in words."""
    found = [*outcome.findings, *at_the_end(wanted, outcome), *physics(wanted, outcome)]
    if wanted.signs:
        found += reaction(wanted, outcome)
    else:
        found += no_reaction(wanted, outcome)
    return found


def no_reaction(wanted: Expected, outcome: Outcome) -> list[str]:
    """The machine goes on as if nothing had been, or stays in its stop."""
    if outcome.reacted is not None:
        return [f"goes on: it reacts with {CAUSES[outcome.causes[-1]]}"]
    if wanted.moment.state <= State.CONFIGURE and "HOME" in outcome.states:
        return ["arms by itself"]
    ends = {State.SOFT_STOP: "CONFIGURE", State.HARD_STOP: "FAULT", State.FAULT: "FAULT"}
    end = ends.get(wanted.moment.state)
    if end and wanted.fault.stands_still != ALWAYS and outcome.states[-1] != end:
        return [f"ends in {outcome.states[-1]}, not {end}"]
    return []


def reaction(wanted: Expected, outcome: Outcome) -> list[str]:
    """The right cause, in time, with the right stop."""
    if outcome.reacted is None:
        return [f"no reaction in {outcome.cycles} cycles"]
    told = CAUSES[next(each for each in outcome.causes if each > 1)]
    signs = [sign for sign in wanted.signs if sign.cause == told]
    if not signs:
        return [f"{told} in cycle {outcome.reacted}"]
    found = []
    latest = max(wanted.latest(sign) for sign in signs)
    if outcome.reacted > latest:
        found.append(f"{told} in cycle {outcome.reacted}, not by {latest}")
    row = TABLE[told]
    blamed = {"drive": wanted.fault.drives, "bus": (wanted.fault.bus,)}.get(row.culprit)
    if blamed and outcome.culprit not in blamed:
        found.append(f"{told} blames {outcome.culprit}, not {blamed}")
    return found + way(wanted, row, outcome)


def way(wanted: Expected, row: Row, outcome: Outcome) -> list[str]:
    """The states that a reaction goes through, and the first cause stands."""
    after = [each for each in outcome.states if each in ("SOFT_STOP", "HARD_STOP", "FAULT")]
    soft = ["SOFT_STOP", "FAULT"]
    escalated = ["SOFT_STOP", "HARD_STOP", "FAULT"]
    hard = ["HARD_STOP", "FAULT"]
    if wanted.moment.state <= State.CONFIGURE:
        allowed = [["FAULT"]]
    elif wanted.moment.state is State.SOFT_STOP:
        allowed = [hard, escalated] if row.hard else [soft, escalated]
    else:
        allowed = [hard] if row.hard else [soft, escalated]
    found = [] if after in allowed else [f"goes through {', '.join(after)}"]
    causes = [each for each in outcome.causes if CAUSES[each] not in ("NONE", "REQUESTED")]
    if len(causes) > 1:
        found.append(f"the first cause does not stand: {[CAUSES[each] for each in causes]}")
    return found


def at_the_end(wanted: Expected, outcome: Outcome) -> list[str]:
    """Every drive is off, in time, if there was a reason."""
    stopped = wanted.signs or wanted.moment.state >= State.SOFT_STOP
    if not stopped and wanted.fault.stands_still != ALWAYS:
        return []
    if outcome.quiet is None or outcome.off is None:
        what = "has torque" if outcome.quiet is None else "is on"
        return [f"a drive {what} in the end"]
    begun = 0 if outcome.reacted is None else outcome.reacted
    bound = begun + stop_cycles(wanted, outcome)
    found = []
    if outcome.quiet > bound:
        found.append(f"torque until cycle {outcome.quiet}, not {bound}")
    bound += TRANSPORT * SLOWEST_BUS
    if outcome.off > bound:
        found.append(f"switched on until cycle {outcome.off}, not {bound}")
    return found


def stop_cycles(wanted: Expected, outcome: Outcome) -> int:
    """Cycles from the reaction until no drive has torque, at the latest."""
    fault = wanted.fault
    if fault.stands_still == ALWAYS:
        return HEARTBEAT_LOST
    soft = "SOFT_STOP" in outcome.states
    ramp = int(NUMBERS["TB_STOP_CYCLES"]) if soft else HARD
    waits = int(NUMBERS["TB_HEARTBEAT_TIMEOUT"]) if soft else 0
    late = HEARTBEAT_LOST + waits if fault.deaf else 0
    return ramp + TRANSPORT * SLOWEST_BUS + late + fault.stands_still % ALWAYS


def physics(wanted: Expected, outcome: Outcome) -> list[str]:
    """Cables pull together or not at all, and not too hard; handle and carriages are not thrown."""
    fault, found = wanted.fault, []
    reacted = outcome.reacted or 0
    alone = reacted + HARD + TRANSPORT + (HEARTBEAT_LOST if fault.deaf else 0)
    alone += fault.stands_still % ALWAYS
    if outcome.alone > alone:
        found.append(f"a cable is pulled alone for {outcome.alone} cycles, not {alone}")
    if outcome.behind > BEHIND and not fault.deaf:
        found.append(f"a cable is {1e3 * outcome.behind:.1f} mN m behind the ramps of the stop")
    return found + motion(outcome, (fault,))


def motion(outcome: Outcome, faults: Sequence[Fault]) -> list[str]:
    """What pulls and moves, by the document's bounds."""
    reached = measured(outcome, faults)
    return [
        f"{name}: {value:.3g}, not {BOUNDS[name]:.3g}"
        for name, value in reached.items()
        if value > BOUNDS[name]
    ]


def measured(outcome: Outcome, faults: Sequence[Fault]) -> dict[str, float]:
    """What was reached, by the name of its bound."""
    pulled = "_FOREIGN" if any(fault.strong for fault in faults) else ""
    led = "_FOREIGN" if any(is_led_astray(fault) for fault in faults) else ""
    reached = {
        f"TENSION{pulled}": outcome.highest,
        "HANDLE": outcome.astray,
        "HANDLE_SPEED": outcome.handle,
        f"CARRIAGE_SPEED{led}": outcome.carriage,
        f"ROLLED{led}": outcome.rolled,
    }
    if not any(fault.stands_still for fault in faults):  # a master that stands leads nothing
        reached[f"OFF_TRACK{led}"] = outcome.off_track
    return reached


def is_led_astray(fault: Fault) -> bool:
    """Whether a base may be led by something else than the controller, or goes on as it was led."""
    bases = [drive for drive in fault.drives if drive >= CABLES]
    return (fault.strong and bool(bases)) or (fault.deaf and (bool(bases) or not fault.drives))
