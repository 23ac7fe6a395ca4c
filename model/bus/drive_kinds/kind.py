"""What one kind of CiA 402 drive has of its own, as data.

The contract, the limits of the machine file's numbers, the DBC, the tables of the generated C and
the simulated drive are made from it. What all kinds share is not said here: states and words of
CiA 402, one PDO either way (6040 with 6071 or 607A; 6041, 6064, 6077) with every SYNC, 6098 for
the way of homing.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import Protocol

from turnbuckle.model.bus.drive_kinds.entry import Entry, Key

#: Beyond what any object holds.
ENDLESS = 2.0**64


class Motor(Protocol):
    """A motor with its encoder; a table `rating` of a machine file is one."""

    @property
    def nominal_current(self) -> float:
        """What the motor carries for any time [A]."""

    @property
    def torque_constant(self) -> float:
        """[N m/A]"""

    @property
    def encoder_counts(self) -> int:
        """Counts a turn, as the drive counts them in 6064."""


Unit = Callable[[Motor], float]
"""What a number of the drive is multiplied with to get the quantity, for a motor."""


def fixed(value: float) -> Unit:
    """A unit that does not depend on the motor."""
    return lambda motor: value


TURN_A_MINUTE = fixed(2 * math.pi / 60)
"""As a unit of speed [rad/s]."""


@dataclass(frozen=True)
class Place:
    """An object that holds a quantity.

    size [bytes]; unit: of the object, in `symbol`; lowest, highest: numbers that it may hold, by
    default all that its size holds; whole: only quantities that are whole units.
    """

    index: int
    subindex: int
    size: int
    meaning: str
    unit: Unit
    symbol: str
    signed: bool = False
    lowest: int | None = None
    highest: int | None = None
    whole: bool = False

    @property
    def key(self) -> Key:
        """Index and subindex."""
        return self.index, self.subindex

    @property
    def bounds(self) -> tuple[int, int]:
        """Smallest and largest number that it may hold."""
        bits = 8 * self.size - self.signed
        low, high = (-(1 << bits) if self.signed else 0), (1 << bits) - 1
        return (
            low if self.lowest is None else self.lowest,
            high if self.highest is None else self.highest,
        )

    def number(self, quantity: float, motor: Motor) -> int:
        """The number nearest to a quantity."""
        ratio = quantity / self.unit(motor)
        return round(min(max(ratio, -ENDLESS), ENDLESS))


@dataclass(frozen=True)
class MotorObjects:
    """Where the drive knows its motor from: all but the limit are read and compared.

    None where the drive has no such object. rated_torque [N m], nominal_current, current_limit [A],
    torque_constant [N m/A], encoder [counts].
    """

    current_limit: Place
    rated_torque: Place | None = None
    nominal_current: Place | None = None
    torque_constant: Place | None = None
    encoder: Place | None = None

    @property
    def read(self) -> tuple[tuple[Place, Callable[[Motor], float]], ...]:
        """The objects that are compared, each with its quantity, in the order of reading."""
        pairs: tuple[tuple[Place | None, Callable[[Motor], float]], ...] = (
            (self.rated_torque, lambda motor: motor.nominal_current * motor.torque_constant),
            (self.nominal_current, lambda motor: motor.nominal_current),
            (self.torque_constant, lambda motor: motor.torque_constant),
            (self.encoder, lambda motor: motor.encoder_counts),
        )
        return tuple((place, quantity) for place, quantity in pairs if place is not None)

    @property
    def places(self) -> tuple[Place, ...]:
        """All of them."""
        return *(place for place, _ in self.read), self.current_limit


def per_mille_of_rated_torque(rated_torque: Place) -> Unit:
    """A unit of 6071 as CiA 402 has it, of the rated torque as the drive knows it [N m]."""

    def unit(motor: Motor) -> float:
        torque = motor.nominal_current * motor.torque_constant
        return rated_torque.number(torque, motor) * rated_torque.unit(motor) / 1000

    return unit


@dataclass(frozen=True)
class Option:
    """An object that chooses what the drive does; codes: by the machine file's word for it."""

    index: int
    subindex: int
    size: int
    meaning: str
    codes: Mapping[str, int]

    @property
    def key(self) -> Key:
        """Index and subindex."""
        return self.index, self.subindex


@dataclass(frozen=True)
class HomingObjects:
    """Homing against a mechanical stop: the codes of 6098, and the objects that describe it.

    forward, backward: towards a stop that the motor meets turning that way; here: home is where the
    motor stands, where the drive has that. speed, search [rad/s], acceleration [rad/s^2];
    threshold: the current that tells the stop [A]; home: the count that the drive then has
    [counts]; offset: how far it moves off the stop [counts], which is set to 0.
    """

    forward: int
    backward: int
    threshold: Place
    speed: Place
    acceleration: Place
    home: Place
    search: Place | None = None
    offset: Place | None = None
    here: int | None = None

    @property
    def methods(self) -> tuple[int, ...]:
        """Codes of 6098."""
        known = {self.forward, self.backward} | ({self.here} if self.here is not None else set())
        return tuple(sorted(known))

    @property
    def places(self) -> tuple[Place, ...]:
        """Its objects, in the order of writing."""
        named = (
            self.threshold,
            self.speed,
            self.search,
            self.acceleration,
            self.offset,
            self.home,
        )
        return tuple(place for place in named if place is not None)


