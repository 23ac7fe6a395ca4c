"""What a simulated drive is before anyone configures it."""

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Ratings:
    """A motor, and the limits its drive was given."""

    nominal_current: int = 2000  # mA
    current_limit: int = 4000  # mA
    torque_constant: int = 30_000  # uN m/A
    encoder_pulses: int = 1024  # per turn; four increments each
    inertia: float = 2e-5  # kg m^2, of all that the motor moves: what its loops are tuned for

    @property
    def rated_torque(self) -> int:
        """Torque of the nominal current [uN m]: object 6076."""
        return self.nominal_current * self.torque_constant // 1000


@dataclass(frozen=True)
class Identity:
    """Object 1018."""

    vendor: int = 0x000000FB
    product: int = 0x61500000
    revision: int = 0x01700000
    serial: int = 1


@dataclass(frozen=True)
class Setup:
    """A drive as it is delivered, mounted and numbered."""

    node: int
    ratings: Ratings = field(default_factory=Ratings)
    identity: Identity = field(default_factory=Identity)
    boot_time: float = 0.2  # s, after power-on and NMT reset node
    start_count: int = 0  # of the encoder at power-on: that of a multi-turn encoder may be any
    restart_time: float = 0.02  # s, after NMT reset communication
