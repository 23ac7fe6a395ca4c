"""The flight recorder, recording the supervisor before ideal drives."""

import ctypes
from collections.abc import Callable
from functools import cache
from pathlib import Path

from supervised import CORE, SHIM, STOCK, Machine, Observation, Orders

from turnbuckle.codegen.compile import LIBRARIES, compile_library
from turnbuckle.lab.flight.replay import supervisor_sources
from turnbuckle.model.files import write_whole

SEGMENTS, SEGMENT_CYCLES = 40, 256
"""TB_RECORDER_SEGMENTS and TB_SEGMENT_CYCLES of runtime/core/recorder.h."""

READ_OUT = """
#include <string.h>
#include "recorder.h"
size_t shim_recorder_size(void);
size_t shim_read_out(const tb_recorder *recorder, unsigned char *out);
size_t shim_reader_size(void);
size_t shim_follow(tb_recorder_reader *reader, uint32_t opened, uint32_t count,
                   unsigned char *out);
size_t shim_recorder_size(void)
{
    return sizeof(tb_recorder);
}
size_t shim_reader_size(void)
{
    return sizeof(tb_recorder_reader);
}
size_t shim_follow(tb_recorder_reader *reader, uint32_t opened, uint32_t count,
                   unsigned char *out)
{
    tb_recorder_mark const mark = {opened, count};
    size_t pieces = 0;
    for (tb_recorder_piece piece = tb_recorder_read(reader, mark); piece.size > 0;
         piece = tb_recorder_read(reader, mark)) {
        memcpy(&out[piece.at], piece.bytes, piece.size);
        pieces++;
    }
    return pieces;
}
size_t shim_read_out(const tb_recorder *recorder, unsigned char *out)
{
    size_t size = 0;
    tb_recorder_reader reader;
    tb_recorder_open(&reader, recorder);
    for (;;) {
        tb_recorder_piece piece = tb_recorder_read(&reader, tb_recorder_now(recorder));
        int const ended = piece.size == 0;
        if (ended) {
            piece = tb_recorder_close(&reader);
        }
        memcpy(&out[piece.at], piece.bytes, piece.size);
        size = (piece.at + piece.size > size) ? piece.at + piece.size : size;
        if (ended) {
            return size;
        }
    }
}
"""


@cache
def library_file() -> Path:
    """The stock machine's supervisor and recorder, with what it takes to run cycles again."""
    folder = LIBRARIES.parent / "flown"
    write_whole(folder / "shim.c", SHIM)
    write_whole(folder / "read_out.c", READ_OUT)
    shims = [folder / "shim.c", folder / "read_out.c"]
    return compile_library([*supervisor_sources(STOCK), *shims], [STOCK, CORE])


@cache
def library() -> ctypes.CDLL:
    """The same, loaded."""
    loaded = ctypes.CDLL(str(library_file()))
    for name in (
        "shim_recorder_size",
        "shim_read_out",
        "shim_reader_size",
        "shim_follow",
        "tb_recording_size",
    ):
        getattr(loaded, name).restype = ctypes.c_size_t
    return loaded


class Flight:
    """A machine whose every cycle is recorded."""

    def __init__(self) -> None:
        """Power-on."""
        self.machine = Machine(library())
        self.size = library().shim_recorder_size()
        self.recorder = ctypes.create_string_buffer(self.size)
        library().tb_recorder_start(self.recorder, self.machine.memory)
        step = self.machine.step

        def recorded(spoil: Callable[[Observation], None] | None = None) -> Orders:
            orders = step(spoil)
            pointers = map(ctypes.byref, (self.machine.seen, orders))
            library().tb_recorder_keep(self.recorder, *pointers, self.machine.memory)
            return orders

        self.machine.step = recorded  # type: ignore[method-assign]

    def read_out(self) -> bytes:
        """The recording as the port would write it."""
        out = ctypes.create_string_buffer(self.size + 65536)
        size = library().shim_read_out(self.recorder, out)
        return out.raw[:size]

    def mark(self) -> tuple[int, int]:
        """Segments opened since the start, and cycles in the newest: tb_recorder_now."""
        now = library().tb_recorder_now
        now.restype = Mark
        found = now(self.recorder)
        return found.opened, found.count


class Mark(ctypes.Structure):
    """tb_recorder_mark"""

    _fields_ = (("opened", ctypes.c_uint32), ("count", ctypes.c_uint32))


class Follower:
    """A file to which a recorder's pieces go as they come."""

    def __init__(self, flight: Flight) -> None:
        """Nothing is read yet."""
        self._flight = flight
        self._reader = ctypes.create_string_buffer(library().shim_reader_size())
        self._out = ctypes.create_string_buffer(flight.size + 65536)
        library().tb_recorder_open(self._reader, flight.recorder)

    def follow(self, mark: tuple[int, int]) -> int:
        """Write what was kept up to a mark; how many pieces."""
        pieces: int = library().shim_follow(self._reader, *mark, self._out)
        return pieces

    @property
    def content(self) -> bytes:
        """The file, with all the room that a recording takes."""
        return self._out.raw
