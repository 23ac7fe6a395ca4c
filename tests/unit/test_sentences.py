"""What a stopped machine tells its user: the culprit, what was found and wanted, what to do."""

import ctypes
import itertools
import re
from ctypes import byref
from pathlib import Path
from typing import Any

import pytest
from canopen_c import MACHINE, RUNTIME, Canopen

from turnbuckle.model.words import LONGEST_IDENTIFIER

LINUX = RUNTIME / "port" / "linux"
CODES = [RUNTIME / "canopen" / f"{name}.c" for name in ("emcy", "sdo", "drive_kind")]
SOURCES = [
    RUNTIME / "core" / "words.c",
    RUNTIME / "canopen" / "cia402.c",
    *CODES,
    *(RUNTIME / "canopen" / f"{name}.c" for name in ("setup", "nmt")),
    LINUX / "sentence.c",
]
C = Canopen([MACHINE / "tb_drives.c", *SOURCES], folders=[LINUX])
INDICES = (0, 0x1400, 0x6060)
"""Of objects: none, one of the contract, the mode."""
ABOUT_A_DEVICE = 160
"""Characters that runtime/port/linux/reopening.c has for what to do about a device."""
CONTRACT = "cable_1 (bus cable1, node 1): did not take its configuration"


def sentence(cause: str, **fields: Any) -> str:
    """tb_sentence_of_cause of orders that tell a cause."""
    orders = C.new("tb_orders")
    orders.cause = getattr(C, f"TB_CAUSE_{cause}")
    mode = fields.pop("mode", 0)
    for name, value in fields.items():
        setattr(orders, name, value)
    orders.drives[orders.culprit].mode = mode
    text = ctypes.create_string_buffer(400)
    C.tb_sentence_of_cause(byref(orders), ctypes.c_size_t(len(text)), text)
    return text.value.decode()


def failure(name: str) -> int:
    """A tb_failure."""
    number: int = getattr(C, f"TB_FAILURE_{name}")
    return number


@pytest.mark.parametrize(
    ("index", "subindex", "found", "said"),
    [
        (0x1017, 0, 0x15, "holds 0x15, the machine file says 0x14"),
        # 1400:1 is written twice, first as invalid
        (0x1400, 1, 0x201, "holds 0x201, the machine file says 0x80000201"),
        (0x1400, 1, 0x80000201, "holds 0x80000201, the machine file says 0x201"),
        (0x1600, 0, 2, "holds 0x2, the machine file says 0x0"),
        (0x1600, 0, 0, "holds 0x0, the machine file says 0x2"),
    ],
)
def test_what_was_found_and_what_was_wanted_differ_in_what_is_shown(
    index: int, subindex: int, found: int, said: str
) -> None:
    told = sentence(
        "DRIVE_SETUP", index=index, subindex=subindex, detail=found, failure=failure("DIFFERENT")
    )
    assert told.startswith(f"drive {CONTRACT}: object {index:04X}:{subindex:02X} {said};")


def test_an_object_of_another_size_is_told_by_its_size() -> None:
    told = sentence("DRIVE_SETUP", index=0x1017, detail=1, failure=failure("SIZE"))
    assert ": object 1017:00 has 1 byte, the machine file says 2;" in told


def test_a_mode_that_was_not_taken_is_told_as_the_mode_that_was_ordered() -> None:
    values = {"index": 0x6060, "detail": 6, "failure": failure("DIFFERENT"), "culprit": 4}
    told = sentence("DRIVE_SETUP", mode=C.TB_MODE_TORQUE, **values)
    assert ": object 6060:00 holds 0x6, it was told 0xA;" in told


def test_a_drive_that_booted_again_is_told() -> None:
    told = sentence("DRIVE_SETUP", failure=failure("RESTARTED"))
    assert told.startswith(f"drive {CONTRACT}: it booted again;")


def test_a_drive_under_local_control_is_told() -> None:
    told = sentence("DRIVE_LOCAL", detail=0x0037)
    assert told.startswith("drive cable_1 (bus cable1, node 1): is not under remote control; ")


@pytest.mark.parametrize(
    ("identifier", "said"),
    [
        (0x000, "an NMT command"),
        (0x080, "SYNC"),
        (0x100, "TIME"),
        (0x201, "setpoints"),
        (0x505, "setpoints"),
        (0x601, "an SDO request"),
        (0x77F, "a master's heartbeat"),
    ],
)
def test_another_master_is_told_by_what_it_sent(identifier: int, said: str) -> None:
    told = sentence("OTHER_MASTER", culprit=2, detail=identifier >> 7)
    assert told.startswith(f"bus base: another master is on the bus: it sent {said}; ")


def test_a_stranger_is_told_where_it_could_be_named() -> None:
    told = sentence("STRANGER", culprit=2, detail=20)
    assert ": of node 20; " in told
    assert "put it with its frames into a table [[node]]" in told


def all_sentences(library: Canopen, room: int) -> list[str]:
    """What is said of every cause, with all that can be known of it, in so many bytes."""
    orders, text = library.new("tb_orders"), ctypes.create_string_buffer(room)
    codes = re.findall(
        r"0x[0-9A-F]{8}|0x[0-9A-F]{4}",
        "".join(map(Path.read_text, [*CODES, MACHINE / "tb_drives.c"])),
    )
    details = [1, 0xFFFFFFFF, C.TB_CALIBRATION_OPEN, *(int(code, 16) for code in codes)]
    causes, failures = (library.constants(f"TB_{kind}_").values() for kind in ("CAUSE", "FAILURE"))
    found = []
    for orders.cause, orders.failure, orders.index in itertools.product(causes, failures, INDICES):
        for orders.detail in details:
            library.tb_sentence_of_cause(byref(orders), ctypes.c_size_t(room), text)
            found.append(text.value.decode())
    return found


def macro(name: str, header: str) -> int:
    """A number of a header of the port."""
    found = re.search(rf"#define {name} (\d+)", (LINUX / header).read_text())
    assert found
    return int(found[1])


def test_no_sentence_is_cut_however_long_the_names_are(tmp_path: Path) -> None:
    tables = tmp_path / "tb_drives.c"
    longest = (MACHINE / "tb_drives.c").read_text()
    tables.write_text(re.sub(r'"[a-z]+_?\d?"', f'"{"w" * LONGEST_IDENTIFIER}"', longest))
    library = Canopen([tables, *SOURCES], folders=[LINUX])
    room = macro("TB_TELEMETRY_TEXT", "telemetry.h")
    device = macro("TB_LONGEST_DEVICE", "options.h")
    told = all_sentences(library, room)
    assert told == all_sentences(library, 1 << 16)
    assert told != all_sentences(library, 200)  # so few bytes would cut
    assert max(map(len, told)) + len("; slcan:") + device + ABOUT_A_DEVICE < room
