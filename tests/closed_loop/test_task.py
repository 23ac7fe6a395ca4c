"""What the bench asks of a machine: only what it can do, and a word about the rest."""

from math import dist

import numpy as np
import pytest
from numpy.typing import NDArray
from variants import STOCK

from turnbuckle.lab.summary import penetration
from turnbuckle.lab.task import CLEARANCE, RESERVE, SHARE, Capability, Planner, Task
from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import MachineError
from turnbuckle.model.reading import load_machine


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
