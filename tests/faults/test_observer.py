"""Somebody who knows docs/safety.md alone hears the wires, and finds every promise kept."""

import re
from collections.abc import Callable, Iterator
from functools import partial
from math import nan
from random import Random

import pytest
from journey import ROOT, stock
from observed import MOMENTS, Observed
from observer import Promise
from observer.causes import Cause

from turnbuckle.codegen.bind import Generated
from turnbuckle.lab.drives.bus import Disturbance, Mishap
from turnbuckle.lab.drives.node import Frame
from turnbuckle.lab.drives.setup import Setup
from turnbuckle.lab.drives.wire import Conditions
from turnbuckle.lab.lockstep import BusState, Lockstep, Request, State

ANSWER, SETPOINT, SYNC, MASTERS_BEAT, BEAT = 0x180, 0x200, 0x080, 0x77F, 0x700
STATE_TIMEOUT = 2000
"""Cycles: TB_STATE_TIMEOUT."""
ENOUGH = 460
"""Cycles: a soft stop, and what is switched off in its end."""
FAULTS_A_MOMENT = 8
Fault = Callable[[Lockstep], None]


@pytest.fixture(scope="module")
def generated() -> Generated:
    """The stock machine."""
    return stock()


CONDITIONS = {
    "wires at their worst": Conditions(worst=True),
    "disturbed wires": Conditions(errors=0.002),
}


@pytest.mark.parametrize("name", CONDITIONS)
def test_nothing_is_found_from_power_on_to_fault_on(name: str, generated: Generated) -> None:
    bench = Observed(generated, CONDITIONS[name])
    bench.get_ready()
    bench.ask(Request.ARM)
    bench.until_state(State.RUN, 50)
    bench.work()
    bench.lockstep.run(400)
    bench.ask(Request.STOP)
    bench.get_ready()
    bench.ask(Request.ARM)
    bench.until_state(State.HOME, 200)
    bench.lockstep.machine.drives[5].raise_error(0x8611)
    bench.until_state(State.FAULT, 300)
    assert bench.observer.findings == []


def test_a_machine_whose_drives_are_in_fault_is_set_up_again_after_a_reset(
    generated: Generated,
) -> None:
    bench = Observed(generated)
    bench.get_ready()
    bench.ask(Request.ARM)
    bench.until_state(State.HOME, 100)
    bench.lockstep.machine.drives[1].raise_error(0x2310)
    bench.until_state(State.FAULT, 20)
    bench.ask(Request.RESET)
    bench.lockstep.run(STATE_TIMEOUT + 800)
    assert bench.observer.findings == []
    assert bench.lockstep.state is State.CONFIGURE


# -- faults ----------------------------------------------------------------------------------------


def drive(number: int, act: Callable[..., None], *values: object) -> Fault:
    """Something happens to a drive."""
    return lambda lockstep: act(lockstep.machine.drives[number], *values)


def frames(cob: int, mishap: Mishap, count: int, cycles: int = 0, flips: bytes = b"") -> Fault:
    """Something happens to the next frames on the first bus."""
    disturbance = Disturbance(mishap, cycles, flips)
    return lambda lockstep: lockstep.machine.buses[0].disturb(cob, disturbance, count)


def say_falsely(drive: object, statusword: int) -> None:
    drive.servo.false_statusword = statusword  # type: ignore[attr-defined]


def fall_silent(drive: object) -> None:
    drive.silent = True  # type: ignore[attr-defined]


def pass_over(lockstep: Lockstep, cycles: int) -> None:
    """The program does not run for some cycles."""
    for _ in range(cycles):
        lockstep.stand_still()
    lockstep.missed = cycles


