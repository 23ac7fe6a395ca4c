"""One cable of the plant: its motor, the cable itself, and its base on a rail or fixed.

While it is taut the cable is rigid and massless (Yoon III-E), so the motor turns exactly as the
distance l from handle to base changes, and the tension T is the force of that constraint. With a
the acceleration of the handle and w the velocity of the base relative to the handle:

    r T = tau + (J l'' + B l') / r + dry friction              motor, tau > 0 pulls
    M s'' = f - friction - T lhat . e                          carriage on its rail
    l'' = lhat . e s'' - lhat . a + (|w|^2 - l'^2) / l         rigid cable

These are linear in T and s''; eliminating s'' leaves T = pull - inertia lhat . a.

A cable cannot push: where that T would be negative it hangs slack, T = 0, and the motor turns on
its own. It takes hold again when all that was paid out is needed, with a jerk that leaves handle
and motor at one speed. A broken cable never takes hold again; the drum of a hooked one stands.
"""

from dataclasses import dataclass
from math import exp, hypot

from turnbuckle.model.base import BaseMotion
from turnbuckle.model.machine import Machine, Plant

Pair = tuple[float, float]

PRESLIDING = 50e-6
"""Distance [m] over which dry friction builds up, and gives way, when the motion turns."""


@dataclass(slots=True)
class Friction:
    """Viscous damping, and dry friction that sticks (Dahl 1968).

    dry [N], damping [N s/m]; grip in [-1, 1] is the share of the dry friction that is at work.
    """

    dry: float
    damping: float
    grip: float = 0.0

    def force(self, speed: float) -> float:
        """Force [N] that resists `speed` [m/s]."""
        return self.damping * speed + self.dry * self.grip

    def slide(self, distance: float) -> None:
        """Let the grip follow a motion over `distance` [m], exactly however long that is."""
        if distance > 0.0:
            self.grip = 1.0 + (self.grip - 1.0) * exp(-distance / PRESLIDING)
        elif distance < 0.0:
            self.grip = (self.grip + 1.0) * exp(distance / PRESLIDING) - 1.0


@dataclass(frozen=True, slots=True)
class Rail:
    """Where a base can be: origin + s * direction, first <= s <= last; a fixed base stays."""

    origin: Pair  # m
    direction: Pair  # unit vector, (0, 0) for a fixed base
    first: float  # m, where the mechanical stops are
    last: float  # m
    mobility: float  # 1/kg, of the carriage; 0 for a fixed base


