"""A cable machine of any kind as physics: a point or a body, in the plane or in space.

The equations are those of strand.py, for all cables together. With x the twist of the platform and
the speeds of the rails, J = [S', -E] (structure matrix, share of every cable along every rail) and
the masses M of platform and carriages:

    l' = -J x,  l'' = -J x' + swing                             rigid cables
    T  = held + m_n l''                                         motors; held: torque and friction
    M x' = push + J' T                                          platform and carriages

so that (M + m_n J'J) x' = push + J'(held + m_n swing) over the taut cables. Where a T would be
negative the cable hangs slack, until all of it is needed again.

The plane is a slice of space: vectors have three entries, and a kind has those of the six
velocities that its platform can have. A platform resists turning as if its mass were at its lever,
about every axis alike.
"""

from collections.abc import Sequence
from math import ceil

import numpy as np
from numpy.typing import NDArray

from turnbuckle.lab import turning
from turnbuckle.lab.plant import LOWEST_RATE, Holder
from turnbuckle.lab.strand import PRESLIDING, stops
from turnbuckle.model.base import Coordinates
from turnbuckle.model.machine import Machine, Plant
from turnbuckle.model.problem import Problem

Reals = NDArray[np.float64]
Flags = NDArray[np.bool_]


def refusal(machine: Machine) -> Problem | None:
    """What of a machine this plant cannot simulate: its cables are straight."""
    if any(machine.pulleys):
        return Problem("pulley", "a radius", "none, for the virtual bench")
    return None


class Frictions:
    """What resists so many motions: viscous damping, and dry friction that sticks (strand.py)."""

    def __init__(self, count: int, dry: float, damping: float) -> None:
        self._dry, self._damping = dry, damping
        self._grip = np.zeros(count)

    def force(self, speed: Reals) -> Reals:
        """Forces [N] that resist speeds [m/s]."""
        return self._damping * speed + self._dry * self._grip

    def slide(self, distance: Reals) -> None:
        """Let the grip follow motions over distances [m]."""
        way = np.sign(distance)
        self._grip = way + (self._grip - way) * np.exp(-np.abs(distance) / PRESLIDING)


