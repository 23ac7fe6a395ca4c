/* What lab/flight/replay.py needs around the supervisor to run recorded cycles again.
 * Runs on a host only; nothing of it goes to a machine. */
#include <stddef.h>

#include "recorder.h"

void shim_replay(tb_supervisor *supervisor, size_t cycles, const tb_recorded_cycle recorded[],
                 tb_recorded_cycle again[]);

void shim_replay(tb_supervisor *supervisor, size_t cycles, const tb_recorded_cycle recorded[],
                 tb_recorded_cycle again[])
{
    for (size_t i = 0; i < cycles; i++) {
        again[i].seen = recorded[i].seen;
        tb_supervisor_step(supervisor, &again[i].seen, &again[i].orders);
    }
}
