"""Timers that count up."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from stm32g474.pace import FIRST_COUNTER
from stm32g474.peripheral import Access, Peripheral, Register, Registers
from stm32g474.schedule import Event

if TYPE_CHECKING:
    from stm32g474.chip import Chip

ENABLE, NO_UPDATE, ONLY_OVERFLOW, ONE_PULSE, PRELOAD = 1, 2, 4, 8, 0x80


class Timer(Peripheral):
    """A timer as a counter: prescaler, auto-reload and the update flag; no channels."""

    REGISTERS: ClassVar[Registers] = {
        "CR1": Register(0x00, 0x1BFF),
        "CR2": Register(0x04, 0x020000F8),
        "SMCR": Register(0x08, 0x0337FFF7),
        "DIER": Register(0x0C, 0x00F07F5F),
        "SR": Register(0x10, 0x00F31EFF, access=Access.STROBE),
        "EGR": Register(0x14, 0x5F, access=Access.STROBE),
        "CNT": Register(0x24),
        "PSC": Register(0x28, 0xFFFF),
        "ARR": Register(0x2C),
    }

    def __init__(self, chip: Chip, name: str, base: int, bit: int, counter: int, bits: int) -> None:
        """`counter`: its number in the compiled part; `bits`: the width of its counter."""
        self.counter, self.width = counter, (1 << bits) - 1
        self._prescaler = 0
        self._reload = self.width
        self._overflow: Event | None = None
        super().__init__(chip, name, base, ("APB1ENR1", bit))

    def reset(self) -> None:
        if self._overflow:
            self._overflow.cancel()
        super().reset()
        self.values["ARR"] = self._reload = self.width
        self._prescaler = 0
        self._set(0)

    @property
    def frequency(self) -> float:
        """Clock before the prescaler [Hz]: twice that of the bus when the bus is divided."""
        rcc = self.chip.rcc
        return rcc.pclk1 if rcc.pclk1 == rcc.hclk else 2 * rcc.pclk1

    @property
    def running(self) -> bool:
        """Whether it counts."""
        return bool(self.values["CR1"] & ENABLE)

    def clocks_changed(self) -> None:
        """It goes on from where it is with another clock."""
        self._set(self.now())

    def now(self) -> int:
        """What the counter shows."""
        return self.chip.counted(self.counter)

    def _set(self, value: int) -> None:
        """Let it stand at a value now and go on from there."""
        rate = self.frequency / (self._prescaler + 1) if self.running else 0.0
        self.chip.set_counter(self.counter, value, rate, self._reload + 1)
        if self._overflow:
            self._overflow.cancel()
            self._overflow = None
        if rate:
            self._wait(self.chip.time + (self._reload + 1 - value) * 1e9 / rate, rate)
        self.changed()

    def _wait(self, due: float, rate: float) -> None:
        """The counter overflows at a time [ns], and then again after each period."""

        def overflow() -> None:
            self.values["SR"] |= 0 if self.values["CR1"] & NO_UPDATE else 1
            stops = self.values["CR1"] & ONE_PULSE
            self.values["CR1"] &= ~ENABLE if stops else ~0
            fresh = self._prescaler, self._reload
            self._take_over()
            if stops or fresh != (self._prescaler, self._reload):
                self._set(0)
            else:
                self._wait(due + (self._reload + 1) * 1e9 / rate, rate)
            self.changed()

        self._overflow = self.chip.at(int(due), overflow)

    def _take_over(self) -> None:
        """An update: what was written for later counts from here on."""
        if not self.values["CR1"] & NO_UPDATE:
            self._prescaler = self.values["PSC"]
            self._reload = self.values["ARR"]

    def kind_of(self, key: str) -> int:
        return FIRST_COUNTER + self.counter if key == "CNT" else super().kind_of(key)

    def read_CNT(self) -> int:
        return self.now()

    def read_SR(self) -> int:
        return self.values["SR"]

    def write_CR1(self, value: int) -> None:
        if value & ~(ENABLE | NO_UPDATE | ONLY_OVERFLOW | ONE_PULSE | PRELOAD):
            raise self.refuse("CR1", "only counting up is part of this model")
        at = self.now()
        self.values["CR1"] = value
        self._set(at)

    def write_CR2(self, value: int) -> None:
        self._unused("CR2", value)

    def write_SMCR(self, value: int) -> None:
        self._unused("SMCR", value)

    def write_DIER(self, value: int) -> None:
        self._unused("DIER", value)

    def _unused(self, name: str, value: int) -> None:
        if value:
            raise self.refuse(name, "interrupts, channels and triggers are not part of this model")

    def write_SR(self, value: int) -> None:
        """Zeros clear."""
        self.values["SR"] &= value

    def write_EGR(self, value: int) -> None:
        if value & ~1:
            raise self.refuse("EGR", "only UG is part of this model")
        if value & 1:
            self._take_over()
            if not self.values["CR1"] & (ONLY_OVERFLOW | NO_UPDATE):
                self.values["SR"] |= 1
            self._set(0)

    def write_CNT(self, value: int) -> None:
        if value > self.width:
            raise self.refuse("CNT", "wider than the counter")
        self._set(value)

    def write_ARR(self, value: int) -> None:
        if not 0 < value <= self.width:
            raise self.refuse("ARR", f"{value:#x} does not count or is wider than the counter")
        at = self.now()
        self.values["ARR"] = value
        if not self.values["CR1"] & PRELOAD:
            self._reload = value
            if at > value:
                raise self.refuse("ARR", f"the counter is at {at}, beyond: it runs to its end")
            self._set(at)
