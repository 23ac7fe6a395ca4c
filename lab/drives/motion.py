"""What a drive's motor does: its encoder, and the torque of every mode.

Angles in rad, speeds in rad/s, torques in N m at the motor; positions in increments as the drive
counts them. The loops are those of a drive that was tuned for the inertia it moves.
"""

from dataclasses import dataclass
from enum import Enum
from math import floor, pi

RPM = 2.0 * pi / 60.0
"""One turn per minute [rad/s]."""
POSITION_BANDWIDTH = 2.0 * pi * 25.0
"""Of the position loop [rad/s]."""
SPEED_BANDWIDTH = 2.0 * pi * 20.0
"""Of the speed loop [rad/s]."""
SPEED_CORNER = 2.0 * pi * 100.0
"""Of the filter on the measured speed [rad/s]."""
STANDSTILL = 10.0 * RPM
"""Slower than this is standing."""
DWELL = 0.02
"""Time of standing against the mechanical stop until it counts as found [s]."""
PATIENCE = 0.5
"""Time a ramp may take beyond its end [s]."""


def clip(value: float, limit: float) -> float:
    """The value within +-limit."""
    return min(max(value, -limit), limit)


class Encoder:
    """Counts increments; at power-on it has the count `start`, wherever the motor stands."""

    def __init__(self, increments_per_turn: int, start: int = 0) -> None:
        self.per_radian = increments_per_turn / (2.0 * pi)
        self.count = start
        self.speed = 0.0  # rad/s, filtered
        self.start_count = start
        self.restart()

    def restart(self) -> None:
        """Power-on: counts from where the motor stands."""
        self.count, self.speed = self.start_count, 0.0
        self._turned = self.start_count
        self._angle: float | None = None
        self._rate = 0.0
        self._from = self._counted = 0.0
        self._scale = 1.0
        self._slip = 0

    def turn(self, angle: float, seconds: float) -> None:
        """The motor is at an angle [rad], so long after it was last looked at."""
        if self._angle is None:
            self._angle = self._from = angle
        if self._slip and self._true_count(angle) != self._true_count(self._angle):
            self._counted += self._slip
        before, self._turned = self._turned, self._count_at(angle)
        self._rate, self._angle = (angle - self._angle) / seconds, angle
        self.count = self._turned
        rate = (self._turned - before) / (self.per_radian * seconds)
        share = SPEED_CORNER * seconds
        self.speed += share / (1.0 + share) * (rate - self.speed)

    def look(self, seconds: float) -> None:
        """Count where the motor is so long after the last turn."""
        if self._angle is not None:
            self.count = self._count_at(self._angle + self._rate * seconds)

    def jump(self, increments: int) -> None:
        """Fault: so many increments that the motor did not turn."""
        self._counted += increments

    def slip(self, increments: int) -> None:
        """Fault: from here on it jumps by so many increments in every cycle in which it turns."""
        self._slip = increments

    def distort(self, scale: float) -> None:
        """Fault: from here on it counts so many times what it should: 0 frozen, -1 backwards."""
        if self._angle is not None:
            self._counted += (self._angle - self._from) * self.per_radian * self._scale
            self._from = self._angle
        self._scale = scale

    def _true_count(self, angle: float) -> int:
        return floor(angle * self.per_radian)

    def _count_at(self, angle: float) -> int:
        turned = (angle - self._from) * self.per_radian * self._scale
        return self.start_count + floor(turned + self._counted)


@dataclass
class SpeedLoop:
    """Torque that keeps a speed."""

    inertia: float  # kg m^2
    integral: float = 0.0

    def torque(self, error: float, limit: float, seconds: float) -> float:
        """Torque for a speed error [rad/s], within +-limit."""
        gain = self.inertia * SPEED_BANDWIDTH
        wanted = gain * error + self.integral
        if abs(wanted) < limit or wanted * error < 0.0:
            self.integral += gain * SPEED_BANDWIDTH / 4.0 * error * seconds
        return clip(wanted, limit)


class PositionLoop:
    """Torque that keeps a position; a demand that moves is known with its speed."""

    def __init__(self, inertia: float, per_radian: float, position: int) -> None:
        self._stiffness = inertia * POSITION_BANDWIDTH**2
        self._damping = 2.0 * inertia * POSITION_BANDWIDTH
        self._per_radian = per_radian
        self._integral = 0.0
        self._steps_left = 0
        self._step = 0.0
        self.demand = float(position)
        self.target = position

    def aim(self, target: int, steps: int) -> None:
        """Go to a target [inc] in so many steps of equal size."""
        self.target = target
        self._steps_left = max(1, steps)
        self._step = (target - self.demand) / self._steps_left

    def torque(self, position: int, speed: float, limit: float, seconds: float) -> float:
        """Torque of this step, at a position [inc] and speed [rad/s]."""
        moving = 0.0
        if self._steps_left:
            self._steps_left -= 1
            self.demand = self.demand + self._step if self._steps_left else float(self.target)
            moving = self._step / (self._per_radian * seconds)
        error = (self.demand - position) / self._per_radian
        wanted = self._stiffness * error + self._damping * (moving - speed) + self._integral
        if abs(wanted) < limit:
            self._integral += self._stiffness * POSITION_BANDWIDTH / 8.0 * error * seconds
        return clip(wanted, limit)


