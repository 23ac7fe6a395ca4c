/* A CAN bus in memory: its only other node is a program in the same process, the peer.
 *
 * Deterministic, and one value: no pointer inside but to the driver, so that a copy is a second bus
 * in the same state. Frames cross in the order they were sent. Nothing answers by itself: what the
 * port sent waits until the peer takes it. */
#ifndef TB_LOOPBACK_H
#define TB_LOOPBACK_H

#include "can.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TB_LOOPBACK_DEPTH 64u /* frames that wait in each direction */

/** Frames in the order they came. */
typedef struct {
    tb_can_frame frames[TB_LOOPBACK_DEPTH];
    uint32_t first; /* the one that has waited longest */
    uint32_t count;
} tb_loopback_ring;

/** The bus. */
typedef struct {
    tb_can_port port;
    tb_can_state state;
    bool full; /* as if the peer took nothing any more */
    tb_loopback_ring sent;
    tb_loopback_ring arrived;
} tb_loopback;

/** An empty bus on which all is well. */
void tb_loopback_open(tb_loopback *loopback);

/** Peer: take the frame that was sent first; TB_CAN_EMPTY where there is none. */
tb_can_result tb_loopback_take(tb_loopback *loopback, tb_can_frame *frame);

/** Peer: let a frame arrive. TB_CAN_REFUSED for what is no frame; TB_CAN_FULL where there is no room:
 *  the port counts it as lost; TB_CAN_CLOSED while the bus is off or not open. */
tb_can_result tb_loopback_give(tb_loopback *loopback, const tb_can_frame *frame);

/** Fault: bring the bus into a state. Off, it carries nothing; TB_CAN_NOT_OPEN is a device that
 *  has gone, for which only tb_loopback_open helps. */
void tb_loopback_set_state(tb_loopback *loopback, tb_can_state state);

/** Fault: refuse every frame (ENOBUFS), or no longer. */
void tb_loopback_set_full(tb_loopback *loopback, bool full);

#ifdef __cplusplus
}
#endif

#endif
