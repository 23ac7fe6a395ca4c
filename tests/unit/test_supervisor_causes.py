"""Every cause of docs/safety.md, in every state in which it can be found."""

import itertools
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
import supervised
from safety_table import STATES, Row, constants, rows
from supervised import CABLES, FAILED, STOP, Failure, Machine, Moments, Observation, Power, State

NUMBERS = constants(supervised.STOCK)
TABLE = {row.cause: row for row in rows()}
Spoil = Callable[[Observation], None]
RAIL_TORQUE = NUMBERS["TB_RAIL_TORQUE_LIMIT"]
CULPRIT = 1
"""The cable, drive or bus that is spoiled."""


def drive(**values: float) -> Spoil:
    """One drive reports this."""

    def spoil(seen: Observation) -> None:
        for name, value in values.items():
            setattr(seen.drives[CULPRIT], name, value)

    return spoil


def bus(**values: int) -> Spoil:
    """One bus reports this."""

    def spoil(seen: Observation) -> None:
        for name, value in values.items():
            setattr(seen.buses[CULPRIT], name, value)

    return spoil


def loop(**values: int) -> Spoil:
    """The cycle itself."""

    def spoil(seen: Observation) -> None:
        for name, value in values.items():
            setattr(seen, name, value)

    return spoil


def jump(distance: float) -> Spoil:
    """An encoder is elsewhere."""

    def spoil(seen: Observation) -> None:
        seen.drives[CULPRIT].position += distance

    return spoil


SYMPTOMS: dict[str, list[Spoil]] = {
    "REQUESTED": [loop(requests=STOP)],
    "STRANGER": [bus(stranger=17)],
    "DRIVE_LOCAL": [drive(silent=2)],
    "OTHER_MASTER": [bus(stranger=0x81), bus(stranger=0x80)],
    "DRIVE_SILENT": [
        drive(silent=1),
        drive(missed=3, fresh=0),
        drive(silent=2, missed=3, fresh=0),
    ],
    "DRIVE_LATE": [drive(late=3)],
    "DRIVE_FAULT": [
        drive(power=Power.FAULT),
        drive(power=Power.FAULT_REACTION),
        drive(error_class=2, error_code=0x2310),
        drive(error_class=3, error_code=0x8130),
    ],
    "DRIVE_STATE": [drive(power=Power.UNKNOWN), drive(power=Power.QUICK_STOP)],
    "BUS_OFF": [bus(state=3), bus(state=4)],
    "BUS_FULL": [bus(refused=1)],
    "BUS_CORRUPT": [bus(malformed=1)],
    "CYCLES_MISSED": [loop(missed=3)],
    "ENCODER_JUMP": [jump(0.1), jump(-0.02), jump(np.nan), jump(np.inf)],
}
#: Phases in which a symptom means something else.
EXCEPTIONS = {
    ("DRIVE_FAULT", "CONFIGURE FAULT_RESET"),
    ("DRIVE_STATE", "CONFIGURE FAULT_RESET"),
    ("DRIVE_STATE", "SOFT_STOP POWER_OFF"),
    ("DRIVE_STATE", "HOME CABLE_POWER"),
}
BEFORE_MESSAGES = ("CONFIGURE CONTRACT", "CONFIGURE START")
"""No drive has answered a SYNC yet."""
ELSEWHERE = {
    "DRIVE_MISSING",
    "DRIVE_DIFFERENT",
    "DRIVE_SETUP",
    "DRIVE_TWICE",
    "DRIVE_STUCK",
    "DRIVE_DEAF",
    "HOMING",
    "MEMORY",
    "CALIBRATION",
    "CABLE_SLACK",
    "CABLE_BREAK",
    "RUNAWAY",
    "CLOSURE",
    "BASE_LOST",
    "CONTROLLER",
    "BASE_RUNAWAY",
    "BASE_BLOCKED",
    "WRONG_WAY",
    "ANSWERS_INCOMPLETE",
}
"""Tested one by one, here or in test_supervisor.py."""


@pytest.fixture
def moments() -> tuple[Machine, Moments]:
    return supervised.moments("torque")


