/* The master: one control cycle, for every port and every fieldbus. A port has a clock and a
 * started fieldbus, and calls
 *
 *   tb_master_sync   at the start of every cycle
 *   tb_master_run    TB_COMPUTE_PHASE later
 *
 * Everything is in tb_master: what was seen and ordered is there to be shown, the recorder to be
 * read out after the last cycle. */
#ifndef TB_MASTER_H
#define TB_MASTER_H

#include <stdint.h>

#include "fieldbus.h"
#include "recorder.h"
#include "supervisor.h"
#include "wishes.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A machine under control. */
typedef struct {
    tb_fieldbus *fieldbus;
    tb_supervisor supervisor;
    tb_recorder recorder;
    tb_observation seen; /* of the last cycle, as the next */
    tb_orders orders;
} tb_master;

/** Take over a started fieldbus; begin in INIT. */
void tb_master_start(tb_master *master, tb_fieldbus *fieldbus);

/** Begin a cycle: the drives measure. */
void tb_master_sync(tb_master *master);

/** Go on with it: read the answers, decide, send. missed: cycles skipped since the last one. */
void tb_master_run(tb_master *master, const tb_wishes *wishes, uint32_t missed);

#ifdef __cplusplus
}
#endif

#endif
