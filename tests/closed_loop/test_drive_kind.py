"""A kind of drive that is one file: that of docs/adding-a-drive.md, in a machine beside EPOS4s."""

import ctypes
import importlib
import pkgutil
import re
import tomllib
from collections.abc import Iterator
from ctypes import byref
from dataclasses import replace
from types import ModuleType
from typing import Any

import pytest
import variants
from canopen_c import RUNTIME, SOURCES, Canopen

from turnbuckle.codegen.bind import Generated
from turnbuckle.codegen.bus.dbc import dbc_files
from turnbuckle.codegen.generate import generate, write
from turnbuckle.lab.demo import plan_task, plant_of
from turnbuckle.lab.lockstep import Lockstep, State
from turnbuckle.lab.machine_sim import SimulatedMachine
from turnbuckle.lab.task import Task
from turnbuckle.model.bus import drive_kinds
from turnbuckle.model.bus.axis import axes
from turnbuckle.model.bus.contract import contract, identity
from turnbuckle.model.bus.drive_kinds import DRIVE_KINDS, by_name, epos4
from turnbuckle.model.bus.drive_kinds.kind import DriveError, DriveKind, Setting
from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import MachineError
from turnbuckle.model.reading import machine_from

PAGE = (variants.ROOT / "docs" / "adding-a-drive.md").read_text()
CABLE, BASE = 1, 6
"""The drives of the new kind: cable_2, base_3."""
KNOWN = tuple(DRIVE_KINDS.values())
BRING_UP = 60_000
"""Cycles that are more than enough."""


