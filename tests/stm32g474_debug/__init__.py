"""The JTAG pins of the simulated STM32G474, for OpenOCD's adapter remote_bitbang.

What OpenOCD programs is in the flash of the simulated chip, which runs it afterwards; OpenOCD's
own flash loader runs on the simulated processor too. Facts are from the Arm Debug Interface
Architecture Specification ADIv5, IEEE 1149.1 and OpenOCD's manual; Debian's OpenOCD has no SWD
for this adapter.
"""

from stm32g474_debug.server import DebugServer

__all__ = ["DebugServer"]
