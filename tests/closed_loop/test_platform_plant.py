"""The plant of every kind against the planar one, and against physics that is known without it."""

import numpy as np
import pytest
import variants
from scipy.spatial.transform import Rotation

from turnbuckle.lab import planar_plant, platform_plant
from turnbuckle.lab.hand import Hand, hand_of
from turnbuckle.lab.hand import Path as Way
from turnbuckle.lab.planar_plant import PlanarPlant
from turnbuckle.lab.plant import SimulatedPlant
from turnbuckle.lab.plants import plant_model
from turnbuckle.lab.platform_plant import PlatformPlant
from turnbuckle.model.base import Coordinates
from turnbuckle.model.machine import Machine, Plant
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.control import base_targets
from turnbuckle.model.reference.kinematics import cable_lengths, structure_matrix

CENTRE = (0.3559, 0.2309)
STOCK = sorted((variants.ROOT / "machines").glob("*.toml"))
SEEN = ("position", "velocity", "cable_force", "hand_force", "lengths", "rails", "tensions")
KINDS = [
    "yoon_synchronised",
    "three_base_equilateral",
    "planar_rigid",
    "brau_tetrahedron",
    "spidar_g",
]


class Push:
    """A holder without mass who pushes with a constant wrench."""

    mass = 0.0

    def __init__(self, wrench: Coordinates) -> None:
        self._wrench = wrench

    def push(self, time: float, pose: Coordinates, twist: Coordinates) -> Coordinates:
        """The wrench [N, N m]."""
        return self._wrench


def stock(name: str) -> Machine:
    """A stock machine."""
    return load_machine(variants.ROOT / "machines" / f"{name}.toml")


def frictionless(machine: Machine) -> Plant:
    """A machine's physics, or that of another, without any friction."""
    plant = machine.plant or stock("yoon_synchronised").plant
    assert plant is not None
    return plant.model_copy(update={name: 0.0 for name in Plant.model_fields if "friction" in name})


def both(rails: list[float]) -> tuple[SimulatedPlant, SimulatedPlant]:
    """The stock machine on either plant, in a hand that moves."""
    machine = stock("yoon2023")
    assert machine.plant is not None
    path = Way(CENTRE, 0.05)
    path.move((0.5, 0.3), 0.3)
    path.move((0.2, 0.1), 0.3)
    hands = Hand(machine.plant, path), Hand(machine.plant, path)
    return (
        PlanarPlant(machine, machine.plant, hands[0], CENTRE, rails),
        PlatformPlant(machine, machine.plant, hands[1], CENTRE, rails),
    )


def difference(one: SimulatedPlant, other: SimulatedPlant) -> float:
    """Largest difference of what is seen of two plants, as a share of the size of each."""
    shares = []
    for name in SEEN:
        a, b = (np.array(getattr(plant, name)) for plant in (one, other))
        shares.append(float(np.abs(a - b).max() / max(np.abs(a).max(), 1e-3)))
    return max(shares)


def turned_torques(cycle: int, size: float = 0.02) -> list[float]:
    """Torques [N m] that go up and down, each at its time."""
    return [size * (1.5 + np.sin(motor + cycle / 30.0)) for motor in range(4)]


def test_on_a_point_in_the_plane_both_plants_move_alike_to_rounding() -> None:
    # Also against the ends of rails, where carriages stop and are held.
    plants = both([0.02, 0.23, 0.35, 0.23])
    largest = 0.0
    for cycle in range(400):
        forces = [-30.0 if cycle < 100 else 12.0, *(8.0 * np.cos(np.arange(3) + cycle / 100.0))]
        for plant in plants:
            plant.advance(turned_torques(cycle), forces)
        largest = max(largest, difference(*plants))
    assert plants[0].rails[0] > 0.02
    assert largest < 1e-9


def test_slack_broken_and_hooked_cables_are_alike_too() -> None:
    # A jerk of the planar plant is solved where the step began: the plants differ by its length.
    plants = both([*CENTRE, *CENTRE])
    largest, loose = 0.0, 0
    for cycle in range(500):
        for plant in plants:
            if cycle == 250:
                plant.hook_cable(2, 0.02)
            if cycle == 400:
                plant.break_cable(0)
            plant.advance(turned_torques(cycle, 0.015 * (cycle % 100 > 30)), [0.0] * 4)
        loose += plants[0].slack[1] > 0.0
        largest = max(largest, difference(*plants))
    assert loose > 10 and plants[1].tensions[0] == 0.0
    assert largest < 1e-4


def test_another_mass_of_the_handle_is_noticed() -> None:
    # Negative control.
    plants = both([*CENTRE, *CENTRE])
    vars(plants[1])["_masses"][0, 0] *= 1.001
    for cycle in range(100):
        for plant in plants:
            plant.advance(turned_torques(cycle), [0.0] * 4)
    assert difference(*plants) > 1e-6


