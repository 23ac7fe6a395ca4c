#include "nmt.h"

#include "cob.h"

#define STATE_MASK 0x7Fu /* the highest bit is node guarding's, and reserved here */

static const tb_heartbeat unheard = {.state = TB_NMT_UNHEARD};

static bool is_state(uint8_t state)
{
    return (state == TB_NMT_BOOTED) || (state == TB_NMT_STOPPED) || (state == TB_NMT_OPERATIONAL) ||
           (state == TB_NMT_PRE_OPERATIONAL);
}

tb_can_frame tb_nmt_frame(tb_nmt_command command, uint8_t node)
{
    tb_can_frame frame = tb_cob_frame(TB_COB_NMT, 0, 2);
    frame.data[0] = (uint8_t)command;
    frame.data[1] = node;
    return frame;
}

tb_can_frame tb_heartbeat_frame(uint8_t node, tb_nmt_state state)
{
    tb_can_frame frame = tb_cob_frame(TB_COB_ERROR_CONTROL, node, 1);
    frame.data[0] = (uint8_t)state;
    return frame;
}

void tb_heartbeat_start(tb_heartbeat *heartbeat)
{
    *heartbeat = unheard;
}

bool tb_heartbeat_take(tb_heartbeat *heartbeat, const tb_can_frame *frame)
{
    uint8_t const state = (uint8_t)(frame->data[0] & STATE_MASK);
    if ((frame->length != 1) || !is_state(state)) {
        return false;
    }
    if ((state == TB_NMT_BOOTED) && (heartbeat->boots < UINT8_MAX)) {
        heartbeat->boots++;
    }
    heartbeat->state = state;
    heartbeat->age = 0;
    return true;
}

void tb_heartbeat_tick(tb_heartbeat *heartbeat)
{
    if (heartbeat->age < UINT32_MAX) {
        heartbeat->age++;
    }
}
