/* Faults: what is wrong in this cycle with loop, buses, drives and encoders. What only a state can
 * tell (a task that failed, cables that do not close) its own file finds. */
#ifndef TB_FAULTS_H
#define TB_FAULTS_H

#include <stdbool.h>

#include "supervisor_memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Whether a cause leaves no time for a soft stop. */
bool tb_is_hard(tb_cause cause);

/** Whether a drive is in its fault state, or says that it goes there. */
bool tb_is_in_fault(const tb_drive_report *report);

/** Who to blame where a drive cannot be relied on to obey: itself, and whether it is silent or under
 *  local control. */
tb_blame tb_blame_silent(const tb_drive_report *report, size_t index);

/** The worst that is wrong in this cycle of a state before HARD_STOP. */
tb_blame tb_find_fault(tb_supervisor *supervisor, const tb_observation *seen);

#ifdef __cplusplus
}
#endif

#endif
