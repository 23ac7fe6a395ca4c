"""The controller step that CasADi generates commands what the runtime's step commands."""

from pathlib import Path

import numpy as np
import pytest

from turnbuckle.lab.benchmark.step.comparison import casadi_step, our_step
from turnbuckle.lab.benchmark.step.motion import recorded_inputs
from turnbuckle.lab.benchmark.tension_problems import Reals
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
CYCLES = 3000


@pytest.fixture(scope="module")
def machine() -> Machine:
    return load_machine(ROOT / "machines" / "yoon2023.toml")


@pytest.fixture(scope="module")
def commands(machine: Machine) -> Reals:
    """What the runtime commands: motor torques [N m] (4), rail forces [N] (4)."""
    return our_step(machine, ROOT / "generated" / "yoon2023")(recorded_inputs(machine, CYCLES))


def tolerances(machine: Machine) -> Reals:
    """Rounding of a cycle, carried on by filters that remember some hundred cycles."""
    drive = machine.rail_drive
    assert drive is not None
    scale = [machine.cable_motor.torque_limit] * 4 + [drive.stiffness * max(machine.frame.size)] * 4
    return 2**12 * np.finfo(float).eps * np.array(scale)


def test_both_steps_command_the_same(machine: Machine, commands: Reals) -> None:
    peer = casadi_step(machine)(recorded_inputs(machine, CYCLES))
    assert np.all(np.abs(peer - commands) <= tolerances(machine))


def test_the_motion_moves_everything(commands: Reals) -> None:
    assert np.all(np.ptp(commands, axis=0) > 0.01 * np.max(np.abs(commands), axis=0))


def test_a_slightly_different_machine_is_told_apart(machine: Machine, commands: Reals) -> None:
    drum = machine.drum.model_copy(update={"radius": (1 + 1e-9) * machine.drum.radius})
    other = machine.model_copy(update={"drum": drum})
    peer = casadi_step(other)(recorded_inputs(machine, CYCLES))
    assert not np.all(np.abs(peer - commands) <= tolerances(machine))
