"""Changes what was heard on the wires, so that it breaks a promise: the code stays as it is."""

from collections.abc import Callable, Sequence
from struct import Struct

from observed import BEFORE, Heard

from turnbuckle.lab.drives.node import Frame

SETPOINT, ANSWER = Struct("<Hh"), Struct("<Hih")
RPDO, TPDO, NODE, MASTERS_BEAT = 0x200, 0x180, 0x07F, 0x77F
CYCLE = 0.001

Order = tuple[int, int]
"""Controlword and torque."""
Answer = tuple[int, int, int]
"""Statusword, position, torque."""
Tape = Sequence[Heard]
Tamper = Callable[[Tape], list[Heard]]
Where = tuple[int, int]
"""Bus and node."""


def orders(change: Callable[[Where, int, Order], Order | None]) -> Tamper:
    """Changes every setpoint, by drive, cycle since something is done and what it was; None: not
    sent."""

    def tamper(tape: Tape) -> list[Heard]:
        def changed(heard: Heard, cycle: int) -> Heard | None:
            where = heard.bus, heard.frame.cob & NODE
            order = change(where, cycle, SETPOINT.unpack(heard.frame.data))
            return None if order is None else with_data(heard, SETPOINT.pack(*order))

        return _each(tape, RPDO, changed)

    return tamper


def answers(change: Callable[[Where, int, Answer], Answer | None]) -> Tamper:
    """Changes every answer, by drive, cycle since something is done and what it was; None: lost."""

    def tamper(tape: Tape) -> list[Heard]:
        def changed(heard: Heard, cycle: int) -> Heard | None:
            where = heard.bus, heard.frame.cob & NODE
            answer = change(where, cycle, ANSWER.unpack(heard.frame.data))
            return None if answer is None else with_data(heard, ANSWER.pack(*answer))

        return _each(tape, TPDO, changed)

    return tamper


def _each(tape: Tape, function: int, change: Callable[[Heard, int], Heard | None]) -> list[Heard]:
    begin, tampered = begin_of(tape), []
    for heard in tape:
        concerned = heard.frame.cob & ~NODE == function
        kept = change(heard, cycle_of(heard) - begin) if concerned else heard
        if kept is not None:
            tampered.append(kept)
    return tampered


def late_orders(cycles: int) -> Tamper:
    """Every setpoint is that of so many cycles before."""

    def tamper(tape: Tape) -> list[Heard]:
        begin = begin_of(tape)
        told = {
            (heard.bus, heard.frame.cob, cycle_of(heard) - begin): heard.frame.data
            for heard in tape
        }

        def changed(heard: Heard, cycle: int) -> Heard:
            data = told.get((heard.bus, heard.frame.cob, cycle - cycles), heard.frame.data)
            return with_data(heard, data)

        return _each(tape, RPDO, changed)

    return tamper


def without(cob: int, bus: int | None = None) -> Tamper:
    """No frame with this identifier."""
    return lambda tape: [
        heard for heard in tape if heard.frame.cob != cob or (bus is not None and heard.bus != bus)
    ]


def with_frame(cycle: int, bus: int, cob: int, data: bytes, every: int = 0) -> Tamper:
    """Another frame late in a cycle, and every so many cycles."""

    def tamper(tape: Tape) -> list[Heard]:
        begin, last = begin_of(tape), cycle_of(tape[-1])
        at = range(begin + cycle, last, every) if every else [begin + cycle]
        more = [Heard((number + 0.9) * CYCLE, bus, Frame(cob, data)) for number in at]
        return sorted([*tape, *more], key=lambda heard: heard.time)

    return tamper


def both(*tampers: Tamper) -> Tamper:
    """One after the other."""

    def tamper(tape: Tape) -> list[Heard]:
        changed = list(tape)
        for each in tampers:
            changed = each(changed)
        return changed

    return tamper


def with_data(heard: Heard, data: bytes) -> Heard:
    """The same frame with other data."""
    return heard._replace(frame=Frame(heard.frame.cob, data))


def cycle_of(heard: Heard) -> int:
    """The cycle in which a frame arrived."""
    return int(heard.time / CYCLE + 1e-9)


def begin_of(tape: Tape) -> int:
    """The cycle of a tape in which something is done; cycles are counted from there."""
    return cycle_of(tape[0]) + BEFORE
