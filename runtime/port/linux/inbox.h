/* What other programs wish of the machine, read once a cycle from the shared file. */
#ifndef TB_INBOX_H
#define TB_INBOX_H

#include "telemetry.h"
#include "wishes.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A force of the inbox, and for how long it has stood. */
typedef struct {
    uint64_t sequence;
    uint32_t age; /* cycles */
    real_t value[TB_DOF];
} tb_standing_force;

/** What was read last. */
typedef struct {
    uint32_t arm;
    uint32_t stop;
    uint32_t reset;
    tb_standing_force force;
    tb_standing_force hand;
} tb_inbox;

/** Read the wishes of this cycle; each request is seen once. */
void tb_inbox_read(tb_inbox *inbox, const tb_telemetry_inbox *shared, tb_wishes *wishes);

#ifdef __cplusplus
}
#endif

#endif
