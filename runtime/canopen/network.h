/* The machine's buses and drives: observations from frames, frames from orders.
 *
 * A cycle is three calls, in this order and at these times:
 *   tb_network_sync      at the start: SYNC on every bus that is due
 *   tb_network_collect   TB_COMPUTE_PHASE later: what the drives answered
 *   tb_network_dispatch  after the supervisor: setpoints, then the heartbeat, then one acyclic
 *                        frame a bus
 * Time is counted in cycles; nothing here reads a clock or waits. A bus whose SYNC comes only every
 * few cycles gets its setpoints in those cycles, and its answers have until the last collect before
 * the next SYNC: the bus proof counts on that. */
#ifndef TB_NETWORK_H
#define TB_NETWORK_H

#include <stdint.h>

#include "can.h"
#include "cycle.h"
#include "drive_link.h"
#include "echo.h"

#ifdef __cplusplus
extern "C" {
#endif

/** One bus; the counters are of the time since the last report. */
typedef struct {
    tb_can_port *port;
    tb_echo echo;        /* what was sent */
    uint8_t synced;      /* 1: the last SYNC that was due was sent */
    uint8_t served;      /* drive whose acyclic frame was sent last */
    uint8_t refused;     /* as in tb_bus_report */
    uint8_t stranger;    /* as in tb_bus_report */
    uint8_t malformed;   /* as in tb_bus_report */
    uint32_t unreadable; /* malformed in the port's statistics, until the last report */
} tb_bus;

/** All buses with all drives. */
typedef struct {
    tb_bus buses[TB_BUSES];
    tb_drive_link links[TB_DRIVES];
    uint32_t cycle;
} tb_network;

/** Take over opened ports, in the order of the buses in the machine file. */
void tb_network_start(tb_network *network, tb_can_port *const ports[TB_BUSES]);

/** Send SYNC where it is due. Frames that wait are late answers to the SYNC before. */
void tb_network_sync(tb_network *network);

/** Read what has arrived into the reports of an observation. */
void tb_network_collect(tb_network *network, tb_observation *seen);

/** Send what the supervisor ordered. Nothing is sent to a bus that is off. */
void tb_network_dispatch(tb_network *network, const tb_orders *orders);

#ifdef __cplusplus
}
#endif

#endif
