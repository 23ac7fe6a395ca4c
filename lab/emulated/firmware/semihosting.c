#include "semihosting.h"

#include <string.h>

enum { SYS_OPEN = 0x01, SYS_WRITE = 0x05, SYS_READ = 0x06, SYS_EXIT_EXTENDED = 0x20 };
#define APPLICATION_EXIT 0x20026u

static int32_t ask(int32_t operation, const uint32_t arguments[])
{
    register int32_t result __asm("r0") = operation;
    register const uint32_t *block __asm("r1") = arguments;
    __asm volatile("bkpt 0xAB" : "+r"(result) : "r"(block) : "memory");
    return result;
}

int32_t semihosting_open(const char *name, semihosting_mode mode)
{
    uint32_t const arguments[] = {(uint32_t)(uintptr_t)name, (uint32_t)mode, strlen(name)};
    return ask(SYS_OPEN, arguments);
}

size_t semihosting_read(int32_t file, void *to, size_t size)
{
    uint32_t arguments[] = {(uint32_t)file, (uint32_t)(uintptr_t)to, size};
    while (arguments[2] > 0u) {
        uint32_t const missing = (uint32_t)ask(SYS_READ, arguments);
        if (missing >= arguments[2]) {
            break;
        }
        arguments[1] += arguments[2] - missing;
        arguments[2] = missing;
    }
    return arguments[2];
}

size_t semihosting_write(int32_t file, const void *from, size_t size)
{
    uint32_t const arguments[] = {(uint32_t)file, (uint32_t)(uintptr_t)from, size};
    return (size_t)ask(SYS_WRITE, arguments);
}

_Noreturn void semihosting_exit(uint32_t status)
{
    uint32_t const arguments[] = {APPLICATION_EXIT, status};
    for (;;) {
        (void)ask(SYS_EXIT_EXTENDED, arguments);
    }
}