def applies(row: Row, moment: str) -> bool:
    """Whether a cause can be found at a moment."""
    if moment.split()[0] not in row.states or (row.cause, moment) in EXCEPTIONS:
        return False
    judged = row.cause.startswith("DRIVE_") and row.cause not in ELSEWHERE
    needs_messages = judged or row.cause == "ENCODER_JUMP"
    return not (needs_messages and moment in BEFORE_MESSAGES)


def reaction(row: Row, state: str) -> str:
    """State that a cause leads to."""
    if state in ("INIT", "IDENTIFY", "CONFIGURE"):
        return "FAULT"
    return "HARD_STOP" if row.hard else "SOFT_STOP"


def culprit(row: Row) -> int:
    """Who is to blame."""
    return CULPRIT if row.culprit else 0


def cases() -> Iterator[tuple[str, Spoil]]:
    for cause, spoils in SYMPTOMS.items():
        for spoil in spoils:
            yield cause, spoil


def test_every_cause_of_the_runtime_is_in_the_table_once() -> None:
    assert [row.cause for row in rows()] == [c.name for c in supervised.Cause if c.name != "NONE"]
    assert set(TABLE) == set(SYMPTOMS) | ELSEWHERE


def tried(machine: Machine, row: Row, spoil: Spoil, moment: str) -> list[str]:
    """What a symptom leads to that the document does not say."""
    state = moment.split()[0]
    expected = (reaction(row, state), row.cause, culprit(row))
    if machine.orders.state == State.SOFT_STOP and row.cause == "REQUESTED":
        return []
    for _ in range(row.cycles(NUMBERS) + 1):
        orders = machine.step(spoil)
    told = State(orders.state).name, supervised.Cause(orders.cause).name, orders.culprit
    return [] if told == expected else [f"{moment}: {told}, not {expected}"]


@pytest.mark.parametrize(("cause", "spoil"), [*cases()])
def test_a_cause_leads_to_its_reaction_in_time_in_every_state(
    moments: tuple[Machine, Moments], cause: str, spoil: Spoil
) -> None:
    machine, saved = moments
    row, wrong, states = TABLE[cause], [], set()
    for moment in saved:
        if applies(row, moment):
            machine.restore(saved[moment])
            wrong += tried(machine, row, spoil, moment)
            states.add(moment.split()[0])
    assert wrong == []
    assert states == set(row.states)


