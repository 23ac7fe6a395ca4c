"""The observer's negative controls: what was heard is tampered with, and it names what is wrong."""

from collections.abc import Callable

import pytest
from forked import in_a_fork
from journey import stock
from observed import MOMENTS, Heard, Observed, working
from observer import Observer, Promise
from observer.causes import Cause
from tampering import (
    MASTERS_BEAT,
    NODE,
    RPDO,
    Answer,
    Order,
    Tamper,
    Tape,
    Where,
    answers,
    both,
    cycle_of,
    late_orders,
    orders,
    with_data,
    with_frame,
    without,
)

from turnbuckle.lab.drives.node import Frame
from turnbuckle.lab.lockstep import Lockstep

LONG = 460
"""Cycles of a tape: a soft stop, and what is switched off in its end."""
CABLE_1, CABLE_2, CABLE_3 = (0, 1), (0, 2), (1, 1)
BASES = [(2, node) for node in (1, 2, 3, 4)]
ON, OFF, ENABLED, IN_FAULT, REFERENCED = 0x0F, 0x00, 0x1237, 0x0208, 0x8000
MOST_PUSH = 3477
"""TB_RAIL_TORQUE_LIMIT [per mille]."""


def nothing(lockstep: Lockstep) -> None:
    """RUN goes on."""


def stranger(lockstep: Lockstep) -> None:
    """A soft stop."""
    lockstep.machine.buses[0].intrude(Frame(0x709, b"\x7f"))


def failing(lockstep: Lockstep) -> None:
    """A hard stop."""
    lockstep.machine.drives[1].raise_error(0x2310)


def silent(lockstep: Lockstep) -> None:
    """A hard stop, and a drive that does not say that it is off."""
    lockstep.machine.drives[2].silent = True


class Tapes:
    """What was heard until RUN, and an observer that has heard that; what was heard afterwards."""

    def __init__(self) -> None:
        generated = stock()
        bench = Observed(generated)
        for reach in MOMENTS[: MOMENTS.index(working) + 1]:
            reach(bench)
        self.begin = list(bench.frames)
        self.machine = generated.machine
        acts = (nothing, stranger, failing, silent)
        self.after: dict[Callable[[Lockstep], None], list[Heard]] = {
            act: bench.frames_after(act, LONG) for act in acts
        }
        self._observer = Observer(self.machine, [])
        listen(self._observer, self.begin)

    def found(self, tape: Tape) -> list[str]:
        """What is found when RUN goes on like that."""

        def act() -> list[str]:
            listen(self._observer, tape)
            return list(self._observer.findings)

        return in_a_fork(act)

    def found_from_the_beginning(self, tamper: Tamper) -> list[str]:
        """What is found when what was heard until RUN is tampered with."""
        observer = Observer(self.machine, [])
        listen(observer, tamper(self.begin))
        return observer.findings


def listen(observer: Observer, tape: Tape) -> None:
    """Let an observer hear a tape."""
    for time, bus, frame in tape:
        observer.hear(bus, frame, time)


@pytest.fixture(scope="module")
def tapes() -> Tapes:
    """Of one machine."""
    return Tapes()


def test_nothing_is_found_in_what_was_heard(tapes: Tapes) -> None:
    for act, tape in tapes.after.items():
        assert tapes.found(tape) == [], act.__doc__


# -- what the master must not do -------------------------------------------------------------------


def of(where: Where, change: Callable[[int, Order], Order | None]) -> Tamper:
    """Changes the setpoints of one drive, by cycle."""
    return orders(lambda drive, cycle, order: change(cycle, order) if drive == where else order)


def held(where: Where, until: int = LONG) -> Tamper:
    """One drive is told what it was told in the beginning, so long."""
    first: list[Order] = []

    def hold(cycle: int, order: Order) -> Order:
        first.append(order)
        return first[0] if cycle < until else order

    return of(where, hold)


def held_cables(until: int) -> Tamper:
    """All cables are."""
    return both(*(held((bus, node), until) for bus in (0, 1) for node in (1, 2)))


def none_at_once(where: Where, cycle: int, order: Order) -> Order:
    """Cables are let go at once."""
    return (order[0], 0) if where[0] < 2 and cycle >= 2 else order


def still_on(where: Where, cycle: int, order: Order) -> Order:
    """Drives stay switched on without torque."""
    return (ON, order[1]) if order[0] & ON != ON else order


def pushed_bases(where: Where, cycle: int, order: Order) -> Order:
    """Bases keep a force while they are on."""
    return (order[0], 300) if where in BASES and order[0] == ON else order


def bases_on(where: Where, cycle: int, order: Order) -> Order:
    """Bases are switched off two cycles late."""
    return (ON, 0) if where in BASES and 0 <= cycle <= 2 else order


