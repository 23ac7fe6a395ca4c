"""The processor, the memories, the clocks and the time of the simulated chip."""

import subprocess
from itertools import pairwise
from random import Random

import pytest
from compiled_firmware import image, report
from stm32g474 import Chip
from stm32g474.pace import SOURCE

MICROSECOND, MILLISECOND = 1_000, 1_000_000
KEYS = (0x45670123, 0xCDEF89AB)
KEYR, SR, CR = 0x40022008, 0x40022010, 0x40022014
PAGE = 0x08040000


STRICT = ("-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", "-fsyntax-only")


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_the_compiled_part_compiles_without_a_warning(compiler: str) -> None:
    subprocess.run([compiler, *STRICT, str(SOURCE)], check=True)


def test_the_timer_and_the_chip_agree_on_the_time() -> None:
    chip = Chip(image("clock_170(); wait_us(1); for (;;) { REPORT[0] = TIM2(0x24); }"))
    chip.run_until(5 * MILLISECOND)
    before, begin = report(chip, 0), chip.time
    chip.run_for(100 * MILLISECOND)
    assert report(chip, 0) - before == pytest.approx((chip.time - begin) / 1000, abs=2)


@pytest.mark.parametrize(
    ("settings", "system", "for_can"),
    [
        # crystal / 6 * 85 = 340 MHz, then / 2, 4, 6, 8 for the system and for the controllers
        ("3U | 5U << 4 | 85U << 8 | 1U << 24 | 1U << 25 | 1U << 20", 85e6, 170e6),
        ("3U | 5U << 4 | 85U << 8 | 1U << 24 | 2U << 25 | 1U << 20 | 1U << 21", 340e6 / 6, 85e6),
        ("3U | 5U << 4 | 85U << 8 | 1U << 24 | 3U << 25 | 1U << 20 | 3U << 21", 42.5e6, 42.5e6),
        ("3U | 1U << 4 | 10U << 8 | 1U << 24", 60e6, 0),
    ],
)
def test_the_clock_tree_divides(settings: str, system: float, for_can: float) -> None:
    body = f"""RCC(RCC_CR) |= 1U << 16; while (!(RCC(RCC_CR) & 1U << 17)) {{ }}
        RCC(RCC_PLLCFGR) = {settings}; RCC(RCC_CR) |= 1U << 24;
        while (!(RCC(RCC_CR) & 1U << 25)) {{ }}
        FLASH(FLASH_ACR) = (FLASH(FLASH_ACR) & ~0xFU) | 4U; RCC(RCC_CFGR) = 3U | 8U << 4;
        for (uint32_t volatile i = 0; i < 60; i++) {{ }}
        RCC(RCC_CFGR) = 3U | 4U << 8 | 5U << 11; RCC(RCC_CCIPR) = 1U << 24;"""
    chip = Chip(image(body))
    chip.run_until(5 * MILLISECOND)
    tree = chip.rcc
    found = tree.sysclk, tree.hclk, tree.pclk1, tree.pclk2, tree.fdcan
    assert found == pytest.approx((system, system, system / 2, system / 4, for_can))


def test_time_goes_on_evenly_while_the_clock_changes() -> None:
    """A timer that counts every clock never counts more than the highest clock gives."""
    body = "RCC(RCC_APB1ENR1) |= 8; (void)RCC(RCC_APB1ENR1); TIM5(0) = 1; clock_170();"
    chip = Chip(image(body + " for (;;) { }"))
    chip.run_until(20 * MICROSECOND)
    times, counts = [], []
    while chip.time < 4 * MILLISECOND:
        chip.run_for(5 * MICROSECOND)
        times.append(chip.time)
        counts.append(chip.bus_read(0x40000C24))
    assert all(5_000 <= later - sooner < 8_000 for sooner, later in pairwise(times))
    steps = [later - sooner for sooner, later in pairwise(counts)]
    assert min(steps) < 5 * 16.5 + 20
    assert 5 * 169 < max(steps) < 8 * 171


