"""tb_drives.h and tb_drives.c, compiled: scales, limits and every object that a drive must hold."""

import ctypes
import math
import tomllib
from collections.abc import Callable
from copy import deepcopy
from pathlib import Path
from typing import Any

import jinja2
import pytest

from turnbuckle.codegen.bus.drives import drive_fields, node_frames
from turnbuckle.codegen.compile import compile_library
from turnbuckle.codegen.generate import TEMPLATES
from turnbuckle.model.bus.axis import Axis, axes
from turnbuckle.model.bus.contract import Object, contract, identity
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine, machine_from

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
TABLES = tomllib.loads(STOCK.read_text())
CHECK, WRITE, WRITE_OF_NODE = 0, 1, 2
CABLE, BASE = 1, 5
Edit = Callable[[dict[str, Any]], object]


class TbObject(ctypes.Structure):
    _fields_ = (
        ("index", ctypes.c_uint16),
        ("subindex", ctypes.c_uint8),
        ("size", ctypes.c_uint8),
        ("action", ctypes.c_uint8),
        ("value", ctypes.c_uint32),
    )


class TbBus(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_char_p),
        ("bit_rate", ctypes.c_uint32),
        ("divider", ctypes.c_uint8),
    )


class TbKind(ctypes.Structure):
    _fields_ = (
        ("errors", ctypes.c_void_p),
        ("aborts", ctypes.c_void_p),
        ("error_count", ctypes.c_uint16),
        ("abort_count", ctypes.c_uint16),
        ("modes", ctypes.c_uint8 * 4),
    )


class TbDrive(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_char_p),
        ("bus", ctypes.c_uint8),
        ("node", ctypes.c_uint8),
        ("mode", ctypes.c_uint8),
        ("metres_per_increment", ctypes.c_double),
        ("increments_per_metre", ctypes.c_double),
        ("torque_per_unit", ctypes.c_double),
        ("units_per_torque", ctypes.c_double),
        ("most_torque_units", ctypes.c_int16),
        ("identity_count", ctypes.c_uint16),
        ("contract_count", ctypes.c_uint16),
        ("identity", ctypes.POINTER(TbObject)),
        ("contract", ctypes.POINTER(TbObject)),
        ("kind", ctypes.POINTER(TbKind)),
    )


class TbNodeFrame(ctypes.Structure):
    _fields_ = (("id", ctypes.c_uint16), ("bus", ctypes.c_uint8))


def edited(*edits: Edit) -> Machine:
    tables = deepcopy(TABLES)
    for edit in edits:
        edit(tables)
    return machine_from(tables, STOCK)


def drive(number: int, **keys: object) -> Edit:
    return lambda tables: tables["drive"][number].update(keys)


def homing(**keys: object) -> Edit:
    return lambda tables: tables["rail_drive"]["homing"].update(keys)


def held(objects: list[Object]) -> dict[tuple[int, int], int]:
    """What the objects hold in the end."""
    return {(entry.index, entry.subindex): entry.unsigned for entry in objects}


@pytest.fixture(scope="module")
def machine() -> Machine:
    return load_machine(STOCK)


@pytest.fixture(scope="module")
def library() -> ctypes.CDLL:
    folder = ROOT / "generated" / "yoon2023"
    return ctypes.CDLL(str(compile_library([folder / "tb_drives.c"], [folder], "double")))


@pytest.fixture(scope="module")
def drives(library: ctypes.CDLL) -> list[TbDrive]:
    return list((TbDrive * 8).in_dll(library, "tb_drives"))


def test_the_buses_are_those_of_the_file(library: ctypes.CDLL) -> None:
    buses = [
        (bus.name, bus.bit_rate, bus.divider) for bus in (TbBus * 3).in_dll(library, "tb_buses")
    ]
    assert buses == [(b"cable1", 10**6, 1), (b"cable2", 10**6, 1), (b"base", 10**6, 2)]


def test_frames_of_other_nodes_are_listed_with_their_bus() -> None:
    frames = [{"id": 0x194, "length": 8, "period": "10 ms"}]
    io = {"name": "io", "bus": "base", "node": 20, "frames": frames}
    machine = edited(lambda tables: tables.update(node=[io]))
    assert node_frames(machine) == ["{0x714, 2}", "{0x194, 2}"]
    assert constants(machine)["TB_NODE_FRAMES"] == "2"


