"""The supervisor compiled and loaded, before ideal drives: they obey, one SYNC late, and err never.

An order of cycle k is taken over at the bus's next SYNC and shows in the answer to the one after.
"""

import ctypes
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from enum import IntEnum
from functools import cache
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from turnbuckle.codegen.compile import compile_library
from turnbuckle.lab.causes import causes
from turnbuckle.model.files import write_whole

ROOT = Path(__file__).parents[1]
CORE = ROOT / "runtime" / "core"
STOCK = ROOT / "generated" / "yoon2023"
BUILD = ROOT / "build" / "supervised"

CABLES, RAILS, DRIVES, BUSES, DOF = 4, 4, 8, 3, 2
PERIOD = 1e-3
DRUM, PINION = 0.005, 0.015
LENGTHS = np.array([0.7118, 0.4618, 0.7118, 0.4618])


def names(header: str, prefix: str) -> type[IntEnum]:
    """An enumeration of a header of the core."""
    text = (CORE / header).read_text()
    start = text.index(f"    {prefix}")
    body = text[start : text.index("}", start)]
    lines = [line.strip() for line in body.splitlines() if line.strip().startswith(prefix)]
    keys = [line.split(",")[0].split("=")[0].split("/*")[0].strip() for line in lines]
    return numbered(prefix.strip("_"), (key.removeprefix(prefix) for key in keys))


def numbered(name: str, members: Iterable[str]) -> type[IntEnum]:
    """An enumeration that counts from 0."""
    values = {member: number for number, member in enumerate(members)}
    return IntEnum(name, values)  # type: ignore[return-value]


State: Any = names("cycle.h", "TB_STATE_")
Phase: Any = names("cycle.h", "TB_PHASE_")
Cause: Any = numbered("CAUSE", (cause.name for cause in causes()))
Power: Any = names("drive.h", "TB_POWER_")
Goal: Any = names("drive.h", "TB_GOAL_")
Mode: Any = names("drive.h", "TB_MODE_")
Homing: Any = names("drive.h", "TB_HOMING_")
Task: Any = names("drive.h", "TB_TASK_")
Failure: Any = names("drive.h", "TB_FAILURE_")
IDLE, BUSY, DONE, FAILED = range(4)
ARM, STOP, RESET = 1, 2, 4
LONGEST = 120_000
"""Cycles from power-on that a machine is run in any test: to wait longer is to fail."""


class Report(ctypes.Structure):
    """tb_drive_report"""

    _fields_ = [
        ("position", ctypes.c_double),
        ("torque", ctypes.c_double),
        ("statusword", ctypes.c_uint16),
        ("error_code", ctypes.c_uint16),
        ("error_class", ctypes.c_uint8),
        ("power", ctypes.c_uint8),
        ("mode", ctypes.c_uint8),
        ("homing", ctypes.c_uint8),
        ("fresh", ctypes.c_uint8),
        ("age", ctypes.c_uint8),
        ("missed", ctypes.c_uint8),
        ("late", ctypes.c_uint8),
        ("silent", ctypes.c_uint8),
        ("task", ctypes.c_uint8),
        ("progress", ctypes.c_uint8),
        ("failure", ctypes.c_uint8),
        ("subindex", ctypes.c_uint8),
        ("index", ctypes.c_uint16),
        ("detail", ctypes.c_uint32),
    ]


class Order(ctypes.Structure):
    """tb_drive_order"""

    _fields_ = [
        ("torque", ctypes.c_double),
        ("position", ctypes.c_double),
        ("goal", ctypes.c_uint8),
        ("mode", ctypes.c_uint8),
        ("task", ctypes.c_uint8),
        ("home", ctypes.c_uint8),
    ]


class Bus(ctypes.Structure):
    """tb_bus_report"""

    _fields_ = [(name, ctypes.c_uint8) for name in ("state", "refused", "stranger", "malformed")]


Fields = list[tuple[str, Any]]


def observation_fields(drives: int, buses: int) -> Fields:
    """Of tb_observation."""
    return [
        ("drives", Report * drives),
        ("buses", Bus * buses),
        ("force", ctypes.c_double * DOF),
        ("hand_force", ctypes.c_double * DOF),
        ("hand_force_fresh", ctypes.c_uint32),
        ("requests", ctypes.c_uint32),
        ("missed", ctypes.c_uint32),
    ]


