"""The supervisor's states: from power-on to work, and back to no torque."""

import ctypes
import itertools
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest
import supervised
from canopen_c import Canopen
from safety_table import constants
from supervised import (
    ARM,
    BUSY,
    CABLES,
    DRIVES,
    DRUM,
    FAILED,
    RESET,
    STOP,
    Cause,
    Failure,
    Goal,
    Homing,
    Machine,
    Mode,
    Moments,
    Observation,
    Phase,
    Power,
    State,
    Task,
)

NUMBERS = constants(supervised.STOCK)
STATE_TIMEOUT = int(NUMBERS["TB_STATE_TIMEOUT"])
HOMING_TIMEOUT = int(NUMBERS["TB_HOMING_TIMEOUT"])
TIMED_OUT = STATE_TIMEOUT + 1
"""Cycles in a phase after which a wait is over."""
POWERED = 7
"""Cycles until an ideal base drive is under power."""
HEARTBEAT_TIMEOUT = int(NUMBERS["TB_HEARTBEAT_TIMEOUT"])
STOP_CYCLES = int(NUMBERS["TB_STOP_CYCLES"])
CLOSED_CYCLES = 100
"""In a row, before RUN."""
TIGHT = DRUM * NUMBERS["TB_TENSION_MIN"]
BASES = range(CABLES, DRIVES)


At = Callable[[str], Machine]


@pytest.fixture(params=supervised.LIBRARIES)
def moments(request: pytest.FixtureRequest) -> tuple[Machine, Moments]:
    """A machine, and what it was in every state and phase of a bring-up."""
    return supervised.moments(request.param)


def restored(machine: Machine, saved: Moments, moment: str) -> Machine:
    """The machine as it was in a state and phase."""
    machine.restore(saved[moment])
    return machine


@pytest.fixture
def at(moments: tuple[Machine, Moments]) -> At:
    """Puts the machine in a state and phase."""
    return partial(restored, *moments)


@pytest.fixture
def stock_at() -> At:
    """The same, where it does not matter what the base drives follow."""
    return partial(restored, *supervised.moments("torque"))


def torques(machine: Machine) -> np.ndarray:
    """Torques ordered of the cables [N m]."""
    return np.array([machine.orders.drives[i].torque for i in range(CABLES)])


def goals(machine: Machine) -> set[int]:
    """Power states ordered."""
    return {order.goal for order in machine.orders.drives}


def told(machine: Machine) -> tuple[str, str]:
    """State and cause."""
    return State(machine.orders.state).name, Cause(machine.orders.cause).name


def test_a_bring_up_passes_every_state_and_phase_in_order(
    moments: tuple[Machine, Moments],
) -> None:
    passed = [moment for moment in moments[1] if not moment.startswith(("FAULT", "HARD_STOP"))]
    once = ["INIT NONE", "IDENTIFY NONE", "CONFIGURE CONTRACT", "CONFIGURE START"]
    once += ["CONFIGURE FAULT_RESET", "CONFIGURE READY"]
    once += [f"HOME {name}" for name in ("CABLE_MODE", "CABLE_POWER", "TIGHTEN")]
    once += ["HOME TRY_CABLES"]
    if "HOME TRY_BASES" in passed:  # bases that follow positions are not pushed
        once += [f"HOME TRY_{name}" for name in ("MODE", "POWER", "BASES", "RELEASE")]
    bases = ("MODE", "POWER", "HOMING", "RELEASE", "WORK_MODE", "WORK_POWER")
    once += [f"HOME BASE_{name}" for name in bases]
    once += ["HOME GATHER", "HOME SWEEP", "HOME SOLVE", "TENSION APPROACH", "TENSION CLOSE"]
    once += ["RUN NONE", "SOFT_STOP RELAX", "SOFT_STOP SLACKEN", "SOFT_STOP POWER_OFF"]
    assert passed == once


def test_the_pose_is_known_after_the_bring_up(at: At) -> None:
    machine = at("RUN NONE")
    assert np.allclose(machine.orders.controller.pose, machine.handle, atol=1e-6)


def test_bases_sweep_in_rhythms_of_their_own_so_that_poses_differ(at: At) -> None:
    machine = at("HOME SWEEP")
    middles = [0.3559, 0.2309, 0.3559, 0.2309]
    sides: list[list[bool]] = [[] for _ in middles]
    while machine.step().phase == Phase.SWEEP:
        for rail, middle in enumerate(middles):
            sides[rail].append(machine.rails[rail] > middle)
    crossings = [sum(a != b for a, b in itertools.pairwise(side)) for side in sides]
    assert crossings == [2, 4, 6, 2]


