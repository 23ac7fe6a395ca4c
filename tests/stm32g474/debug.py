"""What a debugger and the trace unit see: cycles, breakpoints, which chip this is."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from stm32g474.pace import FIRST_COUNTER
from stm32g474.peripheral import WORD, Access, Peripheral, Register, Registers, row

if TYPE_CHECKING:
    from stm32g474.chip import Chip

TRACE = 1 << 24
#: DWT_CTRL: four comparators.
COMPARATORS = 4 << 28


class Trace(Peripheral):
    """DWT: the counter of cycles; the comparators watch nothing."""

    SIZE = 0x1000
    REGISTERS: ClassVar[Registers] = {
        "CTRL": Register(0x000, reset=COMPARATORS),
        "CYCCNT": Register(0x004),
        "CPICNT": Register(0x008),
        "EXCCNT": Register(0x00C),
        "SLEEPCNT": Register(0x010),
        "LSUCNT": Register(0x014),
        "FOLDCNT": Register(0x018),
        **row("COMP", Register(0x020), 4, 16),
        **row("MASK", Register(0x024), 4, 16),
        **row("FUNCTION", Register(0x028), 4, 16),
        "DEVARCH": Register(0xFBC, access=Access.READ),
    }

    def __init__(self, chip: Chip, counter: int) -> None:
        self.counter = counter
        super().__init__(chip, "DWT", 0xE0001000, None)

    def reset(self) -> None:
        super().reset()
        self._set(0)

    def need_clock(self, address: int) -> None:
        if not self.chip.system.values["DEMCR"] & TRACE:
            raise self.refuse("CTRL", "used without TRCENA in DEMCR")

    def clocks_changed(self) -> None:
        """The counter goes on with another clock."""
        self._set(self.read_CYCCNT())

    def _set(self, value: int) -> None:
        rate = self.chip.rcc.hclk if self.values["CTRL"] & 1 else 0.0
        self.chip.set_counter(self.counter, value, rate, WORD + 1)

    def kind_of(self, key: str) -> int:
        return FIRST_COUNTER + self.counter if key == "CYCCNT" else super().kind_of(key)

    def read_CYCCNT(self) -> int:
        return self.chip.counted(self.counter)

    def write_CYCCNT(self, value: int) -> None:
        self._set(value)

    def write_CTRL(self, value: int) -> None:
        if value & ~1 & ~(WORD << 28):
            raise self.refuse("CTRL", "only the counter of cycles is part of this model")
        at = self.read_CYCCNT()
        self.values["CTRL"] = value & 1 | COMPARATORS
        self._set(at)


class Breakpoints(Peripheral):
    """FPB, which stops at nothing."""

    SIZE = 0x1000
    REGISTERS: ClassVar[Registers] = {
        "CTRL": Register(0x000, 0x7FF3, 0x00000260),
        "REMAP": Register(0x004),
        **row("COMP", Register(0x008), 8),
    }

    def __init__(self, chip: Chip) -> None:
        super().__init__(chip, "FPB", 0xE0002000, None)

    def write_CTRL(self, value: int) -> None:
        self.values["CTRL"] = 0x260 | value & 1

    def write(self, address: int, size: int, value: int) -> None:
        """A comparator that is enabled would stop the real processor."""
        super().write(address, size, value)
        if any(self.values[f"COMP{number}"] & 1 for number in range(8)):
            raise self.refuse("COMP0", "breakpoints are not part of this model")


class Debug(Peripheral):
    """DBGMCU: which chip this is, and what stops while a debugger halts it."""

    REGISTERS: ClassVar[Registers] = {
        "IDCODE": Register(0x00, reset=0x20030469, access=Access.READ),
        "CR": Register(0x04, 0xE7),
        "APB1FZR1": Register(0x08, 0xC0601C3F),
        "APB1FZR2": Register(0x0C, 0x2),
        "APB2FZ": Register(0x10, 0x04172800),
    }

    def __init__(self, chip: Chip) -> None:
        super().__init__(chip, "DBGMCU", 0xE0042000, None)
