"""A CAN bus with a controller of the chip on it: arbitration, time on the wire, and faults."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from heapq import heappop, heappush
from itertools import count
from typing import TYPE_CHECKING

from stm32g474.frame import AFTER_ACKNOWLEDGE, GAP, Frame, bits_of, worst_bits_of

if TYPE_CHECKING:
    from stm32g474.chip import Chip
    from stm32g474.fdcan import Fdcan

#: Bits that an error takes: the flags of all nodes and the delimiter.
ERROR_FRAME = 6 + 6 + 8
#: Bits that a node in the state error passive waits more after its own frame.
SUSPEND = 8
#: Where an error that is injected hits a frame, as a part of its length.
HIT = 0.5
#: Recessive bits after which a controller takes part.
JOIN = 11


@dataclass(frozen=True)
class Sent:
    """A frame that was acknowledged, and when its last bit had passed [ns]."""

    time: int
    frame: Frame


@dataclass
class _Wire:
    """What is on the wire now: by the chip, by others, or by both at once."""

    frame: Frame
    from_chip: bool
    from_others: bool
    starts: int = 0
    ends: int = 0
    entry: tuple[tuple[int, int, int, int], int, Frame] | None = field(default=None)


class Bus:
    """One bus. Other nodes are heard by `deliver` and hear by `taken` or `listeners`."""

    def __init__(self, chip: Chip, number: int, bit_rate: float = 1e6) -> None:
        self.chip, self.number = chip, number
        self.bit_rate = bit_rate
        #: Longest way to the other end and back with both transceivers [ns].
        self.round_trip = 500.0
        #: Frames take their longest time instead of their own.
        self.worst_stuffing = False
        #: Another node is there and acknowledges.
        self.acknowledged = True
        #: The wire is cut next to the chip.
        self.cut = False
        #: Called with each frame of the chip that was acknowledged.
        self.listeners: list[Callable[[Sent], None]] = []
        #: Every frame that was on the bus, by the chip or others, until someone empties it.
        self.log: list[tuple[int, bool, Frame]] = []
        self.node: Fdcan | None = None
        #: Error frames so far.
        self.errors = 0
        self._stuck = False
        self._sent: list[Sent] = []
        self._ready: list[tuple[tuple[int, int, int, int], int, Frame]] = []
        self._order = count()
        self._disturbed = self._lost = 0
        self._wire: _Wire | None = None
        self._free = 0
        self._recessive_since = 0
        self._planned = False

    # -- for tests ----------------------------------------------------------------------------

    def deliver(self, frame: Frame, at: int | None = None) -> None:
        """Another node wants to send a frame, now or at a time [ns]."""

        def ready() -> None:
            heappush(self._ready, (frame.priority, next(self._order), frame))
            self.request()

        if at is None or at <= self.chip.time:
            ready()
        else:
            self.chip.at(at, ready)

    def taken(self) -> list[Sent]:
        """Frames of the chip that were acknowledged since the last call, in order."""
        sent, self._sent = self._sent, []
        return sent

    @property
    def waiting(self) -> int:
        """How many frames of other nodes have not been sent yet."""
        return len(self._ready)

    def disturb(self, frames: int = 1) -> None:
        """The next frames are destroyed by an error frame of another node, each once."""
        self._disturbed += frames

    def lose(self, frames: int = 1) -> None:
        """The next frames of other nodes are never sent."""
        self._lost += frames

    @property
    def stuck_dominant(self) -> bool:
        """The bus is dominant all the time: a short circuit or a node gone wild."""
        return self._stuck

    @stuck_dominant.setter
    def stuck_dominant(self, stuck: bool) -> None:
        if stuck == self._stuck:
            return
        self._stuck = stuck
        self._recessive_since = self.chip.time
        if stuck:
            sender = self._break_off()
            self.chip.after(self.bits(6), lambda: self._dominant(sender))
        else:
            self._free = self.chip.time + self.bits(JOIN)
            if self.node:
                self.node.bus_recessive()
            self.request()

    # -- time ---------------------------------------------------------------------------------

    def bits(self, number: float) -> int:
        """How long bits take [ns]."""
        return round(number * 1e9 / self.bit_rate)

    def length(self, frame: Frame) -> int:
        """Bits from the start of a frame to its end."""
        return worst_bits_of(frame) if self.worst_stuffing else bits_of(frame)

    @property
    def idle(self) -> bool:
        """Whether nothing is on the wire."""
        return self._wire is None and not self._stuck

    @property
    def recessive_since(self) -> int:
        """When the last dominant bit had passed, if nothing is on the wire [ns]."""
        return self._recessive_since

    # -- frames -------------------------------------------------------------------------------

    def request(self) -> None:
        """Someone may have something to send."""
        if self._wire is None and not self._planned and not self._stuck:
            self._planned = True
            self.chip.at(max(self.chip.time, self._free), self._arbitrate)

    def withdraw(self) -> None:
        """The controller of the chip goes silent at once, in the midst of its frame maybe."""
        if self._wire and self._wire.from_chip:
            self._break_off()
            self.errors += 1
            self._finish(ERROR_FRAME)
            self.request()

    def _arbitrate(self) -> None:
        self._planned = False
        if self._wire is not None or self._stuck:
            return
        if self._free > self.chip.time:
            self.request()
            return
        own = self.node.candidate() if self.node else None
        wire = self._winner(own)
        if wire is None:
            return
        self._wire = wire
        wire.starts = self.chip.time
        wire.ends = self.chip.time + self._duration(wire)
        if self.node:
            self.node.started() if wire.from_chip else self.node.changed()
        self.chip.at(wire.ends, lambda: self._end(wire))

    def _winner(self, own: Frame | None) -> _Wire | None:
        while self._ready and self._lost:
            self._lost -= 1
            heappop(self._ready)
        other = self._ready[0][2] if self._ready and not (self.cut and own) else None
        if own is None and other is None:
            return None
        if other is None or (own is not None and own.priority < other.priority):
            assert own is not None
            return _Wire(own, True, False)
        entry = heappop(self._ready)
        if own is not None and own.priority == other.priority:
            return _Wire(own, True, True, entry=entry)
        return _Wire(other, False, True, entry=entry)

    def _duration(self, wire: _Wire) -> int:
        """Until the frame, or the error that ends it, has passed [ns], without the gap."""
        length = self.length(wire.frame)
        if self._destroyed(wire):
            return self.bits(int(length * HIT) + ERROR_FRAME)
        if self._unheard(wire):
            return self.bits(length - AFTER_ACKNOWLEDGE + ERROR_FRAME)
        return self.bits(length)

    def _destroyed(self, wire: _Wire) -> bool:
        collision = wire.from_chip and wire.from_others
        return collision or self._disturbed > 0 or self._misread(wire)

    def _misread(self, wire: _Wire) -> bool:
        """The controller has another idea of a bit: it disturbs, unless it may no more."""
        node = self.node
        if node is None or not node.takes_part or node.understands or self.cut:
            return False
        return wire.from_chip or not node.passive

    def _unheard(self, wire: _Wire) -> bool:
        return wire.from_chip and (not self.acknowledged or self.cut)

    def _end(self, wire: _Wire) -> None:
        if self._wire is not wire:
            return
        if self._destroyed(wire):
            self._end_destroyed(wire)
        elif self._unheard(wire):
            self._end_unheard()
        else:
            self._end_well(wire)

    def _end_destroyed(self, wire: _Wire) -> None:
        misread = self._misread(wire)
        self._disturbed -= self._disturbed > 0
        self.errors += 1
        if wire.entry:
            heappush(self._ready, wire.entry)
        self._finish(0)
        if self.node and not self.cut:
            if wire.from_chip:
                self.node.send_failed(bit_error=True)
            else:
                self.node.receive_failed(stuff_error=misread)
        self.request()

    def _end_unheard(self) -> None:
        assert self.node is not None
        self.errors += 1
        passive = self.node.passive
        self._finish(SUSPEND if passive else 0)
        self.node.send_failed(bit_error=False)
        self.request()

    def _end_well(self, wire: _Wire) -> None:
        self._finish(0)
        node = self.node
        if node and not self.cut:
            if wire.from_chip:
                self.log.append((self.chip.time, True, wire.frame))
                node.sent()
                self._tell(Sent(self.chip.time, wire.frame))
            else:
                self.log.append((self.chip.time, False, wire.frame))
                if node.takes_part and not node.understands:
                    node.receive_failed(stuff_error=True)
                else:
                    node.receive(wire.frame)
        self.request()

    def _tell(self, sent: Sent) -> None:
        self._sent.append(sent)
        for listener in self.listeners:
            listener(sent)

    def _finish(self, more: int) -> None:
        """The wire is recessive from now on; the next frame comes after the gap."""
        self._wire = None
        # The delimiter of the acknowledgement and the end of the frame were recessive already.
        self._recessive_since = self.chip.time - self.bits(AFTER_ACKNOWLEDGE)
        self._free = self.chip.time + self.bits(GAP + more)
        if self.node:
            self.node.bus_recessive()

    # -- a bus that is stuck ------------------------------------------------------------------

    def _break_off(self) -> bool:
        """Nothing is on the wire any more; what others sent they send again later.

        Whether the chip was sending.
        """
        wire, self._wire = self._wire, None
        if wire and wire.entry:
            heappush(self._ready, wire.entry)
        return bool(wire and wire.from_chip)

    def _dominant(self, sending: bool) -> None:
        """The controller sees more dominant bits than a frame can have, again and again."""
        node = self.node
        if not self._stuck or node is None or not node.takes_part or self.cut:
            return
        if sending:
            node.send_failed(bit_error=True)
        else:
            node.receive_failed(stuff_error=True, more=7)
        if not node.passive or (sending and node.takes_part):
            self.chip.after(self.bits(8), lambda: self._dominant(sending))
