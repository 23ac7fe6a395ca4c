/* Time as the control loop uses it: nanoseconds of CLOCK_MONOTONIC. */
#ifndef TB_CLOCK_H
#define TB_CLOCK_H

#include <stdint.h>

#define TB_SECOND ((int64_t)1000000000) /* ns */

/** Now [ns]. */
int64_t tb_clock_now(void);

/** Sleep until a point in time [ns]; one that has passed is no sleep. */
void tb_clock_sleep_until(int64_t time);

#endif
