/* Real-time rights: what the system permits, and one notice about what it does not. */
#ifndef TB_REALTIME_H
#define TB_REALTIME_H

#include <stdbool.h>

#include "options.h"

/** Lock the memory, touch the stack, take the processor and the priority. What is not permitted is
 *  told in one notice, and the program goes on without; false for a processor that does not exist. */
bool tb_realtime_enter(const tb_options *options);

#endif
