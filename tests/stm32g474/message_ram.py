"""The message RAM of the three CAN controllers: 212 words each, in a layout that is fixed."""

from __future__ import annotations

from dataclasses import dataclass
from random import Random
from typing import TYPE_CHECKING

from stm32g474.fault import ChipFault
from stm32g474.frame import Frame
from stm32g474.peripheral import Peripheral

if TYPE_CHECKING:
    from stm32g474.chip import Chip
    from stm32g474.fdcan import Fdcan

BASE, SIZE = 0x4000A400, 0x350
#: Places in the part of one controller [bytes].
STANDARD, EXTENDED, RX_FIFO, TX_EVENT, TX_BUFFER = 0x000, 0x070, (0x0B0, 0x188), 0x260, 0x278
ELEMENT = 72
REJECT = None


@dataclass(frozen=True)
class Message:
    """A frame with what the controller notes beside it."""

    frame: Frame
    event: bool = False
    marker: int = 0

    @classmethod
    def of(cls, frame: Frame) -> Message:
        """A frame that comes from outside."""
        return cls(frame)

    @property
    def head(self) -> int:
        """The first word of an element."""
        frame = self.frame
        identifier = frame.identifier if frame.extended else frame.identifier << 18
        return identifier | frame.remote << 29 | frame.extended << 30


