/* The machine's buses, opened. */
#ifndef TB_BUS_PORTS_H
#define TB_BUS_PORTS_H

#include <stdbool.h>
#include <stddef.h>

#include "adapters.h"
#include "can.h"
#include "options.h"
#include "tb_drives.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Ports of all buses, with the memory of their drivers. */
typedef struct {
    tb_adapter_memory drivers[TB_BUSES];
    tb_can_port *ports[TB_BUSES]; /* in the order of the machine file */
} tb_bus_ports;

/** Open every bus. False, with a message, where one cannot be: then none is open. */
bool tb_buses_open(tb_bus_ports *buses, const tb_options *options);

/** Begin to open bus number `i` again, which is closed. TB_CAN_EMPTY: it is under way; TB_CAN_OK: it
 *  is open; else why it cannot be. Never waits. */
tb_can_result tb_buses_begin(tb_bus_ports *buses, size_t i, const tb_bus_option *option);

/** Go on with it; the same answers. */
tb_can_result tb_buses_proceed(tb_bus_ports *buses, size_t i, const tb_bus_option *option);

/** How a bus is reached, as --bus has it: ADAPTER:DEVICE, cut where there is no room. */
void tb_buses_name(const tb_bus_option *option, size_t room, char name[]);

/** Give every bus back. */
void tb_buses_close(tb_bus_ports *buses);

#ifdef __cplusplus
}
#endif

#endif
