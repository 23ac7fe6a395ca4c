"""Every fault of the campaign: how it is done to the machine, and how it shows.

A fault stands from the strike on where its name does not say "once". How it shows is told for
torque-following drives that are set up as machines/yoon2023.toml says; what the supervisor does
about what it sees is docs/safety.md's affair.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from math import inf, nan

from journey import BEFORE_SERVICE, GUIDED, POWERED, SERVICE

from turnbuckle.lab.drives.bus import Disturbance, Frame, Mishap
from turnbuckle.lab.drives.drive import Drive
from turnbuckle.lab.drives.setup import Identity, Setup
from turnbuckle.lab.lockstep import BusState, Lockstep

SYNC, TPDO, RPDO, SDO_ANSWER, HEARTBEAT = 0x080, 0x180, 0x200, 0x580, 0x700
MASTERS_HEARTBEAT = 0x77F
ALWAYS = 100_000
"""Frames or cycles, more than any run has."""
HEARTBEAT_LOST = 50
"""Cycles in which a drive that hears none has switched itself off: object 1016 and a heartbeat."""
BOOTED = 210
"""Cycles in which a drive whose supply has come boots."""
SET_UP = 600
"""Cycles from INIT to the end of CONFIGURE CONTRACT."""
CALIBRATED = 9000
"""Cycles from HOME BASE_HOMING to TENSION."""
TRIAL = 200
"""Cycles of HOME TRY_BASES and the phase after it."""
SWEPT = 2000
"""Cycles in which all bases have moved about in HOME SWEEP."""
MOVED = 400
"""Cycles in which a handle that the hand leads is at another place, and so are the bases."""
LED = 2000
"""Cycles in which the hand leads handle and bases through a good part of where they can be."""
SOLVED = 2500
"""Cycles from HOME SWEEP to the end of its calibration."""
TRIED = 2000
"""Cycles from HOME TIGHTEN until the bases' drives have changed to the mode of their trial."""
INIT, IDENTIFY, CONTRACT = BEFORE_SERVICE
READY, TIGHTEN, TRY_BASES, HOMING, SWEEP, TENSION, RUN, SOFT_STOP = SERVICE
AT_WORK = (TENSION, RUN)

Strike = Callable[[Lockstep], None]


@dataclass(frozen=True)
class Sign:
    """One way in which a fault shows: as this cause, to be seen `after` so many cycles at the
    latest (an expression of the constants of tb_drives.h, `divider` and DRIVES_ON_BUS), at these
    moments."""

    cause: str
    after: str = "0"
    moments: tuple[str, ...] = SERVICE


@dataclass(frozen=True)
class Fault:
    """One fault.

    strike does it; each: what goes on in every cycle, told how many there were; stands_still:
    cycles in which the master does nothing, and is told of afterwards.
    """

    name: str
    signs: tuple[Sign, ...] = ()
    strike: Strike = lambda lockstep: None
    each: Callable[[Lockstep, int], None] = lambda lockstep, cycle: None
    stands_still: int = 0
    drives: tuple[int, ...] = ()
    """Which may be blamed."""
    bus: int = 0
    """Which may be blamed."""
    divider: int = 1
    deaf: bool = False
    """A drive hears no orders any more, or will not obey: it gives up by itself."""
    powerless: bool = False
    """A drive has no torque from the strike on."""
    strong: bool = False
    """Cables are pulled, or bases led, by something else than the controller."""
    brakes: bool = False
    """A drive may take its order for another one, and brake before it switches off."""


