#include "emcy.h"

#include <stddef.h>

#include "little_endian.h"

#define EMCY_LENGTH 8

/* Error codes from one to another, both included. */
typedef struct {
    uint16_t first;
    uint16_t last;
    const char *text;
} tb_error_text;

#define GROUP(first) (first), ((first) + 0xFFu)
#define KIND(first) (first), ((first) + 0xFFFu)
#define ONE(code) (code), (code)

/* Error codes of the EPOS4; the first that fits counts, then the groups of CiA 301 and CiA 402. */
static const tb_error_text texts[] = {
    {ONE(0x0000), "no error"},
    {ONE(0x1000), "generic error"},
    {0x1080, 0x1088, "generic initialisation error"},
    {ONE(0x1090), "firmware and hardware do not fit"},
    {ONE(0x2310), "overcurrent"},
    {ONE(0x2320), "power stage protection"},
    {ONE(0x3210), "supply voltage too high"},
    {ONE(0x3220), "supply voltage too low"},
    {ONE(0x4210), "power stage too hot"},
    {ONE(0x4380), "motor too hot"},
    {ONE(0x5113), "logic supply voltage too low"},
    {0x5280, 0x5282, "hardware defect"},
    {0x5480, 0x5483, "hardware defect"},
    {ONE(0x6080), "sign of life error"},
    {ONE(0x6081), "extension watchdog"},
    {0x6180, 0x61F0, "internal software error"},
    {ONE(0x6320), "software parameter error"},
    {ONE(0x6380), "stored parameters corrupt"},
    {ONE(0x7320), "position sensor error"},
    {0x7380, 0x7382, "position sensor breach or hall sensor error; homing is lost"},
    {0x7388, 0x738A, "encoder or hall sensor error; homing is lost"},
    {0x738C, 0x738D, "SSI sensor error"},
    {0x7390, 0x7391, "sensor missing"},
    {ONE(0x7392), "sensor error; homing is lost"},
    {0x8110, 0x8111, "CAN overrun: messages lost"},
    {ONE(0x8120), "CAN error passive: check the wiring and the termination"},
    {ONE(0x8130), "heartbeat of the master missed"},
    {ONE(0x8140), "recovered from bus-off"},
    {ONE(0x8150), "identifier used twice: is a node number given to two drives?"},
    {0x8180, 0x8184, "EtherCAT communication error"},
    {ONE(0x81FD), "CAN bus-off"},
    {0x81FE, 0x81FF, "CAN queue overflow"},
    {ONE(0x8210), "process data of wrong length"},
    {ONE(0x8250), "process data came too late"},
    {0x8280, 0x8281, "EtherCAT process data error"},
    {ONE(0x8611), "following error"},
    {0x8A80, 0x8A81, "limit switch"},
    {ONE(0x8A82), "software position limit"},
    {ONE(0x8A88), "safe torque off: is the emergency stop pressed?"},
    {ONE(0xFF01), "overloaded (warning)"},
    {ONE(0xFF02), "watchdog; homing is lost"},
    {ONE(0xFF0B), "peak overload"},
    {ONE(0xFF10), "controller gain error"},
    {0xFF11, 0xFF24, "auto tuning error"},
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
    if (code == 0xFF01) {
        return TB_ERROR_WARNING;
    }
    return ((code & 0xFF00u) == 0x8100u) ? TB_ERROR_COMMUNICATION : TB_ERROR_FAULT;
}

bool tb_emcy_take(tb_emcy *emergency, const tb_can_frame *frame)
{
    if (frame->length != EMCY_LENGTH) {
        return false;
    }
    tb_emcy const said = {.code = tb_get_u16(frame->data),
                          .error_class = (uint8_t)tb_emcy_class(tb_get_u16(frame->data))};
    if ((said.code == 0) || (said.error_class > emergency->error_class)) {
        *emergency = said;
    }
    return true;
}
