"""Power control: the voltage of the core, which limits its clock."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from stm32g474.peripheral import Access, Peripheral, Register, Registers

if TYPE_CHECKING:
    from stm32g474.chip import Chip

#: How long the regulator takes from range 2 to range 1 [ns].
REGULATOR = 40_000
#: Highest clock of the processor [Hz].
BOOST, NORMAL, LOW = 170e6, 150e6, 26e6


class Pwr(Peripheral):
    """PWR."""

    REGISTERS: ClassVar[Registers] = {
        "CR1": Register(0x00, 0x00004707, 0x00000200),
        "CR2": Register(0x04, 0x000000FF),
        "CR3": Register(0x08, 0x0000E51F, 0x00008000),
        "CR4": Register(0x0C, 0x0000031F),
        "SR1": Register(0x10, 0x0000811F, access=Access.READ),
        "SR2": Register(0x14, 0x0000FF00, 0x00000100, access=Access.READ),
        "SCR": Register(0x18, 0x0000011F, access=Access.STROBE),
        **{
            f"P{way}CR{port}": Register(0x20 + 8 * number + 4 * down)
            for number, port in enumerate("ABCDEFG")
            for down, way in enumerate("UD")
        },
        "CR5": Register(0x80, 0x00000100, 0x00000100),
    }

    def __init__(self, chip: Chip) -> None:
        super().__init__(chip, "PWR", 0x40007000, ("APB1ENR1", 28))

    @property
    def range(self) -> int:
        """Range of the core's voltage: 1 is the high one."""
        return self.values["CR1"] >> 9 & 3

    @property
    def boosted(self) -> bool:
        """Whether range 1 is raised for clocks above 150 MHz."""
        return self.range == 1 and not self.values["CR5"] >> 8 & 1

    def fastest(self) -> float:
        """The highest clock of the processor that the voltage bears [Hz]."""
        if self.range != 1:
            return LOW
        return BOOST if self.boosted else NORMAL

    def write_CR1(self, value: int) -> None:
        if value >> 9 & 3 not in (1, 2):
            raise self.refuse("CR1", f"VOS {value >> 9 & 3} is reserved")
        if value & 7 or value >> 14 & 1:
            raise self.refuse("CR1", "low-power modes are not part of this model")
        rising = self.range == 2 and value >> 9 & 3 == 1
        self.values["CR1"] = value
        if rising:
            self.values["SR2"] |= 1 << 10
            self.chip.after(REGULATOR, self._risen)
        self.chip.clocks_changed()

    def _risen(self) -> None:
        self.values["SR2"] &= ~(1 << 10)
        self.changed()

    def write_CR5(self, value: int) -> None:
        self.values["CR5"] = value
        self.chip.clocks_changed()

    def write_SCR(self, value: int) -> None:
        self.values["SR1"] &= ~value
