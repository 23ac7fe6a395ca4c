/* CANopen as the machine's fieldbus: observations from frames, frames from orders.
 *
 * In a cycle of fieldbus.h:
 *   sync      SYNC on every bus that is due; frames that wait are late answers to the SYNC before
 *   collect   what the drives answered
 *   dispatch  setpoints, then the heartbeat, then one acyclic frame a bus; nothing is sent to a bus
 *             that is off
 * Time is counted in cycles; nothing here reads a clock or waits. A bus whose SYNC comes only every
 * few cycles gets its setpoints in those cycles, and its answers have until the last collect before
 * the next SYNC: the bus proof counts on that. */
#ifndef TB_NETWORK_H
#define TB_NETWORK_H

#include <stdint.h>

#include "can.h"
#include "drive_link.h"
#include "echo.h"
#include "fieldbus.h"

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
    tb_fieldbus fieldbus;
    tb_bus buses[TB_BUSES];
    tb_drive_link links[TB_DRIVES];
    uint32_t cycle;
} tb_network;

/** Take over opened ports, in the order of the buses in the machine file. */
void tb_network_start(tb_network *network, tb_can_port *const ports[TB_BUSES]);

#ifdef __cplusplus
}
#endif

#endif
