/* A clock as the control loop uses it: the computer's, or one that a simulation keeps
 * (simulated_clock.h). */
#ifndef TB_CLOCK_H
#define TB_CLOCK_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TB_SECOND ((int64_t)1000000000) /* ns */

typedef struct tb_clock tb_clock;

/** A clock; the first member of a struct of its own where it remembers more. */
struct tb_clock {
    int64_t (*now)(const tb_clock *clock);
    void (*sleep_until)(tb_clock *clock, int64_t time);
    bool stopped; /* time does not pass any more, and nobody shall wait for it */
};

/** The computer's clock, which never stops. */
extern tb_clock const tb_system_clock;

/** Nanoseconds of CLOCK_MONOTONIC, whichever clock the control loop has. */
int64_t tb_clock_monotonic(void);

/** Now [ns]. */
static inline int64_t tb_clock_now(const tb_clock *clock)
{
    return clock->now(clock);
}

/** Sleep until a point in time [ns]; one that has passed is no sleep. */
static inline void tb_clock_sleep_until(tb_clock *clock, int64_t time)
{
    clock->sleep_until(clock, time);
}

#ifdef __cplusplus
}
#endif

#endif
