/* The machine's buses, opened. */
#ifndef TB_BUS_PORTS_H
#define TB_BUS_PORTS_H

#include <stdbool.h>

#include "can.h"
#include "options.h"
#include "slcan.h"
#include "socketcan.h"
#include "tb_drives.h"

/** Ports of all buses, with the memory of their drivers. */
typedef struct {
    union {
        tb_slcan slcan;
        tb_socketcan socketcan;
    } drivers[TB_BUSES];
    tb_can_port *ports[TB_BUSES]; /* in the order of the machine file */
} tb_bus_ports;

/** Open every bus. False, with a message, where one cannot be: then none is open. */
bool tb_buses_open(tb_bus_ports *buses, const tb_options *options);

/** Give every bus back. */
void tb_buses_close(tb_bus_ports *buses);

#endif
