"""Time on a classic CAN bus: how long a frame is, and when drives are ready to send.

Lengths are those of ISO 11898-1 with 11 bits of identifier: start of frame, arbitration, control,
data and CRC are stuffed, a complement after every five equal bits; what follows them is not.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from random import Random

from turnbuckle.lab.drives.node import Frame
from turnbuckle.model.bus.frames import HEARTBEAT, RPDO, SDO_ANSWER, SYNC, TPDO
from turnbuckle.model.bus.response import ERROR_BITS, frame_bits
from turnbuckle.model.machine import Machine

FUNCTION = 0x780
"""Bits of an identifier that tell what a frame is; the rest is the node."""
HEADER_BITS, CRC_BITS = 19, 15
TAIL_BITS = 13
"""CRC delimiter, acknowledgement, end of frame, and the pause behind it."""
CRC_POLYNOMIAL = 0x4599
STUFF = 5
"""Equal bits after which a complement is put in."""
SDO_DELAY = 1e-3
"""Most that a simulated drive takes to answer a request [s]."""


@dataclass(frozen=True)
class Conditions:
    """What the wire of a machine is like.

    worst: every frame is as long as stuff bits can make it, every answer is ready as late as the
    bus proof allows, and a foreign frame is on the wire whenever a phase of the cycle begins in
    which no other one is. errors: share of the frames that are destroyed, and sent again.
    """

    seed: int = 1
    worst: bool = False
    errors: float = 0.0


#: By the names that a user may give them.
WIRES = {
    "ordinary": Conditions(),
    "worst": Conditions(worst=True),
    "disturbed": Conditions(seed=7, errors=0.002),
}


@dataclass(frozen=True)
class Wire:
    """The wire of one bus; bit_rate [bit/s]; answer_delay: most from SYNC until a drive's answer is
    ready [s]; period: between two control cycles [s]."""

    bit_rate: float
    answer_delay: float
    period: float
    conditions: Conditions

    def duration(self, frame: Frame, chance: Random) -> float:
        """Time that a frame takes [s], with its repetition if it is destroyed."""
        conditions = self.conditions
        bits = frame_bits(len(frame.data)) if conditions.worst else exact_bits(frame)
        if conditions.errors and chance.random() < conditions.errors:
            bits += ERROR_BITS + bits
        return bits / self.bit_rate

    def delay(self, frame: Frame, chance: Random) -> float:
        """Time from what a drive answers, or from its timer's cycle, until its frame is ready [s].

        A timer may run out anywhere in a cycle.
        """
        function = frame.cob & FUNCTION
        share = 1.0 if self.conditions.worst and function == TPDO else chance.random()
        if function == HEARTBEAT:
            return share * self.period
        return share * (SDO_DELAY if function == SDO_ANSWER else self.answer_delay)

    @property
    def foreign(self) -> float:
        """Time of the longest frame [s]."""
        return frame_bits(8) / self.bit_rate


def wires(machine: Machine, conditions: Conditions) -> list[Wire]:
    """The wires of a machine's buses."""
    period, delay = 1.0 / machine.control.rate, machine.supervision.answer_delay
    return [Wire(bus.bit_rate, delay, period, conditions) for bus in machine.buses]


def phase_of(frame: Frame) -> int | None:
    """The phase of the cycle that a master's frame belongs to; None for one outside the cycle."""
    function = frame.cob & FUNCTION
    if frame.cob == SYNC:
        return SYNC
    return RPDO if function == RPDO else None


def is_cyclic(frame: Frame) -> bool:
    """Whether a frame comes in every cycle of its bus."""
    return frame.cob == SYNC or frame.cob & FUNCTION in (TPDO, RPDO)


# -- length of a frame ----------------------------------------------------------------------------


def exact_bits(frame: Frame) -> int:
    """Bits of a frame on the wire, its stuff bits counted, with the pause behind it."""
    crc, state, stuffed = _header(frame.cob, len(frame.data))
    for byte in frame.data:
        crc = (crc << 8 & 0x7FFF) ^ _CRC_TABLE[crc >> 7 ^ byte]
        state, more = _STUFF_TABLE[state][byte]
        stuffed += more
    state, more = _SEVEN_BITS[state][crc >> 8]
    stuffed += more + _STUFF_TABLE[state][crc & 0xFF][1]
    return HEADER_BITS + 8 * len(frame.data) + CRC_BITS + TAIL_BITS + stuffed


def _bits(value: int, count: int) -> list[int]:
    return [value >> place & 1 for place in reversed(range(count))]


def _stuff(state: int, bits: Sequence[int]) -> tuple[int, int]:
    """State after some bits, and stuff bits among them.

    A state is twice the number of equal bits at the end, 0 at the beginning, plus that bit.
    """
    run, last = state >> 1, state & 1
    stuffed = 0
    for bit in bits:
        run = run + 1 if run and bit == last else 1
        last = bit
        if run == STUFF:
            run, last = 1, 1 - bit
            stuffed += 1
    return run << 1 | last, stuffed


def _crc(crc: int, bits: Sequence[int]) -> int:
    for bit in bits:
        feedback = bit ^ crc >> 14 & 1
        crc = crc << 1 & 0x7FFF ^ (CRC_POLYNOMIAL if feedback else 0)
    return crc


@cache
def _header(cob: int, length: int) -> tuple[int, int, int]:
    """CRC, stuffing state and stuff bits after the data length code."""
    bits = _bits(cob << 7 | length, HEADER_BITS)
    return _crc(0, bits), *_stuff(0, bits)


_CRC_TABLE = [_crc(0, _bits(byte, 8)) for byte in range(256)]
_STUFF_TABLE = [[_stuff(state, _bits(byte, 8)) for byte in range(256)] for state in range(10)]
_SEVEN_BITS = [[_stuff(state, _bits(value, 7)) for value in range(128)] for state in range(10)]
