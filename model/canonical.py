"""What of a machine file counts: its numbers and words, however they are written."""

import hashlib
import json
from typing import Any

from turnbuckle.model.machine import Machine

#: Tables of a machine file that say nothing about a machine without buses.
BUS_TABLES: dict[str, Any] = {
    "buses": True,
    "drives": True,
    "nodes": True,
    "supervision": True,
    "calibration": True,
    "cable_motor": {"rating"},
    "rail_drive": {"rating", "homing"},
}


def canonical(machine: Machine) -> str:
    """The machine's numbers as text; comments and spelling of units do not count.

    Without buses the tables about them say nothing about the C, and do not count either; nor does a
    list of other nodes that is empty.
    """
    without_nodes: dict[str, Any] = {} if machine.nodes else {"nodes": True}
    left_out = without_nodes if machine.buses else BUS_TABLES
    content = machine.model_dump(mode="json", by_alias=True, exclude=left_out)
    return json.dumps(content, sort_keys=True)


def content_hash(machine: Machine) -> str:
    """The same for files that describe the same machine; 16 digits."""
    return hashlib.sha256(canonical(machine).encode()).hexdigest()[:16]