def test_bases_follow_the_handle_in_run(at: At) -> None:
    machine = at("RUN NONE")
    for _ in range(1000):
        machine.handle = (machine.handle[0] + 5e-5, machine.handle[1])
        machine.step()
    assert machine.orders.state == State.RUN
    assert abs(machine.rails[0] - machine.handle[0]) < 5e-3
    machine.handle = (0.39, 0.21)


def test_no_base_is_led_faster_than_a_tenth_of_its_limit_before_run(
    at: At,
) -> None:
    machine = at("TENSION APPROACH")
    fastest = 0.0
    while machine.orders.state != State.RUN:
        before = [*machine.rails]
        machine.run(2)  # a SYNC of their bus
        moved = (abs(a - b) for a, b in zip(machine.rails, before, strict=True))
        fastest = max(fastest, *moved)
    assert fastest / (2 * supervised.PERIOD) < 0.15 * NUMBERS["TB_RAIL_SPEED_LIMIT"]


def test_each_cable_in_turn_pulls_a_fifth_of_its_range_more_in_the_sweep(at: At) -> None:
    machine = at("HOME SWEEP")
    strongest = np.zeros(CABLES)
    while machine.orders.phase == Phase.SWEEP:
        strongest = np.maximum(strongest, torques(machine))
        assert sum(torques(machine) > 1.001 * TIGHT) <= 1
        machine.step()
    extra = 0.2 * DRUM * (NUMBERS["TB_TENSION_MAX"] - NUMBERS["TB_TENSION_MIN"])
    assert strongest == pytest.approx(np.full(CABLES, TIGHT + extra), rel=1e-3)


def test_a_request_that_stood_before_does_not_arm(at: At) -> None:
    machine = at("CONFIGURE CONTRACT")
    machine.seen.requests = ARM
    machine.until(State.CONFIGURE, Phase.READY)
    machine.run(200)
    assert told(machine) == ("CONFIGURE", "NONE")
    machine.seen.requests = 0
    machine.step()
    assert machine.ask(ARM).state == State.HOME


def test_nothing_arms_while_a_stop_is_asked_for(at: At) -> None:
    machine = at("CONFIGURE READY")
    machine.run(10)
    assert machine.ask(ARM | STOP).state == State.CONFIGURE


def test_drives_in_fault_at_power_on_are_reset(at: At) -> None:
    machine = at("CONFIGURE CONTRACT")
    machine.drives[6].power, machine.drives[6].error_code = Power.FAULT, 0x2310
    machine.until(State.CONFIGURE, Phase.READY)
    assert machine.drives[6].power == Power.OFF


def test_a_drive_in_fault_is_reset_though_another_one_comes_into_service_after_it(at: At) -> None:
    machine = at("CONFIGURE START")
    machine.drives[1].power, machine.drives[1].error_code = Power.FAULT, 0x2310
    cycles = itertools.count()

    def come_late(seen: Observation) -> None:
        if next(cycles) < 20:
            seen.drives[6].fresh = 0

    machine.run(100, lambda orders: orders.phase != Phase.START, come_late)
    assert next(cycles) > 20
    machine.until(State.CONFIGURE, Phase.READY)
    assert machine.drives[1].power == Power.OFF


@pytest.mark.parametrize("moment", ["HOME TIGHTEN", "HOME SWEEP", "TENSION CLOSE", "RUN NONE"])
def test_a_stop_that_was_asked_for_ends_ready_to_arm(at: At, moment: str) -> None:
    machine = at(moment)
    assert told_after(machine.ask(STOP)) == ("SOFT_STOP", "REQUESTED")
    machine.until(State.CONFIGURE, Phase.READY, STOP_CYCLES + 20)
    assert told(machine) == ("CONFIGURE", "REQUESTED")
    machine.run(20)
    machine.ask(ARM)
    assert told(machine) == ("HOME", "NONE")
    machine.until(State.RUN)


def told_after(orders: supervised.Orders) -> tuple[str, str]:
    """State and cause of some orders."""
    return State(orders.state).name, Cause(orders.cause).name


