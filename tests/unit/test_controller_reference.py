"""The step in C against the NumPy reference, composed cycle by cycle over a random recording."""

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from motion import committed, recorded, with_defect
from numpy.typing import NDArray

from turnbuckle.codegen.controller import Controller, Outputs
from turnbuckle.model.machine import Machine
from turnbuckle.model.reference import control, kinematics, statics, tension
from turnbuckle.model.symbolic.function import Status

Reals = NDArray[np.floating[Any]]
CYCLES = 1500


class Expected(NamedTuple):
    """What the reference says; every array has a leading axis of cycles."""

    pose: Reals
    velocity: Reals
    residual: Reals
    wanted_force: Reals
    delivered_force: Reals
    tension: Reals
    disturbance: Reals
    motor_torque: Reals
    rail_target: Reals
    rail_force: Reals
    rail_torque: Reals


def expected(machine: Machine, inputs: NDArray[np.void], sent: Reals) -> Expected:
    """The reference's outputs; `sent` are the torques that really went out, cycle by cycle."""
    lengths, rails, force, hand = (
        inputs[name].astype(float) for name in ("lengths", "rails", "force", "hand_force")
    )
    pose, residual = kinematics.forward_kinematics(machine, lengths, rails)
    rates = [control.velocity_sequence(machine, moved) for moved in (lengths, rails)]
    velocity = kinematics.task_velocity(machine, pose, rails, *rates)
    wanted = control.wall_force(machine, pose, velocity) + force
    structure = kinematics.structure_matrix(machine, pose, rails)
    found = tension.distribute_tension(machine, structure, wanted)
    applied = np.vstack([np.zeros_like(sent[:1]), sent[:-1]])
    load = control.load_tension(machine, structure, applied / machine.drum.radius, hand)
    disturbance = control.disturbance_sequence(machine, lengths, load, applied)
    target = control.base_targets(machine, pose)
    rail_force = base_forces(machine, target, rails)
    return Expected(
        pose,
        velocity,
        residual,
        wanted,
        statics.wrench(machine, structure, found.tension),
        found.tension,
        disturbance,
        gated(machine, control.motor_torques(machine, found.tension), disturbance, applied),
        target,
        rail_force,
        machine.rail_drive.pinion_radius * rail_force,  # type: ignore[union-attr]
    )


def gated(machine: Machine, torque: Reals, disturbance: Reals, previous: Reals) -> Reals:
    """Torque and limited compensation, after the torque gate."""
    motor = machine.cable_motor
    share = motor.torque_limit - machine.drum.radius * machine.tension.max
    step = motor.torque_rate_limit / machine.control.rate
    command = np.clip(torque + np.clip(disturbance, -share, share), 0.0, motor.torque_limit)
    return np.asarray(np.clip(command, previous - step, previous + step))


def base_forces(machine: Machine, target: Reals, rails: Reals) -> Reals:
    """Forces on the carriages, cycle by cycle from rest."""
    memory: Reals = np.zeros((rails.shape[1], 3))
    memory[:, control.MEASURED] = rails[0]
    forces = []
    for wanted, measured in zip(target, rails, strict=True):
        memory, force = control.base_pid(machine, memory, wanted, measured)
        forces.append(force)
    return np.array(forces)


def tolerances(machine: Machine, structure: Reals, eps: float) -> dict[str, Reals]:
    """Rounding of every output (cycles, 1), from the sizes of what it is computed of."""
    rate, radius, wall = machine.control.rate, machine.drum.radius, machine.walls[0]
    motor, drive, observer = machine.cable_motor, machine.rail_drive, machine.disturbance_observer
    assert drive is not None and observer is not None
    length = max(machine.frame.size)
    speed = length * rate
    force = wall.stiffness * length + wall.damping * speed + machine.tension.max
    memory = observer.time_constant * rate  # cycles for which the filter keeps what it rounded
    inertia = memory * motor.inertia / observer.time_constant**2
    disturbance = inertia * length / radius + radius * 4 * machine.tension.max
    rail_force = drive.stiffness * length + drive.damping * speed
    # Two cables nearly in line share a force by the small angle between them.
    tension = force / smallest_angle(structure)
    sizes: dict[str, Any] = {
        "pose": length,
        "velocity": speed,
        "residual": length,
        "wanted_force": force,
        "delivered_force": force,
        "tension": tension,
        "disturbance": disturbance,
        "motor_torque": radius * tension + disturbance,
        "rail_target": length,
        "rail_force": rail_force,
        "rail_torque": drive.pinion_radius * rail_force,
    }
    return {name: np.asarray(32 * eps * size) for name, size in sizes.items()}


