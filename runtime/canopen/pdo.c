#include "pdo.h"

#include "cob.h"
#include "little_endian.h"

#define STATUS_LENGTH 8

tb_can_frame tb_pdo_torque_frame(uint8_t node, uint16_t controlword, int16_t permille)
{
    tb_can_frame frame = tb_cob_frame(TB_COB_RPDO1, node, 4);
    tb_put_u16(&frame.data[0], controlword);
    tb_put_u16(&frame.data[2], (uint16_t)permille);
    return frame;
}

tb_can_frame tb_pdo_position_frame(uint8_t node, uint16_t controlword, int32_t increments)
{
    tb_can_frame frame = tb_cob_frame(TB_COB_RPDO1, node, 6);
    tb_put_u16(&frame.data[0], controlword);
    tb_put_u32(&frame.data[2], (uint32_t)increments);
    return frame;
}

bool tb_pdo_take(tb_pdo_status *status, const tb_can_frame *frame)
{
    if (frame->length != STATUS_LENGTH) {
        return false;
    }
    status->statusword = tb_get_u16(&frame->data[0]);
    status->position = tb_signed_32(tb_get_u32(&frame->data[2]));
    status->torque = tb_signed_16(tb_get_u16(&frame->data[6]));
    return true;
}
