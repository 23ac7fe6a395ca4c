#include "emcy.h"

#include <stddef.h>

#include "drive_kind.h"
#include "little_endian.h"

#define EMCY_LENGTH 8

/* Error codes from one to another, both included. */
typedef struct {
    uint16_t first;
    uint16_t last;
    const char *text;
} tb_code_text;

#define GROUP(first) (first), ((first) + 0xFFu)
#define KIND(first) (first), ((first) + 0xFFFu)
#define ONE(code) (code), (code)

/* Error codes of CiA 301 and CiA 402; the first that fits counts, the groups come last. */
static const tb_code_text texts[] = {
    {ONE(0x0000), "no error"},
    {ONE(0x1000), "generic error"},
    {ONE(0x2310), "overcurrent"},
    {ONE(0x3210), "supply voltage too high"},
    {ONE(0x3220), "supply voltage too low"},
    {ONE(0x4210), "power stage too hot"},
    {ONE(0x7320), "position sensor error"},
    {ONE(0x8110), "CAN overrun: messages lost"},
    {ONE(0x8120), "CAN error passive: check the wiring and the termination"},
    {ONE(0x8130), "heartbeat of the master missed"},
    {ONE(0x8140), "recovered from bus-off"},
    {ONE(0x8150), "identifier used twice: is a node number given to two drives?"},
    {ONE(0x8210), "process data of wrong length"},
    {ONE(0x8250), "process data came too late"},
    {ONE(0x8611), "following error"},
    {GROUP(0x8100), "communication error"},
    {GROUP(0x8200), "protocol error"},
    {KIND(0x1000), "generic error"},
    {KIND(0x2000), "current error"},
    {KIND(0x3000), "voltage error"},
    {KIND(0x4000), "temperature error"},
    {KIND(0x5000), "hardware error"},
    {KIND(0x6000), "software error"},
    {KIND(0x7000), "error of an additional module"},
    {KIND(0x8000), "monitoring error"},
    {GROUP(0x9000), "external error"},
    {GROUP(0xFF00), "error of the device"}};

static const char unknown[] = "unknown error";

const char *tb_emcy_text(uint16_t code)
{
    for (size_t i = 0; i < (sizeof texts / sizeof texts[0]); i++) {
        if ((code >= texts[i].first) && (code <= texts[i].last)) {
            return texts[i].text;
        }
    }
    return unknown;
}

tb_error_class tb_emcy_class(uint16_t code)
{
    if (code == 0x0000) {
        return TB_ERROR_NONE;
    }
    return ((code & 0xFF00u) == 0x8100u) ? TB_ERROR_COMMUNICATION : TB_ERROR_FAULT;
}

bool tb_emcy_take(tb_emcy *emergency, const tb_drive_kind *kind, const tb_can_frame *frame)
{
    if (frame->length != EMCY_LENGTH) {
        return false;
    }
    uint16_t const code = tb_get_u16(frame->data);
    tb_emcy const said = {.code = code,
                          .error_class = (uint8_t)tb_drive_kind_error_class(kind, code)};
    if ((said.code == 0) || (said.error_class > emergency->error_class)) {
        *emergency = said;
    }
    return true;
}
