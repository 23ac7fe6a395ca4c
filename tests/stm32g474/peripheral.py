"""What every peripheral shares: named registers, and the refusal of accesses that go wrong."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from enum import Enum
from typing import TYPE_CHECKING, ClassVar

from stm32g474.fault import ChipFault
from stm32g474.pace import ASKED, KNOWN

if TYPE_CHECKING:
    from stm32g474.chip import Chip

WORD = 0xFFFFFFFF


class Access(Enum):
    """What software may do with a register."""

    BOTH = "read and write"
    READ = "read only"
    WRITE = "write only"
    #: Ones clear, start or request something; a one in a reserved bit does nothing.
    STROBE = "write ones"


@dataclass(frozen=True)
class Register:
    """A register: its place, the bits that exist, and what reset leaves in it."""

    offset: int
    bits: int = WORD
    reset: int = 0
    access: Access = Access.BOTH
    #: What is read cannot change until the peripheral says so.
    lasting: bool = True
    #: Accesses narrower than a word work too.
    narrow: bool = False


Registers = Mapping[str, Register]


def row(name: str, register: Register, count: int, stride: int = 4) -> Registers:
    """Registers of one kind, numbered from zero."""
    return {
        f"{name}{number}": replace(register, offset=register.offset + stride * number)
        for number in range(count)
    }


Writer = Callable[[int], None]
Reader = Callable[[], int]


class Peripheral:
    """Registers at an address of the chip.

    A subclass names them in REGISTERS. A method `read_NAME` answers in place of the stored value,
    a method `write_NAME` acts on a written one in place of storing it.
    """

    REGISTERS: ClassVar[Registers] = {}
    SIZE = 0x400

    def __init__(self, chip: Chip, name: str, base: int, clock: tuple[str, int] | None) -> None:
        """`clock`: the register of RCC and the bit that switch the clock on; None: always on."""
        self.chip, self.name, self.base, self.clock = chip, name, base, clock
        self.values: dict[str, int] = {}
        self._names = {register.offset: key for key, register in self.REGISTERS.items()}
        self._drop_reads = chip.forgetting(base, self.SIZE)
        self._readers: dict[str, Reader] = {}
        self._writers: dict[str, Writer] = {}
        for key in self.REGISTERS:
            if reader := getattr(self, f"read_{key}", None):
                self._readers[key] = reader
            if writer := getattr(self, f"write_{key}", None):
                self._writers[key] = writer
        self.reset()

    def reset(self) -> None:
        """As after a reset of the chip."""
        self.values = {key: register.reset for key, register in self.REGISTERS.items()}
        self.changed()

    def changed(self) -> None:
        """What was read before may have another value now."""
        self._drop_reads()

    def refuse(self, register: str, reason: str) -> ChipFault:
        """The fault of an access to a register, to be raised."""
        known = self.REGISTERS.get(register)
        offset = known.offset if known else 0
        return ChipFault(self.base + offset, f"{self.name}_{register}", reason)

    def need_clock(self, address: int) -> None:
        """ChipFault when the clock is off."""
        if self.clock is None:
            return
        register, bit = self.clock
        if not self.chip.rcc.values[register] >> bit & 1:
            reason = f"the clock is off (RCC_{register} bit {bit})"
            raise ChipFault(address, self._name_at(address), reason)

    def kind_of(self, key: str) -> int:
        """Whether what was read of a register stays until `changed`; see pace.py."""
        return KNOWN if self.REGISTERS[key].lasting else ASKED

    def read(self, address: int, size: int) -> tuple[int, int]:
        """The value of a register and its kind; ChipFault where it cannot be read."""
        self.need_clock(address)
        key, register = self._register(address, size)
        if register.access in (Access.WRITE, Access.STROBE) and key not in self._readers:
            raise self.refuse(key, "a register that is only written was read")
        reader = self._readers.get(key)
        value = reader() if reader else self.values[key]
        shift = 8 * (address & 3)
        return value >> shift, self.kind_of(key) if size == 4 else ASKED

    def write(self, address: int, size: int, value: int) -> None:
        """Write a register; ChipFault where the chip would ignore that or do something else."""
        self.need_clock(address)
        key, register = self._register(address, size)
        if register.access is Access.READ:
            raise self.refuse(key, "a register that is only read was written")
        if size != 4:
            raise self.refuse(key, f"written by {size} bytes instead of a word")
        self._check_reserved(key, register, value)
        writer = self._writers.get(key)
        if writer:
            writer(value)
        else:
            self.values[key] = value & register.bits
        self.changed()

    def _check_reserved(self, key: str, register: Register, value: int) -> None:
        reserved = ~register.bits & WORD
        if register.access is Access.STROBE or not (value ^ register.reset) & reserved:
            return
        wrong = (value ^ register.reset) & reserved
        bits = ", ".join(str(bit) for bit in range(32) if wrong >> bit & 1)
        raise self.refuse(key, f"reserved bits changed: {bits}")

    def _register(self, address: int, size: int) -> tuple[str, Register]:
        key = self._names.get((address - self.base) & ~3)
        if key is None:
            raise ChipFault(address, self._name_at(address), "no register is here")
        register = self.REGISTERS[key]
        if address % size:
            raise ChipFault(address, self._name_at(address), "unaligned access")
        if size != 4 and not register.narrow:
            raise self.refuse(key, f"accessed by {size} bytes instead of a word")
        return key, register

    def _name_at(self, address: int) -> str:
        offset = address - self.base
        return f"{self.name}_{self._names.get(offset & ~3, f'+{offset:#x}')}"
