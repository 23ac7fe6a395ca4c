"""The plant against physics that is known without it."""

from math import hypot

import numpy as np
import pytest
from variants import STOCK

from turnbuckle.lab.hand import Hand, Path
from turnbuckle.lab.planar_plant import PlanarPlant
from turnbuckle.lab.strand import PRESLIDING, Friction, Pair
from turnbuckle.model.base import Coordinates
from turnbuckle.model.machine import Machine, Plant
from turnbuckle.model.reading import load_machine

CENTRE = (0.3559, 0.2309)


class Push:
    """A holder without mass who pushes with a constant force."""

    mass = 0.0

    def __init__(self, force: Pair) -> None:
        self._force = force

    def push(self, time: float, pose: Coordinates, twist: Coordinates) -> Coordinates:
        """The force [N]."""
        return self._force


@pytest.fixture
def machine() -> Machine:
    """The stock machine."""
    return load_machine(STOCK)


@pytest.fixture
def plant(machine: Machine) -> Plant:
    """Its physics."""
    assert machine.plant is not None
    return machine.plant


@pytest.fixture
def frictionless(plant: Plant) -> Plant:
    """The same without any friction."""
    none = {name: 0.0 for name in Plant.model_fields if "friction" in name}
    return plant.model_copy(update=none)


def test_at_rest_every_cable_carries_the_torque_of_its_motor(
    machine: Machine, plant: Plant
) -> None:
    world = PlanarPlant(machine, plant, Push((0.0, 0.0)), CENTRE, [*CENTRE, *CENTRE])
    world.advance([0.02] * 4, [0.0] * 4)
    np.testing.assert_allclose(world.tensions, 0.02 / machine.drum.radius, rtol=1e-12)
    assert world.position == pytest.approx(CENTRE, abs=1e-15)


def test_a_push_moves_the_handle_against_its_own_and_the_motors_inertia(
    machine: Machine, frictionless: Plant
) -> None:
    # Along x only the motors of cables 2 and 4 turn.
    world = PlanarPlant(machine, frictionless, Push((1.0, 0.0)), CENTRE, [*CENTRE, *CENTRE])
    world.advance([0.02] * 4, [0.0] * 4)
    winding = machine.cable_motor.inertia / machine.drum.radius**2
    mass = frictionless.handle_mass + 2 * winding
    assert world.velocity[0] == pytest.approx(0.001 / mass, rel=1e-4)
    assert world.velocity[1] == pytest.approx(0.0, abs=1e-9)


def test_work_becomes_kinetic_energy_when_there_is_no_friction(
    machine: Machine, frictionless: Plant
) -> None:
    # Motors and rails work, the handle is pushed, and nothing is lost: also with bases far off
    # the handle, where everything is coupled.
    push, torques, forces = (0.8, -0.5), [0.02, 0.015, 0.018, 0.022], [1.0, -2.0, 0.5, 1.5]
    world = PlanarPlant(machine, frictionless, Push(push), (0.3, 0.2), [0.5, 0.35, 0.2, 0.1])
    before = world.lengths, world.rails, world.position
    for _ in range(150):
        last = world.lengths, world.rails
        world.advance(torques, forces)
    rate = machine.control.rate
    rates, rail_speeds = (
        (np.array(now) - then) * rate
        for now, then in zip((world.lengths, world.rails), last, strict=True)
    )
    assert frictionless.carriage_mass is not None
    winding = machine.cable_motor.inertia / machine.drum.radius**2
    kinetic = 0.5 * (
        winding * np.sum(rates**2)
        + frictionless.carriage_mass * np.sum(rail_speeds**2)
        + frictionless.handle_mass * hypot(*world.velocity) ** 2
    )
    work = (
        np.dot(np.array(torques) / machine.drum.radius, np.subtract(before[0], world.lengths))
        + np.dot(forces, np.subtract(world.rails, before[1]))
        + np.dot(push, np.subtract(world.position, before[2]))
    )
    assert work > 0.05
    assert kinetic == pytest.approx(work, rel=0.01)


def test_a_cable_that_would_have_to_push_hangs_slack_and_takes_hold_again(
    machine: Machine, plant: Plant
) -> None:
    world = PlanarPlant(machine, plant, Push((20.0, 0.0)), CENTRE, [*CENTRE, *CENTRE])
    for _ in range(20):
        world.advance([0.0] * 4, [0.0] * 4)
    assert world.tensions[1] == 0.0 and world.lowest_tension == 0.0
    assert world.slack[1] > 1e-3 and world.slack[3] == 0.0
    for _ in range(60):
        world.advance([0.05] * 4, [0.0] * 4)
    assert world.slack[1] == 0.0 and world.tensions[1] > 1.0