@dataclass(frozen=True)
class Target:
    """A drive that faults strike."""

    name: str
    number: int
    bus: int
    node: int
    divider: int
    powered: tuple[str, ...]
    """Moments at which it is switched on."""
    known: tuple[str, ...]
    """Moments at which its encoder is judged."""

    def of(self, lockstep: Lockstep) -> Drive:
        """The drive."""
        return lockstep.machine.drives[self.number]

    def fault(self, name: str, signs: tuple[Sign, ...], strike: Strike, **traits: bool) -> Fault:
        """A fault of this drive."""
        full = f"{self.name}: {name}"
        known = {"drives": (self.number,), "bus": self.bus, "divider": self.divider}
        return Fault(full, signs, strike, **known, **traits)  # type: ignore[arg-type]

    def disturb(self, base: int, what: Disturbance, count: int) -> Strike:
        """Frames from or to it."""
        return lambda lockstep: lockstep.machine.buses[self.bus].disturb(
            base + self.node, what, count
        )

    def act(self, act: Callable[[Drive], None]) -> Strike:
        """Something about it."""
        return lambda lockstep: act(self.of(lockstep))


CABLE = Target("cable_2", 1, 0, 2, 1, POWERED, SERVICE)
BASE = Target("base_2", 5, 2, 2, 2, (TRY_BASES, HOMING, *GUIDED), GUIDED)
TARGETS = (CABLE, BASE)

DROP = Disturbance(Mishap.DROP)
TWICE = Disturbance(Mishap.DUPLICATE)
SHORT = Disturbance(Mishap.SHORTEN)
LATE = Disturbance(Mishap.DELAY, 1)


def flip(hexadecimal: str) -> Disturbance:
    """Bits that are flipped, as they lie in the frame."""
    return Disturbance(Mishap.CORRUPT, flips=bytes.fromhex(hexadecimal))


# -- signs that several faults have ---------------------------------------------------------------

SYNCS = "(TB_MISSED_LIMIT + 1) * divider"
START = f"{SET_UP} + TB_STATE_TIMEOUT"
"""By when the last drive must have been started."""
ASKED_THRICE = "3 * (DRIVES_ON_BUS + TB_ANSWER_TIMEOUT)"
"""By when an SDO request and its two repetitions are not answered."""
NO_ANSWER = (
    Sign("DRIVE_MISSING", "TB_STATE_TIMEOUT", (INIT,)),
    Sign("DRIVE_MISSING", ASKED_THRICE, (IDENTIFY,)),
    Sign("DRIVE_SETUP", ASKED_THRICE, (CONTRACT,)),
)
NOT_STARTED = Sign("DRIVE_SETUP", START, (CONTRACT,))
SILENT = Sign("DRIVE_SILENT", SYNCS)
NO_BOOT_UP = Sign("DRIVE_MISSING", "TB_STATE_TIMEOUT", (INIT,))
MALFORMED_BOOT_UP = Sign("BUS_CORRUPT", "TB_STATE_TIMEOUT", (INIT,))

OPENS = ("CABLE_SLACK", "CABLE_BREAK", "CLOSURE")
"""What lengths that do not belong together show as, once the platform or a base is elsewhere."""
OPENED = tuple(Sign(cause, str(LED), AT_WORK) for cause in OPENS)
UNSOLVED = Sign("CALIBRATION", str(SOLVED), (SWEEP,))
UNTRUE = (*OPENED, UNSOLVED)
"""A cable's length is not what its encoder says."""
UNPULLED = (*OPENED, UNSOLVED)
"""A cable is not pulled: as if it were longer, when the platform gives way to the others."""
PUSHED = tuple(Sign(cause, str(LED), (SWEEP, *AT_WORK)) for cause in ("BASE_BLOCKED", "WRONG_WAY"))
DEAF_BASE = tuple(
    Sign(cause, str(SWEPT), (SWEEP, RUN)) for cause in ("DRIVE_DEAF", "BASE_BLOCKED", "WRONG_WAY")
)
"""It goes on as it was last told, which is not as it is told then."""
REVERSED = (
    Sign("WRONG_WAY", "100", (TRY_BASES, SWEEP, *AT_WORK)),
    Sign("BASE_RUNAWAY", "1000", (HOMING,)),
)
SCALED = (*OPENED, UNSOLVED, *PUSHED)
"""A base is not where it is thought to be."""
STANDS = (*SCALED, Sign("BASE_BLOCKED", "200", (TRY_BASES,)))

