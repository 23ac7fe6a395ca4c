"""A simulated STM32G474 that runs firmware: processor, memories, peripherals and time."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from random import Random
from typing import TypeVar

from stm32g474 import flash as flash_memory
from stm32g474.bus import Bus
from stm32g474.crc import Crc
from stm32g474.debug import Breakpoints, Debug, Trace
from stm32g474.fault import ChipFault
from stm32g474.fdcan import Fdcan
from stm32g474.flash import FlashController
from stm32g474.gpio import Gpio
from stm32g474.identity import Identity, Syscfg
from stm32g474.message_ram import MessageRam
from stm32g474.pace import KNOWN, Counter
from stm32g474.peripheral import Peripheral
from stm32g474.power import Pwr
from stm32g474.processor import Processor, Trouble
from stm32g474.rcc import Rcc
from stm32g474.schedule import Action, Event, Schedule
from stm32g474.system import SystemControl
from stm32g474.tamp import Tamp
from stm32g474.timer import Timer
from stm32g474.usart import Usart
from stm32g474.watchdog import Iwdg

Kind = TypeVar("Kind", bound=Peripheral)

#: Clocks that an instruction takes: flash that keeps up mostly, branches, loads and divisions.
CYCLES = Fraction(3, 2)
#: Where peripherals can be.
WINDOWS = (
    (0x1FFF0000, 0x10000),
    (0x40000000, 0x30000),
    (0x48000000, 0x2000),
    (0x50000000, 0x61000),
    (0xE0000000, 0x100000),
)
MESSAGE_RAM = range(0x4000A400, 0x4000B000)
#: Serial ports: address, clock, and the place of the bits that choose the kernel clock.
UARTS: dict[str, tuple[int, tuple[str, int], int]] = {
    "USART1": (0x40013800, ("APB2ENR", 14), 0),
    "USART2": (0x40004400, ("APB1ENR1", 17), 2),
    "USART3": (0x40004800, ("APB1ENR1", 18), 4),
    "UART4": (0x40004C00, ("APB1ENR1", 19), 6),
    "UART5": (0x40005000, ("APB1ENR1", 20), 8),
    "LPUART1": (0x40008000, ("APB1ENR2", 0), 10),
}


class Chip:
    """An STM32G474xE on a board: three CAN buses, serial lines, a crystal.

    `faults` tells what an exception of the processor does: "raise" a ChipFault, or "take" it by
    the handler of the firmware.
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
        `check_alignment`: accesses to RAM are watched, which takes about a third of the speed.
        ValueError for a flash that does not fit.
        """
        offset = flash_base - flash_memory.BASE
        if not 0 <= offset <= flash_memory.SIZE - len(flash):
            raise ValueError(f"{len(flash)} bytes at {flash_base:#x} are not within the flash")
        self.hse, self.hsi, self.lsi, self.faults = hse, hsi, lsi, faults
        self._random = Random(seed)
        self._schedule = Schedule()
        self._stuck: dict[int, tuple[int, int]] = {}
        self._refused: BaseException | None = None
        self._reset_cause: str | None = None
        self.powered = True
        self.halted = False
        #: An exception within an exception has stopped the processor until the next reset.
        self.locked_up = False
        #: Number of the exception that is being handled.
        self.exception = 0
        #: Resets so far: time [ns] and cause.
        self.resets: list[tuple[int, str]] = []
        #: Exceptions of the processor so far: time [ns] and what happened.
        self.exceptions: list[tuple[int, str]] = []
        self.processor = Processor(self._ask, self._tell, self._program, check_alignment)
        self.processor.flash[:] = b"\xff" * flash_memory.SIZE
        self.processor.flash[offset : offset + len(flash)] = flash
        self._state = self.processor.pace.state
        self._anchor = 0, 0
        self._due: int | None = None
        self._set_clock(hsi)
        self._windows = [self.processor.pace.open_window(*window) for window in WINDOWS]
        self._build(bit_rates, watchdog_by_hardware)
        self.reset("power")

    # -- for tests ----------------------------------------------------------------------------

    @property
    def time(self) -> int:
        """Since the chip was made [ns]; while something happens, when it was due."""
        return self._executed if self._due is None else self._due

    @property
    def _executed(self) -> int:
        """How far the processor is, which is by a few instructions more."""
        return self.time_of(self._state.count)

    @property
    def flash(self) -> bytes:
        """Content of the flash memory."""
        return bytes(self.processor.flash)

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
            self._do_what_is_due()
            due = self._schedule.next()
            self._advance(time if due is None else min(due, time))
            self._settle()
        self._do_what_is_due()

    def run_for(self, duration: int) -> None:
        """Run for a duration [ns]."""
        self.run_until(self.time + duration)

    def reset(self, cause: str = "pin") -> None:
        """Reset the chip: "power", "pin", "software", "watchdog" and others of rcc.CAUSES."""
        self.rcc.note_reset(cause)
        self._reset_cause = None
        if cause == "power":
            self.powered = True
            self.system.forget_debugger()
            self._lose_ram()
        for peripheral in self._in_order:
            peripheral.reset()
        self.resets.append((self.time, cause))
        self.exception = 0
        self.locked_up = False
        self.halted = self.system.halts_at_reset
        self.clocks_changed()
        self.processor.start()

    def power_cut(self) -> None:
        """The power goes: RAM is lost, and what the flash was busy with is done half.

        Time goes on; the chip starts again by reset("power").
        """
        for peripheral in self._in_order:
            peripheral.reset()
        self.tamp.lose_power()
        self._lose_ram()
        self.powered = False

    def stick(self, address: int, mask: int, value: int) -> None:
        """These bits of a register are read as `value` from now on; mask 0 ends that."""
        self._stuck[address] = mask, value & mask
        self.forgetting(address & ~3, 4)()

    def bus_read(self, address: int, size: int = 4) -> int:
        """What a debugger reads; ChipFault as for the firmware, and for a flash that is locked."""
        self._refuse_locked(address)
        if peripheral := self._peripheral(address):
            return peripheral.read(address, size)[0] & (1 << 8 * size) - 1
        return self.processor.read(address, size)

    def bus_write(self, address: int, value: int, size: int = 4) -> None:
        """What a debugger writes; ChipFault as for the firmware, and for a flash that is locked."""
        self._refuse_locked(address)
        if flash_memory.BASE <= address < flash_memory.BASE + flash_memory.SIZE:
            self.flash_controller.program(address, size, value)
        elif peripheral := self._peripheral(address):
            peripheral.write(address, size, value)
            self._settle()
        else:
            self.processor.write(address, size, value)

    def _refuse_locked(self, address: int) -> None:
        in_flash = flash_memory.BASE <= address < flash_memory.BASE + flash_memory.SIZE
        if in_flash and self.flash_controller.read_protection != flash_memory.OPEN:
            raise ChipFault(address, "flash", "read protection keeps debuggers out")

    # -- for peripherals ----------------------------------------------------------------------

    def at(self, time: int, action: Action) -> Event:
        """Do something at a time [ns]."""
        event = self._schedule.add(time, action)
        self._limit(time)
        return event

    def after(self, delay: int, action: Action) -> Event:
        """Do something after a delay [ns]."""
        return self.at(self.time + delay, action)

    def forgetting(self, address: int, size: int) -> Callable[[], object]:
        """What is called when these registers may have changed."""
        for window in self._windows:
            if window.base <= address < window.base + window.size:
                return window.forgetting(address, min(size, window.base + window.size - address))
        raise ValueError(f"{address:#x} is no address of a peripheral")

    def time_of(self, count: int) -> int:
        """When the count of instructions was this, with the clock as it is now [ns]."""
        base, anchor = self._anchor
        return base + int((count - anchor) * self._count_time)

    def request_reset(self, cause: str) -> None:
        """Reset as soon as the processor has stopped."""
        self._reset_cause = self._reset_cause or cause
        self._state.limit = 0

    def counted(self, number: int) -> int:
        """What a counter of the compiled part shows."""
        return self.processor.pace.counted(number)

    def set_counter(self, number: int, value: int, rate: float, period: int, top: int = 0) -> None:
        """Let a counter stand at a value now; `rate` [Hz], zero to stand still."""
        step = Fraction(rate / self._clock).limit_denominator(1 << 20) * CYCLES
        fraction = step.numerator, step.denominator
        self._state.counters[number] = Counter(self._state.count, value, *fraction, period, top)

    def pins_changed(self) -> None:
        """Pins have another mode or function; ChipFault where one is in use."""
        for node in self.fdcan:
            node.check_pins()
        for port in self.uarts.values():
            port.check_pins()

    def clocks_changed(self) -> None:
        """The clock tree, the voltage or the wait states are others; ChipFault where that fails."""
        hclk = self.rcc.hclk
        self.flash_controller.check_clock(hclk)
        if hclk != self._clock:
            self.watchdog.note_fed()
            self._anchor = self._executed, self._state.count
            self._set_clock(hclk)
            self.rcc.note_clock()
        for follower in self._followers:
            follower()

    # -- parts --------------------------------------------------------------------------------

    def _build(self, bit_rates: tuple[float, ...], watchdog_by_hardware: bool) -> None:
        self._in_order: list[Peripheral] = []
        self.peripherals: dict[str, Peripheral] = {}
        self._pages: dict[int, Peripheral] = {}
        self.rcc = self._add(Rcc(self))
        self.pwr = self._add(Pwr(self))
        flash = self.processor.flash
        self.flash_controller = self._add(FlashController(self, flash, watchdog_by_hardware))
        self.system = self._add(SystemControl(self, 6))
        self.trace = self._add(Trace(self, 7))
        self.gpio = {port: self._add(Gpio(self, port)) for port in "ABCDEFG"}
        self.watchdog = self._add(Iwdg(self))
        self.tamp = self._add(Tamp(self))
        for more in (Crc(self), Breakpoints(self), Debug(self), Syscfg(self), Identity(self)):
            self._add(more)
        self.timers = {number: self._add(self._timer(number)) for number in range(2, 8)}
        self.uarts = {name: self._add(Usart(self, name, *place)) for name, place in UARTS.items()}
        self.buses = [Bus(self, number, rate) for number, rate in enumerate(bit_rates)]
        self.message_rams = [self._add(MessageRam(self, number)) for number in (1, 2, 3)]
        self.fdcan: list[Fdcan] = []
        for number, bus, ram in zip((1, 2, 3), self.buses, self.message_rams, strict=True):
            self.fdcan.append(self._add(Fdcan(self, number, bus, ram)))
        self._followers: list[Callable[[], None]] = [
            *(timer.clocks_changed for timer in self.timers.values()),
            *(port.clocks_changed for port in self.uarts.values()),
            *(node.clocks_changed for node in self.fdcan),
            self.system.clocks_changed,
            self.trace.clocks_changed,
        ]

    def _timer(self, number: int) -> Timer:
        bits = 32 if number in (2, 5) else 16
        base = 0x40000000 + 0x400 * (number - 2)
        return Timer(self, f"TIM{number}", base, number - 2, number - 2, bits)

    def _add(self, peripheral: Kind) -> Kind:
        self.peripherals[peripheral.name] = peripheral
        self._in_order.append(peripheral)
        if peripheral.base not in MESSAGE_RAM:
            for page in range(peripheral.base >> 10, (peripheral.base + peripheral.SIZE) >> 10):
                self._pages[page] = peripheral
        return peripheral

    def _peripheral(self, address: int) -> Peripheral | None:
        """Whose register an address is; ChipFault where a peripheral could be and none is."""
        if address in MESSAGE_RAM:
            return self._message_ram(address)
        if peripheral := self._pages.get(address >> 10):
            return peripheral
        if any(base <= address < base + size for base, size in WINDOWS):
            raise ChipFault(address, "bus", "no peripheral of this model is here")
        return None

    def _message_ram(self, address: int) -> MessageRam:
        number = (address - MESSAGE_RAM.start) // MessageRam.SIZE
        if number >= len(self.message_rams):
            raise ChipFault(address, "SRAMCAN", "outside of the message RAM")
        return self.message_rams[number]

    # -- what the processor asks and tells ----------------------------------------------------

    def _ask(self, address: int, size: int) -> int:
        """A read that the compiled part cannot answer."""
        try:
            return self._answer(address, size)
        except BaseException as fault:
            self._stop_with(fault)
            return 0

    def _answer(self, address: int, size: int) -> int:
        peripheral = self._peripheral(address)
        assert peripheral is not None
        value, kind = peripheral.read(address, size)
        mask, forced = self._stuck.get(address & ~3, (0, 0))
        value = value & ~mask | forced
        if kind == KNOWN or (kind and not mask):
            self._remember(address, value, kind)
        return value & (1 << 8 * size) - 1

    def _remember(self, address: int, value: int, kind: int) -> None:
        for window in self._windows:
            if window.base <= address < window.base + window.size:
                word = (address - window.base) // 4
                window.values[word], window.kinds[word] = value, kind

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

    def _program(self, address: int, size: int, value: int) -> None:
        """A store into the flash."""
        try:
            self.flash_controller.program(address, size, value)
        except ChipFault as fault:
            self._stop_with(fault)

    def _stop_with(self, fault: BaseException) -> None:
        """To be raised when the processor has stopped: not through compiled code."""
        self._refused = self._refused or fault
        self._state.limit = 0

    # -- time ---------------------------------------------------------------------------------

    def _set_clock(self, hclk: float) -> None:
        self._clock = hclk
        self._count_time = float(CYCLES) * 1e9 / hclk

    def _count_at(self, time: int) -> int:
        """The count of instructions just after a time [ns]."""
        base, count = self._anchor
        return max(0, count + int((time - base) / self._count_time) + 1)

    def _limit(self, time: int) -> None:
        """Stop at a time [ns] at the latest."""
        self._state.limit = min(self._state.limit, self._count_at(time))

    def _do_what_is_due(self) -> None:
        while event := self._schedule.take(self._executed):
            self._due, action = event
            try:
                action()
            finally:
                self._due = None
            self._settle()

    def _advance(self, time: int) -> None:
        """Execute until a time [ns], or less far."""
        self._state.limit = self._count_at(time)
        if self.halted or self.locked_up or not self.powered:
            self._state.count = self._state.limit
            return
        trouble = self.processor.run()
        if trouble and not self._refused and not self._reset_cause:
            self._except(trouble)

    def _settle(self) -> None:
        """Raise what was refused; reset when that was asked for."""
        self.processor.take_back()
        if self._refused:
            refused, self._refused = self._refused, None
            raise refused
        if self._reset_cause:
            self.reset(self._reset_cause)

    # -- exceptions and loss of power ---------------------------------------------------------

    def _except(self, trouble: Trouble) -> None:
        """An exception of the processor: raised, or taken by the firmware unless it is in one."""
        if trouble.breakpoint and self.system.is_debugged:
            self.system.note_breakpoint()
            return
        if trouble.returning and self.exception:
            text = "return from an exception: not part of this model"
            raise ChipFault(trouble.place, "processor", text)
        self.exceptions.append((self.time, f"{trouble.text} at {trouble.place:#010x}"))
        if self.faults != "take" or not trouble.exception:
            raise ChipFault(trouble.place, "processor", trouble.text)
        if self.exception:
            self.locked_up = True
            return
        self.exception = self.system.note_exception(trouble)
        table = self.system.values["VTOR"] or flash_memory.BASE
        self.locked_up = not self.processor.enter(self.exception, trouble.place, table)

    def _lose_ram(self) -> None:
        self.processor.lose_ram(self._random)
        for ram in self.message_rams:
            ram.lose_power()
