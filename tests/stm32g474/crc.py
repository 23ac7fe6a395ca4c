"""The unit that computes checksums of 32 bits."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from stm32g474.peripheral import WORD, Peripheral, Register, Registers

if TYPE_CHECKING:
    from stm32g474.chip import Chip


def _reversed(value: int, bits: int) -> int:
    return int(f"{value:0{bits}b}"[::-1], 2)


class Crc(Peripheral):
    """CRC, for polynomials of degree 32."""

    REGISTERS: ClassVar[Registers] = {
        "DR": Register(0x00, reset=WORD, lasting=False, narrow=True),
        "IDR": Register(0x04),
        "CR": Register(0x08, 0xF9),
        "INIT": Register(0x10, reset=WORD),
        "POL": Register(0x14, reset=0x04C11DB7),
    }

    def __init__(self, chip: Chip) -> None:
        super().__init__(chip, "CRC", 0x40023000, ("AHB1ENR", 12))

    def write(self, address: int, size: int, value: int) -> None:
        """The data register takes bytes and half words too."""
        if address == self.base and size < 4:
            self.need_clock(address)
            self._add(value, 8 * size)
        else:
            super().write(address, size, value)

    def write_CR(self, value: int) -> None:
        if value >> 3 & 3:
            raise self.refuse("CR", "short polynomials are not part of this model")
        self.values["CR"] = value & ~1
        if value & 1:
            self.values["DR"] = self.values["INIT"]

    def read_DR(self) -> int:
        value = self.values["DR"]
        return _reversed(value, 32) if self.values["CR"] >> 7 & 1 else value

    def write_DR(self, value: int) -> None:
        self._add(value, 32)

    def _add(self, value: int, bits: int) -> None:
        width = (bits, 8, 16, 32)[self.values["CR"] >> 5 & 3]
        parts = range(bits - width, -1, -width) if width <= bits else [0]
        mask = (1 << width) - 1
        for shift in parts:
            part = value >> shift & mask
            self._shift(_reversed(part, width) if width != bits or self._turned else part, width)

    @property
    def _turned(self) -> bool:
        return bool(self.values["CR"] >> 5 & 3)

    def _shift(self, part: int, bits: int) -> None:
        state = self.values["DR"] ^ part << 32 - bits
        for _ in range(bits):
            state = (state << 1 ^ (self.values["POL"] if state >> 31 else 0)) & WORD
        self.values["DR"] = state
