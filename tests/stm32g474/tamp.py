"""The backup registers of TAMP, which keep their content over resets."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from stm32g474.peripheral import Peripheral, Register, Registers

if TYPE_CHECKING:
    from stm32g474.chip import Chip

COUNT = 32


class Tamp(Peripheral):
    """TAMP, its backup registers only. This board has no battery."""

    REGISTERS: ClassVar[Registers] = {
        f"BKP{number}R": Register(0x100 + 4 * number) for number in range(COUNT)
    }

    def __init__(self, chip: Chip) -> None:
        self._kept = dict.fromkeys(self.REGISTERS, 0)
        super().__init__(chip, "TAMP", 0x40002400, ("APB1ENR1", 10))

    def reset(self) -> None:
        """The content stays."""
        self.values = self._kept
        self.changed()

    def lose_power(self) -> None:
        """The content goes."""
        self._kept = self.values = dict.fromkeys(self.REGISTERS, 0)
        self.changed()

    def write(self, address: int, size: int, value: int) -> None:
        if not self.chip.pwr.values["CR1"] >> 8 & 1:
            raise self.refuse("BKP0R", "written without DBP in PWR_CR1: the write is ignored")
        super().write(address, size, value)