def test_only_a_reset_that_appears_leads_out_of_a_fault(at: At) -> None:
    machine = at("FAULT NONE")
    machine.seen.requests = ARM | STOP
    machine.run(50)
    assert machine.orders.state == State.FAULT
    assert machine.ask(RESET).state == State.INIT
    assert {order.task for order in machine.orders.drives} == {Task.RESET}
    assert machine.orders.cause == Cause.NONE
    machine.arm()
    machine.until(State.RUN)


def test_a_reset_that_stood_before_the_fault_does_nothing(at: At) -> None:
    machine = at("RUN NONE")
    machine.seen.requests = RESET

    def fault(seen: Observation) -> None:
        seen.drives[1].power = Power.FAULT

    machine.run(50, spoil=fault)
    assert told(machine) == ("FAULT", "DRIVE_FAULT")


def test_in_a_soft_stop_all_cables_go_down_together(at: At) -> None:
    machine = at("RUN NONE")
    machine.seen.force[:] = [6.0, -2.0]
    machine.run(50)
    before = torques(machine)
    assert np.ptp(before) > 0.01
    machine.ask(STOP)
    half = STOP_CYCLES // 2
    for cycle in range(2, half + 1):
        machine.step()
        expected = before + (np.minimum(before, TIGHT) - before) * cycle / half
        assert np.allclose(torques(machine), expected, atol=1e-12)
    for cycle in range(1, half + 1):
        machine.step()
        assert np.allclose(torques(machine), np.minimum(before, TIGHT) * (1 - cycle / half))
    assert goals(machine) == {Goal.OFF}


def test_in_a_hard_stop_no_cable_pulls_after_as_many_steps_as_the_limit_has(
    at: At,
) -> None:
    machine = at("RUN NONE")
    machine.seen.force[:] = [6.0, -2.0]
    machine.run(50)
    most = int(np.ceil(NUMBERS["TB_TORQUE_LIMIT"] / NUMBERS["TB_TORQUE_STEP"]))

    def fault(seen: Observation) -> None:
        seen.drives[0].silent = 1

    machine.step(fault)
    assert told(machine) == ("HARD_STOP", "DRIVE_SILENT")
    assert {machine.orders.drives[i].goal for i in BASES} == {Goal.OFF}
    machine.run(most - 1, spoil=fault)
    assert np.all(torques(machine) == 0.0)
    machine.step(fault)
    assert goals(machine) == {Goal.OFF}


def test_a_cable_without_power_gets_no_torque_at_all(at: At) -> None:
    machine = at("RUN NONE")

    def fault(seen: Observation) -> None:
        seen.drives[2].power = Power.OFF

    machine.step(fault)
    assert told(machine) == ("HARD_STOP", "DRIVE_STATE")
    assert machine.orders.drives[2].torque == 0.0


def test_the_first_cause_stands(at: At) -> None:
    machine = at("RUN NONE")

    def late(seen: Observation) -> None:
        seen.drives[3].late = 9

    def broken(seen: Observation) -> None:
        seen.drives[1].power = Power.FAULT

    machine.step(late)
    assert told(machine) == ("SOFT_STOP", "DRIVE_LATE")
    machine.step(broken)
    assert told(machine) == ("HARD_STOP", "DRIVE_LATE")
    machine.run(20, spoil=broken)
    assert told(machine) == ("FAULT", "DRIVE_LATE")
    assert (machine.orders.culprit, machine.orders.detail) == (3, 9)


def test_a_fault_takes_the_place_of_a_request_as_the_cause(at: At) -> None:
    machine = at("SOFT_STOP RELAX")
    assert machine.orders.cause == Cause.REQUESTED

    def late(seen: Observation) -> None:
        seen.buses[2].refused = 4

    machine.step(late)
    assert told(machine) == ("SOFT_STOP", "BUS_FULL")
    machine.until(State.FAULT)
    assert (machine.orders.culprit, machine.orders.detail) == (2, 4)


def test_a_stop_during_homing_switches_the_homing_base_off_at_once(
    at: At,
) -> None:
    machine = at("HOME BASE_HOMING")
    machine.ask(STOP)
    assert {machine.orders.drives[i].goal for i in BASES} == {Goal.OFF}
    assert {order.home for order in machine.orders.drives} == {0}
    assert np.all(torques(machine) > 0.9 * TIGHT)
    machine.until(State.CONFIGURE)


