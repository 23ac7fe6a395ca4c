"""A machine file as its user wrote it, and the machines it describes with other quantities in it.

Everything here happens on the TOML: what a key means is the schema's business. A location is the
way to a value, such as ("cable", 1, "base", 0) for `cable[2].base[1]`.
"""

from __future__ import annotations

import copy
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import tomlkit
from tomlkit.container import OutOfOrderTableProxy
from tomlkit.items import AoT, Item, Table

from turnbuckle.model.machine import Machine
from turnbuckle.model.problem import key_path
from turnbuckle.model.reading import load_machine, machine_from
from turnbuckle.model.units import QuantityError, Written, unit, written

Location = tuple[str | int, ...]
Changes = Mapping[Location, str]
"""New text for the quantity at each location."""

#: Tables that mean something with buses only.
OF_BUSES = frozenset({"bus", "drive", "supervision", "calibration"})


@dataclass(frozen=True)
class Document:
    """A machine file that describes a machine."""

    path: Path
    text: str
    tables: dict[str, Any]

    @classmethod
    def read(cls, path: Path) -> Document:
        """Read a machine file; MachineError where load_machine raises it."""
        path = load_machine(path).path
        text = path.read_bytes().decode("utf-8-sig")
        return cls(path, text, tomllib.loads(text))

    def values(self) -> dict[str, tuple[Location, Any]]:
        """Every table, array and value by its key, as error messages print keys."""
        return {key_path(location): (location, value) for location, value in _walk((), self.tables)}

    def quantity(self, location: Location) -> Written:
        """The quantity at a location of the file."""
        written = as_written(_at(self.tables, location))
        assert written is not None  # the schema has seen to it
        return written

    def words(self, location: Location) -> str:
        """What the file says at a location."""
        return str(_at(self.tables, location))

    def machine(self, changes: Changes) -> Machine:
        """The machine with these changes; MachineError where they make none."""
        return machine_from(self._changed(changes), self.path)

    def candidate(self, changes: Changes) -> Machine:
        """The same less its buses, because a search tries motors that no drive could feed."""
        tables = self._changed(changes)
        return machine_from({k: v for k, v in tables.items() if k not in OF_BUSES}, self.path)

    def _changed(self, changes: Changes) -> dict[str, Any]:
        tables = copy.deepcopy(self.tables)
        _apply(tables, changes)
        return tables

    def text_with(self, changes: Changes) -> str:
        """The file with these changes, its comments and layout as they are."""
        document = tomlkit.parse(self.text)
        for location, text in changes.items():
            line = _line(document, location)
            before = _at(document, line).as_string()
            _apply(document, {location: text})
            _align_comment(_at(document, line), before)
        return tomlkit.dumps(document)


def as_written(value: object) -> Written | None:
    """A value of the file as a quantity; None where it is none."""
    try:
        quantity = written(value) if isinstance(value, str) else None
        return quantity if quantity and unit(quantity.unit) else None
    except QuantityError:
        return None


def _walk(location: Location, value: Any) -> Iterator[tuple[Location, Any]]:
    """A value and all that it holds, with their locations."""
    if location:
        yield location, value
    parts: Iterable[str | int] = ()
    if isinstance(value, dict):
        parts = value
    elif isinstance(value, list):
        parts = range(len(value))
    for part in parts:
        yield from _walk((*location, part), value[part])


def _at(tables: Any, location: Location) -> Any:
    for part in location:
        tables = tables[part]
    return tables


def _line(document: tomlkit.TOMLDocument, location: Location) -> Location:
    """The location of the whole value that holds a quantity: what one line says after its =."""
    item: Any = document
    for end, part in enumerate(location, start=1):
        item = item[part]
        if not isinstance(item, Table | AoT | OutOfOrderTableProxy):
            return location[:end]
    raise KeyError(location)


def _align_comment(item: Item, before: str) -> None:
    """Keep the comment behind a value in its column; `before` is what stood there."""
    longer = len(item.as_string()) - len(before)
    space = item.trivia.comment_ws
    if item.trivia.comment and not space.strip(" "):
        item.trivia.comment_ws = " " * max(1, len(space) - longer)


def _apply(tables: Any, changes: Changes) -> None:
    for location, text in changes.items():
        _at(tables, location[:-1])[location[-1]] = text
