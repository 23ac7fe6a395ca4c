/* From reset to main() on an emulated Cortex-M; main's value, or that of a fault, ends the emulator. */
#include <stdint.h>

#include "semihosting.h"

#define CPACR (*(volatile uint32_t *)0xE000ED88u)
#define FULL_ACCESS_TO_THE_FPU (0xFu << 20)
#define FAULTED 113u
#define UNUSED_STACK 0xDEADBEEFu
#define OWN_FRAME 16 /* words below the frame of reset() that it may use */

extern uint32_t stack_bottom[], stack_top[], data_start[], data_end[], data_load[], bss_start[],
    bss_end[];
extern int main(void);
__attribute__((externally_visible)) void reset(void); /* the linker looks for its name */
void fault(void);
uint32_t stack_used(void);

void fault(void)
{
    semihosting_exit(FAULTED);
}

void reset(void)
{
    CPACR |= FULL_ACCESS_TO_THE_FPU;
    __asm volatile("dsb\n isb" ::: "memory");
    for (uint32_t *word = stack_bottom; word < (uint32_t *)__builtin_frame_address(0) - OWN_FRAME;
         word++) {
        *word = UNUSED_STACK;
    }
    const uint32_t *from = data_load;
    for (uint32_t *to = data_start; to < data_end; to++) {
        *to = *from++;
    }
    for (uint32_t *to = bss_start; to < bss_end; to++) {
        *to = 0;
    }
    semihosting_exit((uint32_t)main());
}

/* Bytes of the stack that have been written since the reset. */
uint32_t stack_used(void)
{
    const uint32_t *word = stack_bottom;
    while ((word < stack_top) && (*word == UNUSED_STACK)) {
        word++;
    }
    return (uint32_t)((uintptr_t)stack_top - (uintptr_t)word);
}

typedef struct {
    uint32_t *stack;
    void (*reset)(void);
    void (*faults[5])(void); /* NMI, hard, memory, bus, usage */
} vector_table;
extern const vector_table vectors;

__attribute__((section(".vectors"), used))
const vector_table vectors = {stack_top, reset, {fault, fault, fault, fault, fault}};