class Severity(Enum):
    """How bad an emergency is; the names are those of tb_error_class."""

    WARNING = "for people to read: the machine goes on"
    FAULT = "the power stage is off or going off"
    COMMUNICATION = "as a fault; only a reset of the communication clears it"


@dataclass(frozen=True)
class DriveError:
    """Error codes of the drive's maker, from one to another, both included, in words."""

    first: int
    last: int
    text: str
    severity: Severity = Severity.FAULT


def error(code: int, text: str, severity: Severity = Severity.FAULT) -> DriveError:
    """A single code."""
    return DriveError(code, code, text, severity)


@dataclass(frozen=True)
class Setting:
    """An object that the drive needs to be written beside what every drive is; size [bytes]."""

    index: int
    subindex: int
    size: int
    value: int
    meaning: str


@dataclass(frozen=True)
class Simulated:
    """What the simulated drive has beyond the rest: it obeys CiA 402 and the kind's own objects.

    product, revision: what it says it is, where the machine file does not care. objects: in
    addition to those of CiA 301 and CiA 402, or in place of one of them, or of the entry that is
    made of a `Place` or `Option`. fault_option, abort_option: error codes after which it does what
    605E, or the option of the lost connection, says; it switches off after any other but a warning.
    latched: only a reset of the communication clears it; homing_lost: the position no longer refers
    to home. speed: a unit of 606C, 6084 and 6085 [rad/s, rad/s^2]. wrong_state, map_in_use: how
    it aborts a change of PDOs outside of pre-operational, or of a map whose entries count.
    """

    product: int = 0
    revision: int = 0
    objects: tuple[Entry, ...] = ()
    fault_option: frozenset[int] = frozenset({0x8611})
    abort_option: frozenset[int] = frozenset({0x8130, 0x8210})
    latched: frozenset[int] = frozenset()
    homing_lost: frozenset[int] = frozenset()
    speed: Unit = TURN_A_MINUTE
    wrong_state: int = 0x08000022
    map_in_use: int = 0x06010000


#: Objects of CiA 301 and CiA 402 that are written where a drive has them.
OPTIONAL = frozenset({0x1029, 0x605B, 0x605C, 0x605E})
MODES = frozenset({"torque", "position", "homing"})
SIZES = frozenset({1, 2, 4})
"""Of what is written or read at once [bytes]."""


@dataclass(frozen=True, eq=False)
class DriveKind:
    """A kind of drive.

    name: in machine files; vendor: 1018:1; torque: a unit of 6071 and 6077 [N m], torque_unit: the
    same in words; modes: codes of 6060 for "torque", "homing" and "position", for those that the
    drive has; pdos: either way, of which all but the first are switched off; lacks: which of
    OPTIONAL the drive has not; homing: None for a drive that cannot move a base; aborts: SDO abort
    codes of its maker.
    """

    name: str
    meaning: str
    vendor: int
    motor: MotorObjects
    torque: Unit
    torque_unit: str
    modes: Mapping[str, int]
    connection_loss: Option
    quick_stop: Option
    homing: HomingObjects | None
    pdos: int = 4
    settings: tuple[Setting, ...] = ()
    lacks: frozenset[int] = frozenset()
    errors: tuple[DriveError, ...] = ()
    aborts: Mapping[int, str] = field(default_factory=dict)
    simulated: Simulated = Simulated()

    def __post_init__(self) -> None:
        """ValueError, with the kind's name, for what no machine could be run with."""
        for wrong in self._wrong():
            raise ValueError(f"{self.name}: {wrong}")

    def _wrong(self) -> Iterator[str]:
        if needed := self.lacks - OPTIONAL:
            allowed = ", ".join(f"{index:04X}" for index in sorted(OPTIONAL))
            found = ", ".join(f"{index:04X}" for index in sorted(needed))
            yield f"a machine cannot do without {found}; `lacks` may name {allowed}"
        if self.error_of(0) is not None:
            yield "the error code 0 says that there is none"
        if unknown := self.modes.keys() - MODES:
            yield f"`modes` has {', '.join(sorted(unknown))}; allowed: {', '.join(sorted(MODES))}"
        if self.homing is not None and "homing" not in self.modes:
            yield "`modes` has no homing, which the objects `homing` need"
        if self.pdos < 1:
            yield f"`pdos` is {self.pdos}; every drive has one PDO either way"
        for held in self._objects:
            if held.size not in SIZES:
                key = f"{held.index:04X}:{held.subindex:02X}"
                yield f"object {key} has {held.size} bytes; allowed: 1, 2 or 4"

    @property
    def _objects(self) -> tuple[Place | Option | Setting, ...]:
        of_homing = () if self.homing is None else self.homing.places
        options = self.connection_loss, self.quick_stop
        return *self.motor.places, *of_homing, *options, *self.settings

    def error_of(self, code: int) -> DriveError | None:
        """What its maker says of an error code."""
        return next((error for error in self.errors if error.first <= code <= error.last), None)