def outputs_fields(slots: int) -> Fields:
    """Of tb_outputs."""
    rails, cables, freedoms = (ctypes.c_double * count for count in (slots, CABLES, DOF))
    return [
        ("pose", freedoms),
        ("velocity", freedoms),
        ("residual", ctypes.c_double),
        ("wanted_force", freedoms),
        ("delivered_force", freedoms),
        ("tension", cables),
        ("disturbance", cables),
        ("motor_torque", cables),
        ("rail_target", rails),
        ("rail_force", rails),
        ("rail_torque", rails),
        ("gate", ctypes.c_uint32 * CABLES),
        ("status", ctypes.c_int32),
    ]


def orders_fields(drives: int, outputs: type[ctypes.Structure]) -> Fields:
    """Of tb_orders."""
    return [
        ("drives", Order * drives),
        ("controller", outputs),
        ("slack", ctypes.c_double * CABLES),
        ("beat", ctypes.c_uint8),
        ("state", ctypes.c_uint8),
        ("phase", ctypes.c_uint8),
        ("cause", ctypes.c_uint8),
        ("culprit", ctypes.c_uint16),
        ("index", ctypes.c_uint16),
        ("subindex", ctypes.c_uint8),
        ("failure", ctypes.c_uint8),
        ("detail", ctypes.c_uint32),
    ]


class Observation(ctypes.Structure):
    """tb_observation of the stock machine"""

    _fields_ = observation_fields(DRIVES, BUSES)


class Outputs(ctypes.Structure):
    """tb_outputs of the stock machine"""

    _fields_ = outputs_fields(RAILS)


class Orders(ctypes.Structure):
    """tb_orders of the stock machine"""

    _fields_ = orders_fields(DRIVES, Outputs)


#: Tells sizes and places that the tests need.
SHIM = r"""
#include "supervisor_memory.h"
#include "words.h"
size_t shim_size(int what)
{
    static const size_t sizes[] = {sizeof(tb_observation), sizeof(tb_orders), sizeof(tb_supervisor),
        offsetof(tb_supervisor, complement), offsetof(tb_supervisor, drives[1].sent),
        offsetof(tb_supervisor, state), offsetof(tb_supervisor, drives[3].sent)};
    return sizes[what];
}
"""


def machine_folder(name: str, generated: Path, drives: Callable[[str], str]) -> Path:
    """The generated C of a machine; its tb_drives.* the stock machine's, changed by `drives`."""
    folder = BUILD / name
    for path in generated.glob("*.[ch]"):
        write_whole(folder / path.name, path.read_text())
    for path in STOCK.glob("tb_drives.[ch]"):
        write_whole(folder / path.name, drives(path.read_text()))
    return folder


def sources(machine: Path) -> list[Path]:
    """Every C file that the supervisor is made of."""
    return [*sorted(machine.glob("*.c")), *sorted(CORE.glob("*.c"))]


def compiled(machine: Path) -> ctypes.CDLL:
    """The supervisor of a machine."""
    shim = BUILD / "shim.c"
    write_whole(shim, SHIM)
    return ctypes.CDLL(str(compile_library([*sources(machine), shim], [machine, CORE])))


@cache
def stock_library() -> ctypes.CDLL:
    """The stock machine's supervisor."""
    return compiled(STOCK)


@cache
def position_library() -> ctypes.CDLL:
    """The same machine with base drives that follow positions."""

    def follow_position(text: str) -> str:
        return re.sub(r'(\{"base_\d", \d, \d,) 0,', r"\1 1,", text)

    return compiled(machine_folder("position", STOCK, follow_position))


@dataclass
class Drive:
    """An ideal drive."""

    position: float = 0.0
    power: int = Power.OFF
    mode: int = Mode.NONE
    homing: int = Homing.IDLE
    error_code: int = 0
    task: int = Task.NONE
    busy: int = 0
    applied: tuple[float, float, int, int, int, int] = (0.0, 0.0, 0, 0, 0, 0)
    homed: bool = False
    ran: int = 0

    def obey(self) -> None:
        """Go one step towards the ordered power state."""
        goal = self.applied[2]
        if goal == Goal.FAULT_RESET and self.power == Power.FAULT:
            self.power, self.error_code = Power.OFF, 0
        elif goal == Goal.ENABLED:
            path = [Power.OFF, Power.READY, Power.ON, Power.ENABLED]
            if self.power in path[:3]:
                self.power = path[path.index(self.power) + 1]
        elif self.power != Power.FAULT:
            self.power = Power.OFF


