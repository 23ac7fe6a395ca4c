"""A simulated STM32G474 for tests of its drivers, written from public facts alone.

It is strict: what the real chip would ignore, answer wrongly or never recover from raises a
ChipFault. What it does not model it refuses, so no test passes by accident.

Facts are from the reference manual RM0440, the data sheet, the manual of Bosch's M_CAN, ARMv7-M
and the vendor's register header, which differs from stm32-data in one bit: R1MODE of PWR_CR5 is
bit 8. Modelled: the Cortex-M4F with its faults, vectors and guards of memory; flash with its
controller; RCC, PWR, GPIO, IWDG, TIM2 to 7 counting up, SysTick, DWT_CYCCNT, USART1 to 3, UART4
and 5, LPUART1, CRC, backup registers, the three FDCAN in classic mode, and what a debugger reads
and writes. Not modelled, and refused: interrupts, DMA, CAN FD, the test modes of FDCAN, low power.

Not seen: an unaligned access of several words in flash or the close memory, wait states of single
accesses (an instruction takes 1.5 clocks and an access to a peripheral 4.5 more), the freezing of
timers by a debugger.
"""

from stm32g474.bus import Bus, Sent
from stm32g474.chip import Chip
from stm32g474.fault import ChipFault
from stm32g474.frame import Frame

__all__ = ["Bus", "Chip", "ChipFault", "Frame", "Sent"]
