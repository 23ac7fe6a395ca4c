"""A drive together with what it moves: scales between its numbers and metres and newton metres."""

import math
from dataclasses import dataclass

from turnbuckle.model.bus.drive_kinds import DRIVE_KINDS
from turnbuckle.model.bus.drive_kinds.kind import DriveKind
from turnbuckle.model.bus.tables import Drive, Rating
from turnbuckle.model.machine import Machine

# A quotient of rounded numbers may miss a whole number by this much.
ROUNDING = 1e-9


@dataclass(frozen=True)
class Axis:
    """A drive with its motor, on a drum or on the pinion of a rail.

    bus: number of its bus; radius [m]; torque_limit [N m]; rail: number of the rail coordinate,
    None for a cable.
    """

    drive: Drive
    bus: int
    rating: Rating
    radius: float
    torque_limit: float
    rail: int | None = None

    @property
    def kind(self) -> DriveKind:
        """What is special to the drive."""
        return DRIVE_KINDS[self.drive.kind]

    @property
    def sense(self) -> int:
        """+1 where the encoder counts up as the position grows, else -1."""
        return 1 if self.drive.direction == "forward" else -1

    @property
    def metres_per_increment(self) -> float:
        """Change of position (cable wound in, or rail coordinate) an encoder count [m]."""
        return self.sense * 2 * math.pi * self.radius / self.rating.encoder_counts

    @property
    def torque_per_unit(self) -> float:
        """Torque, > 0 pulling or towards the rail's end, a unit of 6071 and 6077 [N m]."""
        return self.sense * self.kind.torque(self.rating)

    @property
    def most_torque_units(self) -> int:
        """Most units of 6071 within the torque limit, either way."""
        return torque_units(self.torque_limit, abs(self.torque_per_unit))

    def increments(self, position: float) -> int:
        """The encoder count nearest to a position [m]."""
        return round(position / self.metres_per_increment)


def torque_units(limit: float, unit: float) -> int:
    """Most units [N m] within a torque limit [N m]."""
    return math.floor(limit / unit + ROUNDING)


def base_drive(rail: int) -> str:
    """Name of the drive of a rail coordinate, numbered from 0."""
    return f"base_{rail + 1}"


def drive_names(machine: Machine) -> list[str]:
    """Names of all drives in order: of the cables, then of the rail coordinates."""
    cables = [cable.drive for cable in machine.cables]
    return cables + [base_drive(rail) for rail in range(len(machine.rails))]


def axes(machine: Machine) -> list[Axis]:
    """All drives, in the order of drive_names; none where the machine has no buses."""
    if not machine.buses:
        return []
    drives = {drive.name: drive for drive in machine.drives}
    return [
        _axis(machine, drives[name], number) for number, name in enumerate(drive_names(machine))
    ]


def _axis(machine: Machine, drive: Drive, number: int) -> Axis:
    bus = [bus.name for bus in machine.buses].index(drive.bus)
    motor, rail_drive = machine.cable_motor, machine.rail_drive
    if number < len(machine.cables):
        assert motor.rating is not None  # load_machine has seen to it
        return Axis(drive, bus, motor.rating, machine.drum.radius, motor.torque_limit)
    assert rail_drive is not None and rail_drive.rating is not None
    radius = rail_drive.pinion_radius
    limit = rail_drive.force_limit * radius
    return Axis(drive, bus, rail_drive.rating, radius, limit, number - len(machine.cables))