FAULTS: dict[str, Fault] = {
    "a cable drive fails": drive(1, lambda d: d.raise_error(0x2310)),
    "a base drive fails": drive(6, lambda d: d.raise_error(0x8611)),
    "a drive warns": drive(1, lambda d: d.raise_error(0xFF01)),
    "a cable drive is silent": drive(2, fall_silent),
    "a base drive is silent": drive(4, fall_silent),
    "a cable drive loses its supply": drive(3, lambda d: d.shut_down()),
    "a base drive loses its supply": drive(5, lambda d: d.shut_down()),
    "a drive starts again": drive(3, lambda d: d.switch_on()),
    "a statusword of no state": drive(0, say_falsely, 0x0255),
    "a false quick stop": drive(0, say_falsely, 0x0217),
    "a false off": drive(0, say_falsely, 0x0240),
    "a statusword without remote": drive(0, say_falsely, 0x1037),
    "a false operation": drive(0, say_falsely, 0x1237),
    "a frozen cable encoder": drive(0, lambda d: d.servo.encoder.distort(0.0)),
    "a frozen base encoder": drive(4, lambda d: d.servo.encoder.distort(0.0)),
    "a reversed base encoder": drive(4, lambda d: d.servo.encoder.distort(-1.0)),
    "a cable encoder that jumps": drive(1, lambda d: d.servo.encoder.jump(5000)),
    "a base encoder that jumps": drive(5, lambda d: d.servo.encoder.jump(5000)),
    "a cable encoder that runs away": drive(1, lambda d: d.servo.encoder.distort(3000.0)),
    "two answers are lost": frames(ANSWER + 1, Mishap.DROP, 2),
    "three answers are lost": frames(ANSWER + 1, Mishap.DROP, 3),
    "answers come twice": frames(ANSWER + 1, Mishap.DUPLICATE, 9),
    "answers come late": frames(ANSWER + 1, Mishap.DELAY, 9, 1),
    "answers come very late": frames(ANSWER + 1, Mishap.DELAY, 9, 2),
    "a fault is read into an answer": frames(ANSWER + 1, Mishap.CORRUPT, 1, flips=b"\x28"),
    "a far position is read": frames(ANSWER + 1, Mishap.CORRUPT, 1, flips=b"\0\0\0\x40"),
    "short answers": frames(ANSWER + 1, Mishap.SHORTEN, 9),
    "setpoints are lost": frames(SETPOINT + 1, Mishap.DROP, 300),
    "setpoints come twice": frames(SETPOINT + 1, Mishap.DUPLICATE, 9),
    "a short setpoint": frames(SETPOINT + 1, Mishap.SHORTEN, 1),
    "three SYNCs are lost": frames(SYNC, Mishap.DROP, 3),
    "the master's heartbeat is lost": frames(MASTERS_BEAT, Mishap.DROP, 20),
    "a drive's heartbeat is lost": frames(BEAT + 1, Mishap.DROP, 20),
    "a cable bus is off": lambda lockstep: lockstep.set_bus(0, BusState.BUS_OFF),
    "the base bus is off": lambda lockstep: lockstep.set_bus(2, BusState.BUS_OFF),
    "a bus is full": lambda lockstep: lockstep.set_bus(1, BusState.ERROR_ACTIVE, full=True),
    "a force that is no number": lambda lockstep: setattr(lockstep, "force", (nan, 0.0)),
    "a cable breaks": lambda lockstep: lockstep.machine.plant.break_cable(1),
    "a cable is hooked": lambda lockstep: lockstep.machine.plant.hook_cable(1, 0.01),
    "five cycles are left out": partial(pass_over, cycles=5),
    "eighty cycles are left out": partial(pass_over, cycles=80),
    "a stranger": lambda lockstep: lockstep.machine.buses[0].intrude(Frame(0x709, b"\x7f")),
    "a node twice": lambda lockstep: setattr(lockstep.machine.add_stranger(0, Setup(2)), "x", 0),
}


@pytest.fixture(scope="module")
def moments(generated: Generated) -> Iterator[Callable[[int], Observed]]:
    """The machine at one moment after the other; in order only."""
    bench, reached = Observed(generated), -1

    def at(number: int) -> Observed:
        nonlocal reached
        while reached < number:
            reached += 1
            MOMENTS[reached](bench)
        return bench

    yield at


@pytest.mark.parametrize("number", range(len(MOMENTS)), ids=lambda n: MOMENTS[n].__name__)
def test_the_machine_keeps_its_promises_when_something_is_wrong(
    number: int, moments: Callable[[int], Observed]
) -> None:
    bench = moments(number)
    for name in Random(number).sample(sorted(FAULTS), FAULTS_A_MOMENT):
        found, _ = bench.after(FAULTS[name], ENOUGH)
        assert found == [], name
    assert bench.observer.findings == []


# -- the document ----------------------------------------------------------------------------------


@pytest.mark.parametrize("promise", Promise, ids=lambda promise: promise.name)
def test_a_promise_is_the_sentence_of_a_document(promise: Promise) -> None:
    names = ("safety", "buses", "running")
    text = " ".join((ROOT / "docs" / f"{name}.md").read_text() for name in names)
    assert promise.value in re.sub(r"\s+", " ", text)


@pytest.mark.parametrize("cause", Cause, ids=lambda cause: cause.name)
def test_a_cause_has_the_reaction_of_the_table(cause: Cause) -> None:
    lines = (ROOT / "docs" / "safety.md").read_text().splitlines()
    row = next(line for line in lines if line.startswith(f"| {cause.name} |"))
    assert cause.reaction in row.split("|")[3]
