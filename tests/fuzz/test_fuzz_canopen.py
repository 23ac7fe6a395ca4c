"""SDO, PDO and EMCY take any bytes; seeded defects are found."""

from pathlib import Path

import pytest
from fuzzing import ROOT, Target

RUNTIME = ROOT / "runtime"
CANOPEN = RUNTIME / "canopen"
FOLDERS = (CANOPEN, RUNTIME / "can", RUNTIME / "core", ROOT / "generated" / "yoon2023")


def target(name: str, *sources: str) -> Target:
    """A target with files of the runtime's CANopen."""
    return Target(name, tuple(CANOPEN / f"{source}.c" for source in sources), FOLDERS)


TARGETS = {
    "sdo": target("sdo", "sdo"),
    "pdo": target("pdo", "pdo", "cia402", "nmt"),
    "emcy": target("emcy", "emcy"),
}

DEFECTS = {
    "sdo: an expedited answer longer than its room": (
        "sdo",
        "sdo",
        "if (count > client->room) {",
        "if (count > client->room + 4u) {",
    ),
    "sdo: a segment longer than its room": ("sdo", "sdo", "if (count > left) {", "if (false) {"),
    "sdo: a server that is waited for without end": (
        "sdo",
        "sdo",
        "    client->waited++;\n",
        "",
    ),
    "sdo: a length told that is longer than the room": (
        "sdo",
        "sdo",
        "if (client->size > client->room) {",
        "if (client->size == client->room + 1u) {",
    ),
    "pdo: a status message of any length": (
        "pdo",
        "pdo",
        "frame->length != STATUS_LENGTH",
        "frame->length < STATUS_LENGTH",
    ),
    "pdo: a fault reset that nobody asked for": (
        "pdo",
        "cia402",
        "return QUICK_STOP;",
        "return reset_fault(power, previous);",
    ),
    "emcy: a warning that covers a fault": (
        "emcy",
        "emcy",
        "said.class > emergency->class",
        "said.class != emergency->class",
    ),
}


@pytest.mark.parametrize("name", TARGETS)
def test_any_bytes_from_a_drive_for_a_minute(name: str, tmp_path: Path) -> None:
    assert TARGETS[name].build(tmp_path).finding(60) is None


@pytest.mark.parametrize("defect", DEFECTS)
def test_a_seeded_defect_is_found(defect: str, tmp_path: Path) -> None:
    name, source, old, new = DEFECTS[defect]
    seeded = TARGETS[name].with_defect(CANOPEN / f"{source}.c", old, new, tmp_path)
    assert seeded.build(tmp_path).finding(20) is not None
