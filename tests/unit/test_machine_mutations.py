"""Whatever is done to a machine file, it is read or refused in words: nothing else ever happens."""

import json
import tomllib
from collections.abc import Iterator
from copy import deepcopy
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, event, given, settings
from hypothesis import strategies as st

from turnbuckle.model.problem import MachineError
from turnbuckle.model.reading import load_machine

STOCK = Path(__file__).parents[2] / "machines" / "yoon2023.toml"
CONTENT = STOCK.read_bytes()
TABLES = tomllib.loads(CONTENT.decode())
Place = tuple[str | int, ...]


def places(value: Any, here: Place = ()) -> Iterator[Place]:
    """Every key and array entry of the file."""
    keys: Any = ()
    if isinstance(value, dict | list):
        keys = value if isinstance(value, dict) else range(len(value))
    for key in keys:
        yield (*here, key)
        yield from places(value[key], (*here, key))


def toml(value: Any) -> str:
    """The value as inline TOML."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{toml(k)} = {toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)  # a JSON string is a TOML string
    return str(value).lower()


TEXTS = st.text(st.characters(codec="utf-8", exclude_characters="\x7f"), max_size=12)
PLACES = list(places(TABLES))
WORDS = ["3 N", "0 mm", "-1 m", "nan N", "1e400 Hz", "scale", "if", "cable_1"]
NUMBERS = st.integers() | st.floats()
VALUES = st.recursive(
    st.sampled_from(WORDS) | TEXTS | NUMBERS | st.booleans(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(TEXTS, inner, max_size=2),
    max_leaves=5,
)


def at(tables: Any, place: Place) -> Any:
    for key in place:
        tables = tables[key]
    return tables


@st.composite
def mutations(draw: st.DrawFn) -> dict[str, Any]:
    """The stock file with one to three of its places deleted, renamed, replaced or exchanged."""
    tables = deepcopy(TABLES)
    for _ in range(draw(st.integers(1, 3))):
        place = draw(st.sampled_from(list(places(tables)) or PLACES[:1]))
        if not tables:
            break
        parent, key = at(tables, place[:-1]), place[-1]
        match draw(st.sampled_from(["delete", "rename", "replace", "exchange"])):
            case "delete":
                del parent[key]
            case "rename" if isinstance(parent, dict):
                parent[draw(TEXTS)] = parent.pop(key)
            case "exchange":
                parent[key] = deepcopy(at(TABLES, draw(st.sampled_from(PLACES))))
            case _:
                parent[key] = draw(VALUES)
    return tables


def is_read_or_refused_in_words(path: Path, content: bytes) -> None:
    path.write_bytes(content)
    try:
        load_machine(path)
    except MachineError as error:
        message = str(error)
        assert message.startswith(f"{path}: ")
        assert ": found " in message
        assert "; allowed: " in message
        assert len(message.splitlines()) == 1
        event("refused")
    else:
        event("read")


IN_ONE_FOLDER = settings(
    max_examples=400, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)


@IN_ONE_FOLDER
@given(tables=mutations())
def test_a_mutated_file_is_read_or_refused_in_words(tmp_path: Path, tables: dict[str, Any]) -> None:
    text = "\n".join(f"{toml(key)} = {toml(value)}" for key, value in tables.items())
    assert tomllib.loads(text).keys() == tables.keys()
    is_read_or_refused_in_words(tmp_path / "mutated.toml", text.encode())


@IN_ONE_FOLDER
@given(start=st.integers(0, len(CONTENT)), length=st.integers(0, 30), new=st.binary(max_size=8))
def test_a_file_with_other_bytes_is_read_or_refused_in_words(
    tmp_path: Path, start: int, length: int, new: bytes
) -> None:
    content = CONTENT[:start] + new + CONTENT[start + length :]
    is_read_or_refused_in_words(tmp_path / "damaged.toml", content)


def test_the_stock_file_survives_being_written_out_again(tmp_path: Path) -> None:
    path = tmp_path / "again.toml"
    path.write_text("\n".join(f"{key} = {toml(value)}" for key, value in TABLES.items()))
    assert load_machine(path).model_dump() == load_machine(STOCK).model_dump()
