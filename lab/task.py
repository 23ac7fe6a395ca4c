"""What the hand and the application do on the bench: a tour of what a haptic machine is for.

In this order: the cables are tensioned; the hand moves over the whole target, corner by corner, and
turns a platform that can turn either way about every axis; it holds the centre while the
application turns a force once around in every plane of the axes, and a moment once up and down
about every axis; it presses into every wall and holds there.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations, product
from math import comb, cos, dist, pi, sin

import numpy as np
from numpy.typing import NDArray

from turnbuckle.lab.hand import Path, least_jerk
from turnbuckle.lab.led_platform import wandering
from turnbuckle.model.base import Coordinates
from turnbuckle.model.machine import Machine, Plant, Wall
from turnbuckle.model.problem import MachineError, Problem

Capability = Callable[[NDArray[np.float64]], NDArray[np.float64]]
"""Force [N] (k) that the machine has in every direction at poses (k, d) [m, rad], 0 if none."""

TENSIONING = 0.3
"""Time [s] for the gate to let the torques rise, before anything is asked of the machine."""
MEAN_SPEED = 0.35
"""Speed of the hand between the corners [m/s], on average."""
SHORTEST = 0.5
"""A movement takes at least so long [s]."""
MEAN_TURN = 1.0
"""Speed at which the hand turns a platform [rad/s], on average."""
TURN = 2.0
"""Time in which the application's force turns once around, or its moment goes up and down [s]."""
CORNERS = {
    1: ((-1,), (1,), (-1,)),
    2: ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)),
    3: (
        *((-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1)),
        *((-1, 1, 1), (1, 1, 1), (1, -1, 1), (-1, -1, 1), (-1, -1, -1)),
    ),
}
"""A way around the target along its edges, by the dimension of the space."""
GRID = {1: 9, 2: 9, 3: 5}
"""Poses a side at which the machine must have its reserve, by the dimension of the space."""
WANDERED = 0.8
"""Share of the tour that a wandering hand covers."""
WANDERING = 60
"""Legs of a round trip of a platform that turns: more than a calibration looks at."""
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
    space: int
    dof: int
    turning_force: float  # N
    turning_moment: float  # N m
    notes: tuple[str, ...]

    def phase(self, name: str) -> Phase:
        """The phase of that name."""
        return next(phase for phase in self.phases if phase.name == name)

    @property
    def wall_phases(self) -> tuple[Phase, ...]:
        """The phases in which the hand rests against a wall."""
        return tuple(phase for phase in self.phases if phase.name.startswith("wall "))

    def force(self, time: float) -> Coordinates:
        """Wrench (d) [N, N m] that the application wants at `time` [s]."""
        turn = self.phase("turn")
        wrench = [0.0] * self.dof
        number, u = divmod((time - turn.begin) / TURN, 1.0)
        planes = list(combinations(range(self.space), 2))
        moments = range(self.space, self.dof)
        if not 0.0 <= number < len(planes) + len(moments):
            return tuple(wrench)
        if number < len(planes):
            first, second = planes[int(number)]
            size = self.turning_force * least_jerk(min(u, 1.0 - u, 0.1) / 0.1)
            wrench[first], wrench[second] = size * cos(2 * pi * u), size * sin(2 * pi * u)
        else:
            wrench[moments[int(number) - len(planes)]] = self.turning_moment * sin(2 * pi * u)
        return tuple(wrench)