def on_again(where: Where, cycle: int, order: Order) -> Order:
    """A drive is switched on after all were off."""
    return (ON, 0) if where == CABLE_3 and cycle > 400 else order


def always_enabled(where: Where, cycle: int, said: Answer) -> Answer:
    """Cable drives are."""
    return (ENABLED, *said[1:]) if where[0] < 2 else said


def second_setpoint(tape: Tape) -> list[Heard]:
    """A setpoint comes twice, once."""
    at = next(i for i, heard in enumerate(tape) if heard.frame.cob == RPDO + 1)
    return [*tape[: at + 1], *tape[at:]]


def longer_setpoint(tape: Tape) -> list[Heard]:
    """A setpoint has other data behind it."""
    at = next(i for i, heard in enumerate(tape) if heard.frame.cob == RPDO + 1)
    return [*tape[:at], with_data(tape[at], tape[at].frame.data + b"\0"), *tape[at + 1 :]]


DEEDS: dict[str, tuple[Callable[[Lockstep], None], Tamper, str, str]] = {
    "a second setpoint in one SYNC": (nothing, second_setpoint, "ONE_A_SYNC", "cable_1"),
    "a setpoint of five bytes": (nothing, longer_setpoint, "WITHIN_LIMITS", "cable_1"),
    "a push on a cable": (nothing, of(CABLE_1, lambda c, o: (ON, -1)), "WITHIN_LIMITS", "cable_1"),
    "too strong a pull": (nothing, of(CABLE_1, lambda c, o: (ON, 919)), "WITHIN_LIMITS", "cable_1"),
    "too strong a push": (
        nothing,
        of(BASES[0], lambda c, o: (ON, MOST_PUSH + 1)),
        "WITHIN_LIMITS",
        "base_1",
    ),
    "too fast a change": (
        nothing,
        of(CABLE_1, lambda c, o: (ON, o[1] + 335 * (c == 100))),
        "WITHIN_RATE",
        "cable_1",
    ),
    "one cable is switched off alone": (
        nothing,
        of(CABLE_1, lambda c, o: (OFF, 0) if c > 50 else o),
        "TOGETHER",
        "cable_2",
    ),
    "one cable is switched off while others pull": (
        nothing,
        of(CABLE_1, lambda c, o: (OFF, 0) if c > 50 else o),
        "HARD_BASES",
        "cable_1",
    ),
    "no heartbeat at work": (nothing, without(MASTERS_BEAT, 1), "BEATS_AT_WORK", "cable2"),
    "a drive that stays on without the master": (
        nothing,
        without(MASTERS_BEAT, 1),
        "LETS_GO_ALONE",
        "cable_3",
    ),
    "a soft stop that begins three cycles late": (
        stranger,
        both(late_orders(3), answers(always_enabled)),
        "SOFT_TO_NONE",
        "cable_1",
    ),
    "a soft stop without its ramp": (stranger, orders(none_at_once), "SOFT_TO_NONE", "cable_1"),
    "a soft stop that holds all cables": (stranger, held_cables(306), "SOFT_TO_NONE", "cable_2"),
    "a soft stop that forgets one cable": (stranger, held(CABLE_3), "SOFT_TO_NONE", "cable_3"),
    "a soft stop in which one cable goes slower": (
        stranger,
        of(CABLE_3, lambda c, o: (o[0], min(250, o[1] + 5)) if 200 < c < 299 else o),
        "SOFT_TO_NONE",
        "cable_3",
    ),
    "a soft stop that goes on pushing bases": (
        stranger,
        orders(pushed_bases),
        "SOFT_BASES",
        "base",
    ),
    "a soft stop that does not switch off": (stranger, orders(still_on), "OFF_IN_TIME", "cable_1"),
    "a hard stop that begins a cycle late": (failing, late_orders(1), "HARD_RAMP", "cable_1"),
    "a hard stop that forgets one cable": (failing, held(CABLE_3), "HARD_RAMP", "cable_3"),
    "a hard stop without a ramp": (failing, held_cables(LONG), "HARD_RAMP", "cable_1"),
    "a hard stop that lets the powerless cable go slowly": (
        failing,
        of(CABLE_2, lambda c, o: (ON, 60) if 0 <= c < 2 else o),
        "HARD_WITHOUT_POWER",
        "cable_2",
    ),
    "a hard stop that keeps its bases on": (failing, orders(bases_on), "HARD_BASES", "base_1"),
    "a hard stop that does not switch off": (failing, orders(still_on), "OFF_IN_TIME", "cable_1"),
    "heartbeats in a hard stop": (
        silent,
        with_frame(6, 0, MASTERS_BEAT, b"\x05", every=10),
        "BEATS_WITHHELD",
        "cable_3",
    ),
    "heartbeats in FAULT while a drive is not known to be off": (
        silent,
        with_frame(300, 0, MASTERS_BEAT, b"\x05"),
        "BEATS_WITHHELD",
        "cable_3",
    ),
    "a drive that is switched on after a fault": (
        failing,
        orders(on_again),
        "STAYS_IN_FAULT",
        "cable_3",
    ),
}


