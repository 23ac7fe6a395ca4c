"""The JSON Schema that editors read says what load_machine accepts."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from turnbuckle.model.kind import KINDS
from turnbuckle.model.machine import json_schema

SCHEMA_FILE = Path(__file__).parents[2] / "docs" / "machine.schema.json"
SCHEMA = json_schema()
TABLES: dict[str, Any] = {"the file": SCHEMA, **SCHEMA["$defs"]}


def test_the_exported_schema_is_up_to_date() -> None:
    assert json.loads(SCHEMA_FILE.read_text("utf-8")) == SCHEMA, (
        "to export it again: python -m turnbuckle.model.machine > docs/machine.schema.json"
    )


@pytest.mark.parametrize("table", TABLES)
def test_a_table_refuses_unknown_keys_and_explains_its_own(table: str) -> None:
    assert TABLES[table]["additionalProperties"] is False
    for key, entry in TABLES[table]["properties"].items():
        assert entry.get("description"), key


def test_the_keys_of_the_file_are_the_tables_of_the_file() -> None:
    assert {"machine", "frame", "cable", "wall", "target"} <= SCHEMA["properties"].keys()
    assert {"from", "to", "follows", "heading"} == TABLES["RailBase"]["properties"].keys()
    assert {"machine", "frame", "cable", "tension", "drum", "cable_motor", "control", "target"} == (
        set(SCHEMA["required"])
    )


def test_choices_are_listed() -> None:
    assert TABLES["Identity"]["properties"]["kind"]["enum"] == sorted(KINDS)
    choices = TABLES["Tension"]["properties"]["when_infeasible"]["enum"]
    assert choices == ["scale", "closest", "paper"]


@pytest.mark.parametrize(
    ("table", "alternatives"),
    [("Cable", ["base", "rail", "plane"]), ("DisturbanceObserver", ["corner", "minus_3db"])],
)
def test_exactly_one_of_several_keys_is_asked_for(table: str, alternatives: list[str]) -> None:
    assert TABLES[table]["oneOf"] == [{"required": [key]} for key in alternatives]


def test_a_quantity_is_text_of_a_number_and_a_unit() -> None:
    radius = TABLES["Drum"]["properties"]["radius"]
    assert radius["type"] == "string"
    assert [bool(re.search(radius["pattern"], t)) for t in ("5 mm", "5", "mm", "-.5e-3m")] == [
        True,
        False,
        False,
        True,
    ]