@dataclass(slots=True)
class Strand:
    """State of one cable and its base, and the balance of forces at one instant."""

    rail: Rail
    motor_friction: Friction  # felt at the cable
    carriage_friction: Friction
    motor_mass: float  # kg, J / r^2
    s: float = 0.0  # m
    speed: float = 0.0  # m/s, of the carriage
    acceleration: float = 0.0  # m/s^2, of the carriage
    length: float = 0.0  # m, from the handle to the base
    unit: Pair = (0.0, 0.0)  # lhat, from the handle to the base
    along: float = 0.0  # share of it along the rail
    rate: float = 0.0  # m/s, l'
    swing: float = 0.0  # m/s^2, (|w|^2 - l'^2) / l
    tension: float = 0.0  # N
    pull: float = 0.0  # N, tension while the handle does not accelerate
    inertia: float = 0.0  # kg
    taut: bool = True
    broken: bool = False
    hooked: bool = False
    loose_length: float = 0.0  # m, paid out; these three only while the cable is not taut
    loose_rate: float = 0.0  # m/s
    loose_acceleration: float = 0.0  # m/s^2

    @property
    def paid_out(self) -> float:
        """Cable between drum and handle [m], as the motor measures it."""
        return self.length if self.taut else self.loose_length

    @property
    def is_due(self) -> bool:
        """Whether a slack cable is needed in full: it takes hold now."""
        return not (self.taut or self.broken or self.hooked) and self.length >= self.loose_length

    def look(self, position: Pair, velocity: Pair) -> None:
        """Find length, direction and rate, from the handle's position [m] and velocity [m/s]."""
        (x0, y0), (ex, ey) = self.rail.origin, self.rail.direction
        dx, dy = x0 + self.s * ex - position[0], y0 + self.s * ey - position[1]
        wx, wy = self.speed * ex - velocity[0], self.speed * ey - velocity[1]
        self.length = length = hypot(dx, dy)
        self.unit = ux, uy = dx / length, dy / length
        self.along = ux * ex + uy * ey
        self.rate = rate = ux * wx + uy * wy
        self.swing = (wx * wx + wy * wy - rate * rate) / length

    def balance(self, motor_pull: float, rail_force: float, blocked: bool) -> None:
        """Find pull and inertia; motor_pull [N] = tau / r, rail_force [N] on the carriage."""
        mobility = 0.0 if blocked else self.rail.mobility
        along = self.along
        free = mobility * (rail_force - self.carriage_friction.force(self.speed))
        self.acceleration = free
        if not self.taut:
            self.pull = self.inertia = 0.0
            resisted = motor_pull + self.motor_friction.force(self.loose_rate)
            self.loose_acceleration = -resisted / self.motor_mass
            return
        mass = self.motor_mass
        self.inertia = inertia = mass / (1.0 + mass * along * along * mobility)
        held = motor_pull + self.motor_friction.force(self.rate)
        self.pull = inertia / mass * held + inertia * (along * free + self.swing)

    def settle(self, acceleration: Pair, blocked: bool) -> None:
        """Find tension and carriage acceleration from the handle's acceleration [m/s^2]."""
        ux, uy = self.unit
        tension = self.pull - self.inertia * (ux * acceleration[0] + uy * acceleration[1])
        self.tension = tension
        if not blocked:
            self.acceleration -= self.rail.mobility * self.along * tension

    def move(self, step: float) -> None:
        """Move carriage and motor for `step` seconds; the rail's ends stop it dead."""
        self.speed += self.acceleration * step
        self.s += self.speed * step
        self._turn_motor(step)
        self.carriage_friction.slide(self.speed * step)
        if not self.rail.first <= self.s <= self.rail.last:
            self.s = min(max(self.s, self.rail.first), self.rail.last)
            self.speed = 0.0

    def release(self) -> None:
        """Let the cable hang slack from here on."""
        self.taut = False
        self.loose_length, self.loose_rate = self.length, self.rate
        self.tension = 0.0

    def break_(self) -> None:
        """Cut the cable."""
        if self.taut:
            self.release()
        self.broken = True

    def hook(self, detour: float) -> None:
        """Hold the cable aside, with so much of it [m] beyond the distance it spans."""
        if self.taut:
            self.release()
        self.hooked = True
        self.loose_length, self.loose_rate = self.length + detour, 0.0

    def yielding(self) -> float:
        """Speed [m/s] that a jerk of 1 N s takes from the gap between cable and distance, the
        handle held: what carriage and motor give."""
        along = self.along
        return 1.0 / self.motor_mass + along * along * self.rail.mobility

    def jerk(self, impulse: float) -> None:
        """Let an impulse [N s] of the cable's tension act on the carriage."""
        self.speed -= self.rail.mobility * self.along * impulse

    def _turn_motor(self, step: float) -> None:
        if self.hooked:
            return
        if self.taut:
            self.motor_friction.slide(self.rate * step)
            return
        self.loose_rate += self.loose_acceleration * step
        self.loose_length += self.loose_rate * step
        self.motor_friction.slide(self.loose_rate * step)

    def is_pushed_off(self) -> bool:
        """Whether the carriage stands at an end of its rail and is pushed past it."""
        return (self.s <= self.rail.first and self.acceleration < 0.0) or (
            self.s >= self.rail.last and self.acceleration > 0.0
        )


def strands(machine: Machine, plant: Plant) -> list[Strand]:
    """The cables of a machine, at rest at the start of their rails."""
    motor_mass = machine.cable_motor.inertia / machine.drum.radius**2
    return [
        Strand(_rail(machine, motion, plant), *_frictions(machine, plant), motor_mass)
        for motion in machine.base_motions
    ]


def _frictions(machine: Machine, plant: Plant) -> tuple[Friction, Friction]:
    """Friction of a motor, as its cable feels it, and of a carriage."""
    radius = machine.drum.radius
    return (
        Friction(plant.motor_coulomb_friction / radius, plant.motor_viscous_friction / radius**2),
        Friction(plant.carriage_coulomb_friction or 0.0, plant.carriage_viscous_friction or 0.0),
    )


def _rail(machine: Machine, motion: BaseMotion, plant: Plant) -> Rail:
    x, y = motion.start
    if not motion.travel:
        return Rail((x, y), (0.0, 0.0), first=0.0, last=0.0, mobility=0.0)
    assert plant.carriage_mass is not None  # a machine file with rails states it
    ((number, (ex, ey)),) = motion.travel
    first, last = stops(machine, machine.rails[number].length)
    return Rail((x, y), (ex, ey), first, last, 1.0 / plant.carriage_mass)


def stops(machine: Machine, length: float) -> tuple[float, float]:
    """Where a carriage meets its stops [m]: at the rail's ends, or beyond that of the homing."""
    homing = machine.rail_drive.homing if machine.rail_drive else None
    if homing is None:
        return 0.0, length
    return (-homing.beyond, length) if homing.end == "start" else (0.0, length + homing.beyond)
