/* A firmware that is flashed: checks itself before anything else, then counts what it does. */
#include "image.h"

#include "identity.h"
#include "own.h"

enum { FLASH_SIZE = 512 * 1024 };

extern uint32_t stack_top;
void reset_handler(void);
static void fault_handler(void);
void firmware(void)
{
}

__attribute__((section(".vectors"), used)) static void *const vectors[118] = {
    &stack_top,    reset_handler, fault_handler, fault_handler,
    fault_handler, fault_handler, fault_handler,
};

static void fault_handler(void)
{
    for (;;) {
    }
}

static const volatile uint8_t weight[WEIGHT] = {1, 2, 3}; /* the length of a real program */

void reset_handler(void)
{
    if (!tb_image_is_whole(FLASH_SIZE)) {
        REPORT[1] = 0xBADC0DEU;
        for (;;) {
        }
    }
    REPORT[1] = (uint32_t)tb_identity[0] + weight[2];
    for (REPORT[0] = 0;; REPORT[0]++) {
    }
}
