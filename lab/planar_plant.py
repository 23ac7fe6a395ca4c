"""A planar cable machine as physics: handle, cables, motors, carriages, friction, rail ends.

Every strand (strand.py) gives its tension as T = pull - inertia lhat . a; what is left to solve
is the handle, with the hand that holds it:  m a = push + sum of T lhat.

Where that T would be negative the cable hangs slack instead, until it is needed in full again: then
it takes hold with a jerk that handle, carriages and motors share.

Plain Python numbers, not arrays: with four cables that is several times faster than NumPy.
"""

from collections.abc import Sequence
from math import ceil

from turnbuckle.lab.plant import LOWEST_RATE, Holder
from turnbuckle.lab.strand import Pair, Strand, strands
from turnbuckle.model.base import Coordinates
from turnbuckle.model.machine import Machine, Plant
from turnbuckle.model.problem import Problem


def refusal(machine: Machine) -> Problem | None:
    """What of a machine this plant cannot simulate: it knows points in the plane, straight cables,
    one carriage a rail."""
    if machine.space != 2 or machine.is_rigid:
        return Problem("machine.kind", machine.kind, "planar-point, for the planar plant")
    if any(machine.pulleys):
        return Problem("pulley", "a radius", "none, for the planar plant")
    if any(len(rail.cables) > 1 for rail in machine.rails):
        return Problem("cable", "coupled rails", "a drive a rail, for the planar plant")
    if any(cable.plane for cable in machine.cables):
        return Problem("cable", "a base in a plane", "rails, for the planar plant")
    return None


