"""The supervisor of a machine of which one base moves and three are fixed."""

import ctypes
import re
from dataclasses import dataclass, field
from functools import cache
from typing import Any, ClassVar

import numpy as np
import pytest
import supervised
import unmeasured
from supervised import CABLES, STOP, Cause, Drive, Machine, Phase, Power, State

from turnbuckle.model.files import write_whole
from turnbuckle.model.reading import load_machine

BASES = np.array([[0.3559, 0.0], [0.7118, 0.2309], [0.3559, 0.4618], [0.0, 0.2309]])
"""The first is on a rail along the lower side; here it is in the middle."""
BASE = CABLES
"""Number of the base's drive."""


class Observation(ctypes.Structure):
    """tb_observation with one base drive"""

    _fields_ = supervised.observation_fields(CABLES + 1, 3)


class Outputs(ctypes.Structure):
    """tb_outputs with one rail"""

    _fields_ = supervised.outputs_fields(1)


class Orders(ctypes.Structure):
    """tb_orders with one base drive"""

    _fields_ = supervised.orders_fields(CABLES + 1, Outputs)


@dataclass
class OneRailMachine(Machine):
    """Four cables, one rail."""

    observation: ClassVar[Any] = Observation
    told: ClassVar[Any] = Orders

    drives: list[Drive] = field(default_factory=lambda: [Drive() for _ in range(CABLES + 1)])
    rails: list[float] = field(default_factory=lambda: [0.3])
    rates: list[float] = field(default_factory=lambda: [0.0])

    def position(self, index: int) -> float:
        """What the encoder says."""
        if index == BASE:
            return super().position(index)
        base = np.array([self.rails[0], 0.0]) if index == 0 else BASES[index]
        return float(0.8 - 0.1 * index - np.hypot(*(base - self.handle)))


def one_rail(text: str) -> str:
    """The stock machine's file with the bases of cables 2 to 4 fixed."""
    for cable, (x, y) in enumerate(BASES[1:], 2):
        base = f'base = ["{x} m", "{y} m"]'
        text, count = re.subn(rf"(# {cable}: .*\n)rail = .*\ndrive = .*\n", rf"\1{base}\n", text)
        assert count == 1
        text = re.sub(rf'\[\[drive\]\]\nname = "base_{cable}"\n.*\n.*\n', "", text)
    return text


FOLLOWS = {"torque": "0", "position": "1"}
"""What a base drive follows at work -> its mode in tb_drives.c."""


@cache
def library(drive: str) -> ctypes.CDLL:
    """Its supervisor, with a base drive that follows torques or positions."""
    folder = supervised.BUILD / f"one_rail_{drive}"
    text = one_rail((supervised.ROOT / "machines" / "yoon2023.toml").read_text())
    write_whole(folder / "machine.toml", text)
    machine = load_machine(folder / "machine.toml")
    for path in unmeasured.compiled(machine, topics=unmeasured.STEP).folder.glob("*.[ch]"):
        changed = re.sub(r'(\{"base_1", \d, \d,) 0,', rf"\1 {FOLLOWS[drive]},", path.read_text())
        write_whole(folder / path.name, changed)
    return supervised.compiled(folder)


TRIAL = {"torque": ["TRY_MODE", "TRY_POWER", "TRY_BASES", "TRY_RELEASE"], "position": []}
"""Phases of the trial of the base, which only a drive that follows torques is put through."""
BEFORE = ["CABLE_POWER", "TIGHTEN", "TRY_CABLES"]
BASE_PHASES = [
    *("BASE_MODE", "BASE_POWER", "BASE_HOMING", "BASE_RELEASE"),
    *("BASE_WORK_MODE", "BASE_WORK_POWER"),
]
AFTER = ["GATHER", "SWEEP", "SOLVE", "APPROACH", "CLOSE", "NONE"]


def work(machine: OneRailMachine) -> list[str]:
    """From power-on to RUN, the handle led around during the sweep; the phases after HOME began."""
    phases: list[str] = []
    swept = 0
    machine.arm()
    while machine.orders.state not in (State.RUN, State.FAULT):
        angle = 3e-3 * swept
        machine.handle = (0.37 + 0.02 * np.cos(angle), 0.21 + 0.05 * np.sin(angle))
        phases.append(Phase(machine.step().phase).name)
        swept += machine.orders.phase == Phase.SWEEP
    return [name for name in dict.fromkeys(phases) if name != "CABLE_MODE"]


@pytest.mark.parametrize("drive", FOLLOWS)
def test_one_base_goes_through_every_phase_to_work_and_stops(drive: str) -> None:
    machine = OneRailMachine(library(drive))
    assert work(machine) == [*BEFORE, *TRIAL[drive], *BASE_PHASES, *AFTER]
    assert np.allclose(machine.orders.controller.pose, machine.handle, atol=2e-4)
    machine.ask(STOP)
    machine.until(State.CONFIGURE)
    assert {order.torque for order in machine.orders.drives} == {0.0}


def test_its_base_that_fails_is_named() -> None:
    def fails(seen: Any) -> None:
        seen.drives[BASE].power = Power.FAULT

    machine = OneRailMachine(library("torque"))
    work(machine)
    machine.run(2000, lambda orders: orders.state == State.FAULT, fails)
    assert (Cause(machine.orders.cause).name, machine.orders.culprit) == ("DRIVE_FAULT", BASE)


def test_its_base_that_moves_the_wrong_way_is_named() -> None:
    def mirrored(seen: Any) -> None:
        seen.drives[BASE].position *= -1.0

    machine = OneRailMachine(library("torque"))
    machine.arm()
    machine.run(3000, lambda orders: orders.state != State.HOME, mirrored)
    assert (Cause(machine.orders.cause).name, machine.orders.culprit) == ("WRONG_WAY", BASE)