ERRORS = {
    0x1000: "generic",
    0x2310: "overcurrent",
    0x3210: "overvoltage",
    0x3220: "undervoltage",
    0x4210: "too hot",
    0x5480: "hardware",
    0x6320: "software",
    0x7320: "position sensor",
    0x7390: "sensor missing",
    0x8110: "CAN overrun",
    0x8120: "CAN error passive",
    0x8130: "heartbeat lost",
    0x8150: "identifier twice",
    0x81FD: "CAN bus-off",
    0x8210: "PDO length",
    0x8611: "following error",
    0x8A88: "safe torque off",
    0xFF02: "watchdog",
}
WARNING = 0xFF01
LATCHED = (0x8120, 0x8130)
"""A fault reset does not clear them, a reset of communication does."""


def errors(target: Target) -> Iterator[Fault]:
    """A drive's own faults."""
    for code, what in ERRORS.items():
        stands = (Sign("DRIVE_FAULT", START, (CONTRACT,)),) if code in LATCHED else ()
        strike = target.act(partial(Drive.raise_error, code=code))
        signs = (Sign("DRIVE_FAULT"), *stands)
        yield target.fault(f"error {code:04X}, {what}", signs, strike, powerless=True)
    warn = target.act(partial(Drive.raise_error, code=WARNING))
    yield target.fault(f"error {WARNING:04X}, a warning", (), warn)


def silences(target: Target) -> Iterator[Fault]:
    """A drive says nothing, or not what it should."""

    def set_silent(drive: Drive) -> None:
        drive.silent = True

    def lies(word: int) -> Strike:
        def strike(drive: Drive) -> None:
            drive.servo.false_statusword = word

        return target.act(strike)

    def interrupt(drive: Drive) -> None:
        drive.shut_down()
        drive.switch_on()

    def leave(drive: Drive) -> None:
        drive.receive(0x000, bytes([0x80, drive.node]))

    fault = target.fault
    unknown = (Sign("DRIVE_STATE", "divider"), Sign("DRIVE_STATE", START, (CONTRACT,)))
    off = (Sign("DRIVE_STATE", "divider", target.powered),)
    not_remote = (Sign("DRIVE_LOCAL", "divider"), Sign("DRIVE_LOCAL", START, (CONTRACT,)))
    again = (Sign("DRIVE_SETUP", str(BOOTED), (CONTRACT,)), SILENT)
    act = target.act
    yield fault("silent", (*NO_ANSWER, SILENT), act(set_silent))
    yield fault("without supply", (*NO_ANSWER, SILENT), act(Drive.shut_down), powerless=True)
    yield fault("supply interrupted", again, act(interrupt), powerless=True)
    yield fault("statusword unknown to CiA 402", unknown, lies(0x024C))
    yield fault("statusword stays switch on disabled", off, lies(0x0240))
    yield fault("statusword without remote", not_remote, lies(0x0027))
    yield fault("falls to pre-operational", (SILENT,), act(leave), deaf=True)


def encoders(target: Target) -> Iterator[Fault]:
    """A drive measures what is not."""

    def jump(increments: int) -> Strike:
        return target.act(lambda drive: drive.servo.encoder.jump(increments))

    def count(scale: float) -> Strike:
        return target.act(lambda drive: drive.servo.encoder.distort(scale))

    def slip(increments: int) -> Strike:
        return target.act(lambda drive: drive.servo.encoder.slip(increments))

    jumped = (Sign("ENCODER_JUMP", "2 * divider", target.known),)
    of_base, strong = target is BASE, target is BASE
    fault = target.fault
    yield fault("encoder jumps a turn", jumped, jump(4096))
    yield fault("encoder jumps a turn back", jumped, jump(-4096))
    yield fault("encoder jumps a fortieth of a turn", (), jump(100))
    yield fault("encoder jumps a fortieth of a turn back", (), jump(-100))
    yield fault("encoder stands", STANDS if of_base else UNTRUE, count(0.0), strong=strong)
    yield fault("encoder reversed", REVERSED if of_base else UNTRUE, count(-1.0), strong=strong)
    yield fault("encoder counts half", SCALED if of_base else UNTRUE, count(0.5), strong=strong)
    yield fault("encoder counts double", SCALED if of_base else UNTRUE, count(2.0), strong=strong)
    yield fault("encoder slips", SCALED if of_base else UNTRUE, slip(4), strong=strong)
    yield fault("encoder slips back", SCALED if of_base else UNTRUE, slip(-4), strong=strong)


