"""The DBC of every bus: what cantools makes of frames is what the runtime means by them."""

import tomllib
from pathlib import Path

import cantools
import pytest
from cantools.database.can import Database, Message
from hypothesis import given
from hypothesis import strategies as st

from turnbuckle.codegen.bus.dbc import dbc_files, power_words
from turnbuckle.model.bus.axis import Axis, axes
from turnbuckle.model.bus.frames import messages
from turnbuckle.model.bus.plan import loads, timing
from turnbuckle.model.reading import load_machine, machine_from

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"
MACHINE = load_machine(STOCK)
FILES = dbc_files(MACHINE)
DATABASES: dict[str, Database] = {}
for name, text in FILES.items():
    loaded = cantools.database.load_string(text, "dbc", strict=True)
    assert isinstance(loaded, Database)
    DATABASES[name] = loaded
AXES = {axis.drive.name: axis for axis in axes(MACHINE)}
INT16 = st.integers(-(2**15), 2**15 - 1)
INT32 = st.integers(-(2**31), 2**31 - 1)
WORD = st.integers(0, 2**16 - 1)


def message(name: str) -> Message:
    """The message of this name, on the first bus that has it."""
    return next(m for database in DATABASES.values() for m in database.messages if m.name == name)


def test_each_bus_has_a_dbc_and_the_committed_ones_are_these() -> None:
    assert list(FILES) == [f"yoon2023_{bus}.dbc" for bus in ("cable1", "cable2", "base")]
    for name, text in FILES.items():
        assert (ROOT / "generated" / "yoon2023" / name).read_text() == text


@pytest.mark.parametrize("number", [0, 1, 2])
def test_it_names_every_frame_of_the_bus_proof_but_sdo(number: int) -> None:
    load = loads(MACHINE)[number]
    proven = messages(load.drives, timing(MACHINE).pace(load))
    wanted = {m.identifier: m.size for m in proven if not m.name.startswith("SDO")}
    named = DATABASES[f"yoon2023_{load.name}.dbc"].messages
    assert {m.frame_id: m.length for m in named} == wanted


def test_other_nodes_are_in_the_dbc_of_their_bus() -> None:
    tables = tomllib.loads(STOCK.read_text())
    frames = [{"id": 0x194, "length": 6, "period": "10 ms"}]
    tables["node"] = [{"name": "io", "bus": "base", "node": 20, "frames": frames}]
    machine = machine_from(tables, STOCK)
    files = dbc_files(machine)
    database = cantools.database.load_string(files["yoon2023_base.dbc"], "dbc", strict=True)
    assert isinstance(database, Database)
    load = loads(machine)[2]
    proven = messages(load.drives, timing(machine).pace(load), load.nodes)
    wanted = {m.identifier: m.size for m in proven if not m.name.startswith("SDO")}
    assert {m.frame_id: m.length for m in database.messages} == wanted
    (sent,) = [m for m in database.messages if m.frame_id == 0x194]
    assert (sent.name, sent.senders, sent.cycle_time) == ("io_194", ["io"], 10)
    assert "io" not in files["yoon2023_cable1.dbc"].split()


@pytest.mark.parametrize("name", ["cable_3", "base_2"])
@given(word=WORD, position=INT32, torque=INT16)
def test_an_answer_decodes_to_metres_and_newton_metres(
    name: str, word: int, position: int, torque: int
) -> None:
    axis: Axis = AXES[name]
    frame = word.to_bytes(2, "little")
    frame += position.to_bytes(4, "little", signed=True) + torque.to_bytes(2, "little", signed=True)
    seen = message(f"{name}_answer").decode(frame, decode_choices=False)
    assert isinstance(seen, dict)
    assert seen["position"] == pytest.approx(position * axis.metres_per_increment, rel=1e-12)
    assert seen["torque"] == pytest.approx(torque * axis.torque_per_unit, rel=1e-12)
    assert (seen["power"], seen["warning"]) == (word & 0x7F, word >> 7 & 1)
    assert (seen["remote"], seen["referenced"]) == (word >> 9 & 1, word >> 15)


@given(permille=INT16)
def test_a_command_encodes_to_the_per_mille_of_the_wire(permille: int) -> None:
    torque = permille * AXES["cable_2"].torque_per_unit
    frame = message("cable_2_command").encode(
        {
            "command": "enable_operation",
            "mode_bits": 0,
            "fault_reset": 0,
            "halt": 0,
            "torque": torque,
        },
        strict=False,
    )
    assert frame == b"\x0f\x00" + permille.to_bytes(2, "little", signed=True)


def test_states_and_emergencies_have_names() -> None:
    answer = message("base_1_answer").decode(bytes([0x37, 0x02, 0, 0, 0, 0, 0, 0]))
    heartbeat = message("master_heartbeat").decode(b"\x05")
    emergency = message("base_1_emergency").decode(bytes([0x30, 0x81, 0x11, 0, 0, 0, 0, 0]))
    assert isinstance(answer, dict) and isinstance(heartbeat, dict) and isinstance(emergency, dict)
    assert answer["power"] == "operation_enabled"
    assert heartbeat["state"] == "operational"
    assert emergency["code"] == "heartbeat_missed"


def test_no_pattern_of_a_statusword_has_two_names() -> None:
    patterns = [bits for bits, _ in power_words()]
    assert len(patterns) == len(set(patterns))
    named = dict(power_words())
    assert named[0x27] == named[0x37] == "operation_enabled"
    assert named[0x0F] == named[0x3F] == "fault_reaction_active"
    assert 0x25 not in named


def test_units_and_cycle_times_are_given() -> None:
    answer = message("cable_1_answer")
    units = {signal.name: signal.unit for signal in answer.signals}
    assert (units["position"], units["torque"]) == ("m", "N m")
    assert (answer.cycle_time, message("base_1_answer").cycle_time) == (1, 2)
    assert message("master_heartbeat").cycle_time == 10