class Planner:
    """Plans the task of one machine; `capability` tells what the machine can do where.

    Raises MachineError when the machine cannot hold the handle at the target's centre.
    """

    def __init__(self, machine: Machine, plant: Plant, capability: Capability) -> None:
        self._machine = machine
        self._plant = plant
        self._capability = capability
        self._space, self._turns = machine.space, machine.dof - machine.space
        self._corners = CORNERS[machine.space]
        self._centre = self._cleared((*machine.target.centre, *[0.0] * self._turns))
        self._path = Path(self._centre, rest=TENSIONING)
        self._phases: list[Phase] = []
        self._notes: list[str] = []

    def plan(self) -> Task:
        """Plan the whole task."""
        self._note_phase("tensioning", 0.0)
        self._tour_target()
        turning = TURN * (comb(self._space, 2) + self._turns)
        self._path.rest(turning)
        self._note_phase("turn", self._path.end - turning)
        for wall in self._machine.walls:
            self._press(wall)
        force = SHARE * self._possible(self._centre)
        moment = force / self._machine.target.force * self._machine.target.moment
        return Task(
            self._path,
            self._wander(),
            tuple(self._phases),
            self._space,
            self._machine.dof,
            force,
            moment,
            tuple(self._notes),
        )

    def _note_phase(self, name: str, begin: float) -> None:
        """A phase from `begin` to the end of what is planned so far."""
        self._phases.append(Phase(name, begin, self._path.end))

    def _go(self, target: Coordinates) -> None:
        self._path.move(target, self._duration(self._path.goal, target))

    def _duration(self, start: Coordinates, end: Coordinates) -> float:
        """Time for a movement between poses [s]."""
        space = self._space
        way, turn = dist(start[:space], end[:space]), dist(start[space:], end[space:])
        return max(SHORTEST, way / MEAN_SPEED, turn / MEAN_TURN)

    def _wander(self) -> Path:
        """Corner by corner, not as far as the tour; a platform that turns, to ever other poses."""
        path = Path(self._centre, rest=0.0)
        if self._turns:
            lead = wandering(self._machine, WANDERED)
            poses = [tuple(lead(SHORTEST * leg).tolist()) for leg in range(1, WANDERING)]
        else:
            share = WANDERED * self._reachable_share()
            poses = [self._target_pose(share, sign) for sign in self._corners]
        for pose in [*poses, self._centre]:
            target = self._cleared(pose)
            path.move(target, self._duration(path.goal, target))
        return path

    def _tour_target(self) -> None:
        share = self._reachable_share()
        if share < 1.0:
            self._notes.append(
                f"the path covers {share:.0%} of the target about its centre: beyond it the cables"
                f" have less than {RESERVE * self._machine.target.force:.2g} N in some direction"
            )
        corners = [self._target_pose(share, sign) for sign in self._corners]
        for pose in [*corners, self._centre, *self._turned(share)]:
            self._go(self._cleared(pose))
        if self._turns:
            self._go(self._centre)
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

    def _possible(self, pose: Coordinates) -> float:
        """Force [N] to ask for at a pose: what is wanted, if the machine has it."""
        return min(self._machine.target.force, float(self._capability(np.array([pose]))[0]))

    def _reachable_share(self) -> float:
        """Largest share of the target, about its centre, where the machine has its reserve."""
        sides = np.linspace(-1, 1, GRID[self._space]).tolist()
        unit = list(product(sides, repeat=self._space))
        for share in np.linspace(1.0, 0.01, 100).tolist():
            grid = [self._cleared(self._target_pose(share, sign)) for sign in unit]
            grid += self._turned(share)
            if self._capability(np.array(grid)).min() >= RESERVE * self._machine.target.force:
                return float(share)
        centre = ", ".join(f"{x:g} m" for x in self._centre[: self._space])
        found = f"({centre}), where the cables cannot hold the handle"
        allowed = "for a run on the bench, a centre inside the wrench-feasible workspace"
        raise MachineError(self._machine.path, [Problem("target.centre", found, allowed)])

    def _target_pose(self, share: float, sign: Sequence[float]) -> Coordinates:
        """Where in the target, upright."""
        sides = zip(self._machine.target.centre, sign, self._machine.target.size, strict=True)
        point = [middle + 0.5 * share * way * side for middle, way, side in sides]
        return (*point, *[0.0] * self._turns)

    def _turned(self, share: float) -> list[Coordinates]:
        """At the centre, turned either way about every axis."""
        angle = share * self._machine.target.rotation
        poses = []
        for number, way in product(range(self._turns), (-1.0, 1.0)):
            turns = tuple(way * angle if k == number else 0.0 for k in range(self._turns))
            poses.append((*self._centre[: self._space], *turns))
        return poses

    def _cleared(self, pose: Coordinates) -> Coordinates:
        """The pose, moved out of the walls."""
        for wall in self._machine.walls:
            pose = _moved(pose, wall, max(0.0, CLEARANCE - _height(pose, wall)))
        return pose


def _height(pose: Coordinates, wall: Wall) -> float:
    """Height of a pose over the wall [m], negative inside it."""
    axes = zip(pose, wall.point, wall.normal, strict=False)
    return sum((x - point) * normal for x, point, normal in axes)


def _moved(pose: Coordinates, wall: Wall, distance: float) -> Coordinates:
    """The pose moved along the wall's normal [m]."""
    point = [x + distance * normal for x, normal in zip(pose, wall.normal, strict=False)]
    return (*point, *pose[len(point) :])
