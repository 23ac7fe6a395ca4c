"""Drives may count from anywhere, and over the end of 32 bits: every start value reaches RUN."""

import pytest
import variants

from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.lockstep import Lockstep, State
from turnbuckle.lab.machine_sim import SimulatedMachine

SOMEWHERE = [0.15, 0.11, 0.13, 0.09]
"""Rail coordinates [m] in which the bases were left."""
STARTS = [16_777_216, 2**31 - 2000, -(2**31), -1_234_567_890]


@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("start", STARTS)
def test_a_machine_whose_drives_count_from_anywhere_works(precision: str, start: int) -> None:
    generated = variants.committed(precision)
    machine = generated.machine
    simulated = SimulatedMachine(machine, plant_of(machine), plan_task(generated), SOMEWHERE)
    for drive in simulated.drives:
        drive.servo.encoder.start_count = start
        drive.servo.encoder.restart()
    lockstep = Lockstep(generated, simulated)
    assert lockstep.bring_up(60_000) is State.RUN, lockstep.view
    simulated.begin_task(repeat=True)
    lockstep.run(3000)
    assert lockstep.state is State.RUN, lockstep.view
