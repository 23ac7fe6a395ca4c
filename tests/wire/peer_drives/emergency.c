/* Emergencies of a drive (CiA 301, 7.2.7): message, error register, history, what each leads to. */
#include "peer.h"

typedef enum { POWER_OFF, FAULT_OPTION, CONNECTION, WARNING } reaction;

static reaction reaction_of(uint16_t const code)
{
    static uint16_t const ramped[] = {0x6320, 0x8611, 0x8A80, 0x8A81, 0x8A82, 0xFF10};
    static uint16_t const connection[] = {0x6081, 0x8110, 0x8111, 0x8120, 0x8130, 0x8150,
                                          0x81FD, 0x81FE, 0x81FF, 0x8210, 0x8250};
    if (code == 0xFF01) {
        return WARNING;
    }
    for (size_t i = 0; i < sizeof ramped / sizeof ramped[0]; i++) {
        if (ramped[i] == code) {
            return FAULT_OPTION;
        }
    }
    for (size_t i = 0; i < sizeof connection / sizeof connection[0]; i++) {
        if (connection[i] == code) {
            return CONNECTION;
        }
    }
    return POWER_OFF;
}

static bool loses_home(uint16_t const code)
{
    static uint16_t const codes[] = {0x7380, 0x7381, 0x7382, 0x7388,
                                     0x7389, 0x738A, 0x7392, 0xFF02};
    bool found = false;
    for (size_t i = 0; i < sizeof codes / sizeof codes[0]; i++) {
        found = found || codes[i] == code;
    }
    return found;
}

bool emergency_is_latched(uint16_t const code)
{
    return code == 0x8120 || code == 0x8130 || code == 0x81FD;
}

/* Bits of the error register by the class of the code. */
static uint8_t register_bits(uint16_t const code)
{
    switch (code >> 12) {
    case 0x0: return 0;
    case 0x2: return 0x03;
    case 0x3: return 0x05;
    case 0x4: return 0x09;
    case 0x7: return 0x81;
    case 0x8: return (code & 0xF00) <= 0x200 ? 0x11 : 0x21;
    default: return 0x01;
    }
}

void emergency_send(drive *const d, uint16_t const code)
{
    uint8_t const errors = (uint8_t)d->value[O_ERROR_REGISTER];
    uint8_t const data[8] = {(uint8_t)code, (uint8_t)(code >> 8), errors};
    if (d->nmt == PEER_PRE_OPERATIONAL || d->nmt == PEER_OPERATIONAL) {
        drive_transmit(d, 0x80 + d->config.node, data, 8, d->peer->now);
    }
}

static void remember(drive *const d, uint16_t const code)
{
    int64_t *const history = &d->value[O_HISTORY];
    memmove(&history[2], &history[1], 4 * sizeof history[0]);
    history[1] = code;
    history[0] += history[0] < 5 ? 1 : 0;
}

void emergency_raise(drive *const d, uint16_t const code)
{
    reaction const wanted = reaction_of(code);
    d->value[O_ERROR_REGISTER] |= register_bits(code);
    d->value[O_ERROR_CODE] = code;
    remember(d, code);
    emergency_send(d, code);
    if (wanted == WARNING) {
        d->power.warning = true;
    } else if (wanted != CONNECTION) {
        d->power.referenced_off = d->power.referenced_off || loses_home(code);
        cia402_fault(d, wanted == FAULT_OPTION);
    }
}

void emergency_cleared(drive *const d)
{
    d->value[O_ERROR_REGISTER] = 0;
    d->value[O_ERROR_CODE] = 0;
    d->power.warning = false;
    emergency_send(d, 0x0000);
}

void peer_raise(peer *const p, uint32_t const number, uint16_t const code)
{
    drive *const d = &p->drive[number];
    if (reaction_of(code) == CONNECTION) {
        cia402_connection_lost(d, code);
    } else {
        emergency_raise(d, code);
    }
}
