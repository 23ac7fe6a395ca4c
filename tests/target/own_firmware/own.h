/** Registers of an STM32G474 as the tests of the simulated chip need them; no driver of ours. */
#ifndef OWN_H
#define OWN_H

#include <stdbool.h>
#include <stdint.h>

#define REGISTER(address) (*(uint32_t volatile *)(address))

#define RCC(offset) REGISTER(0x40021000U + (offset))
#define PWR(offset) REGISTER(0x40007000U + (offset))
#define FLASH(offset) REGISTER(0x40022000U + (offset))
#define GPIO(port, offset) REGISTER(0x48000000U + 0x400U * (port) + (offset))
#define TIM2(offset) REGISTER(0x40000000U + (offset))
#define TIM5(offset) REGISTER(0x40000C00U + (offset))
#define IWDG(offset) REGISTER(0x40003000U + (offset))
#define USART2(offset) REGISTER(0x40004400U + (offset))
#define CAN(number, offset) REGISTER(0x40006000U + 0x400U * (number) + (offset))
#define RAM(number, offset) REGISTER(0x4000A400U + 0x350U * ((number)-1U) + (offset))
#define SCB(offset) REGISTER(0xE000ED00U + (offset))

enum { RCC_CR = 0x00, RCC_CFGR = 0x08, RCC_PLLCFGR = 0x0C, RCC_AHB1ENR = 0x48, RCC_AHB2ENR = 0x4C };
enum { RCC_APB1ENR1 = 0x58, RCC_APB1ENR2 = 0x5C, RCC_APB2ENR = 0x60, RCC_CCIPR = 0x88 };
enum { RCC_CSR = 0x94, PWR_CR1 = 0x00, PWR_CR5 = 0x80, FLASH_ACR = 0x00 };
enum { CCCR = 0x18, NBTP = 0x1C, ECR = 0x40, PSR = 0x44, IR = 0x50, RXGFC = 0x80 };
enum { RXF0S = 0x90, RXF0A = 0x94, RXF1S = 0x98, RXF1A = 0x9C, TXBC = 0xC0, TXFQS = 0xC4 };
enum { TXBRP = 0xC8, TXBAR = 0xCC, TXBCR = 0xD0, TXBTO = 0xD4, TXBCF = 0xD8 };
enum { STANDARD = 0x000, EXTENDED = 0x070, RX0 = 0x0B0, RX1 = 0x188, EVENTS = 0x260, TX = 0x278 };

/** What the test reads after the run, at a place in RAM that it knows. */
#define REPORT ((uint32_t volatile *)0x20010000U)

void firmware(void);

/** 170 MHz from a crystal of 24 MHz, in the steps that the reference manual wants. */
void clock_170(void);
/** 500 kbit/s or 1 Mbit/s from 170 MHz; starts a controller with what is in `settings`. */
void can_pins(void);
void can_configure(uint32_t number, uint32_t nbtp, uint32_t settings, uint32_t filters);
void can_start(uint32_t number);
/** A standard frame of up to 8 bytes into a buffer, and the request to send it. */
void can_put(uint32_t number, uint32_t buffer, uint32_t id, uint32_t length, uint32_t low,
             uint32_t high);
void can_send(uint32_t number, uint32_t id, uint32_t length, uint32_t low, uint32_t high);
void wait_us(uint32_t time);

enum { QUEUE = 1U << 24, ONE_MEGABIT = 1U << 25 | 9U << 16 | 13U << 8 | 1U };

#endif
