/* What the machine does, and why it stopped: sentences with the names of the machine file. */
#ifndef TB_SENTENCE_H
#define TB_SENTENCE_H

#include <stddef.h>

#include "cycle.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What the machine does now. */
const char *tb_sentence_of_state(const tb_orders *orders);

/** Why it stopped, into `text` of `room` bytes; empty for no cause. */
void tb_sentence_of_cause(const tb_orders *orders, size_t room, char text[]);

#ifdef __cplusplus
}
#endif

#endif
