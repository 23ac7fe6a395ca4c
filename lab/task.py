"""What the hand and the application do on the bench: a tour of what a haptic machine is for.

In this order: the cables are tensioned; the hand moves over the whole target, corner by corner; it
holds the centre while the application turns a force once around; it presses into every wall and
holds there.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import cos, dist, pi, sin

import numpy as np
from numpy.typing import NDArray

from turnbuckle.lab.hand import Path, least_jerk
from turnbuckle.model.base import Coordinates
from turnbuckle.model.machine import Machine, Plant, Wall
from turnbuckle.model.problem import MachineError, Problem

Capability = Callable[[NDArray[np.float64]], NDArray[np.float64]]
"""Force [N] (k) that the machine has in every direction at positions [m] (k, 2), 0 if none."""

TENSIONING = 0.3
"""Time [s] for the gate to let the torques rise, before anything is asked of the machine."""
MEAN_SPEED = 0.35
"""Speed of the hand between the corners [m/s], on average."""
SHORTEST = 0.5
"""A movement takes at least so long [s]."""
TURN = 2.0
"""Time in which the application's force turns once around [s]."""
CORNERS = ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))
WANDERED = 0.8
"""Share of the tour that a wandering hand covers."""
CLEARANCE = 0.01
"""Distance kept from the walls while not pressing [m]."""
PRESS = 0.8
"""Time to press into a wall, to hold, and to let go, each [s]."""
SHARE = 0.7
"""Share that is asked of the force that is wanted and possible."""
RESERVE = 0.1
"""Share of the wanted force that the machine must have wherever the hand goes."""


@dataclass(frozen=True)
class Phase:
    """A stretch of the task that is looked at on its own; times in s."""

    name: str
    begin: float
    end: float


@dataclass(frozen=True)
class Task:
    """A path for the hand, a force for the application, and what was left out and why."""

    path: Path
    round_trip: Path
    """From the start of the path through the target and back: where a hand wanders."""
    phases: tuple[Phase, ...]
    turning_force: float  # N
    notes: tuple[str, ...]

    def phase(self, name: str) -> Phase:
        """The phase of that name."""
        return next(phase for phase in self.phases if phase.name == name)

    @property
    def wall_phases(self) -> tuple[Phase, ...]:
        """The phases in which the hand rests against a wall."""
        return tuple(phase for phase in self.phases if phase.name.startswith("wall "))

    def force(self, time: float) -> Coordinates:
        """Force [N] that the application wants at `time` [s]."""
        turn = self.phase("turn")
        u = (time - turn.begin) / (turn.end - turn.begin)
        if not 0.0 <= u <= 1.0:
            return 0.0, 0.0
        size = self.turning_force * least_jerk(min(u, 1.0 - u, 0.1) / 0.1)
        return size * cos(2 * pi * u), size * sin(2 * pi * u)


class Planner:
    """Plans the task of one machine; `capability` tells what the machine can do where.

    Raises MachineError when the machine cannot hold the handle at the target's centre.
    """

    def __init__(self, machine: Machine, plant: Plant, capability: Capability) -> None:
        self._machine = machine
        self._plant = plant
        self._capability = capability
        x, y = machine.target.centre
        self._centre = self._cleared((x, y))
        self._path = Path(self._centre, rest=TENSIONING)
        self._phases: list[Phase] = []
        self._notes: list[str] = []

    def plan(self) -> Task:
        """Plan the whole task."""
        self._note_phase("tensioning", 0.0)
        self._tour_target()
        self._path.rest(TURN)
        self._note_phase("turn", self._path.end - TURN)
        for wall in self._machine.walls:
            self._press(wall)
        force = SHARE * self._possible(self._centre)
        return Task(self._path, self._wander(), tuple(self._phases), force, tuple(self._notes))

    def _note_phase(self, name: str, begin: float) -> None:
        """A phase from `begin` to the end of what is planned so far."""
        self._phases.append(Phase(name, begin, self._path.end))

    def _go(self, target: Coordinates) -> None:
        self._path.move(target, max(SHORTEST, dist(self._path.goal, target) / MEAN_SPEED))

    def _wander(self) -> Path:
        """Corner by corner, not as far as the tour."""
        path = Path(self._centre, rest=0.0)
        for sign in (*CORNERS, (0, 0)):
            target = self._cleared(self._target_point(WANDERED * self._reachable_share(), sign))
            path.move(target, max(SHORTEST, dist(path.goal, target) / MEAN_SPEED))
        return path

    def _tour_target(self) -> None:
        share = self._reachable_share()
        if share < 1.0:
            self._notes.append(
                f"the path covers {share:.0%} of the target about its centre: beyond it the cables"
                f" have less than {RESERVE * self._machine.target.force:.2g} N in some direction"
            )
        corners = [self._target_point(share, sign) for sign in CORNERS]
        for point in [*corners, self._centre]:
            self._go(self._cleared(point))
        self._note_phase("tour", TENSIONING)

    def _press(self, wall: Wall) -> None:
        """Press as hard as is asked, then come back to the centre."""
        before = self._cleared(_moved(self._centre, wall, -_height(self._centre, wall)))
        foot = _moved(before, wall, -_height(before, wall))
        force = SHARE * self._possible(foot)
        if force < SHARE * RESERVE * self._machine.target.force:
            self._notes.append(f"wall {wall.name} is not pressed: the cables have no force there")
            return
        depth = force * (1.0 / wall.stiffness + 1.0 / self._plant.hand_stiffness)
        self._go(before)
        self._path.move(_moved(foot, wall, -depth), PRESS)
        self._path.rest(PRESS)
        self._note_phase(f"wall {wall.name}", self._path.end - PRESS)
        self._path.move(before, PRESS)
        self._go(self._centre)

    def _possible(self, position: Coordinates) -> float:
        """Force [N] to ask for at a position: what is wanted, if the machine has it."""
        return min(self._machine.target.force, float(self._capability(np.array([position]))[0]))

    def _reachable_share(self) -> float:
        """Largest share of the target, about its centre, where the machine has its reserve."""
        unit = [(float(x), float(y)) for x in np.linspace(-1, 1, 9) for y in np.linspace(-1, 1, 9)]
        for share in np.linspace(1.0, 0.01, 100):
            grid = [self._cleared(self._target_point(float(share), sign)) for sign in unit]
            if self._capability(np.array(grid)).min() >= RESERVE * self._machine.target.force:
                return float(share)
        x, y = self._centre
        found = f"({x:g} m, {y:g} m), where the cables cannot hold the handle"
        allowed = "for a run on the bench, a centre inside the wrench-feasible workspace"
        raise MachineError(self._machine.path, [Problem("target.centre", found, allowed)])

    def _target_point(self, share: float, sign: Coordinates) -> Coordinates:
        (x, y), (width, height) = self._machine.target.centre, self._machine.target.size
        return x + 0.5 * share * sign[0] * width, y + 0.5 * share * sign[1] * height

    def _cleared(self, point: Coordinates) -> Coordinates:
        """The point, moved out of the walls."""
        for wall in self._machine.walls:
            point = _moved(point, wall, max(0.0, CLEARANCE - _height(point, wall)))
        return point


def _height(point: Coordinates, wall: Wall) -> float:
    """Height of a point over the wall [m], negative inside it."""
    return (point[0] - wall.point[0]) * wall.normal[0] + (point[1] - wall.point[1]) * wall.normal[1]


def _moved(point: Coordinates, wall: Wall, distance: float) -> Coordinates:
    """The point moved along the wall's normal [m]."""
    return point[0] + distance * wall.normal[0], point[1] + distance * wall.normal[1]
