#define _DEFAULT_SOURCE /* struct group */
#include <grp.h>
#include <stdio.h>
#include <sys/stat.h>

#include "adapters.h"

static tb_can_result open_line(tb_adapter_memory *memory, const char *device, uint32_t bit_rate)
{
    return tb_slcan_open(&memory->slcan, device, bit_rate);
}

static tb_can_result begin(tb_adapter_memory *memory, const char *device, uint32_t bit_rate)
{
    return tb_slcan_begin(&memory->slcan, device, bit_rate);
}

static tb_can_result proceed(tb_adapter_memory *memory)
{
    return tb_slcan_proceed(&memory->slcan);
}

/* Name of the group that may use a device. */
static const char *group_of(const char *path)
{
    struct stat about;
    const struct group *const group = (stat(path, &about) == 0) ? getgrgid(about.st_gid) : NULL;
    return (group == NULL) ? "that owns it" : group->gr_name;
}

static const char *advice(tb_can_result result, const char *device, uint32_t bit_rate, size_t room,
                          char text[])
{
    (void)bit_rate;
    if (result != TB_CAN_NO_PERMISSION) {
        return NULL;
    }
    snprintf(text, room,
             "no permission; become a member of the group %s (sudo usermod -aG %s USER) and log in "
             "again",
             group_of(device), group_of(device));
    return text;
}

const tb_adapter tb_adapter_slcan = {
    .name = "slcan",
    .example = "/dev/ttyACM0",
    .meaning = "behind a serial CAN adapter",
    .open = open_line,
    .begin = begin,
    .proceed = proceed,
    .advice = advice,
};
