"""A hand that leads the handle along a path: mass, spring and damper about a smooth movement.

The movement from point to point is the one of least jerk (Flash and Hogan 1985), as people move:
s(u) = 10 u^3 - 15 u^4 + 6 u^5. The person knows the weight of the own arm, so what is left for
spring and damper to carry is the device:

    force on the handle = k (x_d - x) + b (v_d - v) + m (a_d - a)
"""

from bisect import bisect_right
from dataclasses import dataclass

from turnbuckle.lab import turning
from turnbuckle.lab.plant import Holder
from turnbuckle.model.base import Coordinates
from turnbuckle.model.machine import Machine, Plant


def least_jerk(u: float) -> float:
    """Share of a movement done when the share u in [0, 1] of its time is over."""
    return u * u * u * (10.0 + u * (6.0 * u - 15.0))


@dataclass(frozen=True, slots=True)
class Leg:
    """One movement, from the pose `start` to `end` (d) [m, rad], in `duration` [s] from the time
    `begin` [s]."""

    begin: float
    duration: float
    start: Coordinates
    end: Coordinates

    def at(self, time: float) -> tuple[Coordinates, Coordinates, Coordinates]:
        """Position [m], velocity [m/s] and acceleration [m/s^2]; at rest outside the leg."""
        u = min(max((time - self.begin) / self.duration, 0.0), 1.0)
        share = least_jerk(u)
        slope = 30.0 * u * u * (1.0 - u) * (1.0 - u) / self.duration
        bend = 60.0 * u * (1.0 - u) * (1.0 - 2.0 * u) / (self.duration * self.duration)
        pose, rate, acceleration = [], [], []
        for start, end in zip(self.start, self.end, strict=True):
            way = end - start
            pose.append(start + share * way)
            rate.append(slope * way)
            acceleration.append(bend * way)
        return tuple(pose), tuple(rate), tuple(acceleration)


class Path:
    """Movements one after the other; before the first and after the last the hand rests."""

    def __init__(self, start: Coordinates, rest: float) -> None:
        """Begin at `start` [m] and rest there for `rest` [s]."""
        self._legs = [Leg(0.0, rest, start, start)]
        self._begins = [0.0]

    @property
    def end(self) -> float:
        """Time at which the last movement ends [s]."""
        return self._legs[-1].begin + self._legs[-1].duration

    @property
    def goal(self) -> Coordinates:
        """Where the last movement ends [m]."""
        return self._legs[-1].end

    def move(self, target: Coordinates, duration: float) -> None:
        """Then go to `target` [m] in `duration` [s]."""
        begin, start = self.end, self.goal
        self._begins.append(begin)
        self._legs.append(Leg(begin, duration, start, target))

    def rest(self, duration: float) -> None:
        """Then stay for `duration` [s]."""
        self.move(self.goal, duration)

    def at(self, time: float) -> tuple[Coordinates, Coordinates, Coordinates]:
        """Position [m], velocity [m/s] and acceleration [m/s^2] that the hand wants."""
        return self._legs[max(bisect_right(self._begins, time) - 1, 0)].at(time)


class Cue:
    """A path that is not followed before its cue: until then the hand stays at its start, or
    wanders from there and back."""

    def __init__(self, path: Path, round_trip: Path | None = None) -> None:
        """round_trip: where the hand wanders."""
        self._path, self._round_trip = path, round_trip or path
        self._begun: float | None = None
        self._wandered: float | None = None
        self._repeats = False

    def wander(self, time: float) -> None:
        """From `time` [s] on the hand wanders, over and over."""
        if self._wandered is None:
            self._wandered = time

    def begin(self, time: float, repeat: bool = False) -> None:
        """The cue, at `time` [s], for once or over and over; a second one changes nothing. A hand
        that wanders comes back first."""
        if self._begun is None:
            away = 0.0 if self._wandered is None else -(time - self._wandered)
            self._begun, self._repeats = time + away % self._round_trip.end, repeat

    def elapsed(self, time: float) -> float:
        """Time on the path [s]; 0 before the cue."""
        since = 0.0 if self._begun is None else max(0.0, time - self._begun)
        return since % self._path.end if self._repeats else since

    def at(self, time: float) -> tuple[Coordinates, Coordinates, Coordinates]:
        """Position [m], velocity [m/s] and acceleration [m/s^2] that the hand wants."""
        waits = self._begun is None or time < self._begun
        if waits and self._wandered is not None:
            return self._round_trip.at((time - self._wandered) % self._round_trip.end)
        return self._path.at(self.elapsed(time))


class Hand:
    """A hand that follows a path; the handle and the device may hold it back."""

    def __init__(self, plant: Plant, path: Path | Cue) -> None:
        self.mass = plant.hand_mass
        self._stiffness = plant.hand_stiffness
        self._damping = plant.hand_damping
        self._path = path

    def push(self, time: float, pose: Coordinates, twist: Coordinates) -> Coordinates:
        """Force of the muscles [N] at `time` [s], with the handle at `pose` [m] and moving."""
        k, b, m = self._stiffness, self._damping, self.mass
        wanted = self._path.at(time)
        return tuple(
            [
                k * (goal - x) + b * (rate - v) + m * a
                for goal, rate, a, x, v in zip(*wanted, pose, twist, strict=True)
            ]
        )


class Grip:
    """A hand around a platform that turns: spring, damper and mass of a Hand act at its lever.

    The torsional spring leads along the shortest turn to the one that is wanted.
    """

    def __init__(self, machine: Machine, plant: Plant, path: Path | Cue) -> None:
        self.mass = plant.hand_mass
        self._space, self._square = machine.space, machine.lever**2
        self._stiffness, self._damping = plant.hand_stiffness, plant.hand_damping
        self._path = path

    def push(self, time: float, pose: Coordinates, twist: Coordinates) -> Coordinates:
        """Wrench of the muscles [N, N m] at `time` [s], with the handle at `pose` and moving."""
        goal, rate, acceleration = self._path.at(time)
        space, k, b, m = self._space, self._stiffness, self._damping, self.mass
        way = [end - x for end, x in zip(goal[:space], pose[:space], strict=True)]
        way += self._turn_to(goal[space:], pose[space:])
        wanted = (*rate[:space], *self._spin(goal[space:], rate[space:]))
        wrench = [
            k * distance + b * (speed - v) + m * a
            for distance, speed, v, a in zip(way, wanted, twist, acceleration, strict=True)
        ]
        return (*wrench[:space], *(self._square * moment for moment in wrench[space:]))

    @staticmethod
    def _turn_to(goal: Coordinates, turns: Coordinates) -> Coordinates:
        here, there = (turning.from_vector(turning.in_space(each)) for each in (turns, goal))
        return turning.between(here, there)[-len(turns) :]

    @staticmethod
    def _spin(turns: Coordinates, rate: Coordinates) -> Coordinates:
        return turning.spin(turning.in_space(turns), turning.in_space(rate))[-len(turns) :]


def hand_of(machine: Machine, plant: Plant, path: Path | Cue) -> Holder:
    """The hand on a machine's handle."""
    return Grip(machine, plant, path) if machine.is_rigid else Hand(plant, path)
