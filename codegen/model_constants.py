"""The machine's numbers that the model's equations read, as further constants of tb_machine.h.

These constants do not enter the hash of the machine: the functions that read them do.
"""

import math
from collections.abc import Sequence

from turnbuckle.codegen.constants import Constant
from turnbuckle.codegen.print_c import literal
from turnbuckle.model.machine import Machine

AXES = "XYZ"


def model_constants(machine: Machine) -> list[list[Constant]]:
    """All of these constants, in groups that belong together."""
    groups = [
        tensions(machine),
        control(machine),
        rail_control(machine),
        observer(machine),
        walls(machine),
        frame(machine),
        rail_lengths(machine),
        pulleys(machine),
        bases(machine),
        anchors(machine),
    ]
    return [group for group in groups if group]


def tensions(machine: Machine) -> list[Constant]:
    """What the bounds of the tensions make."""
    low, high = machine.tension.min, machine.tension.max
    return [
        real("TB_TENSION_MIDDLE", (low + high) / 2, "N, middle of the bounds"),
        real("TB_TENSION_HALF_RANGE", (high - low) / 2, "N, from the middle to a bound"),
    ]


def control(machine: Machine) -> list[Constant]:
    """The rate."""
    return [real("TB_CONTROL_RATE", 1 / (1 / machine.control.rate), "Hz")]


def rail_control(machine: Machine) -> list[Constant]:
    """The position control of the bases."""
    drive = machine.rail_drive
    if drive is None:
        return []
    period = 1 / machine.control.rate
    weight = 1 - math.exp(-2 * math.pi * drive.derivative_corner * period)
    return [
        real("TB_RAIL_STIFFNESS", drive.stiffness, "N/m"),
        real("TB_RAIL_DAMPING", drive.damping, "N s/m"),
        real("TB_RAIL_INTEGRAL_STEP", drive.integral * period, "N/m, of one cycle"),
        real("TB_RAIL_SPEED_GAIN", weight, "low-pass of a base's speed"),
    ]


def observer(machine: Machine) -> list[Constant]:
    """The disturbance observer, discretised by Tustin's rule; tau is the filter's time constant."""
    found = machine.disturbance_observer
    if found is None:
        return []
    ratio = 2 * found.time_constant * machine.control.rate
    rate = 2 * machine.control.rate / (ratio + 1)
    motor = machine.cable_motor
    return [
        real("TB_OBSERVER_POLE", (ratio - 1) / (ratio + 1), "of 1/(tau s + 1)"),
        real("TB_OBSERVER_GAIN", 1 / (ratio + 1), "of 1/(tau s + 1)"),
        real("TB_OBSERVER_SPEED_GAIN", rate / machine.drum.radius, "rad/(s m), of s/(tau s + 1)"),
        real("TB_OBSERVER_INERTIA_GAIN", rate * motor.inertia, "N m s, of J s/(tau s + 1)"),
        real("TB_OBSERVER_DAMPING", motor.damping, "N m s/rad, nominal"),
    ]


def walls(machine: Machine) -> list[Constant]:
    """The virtual walls."""
    return [
        constant
        for number, wall in enumerate(machine.walls, start=1)
        for constant in (
            real(f"TB_WALL_{number}_STIFFNESS", wall.stiffness, f"N/m, {wall.name}"),
            real(f"TB_WALL_{number}_DAMPING", wall.damping, f"N s/m, {wall.name}"),
            *point(f"TB_WALL_{number}", wall.point, f"m, {wall.name}"),
        )
    ]


def frame(machine: Machine) -> list[Constant]:
    """The sides of the frame, and what a moment is divided by to be compared with forces."""
    named = each("TB_FRAME", AXES, machine.frame.size, "m, side of the frame")
    if not machine.is_rigid:
        return named
    return [
        *named,
        real("TB_LEVER", machine.lever, "m, root mean square of the anchors' distances"),
        real("TB_MOMENT_WEIGHT", 1 / machine.lever, "1/m, of moments in norms of wrenches"),
    ]


def rail_lengths(machine: Machine) -> list[Constant]:
    """How far the bases go."""
    lengths = [rail.length for rail in machine.rails]
    numbers = [str(number) for number in range(1, len(lengths) + 1)]
    return each("TB_RAIL_LENGTH", numbers, lengths, "m, of a rail")


def pulleys(machine: Machine) -> list[Constant]:
    """Radii of the pulleys."""
    radii = [pulley.radius for pulley in machine.pulleys if pulley]
    if len(radii) < len(machine.cables):
        return []
    numbers = [str(number) for number in range(1, len(radii) + 1)]
    return each("TB_PULLEY_RADIUS", numbers, radii, "m, of a pulley")


def bases(machine: Machine) -> list[Constant]:
    """Where the pulley points are, or begin."""
    return [
        constant
        for number, motion in enumerate(machine.base_motions, start=1)
        for constant in point(f"TB_BASE_{number}", motion.start, f"m, base of cable {number}")
    ]


def anchors(machine: Machine) -> list[Constant]:
    """Where a platform holds its cables, from its centre."""
    return [
        constant
        for number, place in enumerate(machine.anchors, start=1)
        for constant in point(f"TB_ANCHOR_{number}", place, f"m, anchor of cable {number}")
    ]


def point(name: str, coordinates: Sequence[float], meaning: str) -> list[Constant]:
    """The coordinates of a point."""
    return [
        real(f"{name}_{axis}", coordinate, meaning)
        for axis, coordinate in zip(AXES, coordinates, strict=False)
    ]


def each(
    name: str, endings: Sequence[str], values: Sequence[float], meaning: str
) -> list[Constant]:
    """One constant for all where all are the same, else one for each."""
    if len(set(values)) == 1:
        return [real(name, values[0], meaning)]
    return [
        real(f"{name}_{ending}", value, meaning)
        for ending, value in zip(endings, values, strict=False)
    ]


def real(name: str, value: float, meaning: str) -> Constant:
    """A constant of type real_t that can be an operand."""
    text = literal(value)
    return Constant(name, text if value >= 0 else f"({text})", meaning)