class PlanarPlant:
    """The physics of a planar-point machine, advanced one control cycle at a time.

    time [s]; position [m], velocity [m/s] of the handle; cable_force and hand_force [N] on it;
    lowest_tension and highest_tension [N]: the extremes of any cable within the last cycle.
    """

    def __init__(
        self,
        machine: Machine,
        plant: Plant,
        holder: Holder,
        position: Sequence[float],
        rails: Sequence[float],
    ) -> None:
        self._strands = strands(machine, plant)
        self._rail_cables = [cable for rail in machine.rails for cable in rail.cables]
        self._carriages = [self._strands[index] for index in self._rail_cables]
        self._holder = holder
        self._mass = plant.handle_mass + holder.mass
        self._radius = machine.drum.radius
        self._steps = ceil(LOWEST_RATE / machine.control.rate)
        self._step = 1.0 / (machine.control.rate * self._steps)
        self.time = 0.0
        x, y = position
        self.position: Pair = (x, y)
        self.velocity: Pair = (0.0, 0.0)
        self.cable_force: Pair = (0.0, 0.0)
        self.hand_force: Pair = (0.0, 0.0)
        self.lowest_tension = 0.0
        self.highest_tension = 0.0
        for carriage, s in zip(self._carriages, rails, strict=True):
            carriage.s = s
        self._look()

    @property
    def lengths(self) -> list[float]:
        """Cable lengths [m] (n) as the motors measure them; a slack cable is longer than the
        distance it spans."""
        return [strand.paid_out for strand in self._strands]

    @property
    def slack(self) -> list[float]:
        """Cable [m] (n) that is paid out and not needed; of a broken one any value."""
        return [strand.paid_out - strand.length for strand in self._strands]

    @property
    def rails(self) -> list[float]:
        """Rail coordinates [m] (m)."""
        return [carriage.s for carriage in self._carriages]

    @property
    def tensions(self) -> list[float]:
        """True cable tensions [N] (n)."""
        return [strand.tension for strand in self._strands]

    def break_cable(self, cable: int) -> None:
        """Cut a cable, counted from 0: its motor has nothing to pull from here on."""
        self._strands[cable].break_()

    def hook_cable(self, cable: int, detour: float) -> None:
        """Let something catch a cable, counted from 0, and hold it aside: so much of it [m] is
        pulled off its drum, which is held, and the handle feels none of its tension."""
        self._strands[cable].hook(detour)

    def advance(self, torques: Sequence[float], rail_forces: Sequence[float]) -> None:
        """Run one control cycle; torques [N m] (n) of the motors, rail_forces [N] (m)."""
        pulls = [torque / self._radius for torque in torques]
        drives = [0.0] * len(self._strands)
        for index, force in zip(self._rail_cables, rail_forces, strict=True):
            drives[index] = force
        self.lowest_tension, self.highest_tension = float("inf"), float("-inf")
        for _ in range(self._steps):
            self._move(self._accelerate(pulls, drives))

    def _look(self) -> None:
        for strand in self._strands:
            strand.look(self.position, self.velocity)

    def _accelerate(self, pulls: Sequence[float], drives: Sequence[float]) -> Pair:
        """The handle's acceleration; carriages pushed past the end of their rail stay there,
        cables that would have to push hang slack."""
        push = self._holder.push(self.time, self.position, self.velocity)
        blocked: set[int] = set()
        while True:
            acceleration = self._solve(push, pulls, drives, blocked)
            if not self._give_way(blocked):
                break
        self._weigh(push, acceleration)
        return acceleration

    def _give_way(self, blocked: set[int]) -> bool:
        """Stop carriages at their ends and let slack what would push; whether there was any."""
        given = False
        for index, strand in enumerate(self._strands):
            if strand.is_pushed_off():
                blocked.add(index)
                given = True
            if strand.tension < 0.0:
                strand.release()
                given = True
        return given

    def _solve(
        self, push: Coordinates, pulls: Sequence[float], drives: Sequence[float], blocked: set[int]
    ) -> Pair:
        fx, fy = push
        for index, strand in enumerate(self._strands):
            strand.balance(pulls[index], drives[index], index in blocked)
            (ux, uy), pull = strand.unit, strand.pull
            fx += ux * pull
            fy += uy * pull
        acceleration = self._divide_by_mass(fx, fy)
        for index, strand in enumerate(self._strands):
            strand.settle(acceleration, index in blocked)
        return acceleration

    def _weigh(self, push: Coordinates, acceleration: Pair) -> None:
        """What a force sensor in the handle and a tension sensor in every cable would read."""
        mass, (ax, ay) = self._holder.mass, acceleration
        self.hand_force = push[0] - mass * ax, push[1] - mass * ay
        fx = fy = 0.0
        lowest, highest = self.lowest_tension, self.highest_tension
        for strand in self._strands:
            tension = strand.tension
            fx += tension * strand.unit[0]
            fy += tension * strand.unit[1]
            lowest = tension if tension < lowest else lowest
            highest = tension if tension > highest else highest
        self.cable_force = fx, fy
        self.lowest_tension, self.highest_tension = lowest, highest

    def _move(self, acceleration: Pair) -> None:
        """Semi-implicit Euler: speeds first, positions with the new speeds."""
        step = self._step
        vx, vy = self.velocity
        vx, vy = vx + acceleration[0] * step, vy + acceleration[1] * step
        self.velocity = vx, vy
        self.position = self.position[0] + vx * step, self.position[1] + vy * step
        for strand in self._strands:
            strand.move(step)
        self.time += step
        self._look()
        for strand in self._strands:
            if strand.is_due:
                self._take_hold(strand)
                self._look()

    def _take_hold(self, strand: Strand) -> None:
        """Bring a slack cable and the distance it spans to one speed (inelastic impact)."""
        ux, uy = strand.unit
        gap_rate = strand.rate - strand.loose_rate
        dx, dy = self._divide_by_mass(ux, uy)
        impulse = max(0.0, gap_rate) / (strand.yielding() + ux * dx + uy * dy)
        for other in self._strands:
            if other.taut:
                along = other.unit[0] * dx + other.unit[1] * dy
                other.jerk(-other.inertia * along * impulse)
        strand.jerk(impulse)
        strand.taut = True
        self.velocity = self.velocity[0] + dx * impulse, self.velocity[1] + dy * impulse

    def _divide_by_mass(self, fx: float, fy: float) -> Pair:
        """Acceleration from a force; the handle moves with the motors of all taut cables."""
        mxx = myy = self._mass
        mxy = 0.0
        for strand in self._strands:
            (ux, uy), inertia = strand.unit, strand.inertia
            mxx += inertia * ux * ux
            mxy += inertia * ux * uy
            myy += inertia * uy * uy
        determinant = mxx * myy - mxy * mxy
        return (myy * fx - mxy * fy) / determinant, (mxx * fy - mxy * fx) / determinant