def test_without_other_nodes_there_is_one_frame_that_no_identifier_is(
    library: ctypes.CDLL,
) -> None:
    (none,) = (TbNodeFrame * 1).in_dll(library, "tb_node_frames")
    assert none.id > 0x7FF
    assert constants(load_machine(STOCK))["TB_NODE_FRAMES"] == "1"


def test_cable_drives_come_first_with_bus_node_and_mode(drives: list[TbDrive]) -> None:
    rows = [(row.name.decode(), row.bus, row.node, row.mode) for row in drives]
    assert rows[:4] == [
        ("cable_1", 0, 1, 0),
        ("cable_2", 0, 2, 0),
        ("cable_3", 1, 1, 0),
        ("cable_4", 1, 2, 0),
    ]
    assert rows[4:] == [(f"base_{node}", 2, node, 0) for node in range(1, 5)]


@pytest.mark.parametrize(
    ("number", "radius", "rated"), [(CABLE, 5e-3, 59.92e-3), (BASE, 15e-3, 258.78e-3)]
)
def test_scales_are_those_of_radius_encoder_and_rated_torque(
    drives: list[TbDrive], number: int, radius: float, rated: float
) -> None:
    row = drives[number]
    assert row.metres_per_increment == pytest.approx(2 * math.pi * radius / 4096)
    assert row.torque_per_unit == pytest.approx(rated / 1000)
    assert row.metres_per_increment * row.increments_per_metre == pytest.approx(1)
    assert row.torque_per_unit * row.units_per_torque == pytest.approx(1)


@pytest.mark.parametrize(("number", "limit"), [(CABLE, 0.055), (BASE, 0.9)])
def test_the_limit_in_per_mille_is_the_largest_within_the_torque_limit(
    drives: list[TbDrive], number: int, limit: float
) -> None:
    row = drives[number]
    assert row.most_torque_units * row.torque_per_unit <= limit * (1 + 1e-9)
    assert (row.most_torque_units + 1) * row.torque_per_unit > limit


def test_every_object_is_compiled_as_it_was_meant(machine: Machine, drives: list[TbDrive]) -> None:
    for axis, row in zip(axes(machine), drives, strict=True):
        for actions, entries, compiled in (
            ({CHECK: 0}, identity(axis), row.identity[: row.identity_count]),
            (
                {WRITE: 0, WRITE_OF_NODE: row.node},
                contract(machine, axis),
                row.contract[: row.contract_count],
            ),
        ):
            wanted = [(e.index, e.subindex, e.size, e.unsigned) for e in entries]
            held = [(c.index, c.subindex, c.size, c.value + actions[c.action]) for c in compiled]
            assert held == wanted


def sharing(machine: Machine) -> list[int]:
    """How many drives have each table of objects."""
    objects: Any = drive_fields(machine)["objects"]
    return [len(table.drives) for table in objects]


def test_drives_that_differ_in_their_number_alone_share_their_tables() -> None:
    assert sharing(edited()) == [4, 4, 4, 4]
    assert sharing(edited(drive(1, revision=7), drive(4, mode="position"))) == [3, 1, 4, 4, 1, 3]


def test_every_row_says_what_it_is_about() -> None:
    fields: Any = drive_fields(edited())
    assert all(row.meaning for table in fields["objects"] for row in table.rows)


def test_modes_are_those_of_the_profile(drives: list[TbDrive]) -> None:
    assert {tuple(row.kind.contents.modes) for row in drives} == {(0, 10, 8, 6)}


def test_a_reversed_drive_counts_and_turns_the_other_way() -> None:
    forward, reverse = (axes(edited(drive(0, direction=way)))[0] for way in ("forward", "reverse"))
    assert reverse.metres_per_increment == -forward.metres_per_increment
    assert reverse.torque_per_unit == -forward.torque_per_unit
    assert reverse.most_torque_units == forward.most_torque_units > 0


# ---- Contract ----


def steps(axis: Axis, machine: Machine, first: int, last: int) -> list[tuple[int, int, int]]:
    found = contract(machine, axis)
    return [(e.index, e.subindex, e.value) for e in found if first <= e.index <= last]