def test_a_timer_behind_a_divided_bus_has_twice_its_clock() -> None:
    body = """clock_170(); RCC(RCC_CFGR) |= 5U << 8; wait_us(1); REPORT[0] = 1;
        for (;;) { REPORT[0] = TIM2(0x24); }"""
    chip = Chip(image(body))
    chip.run_until(4 * MILLISECOND)
    before, begin = report(chip, 0), chip.time
    chip.run_for(10 * MILLISECOND)
    assert report(chip, 0) - before == pytest.approx((chip.time - begin) / 2000, abs=2)


def test_cycles_count_with_the_clock_of_the_processor() -> None:
    body = """clock_170(); REGISTER(0xE000EDFCU) = 1U << 24; REGISTER(0xE0001000U) |= 1;
        wait_us(1); uint32_t const a = REGISTER(0xE0001004U); wait_us(1000);
        REPORT[0] = REGISTER(0xE0001004U) - a; REPORT[1] = 1;"""
    chip = Chip(image(body))
    chip.run_until(5 * MILLISECOND)
    assert report(chip, 1) == 1
    assert report(chip, 0) == pytest.approx(170_000, abs=400)


def test_systick_counts_down_and_flags_its_end() -> None:
    body = """clock_170(); REGISTER(0xE000E014U) = 169999; REGISTER(0xE000E018U) = 0;
        REGISTER(0xE000E010U) = 5; wait_us(1); uint32_t const t = TIM2(0x24);
        REPORT[0] = REGISTER(0xE000E018U);
        for (uint32_t n = 0; n < 4;) { n += REGISTER(0xE000E010U) >> 16 & 1; }
        REPORT[1] = TIM2(0x24) - t; REPORT[2] = 1;"""
    chip = Chip(image(body))
    chip.run_until(8 * MILLISECOND)
    assert report(chip, 2) == 1
    assert 169_000 < report(chip, 0) <= 169_999
    assert report(chip, 1) == pytest.approx(4000, abs=4)


def test_a_timer_flags_its_overflow_in_time() -> None:
    body = """clock_170(); wait_us(1); RCC(RCC_APB1ENR1) |= 8; (void)RCC(RCC_APB1ENR1);
        TIM5(0x28) = 169; TIM5(0x2C) = 19; TIM5(0x14) = 1; TIM5(0x10) = 0; TIM5(0) = 1;
        uint32_t const t = TIM2(0x24);
        for (uint32_t n = 0; n < 200; n++) { while (!(TIM5(0x10) & 1)) { } TIM5(0x10) = ~1U; }
        REPORT[0] = TIM2(0x24) - t;
        for (;;) { REPORT[1] = TIM2(0x24) - t; REPORT[2] = TIM5(0x24); }"""
    chip = Chip(image(body))
    chip.run_until(60 * MILLISECOND)
    assert report(chip, 0) == pytest.approx(4000, abs=2)
    assert (report(chip, 1) - report(chip, 2)) % 20 in (0, 1, 19), "thousands of periods later"


def test_a_prescaler_counts_from_the_next_update_on() -> None:
    """Written without one, the timer still runs at 170 MHz."""
    body = """clock_170(); wait_us(1); RCC(RCC_APB1ENR1) |= 8; (void)RCC(RCC_APB1ENR1);
        TIM5(0x28) = 169; TIM5(0) = 1; wait_us(1000); REPORT[0] = TIM5(0x24);"""
    chip = Chip(image(body))
    chip.run_until(5 * MILLISECOND)
    assert report(chip, 0) == pytest.approx(170_000, abs=600)


def test_slices_of_the_run_change_nothing() -> None:
    """A checksum of what the firmware sees of the time is the same in any slices."""
    body = """clock_170(); wait_us(1); uint32_t sum = 1;
        for (uint32_t n = 0;; n++) { sum = sum * 1664525U + (TIM2(0x24) ^ n);
            if (n % 1000 == 999) { REPORT[1 + n / 1000] = sum; REPORT[0] = n; } }"""
    whole, sliced = Chip(image(body)), Chip(image(body))
    whole.run_until(6 * MILLISECOND)
    random = Random(3)
    while sliced.time < 6 * MILLISECOND:
        sliced.run_for(random.randint(100, 20_000))
    count = min(report(whole, 0), report(sliced, 0)) // 1000
    assert count > 20
    assert [report(whole, n) for n in range(1, count)] == [
        report(sliced, n) for n in range(1, count)
    ]


