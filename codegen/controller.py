"""The compiled controller step (runtime/core) in Python, for tests and the virtual bench."""

import ctypes
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from turnbuckle.codegen.bind import Generated, pointer
from turnbuckle.codegen.compile import compile_library
from turnbuckle.codegen.struct_layout import layouts_in
from turnbuckle.places import RUNTIME

Reals = NDArray[np.floating[Any]]

UNCOMPENSATED = 1
"""TB_OPTION_UNCOMPENSATED: estimate the disturbance, do not compensate it."""

SHIM = Path(__file__).parent / "controller_shim.c"
RUNTIME_CORE = RUNTIME / "core"
#: The part of the runtime that is the controller step; the rest is for machines with buses.
STEP = ("controller.c", "torque_gate.c")


INPUTS = ("lengths", "rails", "force", "hand_force", "options")


class Outputs(NamedTuple):
    """What one cycle gives: arrays (n) of cables, (m) of rails, (d) of degrees of freedom."""

    pose: Reals  # m
    velocity: Reals  # m/s
    residual: Reals  # m, ()
    wanted_force: Reals  # N
    delivered_force: Reals  # N
    tension: Reals  # N
    disturbance: Reals  # N m
    motor_torque: Reals  # N m
    rail_target: Reals  # m
    rail_force: Reals  # N
    rail_torque: Reals  # N m
    gate: NDArray[np.uint32]  # flags of the torque gate
    status: NDArray[np.int32]  # tb_status, ()


class Controller:
    """The controller of one machine, with its memory: tb_controller, by the names of its members.

    Raises LayoutError where the C has not the members that are read or written here.
    """

    def __init__(self, generated: Generated, core: Path = RUNTIME_CORE) -> None:
        """Compile and load the runtime's core, kept in `core`, around a machine's generated C."""
        folder = generated.folder
        sources = [*sorted(folder.glob("*.c")), *(core / name for name in STEP), SHIM]
        library = compile_library(sources, [folder, core], generated.precision)
        self._library = ctypes.CDLL(str(library))
        self._library.shim_run.restype = None
        self._rails = len(generated.machine.rails)
        layouts = layouts_in(self._library, "shim_layout")
        self.inputs_layout = layouts.struct("inputs", *INPUTS)
        self.outputs_layout = layouts.struct("outputs", *Outputs._fields)
        self.memory = np.zeros(1, layouts.struct("controller", "torque", "base"))

    def start(self, lengths: ArrayLike, rails: ArrayLike) -> int:
        """tb_controller_start with measured lengths [m] (n), rails [m] (m); returns tb_status."""
        inputs = self.recording(1)
        inputs["lengths"], inputs["rails"][:, : self._rails] = lengths, rails
        measured = pointer(inputs["lengths"]), pointer(inputs["rails"])
        return int(self._library.tb_controller_start(pointer(self.memory), *measured))

    def take_over(self, torque: ArrayLike, base: ArrayLike) -> None:
        """tb_controller_take_over with torques [N m] (n) and the memory of what moved the bases."""
        reals = self.memory["torque"].dtype
        given = [np.ascontiguousarray(each, reals) for each in (torque, base)]
        self._library.tb_controller_take_over(pointer(self.memory), *map(pointer, given))

    def step(
        self,
        lengths: ArrayLike,
        rails: ArrayLike,
        force: ArrayLike,
        hand_force: ArrayLike,
        options: int = 0,
    ) -> Outputs:
        """One cycle: lengths [m] (n), rails [m] (m), force and hand_force [N] (d)."""
        inputs = self.recording(1)
        inputs["lengths"], inputs["rails"][:, : self._rails] = lengths, rails
        inputs["force"], inputs["hand_force"], inputs["options"] = force, hand_force, options
        outputs, _ = self.run_recorded(inputs)
        return Outputs(*(column[0] for column in outputs))

    def recording(self, cycles: int) -> NDArray[np.void]:
        """Room for the inputs of so many cycles, to be filled and given to run_recorded."""
        return np.zeros(cycles, self.inputs_layout)

    def run_recorded(self, inputs: NDArray[np.void]) -> tuple[Outputs, NDArray[np.int64]]:
        """Run the recorded cycles in one C call.

        Returns outputs with a leading axis of cycles, and the nanoseconds each cycle took.
        """
        if inputs.dtype != self.inputs_layout:
            raise ValueError(f"a recording has the layout {self.inputs_layout}, not {inputs.dtype}")
        inputs = np.ascontiguousarray(inputs)
        outputs = np.zeros(len(inputs), self.outputs_layout)
        nanoseconds = np.zeros(len(inputs), np.int64)
        self._library.shim_run(
            pointer(self.memory),
            ctypes.c_size_t(len(inputs)),
            pointer(inputs),
            pointer(outputs),
            pointer(nanoseconds),
        )
        return Outputs(*(self._column(outputs, name) for name in Outputs._fields)), nanoseconds

    def _column(self, outputs: NDArray[np.void], name: str) -> NDArray[Any]:
        """One output of all cycles; the slot of a machine without rails is left out."""
        column: NDArray[Any] = outputs[name]
        return column[:, : self._rails] if name.startswith("rail_") else column
