#include <stdio.h>

#include "adapters.h"

/* No filter: a node that the machine file does not know shall be seen. The bit rate is set up with the
 * interface, not by a program. */
static tb_can_result open_interface(tb_adapter_memory *memory, const char *device,
                                    uint32_t bit_rate)
{
    static const tb_socketcan_options every_frame;
    (void)bit_rate;
    return tb_socketcan_open(&memory->socketcan, device, &every_frame);
}

/* Opening an interface never waits. */
static tb_can_result proceed(tb_adapter_memory *memory)
{
    (void)memory;
    return TB_CAN_OK;
}

static const char *advice(tb_can_result result, const char *device, uint32_t bit_rate, size_t room,
                          char text[])
{
    if (result == TB_CAN_NO_PERMISSION) {
        return "no permission; a sandbox (container, RestrictAddressFamilies of systemd) keeps the "
               "program from CAN: allow AF_CAN";
    }
    if (result != TB_CAN_DOWN) {
        return NULL;
    }
    snprintf(text, room, "the interface is down; sudo ip link set %s up type can bitrate %u",
             device, (unsigned)bit_rate);
    return text;
}

const tb_adapter tb_adapter_socketcan = {
    .name = "socketcan",
    .example = "can0",
    .meaning = "behind an interface of the kernel",
    .open = open_interface,
    .begin = open_interface,
    .proceed = proceed,
    .advice = advice,
};
