"""The compiled part of the model: counts instructions and answers what is polled; see pace.c."""

import ctypes
from collections.abc import Callable
from ctypes import POINTER, c_size_t, c_uint8, c_uint32, c_uint64, c_void_p
from functools import cache, partial
from pathlib import Path
from typing import Any

from unicorn import UC_HOOK_BLOCK, UC_HOOK_CODE, UC_HOOK_MEM_READ, UC_HOOK_MEM_WRITE
from unicorn.unicorn_py3 import unicorn as binding

from turnbuckle.codegen.compile import compile_library

SOURCE = Path(__file__).with_name("pace.c")
COUNTERS = 16

Ask = Callable[[int, int], int]
Tell = Callable[[int, int, int], None]
ASK = ctypes.CFUNCTYPE(c_uint64, c_uint64, c_uint32)
TELL = ctypes.CFUNCTYPE(None, c_uint64, c_uint32, c_uint64)

#: Kinds of words in a window: asked of the model, known until forgotten, a counter.
ASKED, KNOWN, FIRST_COUNTER = 0, 1, 2
#: Reasons why an instruction was refused.
NO_COPROCESSOR, UNALIGNED, DIVISION, DENIED = 1, 2, 3, 4


class Counter(ctypes.Structure):
    """pace_counter."""

    _fields_ = tuple(
        (name, c_uint64)
        for name in ("since", "origin", "numerator", "denominator", "period", "top")
    )


class State(ctypes.Structure):
    """pace."""

    _fields_ = (
        ("count", c_uint64),
        ("limit", c_uint64),
        ("place", c_uint64),
        ("wrong", c_uint64),
        ("reason", c_uint64),
        ("floating", c_uint64),
        ("dividing", c_uint64),
        ("aligning", c_uint64),
        ("address", c_uint64),
        ("feeding", c_uint64),
        ("food", c_uint64),
        ("fed", c_uint64),
        ("guards", c_uint64),
        ("denied", c_uint64 * 2 * 8),
        ("read_register", c_void_p),
        ("stop", c_void_p),
        ("fetch", c_void_p),
        ("ask", c_void_p),
        ("tell", c_void_p),
        ("counters", Counter * COUNTERS),
    )


class _Window(ctypes.Structure):
    """pace_window."""

    _fields_ = (
        ("pace", POINTER(State)),
        ("base", c_uint64),
        ("kinds", c_void_p),
        ("values", c_void_p),
    )


class Window:
    """A range of addresses whose accesses come to the model."""

    def __init__(self, state: State, base: int, size: int) -> None:
        self.base, self.size = base, size
        self.kinds = (c_uint8 * (size // 4))()
        self.values = (c_uint32 * (size // 4))()
        places = ctypes.addressof(self.kinds), ctypes.addressof(self.values)
        self.c = _Window(ctypes.pointer(state), base, *places)

    def forgetting(self, address: int, size: int) -> Callable[[], object]:
        """What lets all words of a range be asked of the model again."""
        first = ctypes.addressof(self.kinds) + (address - self.base) // 4
        return partial(ctypes.memset, first, ASKED, size // 4)


def _pointer(function: Any) -> c_void_p:
    return ctypes.cast(function, c_void_p)


@cache
def _library() -> ctypes.CDLL:
    library = ctypes.CDLL(str(compile_library([SOURCE], [])))
    library.pace_counted.restype = c_uint64
    return library


class Pace:
    """Counts the instructions of one emulator and stands between it and the peripherals."""

    def __init__(self, emulator: Any, ask: Ask, tell: Tell) -> None:
        """`ask(address, size)` and `tell(address, size, value)` must not raise."""
        self.state = State()
        self.windows: list[Window] = []
        self._emulator = emulator
        self._calls = ASK(ask), TELL(tell)
        self._unicorn = ctypes.CDLL(binding.uclib._name)
        self.state.stop = _pointer(self._unicorn.uc_emu_stop).value
        self.state.read_register = _pointer(self._unicorn.uc_reg_read).value
        self.state.fetch = _pointer(self._unicorn.uc_mem_read).value
        self.state.ask, self.state.tell = (_pointer(call).value for call in self._calls)
        self._hook(UC_HOOK_CODE, _library().pace_instruction, 1, 0)
        self._hook(UC_HOOK_BLOCK, _library().pace_block, 1, 0)

    def watch_memory(self, begin: int, end: int) -> None:
        """Refuse unaligned accesses of several words, and denied ones, from here on."""
        self._hook(UC_HOOK_MEM_READ | UC_HOOK_MEM_WRITE, _library().pace_memory, begin, end)

    def open_window(self, base: int, size: int) -> Window:
        """Accesses to these addresses come to the model."""
        window = Window(self.state, base, size)
        self.windows.append(window)
        user = ctypes.byref(window.c)
        read, write = _pointer(_library().pace_read), _pointer(_library().pace_write)
        place = c_uint64(base), c_size_t(size)
        self._done(self._unicorn.uc_mmio_map(self._emulator._uch, *place, read, user, write, user))
        return window

    def deny(self, ranges: list[tuple[int, int]]) -> None:
        """No data is read or written from the begin to before the end of these, eight at most."""
        self.state.guards = len(ranges)
        for number, (begin, end) in enumerate(ranges):
            self.state.denied[number][0], self.state.denied[number][1] = begin, end

    def counted(self, number: int) -> int:
        """What a counter shows now."""
        value: int = _library().pace_counted(ctypes.byref(self.state), number)
        return value

    def _hook(self, kind: int, function: Any, begin: int, end: int) -> None:
        handle = c_size_t()
        arguments = ctypes.c_int(kind), _pointer(function), ctypes.byref(self.state)
        limits = c_uint64(begin), c_uint64(end)
        added = self._unicorn.uc_hook_add(
            self._emulator._uch, ctypes.byref(handle), *arguments, *limits
        )
        self._done(added)

    @staticmethod
    def _done(error: int) -> None:
        if error:
            raise RuntimeError(f"Unicorn refuses a hook or a window: error {error}")
