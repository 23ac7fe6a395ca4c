/* Identifiers of CANopen messages: the predefined connection set (CiA 301, tables 33 and 34). A
 * message's identifier is its function plus the number of the node it is from or for. */
#ifndef TB_COB_H
#define TB_COB_H

#include <stdint.h>

#include "can.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Functions; "to" and "from" a drive. */
#define TB_COB_NMT 0x000u           /* to all */
#define TB_COB_SYNC 0x080u          /* to all: node 0 of TB_COB_EMCY */
#define TB_COB_EMCY 0x080u          /* from */
#define TB_COB_TIME 0x100u          /* to all */
#define TB_COB_TPDO1 0x180u         /* from: statusword, position, torque */
#define TB_COB_RPDO1 0x200u         /* to: controlword, target */
#define TB_COB_TPDO2 0x280u         /* from */
#define TB_COB_RPDO2 0x300u         /* to */
#define TB_COB_TPDO3 0x380u         /* from */
#define TB_COB_RPDO3 0x400u         /* to */
#define TB_COB_TPDO4 0x480u         /* from */
#define TB_COB_RPDO4 0x500u         /* to */
#define TB_COB_SDO_ANSWER 0x580u    /* from */
#define TB_COB_SDO_REQUEST 0x600u   /* to */
#define TB_COB_ERROR_CONTROL 0x700u /* from: boot-up, heartbeat */

#define TB_COB_LARGEST 0x7FFu
#define TB_COB_FUNCTION_MASK 0x780u
#define TB_COB_NODE_MASK 0x07Fu
#define TB_COB_NODE_BITS 7u

#define TB_MASTER_NODE 127u /* whose heartbeat the drives watch: object 1016h */

/** A frame of a length, all zero. */
static inline tb_can_frame tb_cob_frame(uint32_t function, uint8_t node, uint8_t length)
{
    tb_can_frame frame = {0, 0, 0, {0}};
    frame.id = function + node;
    frame.length = length;
    return frame;
}

#ifdef __cplusplus
}
#endif

#endif
