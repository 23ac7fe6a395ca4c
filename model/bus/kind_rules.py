"""What must hold between a machine file and the kinds of its drives: what they can do and hold."""

from collections.abc import Iterable
from dataclasses import dataclass

from turnbuckle.model.bus.axis import axes, torque_units
from turnbuckle.model.bus.drive_kinds import DRIVE_KINDS
from turnbuckle.model.bus.drive_kinds.kind import DriveKind, Option, Place
from turnbuckle.model.bus.rules import Found, Tables, supervision_problem
from turnbuckle.model.bus.tables import Rating
from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import Location, Problem, key_path, problem_at, shown
from turnbuckle.model.table import WrongKey

MOST_SIGNED, MOST_TORQUE = 0x7FFF_FFFF, 0x7FFF


def words_of_kinds(machine: Machine, tables: Tables) -> Found:
    """What a drive is told to do, its kind can do."""
    first = {drive.kind: drive.name for drive in reversed(machine.drives)}
    for kind, name in ((DRIVE_KINDS[kind], name) for kind, name in first.items()):
        for key in ("connection_loss", "quick_stop"):
            option: Option = getattr(kind, key)
            if getattr(machine.supervision, key) not in option.codes:
                allowed = f"{_quoted(option.codes)} for {name}, {kind.meaning}"
                yield supervision_problem(machine, tables, key, allowed)


def modes_of_kinds(machine: Machine, tables: Tables) -> Found:
    """A drive's kind can do what its mode asks, and that of a base finds the stop."""
    cables = [cable.drive for cable in machine.cables]
    for i, drive in enumerate(machine.drives):
        kind = DRIVE_KINDS[drive.kind]
        if drive.mode not in kind.modes:
            allowed = f"{_quoted(kind.modes.keys() - {'homing'})} for the {kind.meaning}"
            location = ("drive", i, "mode")
            if "mode" in tables["drive"][i]:
                yield problem_at(tables, location, allowed)
            else:
                yield Problem(key_path(location), f"{shown(drive.mode)}, the default", allowed)
        if drive.name not in cables and kind.homing is None:
            found = f"{shown(kind.name)}, which finds no stop"
            yield Problem(key_path(("drive", i, "kind")), found, "a kind that can home a base")


def cable_motor_in_objects(machine: Machine, tables: Tables) -> Found:
    """The objects of every cable drive can hold what the file says of its motor."""
    if machine.buses and machine.cable_motor.rating:
        yield from _motor(machine, tables, "cable_motor", machine.cable_motor.rating)


def base_motor_in_objects(machine: Machine, tables: Tables) -> Found:
    """The objects of every base drive can hold what the file says of its motor."""
    if machine.buses and machine.rail_drive and machine.rail_drive.rating:
        yield from _motor(machine, tables, "rail_drive", machine.rail_drive.rating)


def _kinds(machine: Machine, table: str) -> list[DriveKind]:
    """The kinds of the drives whose motor a table describes."""
    cables = [cable.drive for cable in machine.cables]
    of_cables = table == "cable_motor"
    names = {drive.kind for drive in machine.drives if (drive.name in cables) == of_cables}
    return [DRIVE_KINDS[name] for name in sorted(names)]


def _motor(machine: Machine, tables: Tables, table: str, rating: Rating) -> Found:
    for kind in _kinds(machine, table):
        motor = kind.motor
        keys = {
            motor.nominal_current: "nominal_current",
            motor.torque_constant: "torque_constant",
            motor.encoder: "encoder_counts",
            motor.current_limit: "current_limit",
        }
        limit = motor.current_limit, lambda motor: rating.current_limit
        for place, quantity in (*motor.read, limit):
            key = (table, "rating", keys[place]) if place in keys else (table, "rating")
            try:
                held = Held(kind, place, quantity(rating), place.unit(rating), place.symbol)
            except WrongKey:
                continue
            yield from _unfit(tables, held, key)


