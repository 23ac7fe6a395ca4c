"""The arguments that the functions of the model share, with the bounds inside which they are taken.

The bounds are wide: they exist so that no arithmetic overflows in single precision and a NaN is
refused, not to say what is sensible for the machine.
"""

from model.machine import Machine
from model.symbolic.function import Input, bounded_input, make_input

#: Commands and measurements may exceed the machine's own limits by this factor.
HEADROOM = 1000.0
#: Fastest motion that is taken for a measurement, m/s.
FASTEST = 100.0
#: Largest remembered quantity on average, in its own unit.
MEMORY_BOUND = 1e6


def pose(machine: Machine) -> Input:
    """Position of the platform: the frame and more than its own size around it."""
    return bounded_input("pose", (machine.dof,), "m", 2 * max(machine.frame.size))


def rails(machine: Machine, name: str = "rails") -> Input:
    """Rail coordinates s_i: twice the longest rail."""
    longest = max((rail.length for rail in machine.rails), default=0.0)
    return bounded_input(name, (len(machine.rails),), "m", 2 * longest)


def lengths(machine: Machine, name: str = "lengths") -> Input:
    """Cable lengths l_i."""
    longest = 4 * sum(machine.frame.size)
    return make_input(name, (len(machine.cables),), "m", [0.0], [longest])


def speeds(name: str, count: int) -> Input:
    """Speeds of cables, rails or the platform."""
    return bounded_input(name, (count,), "m/s", FASTEST)


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
    """Structure matrix S (Yoon eq. 7): unit columns for a point platform."""
    return bounded_input("structure", (machine.dof, len(machine.cables)), "1", 4.0)


def tension(machine: Machine, name: str = "tension") -> Input:
    """Cable tensions T_i."""
    bound = HEADROOM * machine.tension.max
    return bounded_input(name, (len(machine.cables),), "N", bound)


def wrench(machine: Machine, name: str = "wrench") -> Input:
    """Wrench on the platform."""
    bound = HEADROOM * machine.tension.max * len(machine.cables)
    return bounded_input(name, (machine.dof,), "N", bound)


def torque(machine: Machine, name: str) -> Input:
    """Motor torques."""
    bound = HEADROOM * machine.tension.max * machine.drum.radius
    return bounded_input(name, (len(machine.cables),), "N m", bound)


def force(machine: Machine) -> Input:
    """Size of a force in any direction."""
    return make_input("force", (), "N", [0.0], [HEADROOM * machine.tension.max])
