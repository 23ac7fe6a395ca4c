"""System configuration, and read-only facts of the chip."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from stm32g474.peripheral import Access, Peripheral, Register, Registers, row

if TYPE_CHECKING:
    from stm32g474.chip import Chip


class Syscfg(Peripheral):
    """SYSCFG."""

    REGISTERS: ClassVar[Registers] = {
        "MEMRMP": Register(0x00, 0x107),
        "CFGR1": Register(0x04, 0xFCFF0300, 0x7C000000),
        **row("EXTICR", Register(0x08, 0x7777), 4),
        "SCSR": Register(0x18, 0x3),
        "CFGR2": Register(0x1C, 0x10F),
        "SWPR": Register(0x20),
        "SKR": Register(0x24, 0xFF, access=Access.WRITE),
    }

    def __init__(self, chip: Chip) -> None:
        super().__init__(chip, "SYSCFG", 0x40010000, ("APB2ENR", 0))

    def write_MEMRMP(self, value: int) -> None:
        if value:
            raise self.refuse("MEMRMP", "another memory at address zero is not part of this model")


class Identity(Peripheral):
    """Read-only facts of the chip: its number and the size of its flash."""

    SIZE = 0x10000
    REGISTERS: ClassVar[Registers] = {
        **row("UID", Register(0x7590, reset=0x00C0FFEE, access=Access.READ), 3),
        "FLASHSIZE": Register(0x75E0, reset=0xFFFF0200, access=Access.READ, narrow=True),
    }

    def __init__(self, chip: Chip) -> None:
        super().__init__(chip, "SYSTEM", 0x1FFF0000, None)