def test_an_answer_before_homing_ran_is_that_of_the_last_homing(
    at: At,
) -> None:
    machine = at("HOME BASE_POWER")

    def done(seen: Observation) -> None:
        seen.drives[CABLES].homing = Homing.DONE

    machine.run(100, spoil=done)
    assert machine.orders.phase == Phase.BASE_HOMING


def stuck(**values: int) -> Callable[[Observation], None]:
    """Every drive reports this, whatever it is ordered."""

    def spoil(seen: Observation) -> None:
        for report in seen.drives:
            for name, value in values.items():
                setattr(report, name, value)

    return spoil


def one_drive(index: int, **values: int) -> Callable[[Observation], None]:
    """One drive reports this, whatever it is ordered."""

    def spoil(seen: Observation) -> None:
        for name, value in values.items():
            setattr(seen.drives[index], name, value)

    return spoil


#: Of a base drive: 5 and 39 objects, each written and read; two requests repeated; two restarts.
LONGEST_TASK = (2 * 44 + 2) * 2 * int(NUMBERS["TB_ANSWER_TIMEOUT"]) + 3 * STATE_TIMEOUT
first_base, last_base = partial(one_drive, CABLES), partial(one_drive, DRIVES - 1)
WAITS: list[tuple[str, Callable[[Observation], None], str, int, int]] = [
    # where, what the drives say for ever, the cause, its culprit, cycles until it is told
    ("CONFIGURE START", last_base(silent=2), "DRIVE_LOCAL", DRIVES - 1, TIMED_OUT),
    ("CONFIGURE START", stuck(fresh=0), "DRIVE_SILENT", 0, TIMED_OUT),
    ("CONFIGURE START", stuck(silent=1), "DRIVE_SILENT", 0, TIMED_OUT),
    ("CONFIGURE START", last_base(fresh=0), "DRIVE_SILENT", DRIVES - 1, TIMED_OUT),
    ("CONFIGURE FAULT_RESET", stuck(power=Power.FAULT), "DRIVE_FAULT", 0, TIMED_OUT),
    ("CONFIGURE FAULT_RESET", first_base(power=Power.ON), "DRIVE_STUCK", 4, TIMED_OUT),
    ("CONFIGURE FAULT_RESET", first_base(error_class=2), "DRIVE_FAULT", 4, TIMED_OUT),
    ("HOME CABLE_MODE", stuck(progress=1), "DRIVE_STUCK", 0, TIMED_OUT),
    ("HOME CABLE_MODE", stuck(mode=Mode.POSITION), "DRIVE_STUCK", 0, TIMED_OUT),
    ("HOME CABLE_POWER", stuck(power=Power.OFF), "DRIVE_STUCK", 0, TIMED_OUT),
    ("HOME BASE_MODE", first_base(progress=1), "DRIVE_STUCK", 4, TIMED_OUT),
    ("HOME BASE_POWER", first_base(power=Power.READY), "DRIVE_STUCK", 4, TIMED_OUT),
    ("HOME BASE_WORK_MODE", first_base(progress=1), "DRIVE_STUCK", 4, TIMED_OUT),
    ("HOME BASE_WORK_POWER", first_base(power=Power.READY), "DRIVE_STUCK", 4, TIMED_OUT),
    ("HOME BASE_RELEASE", first_base(power=Power.ENABLED), "DRIVE_STUCK", 4, TIMED_OUT),
    ("HOME BASE_POWER", first_base(homing=0), "HOMING", 4, POWERED + HOMING_TIMEOUT + 1),
    ("HOME BASE_MODE", last_base(progress=1), "DRIVE_STUCK", DRIVES - 1, TIMED_OUT),
]


@pytest.mark.parametrize(("moment", "spoil", "cause", "culprit", "cycles"), WAITS)
def test_no_wait_is_without_an_end(
    stock_at: At,
    moment: str,
    spoil: Callable[[Observation], None],
    cause: str,
    culprit: int,
    cycles: int,
) -> None:
    machine = stock_at(moment)
    machine.run(cycles - 1, spoil=spoil)
    assert machine.orders.cause == Cause.NONE
    machine.step(spoil)
    assert Cause(machine.orders.cause).name == cause
    assert machine.orders.culprit == culprit


def test_a_soft_stop_waits_for_its_last_drive_to_switch_off_and_no_longer(stock_at: At) -> None:
    machine, on = stock_at("SOFT_STOP POWER_OFF"), last_base(power=Power.ENABLED)
    machine.run(HEARTBEAT_TIMEOUT, spoil=on)
    assert machine.orders.state == State.SOFT_STOP
    machine.step(on)
    assert machine.orders.state == State.FAULT


