"""Structs, constants and functions of a compiled C library for ctypes, from its debug information.

What C declares is declared nowhere a second time, so that no test believes in a layout of old.
"""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from elftools.dwarf.die import DIE
from elftools.elf.elffile import ELFFile

NUMBERS: dict[tuple[int, int], Any] = {
    (0x02, 1): ctypes.c_bool,
    (0x04, 4): ctypes.c_float,
    (0x04, 8): ctypes.c_double,
    (0x05, 1): ctypes.c_int8,
    (0x05, 2): ctypes.c_int16,
    (0x05, 4): ctypes.c_int32,
    (0x05, 8): ctypes.c_int64,
    (0x06, 1): ctypes.c_int8,
    (0x07, 2): ctypes.c_uint16,
    (0x07, 4): ctypes.c_uint32,
    (0x07, 8): ctypes.c_uint64,
    (0x08, 1): ctypes.c_uint8,
}
"""(DW_ATE_..., bytes) -> ctypes."""


@dataclass
class Declarations:
    """What a library declares."""

    types: dict[str, Any] = field(default_factory=dict)
    """Typedef or struct name -> ctypes type."""
    constants: dict[str, int] = field(default_factory=dict)
    """Name of an enumerator -> its value."""
    variables: dict[str, Any] = field(default_factory=dict)
    """Name of a variable of file scope -> its ctypes type."""
    results: dict[str, Any] = field(default_factory=dict)
    """Name of a function -> ctypes type of what it returns."""


def declarations(library: Path) -> Declarations:
    """Read the debug information of a shared library that was compiled with -g."""
    found, reader = Declarations(), Reader()
    with library.open("rb") as file:
        for unit in ELFFile(file).get_dwarf_info().iter_CUs():
            for entry in unit.get_top_DIE().iter_children():
                collect(entry, reader, found)
    return found


def collect(entry: DIE, reader: "Reader", found: Declarations) -> None:
    """Add one declaration of file scope."""
    if entry.tag == "DW_TAG_enumeration_type":
        for value in entry.iter_children():
            found.constants[name_of(value)] = number_of(value, "DW_AT_const_value")
    elif entry.tag in ("DW_TAG_typedef", "DW_TAG_structure_type") and name_of(entry):
        found.types.setdefault(name_of(entry), reader.type_of(entry))
    elif entry.tag == "DW_TAG_subprogram":
        found.results[name_of(entry)] = reader.target_of(entry)
    elif entry.tag == "DW_TAG_variable" and name_of(entry):
        found.variables[name_of(entry)] = reader.target_of(entry)


class Reader:
    """Turns debugging entries into ctypes types, each one once."""

    def __init__(self) -> None:
        self._known: dict[int, Any] = {}
        self._readers: dict[str, Callable[[DIE], Any]] = {
            "DW_TAG_base_type": number,
            "DW_TAG_enumeration_type": lambda entry: ctypes.c_uint32,
            "DW_TAG_pointer_type": lambda entry: ctypes.c_void_p,
            "DW_TAG_array_type": self._array,
            "DW_TAG_structure_type": self._struct,
        }

    def type_of(self, entry: DIE) -> Any:
        """The ctypes type of an entry; None for what has no size, as a function or void."""
        if entry.offset not in self._known:
            self._known[entry.offset] = self._read(entry)
        return self._known[entry.offset]

    def _read(self, entry: DIE) -> Any:
        if entry.tag in self._readers:
            return self._readers[entry.tag](entry)
        return self.target_of(entry)  # typedef, const: as what they stand for

    def target_of(self, entry: DIE) -> Any:
        """The type that an entry names: of a variable, of what a function returns."""
        if "DW_AT_type" not in entry.attributes or entry.tag == "DW_TAG_subroutine_type":
            return None
        return self.type_of(entry.get_DIE_from_attribute("DW_AT_type"))

    def _array(self, entry: DIE) -> Any:
        element = self.target_of(entry)
        for bound in reversed(list(entry.iter_children())):
            element = element * length_of(bound)
        return element

    def _struct(self, entry: DIE) -> Any:
        if "DW_AT_declaration" in entry.attributes:
            return None
        made: Any = type(name_of(entry) or "struct", (ctypes.Structure,), {})
        members = [child for child in entry.iter_children() if child.tag == "DW_TAG_member"]
        made._fields_ = [(name_of(member), self.target_of(member)) for member in members]
        size = number_of(entry, "DW_AT_byte_size")
        if ctypes.sizeof(made) != size:
            raise RuntimeError(f"{name_of(entry)}: {ctypes.sizeof(made)} bytes here, {size} in C")
        return made


def length_of(bound: DIE) -> int:
    """Entries of an array; 0 where its declaration does not say."""
    if "DW_AT_upper_bound" not in bound.attributes:
        return 0
    return number_of(bound, "DW_AT_upper_bound") + 1


def number(entry: DIE) -> Any:
    """A type of number."""
    return NUMBERS.get((number_of(entry, "DW_AT_encoding"), number_of(entry, "DW_AT_byte_size")))


def name_of(entry: DIE) -> str:
    """The name of an entry, empty where it has none."""
    name = entry.attributes.get("DW_AT_name")
    return name.value.decode() if name else ""


def number_of(entry: DIE, attribute: str) -> int:
    """A number that an entry has."""
    return int(entry.attributes[attribute].value)