def test_the_jerk_of_a_cable_that_takes_hold_keeps_the_momentum(
    machine: Machine, frictionless: Plant
) -> None:
    # Motor 2 pays cable out, then winds it in until it takes hold of the handle at rest.
    world = PlanarPlant(machine, frictionless, Push((0.0, 0.0)), CENTRE, [*CENTRE, *CENTRE])
    world.break_cable(3)
    for _ in range(10):
        world.advance([0.0, -0.01, 0.0, 0.0], [0.0] * 4)
    assert world.slack[1] > 0.0 and world.velocity[0] == 0.0
    impulse = -0.01 * 10
    while world.slack[1] > 0.0:
        world.advance([0.0, 0.05, 0.0, 0.0], [0.0] * 4)
        impulse += 0.05
    impulse *= 1.0 / (machine.drum.radius * machine.control.rate)
    winding = machine.cable_motor.inertia / machine.drum.radius**2
    together = impulse / (winding + frictionless.handle_mass)
    assert world.velocity[0] == pytest.approx(together, rel=1e-6) and together > 0.2


def test_a_broken_cable_leaves_its_motor_free_and_the_others_as_they_are(
    machine: Machine, plant: Plant
) -> None:
    world = PlanarPlant(machine, plant, Hand(plant, Path(CENTRE, 1.0)), CENTRE, [*CENTRE, *CENTRE])
    for _ in range(50):
        world.advance([0.02] * 4, [0.0] * 4)
    whole = world.lengths[0]
    world.break_cable(0)
    for _ in range(50):
        world.advance([0.02] * 4, [0.0] * 4)
    assert world.tensions[0] == 0.0 and min(world.tensions[1:]) > 2.0
    assert world.lengths[0] < whole - 0.02
    assert world.slack[1:] == [0.0] * 3


def test_a_carriage_stops_at_the_end_of_its_rail_and_comes_back(
    machine: Machine, plant: Plant
) -> None:
    world = PlanarPlant(machine, plant, Push((0.0, 0.0)), CENTRE, [0.01, 0.23, 0.35, 0.23])
    for _ in range(200):
        world.advance([0.015] * 4, [-60.0, 0.0, 0.0, 0.0])
    assert world.rails[0] == 0.0
    held = world.tensions[0]
    assert held == pytest.approx(3.0, abs=0.5)
    for _ in range(50):
        world.advance([0.015] * 4, [20.0, 0.0, 0.0, 0.0])
    assert world.rails[0] > 0.005


def test_dry_friction_holds_until_it_is_overcome() -> None:
    friction = Friction(dry=0.5, damping=0.0)
    friction.slide(0.1 * PRESLIDING)
    assert 0.0 < friction.force(0.0) < 0.05
    friction.slide(1.0)
    assert friction.force(0.0) == pytest.approx(0.5)
    friction.slide(-1.0)
    assert friction.force(0.0) == pytest.approx(-0.5)


def test_the_force_of_the_hand_balances_cables_and_handle(machine: Machine, plant: Plant) -> None:
    path = Path(CENTRE, rest=0.01)
    path.move((0.40, 0.26), 0.4)
    world = PlanarPlant(machine, plant, Hand(plant, path), CENTRE, [*CENTRE, *CENTRE])
    for _ in range(100):
        before = world.velocity
        world.advance([0.015] * 4, [0.0] * 4)
    # The forces shown are those of the last substep, the change of speed is that of the cycle.
    change = np.subtract(world.velocity, before) * machine.control.rate * plant.handle_mass
    np.testing.assert_allclose(np.add(world.hand_force, world.cable_force), change, atol=0.02)
    assert hypot(*world.hand_force) > 0.3


def test_the_hand_moves_smoothly_from_point_to_point() -> None:
    path = Path((0.0, 0.0), rest=0.1)
    path.move((0.3, -0.1), 0.5)
    path.rest(0.2)
    assert path.end == pytest.approx(0.8) and path.goal == (0.3, -0.1)
    assert path.at(-1.0) == path.at(0.05) == ((0.0, 0.0), (0.0, 0.0), (0.0, 0.0))
    position, velocity, acceleration = path.at(0.35)
    assert position == pytest.approx((0.15, -0.05)) and acceleration == pytest.approx((0.0, 0.0))
    assert velocity == pytest.approx((1.875 * 0.3 / 0.5, -1.875 * 0.1 / 0.5))
    step = 1e-6
    for time in (0.15, 0.2, 0.4, 0.55):
        ahead, behind = path.at(time + step), path.at(time - step)
        for order in (0, 1):
            slope = np.subtract(ahead[order], behind[order]) / (2 * step)
            np.testing.assert_allclose(slope, path.at(time)[order + 1], rtol=1e-5, atol=1e-6)
    assert path.at(9.0)[0] == (0.3, -0.1)
