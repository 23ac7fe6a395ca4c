"""Pins: modes, levels, and which alternate function a pin of a peripheral has."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, ClassVar

from stm32g474.fault import ChipFault
from stm32g474.peripheral import WORD, Access, Peripheral, Register, Registers

if TYPE_CHECKING:
    from stm32g474.chip import Chip

HALF = 0xFFFF
#: Pins of peripherals: port, pin and alternate function, by the signal.
Pin = tuple[str, int, int]
PINS: Mapping[str, Mapping[str, Sequence[Pin]]] = {
    "FDCAN1": {
        "RX": (("A", 11, 9), ("B", 8, 9), ("D", 0, 9)),
        "TX": (("A", 12, 9), ("B", 9, 9), ("D", 1, 9)),
    },
    "FDCAN2": {"RX": (("B", 12, 9), ("B", 5, 9)), "TX": (("B", 13, 9), ("B", 6, 9))},
    "FDCAN3": {"RX": (("A", 8, 11), ("B", 3, 11)), "TX": (("A", 15, 11), ("B", 4, 11))},
    "USART1": {
        "RX": (("A", 10, 7), ("B", 7, 7), ("C", 5, 7), ("E", 1, 7)),
        "TX": (("A", 9, 7), ("B", 6, 7), ("C", 4, 7), ("E", 0, 7)),
    },
    "USART2": {
        "RX": (("A", 3, 7), ("A", 15, 7), ("B", 4, 7), ("D", 6, 7)),
        "TX": (("A", 2, 7), ("A", 14, 7), ("B", 3, 7), ("D", 5, 7)),
    },
    "USART3": {
        "RX": (("B", 8, 7), ("B", 11, 7), ("C", 11, 7), ("D", 9, 7), ("E", 15, 7)),
        "TX": (("B", 9, 7), ("B", 10, 7), ("C", 10, 7), ("D", 8, 7)),
    },
    "UART4": {"RX": (("C", 11, 5),), "TX": (("C", 10, 5),)},
    "UART5": {"RX": (("D", 2, 5),), "TX": (("C", 12, 5),)},
    "LPUART1": {
        "RX": (("A", 3, 12), ("B", 10, 8), ("C", 0, 8)),
        "TX": (("A", 2, 12), ("B", 11, 8), ("C", 1, 8)),
    },
}
#: After a reset the pins of the debugger are in use; the others are analogue.
MODES = {"A": 0xABFFFFFF, "B": 0xFFFFFEBF}
PULLS = {"A": 0x64000000, "B": 0x00000100}
SPEEDS = {"A": 0x0C000000, "B": 0x000000C0}


class Gpio(Peripheral):
    """One port."""

    REGISTERS: ClassVar[Registers] = {
        "MODER": Register(0x00),
        "OTYPER": Register(0x04, HALF),
        "OSPEEDR": Register(0x08),
        "PUPDR": Register(0x0C),
        "IDR": Register(0x10, HALF, access=Access.READ, narrow=True),
        "ODR": Register(0x14, HALF, narrow=True),
        "BSRR": Register(0x18, access=Access.STROBE),
        "LCKR": Register(0x1C, 0x1FFFF),
        "AFRL": Register(0x20),
        "AFRH": Register(0x24),
        "BRR": Register(0x28, HALF, access=Access.STROBE),
    }

    def __init__(self, chip: Chip, port: str) -> None:
        self.port = port
        #: Levels that come from outside, by pin; the others are low.
        self.inputs: dict[int, bool] = {}
        base = 0x48000000 + 0x400 * "ABCDEFG".index(port)
        super().__init__(chip, f"GPIO{port}", base, ("AHB2ENR", "ABCDEFG".index(port)))

    def reset(self) -> None:
        super().reset()
        self.values["MODER"] = MODES.get(self.port, WORD)
        self.values["PUPDR"] = PULLS.get(self.port, 0)
        self.values["OSPEEDR"] = SPEEDS.get(self.port, 0)

    def mode(self, pin: int) -> int:
        """0 input, 1 output, 2 alternate function, 3 analogue."""
        return self.values["MODER"] >> 2 * pin & 3

    def function(self, pin: int) -> int:
        """Number of the alternate function."""
        return self.values["AFRL" if pin < 8 else "AFRH"] >> 4 * (pin % 8) & 0xF

    def level(self, pin: int) -> bool:
        """What the pin shows: driven by the chip, or from outside, or pulled."""
        if self.mode(pin) == 1:
            return bool(self.values["ODR"] >> pin & 1)
        return self.inputs.get(pin, self.values["PUPDR"] >> 2 * pin & 3 == 1)

    def set_input(self, pin: int, level: bool) -> None:
        """Drive a pin from outside."""
        self.inputs[pin] = level
        self.changed()

    def write(self, address: int, size: int, value: int) -> None:
        super().write(address, size, value)
        self.chip.pins_changed()

    def read_IDR(self) -> int:
        return sum(self.level(pin) << pin for pin in range(16) if self.mode(pin) != 3)

    def write_BSRR(self, value: int) -> None:
        self.values["ODR"] = self.values["ODR"] & ~(value >> 16) | value & HALF

    def write_BRR(self, value: int) -> None:
        self.values["ODR"] &= ~value

    def write_LCKR(self, _value: int) -> None:
        raise self.refuse("LCKR", "locked pins are not part of this model")


def need_pins(chip: Chip, peripheral: str, signals: Sequence[str]) -> None:
    """ChipFault unless each signal of a peripheral is on one pin exactly."""
    for signal in signals:
        chosen = [
            f"P{port}{pin}"
            for port, pin, function in PINS[peripheral][signal]
            if chip.gpio[port].mode(pin) == 2 and chip.gpio[port].function(pin) == function
        ]
        if len(chosen) == 1:
            continue
        choice = ", ".join(f"P{port}{pin} AF{af}" for port, pin, af in PINS[peripheral][signal])
        found = " and ".join(chosen) or "no pin"
        address = chip.peripherals[peripheral].base
        reason = f"{signal} is on {found}; its pins are {choice}"
        raise ChipFault(address, peripheral, reason)
