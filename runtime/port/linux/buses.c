#include "buses.h"

#include <stdio.h>

#include "say.h"

#define LONGEST_ADVICE (TB_LONGEST_DEVICE + 160)

static void say_why(const tb_bus_table *bus, const tb_bus_option *option, tb_can_result result)
{
    char room[LONGEST_ADVICE];
    const tb_adapter *const adapter = option->adapter;
    const char *const advice =
        adapter->advice(result, option->device, bus->bit_rate, sizeof room, room);
    tb_say("--bus %s=%s:%s: %s", bus->name, adapter->name, option->device,
           (advice == NULL) ? tb_can_result_text(result) : advice);
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
        tb_can_result const result =
            option->adapter->open(&buses->drivers[i], option->device, tb_buses[i].bit_rate);
        buses->ports[i] = &buses->drivers[i].port;
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
    tb_can_result const result =
        option->adapter->begin(&buses->drivers[i], option->device, tb_buses[i].bit_rate);
    buses->ports[i]->statistics = counted;
    return result;
}

tb_can_result tb_buses_proceed(tb_bus_ports *buses, size_t i, const tb_bus_option *option)
{
    return option->adapter->proceed(&buses->drivers[i]);
}

void tb_buses_name(const tb_bus_option *option, size_t room, char name[])
{
    snprintf(name, room, "%s:%s", option->adapter->name, option->device);
}

void tb_buses_close(tb_bus_ports *buses)
{
    close_first(buses, TB_BUSES);
}
