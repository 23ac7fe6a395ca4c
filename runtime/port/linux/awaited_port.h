/* A port in front of a driver's: receiving waits for frames of which it is known that they are on
 * their way, for as long as that takes a computer that is busy.
 *
 * Both directions are counted, also where the driver begins its own counting anew. */
#ifndef TB_AWAITED_PORT_H
#define TB_AWAITED_PORT_H

#include <stdbool.h>
#include <stdint.h>

#include "can.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The port, and what it knows of the frames on their way. */
typedef struct {
    tb_can_port port;  /* first; its statistics are the driver's */
    tb_can_port *line; /* the driver's */
    uint64_t sent;
    uint64_t received;
    uint64_t promised; /* frames that have been put on their way to us, from the first one on */
    bool deceived;     /* some of them did not come, and the wait was given up */
} tb_awaited_port;

/** Stand in front of an opened port. */
void tb_awaited_port_start(tb_awaited_port *awaited, tb_can_port *line);

#ifdef __cplusplus
}
#endif

#endif
