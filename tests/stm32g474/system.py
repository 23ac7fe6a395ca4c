"""The system control space of the processor: control block, SysTick, protection, debugging."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from stm32g474.pace import ASKED, FIRST_COUNTER, Pace
from stm32g474.peripheral import Access, Peripheral, Register, Registers, row
from stm32g474.processor import BUS, BUS_VALID, HARD, MEMORY, MEMORY_VALID, USAGE, Trouble
from stm32g474.schedule import Event

if TYPE_CHECKING:
    from stm32g474.chip import Chip

VECTOR_KEY, RESET_REQUEST = 0x05FA, 1 << 2
COUNTED = 1 << 16
#: HFSR.
FORCED, BY_DEBUG = 1 << 30, 1 << 31
#: Registers of the processor by their number in DCRSR.
CORE_REGISTERS = {
    **{number: f"r{number}" for number in range(13)},
    13: "sp",
    14: "lr",
    15: "pc",
    16: "xpsr",
    17: "msp",
    18: "psp",
    33: "fpscr",
    **{64 + number: f"s{number}" for number in range(32)},
}
#: Number of four registers of a byte each, and which those are from the lowest.
MASKS, MASK_REGISTERS = 20, ("primask", "basepri", "faultmask", "control")
#: DHCSR.
DEBUGGED, HALT, STEP, STAY_MASKED = 1, 2, 4, 8
READY, HALTED, LOCKED_UP, RETIRED, WAS_RESET = 1 << 16, 1 << 17, 1 << 19, 1 << 24, 1 << 25
#: DFSR.
BREAKPOINT = 2


class SystemControl(Peripheral):
    """SCB, SysTick, NVIC, FPU and MPU: registers without interrupts behind them."""

    SIZE = 0x1000
    REGISTERS: ClassVar[Registers] = {
        "ICTR": Register(0x004, reset=3, access=Access.READ),
        "ACTLR": Register(0x008, 0x00000307),
        "SYST_CSR": Register(0x010, 0x00010007),
        "SYST_RVR": Register(0x014, 0x00FFFFFF),
        "SYST_CVR": Register(0x018),
        "SYST_CALIB": Register(0x01C, access=Access.READ),
        **row("NVIC_ISER", Register(0x100), 4),
        **row("NVIC_ICER", Register(0x180, access=Access.STROBE), 4),
        **row("NVIC_ISPR", Register(0x200), 4),
        **row("NVIC_ICPR", Register(0x280, access=Access.STROBE), 4),
        **row("NVIC_IPR", Register(0x400, narrow=True), 26),
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
        "DCRSR": Register(0xDF4, 0x0001007F, access=Access.WRITE),
        "DCRDR": Register(0xDF8),
        "DEMCR": Register(0xDFC, 0x010F07F1),
        "FPCCR": Register(0xF34, 0xC000017B, 0xC0000000),
        "FPCAR": Register(0xF38, 0xFFFFFFF8),
        "FPDSCR": Register(0xF3C, 0x07C00000),
        "MVFR0": Register(0xF40, reset=0x10110021, access=Access.READ),
        "MVFR1": Register(0xF44, reset=0x11000011, access=Access.READ),
    }

    def __init__(self, chip: Chip, counter: int) -> None:
        self.counter = counter
        self._wrap: Event | None = None
        self._flagged = False
        self._debugger = {"DHCSR": 0, "DEMCR": 0}
        self._was_reset = True
        self._regions: dict[int, tuple[int, int]] = {}
        super().__init__(chip, "SCS", 0xE000E000, None)

    @property
    def _pace(self) -> Pace:
        return self.chip.processor.pace

    def reset(self) -> None:
        """What a debugger has set stays until the power goes."""
        super().reset()
        self.values |= self._debugger
        self._was_reset = True
        self._regions = {}
        self._pace.deny([])
        state = self._pace.state
        state.floating = state.dividing = state.aligning = 0
        self._tick(0)

    def forget_debugger(self) -> None:
        """The power has gone."""
        self._debugger = {"DHCSR": 0, "DEMCR": 0}

    @property
    def halts_at_reset(self) -> bool:
        """A debugger wants the processor to halt before its first instruction."""
        return bool(self._debugger["DHCSR"] & 1 and self._debugger["DEMCR"] & 1)

    # -- SysTick ------------------------------------------------------------------------------

    def kind_of(self, key: str) -> int:
        if key == "SYST_CVR":
            return FIRST_COUNTER + self.counter
        # Reading the flag clears it: what is read next is another value.
        return ASKED if key == "SYST_CSR" and self._flagged else super().kind_of(key)

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
        passed %= period
        self.chip.set_counter(self.counter, passed, rate, period, self._reload)
        if self._wrap:
            self._wrap.cancel()
            self._wrap = None
        if rate:
            # The flag comes with the count zero, a clock before the reload.
            left = (self._reload - passed) % period or period
            self._flag_at(self.chip.time + left * 1e9 / rate, period * 1e9 / rate)
        self.changed()

    def _flag_at(self, due: float, period: float) -> None:
        def flag() -> None:
            self.values["SYST_CSR"] |= COUNTED
            self.changed()
            self._flag_at(due + period, period)

        self._wrap = self.chip.at(int(due), flag)

    def clocks_changed(self) -> None:
        """SysTick goes on with another clock."""
        self._tick(self._reload - self.chip.counted(self.counter))

    def read_SYST_CVR(self) -> int:
        return self.chip.counted(self.counter)

    def read_SYST_CSR(self) -> int:
        value = self.values["SYST_CSR"]
        self._flagged = bool(value & COUNTED)
        self.values["SYST_CSR"] &= ~COUNTED
        return value

    def write_SYST_CSR(self, value: int) -> None:
        if value & 2:
            raise self.refuse("SYST_CSR", "interrupts are not part of this model")
        if value & 1 and not self._reload:
            raise self.refuse("SYST_CSR", "enabled without a reload value: it never counts")
        self.values["SYST_CSR"] = value & 7
        self._tick(self._reload - self.chip.counted(self.counter))

    def write_SYST_RVR(self, value: int) -> None:
        if self.values["SYST_CSR"] & 1:
            raise self.refuse("SYST_RVR", "another reload while it counts: not part of this model")
        self.values["SYST_RVR"] = value

    def write_SYST_CVR(self, _value: int) -> None:
        """Any value sets it to zero, from where it is reloaded at the next clock."""
        self.values["SYST_CSR"] &= ~COUNTED
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
        self._pace.state.floating = int(both == 0xF)

    def write_CCR(self, value: int) -> None:
        self.values["CCR"] = value
        self._pace.state.aligning = value >> 3 & 1
        self._pace.state.dividing = value >> 4 & 1

    def note_exception(self, trouble: Trouble) -> int:
        """Flags and address of an exception; its number: escalated unless it is enabled."""
        values = self.values
        values["CFSR"] |= trouble.status
        if trouble.status & BUS_VALID:
            values["BFAR"] = trouble.address
        if trouble.status & MEMORY_VALID:
            values["MMFAR"] = trouble.address
        enabled = {MEMORY: 16, BUS: 17, USAGE: 18}.get(trouble.exception)
        taken = trouble.exception
        if enabled is None or not values["SHCSR"] >> enabled & 1:
            values["HFSR"] |= FORCED if trouble.status else BY_DEBUG
            taken = HARD
        self.changed()
        return taken

    # -- protection ---------------------------------------------------------------------------

    def write_MPU_RBAR(self, value: int) -> None:
        if value & 0x10:
            self.values["MPU_RNR"] = value & 0xF
        self._check_region()
        number = self.values["MPU_RNR"]
        self._regions[number] = value & ~0x1F, self._regions.get(number, (0, 0))[1]
        self._protect()

    def write_MPU_RASR(self, value: int) -> None:
        self._check_region()
        number = self.values["MPU_RNR"]
        self._regions[number] = self._regions.get(number, (0, 0))[0], value
        self._protect()

    def read_MPU_RBAR(self) -> int:
        number = self.values["MPU_RNR"]
        return self._regions.get(number, (0, 0))[0] | number

    def read_MPU_RASR(self) -> int:
        return self._regions.get(self.values["MPU_RNR"], (0, 0))[1]

    def write_MPU_CTRL(self, value: int) -> None:
        if value & 1 and not value & 4:
            raise self.refuse("MPU_CTRL", "without PRIVDEFENA nothing is allowed at all")
        self.values["MPU_CTRL"] = value
        self._protect()

    def _check_region(self) -> None:
        if self.values["MPU_RNR"] > 7:
            raise self.refuse("MPU_RNR", "there are eight regions")

    def _protect(self) -> None:
        """Regions that allow nothing are denied; those that allow less than all are refused."""
        denied = []
        for base, control in self._regions.values():
            if not self.values["MPU_CTRL"] & 1 or not control & 1:
                continue
            size, rights = 2 << (control >> 1 & 0x1F), control >> 24 & 7
            if size < 32 or base % size:
                raise self.refuse("MPU_RBAR", f"{base:#010x} is no multiple of the size {size:#x}")
            if control & 0xFF00 or rights not in (0, 1, 3):
                raise self.refuse("MPU_RASR", "parts and other rights are not part of this model")
            if rights == 0:
                denied.append((base, base + size))
        self._pace.deny(denied)

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

    @property
    def is_debugged(self) -> bool:
        """A debugger is there, which BKPT instructions halt for."""
        return bool(self._debugger["DHCSR"] & DEBUGGED)

    def note_breakpoint(self) -> None:
        """The processor has come to a BKPT instruction."""
        self.chip.halted = True
        self._debugger["DHCSR"] |= HALT
        self.values["DHCSR"] |= HALT
        self.values["DFSR"] |= BREAKPOINT
        self.changed()

    def read_DHCSR(self) -> int:
        value = self.values["DHCSR"] & 0xF | READY | (HALTED if self.chip.halted else RETIRED)
        value |= LOCKED_UP if self.chip.locked_up else 0
        value |= WAS_RESET if self._was_reset else 0
        self._was_reset = False
        return value

    def write_DHCSR(self, value: int) -> None:
        """For a debugger only: the processor itself cannot halt."""
        if value >> 16 != 0xA05F:
            raise self.refuse("DHCSR", "written without the key 0xA05F")
        if value & DEBUGGED and value & STEP and not value & HALT:
            raise self.refuse("DHCSR", "single steps are not part of this model")
        self.values["DHCSR"] = self._debugger["DHCSR"] = value & 0xF
        self.chip.halted = value & 3 == 3

    def write_DEMCR(self, value: int) -> None:
        self.values["DEMCR"] = self._debugger["DEMCR"] = value

    def write_DCRSR(self, value: int) -> None:
        if not self.chip.halted:
            raise self.refuse("DCRSR", "used while the processor is not halted")
        if value & 0x7F == MASKS:
            self._transfer_masks(bool(value >> 16 & 1))
            return
        name = CORE_REGISTERS.get(value & 0x7F)
        if name is None:
            raise self.refuse("DCRSR", f"register {value & 0x7F} is not part of this model")
        if value >> 16 & 1:
            self.chip.processor.set_register(name, self.values["DCRDR"])
        elif name == "pc":
            self.values["DCRDR"] = self.chip.processor.place & ~1
        else:
            self.values["DCRDR"] = self.chip.processor.register(name)

    def _transfer_masks(self, written: bool) -> None:
        processor = self.chip.processor
        if written:
            for name, value in zip(
                MASK_REGISTERS, self.values["DCRDR"].to_bytes(4, "little"), strict=True
            ):
                processor.set_register(name, value)
        else:
            masks = bytes(processor.register(name) & 0xFF for name in MASK_REGISTERS)
            self.values["DCRDR"] = int.from_bytes(masks, "little")
