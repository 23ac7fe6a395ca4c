/* The clock of a simulation: another program, which simulates what is on the buses, lets time pass.
 *
 * Frames go over the buses as ever. Beside them a unix socket (SOCK_SEQPACKET) carries one message
 * either way for every sleep of the control loop, a tb_moment:
 *
 *   to the simulation   until when the program sleeps, and the frames it has sent on every bus
 *   back                what time it is, and the frames the simulation has sent on every bus
 *
 * A frame may need a while of the computer's time: a pseudo-terminal hands bytes on when the kernel
 * gets round to it. So nobody goes on before the frames are through that the other has counted: the
 * simulation reads that many from every bus before it lets time pass, and the program's ports wait
 * for that many before they say that nothing has come. A cycle then begins when the frames of the
 * last one are through, whatever the computer does; computing takes no time.
 *
 * When the simulation ends, or is not heard for ten minutes of the computer's time, the clock has
 * stopped. */
#ifndef TB_SIMULATED_CLOCK_H
#define TB_SIMULATED_CLOCK_H

#include <stdbool.h>
#include <stdint.h>

#include "awaited_port.h"
#include "clock.h"
#include "tb_drives.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What either side tells the other; native byte order, without gaps. */
typedef struct {
    int64_t time;              /* ns */
    uint64_t frames[TB_BUSES]; /* since the connection; of every bus, as in the machine file */
} tb_moment;

/** The clock, and the ports for whoever lives by it. */
typedef struct {
    tb_clock clock; /* first */
    const char *path;
    int socket;
    int64_t time; /* ns */
    tb_awaited_port awaited[TB_BUSES];
    tb_can_port *ports[TB_BUSES]; /* in front of the buses' own */
} tb_simulated_clock;

/** Connect to the simulation at a path, in front of opened ports; keep the path. False, with a
 *  message, where nobody is there who keeps time. */
bool tb_simulated_clock_open(tb_simulated_clock *clock, const char *path,
                             tb_can_port *const ports[TB_BUSES]);

#ifdef __cplusplus
}
#endif

#endif
