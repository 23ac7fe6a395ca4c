#include "can.h"

#define MOST_CLASSIC_DATA 8u
#define MOST_STANDARD_ID 0x7FFu
#define MOST_EXTENDED_ID 0x1FFFFFFFu
#define LENGTH_CODES 16u

/* ISO 11898-1: the codes beyond 8 count in steps, CAN FD only. */
static const uint8_t lengths[LENGTH_CODES] = {0, 1,  2,  3,  4,  5,  6,  7,
                                              8, 12, 16, 20, 24, 32, 48, 64};

static const char *const texts[TB_CAN_RESULTS] = {
    [TB_CAN_OK] = "all is well",
    [TB_CAN_EMPTY] = "no frame is waiting",
    [TB_CAN_FULL] = "frames cannot be sent: does anything on the bus acknowledge them?",
    [TB_CAN_CLOSED] = "it is not open, or has gone: check its plug, or set the interface up again",
    [TB_CAN_REFUSED] = "it refuses this: does it carry such frames, and is the adapter in order?",
    [TB_CAN_NO_DEVICE] = "there is no such interface or device: check its name and its plug",
    [TB_CAN_NO_PERMISSION] = "this user may not use it: join the group that owns the device",
    [TB_CAN_BUSY] = "another program uses it: end that program first",
    [TB_CAN_NOT_CAN] = "it is there, but is no CAN interface and no serial line",
    [TB_CAN_DOWN] = "the interface is down: ip link set NAME up type can bitrate RATE",
    [TB_CAN_BIT_RATE] = "it cannot run at this bit rate",
    [TB_CAN_UNSUPPORTED] = "this kernel has no SocketCAN: load can_raw, or use slcan",
};

bool tb_can_is_frame(const tb_can_frame *frame)
{
    bool const extended = (frame->flags & TB_CAN_EXTENDED) != 0;
    bool const remote = (frame->flags & TB_CAN_REMOTE) != 0;
    bool const fd = (frame->flags & TB_CAN_FD) != 0;
    bool const fast = (frame->flags & TB_CAN_BIT_RATE_SWITCH) != 0;
    uint8_t const known = TB_CAN_EXTENDED | TB_CAN_REMOTE | TB_CAN_FD | TB_CAN_BIT_RATE_SWITCH;
    if (((frame->flags & ~known) != 0) || (remote && fd) || (fast && !fd)) {
        return false;
    }
    if (frame->id > (extended ? MOST_EXTENDED_ID : MOST_STANDARD_ID)) {
        return false;
    }
    if (!fd) {
        return frame->length <= MOST_CLASSIC_DATA;
    }
    return (frame->length <= TB_CAN_MOST_DATA) &&
           (lengths[tb_can_code_of_length(frame->length)] == frame->length);
}

uint8_t tb_can_length_of_code(uint8_t code)
{
    return lengths[code % LENGTH_CODES];
}

uint8_t tb_can_code_of_length(uint8_t length)
{
    uint8_t code = 0;
    while ((code < LENGTH_CODES - 1u) && (lengths[code] < length)) {
        code++;
    }
    return code;
}

const char *tb_can_result_text(tb_can_result result)
{
    /* as an unsigned number: an ARM compiler may give the enumeration no negative values to compare */
    unsigned const index = (unsigned)result;
    return (index < (unsigned)TB_CAN_RESULTS) ? texts[index] : "unknown result";
}
