"""Every mistake about buses, drives and motors in a machine file gets one message."""

import tomllib
from collections.abc import Callable
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest

from turnbuckle.model.bus.axis import axes, drive_names
from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import MachineError
from turnbuckle.model.reading import machine_from

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
TABLES = tomllib.loads(STOCK.read_text())
Tables = dict[str, Any]
Edit = Callable[[Tables], object]


def edited(edit: Edit) -> Machine:
    tables = deepcopy(TABLES)
    edit(tables)
    return machine_from(tables, STOCK)


def bus(**keys: object) -> Edit:
    return lambda tables: tables["bus"][0].update(keys)


def drive(number: int, **keys: object) -> Edit:
    return lambda tables: tables["drive"][number].update(keys)


IO = {"name": "io", "bus": "base", "node": 20}


def node(*others: dict[str, object], **keys: object) -> Edit:
    """Other nodes: an I/O module with some keys changed, and then others."""
    return lambda tables: tables.update(node=[{**IO, **keys}, *others])


def frames(*frames: dict[str, object]) -> Edit:
    """The I/O module with some frames."""
    return node(frames=[{"length": 8, "period": "10 ms", **frame} for frame in frames])


def within(*path: str, **keys: object) -> Edit:
    def edit(tables: Tables) -> None:
        for key in path:
            tables = tables.setdefault(key, {})
        tables.update(keys)

    return edit


def less(*path: str) -> Edit:
    def edit(tables: Tables) -> None:
        for key in path[:-1]:
            tables = tables[key]
        del tables[path[-1]]

    return edit


def without_buses(tables: Tables) -> None:
    del tables["bus"], tables["drive"]


def node_without_buses(tables: Tables) -> None:
    without_buses(tables)
    tables["node"] = [IO]


# what is changed, the key that the message names, what it says was found, what is allowed
REFUSALS: list[tuple[Edit, str, str, str]] = [
    (bus(bit_rate="1 kHz"), "bus[1].bit_rate", '"1 kHz", a frequency', "bits per second"),
    (bus(bit_rate="400 kbit/s"), "bus[1].bit_rate", '"400 kbit/s"', "one of 10, 20, 50, 125"),
    (bus(rate="1 Mbit/s"), "bus[1].rate", '"1 Mbit/s", a bit rate', "not angle, per second"),
    (bus(rate="600 Hz"), "bus[1].rate", '"600 Hz"', 'control.rate = "1 kHz", or this divided'),
    (bus(rate="2 kHz"), "bus[1].rate", '"2 kHz"', 'control.rate = "1 kHz", or this divided'),
    (bus(name="cable2"), "bus[2].name", '"cable2"', "a name that differs from bus[1].name"),
    (bus(name="if"), "bus[1].name", '"if"', "no keyword of C"),
    (drive(1, node=1), "drive[2].node", "1", "a number that differs from drive[1].node"),
    (drive(1, node=0), "drive[2].node", "0", "a node number, a whole number from 1 to 126"),
    (drive(1, node=127), "drive[2].node", "127", "from 1 to 126"),
    (node(node=0), "node[1].node", "0", "a node number, a whole number from 1 to 126"),
    (node(node=127), "node[1].node", "127", "from 1 to 126"),
    (node(node=3), "node[1].node", "3", "a number that nobody has on bus base; base_3 has"),
    (node(name="base_1"), "node[1].name", '"base_1"', "a name that no drive and no other node has"),
    (node(name="master"), "node[1].name", '"master"', "nor master"),
    (node(name="int"), "node[1].name", '"int"', "no keyword of C"),
    (node(bus="bases"), "node[1].bus", '"bases"', "cable1, cable2, base; did you mean"),
    (node(IO), "node[2].name", '"io"', "a name that no drive and no other node has"),
    (node({**IO, "name": "b"}), "node[2].node", "20", "nobody has on bus base; io has this one"),
    (node(heartbeat="1"), "node[1].heartbeat", '"1"', "a time with its unit"),
    (node(watched=True), "node[1].watched", "", ""),
    (frames({"id": 0}), "node[1].frames[1].id", "0", "an identifier of 11 bits, a whole number"),
    (frames({"id": 0x800}), "node[1].frames[1].id", "2048", "from 1 to 2047"),
    (frames({"id": 1, "length": 9}), "node[1].frames[1].length", "9", "from 0 to 8"),
    (frames({"id": 1, "period": "0 ms"}), "node[1].frames[1].period", '"0 ms"', "greater than"),
    (frames({"id": 0x080}), "node[1].frames[1].id", "128", "nobody has on bus base; master has"),
    (frames({"id": 0x77F}), "node[1].frames[1].id", "1919", "master has this one"),
    (frames({"id": 0x201}), "node[1].frames[1].id", "513", "base_1 has this one"),
    (frames({"id": 0x714}), "node[1].frames[1].id", "1812", "io has this one"),
    (frames({"id": 5}, {"id": 5}), "node[1].frames[2].id", "5", "io has this one"),
    (
        frames({"id": 5, "period": "500 us"}),
        "bus[3]",
        '"base" with 4 drives and io, too much for 1000 kbit/s',
        "a rate of",
    ),
    (drive(1, node="2"), "drive[2].node", '"2"', "a whole number"),
    (drive(1, node=True), "drive[2].node", "true", "a whole number"),
    (drive(1, bus="cabel1"), "drive[2].bus", '"cabel1"', "did you mean cable1?"),
    (drive(1, name="cable_1"), "drive[2].name", '"cable_1"', "differs from drive[1].name"),
    (drive(1, name="cable_9"), "drive[2].name", '"cable_9"', "the drives cable_1, cable_2"),
    (drive(1, name="master"), "drive[2].name", '"master"', "a name other than master"),
    (drive(1, mode="position"), "drive[2].mode", '"position"', '"torque" for the drive of a cable'),
    (drive(1, mode="speed"), "drive[2].mode", '"speed"', '"torque" or "position"'),
    (drive(1, direction="left"), "drive[2].direction", '"left"', '"forward" or "reverse"'),
    (drive(1, product=2**32), "drive[2].product", "4294967296", "0 to 4294967295"),
    (lambda tables: tables["drive"].pop(), "drive", "no drive base_4", "one [[drive]] for each"),
    (
        lambda tables: tables["bus"].append({**TABLES["bus"][0], "name": "spare"}),
        "bus[4]",
        '"spare", a bus without drives',
        "some [[drive]] names",
    ),
    (less("bus"), "drive", "a table", "no such table without a [[bus]]"),
    (less("rail_drive", "homing"), "rail_drive.homing", "nothing", "because of bus[1]"),
    (less("rail_drive", "rating"), "rail_drive.rating", "nothing", "because of bus[1]"),
    (less("cable_motor", "rating"), "cable_motor.rating", "nothing", "because of bus[1]"),
    (
        within("cable_motor", "rating", current_limit="1 A"),
        "cable_motor.rating.current_limit",
        '"1 A"',
        "at least 1.964 A, which cable_motor.torque_limit takes",
    ),
    (
        within("rail_drive", "rating", current_limit="7 A"),
        "rail_drive.rating.current_limit",
        '"7 A"',
        "at least 7.895 A, which rail_drive.force_limit takes",
    ),
    (
        within("cable_motor", "rating", encoder_counts=4095),
        "cable_motor.rating.encoder_counts",
        "4095",
        "a multiple of 4",
    ),
    (
        within("cable_motor", "rating", nominal_current="1 mA"),
        "cable_motor.rating",
        "a torque limit of 1964285 per mille",
        "1 to 32767 (6071)",
    ),
    (
        within("rail_drive", "homing", current="10 A"),
        "rail_drive.homing.current",
        '"10 A"',
        "at most rail_drive.rating.current_limit = 9 A",
    ),
    (
        within("rail_drive", "homing", speed="0.1 mm/s"),
        "rail_drive.homing.speed",
        '"0.1 mm/s"',
        "at least 0.0015708 m/s, in object 6099 of the maxon EPOS4",
    ),
    (
        lambda tables: (
            within("rail_drive", "homing", current="70 A")(tables),
            within("rail_drive", "rating", current_limit="70 A")(tables),
        ),
        "rail_drive.homing.current",
        '"70 A"',
        "at most 65.535 A, in object 30B2 of the maxon EPOS4",
    ),
    (
        lambda tables: tables["drive"][1].update(kind="epos5"),
        "drive[2].kind",
        '"epos5"',
        "the kinds epos4; did you mean epos4?",
    ),
    (
        within("supervision", heartbeat="30 ms"),
        "supervision.heartbeat_timeout",
        "40 ms",
        "at least twice supervision.heartbeat = 30 ms",
    ),
    (
        within("supervision", heartbeat="0.1 ms"),
        "supervision.heartbeat",
        '"0.1 ms"',
        "at least a control cycle, 1 ms",
    ),
    (
        within("supervision", drive_heartbeat="0.1 ms"),
        "supervision.drive_heartbeat",
        '"0.1 ms"',
        "1 ms to 65.535 s",
    ),
    (
        within("calibration", travel="300 mm"),
        "calibration.travel",
        '"300 mm"',
        "at most half of the shortest rail, 230.9 mm",
    ),
]


