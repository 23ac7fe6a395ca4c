"""The compiled runtime and a simulated machine, cycle by cycle, in simulated time.

A cycle is that of the control loop: SYNC at its begin; a compute phase later the master reads what
has arrived by then, and its setpoints leave a compute time after that. Frames take their time on
the wire. Nothing depends on a clock: two runs give the same frames. A Lockstep can be copied at any
cycle by os.fork().
"""

import ctypes
from collections.abc import Callable, Sequence
from enum import IntEnum, IntFlag
from pathlib import Path
from struct import Struct

import numpy as np

from turnbuckle.codegen.bind import Generated, pointer
from turnbuckle.codegen.compile import compile_library
from turnbuckle.codegen.struct_layout import LayoutError, Layouts, layouts_in
from turnbuckle.lab.drives.node import Frame
from turnbuckle.lab.machine_sim import SimulatedMachine
from turnbuckle.model.base import Coordinates
from turnbuckle.model.bus.plan import compute_phase, loads, timing
from turnbuckle.places import RUNTIME

SHIM = Path(__file__).parent / "lockstep_shim.c"
FOLDERS = tuple(RUNTIME / name for name in ("core", "canopen"))
CAN = RUNTIME / "can"
PORTABLE_CAN = (CAN / "can.c", CAN / "loopback.c")
FRAME = Struct("<BBH8s")
ROOM = 256
"""Frames that one step of the master can send at most."""

Arrival = Callable[[Sequence[bytes]], None]
Tap = Callable[[int, Frame], None]
"""Takes the number of a bus and a frame."""


class State(IntEnum):
    """tb_state."""

    INIT = 0
    IDENTIFY = 1
    CONFIGURE = 2
    HOME = 3
    TENSION = 4
    RUN = 5
    SOFT_STOP = 6
    HARD_STOP = 7
    FAULT = 8


class Request(IntFlag):
    """TB_REQUEST_..."""

    ARM = 1
    STOP = 2
    RESET = 4


class BusState(IntEnum):
    """tb_can_state."""

    ERROR_ACTIVE = 0
    ERROR_WARNING = 1
    ERROR_PASSIVE = 2
    BUS_OFF = 3
    NOT_OPEN = 4


