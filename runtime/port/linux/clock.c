#define _POSIX_C_SOURCE 200809L
#include "clock.h"

#include <errno.h>
#include <time.h>

int64_t tb_clock_monotonic(void)
{
    struct timespec now = {0};
    clock_gettime(CLOCK_MONOTONIC, &now); /* fails for no clock that exists */
    return ((int64_t)now.tv_sec * TB_SECOND) + (int64_t)now.tv_nsec;
}

static int64_t now(const tb_clock *clock)
{
    (void)clock;
    return tb_clock_monotonic();
}

static void sleep_until(tb_clock *clock, int64_t time)
{
    struct timespec const until = {.tv_sec = (time_t)(time / TB_SECOND),
                                   .tv_nsec = (long)(time % TB_SECOND)};
    (void)clock;
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL) == EINTR) {
        /* a signal was handled; the time has not come */
    }
}

tb_clock const tb_system_clock = {.now = now, .sleep_until = sleep_until};