@pytest.mark.parametrize(("edit", "key", "found", "allowed"), REFUSALS)
def test_a_mistake_is_refused_with_key_found_and_allowed(
    edit: Edit, key: str, found: str, allowed: str
) -> None:
    with pytest.raises(MachineError) as caught:
        edited(edit)
    words = str(caught.value).removeprefix(f"{STOCK}: ")
    assert words.startswith(f"{key}: found {found}")
    assert allowed in words


def test_a_cable_cannot_take_the_name_of_a_base_drive() -> None:
    def steal(tables: Tables) -> None:
        tables["cable"][0]["drive"] = "base_2"
        tables["drive"].pop(0)

    with pytest.raises(MachineError, match=r"cable\[1\].drive: found \"base_2\"; allowed: a name"):
        edited(steal)


def test_drives_come_in_the_order_of_cables_then_rails_wherever_the_file_has_them() -> None:
    machine = edited(lambda tables: tables["drive"].reverse())
    assert [axis.drive.name for axis in axes(machine)] == drive_names(machine)
    assert drive_names(machine)[3:5] == ["cable_4", "base_1"]


def test_a_third_of_the_control_rate_may_be_written_with_some_digits() -> None:
    machine = edited(bus(rate="333.333 Hz"))
    assert machine.buses[0].rate == pytest.approx(1000 / 3, rel=1e-5)


def test_motor_ratings_need_no_bus() -> None:
    assert edited(without_buses).cable_motor.rating is not None


def test_other_nodes_may_say_what_nobody_else_says_on_their_bus() -> None:
    machine = edited(frames({"id": 0x194}, {"id": 0x094, "period": "100 ms"}))
    (io,) = machine.nodes
    assert io.identifiers == (0x714, 0x194, 0x094)
    edited(node({**IO, "name": "other", "bus": "cable1"}))
