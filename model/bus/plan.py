"""The bus proof: what is on every bus, when it has arrived at the latest, when a cycle does what.

Two bounds that need each other. Response times hold whatever frames coincide, every emergency and
SDO included: no frame is overtaken by its successor, so none is lost. The phases of a cycle hold
while in each phase at most one frame comes that is not of the cycle (heartbeat, SDO, emergency),
and in the cycle all those of other nodes; an answer that is later than its phase counts as missed
once, and is bridged.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from turnbuckle.model.bus.frames import ROUNDING, Pace, cyclic, messages, of_other_nodes
from turnbuckle.model.bus.response import Message, recovery_bits, response_time, utilisation
from turnbuckle.model.bus.tables import Drive, OtherNode, Supervision
from turnbuckle.model.machine import Machine


@dataclass(frozen=True)
class Load:
    """A bus with its drives; bit_rate [bit/s]; divider: control cycles from SYNC to SYNC."""

    name: str
    bit_rate: float
    divider: int
    drives: tuple[Drive, ...]
    nodes: tuple[OtherNode, ...] = ()


@dataclass(frozen=True)
class Row:
    """A message and the most it takes from its turn until it has arrived [s]; inf: no bound."""

    message: Message
    length: float
    period: float
    deadline: float
    response: float

    @property
    def in_time(self) -> bool:
        """Whether it arrives within its deadline."""
        return self.response <= self.deadline


@dataclass(frozen=True)
class Phases:
    """When the parts of a bus's cycle are over at the latest [s], counted from SYNC's turn.

    compute: when the master begins to compute, in every control cycle; commands: counted from the
    SYNC that asked for the answers before; room: until the next SYNC.
    """

    sync: float
    answers: float
    compute: float
    computed: float
    commands: float
    room: float


@dataclass(frozen=True)
class BusPlan:
    """All that is known of a bus; cyclic_load, load: shares of its time; recovery [s]."""

    load: Load
    rows: tuple[Row, ...]
    cyclic_share: float
    share: float
    recovery: float
    phases: Phases

    @property
    def late(self) -> list[Row]:
        """Messages that may be late."""
        return [row for row in self.rows if not row.in_time]

    @property
    def fits(self) -> bool:
        """Whether every frame is in time, and the cycle is over before the next begins."""
        return not self.late and self.phases.room >= 0


@dataclass(frozen=True)
class Timing:
    """What all buses have in common; cycle: the control cycle [s]."""

    cycle: float
    limits: Supervision

    def pace(self, load: Load) -> Pace:
        """How often frames come on a bus."""
        return Pace(
            bit_rate=load.bit_rate,
            sync=self.cycle * load.divider,
            cycle=self.cycle,
            heartbeat=self.limits.heartbeat,
            drive_heartbeat=self.limits.drive_heartbeat,
            sdo_timeout=self.limits.answer_timeout,
            delay=self.limits.answer_delay,
        )


def loads(machine: Machine) -> list[Load]:
    """The buses of a machine with their drives."""
    return [
        Load(
            bus.name,
            bus.bit_rate,
            round(machine.control.rate / bus.rate),
            tuple(drive for drive in machine.drives if drive.bus == bus.name),
            tuple(node for node in machine.nodes if node.bus == bus.name),
        )
        for bus in machine.buses
    ]


def timing(machine: Machine) -> Timing:
    """The machine's cycle and limits."""
    return Timing(1 / machine.control.rate, machine.supervision)


def bus_plans(machine: Machine) -> list[BusPlan]:
    """The proof for every bus of a machine."""
    return plans(loads(machine), timing(machine))


def plans(buses: Sequence[Load], common: Timing) -> list[BusPlan]:
    """The proof for buses that one control cycle serves."""
    phase = compute_phase(buses, common)
    return [_plan(load, common, phase) for load in buses]


def compute_phase(buses: Sequence[Load], common: Timing) -> float:
    """When in every control cycle the answers are there that are due in it, in whole us [s].

    A bus whose SYNC comes every few cycles has until the last of these for its answers.
    """
    latest = [answers_end(load, common) - (load.divider - 1) * common.cycle for load in buses]
    return math.ceil(max([0.0, *latest]) * 1e6 - ROUNDING) * 1e-6


def answers_end(load: Load, common: Timing) -> float:
    """From SYNC's turn until every drive has answered, one foreign frame in between [s]."""
    return _sync_end(load, common) + common.limits.answer_delay + _time(load, common, "answer")


def _sync_end(load: Load, common: Timing) -> float:
    return _foreign(load, common) + _others(load, common) + _time(load, common, "SYNC")


def _foreign(load: Load, common: Timing) -> float:
    """The longest frame that may be on the wire when another one's turn comes [s]."""
    found = messages(load.drives, common.pace(load), load.nodes)
    return max(message.bits for message in found) / load.bit_rate


def _others(load: Load, common: Timing) -> float:
    """Time on the wire of the frames of other nodes from SYNC to SYNC, at most [s]."""
    pace = common.pace(load)
    found = of_other_nodes(load.nodes, pace)
    bits = sum(message.bits * math.ceil(pace.bits(pace.sync) / message.period) for message in found)
    return bits / load.bit_rate


def _time(load: Load, common: Timing, kind: str) -> float:
    """Time on the wire of all frames of a kind in one cycle [s]."""
    found = cyclic(load.drives, common.pace(load))
    return sum(message.bits for message in found if message.name.endswith(kind)) / load.bit_rate


def _plan(load: Load, common: Timing, phase: float) -> BusPlan:
    pace = common.pace(load)
    found = messages(load.drives, pace, load.nodes)
    bit = 1 / load.bit_rate
    return BusPlan(
        load,
        tuple(_row(message, found, bit) for message in found),
        utilisation(cyclic(load.drives, pace)),
        utilisation(found),
        recovery_bits(found) * bit,
        _phases(load, common, phase),
    )


def _row(message: Message, found: Sequence[Message], bit: float) -> Row:
    response = response_time(message, found)
    return Row(
        message,
        message.bits * bit,
        message.period * bit,
        message.deadline * bit,
        math.inf if response is None else response * bit,
    )


def _phases(load: Load, common: Timing, phase: float) -> Phases:
    """Commands leave in the control cycle of their SYNC, answers of a slow bus still under way."""
    answers = answers_end(load, common)
    computed = phase + common.limits.compute_time
    begin = max(computed + _others(load, common), answers)
    commands = begin + _foreign(load, common) + _time(load, common, "command")
    room = load.divider * common.cycle - commands
    return Phases(_sync_end(load, common), answers, phase, computed, commands, room)
