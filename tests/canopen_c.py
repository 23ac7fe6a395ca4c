"""The runtime's CANopen in Python, for tests: its functions, its structs, and frames."""

import ctypes
import os
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple
from unittest import mock

from c_structs import Declarations, declarations

from turnbuckle.codegen.compile import compile_library

ROOT = Path(__file__).parents[1]
MACHINE = ROOT / "generated" / "yoon2023"
RUNTIME = Path(os.environ.get("TURNBUCKLE_RUNTIME", ROOT / "runtime"))
"""The C under test; a test that seeds a defect has a copy of its own."""
FOLDERS = [MACHINE, RUNTIME / "core", RUNTIME / "can", RUNTIME / "canopen"]
SOURCES = [
    MACHINE / "tb_drives.c",
    RUNTIME / "can" / "can.c",
    RUNTIME / "can" / "loopback.c",
    *sorted((RUNTIME / "canopen").glob("*.c")),
]


class Frame(NamedTuple):
    """A classic CAN frame."""

    id: int
    data: bytes


class Canopen:
    """The compiled library; an attribute is a C function, a struct or an enumerator."""

    def __init__(
        self,
        sources: Sequence[Path] = SOURCES,
        precision: str = "double",
        folders: Sequence[Path] = (),
    ) -> None:
        """folders: searched for headers before those of the stock machine."""
        compiler = f"{os.environ.get('CC') or 'gcc'} -g"
        with mock.patch.dict(os.environ, CC=compiler):
            path = compile_library(sources, [*folders, *FOLDERS], precision)
        self._library = ctypes.CDLL(str(path))
        self._declared: Declarations = declarations(path)

    def __getattr__(self, name: str) -> Any:
        for named in (self._declared.constants, self._declared.types):
            if name in named:
                return named[name]
        function = getattr(self._library, name)
        function.restype = self._declared.results[name]
        return function

    def new(self, name: str) -> Any:
        """A struct, all zero."""
        return self._declared.types[name]()

    def constants(self, prefix: str) -> dict[str, int]:
        """All enumerators whose names begin alike."""
        named = self._declared.constants.items()
        return {name: value for name, value in named if name.startswith(prefix)}

    def variable(self, name: str) -> Any:
        """A variable of the library."""
        return self._declared.variables[name].in_dll(self._library, name)

    def frame(self, frame: Frame) -> Any:
        """A frame for C."""
        made = self.new("tb_can_frame")
        made.id, made.length = frame.id, len(frame.data)
        made.data[: len(frame.data)] = frame.data
        return made

    def text(self, name: str, *arguments: Any) -> str:
        """What a function that names a code says."""
        return ctypes.string_at(getattr(self, name)(*arguments)).decode()


def read(frame: Any) -> Frame:
    """A frame of C."""
    return Frame(frame.id, bytes(frame.data[: frame.length]))


@cache
def canopen_c() -> Canopen:
    """The network of drives and what is below it, compiled and loaded once."""
    return Canopen()
