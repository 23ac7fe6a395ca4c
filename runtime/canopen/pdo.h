/* Process data: RPDO1 and TPDO1 as the contract of every drive maps them. Where each object is in them
 * stands in tb_drives.h, from the same table as the contract. */
#ifndef TB_PDO_H
#define TB_PDO_H

#include <stdbool.h>
#include <stdint.h>

#include "can.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What TPDO1 carries. */
typedef struct {
    int32_t position; /* increments */
    int16_t torque;   /* per mille of the rated torque */
    uint16_t statusword;
} tb_pdo_status;

tb_can_frame tb_pdo_torque_frame(uint8_t node, uint16_t controlword, int16_t torque);

tb_can_frame tb_pdo_position_frame(uint8_t node, uint16_t controlword, int32_t increments);

/** Read TPDO1. False: not of its length, and status is left alone. */
bool tb_pdo_take(tb_pdo_status *status, const tb_can_frame *frame);

#ifdef __cplusplus
}
#endif

#endif