class Ramp:
    """Brings the motor to a standstill."""

    def __init__(self, speed: float, deceleration: float, inertia: float) -> None:
        """Begin at a speed [rad/s] with a deceleration [rad/s^2]."""
        self._speed, self._deceleration = speed, deceleration
        self._loop = SpeedLoop(inertia)
        self._waited = 0.0
        self.done = False

    def torque(self, speed: float, limit: float, seconds: float) -> float:
        """Torque of this step; `done` once the motor stands, or would not within PATIENCE."""
        self._speed -= clip(self._speed, self._deceleration * seconds)
        if self._speed == 0.0:
            self._waited += seconds
            self.done = self.done or abs(speed) < STANDSTILL or self._waited > PATIENCE
        return self._loop.torque(self._speed - speed, limit, seconds)


class Run(Enum):
    """How far a homing run is; the value is what bits 13, 12, 10 of the statusword say."""

    RUNNING = 0b000
    INTERRUPTED = 0b001
    ATTAINED = 0b010  # home is found, the motor still moves
    DONE = 0b011
    FAILED = 0b101


@dataclass(frozen=True)
class HomingParameters:
    """What the objects of homing say."""

    direction: float  # 1, -1: of the motor to the stop; 0: home is here
    approach: float  # rad/s
    search: float  # rad/s
    acceleration: float  # rad/s^2
    threshold: float  # N m, what the current threshold makes
    offset: int  # inc, away from the stop
    position: int  # inc, that home is given


class Homing:
    """A homing run: to the mechanical stop, away from it, there is home; or home is here."""

    def __init__(self, parameters: HomingParameters, inertia: float, encoder: Encoder) -> None:
        self.run = Run.RUNNING
        self.home: int | None = None
        """Count of the encoder that is home, once it is known."""
        self._parameters = parameters
        self.position = parameters.position
        """Count that home is given."""
        self._direction = parameters.direction
        self._encoder = encoder
        self._inertia = inertia
        self._loop = SpeedLoop(inertia)
        self._speed = 0.0
        self._standing = 0.0
        self._hold: PositionLoop | None = None
        if parameters.direction == 0.0:
            self._find_home(encoder.count)

    def interrupt(self) -> None:
        """Stop the run where it is; a finished one stays finished."""
        if self.run is Run.RUNNING:
            self.run = Run.INTERRUPTED
            self._hold_at(self._encoder.count)

    def fail(self) -> None:
        """Fault: the run ends without home."""
        self.interrupt()
        self.run, self.home = Run.FAILED, None

    def torque(self, limit: float, seconds: float) -> float:
        """Torque of this step."""
        if self._hold is None:
            return self._approach(min(limit, self._parameters.threshold), seconds)
        encoder = self._encoder
        torque = self._hold.torque(encoder.count, encoder.speed, limit, seconds)
        if self.run is Run.ATTAINED and self._hold.demand == self._hold.target:
            self.run = Run.DONE
        return torque

    def _approach(self, limit: float, seconds: float) -> float:
        parameters, speed = self._parameters, self._encoder.speed
        self._speed = min(parameters.approach, self._speed + parameters.acceleration * seconds)
        torque = self._loop.torque(self._direction * self._speed - speed, limit, seconds)
        pressing = torque * self._direction >= limit and abs(speed) < 0.1 * parameters.approach
        self._standing = self._standing + seconds if pressing else 0.0
        if self._standing >= DWELL:
            self._leave_stop(seconds)
        return torque

    def _leave_stop(self, seconds: float) -> None:
        """The stop is found: move off by the offset, there is home."""
        distance = -self._direction * self._parameters.offset
        home = self._encoder.count + int(distance)
        self._find_home(home)
        assert self._hold is not None
        turned = abs(distance) / self._encoder.per_radian
        self._hold.aim(home, int(turned / (self._parameters.search * seconds)))

    def _find_home(self, home: int) -> None:
        self.run, self.home = Run.ATTAINED, home
        self._hold_at(self._encoder.count)

    def _hold_at(self, count: int) -> None:
        self._hold = PositionLoop(self._inertia, self._encoder.per_radian, count)
