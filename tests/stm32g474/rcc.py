"""Reset and clock control: oscillators, PLL, the clock tree, and why the chip was reset."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, ClassVar

from stm32g474.peripheral import Access, Peripheral, Register, Registers
from stm32g474.schedule import Event

if TYPE_CHECKING:
    from stm32g474.chip import Chip

#: Bits of RCC_CSR by the cause of a reset. Resets from inside pull the reset pin too.
POWER, PIN = 1 << 27 | 1 << 26, 1 << 26
CAUSES = {
    "power": POWER,
    "pin": PIN,
    "software": 1 << 28 | PIN,
    "watchdog": 1 << 29 | PIN,
    "window watchdog": 1 << 30 | PIN,
    "option bytes": 1 << 25 | PIN,
    "low power": 1 << 31 | PIN,
}
FLAGS = 0xFE000000

#: Times until an oscillator is ready [ns]: typical values of the data sheet.
HSI_READY, HSE_READY, PLL_READY, LSI_READY, HSI48_READY = 1_000, 2_000_000, 40_000, 130_000, 3_500
#: How long the AHB prescaler has to stay after a step above 80 MHz [ns].
SLOW_STEP = 1_000
HSI_ON, HSI_RDY, HSE_ON, HSE_RDY, HSE_BYPASS = 1 << 8, 1 << 10, 1 << 16, 1 << 17, 1 << 18
PLL_ON, PLL_RDY = 1 << 24, 1 << 25
HSI, HSE, PLL = 1, 2, 3

#: Peripherals that a bit of a reset register resets.
RESETS: Mapping[str, Mapping[int, tuple[str, ...]]] = {
    "AHB1RSTR": {12: ("CRC",)},
    "AHB2RSTR": {bit: (f"GPIO{port}",) for bit, port in enumerate("ABCDEFG")},
    "AHB3RSTR": {},
    "APB1RSTR1": {
        0: ("TIM2",),
        1: ("TIM3",),
        2: ("TIM4",),
        3: ("TIM5",),
        4: ("TIM6",),
        5: ("TIM7",),
        17: ("USART2",),
        18: ("USART3",),
        19: ("UART4",),
        20: ("UART5",),
        25: ("FDCAN1", "FDCAN2", "FDCAN3"),
        28: ("PWR",),
    },
    "APB1RSTR2": {0: ("LPUART1",)},
    "APB2RSTR": {0: ("SYSCFG",), 14: ("USART1",)},
}


def _enables(offset: int, bits: int, reset: int = 0) -> Register:
    return Register(offset, bits, reset)


class Rcc(Peripheral):
    """RCC."""

    REGISTERS: ClassVar[Registers] = {
        "CR": Register(0x00, 0x030F0700, 0x00000500),
        "ICSCR": Register(0x04, 0x7F000000, 0x40000000),
        "CFGR": Register(0x08, 0x7F003FFF, 0x00000005),
        "PLLCFGR": Register(0x0C, 0xFF737FF3, 0x00001000),
        "CIER": Register(0x18, 0x0000063B),
        "CIFR": Register(0x1C, 0x0000073B, access=Access.READ),
        "CICR": Register(0x20, 0x0000073B, access=Access.STROBE),
        "AHB1RSTR": Register(0x28, 0x0000111F),
        "AHB2RSTR": Register(0x2C, 0x050F607F),
        "AHB3RSTR": Register(0x30, 0x00000101),
        "APB1RSTR1": Register(0x38, 0xD2FEC13F),
        "APB1RSTR2": Register(0x3C, 0x00000103),
        "APB2RSTR": Register(0x40, 0x0437F801),
        "AHB1ENR": _enables(0x48, 0x0000111F, 0x00000100),
        "AHB2ENR": _enables(0x4C, 0x050F607F),
        "AHB3ENR": _enables(0x50, 0x00000101),
        "APB1ENR1": _enables(0x58, 0xD2FECD3F, 0x00000400),
        "APB1ENR2": _enables(0x5C, 0x00000103),
        "APB2ENR": _enables(0x60, 0x0437F801),
        "AHB1SMENR": _enables(0x68, 0x0000131F, 0x0000131F),
        "AHB2SMENR": _enables(0x6C, 0x050F667F, 0x050F667F),
        "AHB3SMENR": _enables(0x70, 0x00000101, 0x00000101),
        "APB1SMENR1": _enables(0x78, 0xD2FECD3F, 0xD2FECD3F),
        "APB1SMENR2": _enables(0x7C, 0x00000103, 0x00000103),
        "APB2SMENR": _enables(0x80, 0x0437F801, 0x0437F801),
        "CCIPR": Register(0x88),
        "BDCR": Register(0x90, 0x0301837F),
        "CSR": Register(0x94, 0xFE800003),
        "CRRCR": Register(0x98, 0x0000FF83),
        "CCIPR2": Register(0x9C, 0x00300003),
    }

    def __init__(self, chip: Chip) -> None:
        self._waits: dict[str, Event] = {}
        self._flags = 0
        self._stepped = 0
        super().__init__(chip, "RCC", 0x40021000, None)

    def reset(self) -> None:
        """Back to the internal oscillator; the causes of resets stay."""
        for wait in self._waits.values():
            wait.cancel()
        self._waits = {}
        super().reset()

    def note_reset(self, cause: str) -> None:
        """A reset happened; its flag joins those that were not removed."""
        flags = CAUSES[cause]
        self._flags = flags if cause == "power" else self._flags | flags

    # -- the tree -----------------------------------------------------------------------------

    @property
    def hsi(self) -> float:
        """Frequency of the internal oscillator as this chip has it [Hz]."""
        return self.chip.hsi

    def source(self, selected: int) -> float:
        """Frequency of HSI, HSE or PLL [Hz]; zero while it is not ready."""
        ready = self.values["CR"]
        if selected == HSI:
            return self.hsi if ready & HSI_RDY else 0.0
        if selected == HSE:
            return (self.chip.hse or 0.0) if ready & HSE_RDY else 0.0
        return self._pll_output(24, 25) if selected == PLL else 0.0

    @property
    def pll_q(self) -> float:
        """Frequency of the output Q of the PLL [Hz]; zero while that is off."""
        return self._pll_output(20, 21)

    @property
    def sysclk(self) -> float:
        """System clock [Hz]."""
        return self.source(self.values["CFGR"] >> 2 & 3)

    @property
    def hclk(self) -> float:
        """Clock of the processor and the AHB [Hz]."""
        return self.sysclk / _ahb_divider(self.values["CFGR"] >> 4 & 0xF)

    @property
    def pclk1(self) -> float:
        """Clock of the first peripheral bus [Hz]."""
        return self.hclk / _apb_divider(self.values["CFGR"] >> 8 & 7)

    @property
    def pclk2(self) -> float:
        """Clock of the second peripheral bus [Hz]."""
        return self.hclk / _apb_divider(self.values["CFGR"] >> 11 & 7)

    @property
    def fdcan(self) -> float:
        """Kernel clock of the CAN controllers [Hz]; zero while its source is off."""
        selected = self.values["CCIPR"] >> 24 & 3
        return (self.source(HSE), self.pll_q, self.pclk1, 0.0)[selected]

    def uart(self, shift: int, bus: float) -> float:
        """Kernel clock of a serial port [Hz] by the place of its two bits in CCIPR."""
        selected = self.values["CCIPR"] >> shift & 3
        return (bus, self.sysclk, self.source(HSI), 0.0)[selected]

    def _pll_output(self, enable: int, divider: int) -> float:
        settings = self.values["PLLCFGR"]
        if not self.values["CR"] & PLL_RDY or not settings >> enable & 1:
            return 0.0
        return self._vco() / (2 * ((settings >> divider & 3) + 1))

    def _pll_input(self) -> float:
        settings = self.values["PLLCFGR"]
        origin = {2: HSI, 3: HSE}.get(settings & 3, 0)
        return self.source(origin) / ((settings >> 4 & 0xF) + 1)

    def _vco(self) -> float:
        return self._pll_input() * (self.values["PLLCFGR"] >> 8 & 0x7F)

    # -- registers ----------------------------------------------------------------------------

    def write_CR(self, value: int) -> None:
        before = self.values["CR"]
        self._check_oscillators(before, value)
        self.values["CR"] = value & ~(HSI_RDY | HSE_RDY | PLL_RDY) | before & (
            HSI_RDY | HSE_RDY | PLL_RDY
        )
        self._switch("HSI", HSI_ON, HSI_RDY, HSI_READY)
        self._switch("HSE", HSE_ON, HSE_RDY, HSE_READY if self.chip.hse else None)
        if value & ~before & PLL_ON:
            self._check_pll()
        self._switch("PLL", PLL_ON, PLL_RDY, PLL_READY)
        self.chip.clocks_changed()

    def _check_oscillators(self, before: int, value: int) -> None:
        """What the system runs from cannot be switched off: the chip ignores that."""
        used = self.values["CFGR"] >> 2 & 3
        pll_used = used == PLL
        origin = {2: HSI, 3: HSE}.get(self.values["PLLCFGR"] & 3, 0) if before & PLL_ON else 0
        for name, source, on in (("HSI", HSI, HSI_ON), ("HSE", HSE, HSE_ON)):
            if before & ~value & on and (used == source or (pll_used and origin == source)):
                raise self.refuse("CR", f"{name} is switched off, but the system runs from it")
        if before & ~value & PLL_ON and pll_used:
            raise self.refuse("CR", "the PLL is switched off, but the system runs from it")
        if (before ^ value) & HSE_BYPASS and before & HSE_ON:
            raise self.refuse("CR", "HSEBYP is only written while HSE is off")

    def _check_pll(self) -> None:
        settings = self.values["PLLCFGR"]
        self._within("input of the PLL", self._pll_input(), 2.66e6, 16e6)
        if not 8 <= settings >> 8 & 0x7F <= 127:
            raise self.refuse("PLLCFGR", "PLLN is below 8")
        fast = self.chip.pwr.range == 1
        self._within("VCO of the PLL", self._vco(), 96e6, 344e6 if fast else 128e6)
        for name, enable, divider in (("Q", 20, 21), ("R", 24, 25)):
            if settings >> enable & 1:
                output = self._vco() / (2 * ((settings >> divider & 3) + 1))
                self._within(f"output {name} of the PLL", output, 8e6, 170e6 if fast else 26e6)

    def _within(self, what: str, frequency: float, low: float, high: float) -> None:
        # A clock that is off by its tolerance is still the nominal one.
        if not low * 0.99 <= frequency <= high * 1.011:
            text = f"{what}: {frequency / 1e6:g} MHz is outside {low / 1e6:g} to {high / 1e6:g} MHz"
            raise self.refuse("PLLCFGR", text)

    def _switch(self, name: str, on: int, ready: int, delay: int | None) -> None:
        """Make an oscillator ready after a delay, or never; or unready at once."""
        wanted = bool(self.values["CR"] & on)
        if not wanted:
            self._cancel(name)
            self.values["CR"] &= ~ready
        elif not self.values["CR"] & ready and name not in self._waits and delay is not None:
            self._later(name, delay, "CR", ready)

    def _cancel(self, name: str) -> None:
        if wait := self._waits.pop(name, None):
            wait.cancel()

    def _later(self, name: str, delay: int, register: str, bit: int) -> None:
        def ready() -> None:
            self._waits.pop(name, None)
            self.values[register] |= bit
            self.changed()

        self._waits[name] = self.chip.after(delay, ready)

    def write_PLLCFGR(self, value: int) -> None:
        outputs = 1 << 16 | 1 << 20 | 1 << 24
        if self.values["CR"] & PLL_ON and (value ^ self.values["PLLCFGR"]) & ~outputs:
            raise self.refuse("PLLCFGR", "written while the PLL is on")
        if not value >> 24 & 1 and self.values["CFGR"] >> 2 & 3 == PLL:
            raise self.refuse("PLLCFGR", "output R is switched off, but the system runs from it")
        self.values["PLLCFGR"] = value
        self.chip.clocks_changed()

    def write_CFGR(self, value: int) -> None:
        selected = value & 3
        if not self.source(selected):
            raise self.refuse("CFGR", f"source {selected} of the system clock is not ready")
        divider = _ahb_divider(value >> 4 & 0xF)
        self._check_step(self.hclk, self.source(selected) / divider, divider)
        self.values["CFGR"] = value & ~0xC | selected << 2
        self.chip.clocks_changed()

    def _check_step(self, before: float, after: float, divider: int) -> None:
        """Above 80 MHz the clock is raised in two steps: half of it for a microsecond at least."""
        if divider > 1 or after <= 81e6 or before >= 0.99 * after:
            return
        if before < 0.49 * after:
            text = "the step above 80 MHz is made with the AHB prescaler at 1, not 2"
            raise self.refuse("CFGR", text)
        if self.chip.time - self._stepped < SLOW_STEP:
            raise self.refuse("CFGR", "the AHB prescaler is left before a microsecond has passed")

    def note_clock(self) -> None:
        """The clock of the processor has just changed."""
        self._stepped = self.chip.time

    def write_CICR(self, value: int) -> None:
        self.values["CIFR"] &= ~value

    def read_CSR(self) -> int:
        return self.values["CSR"] | self._flags

    def write_CSR(self, value: int) -> None:
        if value >> 23 & 1:
            self._flags = 0
        self.values["CSR"] = value & 1 | value & 1 << 23 | self.values["CSR"] & 2
        if not value & 1:
            self._cancel("LSI")
            self.values["CSR"] &= ~2
        elif not self.values["CSR"] & 2 and "LSI" not in self._waits:
            self._later("LSI", LSI_READY, "CSR", 2)

    def write_CRRCR(self, value: int) -> None:
        self.values["CRRCR"] = value & 1 | self.values["CRRCR"] & 2
        if not value & 1:
            self._cancel("HSI48")
            self.values["CRRCR"] = 0
        elif not self.values["CRRCR"] & 2 and "HSI48" not in self._waits:
            self._later("HSI48", HSI48_READY, "CRRCR", 2)

    def write_BDCR(self, value: int) -> None:
        if value & 1:
            raise self.refuse("BDCR", "this board has no low-speed crystal: LSE is never ready")
        self.values["BDCR"] = value

    def write_CCIPR(self, value: int) -> None:
        if value >> 24 & 3 == 3:
            raise self.refuse("CCIPR", "FDCANSEL 3 is reserved")
        self.values["CCIPR"] = value
        self.chip.clocks_changed()

    def _reset_peripherals(self, register: str, value: int) -> None:
        for bit in range(32):
            if value >> bit & 1:
                names = RESETS[register].get(bit)
                if names is None:
                    raise self.refuse(register, f"bit {bit} resets what this model does not have")
                for name in names:
                    self.chip.peripherals[name].reset()
        self.values[register] = value

    def write_AHB1RSTR(self, value: int) -> None:
        self._reset_peripherals("AHB1RSTR", value)

    def write_AHB2RSTR(self, value: int) -> None:
        self._reset_peripherals("AHB2RSTR", value)

    def write_AHB3RSTR(self, value: int) -> None:
        self._reset_peripherals("AHB3RSTR", value)

    def write_APB1RSTR1(self, value: int) -> None:
        self._reset_peripherals("APB1RSTR1", value)

    def write_APB1RSTR2(self, value: int) -> None:
        self._reset_peripherals("APB1RSTR2", value)

    def write_APB2RSTR(self, value: int) -> None:
        self._reset_peripherals("APB2RSTR", value)


def _ahb_divider(field: int) -> int:
    return 1 if field < 8 else (2, 4, 8, 16, 64, 128, 256, 512)[field - 8]


def _apb_divider(field: int) -> int:
    return 1 if field < 4 else 2 << (field - 4)
