"""What the hash of a machine covers: all that decides what its controller does, nothing else."""

import re
import tomllib
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import tomlkit

from turnbuckle.codegen import identity
from turnbuckle.codegen.generate import render
from turnbuckle.codegen.identity import facts, machine_hash
from turnbuckle.codegen.model import Model
from turnbuckle.model.bus import contract, frames
from turnbuckle.model.bus.drive_kinds import DRIVE_KINDS, epos4
from turnbuckle.model.bus.drive_kinds.kind import Setting, Severity, Simulated
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.model.refusal import Refusal
from turnbuckle.places import MACHINES

STOCK = MACHINES / "yoon2023.toml"
NAMES = ["yoon2023", "spidar_g", "brau_five"]
Place = tuple[str | int, ...]


def without_functions(machine: Machine) -> Model:
    """The machine with its constants and tables alone: those of formulas have their own prints."""
    return Model(machine, {})


def code(machine: Machine) -> str:
    """The C of constants and tables, without comments."""
    files = render(without_functions(machine), {})
    text = "".join(text for name, text in sorted(files.items()) if name.endswith((".c", ".h")))
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    return re.sub(r'#define TB_MACHINE_HASH ".*"', "", text)


def leaves(tables: Any, path: Place = ()) -> Iterator[Place]:
    """Where the values of a machine file are."""
    entries = tables.items() if isinstance(tables, dict) else enumerate(tables)
    for key, value in entries:
        if isinstance(value, dict | list):
            yield from leaves(value, (*path, key))
        else:
            yield (*path, key)


def other(value: Any) -> Any:
    """A value of the same kind that is not the same."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        return value
    if isinstance(value, int | float):
        return value + 1
    return re.sub(r"\d+(\.\d+)?", lambda number: f"{float(number[0]) * 1.02:.6g}", value, count=1)


def changed(text: str, path: Place, folder: Path) -> Machine | None:
    """The machine with another value at a place, where it may have one."""
    document: Any = tomlkit.parse(text)
    table = document
    for key in path[:-1]:
        table = table[key]
    table[path[-1]] = other(tomllib.loads(tomlkit.dumps({"value": table[path[-1]]}))["value"])
    file = folder / "changed.toml"
    file.write_text(tomlkit.dumps(document))
    try:
        return load_machine(file)
    except Refusal:
        return None


@pytest.mark.parametrize("name", NAMES)
def test_the_hash_changes_exactly_where_the_code_does(name: str, tmp_path: Path) -> None:
    text = (MACHINES / f"{name}.toml").read_text()
    machine = load_machine(MACHINES / f"{name}.toml")
    same_code, same_facts = code(machine), list(facts(without_functions(machine)))
    differing = 0
    for path in leaves(tomllib.loads(text)):
        if (edited := changed(text, path, tmp_path)) is not None:
            differs = code(edited) != same_code
            assert (list(facts(without_functions(edited))) != same_facts) == differs, path
            differing += differs
    assert differing >= 5


@pytest.mark.parametrize(
    ("pattern", "replacement"),
    [
        (r"(\[plant\][^\[]*?= \")(\d)", r"\g<1>1\2"),
        (r'"7 N"', '"7000 mN"'),
        (r"#.*", "# another comment"),
    ],
    ids=["the plant", "the spelling of a unit", "comments"],
)
def test_what_does_not_reach_the_controller_leaves_the_hash(
    pattern: str, replacement: str, tmp_path: Path
) -> None:
    text = STOCK.read_text()
    edited = re.sub(pattern, replacement, text)
    assert edited != text
    (tmp_path / "same.toml").write_text(edited)
    before, after = (load_machine(path) for path in (STOCK, tmp_path / "same.toml"))
    assert machine_hash(without_functions(after)) == machine_hash(without_functions(before))


def test_another_contract_of_the_same_machine_is_another_hash(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    machine = without_functions(load_machine(STOCK))
    before = machine_hash(machine)
    with monkeypatch.context() as patch:
        patch.setitem(epos4.KIND.connection_loss.codes, "disable", 3)
        assert machine_hash(machine) != before
    swapped = frames.POSITION, frames.STATUSWORD, frames.TORQUE
    with monkeypatch.context() as patch:
        patch.setattr(contract, "tpdo_map", lambda drive: swapped)
        assert machine_hash(machine) != before
    assert machine_hash(machine) == before


CHANGES = {
    "its vendor": {"vendor": 0xFC},
    "its modes": {"modes": {**epos4.KIND.modes, "torque": 4}},
    "its unit of torque": {"torque": lambda motor: 1e-3},
    "its number of PDOs": {"pdos": 8},
    "a text of an error": {"errors": (replace(epos4.ERRORS[0], text="another"), *epos4.ERRORS[1:])},
    "how bad an error is": {
        "errors": tuple(replace(error, severity=Severity.WARNING) for error in epos4.ERRORS)
    },
    "a text of an abort": {"aborts": {**epos4.ABORTS, 0x0F00FFBE: "another"}},
    "an object more": {"settings": (Setting(0x2002, 0, 1, 1, "more"),)},
    "an object less": {"lacks": frozenset({0x1029})},
}


@pytest.mark.parametrize("changes", CHANGES.values(), ids=CHANGES.keys())
def test_another_drive_of_the_same_name_is_another_hash(
    changes: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    machine = without_functions(load_machine(STOCK))
    before = machine_hash(machine)
    monkeypatch.setitem(DRIVE_KINDS, "epos4", replace(epos4.KIND, **changes))
    assert machine_hash(machine) != before


def test_what_the_simulated_drive_does_leaves_the_hash(monkeypatch: pytest.MonkeyPatch) -> None:
    machine = without_functions(load_machine(STOCK))
    before = machine_hash(machine)
    monkeypatch.setitem(DRIVE_KINDS, "epos4", replace(epos4.KIND, simulated=Simulated()))
    assert machine_hash(machine) == before


def test_another_version_is_another_hash(monkeypatch: pytest.MonkeyPatch) -> None:
    machine = without_functions(load_machine(STOCK))
    before = machine_hash(machine)
    monkeypatch.setattr(identity, "VERSION", "99.0.0")
    assert machine_hash(machine) != before
