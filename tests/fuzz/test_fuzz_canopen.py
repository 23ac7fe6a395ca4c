"""SDO, PDO and EMCY take any bytes; seeded defects are found."""

from pathlib import Path

import pytest
from fuzzing import ENOUGH, ROOT, SECONDS, Target

RUNTIME = ROOT / "runtime"
CANOPEN = RUNTIME / "canopen"
FOLDERS = (CANOPEN, RUNTIME / "can", RUNTIME / "core", ROOT / "generated" / "yoon2023")


def target(name: str, *sources: str) -> Target:
    """A target with files of the runtime's CANopen, and the drives of the stock machine."""
    own = tuple(CANOPEN / f"{source}.c" for source in sources)
    return Target(name, (*own, FOLDERS[-1] / "tb_drives.c"), FOLDERS)


TARGETS = {
    "sdo": target("sdo", "sdo"),
    "pdo": target(
        "pdo", "pdo", "cia402", "nmt", "drive_link", "setup", "sdo", "emcy", "drive_kind"
    ),
    "setup": target("setup", "setup", "sdo", "nmt", "cia402"),
    "echo": target("echo", "echo"),
    "emcy": target("emcy", "emcy", "drive_kind", "sdo"),
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
        "frame->length != TB_STATUS_LENGTH",
        "frame->length < TB_STATUS_LENGTH",
    ),
    "pdo: a fault reset that nobody asked for": (
        "pdo",
        "cia402",
        "return QUICK_STOP;",
        "return reset_fault(power, previous);",
    ),
    "sdo: a late answer taken for a second drive": (
        "sdo",
        "sdo",
        "        client->owed--;",
        "        client->owed = 0;",
    ),
    "pdo: positions of the whole count": (
        "pdo",
        "drive_link",
        "(uint32_t)count - (uint32_t)less",
        "(uint32_t)count - (uint32_t)(less * 0)",
    ),
    "pdo: setpoints that do not count from the origin": (
        "pdo",
        "drive_link",
        "(uint32_t)count + (uint32_t)more",
        "(uint32_t)(count * 0) + (uint32_t)more",
    ),
    "setup: bytes beyond an object that nobody looks at": (
        "setup",
        "setup",
        "is_padding ? object->size : count",
        "object->size",
    ),
    "setup: anything beyond an object is padding": (
        "setup",
        "setup",
        "return (*detail == wanted)",
        "return ((*detail & 0xFFu) == (wanted & 0xFFu))",
    ),
    "setup: requests repeated without end": (
        "setup",
        "setup",
        "    setup->repeats++;\n",
        "",
    ),
    "echo: a frame that comes back twice": (
        "echo",
        "echo",
        "        sent->returned = 1;\n",
        "",
    ),
    "emcy: a warning that covers a fault": (
        "emcy",
        "emcy",
        "said.error_class > emergency->error_class",
        "said.error_class != emergency->error_class",
    ),
}


@pytest.mark.parametrize("name", TARGETS)
def test_any_bytes_from_a_drive_are_taken(name: str, tmp_path: Path) -> None:
    assert TARGETS[name].build(tmp_path).finding(SECONDS) is None


@pytest.mark.parametrize("defect", DEFECTS)
def test_a_seeded_defect_is_found(defect: str, tmp_path: Path) -> None:
    name, source, old, new = DEFECTS[defect]
    seeded = TARGETS[name].with_defect(CANOPEN / f"{source}.c", old, new, tmp_path)
    assert seeded.build(tmp_path).finding(inputs=ENOUGH) is not None
