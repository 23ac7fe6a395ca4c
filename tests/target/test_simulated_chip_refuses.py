"""The simulated chip refuses what the real one would ignore, answer wrongly or never recover from.

Each piece of firmware stands beside its right form, which runs without a word: what is refused is
the wrong use and not the use.
"""

import pytest
from compiled_firmware import image
from stm32g474 import Chip, ChipFault

MILLISECOND = 1_000_000
CLOCK = "clock_170();"
PINS = CLOCK + "can_pins();"
CONFIGURED = PINS + "can_configure(1, ONE_MEGABIT, QUEUE, 0);"
STARTED = CONFIGURED + "can_start(1); wait_us(20);"
SERIAL = CLOCK + (
    "RCC(RCC_AHB2ENR) |= 1; RCC(RCC_APB1ENR1) |= 1U << 17; (void)RCC(RCC_APB1ENR1);"
    "GPIO(0, 0x20) = 7U << 8 | 7U << 12; GPIO(0, 0) = 0xABFFFFAFU; USART2(0x0C) = 1476;"
)
WATCHDOG = "IWDG(0) = 0xCCCC; IWDG(0) = 0x5555;"
FLASH_OPEN = "FLASH(8) = 0x45670123U; FLASH(8) = 0xCDEF89ABU;"

