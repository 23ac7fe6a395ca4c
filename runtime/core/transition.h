/* From one state or phase of the supervisor to another. */
#ifndef TB_TRANSITION_H
#define TB_TRANSITION_H

#include "supervisor_memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Go on to a phase; its first cycle is the next one. */
void tb_enter(tb_supervisor *supervisor, tb_state state, tb_phase phase);

#ifdef __cplusplus
}
#endif

#endif