def test_memory_is_anything_after_power_on_and_stays_over_a_reset() -> None:
    body = "REPORT[1] = REPORT[0]; REPORT[0] = 0x12345678U; REPORT[2] = RCC(RCC_CSR); for (;;) { }"
    chip = Chip(image(body))
    chip.run_for(MILLISECOND)
    assert report(chip, 1) not in (0, 0x12345678, 0xFFFFFFFF)
    chip.reset("pin")
    chip.run_for(MILLISECOND)
    assert report(chip, 1) == 0x12345678
    chip.power_cut()
    chip.run_for(MILLISECOND)
    chip.reset("power")
    chip.run_for(MILLISECOND)
    assert report(chip, 1) != 0x12345678


POWER, PIN, SOFTWARE, WATCHDOG = 1 << 27, 1 << 26, 1 << 28, 1 << 29


def test_the_cause_of_a_reset_is_told_until_it_is_removed() -> None:
    body = """REPORT[0] = RCC(RCC_CSR);
        if (REPORT[0] >> 29 & 1) { RCC(RCC_CSR) |= 1U << 23; } for (;;) { }"""
    chip = Chip(image(body))
    chip.run_for(MILLISECOND)
    assert report(chip, 0) == POWER | PIN
    chip.reset("software")
    chip.run_for(MILLISECOND)
    assert report(chip, 0) == POWER | PIN | SOFTWARE
    chip.reset("watchdog")
    chip.run_for(MILLISECOND)
    assert report(chip, 0) == POWER | PIN | SOFTWARE | WATCHDOG
    chip.reset("pin")
    chip.run_for(MILLISECOND)
    assert report(chip, 0) == PIN


def test_software_resets_the_chip() -> None:
    body = """REPORT[1] = RCC(RCC_CSR); if (REPORT[0] != 77) { REPORT[0] = 77; REPORT[2] = 0; }
        if (REPORT[2]++ < 2) { clock_170(); SCB(0x0C) = 0x05FA0004U; } for (;;) { }"""
    chip = Chip(image(body))
    chip.run_until(20 * MILLISECOND)
    assert [cause for _, cause in chip.resets] == ["power", "software", "software"]
    assert report(chip, 1) & SOFTWARE
    assert chip.rcc.hclk == 16.128e6


WATCHED = """IWDG(0) = 0xCCCC; IWDG(0) = 0x5555; IWDG(4) = 0; IWDG(8) = 79; while (IWDG(12)) { }
    IWDG(0) = 0xAAAA; uint32_t n = 0;"""


def test_the_watchdog_resets_unless_it_is_fed() -> None:
    """80 times 4 clocks of 32 kHz are 10 ms."""
    fed = Chip(image(WATCHED + "for (;;) { IWDG(0) = 0xAAAA; (void)n; }"))
    fed.run_until(100 * MILLISECOND)
    assert len(fed.resets) == 1
    hungry = Chip(image(WATCHED + "clock_170(); for (;;) { REPORT[0] = n++; }"))
    hungry.run_until(100 * MILLISECOND)
    times = [time for time, _ in hungry.resets]
    assert [cause for _, cause in hungry.resets[1:]] == ["watchdog"] * (len(times) - 1)
    assert all(10 <= (b - a) / MILLISECOND < 11 for a, b in pairwise(times))


@pytest.mark.parametrize(("pause", "resets"), [(1, True), (6000, False)])
def test_a_window_resets_what_feeds_too_soon(pause: int, resets: bool) -> None:
    """The counter has to be down from 79 to 40: 39 times 4 clocks of 32 kHz are 4.9 ms."""
    window = WATCHED.replace(
        "IWDG(0) = 0xAAAA;", "IWDG(0) = 0x5555; IWDG(16) = 40; while (IWDG(12)) { } clock_170();"
    )
    chip = Chip(image(window + f"for (;;) {{ wait_us({pause}); IWDG(0) = 0xAAAA; (void)n; }}"))
    chip.run_until(40 * MILLISECOND)
    assert (len(chip.resets) > 1) == resets


