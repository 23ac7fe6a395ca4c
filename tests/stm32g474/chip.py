"""A simulated STM32G474 that runs firmware: processor, memories, peripherals and time."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from fractions import Fraction
from random import Random
from typing import Any, TypeVar

from unicorn import (
    UC_ARCH_ARM,
    UC_ERR_OK,
    UC_HOOK_INTR,
    UC_HOOK_MEM_INVALID,
    UC_MEM_WRITE_PROT,
    UC_MODE_THUMB,
    UC_PROT_EXEC,
    UC_PROT_READ,
    Uc,
    UcError,
)
from unicorn.arm_const import (
    UC_ARM_REG_CONTROL,
    UC_ARM_REG_LR,
    UC_ARM_REG_MSP,
    UC_ARM_REG_PC,
    UC_ARM_REG_PRIMASK,
    UC_ARM_REG_R0,
    UC_ARM_REG_R1,
    UC_ARM_REG_R2,
    UC_ARM_REG_R3,
    UC_ARM_REG_R12,
    UC_ARM_REG_SP,
    UC_ARM_REG_XPSR,
    UC_CPU_ARM_CORTEX_M4,
)

from stm32g474 import flash as flash_memory
from stm32g474.bus import Bus
from stm32g474.crc import Crc
from stm32g474.fault import ChipFault
from stm32g474.fdcan import Fdcan
from stm32g474.flash import FlashController
from stm32g474.gpio import Gpio
from stm32g474.message_ram import MessageRam
from stm32g474.pace import KNOWN, NO_COPROCESSOR, Counter, Pace, Window
from stm32g474.peripheral import Peripheral
from stm32g474.power import Pwr
from stm32g474.rcc import Rcc
from stm32g474.schedule import Action, Event, Schedule
from stm32g474.system import Debug, Identity, Syscfg, SystemControl, Trace
from stm32g474.timer import Timer
from stm32g474.usart import Usart
from stm32g474.watchdog import Iwdg

Kind = TypeVar("Kind", bound=Peripheral)

RAM, RAM_SIZE = 0x20000000, 0x20000
#: The last 32 KiB of the RAM are seen here too, where code runs from it.
CLOSE, CLOSE_SIZE, CLOSE_PART = 0x10000000, 0x8000, 0x18000
#: Clocks that an instruction takes: flash that keeps up mostly, branches, loads and divisions.
CYCLES = Fraction(3, 2)
WINDOWS = (
    (0x1FFF0000, 0x10000),
    (0x40000000, 0x30000),
    (0x48000000, 0x2000),
    (0x50000000, 0x61000),
    (0xE0000000, 0x100000),
)
FOREVER = 0xFFFFFFFE
STACKED = (UC_ARM_REG_R0, UC_ARM_REG_R1, UC_ARM_REG_R2, UC_ARM_REG_R3, UC_ARM_REG_R12)
HARD_FAULT, EXCEPTION_RETURN = 3, 0xFFFFFFF9
#: Numbers of Unicorn's exceptions.
SUPERVISOR_CALL, BREAKPOINT = 2, 7
#: CFSR.
UNDEFINED, STATE, NO_FPU, UNALIGNED_USE = 1 << 16, 1 << 17, 1 << 19, 1 << 24
FETCH_ERROR, DATA_ERROR, ADDRESS_VALID = 1 << 8, 1 << 9, 1 << 15
#: HFSR.
FORCED, BY_DEBUG = 1 << 30, 1 << 31
NO_INTERRUPT = "sleeps for an interrupt, but none is enabled: it never wakes up"


class Chip:
    """An STM32G474xE on a board: three CAN buses, serial lines, a crystal.

    `faults` tells what an exception of the processor does: "raise" a ChipFault, or "take" it as
    the hard fault of the firmware.
    """

    def __init__(
        self,
        flash: bytes,
        flash_base: int = flash_memory.BASE,
        *,
        hse: float | None = 24e6,
        hsi: float = 16.128e6,
        lsi: float = 32e3,
        bit_rates: tuple[float, float, float] = (1e6, 1e6, 1e6),
        faults: str = "raise",
        watchdog_by_hardware: bool = False,
        check_alignment: bool = True,
        seed: int = 1,
    ) -> None:
        """Power is on and the chip starts with the content of its flash.

        `hse`: the crystal [Hz], or None for one that never swings. `hsi` and `lsi`: the internal
        oscillators as this chip has them [Hz], the first at the limit of what they are sold as.
        """
        self.hse, self.hsi, self.lsi, self.faults = hse, hsi, lsi, faults
        self._random = Random(seed)
        self._schedule = Schedule()
        self._windows: list[Window] = []
        self._stuck: dict[int, tuple[int, int]] = {}
        self._refused: BaseException | None = None
        self._reset_cause: str | None = None
        self._anchor = 0, 0
        self._clock = 16e6
        self.powered = True
        self.halted = False
        self.exception = 0
        #: Resets so far: time [ns] and cause.
        self.resets: list[tuple[int, str]] = []
        #: Exceptions of the processor so far: time [ns] and what happened.
        self.exceptions: list[tuple[int, str]] = []
        self._build_memory(flash, flash_base, check_alignment)
        self._build_peripherals(bit_rates, watchdog_by_hardware)
        self.reset("power")

    # -- for tests ----------------------------------------------------------------------------

    @property
    def time(self) -> int:
        """Since the power came [ns]."""
        base, count = self._anchor
        return base + int((self._pace.state.count - count) * self._count_time)

    @property
    def flash(self) -> bytes:
        """Content of the flash memory."""
        return bytes(self._flash)

    @property
    def uart(self) -> Usart:
        """The serial port that is enabled; LookupError unless it is exactly one."""
        enabled = [port for port in self.uarts.values() if port.values["CR1"] & 1]
        if len(enabled) != 1:
            raise LookupError(f"{len(enabled)} serial ports are enabled")
        return enabled[0]

    def run_until(self, time: int) -> None:
        """Run the firmware up to a time [ns], and by a few instructions more.

        Raises ChipFault for what the firmware does wrong, as soon as it does.
        """
        while self.time < time:
            while action := self._schedule.take(self.time):
                action()
                self._settle()
            due = self._schedule.next()
            self._advance(time if due is None else min(due, time))
            self._settle()
        while action := self._schedule.take(self.time):
            action()
            self._settle()

    def run_for(self, duration: int) -> None:
        """Run for a duration [ns]."""
        self.run_until(self.time + duration)

    def reset(self, cause: str = "pin") -> None:
        """Reset the chip: "power", "pin", "software", "watchdog" and others of rcc.CAUSES."""
        self.rcc.note_reset(cause)
        self._reset_cause = None
        if cause == "power":
            self.powered = True
            self._lose_ram()
        for peripheral in self._in_order:
            peripheral.reset()
        self.resets.append((self.time, cause))
        self.exception = 0
        self.halted = False
        self.clocks_changed()
        self._start()

    def power_cut(self) -> None:
        """The power goes: RAM is lost, and what the flash was busy with is done half.

        Time goes on; the chip starts again by reset("power").
        """
        for peripheral in self._in_order:
            peripheral.reset()
        self._lose_ram()
        self.powered = False

    def stick(self, address: int, mask: int, value: int) -> None:
        """These bits of a register are read as `value` from now on; mask 0 ends that."""
        self._stuck[address] = mask, value & mask
        self._forget_word(address)

    def bus_read(self, address: int, size: int = 4) -> int:
        """What a debugger reads."""
        if peripheral := self._peripheral(address):
            return peripheral.read(address, size)[0] & (1 << 8 * size) - 1
        return int.from_bytes(self._emulator.mem_read(address, size), "little")

    def bus_write(self, address: int, value: int, size: int = 4) -> None:
        """What a debugger writes."""
        if flash_memory.BASE <= address < flash_memory.BASE + flash_memory.SIZE:
            self.flash_controller.program(address, size, value)
        elif peripheral := self._peripheral(address):
            peripheral.write(address, size, value)
            self._settle()
        else:
            self._emulator.mem_write(address, value.to_bytes(size, "little"))
            self.code_changed(address, size)

    def register(self, name: str) -> int:
        """Value of a register of the processor: "pc", "sp", "lr", "r0" to "r3", "r12"."""
        value: int = self._emulator.reg_read(REGISTERS[name])
        return value

    # -- for peripherals ----------------------------------------------------------------------

    def at(self, time: int, action: Action) -> Event:
        """Do something at a time [ns]."""
        event = self._schedule.add(time, action)
        self._limit(time)
        return event

    def after(self, delay: int, action: Action) -> Event:
        """Do something after a delay [ns]."""
        return self.at(self.time + delay, action)

    def forget(self, address: int, size: int) -> None:
        """Registers may have changed."""
        for window in self._windows:
            if window.base <= address < window.base + window.size:
                window.forget(address, min(size, window.base + window.size - address))

    def code_changed(self, address: int, size: int) -> None:
        """Instructions may have changed."""
        self._emulator.ctl_remove_cache(address & ~3, (address + size + 3) & ~3)

    def request_reset(self, cause: str) -> None:
        """Reset as soon as the processor has stopped."""
        self._reset_cause = self._reset_cause or cause
        self._pace.state.limit = 0

    def set_floating(self, enabled: bool) -> None:
        """The floating-point unit goes on or off."""
        self._pace.state.floating = int(enabled)

    def counted(self, number: int) -> int:
        """What a counter of the compiled part shows."""
        return self._pace.counted(number)

    def set_counter(self, number: int, value: int, rate: float, period: int, top: int = 0) -> None:
        """Let a counter stand at a value now; `rate` [Hz], zero to stand still."""
        step = Fraction(rate / self._clock).limit_denominator(1 << 20) * CYCLES
        count = self._pace.state.count
        self._pace.state.counters[number] = Counter(
            count, value, step.numerator, step.denominator, period, top
        )

    def clocks_changed(self) -> None:
        """The clock tree, the voltage or the wait states are others; ChipFault where that fails."""
        hclk = self.rcc.hclk
        self.flash_controller.check_clock(hclk)
        if hclk != self._clock:
            self._anchor = self.time, self._pace.state.count
            self._set_clock(hclk)
            self.rcc.note_clock()
        for follower in self._followers:
            follower()

    # -- inside -------------------------------------------------------------------------------

    def _set_clock(self, hclk: float) -> None:
        self._clock = hclk
        self._count_time = float(CYCLES) * 1e9 / hclk

    def _build_memory(self, flash: bytes, base: int, check_alignment: bool) -> None:
        emulator: Any = Uc(UC_ARCH_ARM, UC_MODE_THUMB)
        emulator.ctl_set_cpu_model(UC_CPU_ARM_CORTEX_M4)
        if emulator.ctl_get_cpu_model() != UC_CPU_ARM_CORTEX_M4:
            raise RuntimeError("Unicorn emulates no Cortex-M4")
        self._emulator = emulator
        offset = base - flash_memory.BASE
        if not 0 <= offset <= flash_memory.SIZE - len(flash):
            raise ValueError(f"{len(flash)} bytes at {base:#x} are not within the flash memory")
        content = (ctypes.c_ubyte * flash_memory.SIZE)()
        self._flash = memoryview(content).cast("B")
        self._flash[:] = b"\xff" * flash_memory.SIZE
        self._flash[offset : offset + len(flash)] = flash
        self._ram = (ctypes.c_ubyte * RAM_SIZE)()
        only_read = UC_PROT_READ | UC_PROT_EXEC
        emulator.mem_map_ptr(flash_memory.BASE, flash_memory.SIZE, only_read, content)
        emulator.mem_map_ptr(RAM, RAM_SIZE, 7, self._ram)
        close = (ctypes.c_ubyte * CLOSE_SIZE).from_buffer(self._ram, CLOSE_PART)
        emulator.mem_map_ptr(CLOSE, CLOSE_SIZE, 7, close)
        self._pace = Pace(emulator, self._ask, self._tell)
        self._set_clock(self.hsi)
        self._windows = [self._pace.open_window(*window) for window in WINDOWS]
        emulator.hook_add(UC_HOOK_MEM_INVALID, self._invalid)
        emulator.hook_add(UC_HOOK_INTR, self._interrupted)
        if check_alignment:
            self._pace.watch_alignment(RAM, RAM + RAM_SIZE - 1)

    def _build_peripherals(self, bit_rates: tuple[float, ...], watchdog_by_hardware: bool) -> None:
        self._followers: list[Callable[[], None]] = []
        self._in_order: list[Peripheral] = []
        self.peripherals: dict[str, Peripheral] = {}
        self._pages: dict[int, Peripheral] = {}
        self.rcc = self._add(Rcc(self))
        self.pwr = self._add(Pwr(self))
        self.flash_controller = self._add(FlashController(self, self._flash, watchdog_by_hardware))
        self.system = self._add(SystemControl(self, 6))
        self.trace = self._add(Trace(self, 7))
        self.gpio = {port: self._add(Gpio(self, port)) for port in "ABCDEFG"}
        self.watchdog = self._add(Iwdg(self))
        self._add(Crc(self))
        for more in (Debug(self), Syscfg(self), Identity(self)):
            self._add(more)
        self.timers = {number: self._add(self._timer(number)) for number in range(2, 8)}
        self.uarts = {name: self._add(Usart(self, name, *place)) for name, place in UARTS.items()}
        self.buses = [Bus(self, number, rate) for number, rate in enumerate(bit_rates)]
        self.message_rams = [self._add(MessageRam(self, number)) for number in (1, 2, 3)]
        self.fdcan: list[Fdcan] = []
        for number in (1, 2, 3):
            node = Fdcan(self, number, self.buses[number - 1], self.message_rams[number - 1])
            self.fdcan.append(self._add(node))
        followers = self.timers, self.uarts, dict(enumerate(self.fdcan))
        for group in followers:
            self._followers += [member.clocks_changed for member in group.values()]
        self._followers += [self.system.clocks_changed, self.trace.cycles.clocks_changed]

    def _timer(self, number: int) -> Timer:
        bits = 32 if number in (2, 5) else 16
        base = 0x40000000 + 0x400 * (number - 2)
        return Timer(self, f"TIM{number}", base, number - 2, number - 2, bits)

    def _add(self, peripheral: Kind) -> Kind:
        self.peripherals[peripheral.name] = peripheral
        self._in_order.append(peripheral)
        if not isinstance(peripheral, MessageRam):
            for page in range(peripheral.base >> 10, (peripheral.base + peripheral.SIZE) >> 10):
                self._pages[page] = peripheral
        return peripheral

    def _peripheral(self, address: int) -> Peripheral | None:
        """Whose register an address is; ChipFault where a peripheral could be and none is."""
        if 0x4000A400 <= address < 0x4000B000:
            number = (address - 0x4000A400) // 0x350
            if number < 3:
                return self.message_rams[number]
            raise ChipFault(address, "SRAMCAN", "outside of the message RAM")
        if peripheral := self._pages.get(address >> 10):
            return peripheral
        if any(base <= address < base + size for base, size in WINDOWS):
            raise ChipFault(address, "bus", "no peripheral of this model is here")
        return None

    def _ask(self, address: int, size: int) -> int:
        """A read that the compiled part cannot answer."""
        try:
            peripheral = self._peripheral(address)
            assert peripheral is not None
            value, kind = peripheral.read(address, size)
            mask, forced = self._stuck.get(address & ~3, (0, 0))
            value = value & ~mask | forced
            if kind == KNOWN or (kind and not mask):
                self._remember(address, value, kind)
            return value & (1 << 8 * size) - 1
        except BaseException as fault:
            self._stop_with(fault)
            return 0

    def _tell(self, address: int, size: int, value: int) -> None:
        """A write to a peripheral."""
        if self._refused or self._reset_cause:
            return
        try:
            peripheral = self._peripheral(address)
            assert peripheral is not None
            peripheral.write(address, size, value)
        except BaseException as fault:
            self._stop_with(fault)

    def _stop_with(self, fault: BaseException) -> None:
        self._refused = self._refused or fault
        self._pace.state.limit = 0

    def _remember(self, address: int, value: int, kind: int) -> None:
        for window in self._windows:
            if window.base <= address < window.base + window.size:
                word = (address - window.base) // 4
                window.values[word] = value
                window.kinds[word] = kind

    def _forget_word(self, address: int) -> None:
        self.forget(address & ~3, 4)

    def _lose_ram(self) -> None:
        content = self._random.randbytes(RAM_SIZE)
        ctypes.memmove(self._ram, content, RAM_SIZE)
        for ram in self.message_rams:
            ram.lose_power()

    def _start(self) -> None:
        """The processor takes its stack and its first instruction from the flash."""
        stack = int.from_bytes(self._flash[0:4], "little")
        first = int.from_bytes(self._flash[4:8], "little")
        emulator = self._emulator
        emulator.ctl_remove_cache(RAM, RAM + RAM_SIZE)
        for register in (UC_ARM_REG_CONTROL, UC_ARM_REG_PRIMASK):
            emulator.reg_write(register, 0)
        emulator.reg_write(UC_ARM_REG_XPSR, 1 << 24)
        emulator.reg_write(UC_ARM_REG_MSP, stack & ~3)
        emulator.reg_write(UC_ARM_REG_SP, stack & ~3)
        emulator.reg_write(UC_ARM_REG_LR, 0xFFFFFFFF)
        self._next = first

    def _limit(self, time: int) -> None:
        """Stop at a time [ns] at the latest."""
        base, count = self._anchor
        limit = count + int((time - base) / self._count_time) + 1
        state = self._pace.state
        state.limit = min(state.limit, max(limit, 0))

    def _advance(self, time: int) -> None:
        """Execute until a time [ns], or less far."""
        if self.halted or not self.powered:
            self._skip(time)
            return
        self._pace.state.limit = 1 << 62
        self._limit(time)
        try:
            self._emulator.emu_start(self._next | 1, FOREVER)
            error = None
        except UcError as caught:
            error = caught
        self._next = self._emulator.reg_read(UC_ARM_REG_PC)
        self._look_into(error)

    def _skip(self, time: int) -> None:
        base, count = self._anchor
        self._pace.state.count = count + int((time - base) / self._count_time) + 1

    def _settle(self) -> None:
        """Raise what was refused; reset when that was asked for."""
        self._take_back()
        if self._refused:
            refused, self._refused = self._refused, None
            raise refused
        if self._reset_cause:
            self.reset(self._reset_cause)

    # -- exceptions of the processor ----------------------------------------------------------

    def _look_into(self, error: UcError | None) -> None:
        """Why the processor stopped, if not for the time."""
        state, trouble, self._trouble = self._pace.state, self._trouble, None
        if self._refused or self._reset_cause:
            return
        if state.wrong:
            no_fpu, place = state.reason == NO_COPROCESSOR, state.wrong
            state.wrong = state.reason = 0
            text = "floating point while CPACR keeps it off" if no_fpu else "unaligned words"
            self._except(place, NO_FPU if no_fpu else UNALIGNED_USE, text)
        elif trouble:
            self._except(*trouble)
        elif error is not None and error.errno != UC_ERR_OK:
            self._undefined()
        elif state.count < state.limit:
            raise ChipFault(self._next, "processor", NO_INTERRUPT)

    def _undefined(self) -> None:
        half = int.from_bytes(self._emulator.mem_read(self._next & ~1, 2), "little")
        if half == 0xBF20:
            self._next += 2  # WFE: an event may always have been there
            return
        self._except(self._next, UNDEFINED, f"undefined instruction {half:#06x}")

    _trouble: tuple[int, int, str] | None = None
    _bad_address = 0

    def _invalid(
        self, _emulator: Any, access: int, address: int, size: int, value: int, _data: Any
    ) -> bool:
        """An access to no memory at all, or a write to the flash."""
        if access == UC_MEM_WRITE_PROT:
            self._store_into_flash(address, size, value & (1 << 8 * size) - 1)
            return True
        place = self._pace.state.place
        fetched = address == self._emulator.reg_read(UC_ARM_REG_PC)
        self._bad_address = address
        error = FETCH_ERROR if fetched else DATA_ERROR | ADDRESS_VALID
        self._trouble = place, error, f"access to {address:#010x}, where nothing is"
        return False

    def _store_into_flash(self, address: int, size: int, value: int) -> None:
        """The controller takes it; what Unicorn writes in spite of that is taken back."""
        self._take_back()
        try:
            self.flash_controller.program(address, size, value)
        except ChipFault as fault:
            self._stop_with(fault)
        offset = address - flash_memory.BASE
        self._written = offset, bytes(self._flash[offset : offset + size])
        self._pace.state.limit = 0

    def _take_back(self) -> None:
        if self._written:
            offset, data = self._written
            self._flash[offset : offset + len(data)] = data
            self._written = None

    _written: tuple[int, bytes] | None = None

    def _interrupted(self, emulator: Any, number: int, _data: Any) -> None:
        place = emulator.reg_read(UC_ARM_REG_PC)
        if number == SUPERVISOR_CALL:
            self._trouble = place, 0, "SVC, which this model does not take"
        elif number == BREAKPOINT:
            self._trouble = place, 0, "breakpoint without a debugger"
        elif place >= 0xF0000000:
            self._trouble = place, 0, "return from an exception, which this model does not take"
        else:
            self._trouble = place, STATE, f"exception {number}"
        emulator.emu_stop()

    def _except(self, place: int, status: int, text: str) -> None:
        """An exception: it escalates to the hard fault of the firmware."""
        self.exceptions.append((self.time, f"{text} at {place:#010x}"))
        if self.faults != "take" or self.exception:
            raise ChipFault(place, "processor", text)
        values = self.system.values
        values["CFSR"] |= status
        values["HFSR"] |= FORCED if status else BY_DEBUG
        if status & ADDRESS_VALID:
            values["BFAR"] = self._bad_address
        self.system.changed()
        self._enter(place)

    def _enter(self, place: int) -> None:
        """Stack a basic frame and go on at the vector."""
        emulator = self._emulator
        state = emulator.reg_read(UC_ARM_REG_XPSR)
        stack = emulator.reg_read(UC_ARM_REG_SP)
        moved = stack & 4
        stack = (stack & ~7) - 32
        words = [emulator.reg_read(register) for register in STACKED]
        words += [emulator.reg_read(UC_ARM_REG_LR), place & ~1, state | 1 << 24 | moved << 7]
        if not RAM <= stack <= RAM + RAM_SIZE - 32:
            raise ChipFault(stack, "processor", "lockup: the stack is outside of the RAM")
        emulator.mem_write(stack, b"".join(word.to_bytes(4, "little") for word in words))
        emulator.reg_write(UC_ARM_REG_SP, stack)
        emulator.reg_write(UC_ARM_REG_LR, EXCEPTION_RETURN)
        emulator.reg_write(UC_ARM_REG_XPSR, 1 << 24 | HARD_FAULT)
        self.exception = HARD_FAULT
        table = self.system.values["VTOR"] or flash_memory.BASE
        vector = int.from_bytes(emulator.mem_read(table + 4 * HARD_FAULT, 4), "little")
        self._next = vector


REGISTERS = {
    "pc": UC_ARM_REG_PC,
    "sp": UC_ARM_REG_SP,
    "lr": UC_ARM_REG_LR,
    "r0": UC_ARM_REG_R0,
    "r1": UC_ARM_REG_R1,
    "r2": UC_ARM_REG_R2,
    "r3": UC_ARM_REG_R3,
    "r12": UC_ARM_REG_R12,
}
#: Serial ports: address, clock, and the place of the bits that choose the kernel clock.
UARTS: dict[str, tuple[int, tuple[str, int], int]] = {
    "USART1": (0x40013800, ("APB2ENR", 14), 0),
    "USART2": (0x40004400, ("APB1ENR1", 17), 2),
    "USART3": (0x40004800, ("APB1ENR1", 18), 4),
    "UART4": (0x40004C00, ("APB1ENR1", 19), 6),
    "UART5": (0x40005000, ("APB1ENR1", 20), 8),
    "LPUART1": (0x40008000, ("APB1ENR2", 0), 10),
}
