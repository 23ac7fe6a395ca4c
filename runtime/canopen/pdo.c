#include "pdo.h"

#include "cob.h"
#include "little_endian.h"
#include "tb_drives.h"

tb_can_frame tb_pdo_torque_frame(uint8_t node, uint16_t controlword, int16_t torque)
{
    tb_can_frame frame = tb_cob_frame(TB_COB_RPDO1, node, TB_TORQUE_COMMAND_LENGTH);
    tb_put_u16(&frame.data[TB_TORQUE_COMMAND_CONTROLWORD], controlword);
    tb_put_u16(&frame.data[TB_TORQUE_COMMAND_TORQUE], (uint16_t)torque);
    return frame;
}

tb_can_frame tb_pdo_position_frame(uint8_t node, uint16_t controlword, int32_t increments)
{
    tb_can_frame frame = tb_cob_frame(TB_COB_RPDO1, node, TB_POSITION_COMMAND_LENGTH);
    tb_put_u16(&frame.data[TB_POSITION_COMMAND_CONTROLWORD], controlword);
    tb_put_u32(&frame.data[TB_POSITION_COMMAND_POSITION], (uint32_t)increments);
    return frame;
}

bool tb_pdo_take(tb_pdo_status *status, const tb_can_frame *frame)
{
    if (frame->length != TB_STATUS_LENGTH) {
        return false;
    }
    status->statusword = tb_get_u16(&frame->data[TB_STATUS_STATUSWORD]);
    status->position = tb_signed_32(tb_get_u32(&frame->data[TB_STATUS_POSITION]));
    status->torque = tb_signed_16(tb_get_u16(&frame->data[TB_STATUS_TORQUE]));
    return true;
}
