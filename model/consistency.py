"""What must hold between the keys of a machine file, once each key is right by itself."""

from collections.abc import Callable, Iterator
from contextlib import suppress
from typing import Any

from turnbuckle.model import layout
from turnbuckle.model.bus import kind_rules
from turnbuckle.model.bus import rules as bus
from turnbuckle.model.machine import Machine
from turnbuckle.model.partial import forget
from turnbuckle.model.problem import (
    FOUND_NOTHING,
    Location,
    Problem,
    key_path,
    location_of,
    problem_at,
    shown,
)
from turnbuckle.model.rounding import ROUNDING
from turnbuckle.model.table import WrongKey

MOST_CABLES = 16
MOST_WALLS = 16

Found = Iterator[Problem]
Tables = dict[str, Any]
Rule = Callable[["Machine", Tables], Found]


def consistency_problems(machine: Machine, tables: Tables) -> list[Problem]:
    """All problems between the keys of a machine that are right by themselves; `tables`: the TOML.

    Later stages ask for what earlier ones have found to be there: points of the right dimension,
    bases and rails that exist, cables that pull. What a stage finds to be wrong is taken out of the
    machine, so that later stages are silent about that.
    """
    found: list[Problem] = []
    for location in layout.unjudged(machine):
        forget(machine, location)
    for stage in STAGES:
        now = [problem for rule in stage for problem in _asked(rule, machine, tables)]
        for problem in now:
            forget(machine, location_of(problem.key))
        found += now
    return found


def _asked(rule: Rule, machine: Machine, tables: Tables) -> Found:
    """What a rule finds until it needs a key that is wrong already."""
    with suppress(WrongKey):
        yield from rule(machine, tables)


def _counts(machine: Machine, tables: Tables) -> Found:
    cables, fewest = len(machine.cables), machine.dof + 1
    if not fewest <= cables <= MOST_CABLES:
        allowed = f"{fewest} to {MOST_CABLES} cables for the kind {machine.kind}"
        yield Problem("cable", f"{cables} cables", allowed)
    if len(machine.walls) > MOST_WALLS:
        yield Problem("wall", f"{len(machine.walls)} walls", f"0 to {MOST_WALLS} walls")


def _unique_names(machine: Machine, tables: Tables) -> Found:
    names = {
        ("cable", "drive"): [cable.drive for cable in machine.cables],
        ("wall", "name"): [wall.name for wall in machine.walls],
    }
    for (table, key), words in names.items():
        for i, word in enumerate(words):
            if word in words[:i]:
                first = key_path((table, words.index(word), key))
                allowed = f"a name that differs from {first}"
                yield Problem(key_path((table, i, key)), shown(word), allowed)


def _tensions(machine: Machine, tables: Tables) -> Found:
    if machine.tension.min >= machine.tension.max:
        limit = shown(tables["tension"]["max"])
        yield problem_at(tables, ("tension", "min"), f"a force below tension.max = {limit}")


def _torque_limit(machine: Machine, tables: Tables) -> Found:
    needed = machine.tension.max * machine.drum.radius
    if machine.cable_motor.torque_limit < needed * (1 - ROUNDING):
        yield problem_at(
            tables,
            ("cable_motor", "torque_limit"),
            f"at least tension.max times drum.radius = {needed * 1e3:g} mN*m",
        )


def _observer_share(machine: Machine, tables: Tables) -> Found:
    needed = machine.tension.max * machine.drum.radius
    limit = machine.cable_motor.torque_limit
    if machine.disturbance_observer and needed * (1 - ROUNDING) <= limit <= needed * (1 + ROUNDING):
        yield problem_at(
            tables,
            ("cable_motor", "torque_limit"),
            f"more than tension.max times drum.radius = {needed * 1e3:g} mN*m, "
            "because disturbance_observer compensates with what is above",
        )


