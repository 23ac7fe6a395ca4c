"""The Cortex-M4 with its memories, on Unicorn: runs, stops, and enters exceptions."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from random import Random
from typing import Any

from unicorn import (
    UC_ARCH_ARM,
    UC_HOOK_INTR,
    UC_HOOK_MEM_INVALID,
    UC_MEM_WRITE_PROT,
    UC_MODE_THUMB,
    UC_PROT_ALL,
    UC_PROT_EXEC,
    UC_PROT_READ,
    Uc,
    UcError,
)
from unicorn import arm_const as arm

from stm32g474 import flash as flash_memory
from stm32g474.pace import DENIED, DIVISION, NO_COPROCESSOR, UNALIGNED, Ask, Pace, Tell

RAM, RAM_SIZE = 0x20000000, 0x20000
#: The last 32 KiB of the RAM are seen here too, where code runs from it.
CLOSE, CLOSE_SIZE, CLOSE_PART = 0x10000000, 0x8000, 0x18000
#: No instruction is here: the emulator runs until it is stopped.
FOREVER = 0xFFFFFFFE
STACKED = (
    arm.UC_ARM_REG_R0,
    arm.UC_ARM_REG_R1,
    arm.UC_ARM_REG_R2,
    arm.UC_ARM_REG_R3,
    arm.UC_ARM_REG_R12,
)
REGISTERS = {
    **{f"r{number}": arm.UC_ARM_REG_R0 + number for number in range(13)},
    "sp": arm.UC_ARM_REG_SP,
    "lr": arm.UC_ARM_REG_LR,
    "pc": arm.UC_ARM_REG_PC,
    "xpsr": arm.UC_ARM_REG_XPSR,
    "msp": arm.UC_ARM_REG_MSP,
    "psp": arm.UC_ARM_REG_PSP,
    "primask": arm.UC_ARM_REG_PRIMASK,
    "basepri": arm.UC_ARM_REG_BASEPRI,
    "faultmask": arm.UC_ARM_REG_FAULTMASK,
    "control": arm.UC_ARM_REG_CONTROL,
    "fpscr": arm.UC_ARM_REG_FPSCR,
    **{f"s{number}": arm.UC_ARM_REG_S0 + number for number in range(32)},
}
THUMB, RETURN = 1 << 24, 0xFFFFFFF9
#: Numbers of exceptions.
HARD, MEMORY, BUS, USAGE = 3, 4, 5, 6
#: CFSR.
DENIED_FETCH, DENIED_DATA, MEMORY_VALID = 1, 1 << 1, 1 << 7
FETCH_ERROR, DATA_ERROR, BUS_VALID = 1 << 8, 1 << 9, 1 << 15
UNDEFINED, STATE, NO_FPU, UNALIGNED_USE, BY_ZERO = 1 << 16, 1 << 17, 1 << 19, 1 << 24, 1 << 25
#: Numbers of Unicorn's exceptions.
SUPERVISOR_CALL, BREAKPOINT = 2, 7
WFE = 0xBF20


@dataclass(frozen=True)
class Trouble:
    """Why an instruction could not be done."""

    place: int
    text: str
    #: The exception it is, or zero for one that this model does not take.
    exception: int = 0
    #: Bits of CFSR.
    status: int = 0
    #: Address of the data, where CFSR says that it is known.
    address: int = 0
    #: A BKPT instruction, at which a debugger halts the processor.
    breakpoint: bool = False
    #: At an address that in an exception means the return from it.
    returning: bool = False


REFUSALS = {
    NO_COPROCESSOR: ("floating point while CPACR keeps it off", USAGE, NO_FPU),
    UNALIGNED: ("unaligned words", USAGE, UNALIGNED_USE),
    DIVISION: ("division by zero", USAGE, BY_ZERO),
    DENIED: ("access that memory protection denies", MEMORY, DENIED_DATA | MEMORY_VALID),
}


class Processor:
    """Executes what is in its memories."""

    def __init__(self, ask: Ask, tell: Tell, program: Tell, check_alignment: bool) -> None:
        """`program(address, size, value)` is told of stores into the flash; none may raise."""
        self._program = program
        self._trouble: Trouble | None = None
        self._next = 0
        self._written: tuple[int, bytes] | None = None
        self.emulator = _cortex_m4()
        content = (ctypes.c_ubyte * flash_memory.SIZE)()
        self.flash = memoryview(content).cast("B")
        self.ram = (ctypes.c_ubyte * RAM_SIZE)()
        close = (ctypes.c_ubyte * CLOSE_SIZE).from_buffer(self.ram, CLOSE_PART)
        only_read = UC_PROT_READ | UC_PROT_EXEC
        self._map(flash_memory.BASE, flash_memory.SIZE, only_read, content)
        self._map(RAM, RAM_SIZE, UC_PROT_ALL, self.ram)
        self._map(CLOSE, CLOSE_SIZE, UC_PROT_ALL, close)
        self.pace = Pace(self.emulator, ask, tell)
        self.emulator.hook_add(UC_HOOK_MEM_INVALID, self._invalid)
        self.emulator.hook_add(UC_HOOK_INTR, self._interrupted)
        if check_alignment:
            self.pace.watch_memory(RAM, RAM + RAM_SIZE - 1)

    def _map(self, base: int, size: int, rights: int, memory: Any) -> None:
        self.emulator.mem_map_ptr(base, size, rights, memory)

    # -- memory -------------------------------------------------------------------------------

    def read(self, address: int, size: int) -> int:
        """A value from memory."""
        return int.from_bytes(self.emulator.mem_read(address, size), "little")

    def write(self, address: int, size: int, value: int) -> None:
        """Put a value into RAM."""
        self.emulator.mem_write(address, value.to_bytes(size, "little"))
        self.code_changed(address, size)

    def code_changed(self, address: int, size: int) -> None:
        """Instructions there may be others now."""
        self.emulator.ctl_remove_cache(address & ~3, (address + size + 3) & ~3)

    def lose_ram(self, random: Random) -> None:
        """The RAM holds anything."""
        ctypes.memmove(self.ram, random.randbytes(RAM_SIZE), RAM_SIZE)
        self.code_changed(RAM, RAM_SIZE)

    def take_back(self) -> None:
        """Undo what Unicorn has written into the flash: only its controller may."""
        if self._written:
            offset, data = self._written
            self.flash[offset : offset + len(data)] = data
            self._written = None

    # -- running ------------------------------------------------------------------------------

    def register(self, name: str) -> int:
        """Value of a register: see REGISTERS."""
        value: int = self.emulator.reg_read(REGISTERS[name])
        return value

    def set_register(self, name: str, value: int) -> None:
        """Give a register a value while the processor stands still."""
        if name == "pc":
            self._next = value
        self.emulator.reg_write(REGISTERS[name], value)

    @property
    def place(self) -> int:
        """Where it goes on."""
        return self._next

    def start(self) -> None:
        """As after a reset: stack and first instruction from the beginning of the flash."""
        stack = int.from_bytes(self.flash[0:4], "little")
        for register in (arm.UC_ARM_REG_CONTROL, arm.UC_ARM_REG_PRIMASK):
            self.emulator.reg_write(register, 0)
        self.emulator.reg_write(arm.UC_ARM_REG_XPSR, THUMB)
        for register in (arm.UC_ARM_REG_MSP, arm.UC_ARM_REG_SP):
            self.emulator.reg_write(register, stack & ~3)
        self.emulator.reg_write(arm.UC_ARM_REG_LR, 0xFFFFFFFF)
        self._next = int.from_bytes(self.flash[4:8], "little")

    def run(self) -> Trouble | None:
        """Execute up to the limit of the pace; what stopped it before, if anything did."""
        failed = False
        try:
            self.emulator.emu_start(self._next | 1, FOREVER)
        except UcError:
            failed = True
        self._next = self.emulator.reg_read(arm.UC_ARM_REG_PC)
        return self._found(failed)

    def _found(self, failed: bool) -> Trouble | None:
        state, trouble = self.pace.state, self._trouble
        self._trouble = None
        if state.wrong:
            text, exception, status = REFUSALS[state.reason]
            trouble = Trouble(state.wrong, text, exception, status, state.address)
            state.wrong = state.reason = 0
        elif trouble is None and failed:
            trouble = self._undefined()
        elif trouble is None and state.count < state.limit:
            text = "sleeps for an interrupt, but none is enabled: it never wakes up"
            trouble = Trouble(self._next, text)
        return trouble

    def _undefined(self) -> Trouble | None:
        half = self.read(self._next & ~1, 2)
        if half == WFE:
            self._next += 2  # an event may always have been there
            return None
        return Trouble(self._next, f"undefined instruction {half:#06x}", USAGE, UNDEFINED)

    # -- what Unicorn tells -------------------------------------------------------------------

    def _invalid(
        self, _emulator: Any, access: int, address: int, size: int, value: int, _data: Any
    ) -> bool:
        """An access to no memory at all, or a store into the flash."""
        if access == UC_MEM_WRITE_PROT:
            self._store_into_flash(address, size, value & (1 << 8 * size) - 1)
            return True
        fetched = address == self.emulator.reg_read(arm.UC_ARM_REG_PC)
        status = FETCH_ERROR if fetched else DATA_ERROR | BUS_VALID
        text = f"access to {address:#010x}, where nothing is"
        self._trouble = Trouble(self.pace.state.place, text, BUS, status, address)
        return False

    def _store_into_flash(self, address: int, size: int, value: int) -> None:
        self.take_back()
        self._program(address, size, value)
        offset = address - flash_memory.BASE
        self._written = offset, bytes(self.flash[offset : offset + size])
        self.pace.state.limit = 0

    def _interrupted(self, emulator: Any, number: int, _data: Any) -> None:
        place = emulator.reg_read(arm.UC_ARM_REG_PC)
        if number == SUPERVISOR_CALL:
            self._trouble = Trouble(place, "SVC, which this model does not take")
        elif number == BREAKPOINT:
            self._trouble = Trouble(place, "breakpoint without a debugger", HARD, breakpoint=True)
        elif place >= 0xF0000000:
            text = "execution where no instructions may be"
            self._trouble = Trouble(place, text, MEMORY, DENIED_FETCH, returning=True)
        else:
            self._trouble = Trouble(place, "state without Thumb", USAGE, STATE)
        emulator.emu_stop()

    # -- exceptions ---------------------------------------------------------------------------

    def enter(self, exception: int, place: int, table: int) -> bool:
        """Stack a basic frame and go on at the vector; False where the stack has left the RAM."""
        emulator = self.emulator
        stack = self.register("sp")
        aligned = stack & 4
        stack = (stack & ~7) - 32
        if not RAM <= stack <= RAM + RAM_SIZE - 32:
            return False
        words = [emulator.reg_read(register) for register in STACKED]
        words += [self.register("lr"), place & ~1, self.register("xpsr") | THUMB | aligned << 7]
        emulator.mem_write(stack, b"".join(word.to_bytes(4, "little") for word in words))
        emulator.reg_write(arm.UC_ARM_REG_SP, stack)
        emulator.reg_write(arm.UC_ARM_REG_LR, RETURN)
        emulator.reg_write(arm.UC_ARM_REG_XPSR, THUMB | exception)
        self._next = self.read(table + 4 * exception, 4)
        return True


def _cortex_m4() -> Any:
    """Without the mode of M-class, which makes a Cortex-M33 of any model."""
    emulator: Any = Uc(UC_ARCH_ARM, UC_MODE_THUMB)
    emulator.ctl_set_cpu_model(arm.UC_CPU_ARM_CORTEX_M4)
    if emulator.ctl_get_cpu_model() != arm.UC_CPU_ARM_CORTEX_M4:
        raise RuntimeError("Unicorn emulates no Cortex-M4")
    return emulator
