/* The machine's buses and drives: observations from frames, frames from orders.
 *
 * A cycle is three calls, in this order and at these times:
 *   tb_network_sync      at the start: SYNC on every bus that is due
 *   tb_network_collect   TB_COMPUTE_PHASE later: what the drives answered
 *   tb_network_dispatch  after the supervisor: setpoints, then the heartbeat, then one acyclic
 *                        frame a bus
 * Time is counted in cycles; nothing here reads a clock or waits. */
#ifndef TB_NETWORK_H
#define TB_NETWORK_H

#include "can.h"
#include "supervisor.h"
#include "drive_link.h"

/** All buses with all drives. */
typedef struct {
    tb_can_port *ports[TB_BUSES];
    tb_drive_link links[TB_DRIVES];
    uint32_t cycle;
    /* and what canopen/network.c needs further */
} tb_network;

/** Take over opened ports, in the order of the buses in the machine file. */
void tb_network_start(tb_network *network, tb_can_port *const ports[TB_BUSES]);

/** Send SYNC where it is due. Frames that wait are late answers to the SYNC before. */
void tb_network_sync(tb_network *network);

/** Read what has arrived into the reports of an observation. */
void tb_network_collect(tb_network *network, tb_observation *seen);

/** Send what the supervisor ordered. Nothing is sent to a bus that is off. */
void tb_network_dispatch(tb_network *network, const tb_orders *orders);

#endif
