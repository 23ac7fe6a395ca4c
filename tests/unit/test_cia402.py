"""CiA 402: power states of all statuswords; controlwords to every goal, and nowhere else."""

from collections import deque
from itertools import product

import pytest
from canopen.profiles.p402 import Homing, State402
from canopen_c import canopen_c
from cia402_machine import AUTOMATIC, RESET, STATUSWORDS, TRANSITIONS, Machine, command_of

C = canopen_c()
POWERS = [
    "UNKNOWN",
    "NOT_READY",
    "OFF",
    "READY",
    "ON",
    "ENABLED",
    "QUICK_STOP",
    "FAULT_REACTION",
    "FAULT",
]
GOALS = ["OFF", "READY", "ENABLED", "QUICK_STOP", "FAULT_RESET"]
NAMES_OF_P402 = {
    "UNKNOWN": "UNKNOWN",
    "NOT READY TO SWITCH ON": "NOT_READY",
    "SWITCH ON DISABLED": "OFF",
    "READY TO SWITCH ON": "READY",
    "SWITCHED ON": "ON",
    "OPERATION ENABLED": "ENABLED",
    "QUICK STOP ACTIVE": "QUICK_STOP",
    "FAULT REACTION ACTIVE": "FAULT_REACTION",
    "FAULT": "FAULT",
}
HOME = 0x10

ARRIVED = {
    "OFF": {"OFF"},
    "READY": {"ON"},
    "ENABLED": {"ENABLED"},
    "QUICK_STOP": {"QUICK_STOP", "OFF"},
    "FAULT_RESET": {"OFF"},
}


def planned(power: str, goal: str, home: bool = False, previous: int = 0) -> int:
    """tb_cia402_controlword."""
    numbers = getattr(C, f"TB_POWER_{power}"), getattr(C, f"TB_GOAL_{goal}")
    return int(C.tb_cia402_controlword(*numbers, home, previous))


def power_of(statusword: int) -> str:
    """tb_cia402_power."""
    return POWERS[int(C.tb_cia402_power(statusword))]


def distances(goal: str) -> dict[str, int]:
    """Steps from every state to a goal. Operation is enabled from ON only: no state is jumped, and
    out of a quick stop no way leads back to torque but by OFF."""
    skipped = {("READY", "enable"), ("QUICK_STOP", "enable")}
    steps = {(step[0], to) for step, to in TRANSITIONS.items() if step not in skipped}
    steps |= set(AUTOMATIC.items())
    if goal == "FAULT_RESET":
        steps.add(("FAULT", "OFF"))
    found, waiting = dict.fromkeys(ARRIVED[goal], 0), deque(ARRIVED[goal])
    while waiting:
        there = waiting.popleft()
        for before in (a for a, b in steps if b == there and a not in found):
            found[before] = found[there] + 1
            waiting.append(before)
    return found


def test_every_statusword_means_what_python_canopen_says() -> None:
    masks = State402.SW_MASK
    for statusword in range(0x10000):
        names = [name for name, (mask, value) in masks.items() if statusword & mask == value]
        assert len(names) <= 1
        assert power_of(statusword) == NAMES_OF_P402[names[0] if names else "UNKNOWN"]


def test_patterns_that_cia_402_does_not_know_are_unknown_not_a_guess() -> None:
    assert {power_of(word) for word in (0x0001, 0x0020 | 0x05, 0x000B, 0x006F, 0xFFFF)} == {
        "UNKNOWN"
    }


@pytest.mark.parametrize(("power", "goal"), list(product(POWERS[1:], GOALS)))
def test_each_command_is_the_next_step_to_the_goal(power: str, goal: str) -> None:
    away = distances(goal)
    machine = Machine(power)
    machine.take(planned(power, goal))
    if power in away:
        assert away[machine.power] <= max(away[power] - 1, 0), (power, goal, machine.power)
    else:
        assert power in ("FAULT", "FAULT_REACTION") and machine.power == "FAULT"


@pytest.mark.parametrize("goal", ["OFF", "READY", "ENABLED", "FAULT_RESET"])
def test_an_unknown_state_gets_no_power(goal: str) -> None:
    assert planned("UNKNOWN", goal) == 0


def test_an_unknown_state_is_stopped_where_a_stop_is_the_goal() -> None:
    assert command_of(planned("UNKNOWN", "QUICK_STOP")) == "quick stop"


def test_only_the_goal_of_a_fault_reset_resets_a_fault_and_only_in_the_fault_state() -> None:
    for power, goal, home, previous in product(POWERS, GOALS, (False, True), (0, 0x0F, 0x80)):
        resets = bool(planned(power, goal, home, previous) & RESET)
        wanted = (power, goal) == ("FAULT", "FAULT_RESET") and not previous & RESET
        assert resets == wanted, (power, goal, home, previous)


def test_homing_runs_only_in_an_enabled_drive_that_shall_be() -> None:
    for power, goal, home in product(POWERS, GOALS, (False, True)):
        homes = bool(planned(power, goal, home) & HOME)
        assert homes == (home and (power, goal) == ("ENABLED", "ENABLED"))


def test_no_command_has_bits_that_cia_402_does_not_give_it() -> None:
    words = {planned(*case) for case in product(POWERS, GOALS, (False, True), (0, 0x80))}
    assert words == {0x00, 0x02, 0x06, 0x07, 0x0F, 0x1F, 0x80}


@pytest.mark.parametrize("lost", [(), (1,), (2, 3), (4, 5, 6)])
@pytest.mark.parametrize("goal", GOALS)
@pytest.mark.parametrize("start", POWERS[1:])
def test_every_goal_is_reached_with_the_latency_of_sync(
    start: str, goal: str, lost: tuple[int, ...]
) -> None:
    # A command of cycle k acts at SYNC k + 1 and shows at SYNC k + 2; some commands get lost.
    machine, waiting, sent, seen = Machine(start), 0, 0, []
    for cycle in range(24):
        seen.append(machine.power)
        machine.take(waiting)
        sent = planned(power_of(STATUSWORDS[seen[-1]]), goal, previous=sent)
        waiting = waiting if cycle in lost else sent
    stays_faulty = start in ("FAULT", "FAULT_REACTION") and goal != "FAULT_RESET"
    assert set(seen[-6:]) <= ({"FAULT"} if stays_faulty else ARRIVED[goal])


def test_a_planner_that_holds_the_reset_bit_would_be_found_out() -> None:
    machine = Machine("FAULT")
    machine.controlword = RESET  # of a frame before: no edge
    machine.take(RESET)
    assert machine.power == "FAULT"


def test_homing_bits_mean_what_python_canopen_says() -> None:
    names = {
        "IN PROGRESS": "RUNNING",
        "INTERRUPTED": "IDLE",
        "ATTAINED": "RUNNING",
        "TARGET REACHED": "DONE",
        "ERROR VELOCITY IS NOT ZERO": "FAILED",
        "ERROR VELOCITY IS ZERO": "FAILED",
    }
    for statusword in range(0x10000):
        found = [n for n, (mask, value) in Homing.STATES.items() if statusword & mask == value]
        wanted = names[found[0]] if found else "FAILED"
        assert C.tb_cia402_homing(statusword) == getattr(C, f"TB_HOMING_{wanted}")
