#define _DEFAULT_SOURCE /* fgetgrent */
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

/* Name of a group, "" where /etc/group has none; getgrgid would load libraries of the computer, which
 * a program that brings its own C library cannot rely on. */
static const char *name_of_group(gid_t number)
{
    FILE *const groups = fopen("/etc/group", "re");
    if (groups == NULL) {
        return "";
    }
    const struct group *group = fgetgrent(groups);
    while ((group != NULL) && (group->gr_gid != number)) {
        group = fgetgrent(groups);
    }
    (void)fclose(groups);
    return (group == NULL) ? "" : group->gr_name;
}

/* Name of the group that may use a device. */
static const char *group_of(const char *path)
{
    struct stat about;
    const char *const name = (stat(path, &about) == 0) ? name_of_group(about.st_gid) : "";
    return (name[0] == '\0') ? "that owns it" : name;
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
