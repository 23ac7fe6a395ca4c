"""Power stage and motion of a simulated drive (CiA 402): controlword in, statusword and torque out.

Knows nothing of the bus. Errors come in by `react`; what has to be told about them is drive.py's.
"""

from dataclasses import replace

from turnbuckle.lab.drives import errors
from turnbuckle.lab.drives.errors import Reaction
from turnbuckle.lab.drives.motion import (
    Encoder,
    Homing,
    HomingParameters,
    PositionLoop,
    Ramp,
    Run,
    clip,
)
from turnbuckle.lab.drives.node import Objects
from turnbuckle.lab.drives.power import FAULT_RESET, MOVING, Command, Power, command, follow
from turnbuckle.lab.drives.setup import Ratings
from turnbuckle.model.bus.drive_kinds.kind import Option

START_HOMING = 0x10
VOLTAGE, WARNING, REMOTE, LIMITED, FOLLOWS, REFERENCED = (1 << bit for bit in (4, 7, 9, 11, 12, 15))
ENERGISED = (Power.READY, Power.ON, Power.ENABLED, Power.QUICK_STOP)
"""States in which bit 4 of the statusword is set."""
UNLIMITED_WINDOW = 0xFFFFFFFF

SLOW_DOWN, QUICK = 0x6084, 0x6085
"""Objects that hold the decelerations of ramps."""
QUICK_STOP_RAMP = {1: SLOW_DOWN, 2: QUICK, 5: SLOW_DOWN, 6: QUICK}
"""605A; 0 has no ramp."""
DISABLE_RAMP = {1: SLOW_DOWN}
"""605B and 605C; 0 has no ramp."""
FAULT_RAMP = {1: SLOW_DOWN, 2: QUICK}
"""605E; 0 has no ramp."""
ABORT_RAMP = {3: QUICK}
"""6007 of CiA 402; 1 and 2 have no ramp, 0 is no reaction at all."""
PROFILE_CODES = {"disable": 2, "quick_stop": 3, "off": 2, "hold": 6}
"""What CiA 402 has for the words of an option."""
LEAST_UNIT = 1e-9
"""Of torque, where a motor's data make none [N m]."""