@dataclass(frozen=True)
class Held:
    """A quantity for an object of a kind of drive; one: the object's unit, in `symbol`."""

    kind: DriveKind
    place: Place
    quantity: float
    one: float
    symbol: str

    @property
    def allowed(self) -> str:
        """What the object can hold, where it cannot hold the quantity; else nothing."""
        (low, high), one, place = self.place.bounds, self.one, self.place
        where = f"{self.symbol}, in object {place.index:04X} of the {self.kind.meaning}"
        ratio = self.quantity / one
        if round(min(max(ratio, low - 1), high + 1)) < low:
            return f"at least {low * one:.6g} {where}"
        if ratio > high + 0.5:
            return f"at most {high * one:.6g} {where}"
        return f"a multiple of {one:g} {where}" if place.whole and self.quantity % one else ""


def _unfit(tables: Tables, held: Held, key: Location) -> Found:
    """What an object cannot hold; key: of the value, or of the table where several make it."""
    if allowed := held.allowed:
        if len(key) == len(("table", "rating")):
            found = f"{held.place.meaning} of {held.quantity:.6g} {held.symbol}"
            yield Problem(key_path(key), found, allowed)
        else:
            yield problem_at(tables, key, allowed)


def torque_limits(machine: Machine, tables: Tables) -> Found:
    """The largest torques are numbers that a drive takes."""
    limits = {"cable_motor": machine.cable_motor.torque_limit}
    ratings = {"cable_motor": machine.cable_motor.rating}
    if machine.rail_drive:
        drive = machine.rail_drive
        limits["rail_drive"] = drive.force_limit * drive.pinion_radius
        ratings["rail_drive"] = drive.rating
    for table, rating in ratings.items():
        for kind in _kinds(machine, table) if machine.buses and rating else ():
            assert rating is not None
            units = torque_units(limits[table], kind.torque(rating))
            if not 1 <= units <= MOST_TORQUE:
                found = f"a torque limit of {units} {kind.torque_unit}"
                yield Problem(f"{table}.rating", found, f"1 to {MOST_TORQUE} (6071)")


def homing_in_objects(machine: Machine, tables: Tables) -> Found:
    """The objects of every base drive can hold how it finds its zero."""
    drive = machine.rail_drive
    if not machine.buses or drive is None or drive.rating is None or drive.homing is None:
        return
    way, radius = drive.homing, drive.pinion_radius
    for kind in _kinds(machine, "rail_drive"):
        if (objects := kind.homing) is None:
            continue
        speeds = (objects.speed, objects.search or objects.speed)
        held = (
            *((place, "speed", way.speed, radius, "m/s") for place in dict.fromkeys(speeds)),
            (objects.acceleration, "acceleration", way.acceleration, radius, "m/s^2"),
            (objects.threshold, "current", way.current, 1.0, "A"),
        )
        for place, key, quantity, lever, symbol in held:
            one = place.unit(drive.rating) * lever
            value = Held(kind, place, quantity, one, symbol)
            yield from _unfit(tables, value, ("rail_drive", "homing", key))


def longest_rails(machine: Machine, tables: Tables) -> Found:
    """The encoder of a base counts to the end of the rail."""
    if not machine.buses or machine.rail_drive is None or machine.rail_drive.homing is None:
        return
    bases = [axis for axis in axes(machine) if axis.rail is not None]
    farthest = max(rail.length for rail in machine.rails) + machine.rail_drive.homing.beyond
    for base in {axis.kind.name: axis for axis in bases}.values():
        counts = base.increments(farthest)
        home = base.kind.homing
        most = min(MOST_SIGNED, home.home.bounds[1] if home else MOST_SIGNED)
        if abs(counts) > most:
            found = f"{counts} counts of the encoder on the longest rail"
            yield Problem("rail_drive.rating.encoder_counts", found, f"at most {most} (6064)")


def _quoted(words: Iterable[str]) -> str:
    return " or ".join(f'"{word}"' for word in sorted(words))