@dataclass
class Machine:
    """The stock machine with ideal drives, its handle held where `handle` says."""

    observation: ClassVar[type[Observation]] = Observation
    told: ClassVar[type[Orders]] = Orders

    library: ctypes.CDLL
    handle: tuple[float, float] = (0.39, 0.21)
    cycle: int = 0
    drives: list[Drive] = field(default_factory=lambda: [Drive() for _ in range(DRIVES)])
    rails: list[float] = field(default_factory=lambda: [0.3, 0.2, 0.42, 0.3])
    rates: list[float] = field(default_factory=lambda: [0.0] * RAILS)

    def __post_init__(self) -> None:
        sizes = [self.library.shim_size(what) for what in range(3)]
        self.seen, self.orders = self.observation(), self.told()
        assert sizes[:2] == [ctypes.sizeof(self.seen), ctypes.sizeof(self.orders)]
        self.memory = ctypes.create_string_buffer(b"\xa5" * sizes[2], sizes[2])
        self.library.tb_supervisor_start(self.memory)

    def save(self) -> tuple[Any, ...]:
        """Everything as it is now."""
        drives = [Drive(**vars(drive)) for drive in self.drives]
        state = (self.cycle, drives, [*self.rails], [*self.rates])
        return (*state, self.memory.raw, bytes(self.seen), bytes(self.orders))

    def restore(self, saved: tuple[Any, ...]) -> None:
        """Go back to what was saved."""
        self.cycle, drives, rails, rates, memory, seen, orders = saved
        self.drives = [Drive(**vars(drive)) for drive in drives]
        self.rails, self.rates = [*rails], [*rates]
        self.memory.raw = memory
        ctypes.memmove(ctypes.byref(self.seen), seen, len(seen))
        ctypes.memmove(ctypes.byref(self.orders), orders, len(orders))

    def step(self, spoil: Callable[[Observation], None] | None = None) -> Orders:
        """One cycle: SYNC, answers, supervisor. `spoil` changes what it sees."""
        assert self.cycle < LONGEST, f"still {State(self.orders.state).name} after so many cycles"
        self.move()
        for index in range(len(self.drives)):
            self.answer(index)
        if spoil is not None:
            spoil(self.seen)
        pointers = map(ctypes.byref, (self.seen, self.orders))
        self.library.tb_supervisor_step(self.memory, *pointers)
        for index in range(len(self.drives)):
            self.do_task(index)
        self.cycle += 1
        return self.orders

    def run(
        self,
        cycles: int,
        until: Callable[[Orders], bool] | None = None,
        spoil: Callable[[Observation], None] | None = None,
    ) -> Orders:
        """Some cycles, or as many as it takes until something is so."""
        for _ in range(cycles):
            orders = self.step(spoil)
            if until is not None and until(orders):
                return orders
        assert until is None, f"still {State(orders.state).name} {Phase(orders.phase).name}"
        return self.orders

    def answer(self, index: int) -> None:
        """Answer this cycle's SYNC with the state before it, then take over the last order."""
        drive, report = self.drives[index], self.seen.drives[index]
        synced = index < CABLES or self.cycle % 2 == 0
        report.fresh = synced
        report.task, report.progress = drive.task, DONE if drive.busy == 0 else BUSY
        report.mode = drive.mode
        if not synced:
            return
        report.position, report.power = self.position(index), drive.power
        report.torque = drive.applied[0] if drive.power == Power.ENABLED else 0.0
        report.error_code, report.error_class = drive.error_code, 2 if drive.error_code else 0
        report.homing = drive.homing
        order = self.orders.drives[index]
        drive.applied = (
            order.torque,
            order.position,
            order.goal,
            order.mode,
            order.task,
            order.home,
        )
        drive.obey()

    def position(self, index: int) -> float:
        """What the encoder says."""
        if index < CABLES:
            base = bases(self.rails)[index]
            away = np.hypot(base[0] - self.handle[0], base[1] - self.handle[1])
            return float(0.8 - 0.1 * index - away)
        rail = index - CABLES
        return self.rails[rail] - (0.0 if self.drives[index].homed else 0.1 * (rail + 1))

    def do_task(self, index: int) -> None:
        """Begin the ordered task, or go on with it."""
        drive, order = self.drives[index], self.orders.drives[index]
        if order.task != drive.task:
            drive.task, drive.busy = order.task, 3
        elif drive.busy > 0:
            drive.busy -= 1
            if drive.busy == 0 and drive.task == Task.MODE:
                drive.mode = order.mode

    def move(self) -> None:
        """One period of the bases: 1 kg with a little friction, or wherever they are told to be."""
        for rail in range(len(self.rails)):
            drive = self.drives[CABLES + rail]
            torque, position, _, _, _, home = drive.applied
            if drive.power != Power.ENABLED:
                self.rates[rail] = 0.0
            elif drive.mode == Mode.HOMING:
                self.home(rail, drive, bool(home))
            elif drive.mode == Mode.POSITION:
                self.rails[rail] = position
            else:
                force = torque / PINION - 5.0 * self.rates[rail]
                self.rates[rail] += force * PERIOD
                self.rails[rail] += self.rates[rail] * PERIOD

    def home(self, rail: int, drive: Drive, run: bool) -> None:
        """Run to the stop at 1 m/s, and push against it for a while."""
        if not run:
            drive.ran = 0
            return
        drive.ran += 1
        self.rails[rail] = max(self.rails[rail] - 1e-3, 0.0)
        drive.homing = Homing.RUNNING
        if self.rails[rail] == 0.0 and drive.ran > 10:
            drive.homing, drive.homed = Homing.DONE, True

    def ask(self, request: int) -> Orders:
        """One cycle with a request, which then goes."""
        self.seen.requests = request
        orders = self.step()
        self.seen.requests = 0
        return orders

    def arm(self) -> None:
        """From anything before it to the first cycle of HOME."""
        self.until(State.CONFIGURE, Phase.READY)
        self.run(10)
        self.ask(ARM)

    def until(self, state: int, phase: int | None = None, cycles: int = 10000) -> Orders:
        """Go on until a state or phase begins."""
        return self.run(
            cycles,
            lambda orders: orders.state == state and (phase is None or orders.phase == phase),
        )


