"""The arguments that the functions of the model share, with the bounds inside which they are taken.

The bounds are wide: they exist so that no arithmetic overflows in single precision and a NaN is
refused, not to say what is sensible for the machine.
"""

from math import hypot, pi

from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.function import Input, bounded_input, make_input

#: Commands and measurements may exceed the machine's own limits by this factor.
HEADROOM = 1000.0
#: Fastest motion that is taken for a measurement, m/s.
FASTEST = 100.0
#: How much farther than its machine file says a rigid platform may turn about any axis [rad].
BEYOND_ROTATION = 0.5
#: Largest remembered quantity on average, in its own unit.
MEMORY_BOUND = 1e6


def wrench_unit(machine: Machine) -> str:
    """Unit of a wrench: a force, and a moment about the centre of a rigid platform."""
    return "N, N m" if machine.is_rigid else "N"


def structure_unit(machine: Machine) -> str:
    """Unit of the structure matrix: a rigid platform's moments have arms."""
    return "1, m" if machine.is_rigid else "1"


def velocity_unit(machine: Machine) -> str:
    """Unit of a platform's velocity, a twist in the fixed frame where it turns."""
    return "m/s, rad/s" if machine.is_rigid else "m/s"


def pose(machine: Machine, name: str = "pose") -> Input:
    """Position of the platform: the frame and more than its own size around it; its rotation."""
    farthest = 2 * max(machine.frame.size)
    if not machine.is_rigid:
        return bounded_input(name, (machine.dof,), "m", farthest)
    bounds = [farthest] * machine.space
    bounds += [machine.rotation + BEYOND_ROTATION] * (machine.dof - machine.space)
    return make_input(name, (machine.dof,), "m, rad", [-bound for bound in bounds], bounds)


def rails(machine: Machine, name: str = "rails") -> Input:
    """Rail coordinates s_i: twice the longest rail."""
    longest = max((rail.length for rail in machine.rails), default=0.0)
    return bounded_input(name, (len(machine.rails),), "m", 2 * longest)


def lengths(machine: Machine, name: str = "lengths") -> Input:
    """Cable lengths l_i; a cable that leaves its pulley before `contact` counts as shorter."""
    longest = 4 * sum(machine.frame.size)
    wraps = [2 * pi * pulley.radius if pulley else 0.0 for pulley in machine.pulleys]
    lows, highs = [0.0 - wrap for wrap in wraps], [longest + wrap for wrap in wraps]
    return make_input(name, (len(machine.cables),), "m", lows, highs)


def speeds(name: str, count: int, unit: str = "m/s") -> Input:
    """Speeds of cables, rails or the platform."""
    return bounded_input(name, (count,), unit, FASTEST)


def velocity(machine: Machine) -> Input:
    """Velocity of the platform: a twist where it turns."""
    return speeds("velocity", machine.dof, velocity_unit(machine))


def rates(machine: Machine) -> tuple[Input, Input]:
    """Speeds of all cables and of all rails."""
    return (
        speeds("length_rates", len(machine.cables)),
        speeds("rail_rates", len(machine.rails)),
    )


def memory(shape: tuple[int, int], unit: str) -> Input:
    """What a filter remembers, in units of its columns; only a broken memory is refused."""
    return bounded_input("memory", shape, unit, MEMORY_BOUND)


def structure(machine: Machine) -> Input:
    """Structure matrix S (Yoon eq. 7): unit vectors, and moments of a rigid platform's arms."""
    longest = max(1.0, *(hypot(*anchor) for anchor in machine.anchors))
    shape = (machine.dof, len(machine.cables))
    return bounded_input("structure", shape, structure_unit(machine), 4 * longest)


def tension(machine: Machine, name: str = "tension") -> Input:
    """Cable tensions T_i."""
    bound = HEADROOM * machine.tension.max
    return bounded_input(name, (len(machine.cables),), "N", bound)


def wrench(machine: Machine, name: str = "wrench") -> Input:
    """Wrench on the platform."""
    bound = HEADROOM * machine.tension.max * len(machine.cables)
    return bounded_input(name, (machine.dof,), wrench_unit(machine), bound)


def torque(machine: Machine, name: str) -> Input:
    """Motor torques."""
    bound = HEADROOM * machine.tension.max * machine.drum.radius
    return bounded_input(name, (len(machine.cables),), "N m", bound)


def force(machine: Machine) -> Input:
    """Size of a force in any direction."""
    return make_input("force", (), "N", [0.0], [HEADROOM * machine.tension.max])