def motors(target: Target) -> Iterator[Fault]:
    """A motor does not give the torque that its drive is told, and reports."""

    def give(share: float) -> Strike:
        def strike(drive: Drive) -> None:
            drive.servo.given = share

        return target.act(strike)

    nothing, reversed_ = (PUSHED, REVERSED) if target is BASE else (UNPULLED, UNPULLED)
    fault = target.fault
    yield fault("motor gives no torque", nothing, give(0.0), powerless=True, strong=True)
    yield fault("motor gives twice its torque", (), give(2.0), strong=True)
    yield fault("motor gives its torque reversed", reversed_, give(-1.0), strong=True)


def status_messages(target: Target) -> Iterator[Fault]:
    """What a drive sends at a SYNC is lost, doubled, late or wrong."""
    late = (NOT_STARTED, Sign("DRIVE_LATE", f"{SYNCS} + divider - 1"))
    later = (NOT_STARTED, Sign("DRIVE_LATE", f"{SYNCS} + 2 * divider - 1"))
    too_late = Disturbance(Mishap.DELAY, target.divider)
    much_too_late = Disturbance(Mishap.DELAY, 2 * target.divider)
    flipped = (Sign("DRIVE_STATE", "divider"), Sign("DRIVE_FAULT", "divider"))
    jumped = (Sign("ENCODER_JUMP", "divider", target.known),)
    first = (Sign("ENCODER_JUMP", str(SET_UP), (CONTRACT,)),) if target is CABLE else ()
    corrupt = (Sign("BUS_CORRUPT", "divider"), Sign("BUS_CORRUPT", str(SET_UP), (CONTRACT,)))
    always = (
        ("lost always", DROP, (NOT_STARTED, SILENT)),
        ("doubled always", TWICE, ()),
        ("a SYNC late always", too_late, late),
        ("two SYNCs late always", much_too_late, later),
        ("too short always", SHORT, (*corrupt, SILENT)),
    )
    once = (
        ("lost once", DROP, ()),
        ("a SYNC late once", too_late, ()),
        ("too short once", SHORT, ()),
        ("with its state flipped once", flip("6800"), flipped),
        ("with its position flipped once, high", flip("0000 00000040"), (*jumped, *first)),
        ("with its position flipped once, low", flip("0000 01000000"), ()),
        ("with its torque flipped once", flip("0000 00000000 0040"), ()),
    )
    hit = partial(target.disturb, TPDO)
    for name, how, signs in always:
        yield target.fault(f"status message {name}", signs, hit(how, ALWAYS))
    for name, how, signs in once:
        yield target.fault(f"status message {name}", signs, hit(how, 1))
    yield target.fault("status message lost twice", (), hit(DROP, 2))


