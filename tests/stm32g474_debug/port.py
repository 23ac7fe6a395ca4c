"""The debug port with its one access port, through which a debugger reads and writes the chip."""

from collections.abc import Callable

from stm32g474 import Chip, ChipFault

#: One access takes so long on the wires [ns]: 41 bits at 2 MHz.
ACCESS = 20_000
#: How often the chip is looked at while time passes [ns].
GLANCE = 500_000
RAM = range(0x20000000, 0x20020000)
#: Addresses that count up by themselves wrap here, in the access port of a Cortex-M4.
WRAP = 0x1000
#: DP CTRL/STAT: power requests with their answers above them, and the sticky error.
REQUESTS, ERROR = 0x50000000, 1 << 5
#: AP CSW: fixed bits, bits that can be written, device enabled.
CSW_RESET, CSW_BITS, ENABLED = 0x23000040, 0xFF000F37, 0x40
#: AP: ROM table and identification of an AHB access port.
ROM_TABLE, AHB_PORT = 0xE00FF003, 0x24770011
CSW, TAR, DRW, BANKED, BASE, IDR = 0x00, 0x04, 0x0C, range(0x10, 0x20, 4), 0xF8, 0xFC
SIZES = {0: 1, 1: 2, 2: 4}


class DebugPort:
    """Registers of the debug port, and of access port 0; there is no other."""

    def __init__(self, chip: Chip, glance: Callable[[], None]) -> None:
        """`glance`: called again and again while time passes; it may cut the power."""
        self.chip, self._glance = chip, glance
        #: What the chip refused: no debugger that does its work well sees any.
        self.refused: list[ChipFault] = []
        self._status = self._select = self._buffer = 0
        self._csw, self._tar = CSW_RESET, 0
        self._owed = 0

    def pass_time(self, duration: int) -> None:
        """Time goes by before the next access that can see it [ns]."""
        self._owed += duration

    def read(self, register: int) -> int:
        """A register of the debug port, by its address."""
        if register == 0x4:
            return self._status | (self._status & REQUESTS) << 1
        return self._buffer if register == 0xC else 0

    def write(self, register: int, value: int) -> None:
        """Write a register of the debug port; ones to the sticky error clear it."""
        if register == 0x4:
            kept = self._status & ERROR & ~value
            self._status = value & (REQUESTS | 0xF00) | kept
        elif register == 0x8:
            self._select = value

    def access_read(self, register: int) -> int:
        """A register of the access port; what it says comes with the next access too."""
        self._buffer = self._access(self._select & 0xF0 | register, None)
        return self._buffer

    def access_write(self, register: int, value: int) -> None:
        """Write a register of the access port."""
        self._access(self._select & 0xF0 | register, value)

    def _access(self, register: int, value: int | None) -> int:
        if self._select >> 24 or self._status & ERROR or not self.chip.powered:
            return 0
        self._owed += ACCESS
        if register == DRW:
            found = self._transfer(self._tar, SIZES[self._csw & 7], value)
            self._count_up()
            return found
        if register in BANKED:
            return self._transfer(self._tar & ~0xF | register & 0xF, 4, value)
        if value is None:
            return {CSW: self._csw, TAR: self._tar, BASE: ROM_TABLE, IDR: AHB_PORT}.get(register, 0)
        if register == TAR:
            self._tar = value
        elif register == CSW and value & 7 in SIZES:
            self._csw = value & CSW_BITS | ENABLED
        return 0

    def _count_up(self) -> None:
        if self._csw >> 4 & 3:
            step = SIZES[self._csw & 7]
            self._tar = self._tar & -WRAP | self._tar + step & WRAP - 1

    def _transfer(self, address: int, size: int, value: int | None) -> int:
        """Read or write the chip; data narrower than a word is in the byte lanes of its address."""
        shift = 8 * (address & 3)
        try:
            if value is None:
                self._catch_up()
                return self.chip.bus_read(address, size) << shift
            if address not in RAM:
                self._catch_up()
            self.chip.bus_write(address, value >> shift & (1 << 8 * size) - 1, size)
        except ChipFault as fault:
            self.refused.append(fault)
            self._status |= ERROR
        return 0

    def _catch_up(self) -> None:
        """Let the chip live through the time that has gone by."""
        owed, self._owed = self._owed, 0
        end = self.chip.time + owed
        while self.chip.powered and self.chip.time < end:
            self.chip.run_until(min(end, self.chip.time + GLANCE))
            self._glance()