def pdo(entries: list[tuple[int, int, int]], parameters: int, mapping: int) -> list[Any]:
    return [entry for entry in entries if entry[0] in (parameters, mapping)]


def test_pdos_are_described_while_they_are_invalid_in_the_order_of_cia_301(
    machine: Machine,
) -> None:
    entries = steps(axes(machine)[CABLE], machine, 0x1400, 0x1BFF)
    assert pdo(entries, 0x1400, 0x1600) == [
        (0x1400, 1, 0x8000_0202),
        (0x1400, 2, 1),
        (0x1600, 0, 0),
        (0x1600, 1, 0x6040_0010),
        (0x1600, 2, 0x6071_0010),
        (0x1600, 0, 2),
        (0x1400, 1, 0x202),
    ]
    assert pdo(entries, 0x1800, 0x1A00) == [
        (0x1800, 1, 0xC000_0182),
        (0x1800, 2, 1),
        (0x1800, 3, 0),
        (0x1A00, 0, 0),
        (0x1A00, 1, 0x6041_0010),
        (0x1A00, 2, 0x6064_0020),
        (0x1A00, 3, 0x6077_0010),
        (0x1A00, 0, 3),
        (0x1800, 1, 0x4000_0182),
    ]


def test_the_other_pdos_are_made_invalid(machine: Machine) -> None:
    values = held(contract(machine, axes(machine)[CABLE]))
    for number in (1, 2, 3):
        assert values[0x1400 + number, 1] == 0x8000_0202 + 0x100 * number
        assert values[0x1800 + number, 1] == 0xC000_0182 + 0x100 * number


def test_a_position_drive_is_sent_positions() -> None:
    machine = edited(drive(4, mode="position"))
    values = held(contract(machine, axes(machine)[4]))
    assert (values[0x1600, 1], values[0x1600, 2]) == (0x6040_0010, 0x607A_0020)
    assert drive_fields(machine)["drives"][4]["mode"] == 1  # type: ignore[index]


def test_heartbeats_and_reactions_are_those_of_the_file() -> None:
    quick = {"connection_loss": "quick_stop", "quick_stop": "hold", "heartbeat_timeout": "50 ms"}
    for machine, timeout, loss, stop in (
        (load_machine(STOCK), 40, 2, 2),
        (edited(lambda tables: tables.update(supervision=quick)), 50, 3, 6),
    ):
        values = held(contract(machine, axes(machine)[BASE]))
        assert values[0x1016, 1] == 127 << 16 | timeout
        assert values[0x1017, 0] == 20
        assert (values[0x6007, 0], values[0x605A, 0]) == (loss, stop)
        assert [values[index, 0] for index in (0x605B, 0x605C, 0x605E)] == [0, 0, 0]


def test_the_motor_is_checked_and_its_current_limit_is_set(machine: Machine) -> None:
    axis = axes(machine)[CABLE]
    assert held(identity(axis)) == {
        (0x1018, 1): 0xFB,
        (0x6076, 0): 59_920,
        (0x3001, 1): 2140,
        (0x3001, 5): 28_000,
        (0x3010, 1): 1024,
    }
    assert held(contract(machine, axis))[0x3001, 2] == 3000


def test_product_and_revision_are_checked_where_the_file_has_them() -> None:
    machine = edited(drive(0, product=0x6150_0000, revision=0x0170_0000))
    values = held(identity(axes(machine)[0]))
    assert (values[0x1018, 2], values[0x1018, 3]) == (0x6150_0000, 0x0170_0000)


@pytest.mark.parametrize(
    ("end", "direction", "method"),
    [
        ("start", "forward", -4),
        ("start", "reverse", -3),
        ("end", "forward", -3),
        ("end", "reverse", -4),
    ],
)
def test_homing_goes_to_the_stop_whichever_way_the_motor_turns(
    end: str, direction: str, method: int
) -> None:
    machine = edited(homing(end=end, beyond="2 mm"), drive(4, direction=direction))
    axis = axes(machine)[4]
    entries = {(e.index, e.subindex): e.value for e in contract(machine, axis)}
    assert entries[0x6098, 0] == method
    stop = -0.002 if end == "start" else 0.7118 + 0.002
    half = abs(axis.metres_per_increment) / 2
    assert entries[0x30B0, 0] * axis.metres_per_increment == pytest.approx(stop, abs=half)
    assert entries[0x30B1, 0] == 0