def setpoints(target: Target) -> Iterator[Fault]:
    """What a drive is told between SYNCs is lost, doubled, late or wrong."""
    refused = (Sign("DRIVE_FAULT", "3 * divider"),)
    stands = Sign("DRIVE_FAULT", START, (CONTRACT,))
    off = (Sign("DRIVE_STATE", "4 * divider", target.powered),)
    deaf = (
        Sign("DRIVE_DEAF", str(MOVED), (RUN, SOFT_STOP)),
        *(DEAF_BASE if target is BASE else ()),
        Sign("DRIVE_STUCK", "TB_STOP_CYCLES + TB_HEARTBEAT_TIMEOUT", (SOFT_STOP,)),
    )
    misled = {"powerless": True, "brakes": True}
    hit = partial(target.disturb, RPDO)
    fault = target.fault

    def lose_all(lockstep: Lockstep) -> None:
        """And other torques are wanted, or nothing would be missing."""
        hit(DROP, ALWAYS)(lockstep)
        lockstep.force = (-2.0, 3.0)

    yield fault("setpoint lost once", (), hit(DROP, 1))
    yield fault("setpoint lost always", deaf, lose_all, deaf=True)
    yield fault("setpoint doubled always", (), hit(TWICE, ALWAYS))
    yield fault("setpoint a cycle late once", (), hit(LATE, 1))
    yield fault("setpoint a cycle late always", (), hit(LATE, ALWAYS))
    yield fault("setpoint too short once", refused, hit(SHORT, 1), powerless=True)
    yield fault("setpoint too short always", (*refused, stands), hit(SHORT, ALWAYS), powerless=True)
    yield fault("setpoint switches it off once", off, hit(flip("0200"), 1), **misled)
    yield fault("setpoint with its torque flipped once", (), hit(flip("0000 0040"), 1), strong=True)


def heartbeats(target: Target) -> Iterator[Fault]:
    """A drive's heartbeat is lost, doubled, late or wrong."""
    lost = (NO_BOOT_UP, NOT_STARTED, Sign("DRIVE_SILENT", "TB_HEARTBEAT_TIMEOUT"))
    hit = partial(target.disturb, HEARTBEAT)
    fault = target.fault
    yield fault("heartbeat lost once", (NO_BOOT_UP,), hit(DROP, 1))
    yield fault("heartbeat lost always", lost, hit(DROP, ALWAYS))
    yield fault("heartbeat doubled always", (), hit(TWICE, ALWAYS))
    yield fault("heartbeat a cycle late always", (), hit(LATE, ALWAYS))
    yield fault("heartbeat too short once", (MALFORMED_BOOT_UP,), hit(SHORT, 1))
    yield fault("heartbeat too short always", (MALFORMED_BOOT_UP, *lost[1:]), hit(SHORT, ALWAYS))


def set_up(target: Target) -> Iterator[Fault]:
    """A drive does not let itself be set up."""

    def foreign(drive: Drive) -> None:
        drive.setup = replace(drive.setup, identity=Identity(vendor=1))
        drive.describe()

    def refuses(index: int, code: int) -> Strike:
        return target.act(lambda drive: drive.refuse((index, 0), code))

    def double(lockstep: Lockstep) -> None:
        lockstep.machine.add_stranger(target.bus, Setup(target.node))

    def later(cause: str, after: int) -> tuple[Sign, ...]:
        """A base drive changes its mode once the cables were tried, and again for its homing."""
        if target is not BASE:
            return ()
        cables_tried = Sign(cause, f"{TRIED} + {after}", (TIGHTEN,))
        return (cables_tried, Sign(cause, f"{TRIAL} + {after}", (TRY_BASES,)))

    no_mode = (*later("DRIVE_SETUP", 2500), *later("DRIVE_STUCK", 2500))
    turn = "DRIVES_ON_BUS"
    other = (Sign("DRIVE_DIFFERENT", turn, (IDENTIFY,)), Sign("DRIVE_SETUP", turn, (CONTRACT,)))
    twice = (Sign("DRIVE_TWICE", turn, (IDENTIFY, CONTRACT)), *later("DRIVE_TWICE", 0))
    vendor = (Sign("DRIVE_DIFFERENT", str(BOOTED), (INIT,)),)
    contract = Sign("DRIVE_SETUP", str(SET_UP), (IDENTIFY, CONTRACT))
    second = (
        Sign("DRIVE_TWICE", f"{SET_UP}", BEFORE_SERVICE),
        Sign("DRIVE_SETUP", f"{SET_UP}", BEFORE_SERVICE),
        Sign("DRIVE_SILENT", str(BOOTED)),
    )
    hit = partial(target.disturb, SDO_ANSWER)
    fault = target.fault
    yield fault("SDO answers lost", (*NO_ANSWER[1:], *no_mode), hit(DROP, ALWAYS))
    yield fault("SDO answer lost once", (), hit(DROP, 1))
    yield fault("SDO answers hold other values", other + no_mode, hit(flip("00000000 40"), ALWAYS))
    yield fault("SDO answers doubled", twice, hit(TWICE, ALWAYS))
    malformed = (Sign("BUS_CORRUPT", NO_ANSWER[1].after, (IDENTIFY,)), NO_ANSWER[2])
    yield fault("SDO answers too short", (*malformed, *no_mode), hit(SHORT, ALWAYS))
    yield fault("another vendor", vendor, target.act(foreign))
    yield fault("refuses its map", (contract,), refuses(0x1A00, 0x08000022))
    yield fault("refuses its mode", (contract, *no_mode), refuses(0x6060, 0x06090030))
    yield fault("a second drive with its number", second, double)