def test_a_fast_slow_oscillator_bites_sooner() -> None:
    chip = Chip(image(WATCHED + "for (;;) { (void)n; }"), lsi=34e3)
    chip.run_until(30 * MILLISECOND)
    first, second = chip.resets[1][0], chip.resets[2][0]
    assert (second - first) / MILLISECOND == pytest.approx(320 / 34, abs=0.4)


def test_a_crystal_that_never_swings_is_never_ready() -> None:
    body = "RCC(RCC_CR) |= 1U << 16; for (;;) { REPORT[0] = RCC(RCC_CR); }"
    chip = Chip(image(body), hse=None)
    chip.run_until(10 * MILLISECOND)
    assert report(chip, 0) & 3 << 16 == 1 << 16


SERIAL = """clock_170(); RCC(RCC_AHB2ENR) |= 1; RCC(RCC_APB1ENR1) |= 1U << 17;
    (void)RCC(RCC_APB1ENR1); GPIO(0, 0x20) = 7U << 8 | 7U << 12; GPIO(0, 0) = 0xABFFFFAFU;
    USART2(0x0C) = 1476; USART2(0) = 13;"""
ECHO = (
    SERIAL
    + """for (;;) { if (USART2(0x1C) & 0x20) { uint32_t const c = USART2(0x24);
    while (!(USART2(0x1C) & 0x80)) { } USART2(0x28) = c + 1; } }"""
)


def test_bytes_go_in_and_out_at_the_rate_of_the_line() -> None:
    chip = Chip(image(ECHO))
    chip.run_until(3 * MILLISECOND)
    assert chip.uart.name == "USART2"
    chip.uart.receive(b"HAL")
    chip.run_for(2 * MILLISECOND)
    times = [time for time, _ in chip.uart.sent]
    assert chip.uart.taken() == b"IBM"
    assert times[1] - times[0] == pytest.approx(1e10 / 115200, rel=0.03)


def test_bytes_that_nobody_takes_are_overrun() -> None:
    chip = Chip(image(SERIAL + "for (;;) { REPORT[0] = USART2(0x1C); }"))
    chip.run_until(3 * MILLISECOND)
    chip.uart.receive(b"ab")
    chip.run_for(MILLISECOND)
    assert report(chip, 0) & 0x28 == 0x28


def test_a_register_bit_can_stick() -> None:
    body = """RCC(RCC_AHB2ENR) |= 1; (void)RCC(RCC_AHB2ENR);
        for (;;) { GPIO(0, 0x14) = 1; REPORT[0] = GPIO(0, 0x14); }"""
    chip = Chip(image(body))
    chip.run_until(MILLISECOND)
    assert report(chip, 0) == 1
    chip.stick(0x48000014, 3, 2)
    chip.run_for(MILLISECOND)
    assert report(chip, 0) == 2
    chip.stick(0x48000014, 0, 0)
    chip.run_for(MILLISECOND)
    assert report(chip, 0) == 1


# -- exceptions of the processor --------------------------------------------------------------

FAULT_HANDLER = """
void fault_handler(void);
__attribute__((naked)) void fault_handler(void)
{
    __asm volatile("mrs r0, ipsr\\n ldr r1, =0x20010000\\n str r0, [r1]\\n ldr r0, [sp, #24]\\n"
                   " str r0, [r1, #4]\\n ldr r0, =0xE000ED28\\n ldr r0, [r0]\\n"
                   " str r0, [r1, #8]\\n ldr r0, =0xE000ED38\\n ldr r0, [r0]\\n"
                   " str r0, [r1, #12]\\n str lr, [r1, #16]\\n 1: b 1b\\n .ltorg");
}
"""


