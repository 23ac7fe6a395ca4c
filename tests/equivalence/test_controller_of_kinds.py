"""The controller step where the pose has no closed form: it follows, and fails safely."""

import numpy as np
import pytest
from numpy.typing import NDArray
from unmeasured import STEP, compiled, machine_named

from turnbuckle.codegen.bind import REALS, Generated
from turnbuckle.codegen.controller import Controller
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import Status

Doubles = NDArray[np.float64]
NAME = "kinematics_planar_pulleys"
CYCLES = 400
#: No pose fits lengths that are off by this [m], in the steps there are.
TORN = np.array([-0.2, 0.2, -0.2, 0.2])


@pytest.fixture(scope="module", params=REALS)
def generated(request: pytest.FixtureRequest) -> Generated:
    return compiled(machine_named(NAME), request.param, STEP)


def moved(machine: Machine) -> tuple[Doubles, Doubles]:
    """A circle about the target's centre, at up to 0.4 m/s, with bases that sway."""
    angle = np.linspace(0, 4, CYCLES)[:, None]
    circle = np.hstack([np.cos(angle) - 1, np.sin(angle)])
    pose = np.array(machine.target.centre) + 0.04 * circle
    share = 0.5 + 0.1 * np.sin(3 * angle + np.arange(len(machine.rails)))
    return pose, share * [rail.length for rail in machine.rails]


def tolerance(generated: Generated) -> float:
    return 1e-5 if generated.precision == "float" else 1e-12


def test_it_starts_at_the_target_centre_and_follows(generated: Generated) -> None:
    machine, controller = generated.machine, Controller(generated)
    pose, rails = moved(machine)
    lengths = np.asarray(generated.cable_lengths(pose, rails))
    assert controller.start(lengths[0], rails[0]) == Status.OK
    nothing = np.zeros(machine.dof)
    for k in range(1, CYCLES):
        outputs = controller.step(lengths[k], rails[k], nothing, nothing)
        assert outputs.status in (Status.OK, Status.INFEASIBLE)
        assert np.max(np.abs(outputs.pose - pose[k])) < tolerance(generated)
    speed = (pose[-1] - pose[-2]) * machine.control.rate
    assert np.allclose(outputs.velocity, speed, atol=0.02 * np.linalg.norm(speed))


def test_lengths_without_a_pose_fail_safely_and_the_next_good_cycle_goes_on(
    generated: Generated,
) -> None:
    machine, controller = generated.machine, Controller(generated)
    pose, rails = moved(machine)
    lengths = np.asarray(generated.cable_lengths(pose, rails))
    controller.start(lengths[0], rails[0])
    nothing = np.zeros(machine.dof)
    kept = controller.step(lengths[1], rails[1], nothing, nothing).pose
    # within what a measured rate may be, so that it is the search that fails
    outputs = controller.step(lengths[2] + TORN, rails[2], nothing, nothing)
    assert outputs.status == Status.INACCURATE
    assert np.array_equal(outputs.pose, kept)
    assert np.allclose(outputs.tension, machine.tension.min)
    assert not outputs.rail_force.any()
    outputs = controller.step(lengths[3], rails[3], nothing, nothing)
    assert outputs.status in (Status.OK, Status.INFEASIBLE)
    assert np.max(np.abs(outputs.pose - pose[3])) < tolerance(generated)


def test_a_start_without_a_pose_waits_at_the_target_centre(generated: Generated) -> None:
    machine, controller = generated.machine, Controller(generated)
    pose, rails = moved(machine)
    lengths = np.asarray(generated.cable_lengths(pose, rails))
    assert controller.start(lengths[0] + TORN, rails[0]) == Status.INACCURATE
    assert np.allclose(controller.memory["pose"][0], machine.target.centre)
    nothing = np.zeros(machine.dof)
    outputs = controller.step(lengths[0], rails[0], nothing, nothing)
    assert outputs.status in (Status.OK, Status.INFEASIBLE)
    assert np.max(np.abs(outputs.pose - pose[0])) < tolerance(generated)