def buses(number: int, name: str, drives: tuple[int, ...], divider: int) -> Iterator[Fault]:
    """A bus as a whole."""

    def fault(what: str, signs: tuple[Sign, ...], strike: Strike, deaf: bool = False) -> Fault:
        full = f"bus {name}: {what}"
        return Fault(full, signs, strike, drives=drives, bus=number, divider=divider, deaf=deaf)

    def becomes(state: BusState, full: bool = False) -> Strike:
        return lambda lockstep: lockstep.set_bus(number, state, full)

    def hit(how: Disturbance, count: int) -> Strike:
        return lambda lockstep: lockstep.machine.buses[number].disturb(SYNC, how, count)

    def says(cob: int, data: bytes) -> Strike:
        return lambda lockstep: lockstep.machine.buses[number].intrude(Frame(cob, data))

    def stranger(lockstep: Lockstep) -> None:
        lockstep.machine.add_stranger(number, Setup(17))

    everywhere = (*BEFORE_SERVICE, *SERVICE)
    lost = (Sign("BUS_OFF", moments=everywhere),)
    full = (Sign("BUS_FULL", "2 * divider", (IDENTIFY, CONTRACT, *SERVICE)),)
    strange = (Sign("STRANGER", str(BOOTED), everywhere),)
    delayed = Disturbance(Mishap.DELAY, divider)
    twice = (Sign("DRIVE_STATE", str(TRIAL), (TRY_BASES,)),) if number == 2 else ()
    yield fault("off", lost, becomes(BusState.BUS_OFF), deaf=True)
    yield fault("device gone", lost, becomes(BusState.NOT_OPEN), deaf=True)
    yield fault("error passive", (), becomes(BusState.ERROR_PASSIVE))
    yield fault("full", full, becomes(BusState.ERROR_ACTIVE, full=True), deaf=True)
    yield fault("a stranger", strange, stranger)
    master = (Sign("OTHER_MASTER", moments=everywhere),)
    yield fault("another master", master, says(0x202, b"\0\0\0\0"))
    yield fault("a frame of nobody", (), says(0x6E5, b"\1"))
    yield fault("SYNC lost once", (), hit(DROP, 1))
    yield fault("SYNC lost always", (NOT_STARTED, SILENT), hit(DROP, ALWAYS), deaf=True)
    # While a drive powers up: of its two answers the first is from before the last order, and the
    # next order is one step behind.
    yield fault("SYNC doubled always", twice, hit(TWICE, ALWAYS))
    # It then comes when the one after it was due: one answer is missed, the others are in time.
    yield fault("SYNC late by its period always", (), hit(delayed, ALWAYS))


