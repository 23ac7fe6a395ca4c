"""What a CAN controller is asked to send: three buffers, as a queue or as a FIFO."""

from __future__ import annotations

from stm32g474.message_ram import Message

BUFFERS = 3


class Requests:
    """Which buffers are to be sent, and what became of the others, each as bits."""

    def __init__(self) -> None:
        self.pending = self.occurred = self.cancelled = 0
        #: To be cancelled, but on the wire.
        self.cancelling = 0
        #: The next place of a FIFO.
        self.put = 0
        self._messages: dict[int, Message] = {}
        self._order: list[int] = []

    @property
    def level(self) -> int:
        """Free places from the put index on; a request cancelled in the midst leaves a hole."""
        return (self._order[0] - self.put) % BUFFERS if self._order else BUFFERS

    def status(self, queued: bool) -> int:
        """TXFQS: the free level is that of a FIFO only."""
        if queued:
            free = [buffer for buffer in range(BUFFERS) if not self.pending >> buffer & 1]
            return (free[0] if free else 0) << 16 | (not free) << 21
        get = self._order[0] if self._order else self.put
        return self.level | get << 8 | self.put << 16 | (not self.level) << 21

    def add(self, buffer: int, message: Message) -> None:
        """A message is to be sent."""
        self.put = (self.put + 1) % BUFFERS
        self._order.append(buffer)
        self._messages[buffer] = message
        self.pending |= 1 << buffer
        self.occurred &= ~(1 << buffer)
        self.cancelled &= ~(1 << buffer)

    def message(self, buffer: int) -> Message:
        """What is to be sent from a buffer."""
        return self._messages[buffer]

    def end(self, buffer: int, sent: bool) -> bool:
        """A request has ended; whether that is a cancellation."""
        cancelled = not sent or bool(self.cancelling >> buffer & 1)
        self.pending &= ~(1 << buffer)
        self.cancelling &= ~(1 << buffer)
        self.occurred |= sent << buffer
        self.cancelled |= cancelled << buffer
        del self._messages[buffer]
        self._order.remove(buffer)
        return cancelled

    def best(self, queued: bool) -> int | None:
        """The buffer whose turn it is: by identifier and then by number, or the oldest."""
        if not queued or not self._order:
            return self._order[0] if self._order else None
        return min(self._order, key=lambda buffer: (self._messages[buffer].frame.priority, buffer))