@pytest.mark.parametrize(
    ("body", "status"),
    [
        ("*(uint32_t volatile *)0x30000000U = 1;", 1 << 9 | 1 << 15),
        ("(void)*(uint32_t volatile *)0x30000000U;", 1 << 9 | 1 << 15),
        ('__asm volatile("udf #1");', 1 << 16),
        ('SCB(0x88) = 0; __asm volatile("vadd.f32 s0, s0, s0");', 1 << 19),
        ('__asm volatile("ldrd r0, r1, [%0]" : : "r"(0x20008001U) : "r0", "r1");', 1 << 24),
    ],
)
def test_a_fault_is_taken_with_its_cause_and_place(body: str, status: int) -> None:
    chip = Chip(image(body, FAULT_HANDLER), faults="take")
    chip.run_until(MILLISECOND)
    number, place, cause, address, link = (report(chip, n) for n in range(5))
    assert (number, cause, link) == (3, status, 0xFFFFFFF9)
    assert 0x08000000 < place < 0x08000400
    assert len(chip.exceptions) == 1
    if status >> 15 & 1:
        assert address == 0x30000000


@pytest.mark.parametrize(
    ("enable", "body", "number", "status"),
    [
        (18, '__asm volatile("udf #1");', 6, 1 << 16),
        (17, "(void)*(uint32_t volatile *)0x30000000U;", 5, 1 << 9 | 1 << 15),
        (0, "(void)*(uint32_t volatile *)0x30000000U;", 3, 1 << 9 | 1 << 15),
    ],
)
def test_an_enabled_fault_has_its_own_vector(
    enable: int, body: str, number: int, status: int
) -> None:
    chip = Chip(image(f"SCB(0x24) = 1U << {enable} & ~1U; {body}", FAULT_HANDLER), faults="take")
    chip.run_until(MILLISECOND)
    assert (report(chip, 0), report(chip, 2)) == (number, status)


DIVIDE = "int volatile zero = 0; REPORT[0] = 5; REPORT[0] = (uint32_t)(7 / zero);"


def test_division_by_zero_is_zero_unless_it_is_trapped() -> None:
    chip = Chip(image(DIVIDE))
    chip.run_until(MILLISECOND)
    assert report(chip, 0) == 0
    chip = Chip(image("SCB(0x14) |= 1U << 4;" + DIVIDE, FAULT_HANDLER), faults="take")
    chip.run_until(MILLISECOND)
    assert report(chip, 2) == 1 << 25


@pytest.mark.parametrize(("instruction", "odd"), [("ldr", 1), ("ldr", 2), ("ldrh", 1), ("ldrb", 1)])
@pytest.mark.parametrize("trapped", [False, True])
def test_unaligned_words_are_read_unless_they_are_trapped(
    instruction: str, odd: int, trapped: bool
) -> None:
    load = f'__asm volatile("{instruction} r0, [%0]" : : "r"({0x20008000 + odd}U) : "r0");'
    chip = Chip(image(f"SCB(0x14) |= {8 * trapped}; {load}", FAULT_HANDLER), faults="take")
    chip.run_until(MILLISECOND)
    assert bool(chip.exceptions) == (trapped and instruction != "ldrb")


GUARD = "SCB(0x9C) = 0x20008000U | 0x10U; SCB(0xA0) = 1U | 4U << 1 | {rights}U << 24;"
TOUCH = "SCB(0x94) = 5; *(uint32_t volatile *)({place}U) = 1;"


@pytest.mark.parametrize(
    ("rights", "place", "denied"),
    [(0, 0x20008000, True), (0, 0x2000801C, True), (0, 0x20008020, False), (3, 0x20008000, False)],
)
def test_a_guarded_range_of_memory_is_denied(rights: int, place: int, denied: bool) -> None:
    body = GUARD.format(rights=rights) + TOUCH.format(place=place)
    chip = Chip(image(body, FAULT_HANDLER), faults="take")
    chip.run_until(MILLISECOND)
    assert bool(chip.exceptions) == denied
    if denied:
        assert report(chip, 2) == 1 << 1 | 1 << 7