def program() -> Iterator[Fault]:
    """The master's program and its heartbeat."""

    def beat(how: Disturbance, count: int) -> Strike:
        def strike(lockstep: Lockstep) -> None:
            for bus in lockstep.machine.buses:
                bus.disturb(MASTERS_HEARTBEAT, how, count)

        return strike

    lost = (Sign("DRIVE_FAULT", str(HEARTBEAT_LOST)), Sign("DRIVE_FAULT", START, (CONTRACT,)))
    yield Fault("master's heartbeat lost once", (), beat(DROP, 1))
    yield Fault("master's heartbeat lost always", lost, beat(DROP, ALWAYS))
    yield Fault("master's heartbeat doubled always", (), beat(TWICE, ALWAYS))
    for cycles in (1, 2, 3, 20):
        missed = (Sign("CYCLES_MISSED", str(cycles), POWERED),) if cycles > 2 else ()
        yield Fault(f"{cycles} cycles left out", missed, stands_still=cycles)
    yield Fault(
        "stopped for 500 cycles (SIGSTOP)",
        (Sign("DRIVE_FAULT", "502"), Sign("DRIVE_FAULT", f"500 + {START}", (CONTRACT,))),
        stands_still=500,
        deaf=True,
    )
    yield Fault("killed", (), stands_still=ALWAYS, deaf=True)


def surroundings() -> Iterator[Fault]:
    """The application, the hand, the cables."""

    def wants(x: float, y: float) -> Strike:
        def strike(lockstep: Lockstep) -> None:
            lockstep.force = (x, y)

        return strike

    def feels(x: float, y: float) -> Strike:
        def strike(lockstep: Lockstep) -> None:
            lockstep.hand_force = (x, y)

        return strike

    def not_fresh(lockstep: Lockstep) -> None:
        lockstep.hand_force_fresh = False

    def hook(lockstep: Lockstep, cycle: int) -> None:
        lockstep.machine.plant.hook_cable(CABLE.number, min(0.002 * (cycle + 1), 0.02))

    def cut(lockstep: Lockstep) -> None:
        lockstep.machine.plant.break_cable(CABLE.number)

    unwanted = (Sign("CONTROLLER", moments=(RUN,)),)
    unfelt = (Sign("CONTROLLER", moments=AT_WORK),)
    slack = tuple(Sign(cause, "20", AT_WORK) for cause in ("CABLE_SLACK", "CLOSURE"))
    longer = (UNSOLVED,)
    broken = (
        *(Sign(cause, "50", AT_WORK) for cause in ("CABLE_BREAK", "CLOSURE")),
        Sign("CALIBRATION", str(CALIBRATED), (HOMING, SWEEP)),
        Sign("CABLE_SLACK", "TB_STATE_TIMEOUT", (TIGHTEN,)),
    )
    yield Fault("force is NaN", unwanted, wants(nan, 0.0))
    yield Fault("force is infinite", unwanted, wants(inf, -inf))
    yield Fault("force is 1e30 N", unwanted, wants(1e30, 1e30))
    yield Fault("hand force is NaN", unfelt, feels(nan, nan))
    yield Fault("hand force is infinite", unfelt, feels(-inf, 0.0))
    yield Fault("hand force is not fresh", (), not_fresh)
    yield Fault(f"{CABLE.name}: hooked, slack", (*slack, *longer), each=hook, strong=True)
    yield Fault(f"{CABLE.name}: breaks", broken, cut)


KINDS = (errors, silences, encoders, motors, status_messages, setpoints, heartbeats, set_up)


def faults() -> Iterator[Fault]:
    """All of them."""
    for target in TARGETS:
        for kind in KINDS:
            yield from kind(target)
    yield from buses(0, "cable1", drives=(0, 1), divider=1)
    yield from buses(2, "base", drives=(4, 5, 6, 7), divider=2)
    yield from program()
    yield from surroundings()


FAULTS = tuple(faults())