TASKS = [
    ("INIT NONE", last_base(task=0), DRIVES - 1),
    ("CONFIGURE CONTRACT", first_base(progress=1), 4),
    ("CONFIGURE START", first_base(task=0), 4),
]


@pytest.mark.parametrize(("moment", "spoil", "culprit"), TASKS)
def test_a_task_that_never_ends_is_given_up_when_its_last_answer_would_have_been_late(
    stock_at: At, moment: str, spoil: Callable[[Observation], None], culprit: int
) -> None:
    machine = stock_at(moment)
    machine.run(LONGEST_TASK + 20, lambda orders: orders.cause != Cause.NONE, spoil)
    assert Cause(machine.orders.cause).name == "DRIVE_MISSING"
    assert machine.orders.culprit == culprit


@pytest.mark.parametrize(
    ("phase", "drives", "divider"),
    [("CABLE_POWER", range(CABLES), 1), ("BASE_POWER", BASES, 2)],
)
def test_a_power_state_counts_once_the_order_can_show(
    stock_at: At, phase: str, drives: range, divider: int
) -> None:
    # It acts at the next SYNC of the bus, and shows in the answer to the one after it.
    machine = stock_at(f"HOME {phase}")

    def enabled(seen: Observation) -> None:
        for index in drives:
            seen.drives[index].power = Power.ENABLED

    machine.run(3 * divider - 1, spoil=enabled)
    assert machine.orders.phase == Phase[phase]
    machine.step(enabled)
    assert told(machine) == ("HOME", "NONE")
    assert machine.orders.phase != Phase[phase]


def test_a_drive_that_stays_on_after_a_requested_stop_is_a_fault(
    at: At,
) -> None:
    machine = at("SOFT_STOP POWER_OFF")

    def on(seen: Observation) -> None:
        seen.drives[7].power = Power.ENABLED

    machine.run(STATE_TIMEOUT + 10, lambda orders: orders.state == State.FAULT, on)
    assert told(machine) == ("FAULT", "DRIVE_STUCK")
    assert machine.orders.culprit == 7


def test_a_drive_that_gets_power_while_ready_is_a_fault(at: At) -> None:
    machine = at("CONFIGURE READY")
    machine.run(10)

    def on(seen: Observation) -> None:
        seen.drives[7].power = Power.ENABLED

    machine.step(on)
    assert told(machine) == ("FAULT", "DRIVE_STATE")


def test_a_drive_that_does_not_switch_off_before_arming_is_a_fault(
    at: At,
) -> None:
    machine = at("CONFIGURE FAULT_RESET")
    machine.until(State.CONFIGURE, Phase.READY)

    def on(seen: Observation) -> None:
        seen.drives[7].power = Power.ON

    machine.run(STATE_TIMEOUT + 5, lambda orders: orders.state == State.FAULT, on)
    assert told(machine) == ("FAULT", "DRIVE_STUCK")


def test_a_hard_stop_ends_even_if_a_drive_never_tells_that_it_is_off(
    at: At,
) -> None:
    machine = at("HARD_STOP POWER_OFF")
    machine.run(
        STATE_TIMEOUT + 10, lambda orders: orders.state == State.FAULT, stuck(power=Power.ENABLED)
    )
    assert goals(machine) == {Goal.OFF}


@pytest.mark.parametrize("moment", ["SOFT_STOP POWER_OFF", "HARD_STOP POWER_OFF"])
def test_a_drive_that_does_not_switch_off_is_left_without_heartbeat(moment: str, at: At) -> None:
    machine = at(moment)
    beats: list[int] = []

    def over(orders: Any) -> bool:
        beats.append(orders.beat)
        return bool(orders.state == State.FAULT)

    machine.run(HEARTBEAT_TIMEOUT + 5, over, stuck(power=Power.ENABLED))
    assert machine.orders.state == State.FAULT
    assert machine.step(stuck(power=Power.ENABLED)).beat == 0
    assert sum(beats[8:-1]) == (len(beats) - 9 if moment.startswith("SOFT") else 0)
    assert machine.run(2).beat == 1  # it is off, and has said so at its bus's next SYNC


