"""A simulated STM32G474 for tests of its drivers, written from public facts alone.

It is strict: what the real chip would ignore, answer wrongly or never recover from raises a
ChipFault. What it does not model it refuses, so no test passes by accident.
"""

from stm32g474.bus import Bus, Sent
from stm32g474.chip import Chip
from stm32g474.fault import ChipFault
from stm32g474.frame import Frame

__all__ = ["Bus", "Chip", "ChipFault", "Frame", "Sent"]