def bases(rails: list[float]) -> list[tuple[float, float]]:
    """Where the bases are [m]."""
    return [(rails[0], 0.0), (0.7118, rails[1]), (rails[2], 0.4618), (0.0, rails[3])]


Moments = dict[str, tuple[Any, ...]]
SETTLED = 50
"""Cycles from power-on until every drive is ready to arm, and some more."""


#: Base drives that follow torques, or positions.
LIBRARIES = {"torque": stock_library, "position": position_library}


@cache
def moments(drives: str) -> tuple[Machine, Moments]:
    """A machine, and what it was in an early cycle of every state and phase, in their order."""
    machine = Machine(LIBRARIES[drives]())
    machine.seen.hand_force_fresh = 1
    saved: Moments = {}

    def step() -> None:
        machine.step()
        keep(machine, saved)

    while machine.orders.state != State.RUN:
        step()
        if machine.cycle == SETTLED:
            keep(machine, saved, always=True)
        machine.seen.requests = ARM if machine.cycle > SETTLED else 0
    machine.run(200)
    keep(machine, saved, always=True)
    machine.seen.requests = STOP
    while machine.orders.state != State.CONFIGURE:
        step()
    machine.restore(saved["RUN NONE"])

    def fault(seen: Observation) -> None:
        seen.drives[3].power = Power.FAULT

    while machine.orders.state != State.FAULT:
        machine.step(fault)
        keep(machine, saved)
    return machine, saved


def keep(machine: Machine, saved: Moments, always: bool = False) -> None:
    """Save a moment that is not saved yet."""
    name = f"{State(machine.orders.state).name} {Phase(machine.orders.phase).name}"
    if always or name not in saved:
        saved[name] = machine.save()
