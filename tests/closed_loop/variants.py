"""Machine files made from a stock machine: other cables, without rails, walls or observer."""

import json
import tomllib
from pathlib import Path
from typing import Any

from turnbuckle.codegen.bind import Generated
from turnbuckle.model.reading import load_machine

ROOT = Path(__file__).parents[2]
STOCK = ROOT / "machines" / "yoon2023.toml"

CORNERS = [("0 mm", "0 mm"), ("711.8 mm", "0 mm"), ("711.8 mm", "461.8 mm"), ("0 mm", "461.8 mm")]
TRIANGLE = [("0 mm", "0 mm"), ("711.8 mm", "0 mm"), ("355.9 mm", "461.8 mm")]


def committed(precision: str = "double") -> Generated:
    """The generated C of the stock machine, as it is committed."""
    return Generated(load_machine(STOCK), ROOT / "generated" / "yoon2023", precision)


def stock() -> dict[str, Any]:
    """The stock machine's tables."""
    return tomllib.loads(STOCK.read_text())


def fixed(name: str, bases: list[tuple[str, str]]) -> dict[str, Any]:
    """Fixed bases, no walls, no observer, no buses."""
    left_out = {"rail_drive", "wall", "disturbance_observer", "bus", "drive"}
    tables = {key: value for key, value in stock().items() if key not in left_out}
    tables["machine"] |= {"name": name}
    return tables | {"cable": [{"base": list(base)} for base in bases]}


def unmeasured(name: str) -> dict[str, Any]:
    """The stock machine without a force sensor in the handle."""
    tables = stock()
    tables["machine"] |= {"name": name}
    tables["disturbance_observer"] |= {"hand_force": "unmeasured"}
    return tables


def write(tables: dict[str, Any], folder: Path) -> Path:
    """Write a machine file and return where it is."""
    path = folder / f"{tables['machine']['name']}.toml"
    path.write_text("".join(f"{key} = {_value(value)}\n" for key, value in tables.items()))
    return path


def _value(value: Any) -> str:
    """A TOML value; tables inline."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {_value(entry)}" for key, entry in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(_value(entry) for entry in value) + "]"
    return json.dumps(value)