@pytest.mark.parametrize("moment", ["SOFT_STOP POWER_OFF", "HARD_STOP POWER_OFF"])
def test_drives_that_switch_off_lose_no_heartbeat_for_long(moment: str, at: At) -> None:
    machine = at(moment)
    without = [not machine.step().beat for _ in range(50)]
    assert sum(without) < 10 and machine.orders.beat == 1


FAILURES = [
    ("INIT NONE", Failure.SILENT, "DRIVE_MISSING"),
    ("INIT NONE", Failure.TWICE, "DRIVE_TWICE"),
    ("IDENTIFY NONE", Failure.SILENT, "DRIVE_MISSING"),
    ("IDENTIFY NONE", Failure.ABORT, "DRIVE_DIFFERENT"),
    ("IDENTIFY NONE", Failure.DIFFERENT, "DRIVE_DIFFERENT"),
    ("IDENTIFY NONE", Failure.TWICE, "DRIVE_TWICE"),
    ("CONFIGURE CONTRACT", Failure.ABORT, "DRIVE_SETUP"),
    ("CONFIGURE CONTRACT", Failure.TWICE, "DRIVE_TWICE"),
    ("INIT NONE", Failure.RESTARTED, "DRIVE_MISSING"),
    ("IDENTIFY NONE", Failure.SIZE, "DRIVE_DIFFERENT"),
    ("CONFIGURE CONTRACT", Failure.RESTARTED, "DRIVE_SETUP"),
    ("CONFIGURE START", Failure.RESTARTED, "DRIVE_SETUP"),
    ("CONFIGURE START", Failure.SILENT, "DRIVE_SETUP"),
    ("HOME CABLE_MODE", Failure.ABORT, "DRIVE_SETUP"),
    ("HOME BASE_MODE", Failure.DIFFERENT, "DRIVE_SETUP"),
    ("HOME BASE_WORK_MODE", Failure.ABORT, "DRIVE_SETUP"),
]


def spoiled(bus: int, malformed: int) -> Callable[[Observation], None]:
    """Something malformed on a bus, or nothing, while the drives' tasks go on."""

    def spoil(seen: Observation) -> None:
        stuck(progress=BUSY)(seen)
        seen.buses[bus].malformed = malformed

    return spoil


def unheard(machine: Machine, index: int) -> Callable[[Observation], None]:
    """A drive's task has failed for want of an answer."""

    def fail(seen: Observation) -> None:
        report = seen.drives[index]
        report.task, report.progress = machine.orders.drives[index].task, FAILED
        report.failure = Failure.SILENT

    return fail


@pytest.mark.parametrize("moment", ["INIT NONE", "IDENTIFY NONE"])
@pytest.mark.parametrize(("bus", "blamed"), [(2, ("BUS_CORRUPT", 2)), (1, ("DRIVE_MISSING", 4))])
def test_a_bus_that_delivered_malformed_frames_is_blamed_for_a_drive_that_was_not_heard(
    stock_at: At, moment: str, bus: int, blamed: tuple[str, int]
) -> None:
    machine = stock_at(moment)
    machine.step(spoiled(bus, 1))
    machine.run(50, spoil=spoiled(bus, 0))
    assert machine.orders.cause == Cause.NONE
    machine.step(unheard(machine, CABLES))
    assert (Cause(machine.orders.cause).name, machine.orders.culprit) == blamed
    assert machine.orders.detail == (blamed[0] == "BUS_CORRUPT")


def test_a_malformed_frame_of_an_earlier_state_is_not_held_against_the_bus(stock_at: At) -> None:
    machine = stock_at("INIT NONE")
    machine.step(spoiled(2, 1))
    machine.step(spoiled(2, 0))
    machine.run(500, lambda orders: orders.state == State.IDENTIFY)
    machine.step(unheard(machine, CABLES))
    assert Cause(machine.orders.cause).name == "DRIVE_MISSING"


def test_a_bus_that_takes_no_frames_in_init_is_not_excused_from_malformed_ones(
    stock_at: At,
) -> None:
    machine = stock_at("INIT NONE")

    def spoil(seen: Observation) -> None:
        seen.buses[1].refused = seen.buses[1].malformed = 1

    machine.run(int(NUMBERS["TB_MISSED_LIMIT"]) + 1, spoil=spoil)
    assert Cause(machine.orders.cause).name == "BUS_CORRUPT"