class MessageRam(Peripheral):
    """SRAMCAN. Words only are written; what the controllers use meanwhile is left alone."""

    SIZE = SIZE

    def __init__(self, chip: Chip, number: int) -> None:
        self.number = number
        self.words = [0] * (SIZE // 4)
        self._node: Fdcan | None = None
        super().__init__(chip, f"SRAMCAN{number}", BASE + SIZE * (number - 1), ("APB1ENR1", 25))
        self.lose_power()

    def attach(self, node: Fdcan) -> None:
        """The controller that uses this part."""
        self._node = node

    def changed(self) -> None:
        """Nothing that was read is remembered."""

    def lose_power(self) -> None:
        """The content is anything."""
        random = Random(self.number)
        self.words = [random.getrandbits(32) for _ in self.words]

    def read(self, address: int, size: int) -> tuple[int, int]:
        self.need_clock(address)
        offset = address - self.base
        if address % size:
            raise self._fault(address, "unaligned access")
        self._check_read(address, offset)
        return self.words[offset // 4] >> 8 * (address & 3), 0

    def write(self, address: int, size: int, value: int) -> None:
        self.need_clock(address)
        if size != 4 or address % 4:
            raise self._fault(address, f"written by {size} bytes: the RAM takes words only")
        offset = address - self.base
        self._check_write(address, offset)
        self.words[offset // 4] = value

    def _fault(self, address: int, reason: str) -> ChipFault:
        return ChipFault(address, f"{self.name}+{address - self.base:#x}", reason)

    def _check_read(self, address: int, offset: int) -> None:
        node = self._node
        if node is None or node.stopped:
            return
        for number, begin in enumerate(RX_FIFO):
            if begin <= offset < begin + 3 * ELEMENT:
                element = (offset - begin) // ELEMENT
                if not node.rx[number].holds(element):
                    raise self._fault(address, f"element {element} of FIFO {number} is not filled")

    def _check_write(self, address: int, offset: int) -> None:
        node = self._node
        if node is None:
            return
        if offset >= TX_BUFFER:
            buffer = (offset - TX_BUFFER) // ELEMENT
            if node.pending >> buffer & 1:
                raise self._fault(address, f"buffer {buffer} is written while its frame is pending")
        elif offset >= RX_FIFO[0] and not node.stopped:
            raise self._fault(address, "a FIFO of the controller is written while it works")

    # -- elements -----------------------------------------------------------------------------

    def message(self, offset: int) -> Message:
        """What a buffer asks to send; ChipFault when the controller would send something else."""
        head, control = self.words[offset // 4 : offset // 4 + 2]
        extended, remote, length = bool(head >> 30 & 1), bool(head >> 29 & 1), control >> 16 & 0xF
        address = self.base + offset
        if head >> 31:
            raise self._fault(address, "ESI in a classic frame")
        if control >> 20 & 3:
            raise self._fault(address, "FDF or BRS in a frame of a controller without FD operation")
        if length > 8:
            raise self._fault(address, f"length code {length} in a classic frame")
        if not extended and head & 0x3FFFF:
            raise self._fault(address, "bits below a standard identifier, which starts at bit 18")
        identifier = head & 0x1FFFFFFF if extended else head >> 18 & 0x7FF
        first = offset // 4 + 2
        data = b"".join(word.to_bytes(4, "little") for word in self.words[first : first + 2])
        frame = Frame(identifier, b"" if remote else data[:length], extended, remote, length)
        return Message(frame, bool(control >> 23 & 1), control >> 24)

    def store(self, offset: int, message: Message, match: int | None, time_stamp: int) -> None:
        """An element of a FIFO: only words that the frame has are written."""
        frame = message.frame
        control = time_stamp | frame.length << 16 | (match or 0) << 24 | (match is None) << 31
        data = frame.data + bytes(-len(frame.data) % 4)
        words = [message.head, control]
        words += [int.from_bytes(data[at : at + 4], "little") for at in range(0, len(data), 4)]
        self.words[offset // 4 : offset // 4 + len(words)] = words

    def store_event(self, offset: int, message: Message, time_stamp: int) -> None:
        """An element of the FIFO of events: a frame was sent."""
        control = time_stamp | message.frame.length << 16 | 1 << 22 | message.marker << 24
        self.words[offset // 4 : offset // 4 + 2] = [message.head, control]

    # -- acceptance ---------------------------------------------------------------------------

    def accept(self, frame: Frame, settings: int, mask: int) -> tuple[int | None, int | None]:
        """The FIFO for a frame, or None, and the number of the filter that matched, or None."""
        if frame.remote and settings >> (0 if frame.extended else 1) & 1:
            return REJECT, None
        count = settings >> (24 if frame.extended else 16) & (0xF if frame.extended else 0x1F)
        for number in range(count):
            action = self._extended(frame, number, mask) if frame.extended else None
            if not frame.extended:
                action = self._standard(frame, number)
            if action:
                return self._target(action), number
        others = settings >> (2 if frame.extended else 4) & 3
        return (others if others < 2 else REJECT), None

    def _target(self, action: int) -> int | None:
        if action in (4, 5, 6):
            raise ChipFault(self.base, self.name, "filters with priority are not in this model")
        return {1: 0, 2: 1}.get(action, REJECT)

    def _standard(self, frame: Frame, number: int) -> int:
        """What the filter does with the frame; zero when it does not match."""
        word = self.words[STANDARD // 4 + number]
        kind, action = word >> 30, word >> 27 & 7
        first, second = word >> 16 & 0x7FF, word & 0x7FF
        return action if _matches(kind, frame.identifier, first, second, kind == 3) else 0

    def _extended(self, frame: Frame, number: int, mask: int) -> int:
        place = EXTENDED // 4 + 2 * number
        first, second = self.words[place], self.words[place + 1]
        kind, action = second >> 30, first >> 29
        identifier = frame.identifier & (mask if kind != 3 else 0x1FFFFFFF)
        first, second = first & 0x1FFFFFFF, second & 0x1FFFFFFF
        return action if _matches(kind if kind != 3 else 0, identifier, first, second, False) else 0


def _matches(kind: int, identifier: int, first: int, second: int, disabled: bool) -> bool:
    """Range, two identifiers, or an identifier under a mask."""
    if disabled:
        return False
    if kind == 0:
        return first <= identifier <= second
    if kind == 1:
        return identifier in (first, second)
    return (identifier ^ first) & second == 0
