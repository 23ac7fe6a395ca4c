/* The control loop: one cycle every TB_PERIOD, on a grid of absolute times.
 *
 *   at t0                       SYNC
 *   TB_COMPUTE_PHASE later      the answers are read, the next commands computed and sent
 *
 * A cycle that would begin more than a quarter of a period late is skipped and counted, not made up
 * for: the drives' SYNCs stay on the grid. The supervisor is told. */
#ifndef TB_LOOP_H
#define TB_LOOP_H

#include <stdbool.h>

#include "clock.h"
#include "inbox.h"
#include "master.h"
#include "options.h"
#include "record.h"
#include "reopening.h"
#include "telemetry.h"
#include "watchdog.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Why the loop ended. */
typedef enum {
    TB_END_OFF = 0, /* a stop was asked for, and every drive is off */
    TB_END_AT_ONCE, /* asked for a second time */
    TB_END_NOT_OFF, /* a drive did not go off in time */
    TB_END_NO_TIME  /* the clock has stopped */
} tb_end;

/** What the loop works with, and what it remembers. */
typedef struct {
    const tb_options *options;
    tb_clock *clock;
    tb_master *master;
    tb_can_port *const *ports; /* TB_BUSES of them */
    tb_telemetry_file *telemetry;
    tb_record *record;
    tb_watchdog watchdog;
    tb_inbox inbox;
    tb_reopening reopening;
    tb_loop_times times;
    uint64_t number;   /* of the cycle that runs */
    uint64_t stopping; /* cycles since a stop was wished */
    bool armed;        /* --arm has done its work */
} tb_loop;

/** Run until a stop is asked for and done. */
tb_end tb_loop_run(tb_loop *loop);

#ifdef __cplusplus
}
#endif

#endif
