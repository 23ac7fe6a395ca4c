/* Semihosting of a Cortex-M: the emulator does what the BKPT asks for, on the host's files. */
#ifndef SEMIHOSTING_H
#define SEMIHOSTING_H

#include <stddef.h>
#include <stdint.h>

/** How a file is opened, as the third argument of fopen. */
typedef enum { SEMIHOSTING_READ = 1, SEMIHOSTING_WRITE = 5 } semihosting_mode;

/** A handle of the file of that name; negative where it cannot be opened. */
int32_t semihosting_open(const char *name, semihosting_mode mode);

/** Read so many bytes, waiting for them. The number that is missing: 0, or the file has ended. */
size_t semihosting_read(int32_t file, void *to, size_t size);

/** Write so many bytes. The number that was not written. */
size_t semihosting_write(int32_t file, const void *from, size_t size);

/** End the emulator with a status. */
_Noreturn void semihosting_exit(uint32_t status);

#endif
