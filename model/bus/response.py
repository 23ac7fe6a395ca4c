"""Worst-case response times on a CAN bus, by the revised analysis of Davis et al. 2007.

Davis, Burns, Bril, Lukkien: Controller Area Network (CAN) schedulability analysis: refuted,
revisited and revised. Real-Time Systems 35. The analysis of 1994 looks at the first frame of a busy
period only, and can be too optimistic; this one looks at all.

All times are whole bit times. Classic CAN, 11 bits of identifier.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

OVERHEAD_BITS = 55
BITS_OF_A_BYTE = 10
# An error flag with its echo, delimiter and the gap that follows (Tindell and Burns 1994).
ERROR_BITS = 31
# A busy period beyond this is taken to have no end.
LONGEST_BUSY = 100_000_000


def frame_bits(size: int) -> int:
    """Longest that a frame of `size` bytes is, with every stuff bit: 55 + 10 size."""
    return OVERHEAD_BITS + BITS_OF_A_BYTE * size


@dataclass(frozen=True)
class Message:
    """Frames of one identifier; size [bytes], the rest in bit times.

    period: least between two; jitter: how much later than its turn a frame may be ready; deadline:
    from its turn until it must have arrived.
    """

    name: str
    identifier: int
    size: int
    period: int
    deadline: int
    jitter: int = 0

    @property
    def bits(self) -> int:
        """Longest that a frame is."""
        return frame_bits(self.size)


def utilisation(messages: Sequence[Message]) -> float:
    """Share of the bus's time that the messages take at most."""
    return sum(message.bits / message.period for message in messages)


def recovery_bits(messages: Sequence[Message]) -> int:
    """What one transmission error adds to a response time, at most."""
    return ERROR_BITS + max(message.bits for message in messages)


def response_time(message: Message, messages: Sequence[Message]) -> int | None:
    """From a frame's turn until it has arrived, at most; None where there is no bound."""
    above = [other for other in messages if other.identifier < message.identifier]
    below = [other for other in messages if other.identifier > message.identifier]
    blocking = max((other.bits for other in below), default=0)
    busy = _busy_period(message, above, blocking)
    if busy is None:
        return None
    count = _ceil(busy + message.jitter, message.period)
    return max(_response(message, above, blocking, number) for number in range(count))


def _busy_period(message: Message, above: Sequence[Message], blocking: int) -> int | None:
    """How long the bus is busy with frames that are not below this one, at most."""
    level = [*above, message]
    if utilisation(level) >= 1:
        return None
    busy = message.bits
    while busy < LONGEST_BUSY:
        longer = blocking + sum(_ceil(busy + m.jitter, m.period) * m.bits for m in level)
        if longer == busy:
            return busy
        busy = longer
    return None


def _response(message: Message, above: Sequence[Message], blocking: int, number: int) -> int:
    """Response of frame `number` of a busy period; a frame on the wire is not interrupted."""
    waited = start = blocking + number * message.bits
    while True:
        longer = start + sum(_ceil(waited + m.jitter + 1, m.period) * m.bits for m in above)
        if longer == waited:
            return message.jitter + waited - number * message.period + message.bits
        waited = longer


def _ceil(time: int, period: int) -> int:
    return -(-time // period)
