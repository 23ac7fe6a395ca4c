"""What belongs to the processor: control block, SysTick, trace, debug; and small memories."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from stm32g474.pace import FIRST_COUNTER
from stm32g474.peripheral import WORD, Access, Peripheral, Register, Registers
from stm32g474.timer import Cycles

if TYPE_CHECKING:
    from stm32g474.chip import Chip

VECTOR_KEY, RESET_REQUEST = 0x05FA, 1 << 2
TRACE = 1 << 24


def _row(name: str, offset: int, count: int, **more: object) -> Registers:
    return {
        f"{name}{number}": Register(offset + 4 * number, **more)  # type: ignore[arg-type]
        for number in range(count)
    }


class SystemControl(Peripheral):
    """SCB, SysTick, NVIC, FPU and MPU: registers without interrupts behind them."""

    SIZE = 0x1000
    REGISTERS: ClassVar[Registers] = {
        "ICTR": Register(0x004, reset=3, access=Access.READ),
        "ACTLR": Register(0x008, 0x00000307),
        "SYST_CSR": Register(0x010, 0x00010007, lasting=False),
        "SYST_RVR": Register(0x014, 0x00FFFFFF),
        "SYST_CVR": Register(0x018),
        "SYST_CALIB": Register(0x01C, access=Access.READ),
        **_row("NVIC_ISER", 0x100, 4),
        **_row("NVIC_ICER", 0x180, 4, access=Access.STROBE),
        **_row("NVIC_ISPR", 0x200, 4),
        **_row("NVIC_ICPR", 0x280, 4, access=Access.STROBE),
        **_row("NVIC_IPR", 0x400, 26, narrow=True),
        "CPUID": Register(0xD00, reset=0x410FC241, access=Access.READ),
        "ICSR": Register(0xD04, lasting=False),
        "VTOR": Register(0xD08, 0xFFFFFF80),
        "AIRCR": Register(0xD0C, reset=0xFA050000),
        "SCR": Register(0xD10, 0x16),
        "CCR": Register(0xD14, 0x31B, 0x200),
        "SHPR1": Register(0xD18, narrow=True),
        "SHPR2": Register(0xD1C, narrow=True),
        "SHPR3": Register(0xD20, narrow=True),
        "SHCSR": Register(0xD24, 0x0007FD8B),
        "CFSR": Register(0xD28, access=Access.STROBE, narrow=True),
        "HFSR": Register(0xD2C, access=Access.STROBE),
        "DFSR": Register(0xD30, access=Access.STROBE),
        "MMFAR": Register(0xD34),
        "BFAR": Register(0xD38),
        "AFSR": Register(0xD3C),
        "CPACR": Register(0xD88, 0x00F00000),
        "MPU_TYPE": Register(0xD90, reset=0x800, access=Access.READ),
        "MPU_CTRL": Register(0xD94, 7),
        "MPU_RNR": Register(0xD98, 0xFF),
        "MPU_RBAR": Register(0xD9C),
        "MPU_RASR": Register(0xDA0),
        "DHCSR": Register(0xDF0, lasting=False),
        "DEMCR": Register(0xDFC, 0x010F07F1),
        "FPCCR": Register(0xF34, 0xC000017B, 0xC0000000),
        "FPCAR": Register(0xF38, 0xFFFFFFF8),
        "FPDSCR": Register(0xF3C, 0x07C00000),
        "MVFR0": Register(0xF40, reset=0x10110021, access=Access.READ),
        "MVFR1": Register(0xF44, reset=0x11000011, access=Access.READ),
    }

    def __init__(self, chip: Chip, counter: int) -> None:
        self.counter = counter
        self._looked = 0
        super().__init__(chip, "SCS", 0xE000E000, None)

    def reset(self) -> None:
        super().reset()
        self.chip.set_floating(False)
        self._tick(0)

    # -- SysTick ------------------------------------------------------------------------------

    def kind_of(self, key: str) -> int:
        return FIRST_COUNTER + self.counter if key == "SYST_CVR" else super().kind_of(key)

    @property
    def _reload(self) -> int:
        return self.values["SYST_RVR"] & 0xFFFFFF

    def _rate(self) -> float:
        control = self.values["SYST_CSR"]
        if not control & 1:
            return 0.0
        return self.chip.rcc.hclk if control & 4 else self.chip.rcc.hclk / 8

    def _tick(self, passed: int) -> None:
        """Let SysTick stand at a number of clocks since its reload, and go on."""
        rate, period = self._rate(), self._reload + 1
        self.chip.set_counter(self.counter, passed % period, rate, period, self._reload)
        self._looked = self.chip.time
        self.changed()

    def clocks_changed(self) -> None:
        """SysTick goes on with another clock."""
        self._tick(self._reload - self.chip.counted(self.counter))

    def read_SYST_CVR(self) -> int:
        return self.chip.counted(self.counter)

    def read_SYST_CSR(self) -> int:
        rate = self._rate()
        wrapped = 0
        if rate:
            down = self.chip.counted(self.counter)
            since = (self.chip.time - self._looked) * rate / 1e9
            wrapped = since > self._reload - down
        self._looked = self.chip.time
        return self.values["SYST_CSR"] | bool(wrapped) << 16

    def write_SYST_CSR(self, value: int) -> None:
        if value & 2:
            raise self.refuse("SYST_CSR", "interrupts are not part of this model")
        if value & 1 and not self._reload:
            raise self.refuse("SYST_CSR", "enabled without a reload value: it never counts")
        self.values["SYST_CSR"] = value & 7
        self._tick(0)

    def write_SYST_CVR(self, _value: int) -> None:
        self._tick(0)

    # -- control block ------------------------------------------------------------------------

    def write_AIRCR(self, value: int) -> None:
        if value >> 16 != VECTOR_KEY:
            raise self.refuse("AIRCR", "written without the key 0x05FA")
        if value & RESET_REQUEST:
            self.chip.request_reset("software")
        self.values["AIRCR"] = 0xFA050000 | value & 0x700

    def write_VTOR(self, value: int) -> None:
        if value & 0x1FF:
            raise self.refuse("VTOR", f"{value:#010x} is no multiple of 512, as 118 vectors need")
        self.values["VTOR"] = value

    def write_CPACR(self, value: int) -> None:
        both = value >> 20 & 0xF
        if both not in (0, 0xF):
            raise self.refuse("CPACR", "CP10 and CP11 must be off or full access, both alike")
        self.values["CPACR"] = value
        self.chip.set_floating(both == 0xF)

    def write_MPU_CTRL(self, value: int) -> None:
        if value & 1:
            raise self.refuse("MPU_CTRL", "memory protection is not part of this model")

    def _no_interrupts(self, name: str, value: int) -> None:
        if value:
            raise self.refuse(name, "interrupts are not part of this model")

    def write_NVIC_ISER0(self, value: int) -> None:
        self._no_interrupts("NVIC_ISER0", value)

    def write_NVIC_ISER1(self, value: int) -> None:
        self._no_interrupts("NVIC_ISER1", value)

    def write_NVIC_ISER2(self, value: int) -> None:
        self._no_interrupts("NVIC_ISER2", value)

    def write_NVIC_ISER3(self, value: int) -> None:
        self._no_interrupts("NVIC_ISER3", value)

    def read_CFSR(self) -> int:
        return self.values["CFSR"]

    def write_CFSR(self, value: int) -> None:
        self.values["CFSR"] &= ~value

    def read_HFSR(self) -> int:
        return self.values["HFSR"]

    def write_HFSR(self, value: int) -> None:
        self.values["HFSR"] &= ~value

    def read_DFSR(self) -> int:
        return self.values["DFSR"]

    def write_DFSR(self, value: int) -> None:
        self.values["DFSR"] &= ~value

    def read_ICSR(self) -> int:
        return self.chip.exception

    def read_DHCSR(self) -> int:
        return self.values["DHCSR"] & 0xF | self.chip.halted << 17 | 1 << 16

    def write_DHCSR(self, value: int) -> None:
        """For a debugger only: the processor itself cannot halt."""
        if value >> 16 != 0xA05F:
            raise self.refuse("DHCSR", "written without the key 0xA05F")
        self.values["DHCSR"] = value & 0xF
        self.chip.halted = value & 3 == 3

    def write_DEMCR(self, value: int) -> None:
        self.values["DEMCR"] = value


class Trace(Peripheral):
    """DWT: the counter of cycles."""

    SIZE = 0x1000
    REGISTERS: ClassVar[Registers] = {
        "CTRL": Register(0x000, reset=0x40000000),
        "CYCCNT": Register(0x004),
        "CPICNT": Register(0x008),
        "EXCCNT": Register(0x00C),
        "SLEEPCNT": Register(0x010),
        "LSUCNT": Register(0x014),
        "FOLDCNT": Register(0x018),
    }

    def __init__(self, chip: Chip, counter: int) -> None:
        self.cycles = Cycles(chip, counter)
        super().__init__(chip, "DWT", 0xE0001000, None)

    def reset(self) -> None:
        super().reset()
        self.cycles.running = False
        self.cycles.set(0)

    def need_clock(self, address: int) -> None:
        if not self.chip.system.values["DEMCR"] & TRACE:
            raise self.refuse("CTRL", "used without TRCENA in DEMCR")

    def kind_of(self, key: str) -> int:
        return FIRST_COUNTER + self.cycles.counter if key == "CYCCNT" else super().kind_of(key)

    def read_CYCCNT(self) -> int:
        return self.chip.counted(self.cycles.counter)

    def write_CYCCNT(self, value: int) -> None:
        self.cycles.set(value & WORD)

    def write_CTRL(self, value: int) -> None:
        if value & ~1 & 0x0FFFFFFF:
            raise self.refuse("CTRL", "only the counter of cycles is part of this model")
        at = self.chip.counted(self.cycles.counter)
        self.values["CTRL"] = value & 1 | 0x40000000
        self.cycles.running = bool(value & 1)
        self.cycles.set(at)


class Debug(Peripheral):
    """DBGMCU: which chip this is, and what stops while a debugger halts it."""

    REGISTERS: ClassVar[Registers] = {
        "IDCODE": Register(0x00, reset=0x20030469, access=Access.READ),
        "CR": Register(0x04, 0xE7),
        "APB1FZR1": Register(0x08, 0xC0601C3F),
        "APB1FZR2": Register(0x0C, 0x2),
        "APB2FZ": Register(0x10, 0x04172800),
    }

    def __init__(self, chip: Chip) -> None:
        super().__init__(chip, "DBGMCU", 0xE0042000, None)


class Syscfg(Peripheral):
    """SYSCFG."""

    REGISTERS: ClassVar[Registers] = {
        "MEMRMP": Register(0x00, 0x107),
        "CFGR1": Register(0x04, 0xFCFF0300, 0x7C000000),
        **_row("EXTICR", 0x08, 4, bits=0x7777),
        "SCSR": Register(0x18, 0x3),
        "CFGR2": Register(0x1C, 0x10F),
        "SWPR": Register(0x20),
        "SKR": Register(0x24, 0xFF, access=Access.WRITE),
    }

    def __init__(self, chip: Chip) -> None:
        super().__init__(chip, "SYSCFG", 0x40010000, ("APB2ENR", 0))

    def write_MEMRMP(self, value: int) -> None:
        if value:
            raise self.refuse("MEMRMP", "another memory at address zero is not part of this model")


class Identity(Peripheral):
    """Read-only facts of the chip: its number and the size of its flash."""

    SIZE = 0x10000
    REGISTERS: ClassVar[Registers] = {
        **_row("UID", 0x7590, 3, reset=0x00C0FFEE, access=Access.READ),
        "FLASHSIZE": Register(0x75E0, reset=0xFFFF0200, access=Access.READ, narrow=True),
    }

    def __init__(self, chip: Chip) -> None:
        super().__init__(chip, "SYSTEM", 0x1FFF0000, None)
