"""What the bench asks of a machine: only what it can do, and a word about the rest."""

from collections.abc import Sequence
from math import dist

import numpy as np
import pytest
from numpy.typing import NDArray
from variants import ROOT, STOCK

from turnbuckle.lab.led_platform import wandering
from turnbuckle.lab.summary import penetration
from turnbuckle.lab.task import CLEARANCE, RESERVE, SHARE, Capability, Planner, Task
from turnbuckle.model.base import Coordinates
from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import MachineError
from turnbuckle.model.reading import load_machine
from turnbuckle.model.reference.kinematics import length_jacobian


@pytest.fixture
def machine() -> Machine:
    """The stock machine."""
    return load_machine(STOCK)


def everywhere(force: float) -> Capability:
    """A machine with the same force wherever it is asked."""
    return lambda positions: np.full(len(positions), force)


def within(machine: Machine, radius: float) -> Capability:
    """A machine that can do what is wanted within a radius of the centre, and nothing beyond."""
    centre, force = machine.target.centre, machine.target.force

    def capability(positions: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.array([force if dist(point, centre) < radius else 0.0 for point in positions])

    return capability


def plan(machine: Machine, capability: Capability) -> Task:
    """The task of a machine."""
    assert machine.plant is not None
    return Planner(machine, machine.plant, capability).plan()


def positions(task: Task, name: str) -> NDArray[np.float64]:
    """Where the hand goes in a phase (k, 2) [m]."""
    phase = task.phase(name)
    return np.array([task.path.at(t)[0] for t in np.linspace(phase.begin, phase.end, 2000)])


def test_a_capable_machine_is_taken_to_the_corners_of_its_target(machine: Machine) -> None:
    free = machine.model_copy(update={"walls": ()})
    task = plan(free, everywhere(7.0))
    assert task.notes == ()
    low, high = positions(task, "tour").min(axis=0), positions(task, "tour").max(axis=0)
    np.testing.assert_allclose(high - low, free.target.size, rtol=1e-5)
    np.testing.assert_allclose((high + low) / 2, free.target.centre, rtol=1e-5)


def test_the_tour_keeps_clear_of_the_walls(machine: Machine) -> None:
    depth = penetration(machine, positions(plan(machine, everywhere(7.0)), "tour"))
    assert depth.max() <= -CLEARANCE + 1e-9


def test_a_weak_machine_is_taken_only_where_it_is_able_and_the_task_says_so(
    machine: Machine,
) -> None:
    task = plan(machine, within(machine, 0.1))
    assert "of the target about its centre" in task.notes[0]
    far = np.linalg.norm(positions(task, "tour") - machine.target.centre, axis=1).max()
    assert 0.09 < far < 0.1


def test_every_wall_is_pressed_with_the_share_of_force_that_is_asked(machine: Machine) -> None:
    task = plan(machine, everywhere(7.0))
    assert [phase.name for phase in task.wall_phases] == ["wall right", "wall top"]
    for wall, phase in zip(machine.walls, task.wall_phases, strict=True):
        goal, velocity, _ = task.path.at(phase.begin + 1e-6)
        depth = np.dot(np.subtract(wall.point, goal), wall.normal)
        series = 1 / wall.stiffness + 1 / machine.plant.hand_stiffness  # type: ignore[union-attr]
        assert depth / series == pytest.approx(SHARE * 7.0)
        assert velocity == (0.0, 0.0)


def test_a_wall_out_of_reach_is_left_out_and_named(machine: Machine) -> None:
    task = plan(machine, within(machine, 0.15))
    assert [phase.name for phase in task.wall_phases] == ["wall top"]
    assert any("wall right is not pressed" in note for note in task.notes)


def test_the_applications_force_turns_once_around_and_starts_softly(machine: Machine) -> None:
    task = plan(machine, everywhere(5.0))
    turn = task.phase("turn")
    times = np.linspace(turn.begin - 0.1, turn.end + 0.1, 4000)
    forces = np.array([task.force(time) for time in times])
    assert np.linalg.norm(forces, axis=1).max() == pytest.approx(SHARE * 5.0)
    assert (forces[times < turn.begin] == 0).all() and (forces[times > turn.end] == 0).all()
    assert np.abs(np.diff(forces, axis=0)).max() < 0.05
    strong = forces[np.linalg.norm(forces, axis=1) > 0.99 * SHARE * 5.0]
    assert {(x > 0, y > 0) for x, y in strong} == {
        (True, True),
        (True, False),
        (False, True),
        (False, False),
    }


def test_a_machine_that_cannot_hold_its_centre_is_refused(machine: Machine) -> None:
    with pytest.raises(MachineError, match=r"target\.centre: found .* cannot hold the handle"):
        plan(machine, everywhere(0.5 * RESERVE * machine.target.force))


def uncertainty(machine: Machine, poses: Sequence[Coordinates]) -> float:
    """Of the least certain zero over that of a length, from poses that nobody knows."""
    normal = np.zeros((len(machine.cables),) * 2)
    for pose in poses:
        jacobian = length_jacobian(machine, np.array(pose), [])
        normal += np.eye(len(normal)) - jacobian @ np.linalg.pinv(jacobian)
    return float(1.0 / np.sqrt(np.linalg.eigvalsh(normal)[0]))


def test_a_hand_that_wanders_turns_a_platform_enough_to_find_the_cables_zeros() -> None:
    # The calibration refuses more than 8; friction and the hand's own springs take a part of the
    # rotation, so that the path has to be better than that.
    machine = load_machine(ROOT / "machines" / "spidar_g.toml")
    trip = plan(machine, everywhere(2.0)).round_trip
    times = [0.3 * number for number in range(1, machine.calibration.samples + 1)]
    assert uncertainty(machine, [trip.at(time)[0] for time in times]) < 5.0
    narrow = wandering(machine, 0.6)  # negative control: as far as a platform without friction
    assert uncertainty(machine, [tuple(narrow(time)) for time in times]) > 5.0


def test_a_platform_in_space_is_taken_to_all_corners_and_turned_about_all_axes() -> None:
    machine = load_machine(ROOT / "machines" / "spidar_g.toml")
    task = plan(machine, everywhere(2.0))
    way = positions(task, "tour")
    reach = [*np.array(machine.target.size) / 2, *[machine.target.rotation] * 3]
    np.testing.assert_allclose(np.ptp(way, axis=0) / 2, reach, rtol=1e-3)
    corners = {tuple(np.sign(p[:3] - machine.target.centre).astype(int)) for p in way}
    assert len([corner for corner in corners if 0 not in corner]) == 8
    turn = task.phase("turn")
    wrenches = np.array([task.force(t) for t in np.linspace(turn.begin, turn.end, 1201)])
    peaks = np.abs(wrenches).max(axis=0)
    np.testing.assert_allclose(peaks[:3], SHARE * machine.target.force, rtol=1e-3)
    np.testing.assert_allclose(peaks[3:], SHARE * machine.target.moment, rtol=1e-3)
    assert (np.abs(wrenches[:, :3]).max(axis=1) * np.abs(wrenches[:, 3:]).max(axis=1) < 1e-9).all()