class PlatformPlant:
    """The physics of a machine of any kind, advanced one control cycle at a time."""

    def __init__(
        self,
        machine: Machine,
        plant: Plant,
        holder: Holder,
        pose: Sequence[float],
        rails: Sequence[float],
    ) -> None:
        """At rest at a pose (d) [m, rad], with its bases at `rails` [m] (m)."""
        self._space, self._dof = machine.space, machine.dof
        self._turns = slice(3, 6) if machine.space == 3 else slice(5, 6)
        self._holder, self._radius = holder, machine.drum.radius
        self._steps = ceil(LOWEST_RATE / machine.control.rate)
        self._step = 1.0 / (machine.control.rate * self._steps)
        self._set_cables(machine, plant)
        self._set_masses(machine, plant)
        self.time = 0.0
        self.lowest_tension = self.highest_tension = 0.0
        self.cable_force = self.hand_force = (0.0,) * self._dof
        self._centre = _in_space(pose[: self._space])
        self._turn = turning.from_vector(turning.in_space(tuple(pose[self._space :])))
        self._rails = np.array(rails, dtype=float)
        self._twist, self._rail_speeds = np.zeros(self._dof), np.zeros(len(rails))
        self._look()

    def _set_cables(self, machine: Machine, plant: Plant) -> None:
        count, radius = len(machine.cables), machine.drum.radius
        self._anchors = np.array([_in_space(anchor) for anchor in machine.anchors])
        self._starts = np.array([_in_space(motion.start) for motion in machine.base_motions])
        self._travel = np.zeros((count, 3, len(machine.rails)))
        for cable, motion in enumerate(machine.base_motions):
            for rail, direction in motion.travel:
                self._travel[cable, :, rail] = _in_space(direction)
        ends = [stops(machine, rail.length) for rail in machine.rails]
        self._first, self._last = np.array(ends).reshape(-1, 2).T
        self._motor_friction = Frictions(
            count, plant.motor_coulomb_friction / radius, plant.motor_viscous_friction / radius**2
        )
        self._motor_mass = machine.cable_motor.inertia / radius**2
        self._tensions = np.zeros(count)
        self._taut = np.ones(count, dtype=bool)
        self._broken, self._hooked = ~self._taut, ~self._taut
        self._loose_length, self._loose_rate = np.zeros(count), np.zeros(count)

    def _set_masses(self, machine: Machine, plant: Plant) -> None:
        """Of platform and carriages; a carriage that several rails move couples them."""
        turns = machine.dof - machine.space
        shares = np.array([1.0] * machine.space + [machine.lever**2] * turns)
        self._hand_masses = self._holder.mass * shares
        carriages = plant.carriage_mass or 0.0
        moved = np.einsum("ixk,ixl->kl", self._travel, self._travel)
        self._masses = np.zeros((self._dof + len(machine.rails),) * 2)
        self._masses[: self._dof, : self._dof] = np.diag(
            plant.handle_mass * shares + self._hand_masses
        )
        self._masses[self._dof :, self._dof :] = carriages * moved
        self._carriage_friction = Frictions(
            len(machine.rails),
            plant.carriage_coulomb_friction or 0.0,
            plant.carriage_viscous_friction or 0.0,
        )
        self._carriages = np.array([len(rail.cables) for rail in machine.rails], dtype=float)

    @property
    def position(self) -> Coordinates:
        """Pose (d) [m, rad]."""
        turns = turning.to_vector(self._turn)
        centre: list[float] = self._centre[: self._space].tolist()
        return (*centre, *(turns if self._space == 3 else turns[2:])[: self._dof - self._space])

    @property
    def velocity(self) -> Coordinates:
        """Twist (d) [m/s, rad/s]."""
        return tuple(self._twist.tolist())

    @property
    def lengths(self) -> list[float]:
        """Cable lengths [m] (n) as the motors measure them."""
        lengths: list[float] = np.where(self._taut, self._length, self._loose_length).tolist()
        return lengths

    @property
    def slack(self) -> list[float]:
        """Cable [m] (n) that is paid out and not needed; of a broken one any value."""
        return [out - needed for out, needed in zip(self.lengths, self._length, strict=True)]

    @property
    def rails(self) -> list[float]:
        """Rail coordinates [m] (m)."""
        rails: list[float] = self._rails.tolist()
        return rails

    @property
    def tensions(self) -> list[float]:
        """True cable tensions [N] (n)."""
        tensions: list[float] = self._tensions.tolist()
        return tensions

    def break_cable(self, cable: int) -> None:
        """Cut a cable, counted from 0."""
        self._release(cable)
        self._broken[cable] = True

    def hook_cable(self, cable: int, detour: float) -> None:
        """Hold a cable, counted from 0, aside, with so much of it [m] off its drum."""
        self._release(cable)
        self._hooked[cable] = True
        self._loose_length[cable], self._loose_rate[cable] = self._length[cable] + detour, 0.0

    def advance(self, torques: Sequence[float], rail_forces: Sequence[float]) -> None:
        """Run one control cycle; torques [N m] (n) of the motors, rail_forces [N] (m)."""
        pulls = np.array(torques) / self._radius
        drives = np.array(rail_forces, dtype=float)
        self.lowest_tension, self.highest_tension = float("inf"), float("-inf")
        for _ in range(self._steps):
            self._move(self._accelerate(pulls, drives))

    def _look(self) -> None:
        """Find lengths, directions and rates of all cables."""
        arms = self._anchors @ np.array(turning.matrix(self._turn)).T
        speed = self._travel @ self._rail_speeds - _in_space(self._twist[: self._space])
        spans = self._starts + self._travel @ self._rails - self._centre - arms
        self._length = length = np.sqrt((spans * spans).sum(axis=1))
        units = spans / length[:, None]
        columns = [*units.T[: self._space]]
        if self._dof > self._space:
            columns += _moments(arms, units)[self._turns.start - 3 :]
        along = (units[:, :, None] * self._travel).sum(axis=1)
        self._jacobian = np.column_stack([*columns, -along])
        self._turn_swing(units, arms, speed)

    def _turn_swing(self, units: Reals, arms: Reals, speed: Reals) -> None:
        """What of l'' is there without any acceleration; and l'. speed (n, 3) [m/s]: of the bases
        relative to the platform's centre."""
        carried: Reals | float = 0.0
        if self._dof > self._space:
            omega = self._angular_velocity()
            speed = speed - np.stack(_moments(np.broadcast_to(omega, arms.shape), arms), axis=1)
            inward = (units @ omega) * (arms @ omega)
            carried = inward - (units * arms).sum(axis=1) * (omega @ omega)
        self._rate = rate = (units * speed).sum(axis=1)
        self._swing = ((speed * speed).sum(axis=1) - rate * rate) / self._length - carried

    def _angular_velocity(self) -> Reals:
        return np.array(turning.in_space(tuple(self._twist[self._space :].tolist())))

    def _accelerate(self, pulls: Reals, drives: Reals) -> Reals:
        """Acceleration of platform and carriages (d + m); carriages pushed past the end of their
        rail stay there, cables that would have to push hang slack."""
        push = np.array(self._holder.push(self.time, self.position, self.velocity))
        resisted = self._carriages * self._carriage_friction.force(self._rail_speeds)
        forces = np.concatenate([push, drives - resisted])
        blocked = np.zeros(len(forces), dtype=bool)
        while True:
            motor_rate = np.where(self._taut, self._rate, self._loose_rate)
            held = pulls + self._motor_friction.force(motor_rate)
            acceleration = self._solve(forces, held, blocked)
            pushed, slackening = self._pushed_off(acceleration, blocked), self._tensions < 0.0
            if not (pushed.any() or slackening.any()):
                break
            blocked[self._dof :] |= pushed
            for cable in np.flatnonzero(slackening):
                self._release(int(cable))
        self._loose_acceleration = -held / self._motor_mass
        self._weigh(push, acceleration[: self._dof])
        return acceleration

    def _solve(self, forces: Reals, held: Reals, blocked: Flags) -> Reals:
        pulling = self._jacobian * self._taut[:, None] * ~blocked
        still = held + self._motor_mass * self._swing
        masses = self._masses + self._motor_mass * pulling.T @ pulling
        acceleration: Reals
        acceleration = np.linalg.solve(masses, forces * ~blocked + pulling.T @ still)
        acceleration[blocked] = 0.0
        carried = still - self._motor_mass * (self._jacobian @ acceleration)
        self._tensions = np.where(self._taut, carried, 0.0)
        return acceleration

    def _pushed_off(self, acceleration: Reals, blocked: Flags) -> Flags:
        """Which carriages (m) stand at an end of their rail and are pushed past it."""
        along = acceleration[self._dof :]
        return ~blocked[self._dof :] & (
            ((self._rails <= self._first) & (along < 0.0))
            | ((self._rails >= self._last) & (along > 0.0))
        )

    def _weigh(self, push: Reals, acceleration: Reals) -> None:
        """What a force sensor in the handle and a tension sensor in every cable would read."""
        self.hand_force = tuple((push - self._hand_masses * acceleration).tolist())
        self.cable_force = tuple((self._tensions @ self._jacobian[:, : self._dof]).tolist())
        self.lowest_tension = min(self.lowest_tension, float(self._tensions.min()))
        self.highest_tension = max(self.highest_tension, float(self._tensions.max()))

    def _move(self, acceleration: Reals) -> None:
        """Semi-implicit Euler: speeds first, positions with the new speeds."""
        step = self._step
        self._twist += acceleration[: self._dof] * step
        self._centre = self._centre + _in_space(self._twist[: self._space]) * step
        if self._dof > self._space:
            x, y, z = (self._angular_velocity() * step).tolist()
            self._turn = turning.then(self._turn, turning.from_vector((x, y, z)))
        self._move_carriages(acceleration[self._dof :])
        self._turn_motors()
        self.time += step
        self._look()
        while (due := self._due()).any():
            self._take_hold(int(due.argmax()))
            self._look()

    def _move_carriages(self, acceleration: Reals) -> None:
        """The rails' ends stop carriages dead."""
        self._rail_speeds += acceleration * self._step
        self._rails += self._rail_speeds * self._step
        self._carriage_friction.slide(self._rail_speeds * self._step)
        self._rail_speeds[(self._rails < self._first) | (self._rails > self._last)] = 0.0
        np.clip(self._rails, self._first, self._last, out=self._rails)

    def _turn_motors(self) -> None:
        step = self._step
        loose = ~(self._taut | self._hooked)
        self._loose_rate += np.where(loose, self._loose_acceleration * step, 0.0)
        self._loose_length += np.where(loose, self._loose_rate * step, 0.0)
        rate = np.where(self._taut, self._rate, np.where(loose, self._loose_rate, 0.0))
        self._motor_friction.slide(rate * step)

    def _release(self, cable: int) -> None:
        """Let a taut cable hang slack from here on."""
        if self._taut[cable]:
            self._taut[cable] = False
            self._tensions[cable] = 0.0
            self._loose_length[cable] = self._length[cable]
            self._loose_rate[cable] = self._rate[cable]

    def _due(self) -> Flags:
        """Which slack cables (n) are needed in full: they take hold now."""
        waits = ~(self._taut | self._broken | self._hooked)
        due: Flags = waits & (self._length >= self._loose_length)
        return due

    def _take_hold(self, cable: int) -> None:
        """Bring a slack cable and the distance it spans to one speed (inelastic impact)."""
        pulling = self._jacobian * self._taut[:, None]
        masses = self._masses + self._motor_mass * pulling.T @ pulling
        row = self._jacobian[cable]
        given = np.linalg.solve(masses, row)
        gap_rate = max(0.0, float(self._rate[cable] - self._loose_rate[cable]))
        change = gap_rate / (1.0 / self._motor_mass + row @ given) * given
        self._twist += change[: self._dof]
        self._rail_speeds += change[self._dof :]
        self._taut[cable] = True


def _in_space(vector: Sequence[float] | Reals) -> Reals:
    """A vector with three entries, of one of the plane or of space."""
    whole = np.zeros(3)
    whole[: len(vector)] = vector
    return whole


def _moments(arms: Reals, forces: Reals) -> list[Reals]:
    """Entries (3, n) of arm x force for vectors (n, 3); for few of them faster than np.cross."""
    (x, y, z), (u, v, w) = arms.T, forces.T
    return [y * w - z * v, z * u - x * w, x * v - y * u]
