"""What the programmer of a board's flash has to know of its chip."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Chip:
    """A microcontroller as a debugger sees it."""

    name: str
    target: str
    """OpenOCD's own file of it."""
    flash: int
    """Address of its flash."""
    size: int
    """Bytes of that."""
    page: int
    """Bytes that are erased together."""
    memory: int
    """Bytes of RAM."""
    buses: int
    """CAN controllers."""
    identity_register: int
    identity: int
    """Device number in the lowest twelve bits there."""
    size_register: int
    """Tells the kilobytes of flash in its lowest sixteen bits."""
    option_register: int
    """Tells the read protection in its lowest eight bits."""


#: Of the reference manual RM0440: DBGMCU_IDCODE of category 3, FLASHSIZE, FLASH_OPTR.
STM32G474 = Chip(
    "stm32g474",
    "target/stm32g4x.cfg",
    flash=0x08000000,
    size=512 * 1024,
    page=2048,
    memory=128 * 1024,
    buses=3,
    identity_register=0xE0042000,
    identity=0x469,
    size_register=0x1FFF75E0,
    option_register=0x40022020,
)

CHIPS = {chip.name: chip for chip in (STM32G474,)}
