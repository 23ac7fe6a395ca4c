"""Runs functions of an ELF file on an emulated Cortex-M4F and counts their instructions."""

import struct
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from elftools.elf.elffile import ELFFile
from numpy.typing import NDArray
from unicorn import UC_ARCH_ARM, UC_HOOK_BLOCK, UC_MODE_THUMB, Uc
from unicorn.arm_const import (
    UC_ARM_REG_LR,
    UC_ARM_REG_PC,
    UC_ARM_REG_R0,
    UC_ARM_REG_R1,
    UC_ARM_REG_R2,
    UC_ARM_REG_R3,
    UC_ARM_REG_SP,
    UC_CPU_ARM_CORTEX_M4,
)

FLASH, FLASH_SIZE = 0x08000000, 0x100000
RAM, RAM_SIZE = 0x20000000, 0x40000
#: Where data for calls is placed: the upper half of the RAM, below the stack.
DATA = RAM + RAM_SIZE // 2
STACK = RAM + RAM_SIZE
#: Returning to this address ends a call.
FINISH = FLASH + FLASH_SIZE - 4
REGISTERS = (UC_ARM_REG_R0, UC_ARM_REG_R1, UC_ARM_REG_R2, UC_ARM_REG_R3)
#: A call that runs longer than this is broken.
MOST_INSTRUCTIONS = 20_000_000

Floats = NDArray[np.float32]


def cortex_m4() -> Any:
    """A processor with empty memory.

    Without UC_MODE_MCLASS, which makes a Cortex-M33 of any model. RuntimeError when it is none.
    """
    cpu = Uc(UC_ARCH_ARM, UC_MODE_THUMB)
    cpu.ctl_set_cpu_model(UC_CPU_ARM_CORTEX_M4)
    if (model := cpu.ctl_get_cpu_model()) != UC_CPU_ARM_CORTEX_M4:
        raise RuntimeError(f"Unicorn emulates its ARM model {model}, which is no Cortex-M4")
    cpu.mem_map(FLASH, FLASH_SIZE)
    cpu.mem_map(RAM, RAM_SIZE)
    return cpu


def thumb_instructions(code: bytes) -> int:
    """Number of Thumb instructions: 32 bits long where the first five are above 0b11100."""
    halves = struct.unpack(f"<{len(code) // 2}H", code)
    count = position = 0
    while position < len(halves):
        position += 2 if halves[position] >> 11 > 0b11100 else 1
        count += 1
    return count


class Emulator:
    """One program in flash, with room in RAM to place arguments."""

    def __init__(self, program: Path, more: Sequence[tuple[int, int]] = ()) -> None:
        """Load an ELF file that was linked to FLASH and RAM; more: memory, addresses and sizes."""
        self._cpu = cortex_m4()
        for address, size in more:
            self._cpu.mem_map(address, size)
        self._count = 0
        self._lengths: dict[tuple[int, int], int] = {}
        self._cpu.hook_add(UC_HOOK_BLOCK, self._on_block)
        with program.open("rb") as stream:
            elf = ELFFile(stream)
            for segment in elf.iter_segments("PT_LOAD"):
                self._cpu.mem_write(segment["p_paddr"], segment.data())
            table: Any = elf.get_section_by_name(".symtab")
            self._symbols = {symbol.name: symbol["st_value"] for symbol in table.iter_symbols()}
        self._next = DATA

    def _on_block(self, _cpu: object, address: int, size: int, _data: object) -> None:
        """Count a straight run of instructions, which is always run to its end.

        Those that a condition skips are counted: the processor spends a cycle on them too.
        """
        block = address, size
        if block not in self._lengths:
            self._lengths[block] = thumb_instructions(bytes(self._cpu.mem_read(address, size)))
        self._count += self._lengths[block]

    def free_all(self) -> None:
        """Forget everything that was placed."""
        self._next = DATA

    def place(self, data: bytes) -> int:
        """Put data into RAM; returns its address."""
        address = self._next
        self._cpu.mem_write(address, data)
        self._next += (len(data) + 7) // 8 * 8
        return address

    def put(self, address: int, data: bytes) -> None:
        """Put data to an address."""
        self._cpu.mem_write(address, data)

    def place_floats(self, values: Sequence[float] | NDArray[np.floating[Any]]) -> int:
        """Put single-precision numbers into RAM; returns their address."""
        return self.place(np.asarray(values, np.float32).tobytes())

    def place_words(self, words: Sequence[int]) -> int:
        """Put 32-bit words, such as addresses, into RAM; returns their address."""
        return self.place(struct.pack(f"<{len(words)}I", *words))

    def read_floats(self, address: int, count: int) -> Floats:
        """Single-precision numbers from RAM."""
        return np.frombuffer(bytes(self._cpu.mem_read(address, 4 * count)), np.float32)

    @property
    def return_address(self) -> int:
        """Where the function that has just been entered returns to."""
        address: int = self._cpu.reg_read(UC_ARM_REG_LR)
        return address

    def call(self, name: str, *words: int) -> int:
        """Call a function with integers or addresses; returns the instructions it took.

        RuntimeError when it does not come back.
        """
        stacked = words[len(REGISTERS) :]
        stack = STACK - (4 * len(stacked) + 7) // 8 * 8
        self._cpu.mem_write(stack, struct.pack(f"<{len(stacked)}I", *stacked))
        for register, word in zip(REGISTERS, words, strict=False):
            self._cpu.reg_write(register, word)
        self._cpu.reg_write(UC_ARM_REG_SP, stack)
        self._cpu.reg_write(UC_ARM_REG_LR, FINISH | 1)
        self._count = 0
        self._cpu.emu_start(self._symbols[name] | 1, FINISH, count=MOST_INSTRUCTIONS)
        if self._cpu.reg_read(UC_ARM_REG_PC) != FINISH:
            raise RuntimeError(f"{name} did not return within {MOST_INSTRUCTIONS} instructions")
        return self._count
