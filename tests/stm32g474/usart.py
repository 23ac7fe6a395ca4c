"""Serial ports: eight data bits, no parity, one stop bit; with and without FIFO."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, ClassVar

from stm32g474.gpio import need_pins
from stm32g474.peripheral import Access, Peripheral, Register, Registers
from stm32g474.schedule import Event

if TYPE_CHECKING:
    from stm32g474.chip import Chip

#: CR1.
UE, RE, TE, OVER8, FIFO = 1, 4, 8, 1 << 15, 1 << 29
FORMAT = 1 << 10 | 1 << 12 | 1 << 28
#: Flags that are handled: no interrupts, no address marks, no delays.
CR1_USED = UE | RE | TE | OVER8 | FIFO
#: ISR.
ORE, IDLE, RXNE, TC, TXE, BUSY, TEACK, REACK, TXFE, RXFF = (
    1 << bit for bit in (3, 4, 5, 6, 7, 16, 21, 22, 23, 24)
)
CLEARABLE = 0x1F | TC | 1 << 8 | 1 << 9 | 1 << 11 | 1 << 12 | 1 << 17
OVERRUN_OFF = 1 << 12
DEPTH = 8
PRESCALERS = (1, 2, 4, 6, 8, 10, 12, 16, 32, 64, 128, 256)
BITS = 10
#: Parts of a bit rate that two ends may differ by.
TOLERANCE = 0.03


class Usart(Peripheral):
    """USART1, 2, 3, UART4, 5 or LPUART1, with a line to the outside."""

    REGISTERS: ClassVar[Registers] = {
        "CR1": Register(0x00),
        "CR2": Register(0x04, 0xFFFFFF79),
        "CR3": Register(0x08, 0xFFFEFFFF),
        "BRR": Register(0x0C, 0x000FFFFF),
        "GTPR": Register(0x10, 0xFFFF),
        "RTOR": Register(0x14),
        "RQR": Register(0x18, 0x1F, access=Access.STROBE),
        "ISR": Register(0x1C, access=Access.READ),
        "ICR": Register(0x20, 0x00123BFF, access=Access.STROBE),
        "RDR": Register(0x24, 0x1FF, access=Access.READ, lasting=False, narrow=True),
        "TDR": Register(0x28, 0x1FF, narrow=True),
        "PRESC": Register(0x2C, 0xF),
    }

    def __init__(
        self, chip: Chip, name: str, base: int, clock: tuple[str, int], select: int
    ) -> None:
        """`select`: place of the bits in RCC_CCIPR that choose its kernel clock."""
        #: Bits a second of the other end; None follows the chip.
        self.line: float | None = None
        #: Bytes that the chip sent, with the time when each had passed [ns].
        self.sent: list[tuple[int, int]] = []
        self.listeners: list[Callable[[int], None]] = []
        self._select = select
        self._low_power = name.startswith("LP")
        self._coming: deque[int] = deque()
        self._receiving: Event | None = None
        self._sending: Event | None = None
        super().__init__(chip, name, base, clock)

    def reset(self) -> None:
        """Off; what the other end sends meanwhile is lost."""
        for event in (self._receiving, self._sending):
            if event:
                event.cancel()
        self._receiving = self._sending = None
        self._received: deque[int] = deque()
        self._queue: deque[int] = deque()
        self._shifting: int | None = None
        super().reset()
        self.values["ISR"] = TC | TXE

    # -- for tests ----------------------------------------------------------------------------

    def taken(self) -> bytes:
        """Bytes that the chip sent since the last call."""
        data = bytes(byte for _, byte in self.sent)
        self.sent.clear()
        return data

    def receive(self, data: bytes) -> None:
        """The other end sends bytes, one after the other at the rate of the line."""
        self._coming.extend(data)
        if self._receiving is None and self._coming:
            self._receiving = self.chip.after(self._byte_time(True), self._arrived)

    # -- the line -----------------------------------------------------------------------------

    @property
    def kernel(self) -> float:
        """Its clock [Hz]."""
        bus = self.chip.rcc.pclk2 if self.name == "USART1" else self.chip.rcc.pclk1
        return self.chip.rcc.uart(self._select, bus) / PRESCALERS[self.values["PRESC"]]

    @property
    def rate(self) -> float:
        """Bits a second as they are set."""
        divider = self.values["BRR"]
        if self._low_power:
            return 256 * self.kernel / divider if divider else 0.0
        if self.values["CR1"] & OVER8:
            divider = divider & ~0xF | (divider & 7) << 1
            return 2 * self.kernel / divider if divider else 0.0
        return self.kernel / divider if divider else 0.0

    def _byte_time(self, of_line: bool) -> int:
        rate = self.line if of_line and self.line else self.rate or self.line or 115200.0
        return int(BITS * 1e9 / rate)

    def clocks_changed(self) -> None:
        """ChipFault when an enabled port is on another rate than its line."""
        if self.values["CR1"] & UE:
            self._check_rate()

    def _check_rate(self) -> None:
        if self.line and not abs(self.rate / self.line - 1) <= TOLERANCE:
            text = f"{self.rate:.0f} bit/s on a line of {self.line:.0f} bit/s"
            raise self.refuse("BRR", text)

    def _arrived(self) -> None:
        byte = self._coming.popleft()
        self._receiving = None
        if self.values["CR1"] & (UE | RE) == UE | RE:
            self._put(byte)
        if self._coming:
            self._receiving = self.chip.after(self._byte_time(True), self._arrived)
        self.changed()

    def _put(self, byte: int) -> None:
        if len(self._received) < (DEPTH if self.values["CR1"] & FIFO else 1):
            self._received.append(byte)
        elif self.values["CR3"] & OVERRUN_OFF:
            self._received[-1] = byte
        else:
            self.values["ISR"] |= ORE

    def _start(self) -> None:
        if self._shifting is None and self._queue:
            self._shifting = self._queue.popleft()
            self._sending = self.chip.after(self._byte_time(False), self._passed)
            self.values["ISR"] &= ~TC

    def _passed(self) -> None:
        byte, self._shifting = self._shifting, None
        assert byte is not None
        self.sent.append((self.chip.time, byte))
        for listener in self.listeners:
            listener(byte)
        self._start()
        if self._shifting is None:
            self.values["ISR"] |= TC
        self.changed()

    # -- registers ----------------------------------------------------------------------------

    def write_CR1(self, value: int) -> None:
        before = self.values["CR1"]
        if value & FORMAT:
            raise self.refuse("CR1", "only eight bits without parity are part of this model")
        if value & ~CR1_USED:
            raise self.refuse("CR1", "interrupts and marks are not part of this model")
        if before & UE and value & UE and (value ^ before) & (FIFO | OVER8):
            raise self.refuse("CR1", "FIFOEN and OVER8 are only written while UE is clear")
        self.values["CR1"] = value
        if value & UE and value & (RE | TE):
            self._check_enabled()
        if before & UE and not value & UE:
            self._received.clear()
            self._queue.clear()
            self.values["ISR"] = TC | TXE

    def check_pins(self) -> None:
        """ChipFault when it is enabled and its pins are not."""
        control = self.values["CR1"]
        if control & UE:
            signals = [name for name, bit in (("RX", RE), ("TX", TE)) if control & bit]
            need_pins(self.chip, self.name, signals)

    def _check_enabled(self) -> None:
        self.check_pins()
        if not self.kernel:
            raise self.refuse("CR1", "its kernel clock is off (RCC_CCIPR)")
        lowest = 0x300 if self._low_power else 16
        if self.values["BRR"] < lowest:
            raise self.refuse("BRR", f"{self.values['BRR']} is below {lowest}")
        self._check_rate()

    def _while_off(self, name: str, value: int) -> None:
        if self.values["CR1"] & UE:
            raise self.refuse(name, "only written while UE is clear")
        self.values[name] = value

    def write_BRR(self, value: int) -> None:
        if not self._low_power and value > 0xFFFF:
            raise self.refuse("BRR", "reserved bits changed")
        self._while_off("BRR", value)

    def write_PRESC(self, value: int) -> None:
        if value >= len(PRESCALERS):
            raise self.refuse("PRESC", f"{value} is reserved")
        self._while_off("PRESC", value)

    def write_CR2(self, value: int) -> None:
        if value:
            raise self.refuse("CR2", "other formats are not part of this model")

    def write_CR3(self, value: int) -> None:
        thresholds = 7 << 29 | 7 << 25
        if value & ~(OVERRUN_OFF | thresholds | 1 << 11):
            raise self.refuse("CR3", "DMA, handshakes and interrupts are not part of this model")
        self.values["CR3"] = value

    def read_ISR(self) -> int:
        control = self.values["CR1"]
        room = DEPTH if control & FIFO else 1
        value = self.values["ISR"] & (ORE | TC)
        value |= RXNE if self._received else 0
        value |= TXE if len(self._queue) < room else 0
        value |= BUSY if self._receiving and control & UE else 0
        if control & FIFO:
            value |= TXFE if not self._queue else 0
            value |= RXFF if len(self._received) == DEPTH else 0
        if control & UE:
            value |= TEACK if control & TE else 0
            value |= REACK if control & RE else 0
        return value

    def write_ICR(self, value: int) -> None:
        self.values["ISR"] &= ~(value & CLEARABLE)

    def write_RQR(self, value: int) -> None:
        if value & 8:
            self._received.clear()
        if value & 16:
            self._queue.clear()
        if value & 7:
            raise self.refuse("RQR", "breaks, mute and rate detection are not part of this model")

    def read_RDR(self) -> int:
        if not self._received:
            raise self.refuse("RDR", "read while nothing was received")
        byte = self._received.popleft()
        self.changed()
        return byte

    def write(self, address: int, size: int, value: int) -> None:
        """The data register takes bytes too."""
        if address == self.base + 0x28 and size < 4:
            self.need_clock(address)
            self.write_TDR(value)
            self.changed()
        else:
            super().write(address, size, value)

    def write_TDR(self, value: int) -> None:
        control = self.values["CR1"]
        if control & (UE | TE) != UE | TE:
            raise self.refuse("TDR", "written while the transmitter is off")
        if len(self._queue) >= (DEPTH if control & FIFO else 1):
            raise self.refuse("TDR", "written while it is full: a byte is lost")
        self._queue.append(value & 0xFF)
        self._start()
