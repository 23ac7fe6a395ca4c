"""All that is wrong with a machine file is told at once, and nothing that follows from the rest."""

import tomllib
from collections.abc import Callable
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from turnbuckle.model.machine import Machine
from turnbuckle.model.partial import forget, partial, value_at
from turnbuckle.model.problem import MachineError, key_path, location_of
from turnbuckle.model.reading import load_machine, machine_from
from turnbuckle.model.table import WrongKey

STOCK = Path(__file__).parents[2] / "machines" / "yoon2023.toml"
TABLES = tomllib.loads(STOCK.read_text(encoding="utf-8"))
Tables = dict[str, Any]
Edit = Callable[[Tables], object]


def at(key: str, value: object) -> Edit:
    """Writes a value at a key of the file."""

    def edit(tables: Any) -> None:
        *way, last = location_of(key)
        for part in way:
            tables = tables[part]
        tables[last] = value

    return edit


def without(table: str, key: str) -> Edit:
    return lambda tables: tables[table].pop(key)


#: Key that the problem names -> what makes it wrong; each by itself, some alone and some by others.
DEFECTS: dict[str, Edit] = {
    "machine.nam": at("machine.nam", "yoon"),
    "machine.source": without("machine", "source"),
    "drum.radius": at("drum.radius", "-5 mm"),
    "tension.min": at("tension.min", "12 N"),
    "cable[2].rail.to[2]": at("cable[2].rail.to[2]", "461.8 s"),
    "cable[3].rail.from": at("cable[3].rail.from[2]", "461.9 mm"),
    "wall[1].stiffness": at("wall[1].stiffness", "1 kg"),
    "wall[2].name": at("wall[2].name", "right"),
    "control.velocity_corner": at("control.velocity_corner", "600 Hz"),
    "rail_drive.derivative_corner": at("rail_drive.derivative_corner", "600 Hz"),
    "target.centre": at("target.centre[1]", "200 mm"),
    "bus[1].bit_rate": at("bus[1].bit_rate", "400 kbit/s"),
    "drive[8].node": at("drive[8].node", 3),
    "cable_motor.rating.encoder_counts": at("cable_motor.rating.encoder_counts", 4095),
    "rail_drive.homing.current": at("rail_drive.homing.current", "10 A"),
    "plant.hand_mass": at("plant.hand_mass", 5),
}


def problems(*edits: Edit) -> list[str]:
    """Keys of all problems of the stock machine with these edits."""
    tables = deepcopy(TABLES)
    for edit in edits:
        edit(tables)
    with pytest.raises(MachineError) as caught:
        machine_from(tables, STOCK)
    return [problem.key for problem in caught.value.problems]


@pytest.mark.parametrize("key", DEFECTS)
def test_a_defect_alone_is_the_only_problem(key: str) -> None:
    assert problems(DEFECTS[key]) == [key]


@given(st.lists(st.sampled_from(sorted(DEFECTS)), unique=True, min_size=2))
def test_of_several_defects_every_one_is_told_and_no_other(keys: list[str]) -> None:
    assert sorted(problems(*(DEFECTS[key] for key in keys))) == sorted(keys)


@pytest.mark.parametrize(
    ("wrong", "silent"),
    [
        (at("drum.radius", "5"), at("cable_motor.torque_limit", "1 mN*m")),
        (at("tension.max", 10), at("tension.min", "12 N")),
        (at("frame.size[1]", "1 s"), at("cable[1].rail.to[1]", "2 m")),
        (at("control.rate", "1 s"), at("control.velocity_corner", "1 kHz")),
        (at("machine.kind", "round"), at("target.size", ["1 m", "1 m", "1 m"])),
        (at("rail_drive", 5), at("rail_drive", 5)),
        (at("cable[4]", 5), at("cable[1].rail.to[1]", "0 mm")),
        (at("cable[4].rail", 5), at("plant.carriage_mass", "1 kg")),
    ],
)
def test_rules_are_silent_about_what_depends_on_a_wrong_key(wrong: Edit, silent: Edit) -> None:
    assert problems(silent, wrong) == problems(wrong)
    assert len(problems(wrong)) == 1


def test_a_problem_between_keys_is_told_beside_one_of_a_later_stage() -> None:
    late = at("supervision", {"heartbeat_timeout": "15 ms"})
    assert problems(DEFECTS["tension.min"], late) == [
        "tension.min",
        "supervision.heartbeat_timeout",
    ]


def test_what_is_right_of_a_machine_can_be_asked_for_and_what_is_wrong_cannot() -> None:
    tables = deepcopy(TABLES)
    DEFECTS["cable[2].rail.to[2]"](tables)
    machine = partial(Machine, tables)
    whole = load_machine(STOCK)
    assert machine.cables[0] == whole.cables[0]
    assert machine.cables[1].rail is not None and whole.cables[1].rail is not None
    assert machine.cables[1].rail.start == whole.cables[1].rail.start
    for what in (lambda: machine.cables[1].rail.end, lambda: machine.rails):
        with pytest.raises(WrongKey):
            what()


@pytest.mark.parametrize("key", ["frame.size", "cable[2].rail.to", "cable[2]", "cable", "drum"])
def test_what_is_forgotten_is_wrong_and_the_rest_stays(key: str) -> None:
    machine = load_machine(STOCK)
    assert machine.rails  # which remembers where bases are
    forget(machine, location_of(key))
    with pytest.raises(WrongKey):
        value_at(machine, location_of(key if key != "cable[2]" else "cable[2].rail"))
    if key == "cable[2].rail.to":
        with pytest.raises(WrongKey):
            assert machine.rails
    assert machine.control.rate == 1000.0


@pytest.mark.parametrize("location", [("drum",), ("cable", 1, "rail", "to", 0), ("wall", 15)])
def test_a_key_is_found_from_its_words(location: tuple[str | int, ...]) -> None:
    assert location_of(key_path(location)) == list(location)


@pytest.mark.parametrize(
    ("edit", "key"),
    [
        (at("wall[1].point", ["712 mm", "0 mm"]), "wall[1].point"),
        (at("wall[1].normal", [1, 0]), None),
        (at("wall[2].point", ["0 mm", "-1 mm"]), "wall[2].point"),
        (at("wall[2].point", ["900 mm", "330 mm"]), None),
        (at("wall[1].point", ["711.8 mm", "0 mm"]), None),
    ],
    ids=["beyond", "turned round", "behind everything", "beside but through it", "at its side"],
)
def test_a_wall_stands_where_the_frame_is(edit: Edit, key: str | None) -> None:
    tables = deepcopy(TABLES)
    edit(tables)
    if key is None:
        machine_from(tables, STOCK)
    else:
        assert problems(edit) == [key]


def test_a_target_beside_the_middle_of_the_frame_is_said() -> None:
    assert load_machine(STOCK).warnings() == []
    tables = deepcopy(TABLES)
    at("target.centre", ["345.9 mm", "230.9 mm"])(tables)
    machine = machine_from(tables, STOCK)
    words = "-10 x 0 mm off the middle of the frame"
    assert machine.warnings() == [("target.centre", words)]
    assert words in dict(machine.describe())["target"]
