/* A fieldbus as the master sees it: what carries observations from the drives and orders to them.
 *
 * All memory of a fieldbus is in its own struct, whose first member is the tb_fieldbus; its header
 * has the function that starts it. A cycle is three calls, in this order and at these times:
 *
 *   sync      at the start of the cycle: the drives measure, and take over what they were told
 *   collect   TB_COMPUTE_PHASE later: reports of all drives and all buses; of what was not heard in
 *             this cycle the report stays, with its age
 *   dispatch  after the supervisor: every drive's order; the heartbeat where the orders let it go
 *
 * None of them waits or allocates.
 *
 *   canopen/network.h  CANopen on any number of CAN buses */
#ifndef TB_FIELDBUS_H
#define TB_FIELDBUS_H

#include "cycle.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tb_fieldbus tb_fieldbus;

/** What a fieldbus does in a cycle. */
typedef struct {
    void (*sync)(tb_fieldbus *fieldbus);
    void (*collect)(tb_fieldbus *fieldbus, tb_observation *seen);
    void (*dispatch)(tb_fieldbus *fieldbus, const tb_orders *orders);
} tb_fieldbus_protocol;

/** The first member of every fieldbus's own struct. */
struct tb_fieldbus {
    const tb_fieldbus_protocol *protocol;
};

#ifdef __cplusplus
}
#endif

#endif
