"""The flash memory and its controller: wait states, keys, page erase, double words."""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING, ClassVar

from stm32g474.fault import ChipFault
from stm32g474.peripheral import Access, Peripheral, Register, Registers
from stm32g474.schedule import Event

if TYPE_CHECKING:
    from stm32g474.chip import Chip

BASE, SIZE, PAGE = 0x08000000, 0x80000, 0x800
KEYS = (0x45670123, 0xCDEF89AB)
OPTION_KEYS = (0x08192A3B, 0x4C5D6E7F)
#: Highest clock of the processor for each number of wait states [Hz], by the core's voltage.
BOOSTED = (34e6, 68e6, 102e6, 136e6, 170e6)
NORMAL = (30e6, 60e6, 90e6, 120e6, 150e6)
LOW = (12e6, 24e6, 26e6)
#: Typical times of the data sheet [ns].
PROGRAM_TIME, ERASE_TIME, MASS_TIME = 81_690, 22_020_000, 22_130_000
#: FLASH_CR.
PG, PER, MER1, BKER, MER2, STRT, OPTSTRT = 1, 2, 4, 1 << 11, 1 << 15, 1 << 16, 1 << 17
OPTLOCK, LOCK = 1 << 30, 1 << 31
#: FLASH_SR.
EOP, PROGERR, WRPERR, PGAERR, SIZERR, PGSERR, BSY = 1, 8, 16, 32, 64, 128, 1 << 16
ERRORS = 0xC3FA
#: FLASH_OPTR: two banks of pages of 2 KiB, watchdog started by software.
DUAL, WATCHDOG_BY_SOFTWARE = 1 << 22, 1 << 16
#: Read protection in FLASH_OPTR: none, and for good; any other number is level 1.
OPEN, SEALED = 0xAA, 0xCC


