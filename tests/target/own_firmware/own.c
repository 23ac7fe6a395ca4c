#include "own.h"

extern uint32_t stack_top, data_begin, data_end, data_load, bss_begin, bss_end;
void reset_handler(void);
void fault_handler(void);

__attribute__((section(".vectors"), used)) static void *const vectors[16] = {
    &stack_top,    reset_handler, fault_handler, fault_handler,
    fault_handler, fault_handler, fault_handler,
};

void reset_handler(void)
{
    SCB(0x88) |= 0xFU << 20;
    __asm volatile("dsb\n isb" ::: "memory");
    uint32_t const *from = &data_load;
    for (uint32_t *to = &data_begin; to < &data_end; to++) {
        *to = *from++;
    }
    for (uint32_t *to = &bss_begin; to < &bss_end; to++) {
        *to = 0;
    }
    firmware();
    for (;;) {
    }
}

__attribute__((weak)) void fault_handler(void)
{
    for (;;) {
    }
}

void clock_170(void)
{
    RCC(RCC_APB1ENR1) |= 1U << 28;
    (void)RCC(RCC_APB1ENR1);
    PWR(PWR_CR5) &= ~(1U << 8);
    RCC(RCC_CR) |= 1U << 16;
    while (!(RCC(RCC_CR) & 1U << 17)) {
    }
    RCC(RCC_PLLCFGR) = 3U | 5U << 4 | 85U << 8 | 1U << 24;
    RCC(RCC_CR) |= 1U << 24;
    while (!(RCC(RCC_CR) & 1U << 25)) {
    }
    FLASH(FLASH_ACR) = (FLASH(FLASH_ACR) & ~0xFU) | 4U;
    while ((FLASH(FLASH_ACR) & 0xFU) != 4U) {
    }
    RCC(RCC_CFGR) = 3U | 8U << 4;
    while ((RCC(RCC_CFGR) >> 2 & 3U) != 3U) {
    }
    for (uint32_t volatile i = 0; i < 60; i++) {
    }
    RCC(RCC_CFGR) = 3U;
}

static void alternate(uint32_t port, uint32_t pin, uint32_t function)
{
    uint32_t const at = pin % 8 * 4;
    uint32_t const table = 0x20 + pin / 8 * 4;
    GPIO(port, table) = (GPIO(port, table) & ~(0xFU << at)) | function << at;
    GPIO(port, 0) = (GPIO(port, 0) & ~(3U << 2 * pin)) | 2U << 2 * pin;
}

void can_pins(void)
{
    RCC(RCC_AHB2ENR) |= 3;
    RCC(RCC_APB1ENR1) |= 1U << 25;
    RCC(RCC_CCIPR) |= 2U << 24;
    (void)RCC(RCC_CCIPR);
    alternate(0, 11, 9);
    alternate(0, 12, 9);
    alternate(1, 12, 9);
    alternate(1, 13, 9);
    alternate(0, 8, 11);
    alternate(0, 15, 11);
}

void can_configure(uint32_t number, uint32_t nbtp, uint32_t settings, uint32_t filters)
{
    CAN(number, CCCR) |= 1;
    while (!(CAN(number, CCCR) & 1)) {
    }
    CAN(number, CCCR) |= 2;
    CAN(number, NBTP) = nbtp;
    CAN(number, TXBC) = settings;
    CAN(number, RXGFC) = filters;
    for (uint32_t offset = 0; offset < 0x350; offset += 4) {
        RAM(number, offset) = 0;
    }
}

void can_start(uint32_t number)
{
    CAN(number, CCCR) &= ~1U;
    while (CAN(number, CCCR) & 1) {
    }
}

void can_put(uint32_t number, uint32_t buffer, uint32_t id, uint32_t length, uint32_t low,
             uint32_t high)
{
    uint32_t const at = TX + 72 * buffer;
    RAM(number, at) = id << 18;
    RAM(number, at + 4) = length << 16;
    RAM(number, at + 8) = low;
    RAM(number, at + 12) = high;
    CAN(number, TXBAR) = 1U << buffer;
}

void can_send(uint32_t number, uint32_t id, uint32_t length, uint32_t low, uint32_t high)
{
    while (CAN(number, TXFQS) & 1U << 21) {
    }
    can_put(number, CAN(number, TXFQS) >> 16 & 3U, id, length, low, high);
}

void wait_us(uint32_t time)
{
    RCC(RCC_APB1ENR1) |= 1;
    (void)RCC(RCC_APB1ENR1);
    if (!(TIM2(0) & 1)) {
        TIM2(0x28) = 169;
        TIM2(0x14) = 1;
        TIM2(0) = 1;
    }
    uint32_t const begin = TIM2(0x24);
    while (TIM2(0x24) - begin < time) {
    }
}