class Lockstep:
    """The master of a machine, and the machine.

    cycle() runs one cycle; `view` is what is to be seen of the last one: state, phase, cause,
    culprit, index, subindex, failure, detail, beat, status, pose, residual, wanted_force,
    delivered_force, tension, zeros, position, ordered, led, power. SI units, numbers as in the C
    headers.
    """

    def __init__(self, generated: Generated, machine: SimulatedMachine) -> None:
        """Compile and load the runtime around a machine's generated C."""
        self.machine = machine
        self.cycles = 0
        self.requests = Request(0)
        """What is asked of the supervisor; stands until it is changed."""
        self.force: Coordinates | None = None
        """Force [N] that the application wants; without one the task's."""
        self.hand_force: Coordinates | None = None
        """What the force sensor says [N]; without one the truth."""
        self.hand_force_fresh = True
        self.taps: list[Tap] = []
        """Told of every frame the master sends, before anything can happen to it."""
        self.arrivals: list[Arrival] = []
        """Told of the packed frames that reach the master's ports, twice a cycle: when it reads the
        answers, and at the end."""
        self.lost = 0
        """Frames of the drives that the master's ports did not take."""
        self.missed = 0
        """Cycles that are told to have been skipped; counts once."""
        common = timing(generated.machine)
        self._compute_phase = compute_phase(loads(generated.machine), common)
        self._library = load(generated)
        layouts = layouts_of(self._library)
        self._ready, self._sweep = (layouts.number("phase", name) for name in ("READY", "SWEEP"))
        self._memory = ctypes.create_string_buffer(self._library.shim_machine_size())
        self._wishes = np.zeros(1, layouts.struct("wishes"))
        self._view = np.zeros(1, layouts.struct("view"))
        self._sent = ctypes.create_string_buffer(ROOM * FRAME.size)
        self._library.shim_start(self._memory)

    @property
    def view(self) -> np.void:
        """The last cycle."""
        self._library.shim_look(self._memory, pointer(self._view))
        seen: np.void = self._view[0]
        return seen

    @property
    def wishes(self) -> np.void:
        """What the application wished in the last cycle: tb_wishes."""
        wished: np.void = self._wishes[0]
        return wished

    @property
    def state(self) -> State:
        """State of the supervisor."""
        return State(int(self.view["state"]))

    def cycle(self) -> None:
        """Run one cycle."""
        began = self.machine.time
        self._hand_over(self._library.shim_sync(self._memory, self._sent, ROOM), 0.0)
        self.machine.run_until(began + self._compute_phase)
        self._return_answers()
        self._wish()
        missed, self.missed = self.missed, 0
        wishes = pointer(self._wishes)
        count = self._library.shim_run(self._memory, wishes, missed, self._sent, ROOM)
        self._hand_over(count, self.machine.compute_time)
        self.machine.advance()
        self._return_answers()
        self.cycles += 1

    def stand_still(self) -> None:
        """Let a cycle pass in which the master does nothing; what is sent to it waits."""
        self.machine.advance()
        self._return_answers()

    def run(self, cycles: int) -> None:
        """Run so many cycles."""
        for _ in range(cycles):
            self.cycle()

    def run_until(self, states: Sequence[State], most: int) -> State:
        """Run until one of the states is reached, `most` cycles at most; the state at the end."""
        for _ in range(most):
            self.cycle()
            if self.state in states:
                break
        return self.state

    def bring_up(self, most: int) -> State:
        """Arm the machine once it is ready, and run until it works, `most` cycles at most; the
        state at the end. The hand moves the handle about where no base moves."""
        for _ in range(most):
            if self.view["phase"] == self._sweep:
                self.machine.wander()
            self.requests = Request.ARM if self._is_ready and self.cycles % 2 else Request(0)
            self.cycle()
            if self.state in (State.RUN, State.FAULT):
                break
        return self.state

    @property
    def _is_ready(self) -> bool:
        return self.state is State.CONFIGURE and self.view["phase"] == self._ready

    def exchange_runtime(self, library: ctypes.CDLL) -> None:
        """Go on with another build of the runtime, whose memory has the same layout."""
        self._library = library
        library.shim_adopt(self._memory)

    def set_bus(self, bus: int, state: BusState, full: bool = False) -> None:
        """Fault: bring a bus into a state; full: it takes no frames (ENOBUFS)."""
        self._library.shim_set_bus(self._memory, bus, int(state), int(full))

    def _wish(self) -> None:
        wishes, machine = self._wishes[0], self.machine
        wishes["force"] = machine.task_force if self.force is None else self.force
        known = self.hand_force is None
        wishes["hand_force"] = machine.world.hand_force if known else self.hand_force
        wishes["hand_force_fresh"] = self.hand_force_fresh
        wishes["requests"] = int(self.requests)

    def _hand_over(self, count: int, after: float) -> None:
        """Give what the master sent to its controllers, so long [s] from now."""
        buses = self.machine.buses
        sent = memoryview(self._sent)[: count * FRAME.size]
        for bus, length, identifier, data in FRAME.iter_unpack(sent):
            frame = Frame(identifier, data[:length])
            for tap in self.taps:
                tap(bus, frame)
            buses[bus].send(frame, after)

    def _return_answers(self) -> None:
        packed = [
            FRAME.pack(number, len(data), cob, data)
            for number, bus in enumerate(self.machine.buses)
            for cob, data in bus.take()
        ]
        for arrival in self.arrivals:
            arrival(packed)
        if packed:
            taken = self._library.shim_give(self._memory, b"".join(packed), len(packed))
            self.lost += len(packed) - taken


def load(generated: Generated, folders: Sequence[Path] = FOLDERS) -> ctypes.CDLL:
    """The runtime of a machine with its buses in memory; folders: of its core and canopen."""
    sources = [path for folder in folders for path in sorted(folder.glob("*.c"))]
    sources += [*sorted(generated.folder.glob("*.c")), *PORTABLE_CAN, SHIM]
    include = [generated.folder, *folders, CAN]
    library = ctypes.CDLL(str(compile_library(sources, include, generated.precision)))
    for name in ("machine_size", "sync", "run", "give"):
        getattr(library, f"shim_{name}").restype = ctypes.c_size_t
    for name, arguments in ARGUMENTS.items():
        getattr(library, name).argtypes = arguments
    return library


def layouts_of(library: ctypes.CDLL) -> Layouts:
    """What lockstep_shim.c describes: tb_wishes, tb_view and the enumerations.

    Raises LayoutError where an enumeration of this module is not that of the C.
    """
    layouts = layouts_in(library, "shim_layout")
    for name, enumeration in {"state": State, "can_state": BusState, "request": Request}.items():
        if layouts.enumerations[name] != {each.name: each.value for each in enumeration}:
            raise LayoutError(f"tb_{name} has other values in the C than {enumeration.__name__}")
    return layouts


_POINTER, _SIZE, _WORD = ctypes.c_void_p, ctypes.c_size_t, ctypes.c_uint32
ARGUMENTS = {
    "shim_sync": [_POINTER, _POINTER, _SIZE],
    "shim_run": [_POINTER, _POINTER, _WORD, _POINTER, _SIZE],
    "shim_give": [_POINTER, ctypes.c_char_p, _SIZE],
    "shim_look": [_POINTER, _POINTER],
    "shim_adopt": [_POINTER],
    "shim_set_bus": [_POINTER, _SIZE, _WORD, _WORD],
}
