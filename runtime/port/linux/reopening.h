/* Adapters that went away and come back: a USB plug that was pulled, an interface taken down.
 *
 * A device that has gone is given back in FAULT, where nothing has torque: while its old descriptor
 * is held, the kernel gives its name to no other. The next reset opens the device again, a little
 * in every cycle, and reaches the supervisor when it is open, or cannot be: then the supervisor
 * finds the bus lost, and one more reset tries again. A sealed program must be started again, and
 * says so: the seal is there so that the control loop opens no file. */
#ifndef TB_REOPENING_H
#define TB_REOPENING_H

#include <stddef.h>

#include "buses.h"
#include "options.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What became of a bus. */
typedef enum {
    TB_BUS_PRESENT = 0,
    TB_BUS_GONE,    /* given back, not asked for since */
    TB_BUS_OPENING, /* a reset waits for it */
    TB_BUS_REFUSED  /* could not be opened: `why` */
} tb_bus_presence;

/** What is remembered of the buses that went away. */
typedef struct {
    const tb_options *options;
    tb_bus_ports *buses;
    tb_bus_presence presence[TB_BUSES];
    tb_can_result why[TB_BUSES];
} tb_reopening;

/** Once a cycle, before it runs. state: of the supervisor. Returns those of the requests that it is
 *  to hear in this cycle. What happens is told on stderr. */
uint32_t tb_reopen(tb_reopening *reopening, uint8_t state, uint32_t requests);

/** Add what to do about the first bus that is not there to a sentence in `room` bytes; nothing
 *  where all are. */
void tb_reopening_tell(const tb_reopening *reopening, size_t room, char text[]);

#ifdef __cplusplus
}
#endif

#endif
