"""What a simulated drive is before anyone configures it."""

from dataclasses import dataclass, field

from turnbuckle.model.bus.drive_kinds import epos4
from turnbuckle.model.bus.drive_kinds.kind import DriveKind


@dataclass(frozen=True)
class Ratings:
    """A motor, and the limits its drive was given."""

    nominal_current: float = 2.0  # A
    current_limit: float = 4.0  # A
    torque_constant: float = 0.03  # N m/A
    encoder_counts: int = 4096  # per turn
    inertia: float = 2e-5  # kg m^2, of all that the motor moves: what its loops are tuned for

    @property
    def rated_torque(self) -> float:
        """Torque of the nominal current [N m]."""
        return self.nominal_current * self.torque_constant


@dataclass(frozen=True)
class Identity:
    """Object 1018."""

    vendor: int = epos4.KIND.vendor
    product: int = epos4.KIND.simulated.product
    revision: int = epos4.KIND.simulated.revision
    serial: int = 1


@dataclass(frozen=True)
class Setup:
    """A drive as it is delivered, mounted and numbered."""

    node: int
    kind: DriveKind = epos4.KIND
    ratings: Ratings = field(default_factory=Ratings)
    identity: Identity = field(default_factory=Identity)
    boot_time: float = 0.2  # s, after power-on and NMT reset node
    start_count: int = 0  # of the encoder at power-on: that of a multi-turn encoder may be any
    restart_time: float = 0.02  # s, after NMT reset communication