def _carriages(machine: Machine, tables: Tables) -> Found:
    if machine.plant is None or not machine.rails:
        return
    first = _first_movable(machine)
    for key in ("carriage_mass", "carriage_coulomb_friction", "carriage_viscous_friction"):
        if getattr(machine.plant, key) is None:
            allowed = f"a quantity with its unit, because of {first}"
            yield Problem(key_path(("plant", key)), FOUND_NOTHING, allowed)


def _rail_drive(machine: Machine, tables: Tables) -> Found:
    if machine.rails and machine.rail_drive is None:
        first = _first_movable(machine)
        yield Problem("rail_drive", FOUND_NOTHING, f"a table, because of {first}")
    if not machine.rails and machine.rail_drive is not None:
        yield Problem("rail_drive", "a table", "no such table, because no cable has a rail")


def _observer(machine: Machine, tables: Tables) -> Found:
    observer = machine.disturbance_observer
    if observer and (observer.corner is None) == (observer.minus_3db is None):
        found = "both corner and minus_3db" if observer.corner else "neither corner nor minus_3db"
        yield Problem("disturbance_observer", found, "either corner or minus_3db")


def _velocity_corner(machine: Machine, tables: Tables) -> Found:
    corner, half = machine.control.velocity_corner, machine.control.rate / 2
    yield from _below(tables, ("control", "velocity_corner"), corner, half)


def _derivative_corner(machine: Machine, tables: Tables) -> Found:
    if machine.rail_drive:
        corner, half = machine.rail_drive.derivative_corner, machine.control.rate / 2
        yield from _below(tables, ("rail_drive", "derivative_corner"), corner, half)


def _observer_corner(machine: Machine, tables: Tables) -> Found:
    observer, half = machine.disturbance_observer, machine.control.rate / 2
    if observer and observer.corner:
        yield from _below(tables, ("disturbance_observer", "corner"), observer.corner, half)
    elif observer and observer.minus_3db:
        limit = half * observer.cut_off / observer.pole_corner
        location = ("disturbance_observer", "minus_3db")
        yield from _below(tables, location, observer.minus_3db, limit)


def _below(tables: Tables, location: Location, corner: float, limit: float) -> Found:
    if corner >= limit:
        reason = "so that the corner is below half of control.rate"
        yield problem_at(tables, location, f"a frequency below {limit:.4g} Hz, {reason}")


def _first_movable(machine: Machine) -> str:
    """The key of the first base that moves."""
    number = machine.rails[0].cables[0]
    return key_path(("cable", number, "rail" if machine.cables[number].rail else "plane"))


STAGES = (
    (layout.dimension_problems,),
    (
        _counts,
        layout.one_base_each,
        layout.bases_in_the_frame,
        layout.travel_has_length,
        layout.coupled_rails,
        layout.anchors,
        layout.platform,
        layout.pulleys,
        _unique_names,
        _tensions,
        _torque_limit,
        _observer_share,
        _observer,
        _velocity_corner,
        _derivative_corner,
        _observer_corner,
        layout.target_in_the_frame,
        layout.walls_in_the_frame,
    ),
    (layout.headings, layout.pulley_contacts, _carriages, _rail_drive),
    (layout.cables_span, layout.bases_off_one_line),
    (bus.buses_first, bus.bit_rates, bus.sync_rates, bus.names_and_nodes, bus.drives_on_buses),
    (bus.drives_of_the_machine, bus.positions_of_bases, bus.ratings_given, bus.other_nodes),
    (
        kind_rules.words_of_kinds,
        kind_rules.modes_of_kinds,
        kind_rules.cable_motor_in_objects,
        kind_rules.base_motor_in_objects,
    ),
    (
        bus.currents,
        kind_rules.torque_limits,
        kind_rules.homing_in_objects,
        kind_rules.longest_rails,
    ),
    (bus.heartbeats, bus.sweeps, bus.frames_of_other_nodes),
    (bus.schedulable,),
)
