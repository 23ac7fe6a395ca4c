"""Layouts of C structs and values of enumerations, as the C itself describes them.

runtime/core/layout.h says what a description is. Members are read by their names: where they are is
known to the C alone.
"""

import ctypes
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import takewhile
from typing import Any

import numpy as np
from numpy.typing import NDArray

from turnbuckle.model.refusal import Refusal

Layout = np.dtype[np.void]
ROW: Layout = np.dtype(
    [
        ("name", "S28"),
        ("type", "S20"),
        *((name, np.uint32) for name in ("kind", "at", "size", "count")),
    ]
)
"""tb_layout_row"""

STRUCT, PART, REAL, UNSIGNED, SIGNED, TEXT, ENUMERATION, VALUE = (ord(c) for c in "spfuiSev")
"""TB_LAYOUT_IS_..."""
NUMBERS = {
    **{(REAL, size): f"f{size}" for size in (4, 8)},
    **{(UNSIGNED, size): f"u{size}" for size in (1, 2, 4, 8)},
    **{(SIGNED, size): f"i{size}" for size in (4, 8)},
}


class LayoutError(Refusal):
    """A description contradicts itself, or has not what is to be read."""


@dataclass(frozen=True)
class Layouts:
    """A description."""

    structs: Mapping[str, Layout]
    """By the name of the C struct, without tb_."""
    enumerations: Mapping[str, Mapping[str, int]]
    """Values by name, without what the names of the enumeration begin with: SOFT_STOP."""

    def struct(self, name: str, *members: str) -> Layout:
        """The layout of tb_<name>; LayoutError where one of the members is not in it."""
        if name not in self.structs:
            raise LayoutError(f"tb_{name} is not described")
        layout = self.structs[name]
        for member in members:
            if member not in (layout.names or ()):
                raise LayoutError(f"tb_{name} has no member {member}")
        return layout

    def number(self, enumeration: str, name: str) -> int:
        """The value of a name; LayoutError where there is none."""
        found = self.enumerations.get(enumeration, {})
        if name not in found:
            raise LayoutError(f"tb_{enumeration} has no value {name}")
        return found[name]

    def name(self, enumeration: str, number: int) -> str:
        """The name of a value, as SOFT_STOP; the number itself where there is none."""
        return self._names.get(enumeration, {}).get(int(number), str(number))

    def word(self, enumeration: str, number: int) -> str:
        """The same for people: soft stop."""
        return self.name(enumeration, number).replace("_", " ").lower()

    @property
    def version(self) -> str:
        """Version of the runtime, as 0.2.0; empty where it is not described."""
        values = self.enumerations.get("version", {})
        number = values.get("RUNTIME_VERSION")
        if number is None:
            return ""
        return f"{number // 10000}.{number // 100 % 100}.{number % 100}"

    @cached_property
    def _names(self) -> dict[str, dict[int, str]]:
        return {
            enumeration: {value: name for name, value in values.items()}
            for enumeration, values in self.enumerations.items()
        }


def read_layouts(rows: NDArray[np.void]) -> Layouts:
    """Read a description, an array of ROW; LayoutError where it contradicts itself."""
    structs: dict[str, Layout] = {}
    enumerations: dict[str, dict[str, int]] = {}
    for head, members in blocks(rows):
        name = text(head["name"])
        if head["kind"] == STRUCT:
            structs[name] = struct_of(head, members, structs)
        elif head["kind"] == ENUMERATION:
            enumerations[name] = values_of(members)
        else:
            raise LayoutError(f"a description begins with {name!r}, which is no struct")
    return Layouts(structs, enumerations)


def blocks(rows: NDArray[np.void]) -> Iterator[tuple[np.void, NDArray[np.void]]]:
    """Every struct or enumeration with the rows that follow it."""
    begins = [i for i, row in enumerate(rows) if row["kind"] in (STRUCT, ENUMERATION)]
    if len(rows) and begins[:1] != [0]:
        begins.insert(0, 0)
    for begin, end in zip(begins, [*begins[1:], len(rows)], strict=True):
        yield rows[begin], rows[begin + 1 : end]


def struct_of(head: np.void, members: NDArray[np.void], known: Mapping[str, Layout]) -> Layout:
    """The layout of a struct."""
    if not head["size"]:
        raise LayoutError(f"tb_{text(head['name'])} is described as nothing")
    fields = {
        "names": [text(member["name"]) for member in members],
        "formats": [format_of(member, known) for member in members],
        "offsets": [int(member["at"]) for member in members],
        "itemsize": int(head["size"]),
    }
    try:
        return np.dtype(fields)  # type: ignore[call-overload, no-any-return]
    except (ValueError, OverflowError) as error:
        raise LayoutError(f"tb_{text(head['name'])} is described wrongly: {error}") from None


def format_of(member: np.void, known: Mapping[str, Layout]) -> Any:
    """What a member is, as NumPy takes it."""
    kind, size, count = (int(member[name]) for name in ("kind", "size", "count"))
    entry: Any = NUMBERS.get((kind, size))
    if kind == TEXT and size:
        entry = f"S{size}"
    elif kind == PART:
        entry = known.get(text(member["type"]))
    if entry is None or np.dtype(entry).itemsize != size:
        raise LayoutError(f"member {text(member['name'])!r} is described wrongly")
    return (entry, (count,)) if count else entry


def values_of(rows: NDArray[np.void]) -> dict[str, int]:
    """The values of an enumeration, without what all their names begin with."""
    names = [text(row["name"]).split("_") for row in rows]
    alike = takewhile(lambda words: len(set(words)) == 1, zip(*names, strict=False))
    shared = sum(1 for _ in alike) if len(names) > 1 else 0
    parts = ["_".join(words[shared:]) for words in names]
    return dict(zip(parts, (int(row["at"]) for row in rows), strict=True))


def text(content: bytes) -> str:
    """A text of a row."""
    return content.decode("ascii", errors="backslashreplace")


def layouts_in(library: ctypes.CDLL, name: str) -> Layouts:
    """The description in the array `name` of a compiled library, with <name>_rows rows."""
    count = ctypes.c_uint32.in_dll(library, f"{name}_rows").value
    content = (ctypes.c_char * (count * ROW.itemsize)).in_dll(library, name)
    return read_layouts(np.frombuffer(bytes(content), ROW))