def block(language: str) -> str:
    """The one code block of the page in a language."""
    (found,) = re.findall(rf"^```{language}\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
    return str(found)


def page_kind() -> DriveKind:
    """The kind of the page."""
    module = ModuleType("acme")
    exec(compile(block("python"), "acme.py", "exec"), module.__dict__)
    kind: DriveKind = module.KIND
    return kind


@pytest.fixture(scope="module", autouse=True)
def acme() -> Iterator[DriveKind]:
    """The kind, registered."""
    kind = page_kind()
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(DRIVE_KINDS, kind.name, kind)
        yield kind


def tables(**keys: Any) -> dict[str, Any]:
    """The stock machine with a cable drive and a base drive of the new kind."""
    found = variants.stock()
    (named,) = tomllib.loads(block("toml"))["drive"]
    found["drive"][CABLE] = named
    found["drive"][BASE]["kind"] = named["kind"]
    found["rail_drive"]["homing"]["beyond"] = "2 mm"
    return {**found, **keys}


def machine_of(content: dict[str, Any]) -> Machine:
    """A machine of these tables."""
    return machine_from(content, variants.STOCK)


@pytest.fixture(scope="module")
def generated(tmp_path_factory: pytest.TempPathFactory) -> Generated:
    """The mixed machine, generated."""
    machine, folder = machine_of(tables()), tmp_path_factory.mktemp("mixed") / "yoon2023"
    write(generate(machine), folder)
    return Generated(machine, folder, "double")


@pytest.fixture(scope="module")
def task(generated: Generated) -> Task:
    """What is done with it."""
    return plan_task(generated)


@pytest.fixture
def lockstep(generated: Generated, task: Task) -> Lockstep:
    """The machine at power-on."""
    machine = generated.machine
    return Lockstep(generated, SimulatedMachine(machine, plant_of(machine), task))


@pytest.fixture(scope="module")
def words(generated: Generated) -> Canopen:
    """What tells a cause, with the machine's tables."""
    linux = RUNTIME / "port" / "linux"
    own = [generated.folder / "tb_drives.c", RUNTIME / "core" / "words.c", linux / "sentence.c"]
    shared = [source for source in SOURCES if source.name != "tb_drives.c"]
    return Canopen([*own, *shared], folders=[generated.folder, linux])


def told(words: Canopen, lockstep: Lockstep, **other: int) -> str:
    """The sentence of the machine's cause, or of one that differs in something from it."""
    orders, text = words.new("tb_orders"), ctypes.create_string_buffer(500)
    for name in ("cause", "culprit", "index", "subindex", "failure", "detail"):
        setattr(orders, name, other.get(name, int(lockstep.view[name])))
    words.tb_sentence_of_cause(byref(orders), ctypes.c_size_t(len(text)), text)
    return text.value.decode()


def stopped(lockstep: Lockstep) -> State:
    """Run until the machine has stopped for a fault, or has not for long."""
    return lockstep.run_until([State.HARD_STOP, State.FAULT], 3000)


def check_scales(lockstep: Lockstep) -> None:
    """Cables pull as ordered [N m], bases are where they are [m], whatever a drive's units."""
    view, machine = lockstep.view, lockstep.machine
    for number, axis in enumerate(axes(machine_of(tables()))):
        if axis.rail is None:
            pulls = axis.sense * machine.drives[number].servo.torque
            assert abs(view["ordered"][number] - pulls) < 3 * abs(axis.torque_per_unit)
        else:
            assert abs(view["position"][number] - machine.positions[number]) < 0.2e-3


def test_a_mixed_machine_comes_up_and_tells_an_error_in_the_words_of_its_maker(
    lockstep: Lockstep, words: Canopen
) -> None:
    assert lockstep.bring_up(BRING_UP) is State.RUN, told(words, lockstep)
    lockstep.run(100)
    check_scales(lockstep)
    lockstep.machine.drives[CABLE].raise_error(0xFF20)
    lockstep.run(100)
    assert lockstep.state is State.RUN  # a warning of this maker
    lockstep.machine.drives[CABLE].raise_error(0x5441)
    stopped(lockstep)
    assert "drive cable_2" in told(words, lockstep)
    assert "error 5441 (motor cable is not plugged)" in told(words, lockstep)
    of_an_epos4 = told(words, lockstep, culprit=CABLE - 1)
    assert "error 5441 (hardware error)" in of_an_epos4


@pytest.mark.parametrize(
    ("number", "vendor", "said"),
    [
        (CABLE, 0xFB, "0xFB, the machine file says 0x123"),
        (0, 0x123, "0x123, the machine file says"),
    ],
)
def test_a_drive_of_another_maker_is_refused_by_name(
    lockstep: Lockstep, words: Canopen, number: int, vendor: int, said: str
) -> None:
    drive = lockstep.machine.drives[number]
    drive.setup = replace(drive.setup, identity=replace(drive.setup.identity, vendor=vendor))
    drive.describe()
    lockstep.run(3000)
    assert lockstep.state in (State.INIT, State.IDENTIFY, State.FAULT)
    assert f"drive cable_{number + 1}" in told(words, lockstep)
    assert f"object 1018:01 holds {said}" in told(words, lockstep)


def test_an_abort_is_told_in_the_words_of_its_maker(lockstep: Lockstep, words: Canopen) -> None:
    lockstep.machine.drives[BASE].refuse((0x2031, 0), 0x06040030)
    lockstep.run(3000)
    assert "drive base_3" in told(words, lockstep)
    assert "aborted with 06040030 (locked by its key)" in told(words, lockstep)
    of_an_epos4 = told(words, lockstep, culprit=BASE - 1)
    assert "aborted with 06040030 (unknown abort code)" in of_an_epos4


def test_its_contract_has_its_objects_and_none_of_the_epos4() -> None:
    machine = machine_of(tables())
    axis = axes(machine)[BASE]
    entries = [*identity(axis), *contract(machine, axis)]
    held = {(entry.index, entry.subindex): entry.value for entry in entries}
    assert {0x2031, 0x2060, 0x2070, 0x203A, 0x607C} <= {entry.index for entry in entries}
    assert not {0x3001, 0x3010, 0x6007, 0x30B0, 0x30B1, 0x30B2, 0x1029} & {
        entry.index for entry in entries
    }
    assert held[0x1018, 1] == 0x123 and held[0x6076, 0] == 259
    assert held[0x6098, 0] == -17 and held[0x203A, 1] == round(1e6 / 2270)
    assert held[0x6099, 1] == round(0.06 / (2 * 3.141592653589793 * 0.015) * 4096)
    assert held[0x1404, 1] == 0x8000_0000 and held[0x1405, 1] == 0x8000_0000
    assert axis.torque_per_unit == 1e-4


def test_the_dbc_names_the_errors_of_each_drive_by_its_maker() -> None:
    lines = dbc_files(machine_of(tables()))["yoon2023_cable1.dbc"].splitlines()
    first, second = (line for line in lines if line.startswith("VAL_ 1") and "code" in line)
    assert "safe_torque_off" in first and "motor_cable_is_not_plugged" not in first
    assert "motor_cable_is_not_plugged" in second and "safe_torque_off" not in second


def rail_drive(**homing: str) -> dict[str, Any]:
    """The table with another homing."""
    table = variants.stock()["rail_drive"]
    return {**table, "homing": {**table["homing"], **homing}}


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        (
            {"rail_drive": rail_drive(current="5 A")},
            'rail_drive.homing.current: found "5 A"; allowed: at most 4.54 A, in object 203A of'
            " the Acme S1",
        ),
        (
            {"supervision": {"quick_stop": "hold"}},
            'supervision.quick_stop: found "hold"; allowed: "off" for cable_2, Acme S1',
        ),
    ],
)
def test_what_the_kind_cannot_do_is_refused(keys: dict[str, Any], message: str) -> None:
    machine_of({**variants.stock(), **keys})  # EPOS4s can
    with pytest.raises(MachineError) as caught:
        machine_of(tables(**keys))
    assert message in str(caught.value)


