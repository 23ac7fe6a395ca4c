#define _DEFAULT_SOURCE /* struct group */
#include "buses.h"

#include <grp.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include "say.h"

/* No filter: a node that the machine file does not know shall be seen. */
static const tb_socketcan_options every_frame;

static const char *adapter_of(const tb_bus_option *option)
{
    return (option->adapter == TB_ADAPTER_SLCAN) ? "slcan" : "socketcan";
}

static tb_can_result open_port(tb_bus_ports *buses, size_t i, const tb_bus_option *option)
{
    if (option->adapter == TB_ADAPTER_SLCAN) {
        buses->ports[i] = &buses->drivers[i].slcan.port;
        return tb_slcan_open(&buses->drivers[i].slcan, option->device, tb_buses[i].bit_rate);
    }
    buses->ports[i] = &buses->drivers[i].socketcan.port;
    return tb_socketcan_open(&buses->drivers[i].socketcan, option->device, &every_frame);
}

/* Name of the group that may use a device. */
static const char *group_of(const char *path)
{
    struct stat about;
    const struct group *const group = (stat(path, &about) == 0) ? getgrgid(about.st_gid) : NULL;
    return (group == NULL) ? "that owns it" : group->gr_name;
}

static void say_permission(const char *bus, const tb_bus_option *option)
{
    if (option->adapter == TB_ADAPTER_SLCAN) {
        tb_say("--bus %s=slcan:%s: no permission; become a member of the group %s (sudo usermod "
               "-aG %s USER) and log in again",
               bus, option->device, group_of(option->device), group_of(option->device));
    } else {
        tb_say("--bus %s=socketcan:%s: no permission; a sandbox (container, "
               "RestrictAddressFamilies of "
               "systemd) keeps the program from CAN: allow AF_CAN",
               bus, option->device);
    }
}

static void say_why(const tb_bus_table *bus, const tb_bus_option *option, tb_can_result result)
{
    const char *const adapter = adapter_of(option);
    if (result == TB_CAN_NO_PERMISSION) {
        say_permission(bus->name, option);
    } else if (result == TB_CAN_DOWN) {
        tb_say("--bus %s=%s:%s: the interface is down; sudo ip link set %s up type can bitrate %u",
               bus->name, adapter, option->device, option->device, (unsigned)bus->bit_rate);
    } else {
        tb_say("--bus %s=%s:%s: %s", bus->name, adapter, option->device,
               tb_can_result_text(result));
    }
}

static void close_first(tb_bus_ports *buses, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        tb_can_close(buses->ports[i]);
    }
}

bool tb_buses_open(tb_bus_ports *buses, const tb_options *options)
{
    for (size_t i = 0; i < TB_BUSES; i++) {
        const tb_bus_option *const option = &options->buses[i];
        tb_can_result const result = open_port(buses, i, option);
        if (result != TB_CAN_OK) {
            say_why(&tb_buses[i], option, result);
            close_first(buses, i);
            return false;
        }
    }
    return true;
}

/* What was counted goes on: to those who read the counters it is the same bus. */
tb_can_result tb_buses_begin(tb_bus_ports *buses, size_t i, const tb_bus_option *option)
{
    tb_can_statistics const counted = buses->ports[i]->statistics;
    tb_can_result result;
    if (option->adapter == TB_ADAPTER_SLCAN) {
        result = tb_slcan_begin(&buses->drivers[i].slcan, option->device, tb_buses[i].bit_rate);
    } else {
        result = tb_socketcan_open(&buses->drivers[i].socketcan, option->device, &every_frame);
    }
    buses->ports[i]->statistics = counted;
    return result;
}

tb_can_result tb_buses_proceed(tb_bus_ports *buses, size_t i, const tb_bus_option *option)
{
    return (option->adapter == TB_ADAPTER_SLCAN) ? tb_slcan_proceed(&buses->drivers[i].slcan)
                                                 : TB_CAN_OK;
}

void tb_buses_name(const tb_bus_option *option, size_t room, char name[])
{
    snprintf(name, room, "%s:%s", adapter_of(option), option->device);
}

void tb_buses_close(tb_bus_ports *buses)
{
    close_first(buses, TB_BUSES);
}
