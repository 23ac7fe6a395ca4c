"""The machine's numbers that the runtime needs, as constants of tb_machine.h."""

import math
from dataclasses import dataclass

from turnbuckle.codegen.print_c import literal
from turnbuckle.model.machine import Machine
from turnbuckle.model.symbolic.forward_kinematics import needs_guess


@dataclass(frozen=True)
class Constant:
    """One #define."""

    name: str
    text: str
    meaning: str = ""


def constants(machine: Machine) -> list[list[Constant]]:
    """All constants, in groups that belong together."""
    groups = [
        sizes(machine),
        start(machine),
        platform(machine),
        cycle(machine),
        cables(machine),
        rails(machine),
        observer(machine),
    ]
    return [group for group in groups if group]


def sizes(machine: Machine) -> list[Constant]:
    """How many of what."""
    rail_count = len(machine.rails)
    return [
        Constant("TB_DOF", str(machine.dof), "degrees of freedom of the platform"),
        Constant("TB_CABLES", str(len(machine.cables))),
        Constant("TB_RAILS", str(rail_count), "movable bases"),
        Constant("TB_RAIL_SLOTS", str(max(1, rail_count)), "entries of an array of rails"),
        Constant("TB_WALLS", str(len(machine.walls)), "virtual walls"),
    ]


def start(machine: Machine) -> list[Constant]:
    """Where the search for the pose begins, of machines whose pose has no closed form."""
    if not needs_guess(machine):
        return []
    upright = [0.0] * (machine.dof - machine.space)
    entries = ", ".join(literal(value) for value in [*machine.target.centre, *upright])
    meaning = "the target's centre, upright: the first guess of the pose"
    return [Constant("TB_START_POSE", f"{{{entries}}}", meaning)]


def platform(machine: Machine) -> list[Constant]:
    """How far from its centre a rigid platform is held."""
    if not machine.is_rigid:
        return []
    longest = max(math.hypot(*anchor) for anchor in machine.anchors)
    return [
        Constant("TB_SPACE", str(machine.space), "entries of a pose that are a position"),
        real("TB_LONGEST_ARM", longest, "m, from the platform's centre to its farthest anchor"),
    ]


def cycle(machine: Machine) -> list[Constant]:
    """Timing."""
    period = 1 / machine.control.rate
    return [
        real("TB_PERIOD", period, "s, one control cycle"),
        real(
            "TB_VELOCITY_GAIN",
            1 - math.exp(-2 * math.pi * machine.control.velocity_corner * period),
            "low-pass of the measured rates",
        ),
    ]


def cables(machine: Machine) -> list[Constant]:
    """Tension and torque limits."""
    motor = machine.cable_motor
    return [
        real("TB_TENSION_MIN", machine.tension.min, "N"),
        real("TB_TENSION_MAX", machine.tension.max, "N"),
        real("TB_DRUM_RADIUS", machine.drum.radius, "m"),
        real("TB_TORQUE_LIMIT", motor.torque_limit, "N m, most that a cable motor is asked for"),
        real(
            "TB_TORQUE_STEP",
            motor.torque_rate_limit / machine.control.rate,
            "N m, largest change of a torque in one cycle",
        ),
    ]


def rails(machine: Machine) -> list[Constant]:
    """Limits of the base drives."""
    drive = machine.rail_drive
    if drive is None:
        return []
    return [
        real("TB_PINION_RADIUS", drive.pinion_radius, "m"),
        real("TB_RAIL_FORCE_LIMIT", drive.force_limit, "N"),
    ]


def observer(machine: Machine) -> list[Constant]:
    """Whether there is a disturbance observer, and whether it knows the force of the hand."""
    present = machine.disturbance_observer
    measured = present is not None and present.hand_force == "measured"
    return [
        Constant("TB_HAS_OBSERVER", str(int(present is not None))),
        Constant("TB_HAND_FORCE_MEASURED", str(int(measured))),
    ]


def real(name: str, value: float, meaning: str) -> Constant:
    """A constant of type real_t."""
    return Constant(name, literal(value), meaning)