def test_homing_speeds_are_in_turns_of_the_motor(machine: Machine) -> None:
    values = held(contract(machine, axes(machine)[BASE]))
    turn = 2 * math.pi * 15e-3
    assert values[0x6099, 1] == values[0x6099, 2] == round(0.06 / turn * 60)
    assert values[0x609A, 0] == round(0.5 / turn * 60)
    assert values[0x30B2, 0] == 1000


def test_bases_begin_with_homing_and_cables_with_torque(machine: Machine) -> None:
    last = [contract(machine, axis)[-1] for axis in axes(machine)]
    assert [(entry.index, entry.value) for entry in last] == [(0x6060, 10)] * 4 + [(0x6060, 6)] * 4


@pytest.mark.parametrize("number", [CABLE, BASE])
def test_values_fit_their_size_and_are_of_the_types_of_the_dictionary(
    machine: Machine, number: int
) -> None:
    sizes = {0x1029: 1, 0x6060: 1, 0x6098: 1, 0x6007: 2, 0x605A: 2, 0x1017: 2, 0x30B2: 2}
    axis = axes(machine)[number]
    for entry in [*identity(axis), *contract(machine, axis)]:
        bits = 8 * entry.size
        assert -(1 << bits - 1) <= entry.value < 1 << bits
        assert entry.size == sizes.get(entry.index, entry.size)
        if 0x1600 <= entry.index < 0x1B00 and not 0x1800 <= entry.index < 0x1900:
            assert entry.size == (1 if entry.subindex == 0 else 4)


# ---- Header ----


def constants(machine: Machine) -> dict[str, str]:
    groups: Any = drive_fields(machine)["groups"]
    return {constant.name: constant.text for _, group in groups for constant in group}


def test_times_are_counted_in_control_cycles() -> None:
    slow = {"rate": "500 Hz", "velocity_corner": "100 Hz"}
    machine = edited(
        lambda tables: tables.update(control=slow),
        *(lambda tables, n=n: tables["bus"][n].update(rate="250 Hz") for n in range(3)),
    )
    assert constants(machine)["TB_HEARTBEAT_CYCLES"] == "5"
    assert constants(machine)["TB_STOP_CYCLES"] == "150"
    assert constants(load_machine(STOCK))["TB_HEARTBEAT_CYCLES"] == "10"


def test_bases_sweep_half_of_a_short_rail() -> None:
    def shorten(tables: dict[str, Any]) -> None:
        tables["cable"][0]["rail"]["to"] = ["150 mm", "0 mm"]

    assert float(constants(edited(shorten))["TB_CALIBRATION_TRAVEL"][5:-1]) == pytest.approx(0.075)


def test_a_machine_without_rails_has_the_same_constants_with_zeros() -> None:
    def fix(tables: dict[str, Any]) -> None:
        corners = [("0 mm", "0 mm"), ("711.8 mm", "0 mm"), ("711.8 mm", "461.8 mm")]
        tables["cable"] = [{"base": list(corner)} for corner in [*corners, ("0 mm", "461.8 mm")]]
        tables["drive"] = tables["drive"][:4]
        tables["bus"] = tables["bus"][:2]
        del tables["rail_drive"]

    fixed = constants(edited(fix))
    assert fixed.keys() == constants(load_machine(STOCK)).keys()
    assert fixed["TB_RAIL_TORQUE_LIMIT"] == "TB_C(0.0)"
    assert fixed["TB_RAIL_LENGTHS"] == "{TB_C(0.0)}"
    assert fixed["TB_DRIVES"] == "4"


def test_the_committed_tables_are_those_of_the_file(machine: Machine) -> None:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES), keep_trailing_newline=True
    )
    for name in ("tb_drives.h", "tb_drives.c"):
        fresh = environment.get_template(f"{name}.jinja").render(banner="", **drive_fields(machine))
        committed = (ROOT / "generated" / "yoon2023" / name).read_text()
        assert committed.split("*/\n", 1)[1] == fresh.removeprefix("\n")