@pytest.mark.parametrize("name", KINDS)
def test_work_becomes_kinetic_energy_when_there_is_no_friction(name: str) -> None:
    machine = stock(name)
    plant, (d, n, m) = frictionless(machine), (machine.dof, len(machine.cables), len(machine.rails))
    turns = [0.1, -0.05, 0.08][: d - machine.space]
    pose = (*machine.target.centre, *turns)
    push = np.array([0.8, -0.5, 0.3][: machine.space] + [0.02, -0.01, 0.03][: len(turns)])
    torques, forces = np.linspace(0.018, 0.022, n), np.linspace(-1.0, 1.5, m)
    rails = base_targets(machine, pose).tolist()
    world = PlatformPlant(machine, plant, Push(tuple(push)), pose, rails)
    first = np.array(world.lengths), np.array(world.rails)
    work: float = 0.0
    before = np.zeros(d)
    for _ in range(100):
        last = np.array(world.lengths), np.array(world.rails)
        world.advance(torques.tolist(), forces.tolist())
        twist = np.array(world.velocity)
        work += float(push @ (before + twist)) / 2 / machine.control.rate
        before = twist
    rate = machine.control.rate
    rates, speeds = (np.subtract(world.lengths, last[0]), np.subtract(world.rails, last[1]))
    winding = machine.cable_motor.inertia / machine.drum.radius**2
    shares = np.array([1.0] * machine.space + [machine.lever**2] * len(turns))
    kinetic = float(plant.handle_mass * shares @ twist**2 + winding * np.sum((rates * rate) ** 2))
    carriages = np.array([len(rail.cables) for rail in machine.rails]) * (plant.carriage_mass or 0)
    kinetic = 0.5 * (kinetic + float(carriages @ (speeds * rate) ** 2))
    work += float(torques @ (first[0] - world.lengths)) / machine.drum.radius
    work += float(forces @ (np.array(world.rails) - first[1]))
    assert kinetic == pytest.approx(work, rel=0.03) and work > 1e-3


@pytest.mark.parametrize("name", KINDS)
def test_lengths_and_wrench_are_those_of_the_reference(name: str) -> None:
    machine = stock(name)
    turns = [0.2, -0.1, 0.15][: machine.dof - machine.space]
    pose = (*machine.target.centre, *turns)
    rails = base_targets(machine, pose).tolist()
    path = Way(pose, rest=1.0)
    plant = frictionless(machine)
    world = PlatformPlant(machine, plant, hand_of(machine, plant, path), pose, rails)
    torques = np.linspace(0.01, 0.02, len(machine.cables)).tolist()
    for _ in range(30):
        world.advance(torques, [0.0] * len(rails))
    expected = cable_lengths(machine, world.position, world.rails)
    np.testing.assert_allclose(world.lengths, expected, rtol=1e-12)
    structure = structure_matrix(machine, world.position, world.rails)
    wrench = structure @ np.array(world.tensions)
    np.testing.assert_allclose(world.cable_force, wrench, atol=1e-3 * np.abs(wrench).max())


def test_a_hand_leads_a_platform_by_springs_along_the_shortest_turn() -> None:
    machine = stock("spidar_g")
    assert machine.plant is not None
    goal = (0.32, 0.29, 0.31, 0.1, -0.15, 0.05)
    path = Way((0.3, 0.3, 0.3, 0.0, 0.0, 0.0), rest=0.02)
    path.move(goal, 0.3)
    hand = hand_of(machine, machine.plant, path)
    world = PlatformPlant(machine, machine.plant, hand, path.at(0.0)[0], [])
    for _ in range(600):
        world.advance([0.004] * 8, [])
    assert np.abs(np.subtract(world.position, goal)).max() < 0.02
    assert min(world.tensions) > 0.5 and world.slack == [0.0] * 8
    here, there = (Rotation.from_rotvec(pose[3:]) for pose in (world.position, goal))
    way = [*np.subtract(goal, world.position)[:3], *(there * here.inv()).as_rotvec()]
    shares = np.array([1.0] * 3 + [machine.lever**2] * 3)
    spring, damper = machine.plant.hand_stiffness * shares, machine.plant.hand_damping * shares
    muscles = spring * way - damper * world.velocity
    assert np.abs(way[3:]).min() > 1e-3
    np.testing.assert_allclose(
        hand.push(world.time, world.position, world.velocity), muscles, rtol=1e-9
    )


def test_the_fast_plant_is_for_points_in_the_plane_and_the_other_for_all() -> None:
    for path in STOCK:
        machine = load_machine(path)
        fast = planar_plant.refusal(machine) is None
        assert plant_model(machine).make is (PlanarPlant if fast else PlatformPlant)
        assert platform_plant.refusal(machine) is None
    assert planar_plant.refusal(stock("yoon2023")) is None
    for name in KINDS:
        assert planar_plant.refusal(stock(name)) is not None