def test_a_base_that_follows_positions_needs_a_drive_that_can() -> None:
    content = tables()
    content["drive"][BASE]["mode"] = "position"
    with pytest.raises(MachineError, match=r'drive\[7\]\.mode.*allowed: "torque" for the Acme S1'):
        machine_of(content)


def test_a_base_needs_a_drive_that_finds_the_stop(
    acme: DriveKind, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(DRIVE_KINDS, "acme", replace(acme, homing=None))
    with pytest.raises(
        MachineError, match=r"drive\[7\]\.kind: found \"acme\", which finds no stop"
    ):
        machine_of(tables())


def test_a_kind_without_the_mode_that_a_drive_has_by_default_is_refused(
    acme: DriveKind, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(DRIVE_KINDS, "acme", replace(acme, modes={"position": 8, "homing": 6}))
    message = r'drive\[2\]\.mode: found "torque", the default; allowed: "position" for the Acme S1'
    with pytest.raises(MachineError, match=message):
        machine_of(tables())


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"modes": {"torqe": -2, "homing": 6}}, "`modes` has torqe; allowed: homing, position"),
        ({"modes": {"torque": -2}}, "`modes` has no homing"),
        ({"pdos": 0}, "`pdos` is 0"),
        ({"settings": (Setting(0x2070, 0, 3, 1, "any"),)}, "object 2070:00 has 3 bytes"),
        ({"lacks": frozenset({0x1016})}, "without 1016; `lacks` may name 1029, 605B, 605C, 605E"),
    ],
)
def test_a_slip_in_the_file_of_a_kind_is_told_where_it_stands(
    acme: DriveKind, changes: dict[str, Any], message: str
) -> None:
    with pytest.raises(ValueError, match=f"acme: .*{message}"):
        replace(acme, **changes)


def test_every_file_of_a_kind_is_registered() -> None:
    """One that is not is no word for a machine file."""
    paths = pkgutil.iter_modules(drive_kinds.__path__, f"{drive_kinds.__name__}.")
    modules = [importlib.import_module(path.name) for path in paths]
    missing = [m.__name__ for m in modules if getattr(m, "KIND", None) not in (None, *KNOWN)]
    assert not missing, "model/bus/drive_kinds/__init__.py: no KIND of these"


def test_no_kind_takes_the_name_of_another(acme: DriveKind) -> None:
    assert by_name(epos4.KIND, acme) == {"epos4": epos4.KIND, "acme": acme}
    with pytest.raises(ValueError, match="two kinds of drives share a name: epos4, epos4"):
        by_name(epos4.KIND, replace(acme, name="epos4"))


def test_a_kind_that_does_not_miss_the_master_is_none(acme: DriveKind) -> None:
    with pytest.raises(ValueError, match="acme: a machine cannot do without"):
        replace(acme, lacks=frozenset({0x1016}))


def test_no_kind_gives_the_all_clear_other_words(acme: DriveKind) -> None:
    with pytest.raises(ValueError, match="acme: the error code 0"):
        replace(acme, errors=(DriveError(0, 0xFFFF, "any"),))