def smallest_angle(structure: Reals) -> Reals:
    """Sine of the smallest angle between the lines of any two cables (cycles, 1)."""
    first, second = np.triu_indices(structure.shape[-1], 1)
    x, y = structure[:, 0], structure[:, 1]
    sines = np.abs(x[:, first] * y[:, second] - y[:, first] * x[:, second])
    return np.asarray(sines.min(axis=1, keepdims=True))


def compare(machine: Machine, inputs: NDArray[np.void], outputs: Outputs) -> None:
    """Every output of every cycle against the reference."""
    reference = expected(machine, inputs, outputs.motor_torque.astype(float))
    structure = kinematics.structure_matrix(machine, reference.pose, inputs["rails"])
    allowed = tolerances(machine, structure, float(np.finfo(outputs.pose.dtype).eps))
    for name, values in reference._asdict().items():
        error = np.abs(getattr(outputs, name) - values)
        assert (error <= allowed[name]).all(), f"{name}: {error.max()}, allowed {allowed[name]}"


@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("seed", [101, 202, 303])
def test_the_step_agrees_with_the_reference_in_every_output(precision: str, seed: int) -> None:
    generated = committed("yoon2023", precision)
    controller = Controller(generated)
    inputs = recorded(generated.machine, controller, CYCLES, seed)
    controller.start(inputs["lengths"][0], inputs["rails"][0])
    outputs, _ = controller.run_recorded(inputs)
    assert set(outputs.status.tolist()) == {Status.OK, Status.INFEASIBLE}
    compare(generated.machine, inputs, outputs)


@pytest.mark.parametrize(
    ("field", "amount"),
    [("lengths", 1e-5), ("rails", 1e-5), ("force", 1e-3), ("hand_force", 1e-2)],
)
def test_a_small_difference_in_one_reading_is_noticed(field: str, amount: float) -> None:
    generated = committed("yoon2023", "double")
    controller = Controller(generated)
    inputs = recorded(generated.machine, controller, CYCLES, seed=101)
    controller.start(inputs["lengths"][0], inputs["rails"][0])
    outputs, _ = controller.run_recorded(inputs)
    inputs[field][CYCLES // 2, 0] += amount
    with pytest.raises(AssertionError):
        compare(generated.machine, inputs, outputs)


SEEDED = [
    (
        "outputs->wanted_force[i] += inputs->force[i]",
        "outputs->wanted_force[i] -= inputs->force[i]",
    ),
    ("rates[i] = kept[i] + (TB_VELOCITY_GAIN * (rate - kept[i]))", "rates[i] = rate"),
    ("controller->torque[i] * (TB_C(1.0) / TB_DRUM_RADIUS)", "outputs->tension[i]"),
    ("+= limit_compensation(", "-= limit_compensation("),
    ("TB_PINION_RADIUS * outputs->rail_force[i]", "outputs->rail_force[i]"),
    ("copy(TB_DOF, inputs->hand_force, hand_force)", "fill(TB_DOF, TB_C(0.0), hand_force)"),
    (
        "(outputs->pose, outputs->velocity, outputs->wanted_force)",
        "(outputs->pose, outputs->pose, outputs->wanted_force)",
    ),
]


@pytest.mark.parametrize(("old", "new"), SEEDED)
def test_a_seeded_defect_of_the_arithmetic_is_found(tmp_path: Path, old: str, new: str) -> None:
    generated = committed("yoon2023", "double")
    controller = Controller(generated, with_defect(tmp_path, old, new))
    inputs = recorded(generated.machine, controller, CYCLES, seed=101)
    controller.start(inputs["lengths"][0], inputs["rails"][0])
    outputs, _ = controller.run_recorded(inputs)
    with pytest.raises(AssertionError):
        compare(generated.machine, inputs, outputs)
