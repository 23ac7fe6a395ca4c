/* Real-time rights: what the system permits, and one notice about what it does not. */
#ifndef TB_REALTIME_H
#define TB_REALTIME_H

#include <stdbool.h>

#include "options.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Take the processor, the priority and the memory for good; with --priority 0 only the processor, as
 *  with --clock: a simulation waits for the program.
 *  What is not permitted is told in one notice, and the program goes on without; false, with a
 *  message, for a processor that does not exist. */
bool tb_realtime_enter(const tb_options *options);

#ifdef __cplusplus
}
#endif

#endif