class Servo:
    """Power stage, modes and motor of one drive."""

    def __init__(self, objects: Objects, ratings: Ratings, start_count: int = 0) -> None:
        self.power = Power.NOT_READY
        self.encoder = Encoder(ratings.encoder_counts, start_count)
        self.homing: Homing | None = None
        self.torque = 0.0  # N m
        self.false_statusword: int | None = None
        """Fault: the statusword that is reported, whatever the state."""
        self.given = 1.0
        """Fault: the motor gives so many times the torque that is told and reported."""
        self._objects, self._signals = objects, objects.signals
        self._kind, self._ratings = objects.kind, ratings
        self._modes = {code: word for word, code in objects.kind.modes.items()}
        self._speed = objects.kind.simulated.speed(ratings)  # rad/s
        self._inertia = ratings.inertia
        self._ramp: Ramp | None = None
        self._after_ramp = Power.OFF
        self._loop: PositionLoop | None = None
        self._seconds = 0.001
        self.switch_on()

    # -- power-on, resets ---------------------------------------------------------------------

    def switch_on(self) -> None:
        """Everything as after power-on."""
        self.encoder.restart()
        self.homing = None
        self._offset = 0
        self._referenced = self._warned = self._limited = False
        self.power = Power.NOT_READY
        self.read_ratings()
        self.restart()

    def restart(self) -> None:
        """Communication was reset: no torque; a fault remains, and may now be reset."""
        if self.power not in (Power.FAULT, Power.FAULT_REACTION):
            self.power = Power.NOT_READY
        self._rest()
        self._latched = False
        self._last_controlword = self._signals.controlword = 0

    def get_ready(self) -> None:
        """Booting is over (transition 1)."""
        if self.power is Power.NOT_READY:
            self.power = Power.OFF

    def read_ratings(self) -> None:
        """Take over the motor's data; the rated torque follows from them."""
        places, objects = self._kind.motor, self._objects
        ratings = self._ratings
        if places.nominal_current is not None:
            current = objects.held(places.nominal_current, ratings)
            ratings = replace(ratings, nominal_current=current)
        if places.torque_constant is not None:
            constant = objects.held(places.torque_constant, ratings)
            ratings = replace(ratings, torque_constant=constant)
        if places.rated_torque is not None:
            rated = places.rated_torque.number(ratings.rated_torque, ratings)
            objects.put(places.rated_torque.key, rated)
        self._amperes = ratings.torque_constant  # N m/A
        self._unit = max(self._kind.torque(ratings), LEAST_UNIT)  # N m
        self._limit = objects.held(places.current_limit, ratings) * self._amperes

    def _option(self, option: Option) -> int:
        """What an object of the kind chooses, as CiA 402 would say it."""
        value = self._objects[option.key]
        words = {code: word for word, code in option.codes.items()}
        return PROFILE_CODES[words[value]] if value in words else value

    @property
    def _mode(self) -> str:
        """What the drive follows; empty for nothing that a machine uses."""
        return self._modes.get(self._signals.mode_display, "")

    # -- controlword and statusword -----------------------------------------------------------

    def obey(self) -> bool:
        """Do what the controlword asks; whether it reset a fault."""
        word, last = self._signals.controlword, self._last_controlword
        self._last_controlword = word
        if self.power is Power.FAULT:
            return self._reset_fault(bool(word & ~last & FAULT_RESET))
        if self.power in (Power.FAULT_REACTION, Power.NOT_READY):
            return False
        works_on = self.power is Power.ENABLED and word == last and self._ramp is None
        if not works_on:
            self._go(command(word))
        if self.power is Power.ENABLED:
            self._obey_mode(word, last)
        return False

    def statusword(self, remote: bool) -> int:
        """Object 6041; remote tells whether NMT is operational."""
        if self.false_statusword is not None:
            return self.false_statusword
        word = self.power.value | self._mode_bits()
        if self.power in ENERGISED:
            word |= VOLTAGE
        if remote:
            word |= REMOTE
        if self._warned:
            word |= WARNING
        if self._limited:
            word |= LIMITED
        if self._referenced:
            word |= REFERENCED
        return word

    def _mode_bits(self) -> int:
        if self._mode == "homing":
            bits = (Run.INTERRUPTED if self.homing is None else self.homing.run).value
            return (bits & 1) << 10 | (bits >> 1) << 12
        follows = self._mode in ("torque", "position") and self.power is Power.ENABLED
        return FOLLOWS if follows else 0

    def _reset_fault(self, asked: bool) -> bool:
        if not asked or self._latched:
            return False
        self.power = Power.OFF
        self._warned = False
        self._signals.error_code = errors.NO_ERROR
        return True

    def _go(self, asked: Command) -> None:
        """Make the transition a command asks for, by way of a ramp where an option says so."""
        target = follow(self.power, asked, self._option(self._kind.quick_stop))
        if asked is Command.ENABLE and self.power is Power.ENABLED:
            self._ramp = None
        if target is self.power or (self._ramp and target is self._after_ramp):
            return
        if self.power is Power.ENABLED:
            self._leave_operation(target)
        elif target is Power.ENABLED:
            self.power = target
            self._begin_mode()
        else:
            self._stop(target)

    def _leave_operation(self, target: Power) -> None:
        objects = self._objects
        if target is Power.QUICK_STOP:
            option = self._option(self._kind.quick_stop)
            ramp = QUICK_STOP_RAMP.get(option)
            self._stop(target if ramp else Power.OFF)
            self._start_ramp(ramp, target if option in (5, 6) else Power.OFF)
        elif target is Power.OFF:
            self._stop(target)
        else:
            option = objects.option(0x605C if target is Power.ON else 0x605B)
            if option in DISABLE_RAMP:
                self._start_ramp(DISABLE_RAMP[option], target)
            else:
                self._stop(target)

    def _start_ramp(self, deceleration: int | None, after: Power) -> None:
        if deceleration is not None:
            slope = self._objects[deceleration, 0] * self._speed
            self._ramp = Ramp(self.encoder.speed, slope, self._inertia)
            self._after_ramp = after

    def _stop(self, target: Power) -> None:
        self._rest()
        self.power = target

    def _rest(self) -> None:
        """Leave no loop running."""
        self._ramp = self._loop = None
        self._limited = False
        if self.homing is not None:
            self.homing.interrupt()

    # -- errors -------------------------------------------------------------------------------

    def react(self, code: int) -> None:
        """Do what an error asks for."""
        reaction, simulated = errors.reaction(self._kind, code), self._kind.simulated
        self._latched = self._latched or code in simulated.latched
        if reaction is Reaction.WARNING:
            self._warned = True
            return
        if reaction is Reaction.ABORT_OPTION and self._option(self._kind.connection_loss) == 0:
            return
        self._signals.error_code = code
        if code in simulated.homing_lost:
            self._referenced, self.homing = False, None
        if self.power is not Power.FAULT:
            moving = self.power in MOVING
            self._stop(Power.FAULT_REACTION)
            if moving:
                self._start_ramp(self._fault_ramp(reaction), Power.FAULT)

    def abort_connection(self) -> None:
        """NMT leaves operation by command: as after a lost connection, without an error."""
        option = self._option(self._kind.connection_loss)
        if self.power is Power.ENABLED and option:
            self._go(Command.QUICK_STOP if option == 3 else Command.DISABLE_VOLTAGE)

    def _fault_ramp(self, reaction: Reaction) -> int | None:
        if reaction is Reaction.FAULT_OPTION:
            return FAULT_RAMP.get(self._objects.option(0x605E))
        if reaction is Reaction.ABORT_OPTION:
            return ABORT_RAMP.get(self._option(self._kind.connection_loss))
        return None

    # -- motion -------------------------------------------------------------------------------

    @property
    def position(self) -> int:
        """Object 6064 [inc]."""
        return (self.encoder.count + self._offset + (1 << 31) & 0xFFFFFFFF) - (1 << 31)

    def refresh(self) -> None:
        """Bring the objects of position, speed and torque up to date."""
        signals = self._signals
        signals.position = self.position
        signals.velocity = round(self.encoder.speed / self._speed)
        signals.torque = clip_word(round(self.torque / self._unit))
        signals.current = round(1000.0 * self.torque / self._amperes) if self._amperes else 0

    def drive(self, seconds: float) -> float:
        """Let time pass; the motor's torque [N m] during it."""
        self._seconds = seconds
        if self._signals.mode != self._signals.mode_display:
            self._signals.mode_display = self._signals.mode
            self._rest()
            self.homing = None
            if self.power is Power.ENABLED:
                self._begin_mode()
        self.torque = self._drive_motor(seconds) if self.power in MOVING else 0.0
        return self.torque * self.given

    def following_error(self) -> bool:
        """Whether the target is further away than object 6065 allows."""
        window = self._objects[0x6065, 0]
        return (
            self._loop is not None
            and self._ramp is None
            and self._mode == "position"
            and window != UNLIMITED_WINDOW
            and abs(self._loop.target - self.position) > window
        )

    def _begin_mode(self) -> None:
        self._ramp = None
        if self._mode not in ("torque", "homing"):
            self._loop = self._loop_here()

    def _loop_here(self) -> PositionLoop:
        return PositionLoop(self._inertia, self.encoder.per_radian, self.position)

    def _obey_mode(self, word: int, last: int) -> None:
        signals = self._signals
        if self._mode == "position" and self._loop is not None:
            interval = self._objects[0x60C2, 1] * 1e-3
            self._loop.aim(signals.target_position, round(interval / self._seconds))
        elif self._mode == "homing":
            if word & ~last & START_HOMING:
                self.homing = Homing(self._homing_parameters(), self._inertia, self.encoder)
                self._referenced, self._loop = False, None
            elif not word & START_HOMING and self.homing is not None:
                self.homing.interrupt()

    def _homing_parameters(self) -> HomingParameters:
        homing, objects, ratings = self._kind.homing, self._objects, self._ratings
        assert homing is not None  # there is a mode for it
        directions = {homing.forward: 1.0, homing.backward: -1.0}
        search, offset = homing.search or homing.speed, homing.offset
        return HomingParameters(
            direction=directions.get(objects[0x6098, 0], 0.0),
            approach=objects.held(homing.speed, ratings),
            search=objects.held(search, ratings),
            acceleration=objects.held(homing.acceleration, ratings),
            threshold=objects.held(homing.threshold, ratings) * self._amperes,
            offset=round(objects.held(offset, ratings)) if offset is not None else 0,
            position=round(objects.held(homing.home, ratings)),
        )

    def _drive_motor(self, seconds: float) -> float:
        if self._ramp is not None:
            return self._follow_ramp(self._ramp, seconds)
        if self.power is Power.FAULT_REACTION:
            self._stop(Power.FAULT)
            return 0.0
        signals = self._signals
        if self.power is Power.ENABLED and self._mode == "torque":
            wanted = (signals.target_torque + signals.torque_offset) * self._unit
            self._limited = abs(wanted) > self._limit
            return clip(wanted, self._limit)
        if self._mode == "homing" and self.homing is not None:
            return self._home(self.homing, seconds)
        if self._loop is None:
            self._loop = self._loop_here()
        torque = self._loop.torque(self.position, self.encoder.speed, self._limit, seconds)
        signals.position_demand = round(self._loop.demand)
        return torque

    def _follow_ramp(self, ramp: Ramp, seconds: float) -> float:
        torque = ramp.torque(self.encoder.speed, self._limit, seconds)
        if ramp.done:
            self._stop(self._after_ramp)
        return torque if self.power in MOVING else 0.0

    def _home(self, homing: Homing, seconds: float) -> float:
        torque = homing.torque(self._limit, seconds)
        if homing.home is not None and not self._referenced:
            self._offset = homing.position - homing.home
            self._referenced = True
        return torque


def clip_word(value: int) -> int:
    """The nearest value that an I16 holds."""
    return min(max(value, -0x8000), 0x7FFF)