def test_a_fault_in_the_handler_locks_up_until_the_watchdog_bites() -> None:
    more = """void fault_handler(void);
        void fault_handler(void) { REPORT[0]++; *(uint32_t volatile *)0x30000000U = 1; }"""
    body = 'REPORT[0] = 0; IWDG(0) = 0xCCCC; __asm volatile("udf #1");'
    chip = Chip(image(body, more), faults="take")
    chip.run_until(10 * MILLISECOND)
    assert chip.locked_up
    assert report(chip, 0) == 1
    chip.run_until(600 * MILLISECOND)
    assert [cause for _, cause in chip.resets] == ["power", "watchdog"]


def test_a_stack_outside_of_the_memory_locks_up() -> None:
    body = '__asm volatile("ldr sp, =0x20000010\\n udf #1\\n .ltorg");'
    chip = Chip(image(body), faults="take")
    chip.run_until(MILLISECOND)
    assert chip.locked_up


def test_a_handler_resets_the_chip_and_the_firmware_finds_what_it_left() -> None:
    more = """void fault_handler(void);
        void fault_handler(void) { REPORT[0] = SCB(0x28); SCB(0x0C) = 0x05FA0004U;
            for (;;) { } }"""
    body = """if (RCC(RCC_CSR) >> 28 & 1) { REPORT[1] = REPORT[0]; for (;;) { } }
        __asm volatile("udf #1");"""
    chip = Chip(image(body, more), faults="take")
    chip.run_until(MILLISECOND)
    assert [cause for _, cause in chip.resets] == ["power", "software"]
    assert report(chip, 1) == 1 << 16


# -- flash -------------------------------------------------------------------------------------


def unlocked() -> Chip:
    """A chip that a debugger has halted, with its flash unlocked."""
    chip = Chip(image("for (;;) { }"))
    chip.bus_write(0xE000EDF0, 0xA05F0003)
    for key in KEYS:
        chip.bus_write(KEYR, key)
    return chip


def settle(chip: Chip) -> None:
    while chip.bus_read(SR) >> 16 & 1:
        chip.run_for(10 * MICROSECOND)


def test_a_debugger_programs_and_erases_the_flash() -> None:
    chip = unlocked()
    before = chip.flash
    chip.bus_write(CR, 1)
    for word in range(4):
        settle(chip)
        chip.bus_write(PAGE + 4 * word, 0x01010101 * word)
    settle(chip)
    assert chip.flash[0x40000:0x40010] == bytes([0] * 4 + [1] * 4 + [2] * 4 + [3] * 4)
    assert chip.flash[:0x40000] == before[:0x40000]
    begin = chip.time
    chip.bus_write(CR, 2 | 1 << 11 | 1 << 16)
    settle(chip)
    assert chip.time - begin > 20 * MILLISECOND
    assert chip.flash == before


def test_a_power_cut_while_a_page_is_erased_leaves_anything_in_it() -> None:
    chip = unlocked()
    before = chip.flash
    chip.bus_write(CR, 2 | 1 << 11 | 1 << 16)
    chip.power_cut()
    assert chip.flash[0x40000:0x40800] not in (before[0x40000:0x40800], b"\xff" * 0x800)
    assert chip.flash[:0x40000] + chip.flash[0x40800:] == before[:0x40000] + before[0x40800:]


def test_firmware_programs_the_flash_and_runs_what_it_wrote() -> None:
    body = f"""FLASH(8) = {KEYS[0]}U; FLASH(8) = {KEYS[1]}U; FLASH(0x14) = 1;
        *(uint32_t volatile *){PAGE}U = 0x47702007U; /* movs r0, #7; bx lr */
        *(uint32_t volatile *){PAGE + 4}U = 0;
        while (FLASH(0x10) >> 16 & 1) {{ }}
        REPORT[0] = ((uint32_t (*)(void)){PAGE + 1}U)();"""
    chip = Chip(image(body))
    chip.run_until(MILLISECOND)
    assert report(chip, 0) == 7
    assert chip.flash[0x40000:0x40008] == bytes.fromhex("0720704700000000")