@pytest.mark.parametrize("deed", DEEDS)
def test_what_the_master_must_not_do_is_found(deed: str, tapes: Tapes) -> None:
    act, tamper, promise, culprit = DEEDS[deed]
    found = tapes.found(tamper(tapes.after[act]))
    assert any(f": {promise}: " in each and f" {culprit}" in each for each in found), found


# -- what the master must not overlook -------------------------------------------------------------


def says(where: Where, change: Callable[[int, Answer], Answer | None]) -> Tamper:
    """Changes the answers of one drive, by cycle."""
    return answers(lambda drive, cycle, said: change(cycle, said) if drive == where else said)


def late_answers(tape: Tape) -> list[Heard]:
    """Answers of cable_1 come after the master has looked."""
    late = [
        heard._replace(time=(cycle_of(heard) + 0.8) * 0.001) if heard.frame.cob == 0x181 else heard
        for heard in tape
    ]
    return sorted(late, key=lambda heard: heard.time)


def gap(tape: Tape) -> list[Heard]:
    """Nothing is heard for four cycles."""
    begin = cycle_of(tape[0])
    return [heard for heard in tape if not 10 <= cycle_of(heard) - begin < 14]


class Carriage:
    """A base that goes another way from where it is."""

    def __init__(self, torque: int, way: Callable[[int], int]) -> None:
        self._torque, self._way = torque, way
        self._start: int | None = None

    def __call__(self, where: Where, cycle: int, said: Answer) -> Answer:
        if where != BASES[0]:
            return said
        if self._start is None:
            self._start = said[1]
        return (said[0], self._start + self._way(max(cycle, 0)), self._torque)


