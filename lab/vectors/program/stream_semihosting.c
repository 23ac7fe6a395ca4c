/* On an emulated Cortex-M: two files of the host. */
#include "stream.h"

#include "semihosting.h"

static int32_t arguments, results;

bool stream_open(void)
{
    arguments = semihosting_open("arguments", SEMIHOSTING_READ);
    results = semihosting_open("results", SEMIHOSTING_WRITE);
    return (arguments >= 0) && (results >= 0);
}

bool stream_take(void *to, size_t size)
{
    return semihosting_read(arguments, to, size) == 0;
}

bool stream_give(const void *from, size_t size)
{
    return semihosting_write(results, from, size) == 0;
}
