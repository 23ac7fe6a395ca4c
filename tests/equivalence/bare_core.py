"""Parts of runtime/core compiled for any machine, a bus or none: limits come from a stand-in."""

import ctypes
import hashlib
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from unmeasured import geometry, machine_named

from turnbuckle.codegen.bind import REALS, pointer
from turnbuckle.codegen.compile import LIBRARIES, compile_library
from turnbuckle.model.files import write_whole
from turnbuckle.model.machine import Machine

ROOT = Path(__file__).parents[2]
CORE = ROOT / "runtime" / "core"
SAMPLES = 24
CLOSURE = 0.002
"""Limit of the residual [m]."""

#: What these parts take from tb_drives.h, for machines that have no drives in their file.
LIMITS = f"""
#ifndef TB_DRIVES_H
#define TB_DRIVES_H
#include "tb_types.h"
#define TB_CALIBRATION_SAMPLES {SAMPLES}
#define TB_CLOSURE_LIMIT TB_C({CLOSURE})
#define TB_CLOSURE_CYCLES 5
#define TB_CABLE_SPEED_LIMIT TB_C(5.0)
#define TB_RAIL_LAG_LIMIT TB_C(0.05)
#define TB_RAIL_LAG_CYCLES 200
#endif
"""


class Kinematics(NamedTuple):
    """The C of a machine, of which only the kinematics are compiled here."""

    machine: Machine
    folder: Path
    precision: str


class Part:
    """A compiled part of the core with the memory that it works on."""

    def __init__(
        self, generated: Kinematics, sources: dict[str, str], memory: np.dtype[np.void]
    ) -> None:
        """Compile C files, each a name and a text, together with the machine's kinematics."""
        texts = sources | {"tb_drives.h": LIMITS}
        digest = hashlib.sha256(repr(texts).encode()).hexdigest()[:16]
        folder = LIBRARIES.parent / "core" / digest
        for name, text in texts.items():
            write_whole(folder / name, text)
        files = [as_it_is(folder / name) for name in sources]
        files.append(generated.folder / "tb_kinematics.c")
        library = compile_library(files, [folder, generated.folder, CORE], generated.precision)
        self.library = ctypes.CDLL(str(library))
        self.memory: NDArray[np.void] = np.zeros(1, memory)

    def call(self, name: str, *arrays: NDArray[np.generic]) -> int:
        """A function of the part: its memory first, then the arrays."""
        function = getattr(self.library, name)
        return int(function(pointer(self.memory), *map(pointer, arrays)))


@cache
def kinematics_of(name: str, precision: str) -> Kinematics:
    """The kinematics of a machine: as committed, or made for the tests."""
    folder = ROOT / "generated" / name
    if not folder.exists():
        folder = geometry(name).folder
    return Kinematics(machine_named(name), folder, precision)


def source(name: str) -> str:
    """A C file of runtime/core."""
    return (CORE / name).read_text()


def as_it_is(copy: Path) -> Path:
    """The file of runtime/core that a copy is of, if nothing is changed in the copy."""
    original = CORE / copy.name
    same = original.exists() and original.read_text() == copy.read_text()
    return original if same else copy


def slots(generated: Kinematics) -> int:
    """TB_RAIL_SLOTS."""
    return max(1, len(generated.machine.rails))


def in_slots(generated: Kinematics, rails: NDArray[np.float64]) -> NDArray[np.floating]:
    """Rail coordinates (..., m) in the slots that the C has for them."""
    filled = np.zeros((*rails.shape[:-1], slots(generated)), REALS[generated.precision])
    filled[..., : rails.shape[-1]] = rails
    return filled
