"""The supervisor of a machine whose bases are fixed: its user moves the platform to calibrate."""

import ctypes
import re
from dataclasses import dataclass, field
from functools import cache
from typing import Any, ClassVar

import numpy as np
import pytest
import supervised
from safety_table import constants
from supervised import CABLES, STOP, Cause, Drive, Machine, Phase, State

FIXED = supervised.ROOT / "generated" / "yoon_fixed_diagonal"
NUMBERS = constants(supervised.STOCK)
CORNERS = np.array([[0.0, 0.0], [0.506, 0.0], [0.506, 0.284], [0.0, 0.284]])


class Observation(ctypes.Structure):
    """tb_observation without base drives"""

    _fields_ = supervised.observation_fields(CABLES, 2)


class Outputs(ctypes.Structure):
    """tb_outputs without rails"""

    _fields_ = supervised.outputs_fields(1)


class Orders(ctypes.Structure):
    """tb_orders without base drives"""

    _fields_ = supervised.orders_fields(CABLES, Outputs)


@dataclass
class FixedMachine(Machine):
    """Four cables, no rails."""

    observation: ClassVar[Any] = Observation
    told: ClassVar[Any] = Orders

    handle: tuple[float, float] = (0.25, 0.14)
    drives: list[Drive] = field(default_factory=lambda: [Drive() for _ in range(CABLES)])
    rails: list[float] = field(default_factory=list)
    rates: list[float] = field(default_factory=list)

    def position(self, index: int) -> float:
        """Cable wound in."""
        return float(0.7 + 0.05 * index - np.hypot(*(CORNERS[index] - self.handle)))


@cache
def library() -> ctypes.CDLL:
    """Its supervisor: the cable drives of the stock machine on two buses."""

    def without_bases(text: str) -> str:
        text = re.sub(r"(#define TB_DRIVES) 8", r"\1 4", text)
        text = re.sub(r"(#define TB_BUSES) 3", r"\1 2", text)
        text = re.sub(r"(#define TB_RAIL_LENGTHS) \{.*\}", r"\1 {TB_C(0.0)}", text)
        text = re.sub(r',\s*\{"base",[^}]*\}', "", text)
        return re.sub(r',\s*\{"base_\d",[^}]*\}', "", text)

    folder = supervised.machine_folder("without_rails", FIXED, without_bases)
    return supervised.compiled(folder)


@pytest.fixture
def machine() -> FixedMachine:
    made = FixedMachine(library())
    made.arm()
    made.until(State.HOME, Phase.SWEEP)
    return made


def lead(machine: FixedMachine, cycles: int) -> None:
    """Move the handle around in circles that grow."""
    for cycle in range(cycles):
        if machine.orders.phase != Phase.SWEEP:
            return
        angle, radius = 3e-3 * cycle, 0.02 + 2e-5 * min(cycle, 4000)
        away = radius * np.array([np.cos(angle) - 1, np.sin(angle)])
        machine.handle = (0.25 + float(away[0]), 0.14 + float(away[1]))
        machine.step()


def test_moving_the_handle_around_calibrates_the_machine(machine: FixedMachine) -> None:
    lead(machine, 6000)
    machine.until(State.RUN, cycles=1000)
    assert np.allclose(machine.orders.controller.pose, machine.handle, atol=1e-5)
    machine.ask(STOP)
    machine.until(State.CONFIGURE)


def test_no_base_is_waited_for() -> None:
    machine, phases = FixedMachine(library()), list[str]()
    machine.arm()
    while machine.orders.phase != Phase.SWEEP:
        phases.append(Phase(machine.step().phase).name)
    passed = ["CABLE_MODE", "CABLE_POWER", "TIGHTEN", "TRY_CABLES", "GATHER", "SWEEP"]
    assert list(dict.fromkeys(["CABLE_MODE", *phases])) == passed


def test_a_handle_that_is_left_alone_does_not(machine: FixedMachine) -> None:
    machine.run(int(NUMBERS["TB_HOMING_TIMEOUT"]) + 5, lambda orders: orders.state != State.HOME)
    told = State(machine.orders.state).name, Cause(machine.orders.cause).name
    assert told == ("SOFT_STOP", "CALIBRATION")


def test_a_silent_drive_stops_it_at_once(machine: FixedMachine) -> None:
    def silent(seen: Any) -> None:
        seen.drives[3].silent = 1

    machine.run(20, spoil=silent)
    assert State(machine.orders.state) == State.FAULT
    assert {order.torque for order in machine.orders.drives} == {0.0}
