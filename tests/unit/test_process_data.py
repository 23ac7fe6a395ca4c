"""The runtime packs and reads process data as the contract of the drives maps them."""

from ctypes import byref
from itertools import permutations
from pathlib import Path
from typing import Any

import pytest
from canopen_c import RUNTIME, Canopen, Frame, read

from turnbuckle.codegen.bus import process_data
from turnbuckle.codegen.generate import render
from turnbuckle.codegen.model import Model
from turnbuckle.model.bus import frames
from turnbuckle.model.bus.axis import axes
from turnbuckle.model.bus.contract import contract
from turnbuckle.model.machine import Machine
from turnbuckle.model.reading import load_machine
from turnbuckle.places import MACHINES

SOURCES = [RUNTIME / "canopen" / "pdo.c"]
VALUES = {0x6040: 0x1234, 0x6041: 0x5678, 0x6064: -123456789, 0x6071: -321, 0x6077: -654}
"""Of each object."""


@pytest.fixture(scope="module")
def machine() -> Machine:
    """The stock machine."""
    return load_machine(MACHINES / "yoon2023.toml")


def compiled(machine: Machine, folder: Path) -> Canopen:
    """The runtime's process data with the machine's constants."""
    text = render(Model(machine, {}), {})["tb_drives.h"]
    (folder / "tb_drives.h").write_text(text)
    return Canopen(SOURCES, folders=[folder])


def mapped(machine: Machine, mapping: int) -> bytes:
    """A frame with these values as the contract of the first drive maps them."""
    entries = [entry for entry in contract(machine, axes(machine)[0]) if entry.index == mapping]
    codes = [entry.unsigned for entry in entries if entry.subindex > 0]
    parts = [(VALUES[code >> 16], (code & 0xFF) // 8) for code in codes]
    return b"".join((value % (1 << 8 * size)).to_bytes(size, "little") for value, size in parts)


def status_of(c: Canopen, data: bytes) -> tuple[int, int, int]:
    """What the runtime reads of a status message."""
    status: Any = c.new("tb_pdo_status")
    assert c.tb_pdo_take(byref(status), byref(c.frame(Frame(0x181, data))))
    return status.statusword, status.position, status.torque


@pytest.mark.parametrize("order", list(permutations(range(3))), ids=str)
def test_a_status_message_is_read_as_the_contract_maps_it(
    machine: Machine, order: tuple[int, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    swapped = tuple(frames.STATUS[k] for k in order)
    for home in (frames, process_data):
        monkeypatch.setattr(home, "STATUS", swapped)
    found = status_of(compiled(machine, tmp_path), mapped(machine, 0x1A00))
    assert found == (VALUES[0x6041], VALUES[0x6064], VALUES[0x6077])


@pytest.mark.parametrize("order", list(permutations(range(2))), ids=str)
def test_a_setpoint_is_packed_as_the_contract_maps_it(
    machine: Machine, order: tuple[int, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    torque = frames.COMMANDS["torque"]
    monkeypatch.setitem(frames.COMMANDS, "torque", tuple(torque[k] for k in order))
    c = compiled(machine, tmp_path)
    frame = c.tb_pdo_torque_frame(1, VALUES[0x6040], VALUES[0x6071])
    assert read(frame) == Frame(0x201, mapped(machine, 0x1600))


def test_two_entries_that_are_swapped_in_one_place_alone_are_read_wrong(
    machine: Machine, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(process_data, "STATUS", frames.STATUS[::-1])
    found = status_of(compiled(machine, tmp_path), mapped(machine, 0x1A00))
    assert found != (VALUES[0x6041], VALUES[0x6064], VALUES[0x6077])
