"""The independent watchdog, which runs on its own slow oscillator."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, ClassVar

from stm32g474.peripheral import Access, Peripheral, Register, Registers
from stm32g474.schedule import Event

if TYPE_CHECKING:
    from stm32g474.chip import Chip

START, RELOAD, UNLOCK, LOCK = 0xCCCC, 0xAAAA, 0x5555, 0x0000
#: Clocks of the slow oscillator until a written register has arrived.
UPDATE = 5


class Iwdg(Peripheral):
    """IWDG."""

    REGISTERS: ClassVar[Registers] = {
        "KR": Register(0x00, 0xFFFF, access=Access.WRITE),
        "PR": Register(0x04, 0x7),
        "RLR": Register(0x08, 0xFFF, 0xFFF),
        "SR": Register(0x0C, 0x7, access=Access.READ),
        "WINR": Register(0x10, 0xFFF, 0xFFF),
    }
    FLAGS: ClassVar[Mapping[str, int]] = {"PR": 1, "RLR": 2, "WINR": 4}

    def __init__(self, chip: Chip) -> None:
        self.running = False
        self._unlocked = False
        self._end: Event | None = None
        self._reloaded = 0
        #: What was written and has not arrived: it never does before the watchdog is started.
        self._arriving: set[str] = set()
        super().__init__(chip, "IWDG", 0x40003000, None)

    def reset(self) -> None:
        """Stopped, unless an option starts it with the chip."""
        if self._end:
            self._end.cancel()
        self.running = self._unlocked = False
        self._end = None
        self._arriving = set()
        self._feed_quickly(False)
        super().reset()
        if self.chip.flash_controller.watchdog_by_hardware:
            self._start()

    @property
    def timeout(self) -> int:
        """From a reload to the reset [ns]."""
        clocks = (self.values["RLR"] + 1) * (4 << min(self.values["PR"], 6))
        return int(clocks * 1e9 / self.chip.lsi)

    def note_fed(self) -> None:
        """Reloads that the compiled part has seen alone are known here too."""
        state = self.chip.processor.pace.state
        if state.fed:
            self._reloaded = self.chip.time_of(state.fed)
            self._unlocked = False
            state.fed = 0

    def _feed_quickly(self, quickly: bool) -> None:
        """Reloads need not come here while nothing else can follow from one."""
        state = self.chip.processor.pace.state
        state.feeding, state.food = self.base if quickly else 0, RELOAD

    def write_KR(self, value: int) -> None:
        self.note_fed()
        if value not in (START, RELOAD, UNLOCK, LOCK):
            raise self.refuse("KR", f"{value:#06x} is no key")
        self._unlocked = value == UNLOCK
        if value == START:
            self._start()
        elif value == RELOAD and self.running:
            self._check_window()
            self._reload()

    def write_PR(self, value: int) -> None:
        self._update("PR", value)

    def write_RLR(self, value: int) -> None:
        self._update("RLR", value)

    def write_WINR(self, value: int) -> None:
        self._update("WINR", value)

    def read_PR(self) -> int:
        return self._arrived("PR")

    def read_RLR(self) -> int:
        return self._arrived("RLR")

    def read_WINR(self) -> int:
        return self._arrived("WINR")

    def _start(self) -> None:
        self.running = True
        self._reload()
        for name in self._arriving:
            self._arrive(name)

    def _reload(self) -> None:
        if self._end:
            self._end.cancel()
        self._reloaded = self.chip.time
        self._end = self.chip.after(self.timeout, self._run_out)
        self._feed_quickly(self.values["WINR"] >= self.values["RLR"])

    def _run_out(self) -> None:
        self.note_fed()
        due = self._reloaded + self.timeout
        if self._frozen:
            self._reload()
        elif due > self.chip.time:
            self._end = self.chip.at(due, self._run_out)
        else:
            self.chip.request_reset("watchdog")

    @property
    def _frozen(self) -> bool:
        """A debugger has halted the processor and wants the watchdog to wait."""
        debug = self.chip.peripherals["DBGMCU"].values["APB1FZR1"]
        return self.chip.halted and bool(debug >> 12 & 1)

    def _check_window(self) -> None:
        """A reload before the counter is down at the window resets the chip."""
        window = self.values["WINR"]
        if window >= self.values["RLR"]:
            return
        passed = (self.chip.time - self._reloaded) * self.chip.lsi / 1e9
        if self.values["RLR"] - passed / (4 << min(self.values["PR"], 6)) > window:
            self.chip.request_reset("watchdog")

    def _update(self, name: str, value: int) -> None:
        self.note_fed()
        self._feed_quickly(False)
        if not self._unlocked:
            raise self.refuse(name, "written without the key 0x5555")
        if name in self._arriving:
            raise self.refuse(name, "written again before the last value has arrived (SR)")
        self.values[name] = value
        self.values["SR"] |= self.FLAGS[name]
        self._arriving.add(name)
        if name == "WINR" and self.running:
            self._reload()
        if self.running:
            self._arrive(name)

    def _arrive(self, name: str) -> None:
        def arrived() -> None:
            self._arriving.discard(name)
            self.values["SR"] &= ~self.FLAGS[name]
            self.changed()

        self.chip.after(int(UPDATE * 1e9 / self.chip.lsi), arrived)

    def _arrived(self, name: str) -> int:
        if name in self._arriving:
            raise self.refuse(name, "read before the last value has arrived (SR)")
        return self.values[name]