def test_backup_registers_outlive_a_reset_but_not_the_power() -> None:
    body = """RCC(RCC_APB1ENR1) |= 1U << 28; (void)RCC(RCC_APB1ENR1); PWR(PWR_CR1) |= 1U << 8;
        REPORT[0] = REGISTER(0x40002500U); REGISTER(0x40002500U) = 77; for (;;) { }"""
    chip = Chip(image(body))
    found = []
    for cause in ("watchdog", "power"):
        chip.run_for(MILLISECOND)
        found.append(report(chip, 0))
        if cause == "power":
            chip.power_cut()
        chip.reset(cause)
    chip.run_for(MILLISECOND)
    assert [*found, report(chip, 0)] == [0, 77, 0]


def test_an_option_starts_the_watchdog_with_the_chip() -> None:
    chip = Chip(image("for (;;) { }"), watchdog_by_hardware=True)
    chip.run_until(2000 * MILLISECOND)
    assert [cause for _, cause in chip.resets] == ["power"] + ["watchdog"] * 3


def test_a_debugger_reads_and_sets_the_processor() -> None:
    chip = Chip(image("for (;;) { REPORT[0]++; }"))
    chip.run_until(MILLISECOND)
    chip.bus_write(0xE000EDF0, 0xA05F0003)
    chip.bus_write(0xE000EDF8, 0x20004000)
    chip.bus_write(0xE000EDF4, 1 << 16 | 13)
    chip.bus_write(0xE000EDF4, 15)
    assert 0x08000000 <= chip.bus_read(0xE000EDF8) < 0x08001000
    chip.bus_write(0xE000EDF4, 13)
    assert chip.bus_read(0xE000EDF8) == 0x20004000


@pytest.mark.parametrize(("freeze", "resets"), [(0, 1), (1 << 12, 0)])
def test_the_watchdog_goes_on_while_a_debugger_halts_unless_it_is_frozen(
    freeze: int, resets: int
) -> None:
    chip = Chip(image(WATCHED + "for (;;) { IWDG(0) = 0xAAAA; (void)n; }"))
    chip.run_until(5 * MILLISECOND)
    chip.bus_write(0xE0042008, freeze)
    chip.bus_write(0xE000EDF0, 0xA05F0003)
    chip.run_for(12 * MILLISECOND)
    assert len(chip.resets) - 1 == resets


def test_a_debugger_halts_the_chip_at_its_first_instruction() -> None:
    chip = Chip(image("REPORT[0] = 1; for (;;) { }"))
    chip.bus_write(0xE000EDF0, 0xA05F0001)
    chip.bus_write(0xE000EDFC, 1)
    chip.bus_write(0xE000ED0C, 0x05FA0004)
    chip.run_for(MILLISECOND)
    assert chip.halted
    assert report(chip, 0) != 1
    chip.bus_write(0xE000EDF0, 0xA05F0001)
    chip.run_for(MILLISECOND)
    assert report(chip, 0) == 1


def test_a_halted_processor_stands_still_and_time_goes_on() -> None:
    chip = Chip(image("for (;;) { REPORT[0]++; }"))
    chip.run_until(MILLISECOND)
    chip.bus_write(0xE000EDF0, 0xA05F0003)
    count = report(chip, 0)
    chip.run_for(MILLISECOND)
    assert report(chip, 0) == count
    assert chip.time >= 2 * MILLISECOND
    chip.bus_write(0xE000EDF0, 0xA05F0000)
    chip.run_for(MILLISECOND)
    assert report(chip, 0) > count


def test_the_checksum_unit_computes_the_usual_checksum() -> None:
    body = """RCC(RCC_AHB1ENR) |= 1U << 12; (void)RCC(RCC_AHB1ENR);
        REGISTER(0x40023008U) = 1U | 1U << 5 | 1U << 7;
        for (char const *c = "123456789"; *c; c++) {
            *(uint8_t volatile *)0x40023000U = (uint8_t)*c; }
        REPORT[0] = ~REGISTER(0x40023000U);"""
    chip = Chip(image(body))
    chip.run_until(MILLISECOND)
    assert report(chip, 0) == 0xCBF43926
