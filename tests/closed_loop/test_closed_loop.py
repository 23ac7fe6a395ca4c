"""The compiled controller in closed loop with the plant: what a user of the machine would feel."""

import numpy as np
import pytest
from numpy.typing import NDArray
from variants import committed

from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.controller import UNCOMPENSATED, Controller, Outputs
from turnbuckle.lab.bench import Recording, run_task
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.summary import Summary, penetration, summarise
from turnbuckle.lab.task import SHARE, TENSIONING
from turnbuckle.model.machine import Machine, Plant
from turnbuckle.model.symbolic.function import Status


@pytest.fixture(scope="module")
def generated() -> Generated:
    """The stock machine."""
    return committed()


@pytest.fixture(scope="module")
def machine(generated: Generated) -> Machine:
    """The stock machine as data."""
    return generated.machine


@pytest.fixture(scope="module")
def plant(machine: Machine) -> Plant:
    """Its physics."""
    return plant_of(machine)


@pytest.fixture(scope="module")
def recording(generated: Generated, plant: Plant) -> Recording:
    """One run of the whole task."""
    return run_task(generated.machine, plant, Controller(generated), plan_task(generated))


@pytest.fixture(scope="module")
def summary(machine: Machine, recording: Recording) -> Summary:
    """Its numbers."""
    return summarise(machine, recording)


@pytest.fixture(scope="module")
def uncompensated(generated: Generated, plant: Plant) -> Summary:
    """The numbers of the same run while the observer only watches."""
    task = plan_task(generated)
    controller = Controller(generated)
    return summarise(
        generated.machine, run_task(generated.machine, plant, controller, task, UNCOMPENSATED)
    )


def running(recording: Recording) -> NDArray[np.bool_]:
    """The cycles after the tensioning."""
    return np.asarray(recording.time >= TENSIONING)


def cable_motion(machine: Machine, recording: Recording) -> tuple[float, float]:
    """Largest speed [m/s] and acceleration [m/s^2] of any cable."""
    rates = np.diff(recording.inputs["lengths"], axis=0) * machine.control.rate
    accelerations = np.diff(rates, axis=0) * machine.control.rate
    return float(np.abs(rates).max()), float(np.abs(accelerations).max())


def physical_margin(machine: Machine, plant: Plant, recording: Recording) -> float:
    """How far a tension may fall below its command: what friction and inertia of a motor take.

    Dry friction counts twice: the friction itself, and a compensation that still has the sign it
    had before the motion turned.
    """
    radius = machine.drum.radius
    speed, acceleration = cable_motion(machine, recording)
    dry = 2 * plant.motor_coulomb_friction / radius
    viscous = plant.motor_viscous_friction / radius**2 * speed
    inertial = machine.cable_motor.inertia / radius**2 * acceleration
    return dry + viscous + inertial


def test_no_cycle_fails_and_no_wanted_force_is_too_much(summary: Summary) -> None:
    assert summary.failed == 0 and summary.infeasible == 0


def test_the_gate_never_has_to_step_in(recording: Recording) -> None:
    assert (recording.outputs.gate == 0).all()


def test_no_tension_falls_below_the_minimum_by_more_than_the_motors_physics(
    machine: Machine, plant: Plant, recording: Recording, summary: Summary
) -> None:
    margin = physical_margin(machine, plant, recording)
    assert 0.3 < margin < 0.8 * machine.tension.min
    assert summary.lowest_tension > machine.tension.min - margin
    assert summary.highest_tension < machine.tension.max + margin


def test_a_resting_hand_feels_the_walls_stiffness_times_its_depth(
    machine: Machine, recording: Recording
) -> None:
    depths = penetration(machine, recording.position)
    for index, (wall, phase) in enumerate(
        zip(machine.walls, recording.task.wall_phases, strict=True)
    ):
        rest = recording.during(phase)
        depth = depths[rest, index]
        force = recording.cable_force[rest] @ np.array(wall.normal)
        assert force.mean() == pytest.approx(SHARE * machine.target.force, abs=0.15)
        assert force.mean() == pytest.approx(wall.stiffness * depth.mean(), abs=0.15)
        assert depth.max() == pytest.approx(force.mean() / wall.stiffness, rel=0.05)