def test_a_jump_needs_no_detail(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    machine.restore(saved["RUN NONE"])
    machine.step(jump(0.1))
    assert (machine.orders.cause, machine.orders.detail) == (supervised.Cause.ENCODER_JUMP, 0)


def test_nothing_changes_a_fault(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    for _, spoil in cases():
        machine.restore(saved["FAULT NONE"])
        before = bytes(machine.orders)
        machine.step(spoil)
        assert bytes(machine.orders)[-24:] == before[-24:]


def test_nothing_keeps_a_hard_stop_from_its_end(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    for _, spoil in cases():
        machine.restore(saved["HARD_STOP SLACKEN"])
        machine.run(20, spoil=spoil)
        assert machine.orders.state in (State.FAULT, State.HARD_STOP)
        assert supervised.Cause(machine.orders.cause).name == "DRIVE_FAULT"


def test_a_warning_of_a_drive_stops_nothing(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    machine.restore(saved["RUN NONE"])
    machine.run(50, spoil=drive(error_class=1, error_code=0xFF01))
    assert machine.orders.state == State.RUN


def test_a_malformed_frame_now_and_then_stops_nothing(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    machine.restore(saved["RUN NONE"])
    for _ in range(50):
        machine.step(bus(malformed=3))
        machine.run(2, spoil=bus(malformed=0))
    assert machine.orders.state == State.RUN


def ended(machine: Machine, spoil: Spoil, cycles: int) -> tuple[str, str, int]:
    """State, cause and culprit when something was found."""
    machine.seen.requests = 0
    start = machine.orders.state
    orders = machine.run(cycles, lambda orders: orders.state != start, spoil)
    return State(orders.state).name, supervised.Cause(orders.cause).name, orders.culprit


@pytest.mark.parametrize(
    "moment", ["HOME SWEEP", "TENSION APPROACH", "RUN NONE", "SOFT_STOP RELAX"]
)
def test_a_cable_that_speeds_up_beyond_the_limit_is_a_runaway(
    moments: tuple[Machine, Moments], moment: str
) -> None:
    machine, saved = moments
    machine.restore(saved[moment])
    wound = itertools.accumulate(itertools.chain([3e-3, 7e-3], itertools.repeat(9e-3)))

    def run_away(seen: Observation) -> None:
        seen.drives[CULPRIT].position += next(wound)

    assert ended(machine, run_away, 3) == ("HARD_STOP", "RUNAWAY", CULPRIT)


MOMENTS_OF_TORQUE = ["HOME SWEEP", "TENSION APPROACH", "RUN NONE", "SOFT_STOP RELAX"]


@pytest.mark.parametrize("moment", MOMENTS_OF_TORQUE)
@pytest.mark.parametrize(("number", "share"), [(CULPRIT, 0.2), (CULPRIT, -0.2), (CABLES + 1, 0.2)])
def test_a_drive_that_does_not_do_what_it_is_told_is_deaf(
    moments: tuple[Machine, Moments], moment: str, number: int, share: float
) -> None:
    machine, saved = moments
    limit = NUMBERS["TB_TORQUE_LIMIT" if number < CABLES else "TB_RAIL_TORQUE_LIMIT"]

    def differ(by: float) -> Spoil:
        def spoil(seen: Observation) -> None:
            seen.drives[number].torque = machine.orders.drives[number].torque + by * limit

        return spoil

    cycles = TABLE["DRIVE_DEAF"].cycles(NUMBERS)
    machine.restore(saved[moment])
    machine.run(cycles, spoil=differ(share))
    assert machine.orders.cause in (supervised.Cause.NONE, supervised.Cause.REQUESTED)
    assert ended(machine, differ(share), 1) == ("HARD_STOP", "DRIVE_DEAF", number)
    machine.restore(saved[moment])
    for _ in range(3):  # negative controls: not for long enough, not by enough
        machine.run(cycles, spoil=differ(share))
        machine.run(cycles, spoil=differ(0.4 * share))
    assert supervised.Cause(machine.orders.cause).name != "DRIVE_DEAF"


def drift(sign: float) -> Spoil:
    """A cable is wound in (1) or out (-1) without the platform, 0.5 mm a cycle up to 20 mm."""
    cycles = itertools.count(1)

    def spoil(seen: Observation) -> None:
        seen.drives[CULPRIT].position += sign * min(5e-4 * next(cycles), 0.02)

    return spoil


@pytest.mark.parametrize(("sign", "expected"), [(-1.0, "CABLE_SLACK"), (1.0, "CABLE_BREAK")])
def test_slack_and_a_break_are_told_apart_where_cables_are_not_in_line(
    moments: tuple[Machine, Moments], sign: float, expected: str
) -> None:
    machine, saved = moments
    machine.restore(saved["TENSION APPROACH"])
    state = "HARD_STOP" if TABLE[expected].hard else "SOFT_STOP"
    assert ended(machine, drift(sign), 100) == (state, expected, CULPRIT)


def test_lengths_that_disagree_are_found_in_run(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    machine.restore(saved["RUN NONE"])
    state, cause, _ = ended(machine, drift(-1.0), 100)
    assert (state, cause) in {("SOFT_STOP", "CLOSURE"), ("SOFT_STOP", "CABLE_SLACK")}
    assert any(machine.orders.slack) or machine.orders.state == State.SOFT_STOP


def test_a_hard_stop_lets_go_in_the_cycle_in_which_its_cause_is_found(
    moments: tuple[Machine, Moments],
) -> None:
    machine, saved = moments
    machine.restore(saved["RUN NONE"])

    def fault(seen: Observation) -> None:
        seen.drives[0].power = Power.FAULT

    machine.run(50)
    before = [machine.orders.drives[cable].torque for cable in range(1, CABLES)]
    machine.step(fault)
    assert machine.orders.state == State.HARD_STOP
    after = [machine.orders.drives[cable].torque for cable in range(1, CABLES)]
    wanted = [torque - NUMBERS["TB_TORQUE_STEP"] for torque in before]
    assert after == pytest.approx(np.maximum(wanted, 0.0), abs=1e-12)


def test_what_the_controller_found_is_forgotten_in_a_stop(
    moments: tuple[Machine, Moments],
) -> None:
    machine, saved = moments
    machine.restore(saved["RUN NONE"])
    told, spoil = np.zeros(CABLES, dtype=bool), drift(-1.0)
    while machine.orders.state == State.RUN:
        told |= np.array(machine.orders.slack) != 0.0
        found = any(bytes(machine.orders.controller))
        machine.step(spoil)
    assert told.all() and found
    # at once: the stop has its first cycle in that in which its cause was found
    assert not any(machine.orders.slack)
    assert not any(bytes(machine.orders.controller))


def test_lengths_that_never_agree_keep_the_machine_from_running(
    moments: tuple[Machine, Moments],
) -> None:
    machine, saved = moments
    machine.restore(saved["TENSION CLOSE"])
    limit = NUMBERS["TB_CLOSURE_LIMIT"]
    on = itertools.cycle([True] * 4 + [False] * 8)

    def disagree(seen: Observation) -> None:
        for cable in (0, 2):
            seen.drives[cable].position -= 1.5 * limit * next(on)

    state, cause, _ = ended(machine, disagree, int(NUMBERS["TB_STATE_TIMEOUT"]) + 5)
    assert (state, cause) == ("SOFT_STOP", "CLOSURE")


@pytest.mark.parametrize(
    ("moment", "cycles"), [("HOME GATHER", 2000), ("TENSION APPROACH", 2000), ("RUN NONE", 2000)]
)
def test_a_base_that_does_not_follow_is_lost(
    moments: tuple[Machine, Moments], moment: str, cycles: int
) -> None:
    machine, saved = moments
    machine.restore(saved[moment])
    steps = itertools.count()
    held = machine.rails[2]

    def creep(_: Observation) -> None:
        machine.rails[2], machine.rates[2] = held + 2e-5 * abs(next(steps) % 100 - 50), 0.0
        if moment == "RUN NONE":
            machine.handle = (machine.handle[0] + 5e-5, machine.handle[1])

    found = ended(machine, creep, cycles)
    machine.handle = (0.39, 0.21)
    assert found == ("SOFT_STOP", "BASE_LOST", CABLES + 2)


@pytest.mark.parametrize("moment", ["HOME GATHER", "TENSION APPROACH", "RUN NONE"])
def test_a_base_that_is_pushed_in_vain_is_blocked(
    moments: tuple[Machine, Moments], moment: str
) -> None:
    machine, saved = moments
    machine.restore(saved[moment])
    held = machine.rails[2]
    pushed: list[bool] = []

    def hold(_: Observation) -> None:
        machine.rails[2], machine.rates[2] = held, 0.0
        pushed.append(abs(machine.orders.drives[CABLES + 2].torque) > 0.95 * RAIL_TORQUE)
        if moment == "RUN NONE":
            machine.handle = (machine.handle[0] + 5e-5, machine.handle[1])

    found = ended(machine, hold, 2000)
    machine.handle = (0.39, 0.21)
    assert found == ("HARD_STOP", "BASE_BLOCKED", CABLES + 2)
    assert sum(pushed) == int(NUMBERS["TB_BLOCKED_CYCLES"]) + 1


def test_bases_that_follow_positions_are_judged_by_the_torque_they_tell() -> None:
    machine, saved = supervised.moments("position")
    machine.restore(saved["RUN NONE"])

    def tell(torque: float, swap: bool) -> Spoil:
        signs = itertools.cycle((1, 1, -1, -1)) if swap else itertools.repeat(1)

        def spoil(seen: Observation) -> None:
            seen.drives[CABLES + 1].torque = seen.drives[CABLES + 2].torque = torque * next(signs)

        return spoil

    machine.run(200, spoil=tell(0.94 * RAIL_TORQUE, swap=False))
    machine.run(200, spoil=tell(RAIL_TORQUE, swap=True))
    assert machine.orders.cause == 0
    found = ended(machine, tell(RAIL_TORQUE, swap=False), 100)
    assert found == ("HARD_STOP", "BASE_BLOCKED", CABLES + 1)  # the first of two


@pytest.mark.parametrize("moment", ["HOME SWEEP", "TENSION APPROACH", "RUN NONE"])
def test_a_base_that_goes_against_its_force_is_stopped_at_once(
    moments: tuple[Machine, Moments], moment: str
) -> None:
    machine, saved = moments
    machine.restore(saved[moment])
    here = machine.rails[1]

    def mirror(seen: Observation) -> None:
        seen.drives[CABLES + 1].position = 2 * here - machine.rails[1]

    found = ended(machine, mirror, 500)
    assert found == ("HARD_STOP", "WRONG_WAY", CABLES + 1)
    assert abs(machine.rates[1]) < 0.3 * NUMBERS["TB_RAIL_SPEED_LIMIT"]
    assert abs(machine.rails[1] - here) < 0.01


@pytest.mark.parametrize("moment", ["CONFIGURE READY", "HOME TIGHTEN"])
def test_a_base_that_becomes_too_fast_bit_by_bit_is_stopped(
    moments: tuple[Machine, Moments], moment: str
) -> None:
    machine, saved = moments
    machine.restore(saved[moment])
    speed = itertools.count(step=0.02)
    away = [0.0]

    def run(seen: Observation) -> None:
        away[0] += next(speed) * supervised.PERIOD
        seen.drives[CABLES + 3].position = machine.position(CABLES + 3) + away[0]

    _, cause, culprit = ended(machine, run, 300)
    assert (cause, culprit) == ("BASE_RUNAWAY", CABLES + 3)
    assert next(speed) < NUMBERS["TB_RAIL_SPEED_LIMIT"] + 0.1


def test_a_base_that_runs_away_in_its_homing_is_stopped_whatever_zero_it_counts_from(
    moments: tuple[Machine, Moments],
) -> None:
    machine, saved = moments
    machine.restore(saved["HOME BASE_HOMING"])
    zero = machine.position(CABLES + 1) + 0.4
    time = itertools.count(step=supervised.PERIOD)
    speed = [0.0]

    def run(seen: Observation) -> None:
        now = next(time)
        speed[0] = 60.0 * now
        if seen.drives[CABLES + 1].fresh:
            seen.drives[CABLES + 1].position = zero - 0.5 * 60.0 * now * now

    assert ended(machine, run, 300) == ("HARD_STOP", "BASE_RUNAWAY", CABLES + 1)
    assert speed[0] < NUMBERS["TB_RAIL_SPEED_LIMIT"] + 0.3


@pytest.mark.parametrize("position", [np.nan, np.inf, 1e7])
def test_a_base_that_is_nowhere_is_told_although_it_may_count_from_any_zero(
    moments: tuple[Machine, Moments], position: float
) -> None:
    machine, saved = moments
    machine.restore(saved["HOME TIGHTEN"])

    def lose(seen: Observation) -> None:
        seen.drives[CABLES + 1].position = position

    assert ended(machine, lose, 3) == ("HARD_STOP", "ENCODER_JUMP", CABLES + 1)


def test_bases_are_pushed_no_more_in_a_soft_stop(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    machine.restore(saved["HOME SWEEP"])
    step = NUMBERS["TB_RAIL_TORQUE_STEP"]
    machine.run(500, lambda orders: base_torques(orders).max() > step)
    before = base_torques(machine.orders)
    machine.ask(STOP)
    while machine.orders.phase != supervised.Phase.POWER_OFF:
        now = base_torques(machine.orders)
        assert np.all(now <= np.maximum(before - step, 0.0) + 1e-12)
        before = now
        machine.step()


def base_torques(orders: supervised.Orders) -> Any:
    """What every base is pushed with, either way [N m]."""
    return np.abs([order.torque for order in orders.drives[CABLES:]])


def test_a_base_that_never_arrives_ends_the_approach(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    machine.restore(saved["TENSION APPROACH"])
    turn = itertools.count()

    def shake(_: Observation) -> None:
        away = 1e-3 * (abs((next(turn) + 20) % 80 - 40) - 20)
        machine.handle = (0.39 + away, 0.21 + away)

    found = ended(machine, shake, int(NUMBERS["TB_HOMING_TIMEOUT"]) + 5)
    machine.handle = (0.39, 0.21)
    assert found == ("SOFT_STOP", "BASE_LOST", CABLES)


@pytest.mark.parametrize("moment", ["TENSION CLOSE", "RUN NONE"])
def test_a_controller_that_fails_too_often_stops_the_machine(
    moments: tuple[Machine, Moments], moment: str
) -> None:
    machine, saved = moments
    machine.restore(saved[moment])

    def no_number(seen: Observation) -> None:
        seen.hand_force[:] = [np.nan, 0.0]

    limit = int(NUMBERS["TB_FAILED_LIMIT"])
    machine.run(limit, spoil=no_number)
    assert machine.orders.cause == 0
    machine.step(no_number)
    orders = machine.orders
    assert (orders.state, supervised.Cause(orders.cause).name) == (State.SOFT_STOP, "CONTROLLER")
    assert orders.detail == 3


def test_a_failed_homing_is_told(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    for answer in (supervised.Homing.FAILED, supervised.Homing.IDLE):
        machine.restore(saved["HOME BASE_HOMING"])
        machine.run(10)

        def fail(seen: Observation, answer: int = answer) -> None:
            seen.drives[CABLES].homing = answer

        assert ended(machine, fail, 3) == ("SOFT_STOP", "HOMING", CABLES)


def blind(seen: Observation) -> None:
    """No cycle in which every drive answers."""
    seen.drives[CULPRIT].fresh = 0


def test_too_few_measurements_end_the_calibration(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    machine.restore(saved["HOME SWEEP"])
    machine.run(int(NUMBERS["TB_STATE_TIMEOUT"]), spoil=blind)
    assert machine.orders.cause == 0
    assert ended(machine, blind, 1) == ("SOFT_STOP", "ANSWERS_INCOMPLETE", CULPRIT)


def test_answers_of_a_slower_bus_need_not_come_in_one_cycle(
    moments: tuple[Machine, Moments],
) -> None:
    # The last of four base drives answers after the compute phase, in the next control cycle.
    machine, saved = moments
    machine.restore(saved["HOME SWEEP"])
    kept: dict[str, Any] = {}

    def delay(seen: Observation) -> None:
        report = seen.drives[CABLES + 3]
        if report.fresh:
            kept.update(position=report.position, power=report.power)
            report.fresh = 0
        else:
            report.fresh, report.age = 1, 1

    machine.run(20_000, lambda orders: orders.state == State.RUN, delay)
    assert np.allclose(machine.orders.controller.pose, machine.handle, atol=1e-4)


def test_lengths_that_do_not_close_end_the_calibration(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    machine.restore(saved["HOME SWEEP"])
    slip = itertools.count()

    def slide(seen: Observation) -> None:
        seen.drives[CULPRIT].position += 2e-5 * next(slip)

    assert ended(machine, slide, 5000) == ("SOFT_STOP", "CALIBRATION", 0)
    assert machine.orders.detail == 3


def test_a_symptom_that_the_document_does_not_know_is_noticed(
    moments: tuple[Machine, Moments],
) -> None:
    machine, saved = moments
    machine.restore(saved["RUN NONE"])
    wrong: Any = Row("BUS_FULL", "bus", True, tuple(STATES), "0")
    assert tried(machine, wrong, bus(refused=1), "RUN NONE") != []


def test_two_nodes_with_one_number_never_get_torque(moments: tuple[Machine, Moments]) -> None:
    machine, saved = moments
    machine.restore(saved["INIT NONE"])

    def twice(seen: Observation) -> None:
        seen.drives[CULPRIT].task = machine.orders.drives[CULPRIT].task
        seen.drives[CULPRIT].progress, seen.drives[CULPRIT].failure = FAILED, Failure.TWICE

    machine.step(twice)
    assert supervised.Cause(machine.orders.cause).name == "DRIVE_TWICE"
    assert {order.goal for order in machine.orders.drives} == {supervised.Goal.OFF}