#: The register refused, words of the reason, the wrong use, and the right one.
WRONG: dict[str, tuple[str, str, str, str]] = {
    "a controller without its clock": (
        "FDCAN1_CCCR",
        "clock is off",
        CLOCK + "CAN(1, CCCR) = 1;",
        PINS + "CAN(1, CCCR) = 1;",
    ),
    "message RAM without its clock": (
        "SRAMCAN1",
        "clock is off",
        CLOCK + "RAM(1, 0) = 0;",
        PINS + "RAM(1, 0) = 0;",
    ),
    "a port without its clock": (
        "GPIOA_MODER",
        "clock is off",
        "GPIO(0, 0) = 0;",
        "RCC(RCC_AHB2ENR) |= 1; (void)RCC(RCC_AHB2ENR); GPIO(0, 0) = 0xABFFFFFFU;",
    ),
    "a timer without its clock": (
        "TIM5_CR1",
        "clock is off",
        "TIM5(0) = 1;",
        "RCC(RCC_APB1ENR1) |= 8; (void)RCC(RCC_APB1ENR1); TIM5(0) = 1;",
    ),
    "power control without its clock": (
        "PWR_CR5",
        "clock is off",
        "PWR(PWR_CR5) = 0;",
        "RCC(RCC_APB1ENR1) |= 1U << 28; (void)RCC(RCC_APB1ENR1); PWR(PWR_CR5) = 0;",
    ),
    "bit timing without CCE": (
        "FDCAN1_NBTP",
        "without INIT and CCE",
        PINS + "CAN(1, CCCR) = 1; CAN(1, NBTP) = ONE_MEGABIT;",
        PINS + "CAN(1, CCCR) = 3; CAN(1, NBTP) = ONE_MEGABIT;",
    ),
    "filters while it works": (
        "FDCAN1_RXGFC",
        "without INIT and CCE",
        STARTED + "CAN(1, RXGFC) = 0;",
        CONFIGURED + "CAN(1, RXGFC) = 0;",
    ),
    "CCE before INIT is read back": (
        "FDCAN1_CCCR",
        "before INIT is read back",
        STARTED + "CAN(1, CCCR) |= 1; CAN(1, CCCR) |= 3;",
        STARTED + "CAN(1, CCCR) |= 1; while (!(CAN(1, CCCR) & 1)) { } CAN(1, CCCR) |= 3;",
    ),
    "INIT and back at once": (
        "FDCAN1_CCCR",
        "before its last value was read back",
        STARTED + "CAN(1, CCCR) = 1; CAN(1, CCCR) = 0;",
        STARTED + "CAN(1, CCCR) = 1; while (!(CAN(1, CCCR) & 1)) { } CAN(1, CCCR) = 0;",
    ),
    "no automatic retransmission without CCE": (
        "FDCAN1_CCCR",
        "without INIT and CCE",
        PINS + "CAN(1, CCCR) = 1U << 6 | 1;",
        PINS + "CAN(1, CCCR) = 3; CAN(1, CCCR) = 1U << 6 | 3;",
    ),
    "a controller without a kernel clock": (
        "FDCAN1_CCCR",
        "kernel clock is off",
        "RCC(RCC_APB1ENR1) |= 1U << 25; (void)RCC(RCC_APB1ENR1); CAN(1, CCCR) = 3;",
        PINS + "CAN(1, CCCR) = 3;",
    ),
    "a kernel clock faster than the bus": (
        "FDCAN1_CCCR",
        "faster than the bus clock",
        CONFIGURED + "RCC(RCC_PLLCFGR) |= 1U << 20; RCC(RCC_CCIPR) = 1U << 24;"
        "RCC(RCC_CFGR) |= 4U << 8; can_start(1);",
        CONFIGURED + "RCC(RCC_PLLCFGR) |= 1U << 20; RCC(RCC_CCIPR) = 1U << 24; can_start(1);",
    ),
    "a kernel clock that is reserved": (
        "RCC_CCIPR",
        "reserved",
        "RCC(RCC_CCIPR) = 3U << 24;",
        "RCC(RCC_CCIPR) = 2U << 24;",
    ),
    "no pin for sending": (
        "FDCAN1",
        "TX is on no pin",
        CONFIGURED + "GPIO(0, 0) |= 3U << 24; can_start(1);",
        CONFIGURED + "can_start(1);",
    ),
    "the wrong function of a pin": (
        "FDCAN1",
        "RX is on no pin",
        CONFIGURED + "GPIO(0, 0x24) = (GPIO(0, 0x24) & ~0xF000U) | 8U << 12; can_start(1);",
        CONFIGURED + "can_start(1);",
    ),
    "a pin taken away from a controller at work": (
        "FDCAN1",
        "TX is on no pin",
        STARTED + "GPIO(0, 0) |= 3U << 24;",
        STARTED + "GPIO(0, 0) |= 3U << 2;",
    ),
    "two pins for one signal": (
        "FDCAN1",
        "RX is on PA11 and PB8",
        CONFIGURED
        + "GPIO(1, 0x24) |= 9U; GPIO(1, 0) = (GPIO(1, 0) & ~(3U << 16)) | 2U << 16; can_start(1);",
        CONFIGURED + "can_start(1);",
    ),
    "a jump width longer than its segment": (
        "FDCAN1_NBTP",
        "jump width",
        CONFIGURED + "CAN(1, NBTP) = 2U << 25 | 9U << 16 | 13U << 8 | 1U; can_start(1);",
        CONFIGURED + "can_start(1);",
    ),
    "bytes into the message RAM": (
        "SRAMCAN1",
        "words only",
        CONFIGURED + "*(uint8_t volatile *)0x4000A680U = 1;",
        CONFIGURED + "RAM(1, 0x280) = 1;",
    ),
    "beyond the message RAM": (
        "SRAMCAN",
        "outside of the message RAM",
        CONFIGURED + "RAM(3, 0x350) = 1;",
        CONFIGURED + "RAM(3, 0x34C) = 1;",
    ),
    "half a word of a register": (
        "FDCAN1_IR",
        "2 bytes instead of a word",
        CONFIGURED + "*(uint16_t volatile *)0x40006450U = 1;",
        CONFIGURED + "CAN(1, IR) = 1;",
    ),
    "a register that is not there": (
        "FDCAN1_+0x8c",
        "no register",
        CONFIGURED + "REPORT[0] = CAN(1, 0x8C);",
        CONFIGURED + "REPORT[0] = CAN(1, 0x88);",
    ),
    "a status that is only read": (
        "FDCAN1_PSR",
        "only read",
        CONFIGURED + "CAN(1, PSR) = 0;",
        CONFIGURED + "(void)CAN(1, PSR);",
    ),
    "reserved bits": (
        "PWR_CR5",
        "reserved bits changed: 0",
        "RCC(RCC_APB1ENR1) |= 1U << 28; (void)RCC(RCC_APB1ENR1); PWR(PWR_CR5) |= 1;",
        "RCC(RCC_APB1ENR1) |= 1U << 28; (void)RCC(RCC_APB1ENR1); PWR(PWR_CR5) |= 0x100;",
    ),
    "a request that is pending already": (
        "FDCAN1_TXBAR",
        "pending already",
        STARTED + "can_put(1, 0, 1, 0, 0, 0); CAN(1, TXBAR) = 1;",
        STARTED + "can_put(1, 0, 1, 0, 0, 0); can_put(1, 1, 1, 0, 0, 0);",
    ),
    "a buffer whose frame is pending": (
        "SRAMCAN1+0x278",
        "while its frame is pending",
        STARTED + "can_put(1, 0, 1, 0, 0, 0); RAM(1, TX) = 0;",
        STARTED + "can_put(1, 0, 1, 0, 0, 0); RAM(1, TX + 72) = 0;",
    ),
    "a FIFO in another order": (
        "FDCAN1_TXBAR",
        "put index is 0",
        STARTED.replace("QUEUE", "0") + "can_put(1, 1, 1, 0, 0, 0);",
        STARTED.replace("QUEUE", "0") + "can_put(1, 0, 1, 0, 0, 0);",
    ),
    "a fourth request to a FIFO": (
        "FDCAN1_TXBAR",
        "pending already",
        STARTED.replace("QUEUE", "0") + "for (uint32_t i = 0; i < 3; i++) {"
        "can_put(1, i, 1, 0, 0, 0); } CAN(1, TXBAR) = 1;",
        STARTED.replace("QUEUE", "0") + "for (uint32_t i = 0; i < 3; i++) {"
        "can_put(1, i, 1, 0, 0, 0); } wait_us(80); CAN(1, TXBAR) = 1;",
    ),
    "a request while CCE is set": (
        "FDCAN1_TXBAR",
        "while CCE is set",
        CONFIGURED + "can_put(1, 0, 1, 0, 0, 0);",
        STARTED + "can_put(1, 0, 1, 0, 0, 0);",
    ),
    "an identifier at bit 0": (
        "SRAMCAN1+0x278",
        "starts at bit 18",
        STARTED + "RAM(1, TX) = 0x201; RAM(1, TX + 4) = 0; CAN(1, TXBAR) = 1;",
        STARTED + "RAM(1, TX) = 0x201U << 18; RAM(1, TX + 4) = 0; CAN(1, TXBAR) = 1;",
    ),
    "a frame of CAN FD": (
        "SRAMCAN1+0x278",
        "without FD operation",
        STARTED + "RAM(1, TX) = 0; RAM(1, TX + 4) = 1U << 21; CAN(1, TXBAR) = 1;",
        STARTED + "RAM(1, TX) = 0; RAM(1, TX + 4) = 1U << 23; CAN(1, TXBAR) = 1;",
    ),
    "nine bytes": (
        "SRAMCAN1+0x278",
        "length code 9",
        STARTED + "can_put(1, 0, 1, 9, 0, 0);",
        STARTED + "can_put(1, 0, 1, 8, 0, 0);",
    ),
    "an element that was given back": (
        "SRAMCAN1+0xb0",
        "is not filled",
        STARTED + "REPORT[0] = RAM(1, RX0);",
        CONFIGURED + "REPORT[0] = RAM(1, RX0);",
    ),
    "giving back what is not there": (
        "FDCAN1_RXF0A",
        "not in the FIFO",
        STARTED + "CAN(1, RXF0A) = 0;",
        STARTED + "REPORT[0] = CAN(1, RXF0S);",
    ),
    "too many filters": (
        "FDCAN1_RXGFC",
        "28 standard filters",
        CONFIGURED + "CAN(1, RXGFC) = 29U << 16;",
        CONFIGURED + "CAN(1, RXGFC) = 28U << 16;",
    ),
    "the divider in another controller": (
        "FDCAN2_CKDIV",
        "only FDCAN1",
        CONFIGURED + "can_configure(2, ONE_MEGABIT, QUEUE, 0); CAN(2, 0x100) = 0;",
        CONFIGURED + "CAN(1, 0x100) = 0;",
    ),
    "a PLL beyond its range": (
        "RCC_PLLCFGR",
        "outside",
        "RCC(RCC_PLLCFGR) = 2U | 127U << 8 | 1U << 24; RCC(RCC_CR) |= 1U << 24;",
        "RCC(RCC_PLLCFGR) = 2U | 3U << 4 | 80U << 8 | 1U << 24; RCC(RCC_CR) |= 1U << 24;",
    ),
    "a PLL changed while it is on": (
        "RCC_PLLCFGR",
        "while the PLL is on",
        CLOCK + "RCC(RCC_PLLCFGR) = 3U | 5U << 4 | 80U << 8 | 1U << 24;",
        CLOCK + "RCC(RCC_PLLCFGR) |= 1U << 20;",
    ),
    "a source that is not ready": (
        "RCC_CFGR",
        "not ready",
        "RCC(RCC_CR) |= 1U << 16; RCC(RCC_CFGR) = 2;",
        "RCC(RCC_CR) |= 1U << 16; while (!(RCC(RCC_CR) >> 17 & 1)) { } RCC(RCC_CFGR) = 2;",
    ),
    "the source that is used is switched off": (
        "RCC_CR",
        "runs from it",
        "RCC(RCC_CR) &= ~(1U << 8);",
        CLOCK + "RCC(RCC_CR) &= ~(1U << 8);",
    ),
    "too few wait states": (
        "FLASH_ACR",
        "needs 4 wait states",
        CLOCK + "FLASH(0) = (FLASH(0) & ~15U) | 3;",
        CLOCK + "FLASH(0) = (FLASH(0) & ~15U) | 5;",
    ),
    "170 MHz without boost": (
        "PWR_CR5",
        "at most 150 MHz",
        CLOCK + "PWR(PWR_CR5) |= 1U << 8;",
        CLOCK + "PWR(PWR_CR5) &= ~(1U << 8);",
    ),
    "170 MHz in the low range": (
        "PWR_CR5",
        "at most 26 MHz",
        CLOCK + "PWR(PWR_CR1) = 2U << 9;",
        CLOCK + "PWR(PWR_CR1) = 1U << 9;",
    ),
    "170 MHz in one step": (
        "RCC_CFGR",
        "AHB prescaler at 1",
        CLOCK + "RCC(RCC_CFGR) = 2; RCC(RCC_CFGR) = 3;",
        CLOCK + "RCC(RCC_CFGR) = 2; RCC(RCC_CFGR) = 3 | 8U << 4; wait_us(1); wait_us(1);"
        "RCC(RCC_CFGR) = 3;",
    ),
    "a step that is left too soon": (
        "RCC_CFGR",
        "a microsecond",
        CLOCK + "RCC(RCC_CFGR) = 2; RCC(RCC_CFGR) = 3 | 8U << 4; RCC(RCC_CFGR) = 3;",
        CLOCK + "RCC(RCC_CFGR) = 2; RCC(RCC_CFGR) = 3 | 8U << 4;",
    ),
    "the watchdog without its key": (
        "IWDG_RLR",
        "without the key",
        "IWDG(0) = 0xCCCC; IWDG(8) = 100;",
        WATCHDOG + "IWDG(8) = 100;",
    ),
    "a word that is no key": ("IWDG_KR", "no key", "IWDG(0) = 0xAAAB;", "IWDG(0) = 0xAAAA;"),
    "a watchdog register before it has arrived": (
        "IWDG_PR",
        "before the last value",
        WATCHDOG + "IWDG(4) = 1; REPORT[0] = IWDG(4);",
        WATCHDOG + "IWDG(4) = 1; while (IWDG(12)) { } REPORT[0] = IWDG(4);",
    ),
    "a serial port without a pin": (
        "USART2",
        "RX is on no pin",
        SERIAL + "GPIO(0, 0) = 0xABFFFFFFU; USART2(0) = 13;",
        SERIAL + "USART2(0) = 13;",
    ),
    "a serial port without a divider": (
        "USART2_BRR",
        "below 16",
        SERIAL + "USART2(0x0C) = 0; USART2(0) = 13;",
        SERIAL + "USART2(0) = 13;",
    ),
    "a divider while the port is on": (
        "USART2_BRR",
        "while UE is clear",
        SERIAL + "USART2(0) = 13; USART2(0x0C) = 100;",
        SERIAL + "USART2(0) = 13; USART2(0) = 0; USART2(0x0C) = 100;",
    ),
    "a byte into a full port": (
        "USART2_TDR",
        "a byte is lost",
        SERIAL + "USART2(0) = 13; for (int i = 0; i < 3; i++) { USART2(0x28) = 1; }",
        SERIAL + "USART2(0) = 13; for (int i = 0; i < 3; i++) {"
        "while (!(USART2(0x1C) & 0x80)) { } USART2(0x28) = 1; }",
    ),
    "a byte that has not come": (
        "USART2_RDR",
        "nothing was received",
        SERIAL + "USART2(0) = 13; REPORT[0] = USART2(0x24);",
        SERIAL + "USART2(0) = 13; REPORT[0] = USART2(0x1C);",
    ),
    "the flash without its keys": (
        "FLASH_CR",
        "locked",
        "FLASH(0x14) = 1;",
        FLASH_OPEN + "FLASH(0x14) = 1;",
    ),
    "a wrong key": (
        "FLASH_KEYR",
        "until the next reset",
        "FLASH(8) = 0x45670124U;",
        FLASH_OPEN,
    ),
    "a store into the flash": (
        "flash",
        "without PG",
        "*(uint32_t volatile *)0x08040000U = 1;",
        "*(uint32_t volatile *)0x20008000U = 1;",
    ),
    "writing what is not erased": (
        "flash",
        "not erased",
        FLASH_OPEN + "FLASH(0x14) = 1; *(uint32_t volatile *)0x08000000U = 1;"
        "*(uint32_t volatile *)0x08000004U = 1;",
        FLASH_OPEN + "FLASH(0x14) = 1; *(uint32_t volatile *)0x08040000U = 1;"
        "*(uint32_t volatile *)0x08040004U = 1;",
    ),
    "a reset without its key": (
        "SCS_AIRCR",
        "without the key",
        "SCB(0x0C) = 4;",
        "SCB(0x0C) = 0x05FA0000U;",
    ),
    "an interrupt": (
        "SCS_NVIC_ISER0",
        "not part of this model",
        "REGISTER(0xE000E100U) = 1U << 21;",
        "REGISTER(0xE000E180U) = 1U << 21;",
    ),
    "a vector table out of line": (
        "SCS_VTOR",
        "multiple of 512",
        "SCB(0x08) = 0x08000080U;",
        "SCB(0x08) = 0x08000200U;",
    ),
    "cycles without the trace unit": (
        "DWT_CTRL",
        "without TRCENA",
        "REPORT[0] = REGISTER(0xE0001004U);",
        "REGISTER(0xE000EDFCU) = 1U << 24; REPORT[0] = REGISTER(0xE0001004U);",
    ),
    "a peripheral that is not modelled": (
        "bus",
        "no peripheral of this model",
        "REGISTER(0x40020000U) = 1;",
        "",
    ),
    "sleep without an interrupt": ("processor", "never wakes up", '__asm volatile("wfi");', ""),
    "a null pointer": (
        "processor",
        "where nothing is",
        "uint32_t volatile *volatile p = 0; REPORT[0] = *p;",
        "uint32_t volatile *volatile p = (uint32_t volatile *)0x08000000U; REPORT[0] = *p;",
    ),
    "floating point that is off": (
        "processor",
        "floating point",
        'SCB(0x88) = 0; __asm volatile("vadd.f32 s0, s0, s0");',
        '__asm volatile("vadd.f32 s0, s0, s0");',
    ),
    "unaligned words": (
        "processor",
        "unaligned words",
        '__asm volatile("ldrd r0, r1, [%0]" : : "r"(0x20008001U) : "r0", "r1");',
        '__asm volatile("ldr r0, [%0]" : : "r"(0x20008001U) : "r0");',
    ),
    "an undefined instruction": (
        "processor",
        "undefined instruction",
        '__asm volatile("udf #1");',
        '__asm volatile("nop");',
    ),
}


@pytest.mark.parametrize("use", WRONG)
def test_a_wrong_use_is_refused(use: str) -> None:
    register, reason, wrong, _ = WRONG[use]
    chip = Chip(image(wrong))
    with pytest.raises(ChipFault, match=reason) as refused:
        chip.run_until(8 * MILLISECOND)
    assert refused.value.register.startswith(register)
    assert f"{refused.value.address:#010x}" in str(refused.value)


@pytest.mark.parametrize("use", WRONG)
def test_the_right_use_beside_is_not_refused(use: str) -> None:
    chip = Chip(image(WRONG[use][3]))
    chip.run_until(8 * MILLISECOND)
    assert chip.exceptions == []


def test_a_line_of_another_rate_is_refused() -> None:
    chip = Chip(image(SERIAL + "USART2(0) = 13;"))
    chip.uarts["USART2"].line = 57_600
    with pytest.raises(ChipFault, match="on a line of 57600 bit/s"):
        chip.run_until(8 * MILLISECOND)
    chip = Chip(image(SERIAL + "USART2(0) = 13;"))
    chip.uarts["USART2"].line = 115_200
    chip.run_until(8 * MILLISECOND)