@pytest.mark.parametrize(("moment", "failure", "cause"), FAILURES)
def test_a_failed_task_is_told_with_its_object(
    stock_at: At, moment: str, failure: int, cause: str
) -> None:
    machine = stock_at(moment)
    cables = moment == "HOME CABLE_MODE"
    index = 2 if cables else 4

    def fail(seen: Observation) -> None:
        report = seen.drives[index]
        report.task, report.progress = machine.orders.drives[index].task, FAILED
        report.failure, report.index, report.subindex, report.detail = failure, 0x6076, 1, 99

    machine.step(fail)
    orders = machine.orders
    state = "SOFT_STOP" if moment.startswith("HOME") else "FAULT"
    assert told(machine) == (state, cause)
    assert (orders.culprit, orders.index, orders.subindex) == (index, 0x6076, 1)
    assert (orders.failure, orders.detail) == (failure, 99)


def damage(machine: Machine, place: int, value: int) -> None:
    """Overwrite a byte, or the eight from there."""
    offset = machine.library.shim_size(place)
    size = 8 if place in (4, 6) else 1
    data = bytes([value] * size)
    ctypes.memmove(ctypes.addressof(machine.memory) + offset, data, size)


@pytest.mark.parametrize(
    ("moment", "place"),
    [*itertools.product(["CONFIGURE READY", "HOME SWEEP", "RUN NONE", "FAULT NONE"], range(3, 7))],
)
def test_damaged_memory_takes_torque_and_heartbeat_away(
    stock_at: At, moment: str, place: int
) -> None:
    machine = stock_at(moment)
    first = machine.orders.cause
    damage(machine, place, 0x7F)
    orders = machine.step()
    assert orders.beat == 0
    assert orders.state == State.HARD_STOP
    machine.run(10, lambda orders: orders.state == State.FAULT)
    assert machine.orders.cause == (first or Cause.MEMORY)
    assert machine.orders.beat == 0
    machine.step()
    assert machine.ask(RESET).beat == 1


def test_a_state_that_is_none_is_damage_too(at: At) -> None:
    machine = at("RUN NONE")
    damage(machine, 5, 0x7F)
    damage(machine, 3, 0x80)
    assert machine.step().beat == 0


def test_a_force_sensor_that_is_silent_is_not_read(at: At) -> None:
    machine = at("RUN NONE")
    machine.seen.hand_force_fresh = 0
    machine.seen.hand_force[:] = [np.nan, np.inf]
    machine.run(100)
    assert machine.orders.state == State.RUN
    assert machine.orders.controller.status == 0


def memory_of(machine: Machine) -> Any:
    """tb_supervisor, as its C declares it."""
    found = Canopen(supervised.sources(supervised.STOCK)).new("tb_supervisor")
    ctypes.memmove(ctypes.byref(found), machine.memory.raw, ctypes.sizeof(found))
    return found


def test_the_controller_begins_with_what_drives_and_bases_were_ordered(at: At) -> None:
    machine = at("HOME SOLVE")
    for phase in (Phase.APPROACH, Phase.CLOSE):
        while machine.orders.phase != phase:
            before = torques(machine).tolist()
            machine.step()
        memory = memory_of(machine)
        assert [*memory.controller.torque] == before
        assert [*memory.controller.base] == [*memory.guide.base]


def test_lengths_must_agree_for_so_many_cycles_in_a_row(at: At) -> None:
    machine = at("TENSION CLOSE")

    def fails(seen: Observation) -> None:
        seen.hand_force_fresh, seen.hand_force[0] = 1, np.nan

    machine.run(20)
    machine.step(fails)
    machine.seen.hand_force[0] = 0.0
    for _ in range(CLOSED_CYCLES - 1):
        assert machine.step().state == State.TENSION
    assert machine.step().state == State.RUN


def test_drives_are_ordered_what_the_controller_computed(at: At) -> None:
    machine = at("RUN NONE")
    machine.seen.force[:] = [0.5, -0.5]
    for _ in range(50):
        machine.step()
        assert torques(machine).tolist() == [*machine.orders.controller.motor_torque]


def test_a_disturbance_is_compensated_only_with_a_fresh_force_sensor(at: At) -> None:
    for fresh, least, most in ((0, 0.0, 1e-12), (1, 1e-3, 1e-2)):
        machine = at("RUN NONE")
        machine.seen.hand_force_fresh = fresh
        machine.seen.hand_force[:] = [1.0, 0.5]
        machine.run(300)
        added = torques(machine) - DRUM * np.array(machine.orders.controller.tension)
        assert least <= np.abs(added).max() <= most


