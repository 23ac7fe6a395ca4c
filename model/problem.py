"""How the problems of a machine file are worded: file, key, what was found, what is allowed."""

import difflib
import json
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from inspect import isclass
from pathlib import Path
from typing import Any, get_args

from pydantic import ValidationError
from pydantic_core import ErrorDetails, PydanticCustomError

from turnbuckle.model.refusal import Refusal
from turnbuckle.model.table import Table

Location = Sequence[str | int]

LONGEST_SHOWN = 60
# Python refuses to write out longer integers than some thousand bits.
LONGEST_INTEGER = 1024
BARE_KEY = re.compile(rf"[A-Za-z0-9_-]{{1,{LONGEST_SHOWN}}}")
FOUND_NOTHING = "nothing, it is missing"


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong with a machine file; `key` is "" when it is the file itself."""

    key: str
    found: str
    allowed: str

    def __str__(self) -> str:
        text = f"found {self.found}; allowed: {self.allowed}"
        return f"{self.key}: {text}" if self.key else text


class MachineError(Refusal):
    """A machine file was refused."""

    def __init__(self, path: Path, problems: Sequence[Problem]) -> None:
        more = len(problems) - 1
        listed = "; turnbuckle check lists all" if more > 1 else ""
        tail = f" (and {more} more problem{'s' if more > 1 else ''}{listed})" if more else ""
        super().__init__(f"{path}: {problems[0]}{tail}")
        self.path = path
        self.problems = tuple(problems)


def refusal(allowed: str, found: str = "") -> PydanticCustomError:
    """The error a field's validator raises; `found` defaults to the value as written."""
    return PydanticCustomError("refused", "refused", {"allowed": allowed, "found": found})


def shown(value: object) -> str:
    """A TOML value as the user wrote it, on one line and shortened."""
    text = _in_toml(value)
    return text if len(text) <= LONGEST_SHOWN else text[: LONGEST_SHOWN - 3] + "..."


def _in_toml(value: object) -> str:
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, list):
        return f"[{', '.join(map(_in_toml, value))}]"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=not value.isprintable())
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int) and value.bit_length() > LONGEST_INTEGER:
        return "a huge number"
    return str(value)


def key_path(location: Location) -> str:
    """("cable", 1, "rail", "to") -> `cable[2].rail.to`: entries of an array count from 1."""
    path = ""
    for part in location:
        if isinstance(part, int):
            path += f"[{part + 1}]"
        else:
            path += ("." if path else "") + (part if BARE_KEY.fullmatch(part) else shown(part))
    return path


def location_of(key: str) -> Location:
    """The inverse of key_path for keys of the schema."""
    parts = re.findall(r"([A-Za-z0-9_-]+)|\[([0-9]+)\]", key)
    return [word or int(number) - 1 for word, number in parts]


def problem_at(tables: dict[str, Any], location: Location, allowed: str) -> Problem:
    """A problem whose `found` is what the file says at `location`."""
    value: Any = tables
    for part in location:
        value = value[part]
    return Problem(key_path(location), shown(value), allowed)


def nearest(word: str, known: Iterable[str]) -> str:
    """ "; did you mean ...?" when a known word is close, else ""."""
    close = difflib.get_close_matches(word, list(known), n=1)
    return f"; did you mean {close[0]}?" if close else ""


def schema_problems(error: ValidationError, schema: type[Table]) -> list[Problem]:
    """Word every error of the schema; unknown keys first, as they often explain a missing one."""
    details = error.errors(include_url=False)
    ordered = sorted(details, key=lambda detail: detail["type"] != "extra_forbidden")
    return [_worded(detail, schema) for detail in ordered]


def _worded(detail: ErrorDetails, schema: type[Table]) -> Problem:
    location, context = detail["loc"], detail.get("ctx", {})
    if detail["type"] == "extra_forbidden":
        return _unknown_key(location, schema)
    if detail["type"] == "missing":
        return Problem(key_path(location), FOUND_NOTHING, _meaning(location, schema))
    found = context.get("found") or shown(detail["input"])
    allowed = context.get("allowed") or _allowed_by_type(detail, location, context)
    return Problem(key_path(location), found, allowed)


def _allowed_by_type(detail: ErrorDetails, location: Location, context: dict[str, Any]) -> str:
    if detail["type"] == "literal_error":
        return str(context["expected"]).replace("'", '"')
    if detail["type"] == "model_type":
        return "a table"
    if detail["type"] == "tuple_type":
        return f"an array of tables, each begun by [[{location[-1]}]]"
    if detail["type"] == "string_type":
        return "text in quotes"
    return detail["msg"]


def _unknown_key(location: Location, schema: type[Table]) -> Problem:
    keys = field_names(_table_at(location[:-1], schema))
    word = str(location[-1])
    allowed = f"the keys {', '.join(keys)}{nearest(word, keys)}"
    return Problem(key_path(location), "an unknown key", allowed)


def _meaning(location: Location, schema: type[Table]) -> str:
    table = _table_at(location[:-1], schema)
    field = table.model_fields[field_names(table)[str(location[-1])]]
    examples = [item.allowed for item in field.metadata if hasattr(item, "allowed")]
    return ", ".join(filter(None, [field.description, *examples]))


def field_names(table: type[Table]) -> dict[str, str]:
    """Key in the file -> name of the field."""
    return {field.alias or name: name for name, field in table.model_fields.items()}


def _table_at(location: Location, schema: type[Table]) -> type[Table]:
    for part in location:
        if isinstance(part, str):
            schema = table_in(schema.model_fields[field_names(schema)[part]].annotation) or schema
    return schema


def table_in(annotation: object) -> type[Table] | None:
    """The table that a field holds, or an array of which it holds."""
    if isclass(annotation) and issubclass(annotation, Table):
        return annotation
    return next(filter(None, map(table_in, get_args(annotation))), None)