class FlashController(Peripheral):
    """FLASH, and the content of the memory."""

    REGISTERS: ClassVar[Registers] = {
        "ACR": Register(0x00, 0x00047F0F, 0x00040600),
        "PDKEYR": Register(0x04, access=Access.WRITE),
        "KEYR": Register(0x08, access=Access.WRITE),
        "OPTKEYR": Register(0x0C, access=Access.WRITE),
        "SR": Register(0x10, 0x0001C3FB, access=Access.STROBE),
        "CR": Register(0x14, 0xFF078FFF, 0xC0000000),
        "ECCR": Register(0x18, 0xF167FFFF),
        "OPTR": Register(0x20, 0x7FDF77FF, 0xFFEFF8AA),
        "PCROP1SR": Register(0x24, 0x7FFF, 0xFFFFFFFF),
        "PCROP1ER": Register(0x28, 0x80007FFF, 0x00FF0000),
        "WRP1AR": Register(0x2C, 0x007F007F, 0xFF00FFFF),
        "WRP1BR": Register(0x30, 0x007F007F, 0xFF00FFFF),
        "PCROP2SR": Register(0x44, 0x7FFF, 0xFFFFFFFF),
        "PCROP2ER": Register(0x48, 0x7FFF, 0xFFFF0000),
        "WRP2AR": Register(0x4C, 0x007F007F, 0xFF00FFFF),
        "WRP2BR": Register(0x50, 0x007F007F, 0xFF00FFFF),
        "SEC1R": Register(0x70, 0x000100FF, 0xFF00FE00),
        "SEC2R": Register(0x74, 0x000000FF, 0xFF00FE00),
    }

    def __init__(self, chip: Chip, memory: memoryview, watchdog_by_hardware: bool) -> None:
        self.memory = memory
        self.watchdog_by_hardware = watchdog_by_hardware
        #: As programmed: works from the next reset on.
        self.read_protection = OPEN
        self._keys: list[int] = []
        self._locked_for_good = False
        self._first: tuple[int, int] | None = None
        self._busy: Event | None = None
        #: What a cut of the power now would leave half done.
        self._touched: tuple[int, int] | None = None
        super().__init__(chip, "FLASH", 0x40022000, None)

    def reset(self) -> None:
        """The content stays; what was being written is done half."""
        self._interrupt()
        self._keys, self._first, self._locked_for_good = [], None, False
        super().reset()
        if self.watchdog_by_hardware:
            self.values["OPTR"] &= ~WATCHDOG_BY_SOFTWARE
        self.values["OPTR"] = self.values["OPTR"] & ~0xFF | self.read_protection

    @property
    def working_on(self) -> tuple[int, int] | None:
        """Begin and size of what is being erased or written."""
        return self._touched

    def _interrupt(self) -> None:
        """Power or clock end while the memory is busy: what it was working on is anything."""
        if self._busy:
            self._busy.cancel()
            self._busy = None
        if self._touched:
            begin, size = self._touched
            self.memory[begin : begin + size] = Random(begin).randbytes(size)
            self._touched = None

    # -- the clock ----------------------------------------------------------------------------

    def check_clock(self, hclk: float) -> None:
        """ChipFault when the voltage or the wait states do not bear this clock [Hz]."""
        power = self.chip.pwr
        # A clock that is off by its tolerance is still the nominal one.
        nominal = hclk / 1.011
        if nominal > power.fastest():
            text = (
                f"{hclk / 1e6:g} MHz in range {power.range}{' boosted' if power.boosted else ''}: "
                f"at most {power.fastest() / 1e6:g} MHz"
            )
            raise power.refuse("CR5", text)
        limits = BOOSTED if power.boosted else NORMAL if power.range == 1 else LOW
        needed = next((n for n, limit in enumerate(limits) if nominal <= limit), len(limits))
        if self.values["ACR"] & 0xF < needed:
            text = f"{hclk / 1e6:g} MHz needs {needed} wait states"
            raise self.refuse("ACR", text)

    def write_ACR(self, value: int) -> None:
        if value & 0x6000:
            raise self.refuse("ACR", "power-down of the flash is not part of this model")
        for cache, reset in ((9, 11), (10, 12)):
            if value >> reset & 1 and self.values["ACR"] >> cache & 1:
                raise self.refuse("ACR", "a cache is reset only while it is off")
        self.values["ACR"] = value
        self.chip.clocks_changed()

    # -- keys and commands ----------------------------------------------------------------------

    def write_PDKEYR(self, _value: int) -> None:
        raise self.refuse("PDKEYR", "power-down of the flash is not part of this model")

    def write_KEYR(self, value: int) -> None:
        self._unlock("KEYR", value, KEYS, LOCK)

    def write_OPTKEYR(self, value: int) -> None:
        if self.values["CR"] & LOCK:
            raise self.refuse("OPTKEYR", "FLASH_CR is locked")
        self._unlock("OPTKEYR", value, OPTION_KEYS, OPTLOCK)

    def _unlock(self, register: str, value: int, keys: tuple[int, int], lock: int) -> None:
        wanted = keys[len(self._keys)]
        if value != wanted or self._locked_for_good or not self.values["CR"] & lock:
            self._locked_for_good = True
            raise self.refuse(register, f"key {value:#010x}: locked until the next reset")
        self._keys.append(value)
        if len(self._keys) == 2:
            self._keys = []
            self.values["CR"] &= ~lock

    def read_SR(self) -> int:
        return self.values["SR"]

    def write_SR(self, value: int) -> None:
        self.values["SR"] &= ~(value & (ERRORS | EOP))

    def write_CR(self, value: int) -> None:
        before = self.values["CR"]
        if before & LOCK:
            raise self.refuse("CR", "locked: write the keys to FLASH_KEYR first")
        if self.values["SR"] & BSY:
            raise self.refuse("CR", "written while the memory is busy")
        if value & (OPTSTRT | 1 << 27 | 1 << 18):
            raise self.refuse("CR", "options and fast programming are not part of this model")
        self.values["CR"] = value & ~STRT
        if value & STRT:
            self._erase(value)

    def _erase(self, command: int) -> None:
        if self.values["SR"] & ERRORS:
            raise self.refuse("CR", f"started with errors in FLASH_SR {self.values['SR']:#x}")
        if command & PG or not command & (PER | MER1 | MER2):
            raise self.refuse("CR", "started without PER or MER, or with PG")
        if command & PER:
            page = (command >> 3 & 0x7F) + (128 if command & BKER else 0)
            self._clear(page * PAGE, PAGE, ERASE_TIME)
        else:
            begin = 0 if command & MER1 else SIZE // 2
            end = SIZE if command & MER2 else SIZE // 2
            self._clear(begin, end - begin, MASS_TIME)

    def _clear(self, begin: int, size: int, duration: int) -> None:
        def done() -> None:
            self.memory[begin : begin + size] = b"\xff" * size
            self.chip.processor.code_changed(BASE + begin, size)

        self._work(begin, size, duration, done)

    def _work(self, begin: int, size: int, duration: int, work: object) -> None:
        assert callable(work)

        def done() -> None:
            work()
            self._touched = self._busy = None
            self.values["SR"] &= ~BSY
            if self.values["CR"] >> 24 & 1:
                self.values["SR"] |= EOP
            self.changed()

        self.values["SR"] |= BSY
        self._touched = begin, size
        self._busy = self.chip.after(duration, done)

    # -- programming ----------------------------------------------------------------------------

    def program(self, address: int, size: int, value: int) -> None:
        """A write to the memory itself: the first word of a pair waits, the second writes both."""
        offset = address - BASE
        if self.values["CR"] & LOCK or not self.values["CR"] & PG:
            self._fail(PGSERR, address, "the memory is written without PG in FLASH_CR")
        if self.values["SR"] & (ERRORS | BSY):
            self._fail(PGSERR, address, "written while it is busy or FLASH_SR shows an error")
        if size != 4:
            self._fail(SIZERR, address, f"written by {size} bytes instead of two words")
        if offset % 8 == 0:
            self._first = offset, value
            return
        if self._first is None or self._first[0] != offset - 4:
            self._fail(PGAERR, address, "the second word of a pair without its first")
        assert self._first is not None
        first, self._first = self._first, None
        self._program_pair(first[0], first[1].to_bytes(4, "little") + value.to_bytes(4, "little"))

    def _program_pair(self, offset: int, data: bytes) -> None:
        old = bytes(self.memory[offset : offset + 8])
        if old != b"\xff" * 8 and data != bytes(8):
            self._fail(PROGERR, BASE + offset, "written while it is not erased")

        def done() -> None:
            self.memory[offset : offset + 8] = data
            self.chip.processor.code_changed(BASE + offset, 8)

        self._work(offset, 8, PROGRAM_TIME, done)
        self.changed()

    def _fail(self, error: int, address: int, reason: str) -> None:
        self.values["SR"] |= error
        self.changed()
        raise ChipFault(address, "flash", reason)