def test_the_bases_follow_as_closely_as_their_drives_allow(
    machine: Machine, plant: Plant, recording: Recording, summary: Summary
) -> None:
    # A PID with damping on the measured speed trails by (b v + M a + friction) / k.
    drive = machine.rail_drive
    assert drive is not None and summary.base_lag is not None
    assert plant.carriage_viscous_friction is not None
    assert plant.carriage_coulomb_friction is not None
    speeds = np.diff(recording.outputs.rail_target[running(recording)], axis=0)
    speed = np.abs(speeds).max() * machine.control.rate
    resistance = (drive.damping + plant.carriage_viscous_friction) * speed
    assert summary.base_lag < (resistance + plant.carriage_coulomb_friction) / drive.stiffness
    still = recording.during(recording.task.wall_phases[-1])
    rest = np.abs(recording.rails - recording.outputs.rail_target)[still]
    assert rest.max() < 0.1 * summary.base_lag


def test_the_pose_is_known_to_within_rounding(summary: Summary) -> None:
    assert summary.pose_error < 1e-12


def test_the_observer_brings_the_force_nearer_to_what_is_wanted(
    summary: Summary, uncompensated: Summary
) -> None:
    # Without it a hand at rest feels the dry friction of two motors; with it, next to nothing.
    assert summary.wall_error is not None and uncompensated.wall_error is not None
    assert uncompensated.wall_error > 0.4
    assert summary.wall_error < 0.2 * uncompensated.wall_error
    assert summary.turn_error < 0.6 * uncompensated.turn_error
    assert summary.tour_force < uncompensated.tour_force


def test_the_tensions_against_each_other_do_not_drift(
    machine: Machine, recording: Recording
) -> None:
    # Nobody measures them, so an observer that integrated them would let the cables go slack.
    last = recording.during(recording.task.wall_phases[-1])
    opposite = recording.tensions[last].mean(axis=0)
    commanded = recording.outputs.tension[last].mean(axis=0)
    assert np.abs(opposite - commanded).max() < 0.1 * machine.tension.min


def test_a_recording_replays_to_the_same_bits(generated: Generated, recording: Recording) -> None:
    controller = Controller(generated)
    first = recording.inputs[0]
    controller.start(first["lengths"], first["rails"])
    replayed, nanoseconds = controller.run_recorded(recording.inputs)
    for name, column in replayed._asdict().items():
        assert (column == getattr(recording.outputs, name)).all(), name
    assert (nanoseconds >= 0).all() and nanoseconds.sum() > 0


def test_single_precision_feels_the_same(plant: Plant, summary: Summary) -> None:
    single = committed("float")
    task = plan_task(single)
    found = summarise(single.machine, run_task(single.machine, plant, Controller(single), task))
    assert found.failed == 0
    assert found.wall_error == pytest.approx(summary.wall_error, abs=0.05)
    assert found.turn_error == pytest.approx(summary.turn_error, rel=0.05)
    assert found.lowest_tension == pytest.approx(summary.lowest_tension, abs=0.1)


class Deaf(Controller):
    """A controller that cannot read one cable during some of its cycles."""

    def __init__(self, generated: Generated, cycles: range) -> None:
        super().__init__(generated)
        self._deaf = cycles
        self._cycle = iter(range(10**9))

    def run_recorded(self, inputs: NDArray[np.void]) -> tuple[Outputs, NDArray[np.int64]]:
        """Run one cycle."""
        if next(self._cycle) in self._deaf:
            inputs["lengths"][:, 2] = np.nan
        return super().run_recorded(inputs)


def cycles_of(recording: Recording, name: str, count: int) -> range:
    """So many cycles from the middle of a phase."""
    middle = int(np.flatnonzero(recording.during(recording.task.phase(name))).mean())
    return range(middle, middle + count)


@pytest.mark.parametrize("lost", [1, 20])
def test_a_machine_that_loses_an_encoder_while_pressing_stays_taut_and_comes_back(
    generated: Generated, plant: Plant, recording: Recording, lost: int
) -> None:
    cycles = cycles_of(recording, "wall right", lost)
    found = run_task(generated.machine, plant, Deaf(generated, cycles), recording.task)
    failed = found.outputs.status > Status.INFEASIBLE
    assert np.flatnonzero(failed).tolist() == list(cycles)
    assert all(np.isfinite(column).all() for column in found.outputs)
    assert found.lowest_tension[running(found)].min() > 0.0
    after = found.during(found.task.phase("wall top"))
    same = np.abs(found.tensions[after] - recording.tensions[after]).max()
    assert same < 0.1 * generated.machine.tension.min