def test_the_force_of_the_application_is_served_in_run_only(at: At) -> None:
    for moment, served in (("TENSION CLOSE", 0.0), ("RUN NONE", 2.0)):
        machine = at(moment)
        machine.seen.force[:] = [2.0, 0.0]
        machine.step()
        assert machine.orders.controller.wanted_force[0] == served


def test_a_force_that_the_cables_do_not_have_is_no_fault(at: At) -> None:
    machine = at("RUN NONE")
    machine.seen.force[:] = [50.0, 0.0]
    machine.run(100)
    assert machine.orders.state == State.RUN
    assert machine.orders.controller.status == 1


def test_a_failed_step_only_delays_the_approach(at: At) -> None:
    machine = at("TENSION APPROACH")

    def no_number(seen: Observation) -> None:
        seen.hand_force[0] = np.nan

    machine.run(3, spoil=no_number)
    machine.seen.hand_force[0] = 0.0
    machine.until(State.RUN)
    assert machine.orders.cause == Cause.NONE


def test_a_drive_that_leaves_its_mode_stops_the_machine(at: At) -> None:
    machine = at("RUN NONE")

    def leave(seen: Observation) -> None:
        seen.drives[1].mode = Mode.HOMING

    machine.step(leave)
    assert told(machine) == ("HARD_STOP", "DRIVE_STATE")


def test_bases_home_together_and_each_waits_for_the_last(at: At) -> None:
    machine = at("HOME BASE_HOMING")

    def slow(seen: Observation) -> None:
        seen.drives[DRIVES - 1].homing = Homing.RUNNING

    machine.run(3000, spoil=slow)
    assert machine.orders.phase == Phase.BASE_HOMING
    assert {machine.orders.drives[i].home for i in BASES} == {1}
    machine.until(State.HOME, Phase.BASE_RELEASE)
    assert {machine.orders.drives[i].home for i in BASES} == {0}


def test_missed_answers_are_bridged_up_to_the_limit(at: At) -> None:
    machine = at("RUN NONE")
    limit = int(NUMBERS["TB_MISSED_LIMIT"])
    missed = itertools.count(1)

    def lose(seen: Observation) -> None:
        seen.drives[1].fresh, seen.drives[1].missed = 0, next(missed)

    machine.run(limit, spoil=lose)
    assert machine.orders.state == State.RUN
    machine.step(lose)
    assert told(machine) == ("HARD_STOP", "DRIVE_SILENT")


def test_slack_is_wound_in_gently(at: At) -> None:
    machine = at("HOME CABLE_POWER")
    machine.until(State.HOME, Phase.TIGHTEN)
    wound = 0.0
    start = machine.seen.drives[0].position

    def turn(seen: Observation) -> None:
        seen.drives[0].position = start + wound

    for speed in (0.1, 0.2, 0.3, 0.4, 0.5, 0.6):
        for _ in range(3):
            wound += speed * supervised.PERIOD
            machine.step(turn)
        expected = TIGHT * max(0.0, 1.0 - speed / (0.1 * NUMBERS["TB_CABLE_SPEED_LIMIT"]))
        assert machine.orders.drives[0].torque == pytest.approx(expected, abs=1e-9)


def test_a_cable_is_tight_though_a_carriage_glides_towards_the_platform(at: At) -> None:
    machine = at("HOME TIGHTEN")
    wound = itertools.count(1)
    start = machine.seen.drives[2].position

    def glide(seen: Observation) -> None:
        seen.drives[2].position = start + 1e-4 * next(wound)

    machine.run(200, lambda orders: orders.phase == Phase.TRY_CABLES, glide)


@pytest.mark.parametrize(
    ("speed", "expected"), [(0.3, ("SOFT_STOP", "CABLE_SLACK")), (-0.3, ("HARD_STOP", "WRONG_WAY"))]
)
def test_a_cable_that_cannot_be_tightened_is_told(
    at: At, speed: float, expected: tuple[str, str]
) -> None:
    machine = at("HOME TIGHTEN")
    wound = itertools.count(1)
    start = machine.seen.drives[2].position

    def turn(seen: Observation) -> None:
        seen.drives[2].position = start + speed * supervised.PERIOD * next(wound)

    machine.run(STATE_TIMEOUT + 10, lambda orders: orders.state != State.HOME, turn)
    assert told(machine) == expected
    assert machine.orders.culprit == 2
