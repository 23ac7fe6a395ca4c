/* Network management: commands to nodes, their boot-up and heartbeat (CiA 301, 7.2.8). */
#ifndef TB_NMT_H
#define TB_NMT_H

#include <stdbool.h>
#include <stdint.h>

#include "can.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What a node can be told to do. */
typedef enum {
    TB_NMT_START = 0x01, /* operational: from now on it answers SYNC */
    TB_NMT_STOP = 0x02,
    TB_NMT_ENTER_PRE_OPERATIONAL = 0x80,
    TB_NMT_RESET_NODE = 0x81,
    TB_NMT_RESET_COMMUNICATION = 0x82
} tb_nmt_command;

/** State of a node, as in its heartbeat. */
typedef enum {
    TB_NMT_BOOTED = 0x00,
    TB_NMT_STOPPED = 0x04,
    TB_NMT_OPERATIONAL = 0x05,
    TB_NMT_PRE_OPERATIONAL = 0x7F,
    TB_NMT_UNHEARD = 0xFF /* no message yet */
} tb_nmt_state;

/** What is known of a node from its boot-up messages and heartbeats. */
typedef struct {
    uint32_t age;  /* cycles since the last of them */
    uint8_t state; /* tb_nmt_state */
    uint8_t boots; /* boot-up messages; stops at 255 */
} tb_heartbeat;

/** Command to a node; to all nodes where node is 0. */
tb_can_frame tb_nmt_frame(tb_nmt_command command, uint8_t node);

/** Heartbeat of a node. */
tb_can_frame tb_heartbeat_frame(uint8_t node, tb_nmt_state state);

/** Forget all that is known. */
void tb_heartbeat_start(tb_heartbeat *heartbeat);

/** Read a boot-up message or heartbeat. False: malformed, and ignored. */
bool tb_heartbeat_take(tb_heartbeat *heartbeat, const tb_can_frame *frame);

/** A cycle has passed. */
void tb_heartbeat_tick(tb_heartbeat *heartbeat);

#ifdef __cplusplus
}
#endif

#endif
