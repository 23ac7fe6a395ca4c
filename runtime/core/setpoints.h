/* Setpoints: every order passes its motor's gate here, and nowhere else does one leave. */
#ifndef TB_SETPOINTS_H
#define TB_SETPOINTS_H

#include <stdbool.h>

#include "supervisor_memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Gate what is wanted of every drive into its order. */
void tb_gate_setpoints(tb_supervisor *supervisor, const tb_observation *seen,
                       tb_drive_order orders[TB_DRIVES]);

/** Whether the remembered setpoints are ones that the gates can have let through. */
bool tb_are_setpoints_intact(const tb_supervisor *supervisor);

#ifdef __cplusplus
}
#endif

#endif