def push(force: int) -> Tamper:
    """A base is told a force, step by step."""
    return of(BASES[0], lambda cycle, order: (order[0], min(force, 700 * (max(cycle, 0) // 2 + 1))))


SYMPTOMS: dict[str, tuple[Tamper, str]] = {
    "a fault": (says(CABLE_1, lambda c, s: (IN_FAULT, s[1], 0)), "DRIVE_FAULT of cable_1"),
    "a fault in SOFT_STOP": (
        says(CABLE_1, lambda c, s: (IN_FAULT, s[1], 0) if c > 100 else s),
        "DRIVE_FAULT of cable_1",
    ),
    "an emergency": (
        with_frame(5, 2, 0x083, b"\x10\x23\x03\0\0\0\0\0"),
        "DRIVE_FAULT of base_3",
    ),
    "a drive that is off": (
        says(CABLE_1, lambda c, s: (0x0240, s[1], 0)),
        "DRIVE_STATE of cable_1",
    ),
    "a statusword of no state": (
        says(CABLE_3, lambda c, s: (0x0255, *s[1:])),
        "DRIVE_STATE of cable_3",
    ),
    "no answers": (says(CABLE_1, lambda c, s: None), "DRIVE_SILENT of cable_1"),
    "no answers of a base": (says(BASES[1], lambda c, s: None), "DRIVE_SILENT of base_2"),
    "late answers": (late_answers, "DRIVE_LATE of cable_1"),
    "no heartbeat": (without(0x701, 0), "DRIVE_SILENT of cable_1"),
    "a boot-up message": (with_frame(5, 0, 0x702, b"\0"), "DRIVE_SILENT of cable_2"),
    "a stranger": (with_frame(5, 1, 0x199, bytes(8)), "STRANGER of cable2"),
    "another torque": (says(CABLE_1, lambda c, s: (*s[:2], 0)), "DRIVE_DEAF of cable_1"),
    "a jump": (
        says(CABLE_1, lambda c, s: (s[0], s[1] + 2000 * (c > 9), s[2])),
        "ENCODER_JUMP of cable_1",
    ),
    "a cable that runs away": (
        says(CABLE_1, lambda c, s: (s[0], s[1] + 5 * max(c, 0) ** 2, s[2])),
        "RUNAWAY of cable_1",
    ),
    "a base that runs away": (
        says(BASES[3], lambda c, s: (s[0], s[1] + max(c, 0) ** 2, s[2])),
        "BASE_RUNAWAY of base_4",
    ),
    "a blocked base": (
        both(push(MOST_PUSH), answers(Carriage(MOST_PUSH, lambda c: 0))),
        "BASE_BLOCKED of base_1",
    ),
    "a base that runs the wrong way": (
        both(push(1800), answers(Carriage(1800, lambda cycle: -(min(cycle, 200) ** 2) // 4))),
        "WRONG_WAY of base_1",
    ),
    "a bus without SYNC": (
        lambda tape: [heard for heard in tape if heard.bus != 1],
        "BUS_FULL of cable2",
    ),
    "cycles that are left out": (gap, "CYCLES_MISSED of master"),
}


@pytest.mark.parametrize("symptom", SYMPTOMS)
def test_a_machine_that_overlooks_a_symptom_is_found(symptom: str, tapes: Tapes) -> None:
    tamper, cause = SYMPTOMS[symptom]
    found = tapes.found(tamper(tapes.after[nothing]))
    assert any(f"after {cause} in cycle" in each for each in found), found


# -- before there may be torque --------------------------------------------------------------------


def without_answer(index: int) -> Tamper:
    """The object of cable_1 is not answered for."""
    key = index.to_bytes(2, "little")
    return lambda tape: [
        heard
        for heard in tape
        if not (heard.bus == 0 and heard.frame.cob == 0x581 and heard.frame.data[1:3] == key)
    ]


def another_answer(index: int) -> Tamper:
    """The object of cable_1 holds another value."""
    key = index.to_bytes(2, "little")

    def tamper(tape: Tape) -> list[Heard]:
        return [
            with_data(heard, heard.frame.data[:4] + b"\1\0\0\0")
            if heard.bus == 0 and heard.frame.cob == 0x581 and heard.frame.data[1:3] == key
            else heard
            for heard in tape
        ]

    return tamper


def not_enabled(where: Where, cycle: int, said: Answer) -> Answer:
    """A drive says that it is switched on, not enabled."""
    return (0x0233, said[1], said[2]) if where == CABLE_3 and said[0] & NODE == 0x37 else said


def fault_again(where: Where, cycle: int, said: Answer) -> Answer:
    """A drive comes up in fault."""
    return (IN_FAULT, said[1], 0) if where == CABLE_1 else said


def refused(tape: Tape) -> list[Heard]:
    """cable_1 does not let object 6007 be written."""
    return [
        with_data(heard, b"\x80\x07\x60\0\x22\0\0\x08")
        if (heard.bus, heard.frame.cob) == (0, 0x581) and heard.frame.data[1:3] == b"\x07\x60"
        else heard
        for heard in tape
    ]


def failed_homing(where: Where, cycle: int, said: Answer) -> Answer:
    """base_1 says that its homing has failed."""
    return (said[0] | 0x2000, *said[1:]) if where == BASES[0] else said


def never_enabled(where: Where, cycle: int, said: Answer) -> Answer:
    """base_3 does not get ready."""
    return (said[0] & ~0x06, *said[1:]) if where == BASES[2] else said


BEGINNINGS = {
    "an object that was not written": (without_answer(0x6007), "SET_UP_FIRST", "6007:0"),
    "another current limit": (another_answer(0x3001), "STAYS_IN_FAULT", "DRIVE_DIFFERENT"),
    "an identity that was not read": (without_answer(0x6076), "IDENTITY_FIRST", "6076:0"),
    "a drive that cannot pull": (answers(not_enabled), "NONE_ALONE", "cable_3"),
    "a drive in fault is armed": (answers(fault_again), "NO_TORQUE_BEFORE", "cable_1"),
    "an object that was refused": (refused, "STAYS_IN_FAULT", "DRIVE_SETUP of cable_1"),
    "a drive that boots twice": (
        with_frame(400, 2, 0x702, b"\0"),
        "STAYS_IN_FAULT",
        "DRIVE_TWICE of base_2",
    ),
    "a homing that fails": (answers(failed_homing), "SOFT_TO_NONE", "HOMING of base_1"),
    "a base that is not enabled": (answers(never_enabled), "SOFT_TO_NONE", "DRIVE_STUCK of base_3"),
    "a fault is not reset": (answers(fault_again), "FAULTS_RESET", "cable_1"),
}


@pytest.mark.parametrize("beginning", BEGINNINGS)
def test_a_machine_that_goes_on_too_early_is_found(beginning: str, tapes: Tapes) -> None:
    tamper, promise, words = BEGINNINGS[beginning]
    found = tapes.found_from_the_beginning(tamper)
    assert any(f": {promise}: " in each and words in each for each in found), found


def test_every_promise_and_cause_is_seen_to_be_found() -> None:
    tried = {promise for _, _, promise, _ in DEEDS.values()}
    tried |= {promise for _, promise, _ in BEGINNINGS.values()}
    assert tried == {promise.name for promise in Promise}
    words = [*(cause for _, cause in SYMPTOMS.values()), *(each[2] for each in BEGINNINGS.values())]
    assert {cause.name for cause in Cause} <= {each.split()[0] for each in words}
