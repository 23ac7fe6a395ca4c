/* Orders to groups of drives, and whether they were carried out. */
#ifndef TB_DRIVE_ORDERS_H
#define TB_DRIVE_ORDERS_H

#include <stdbool.h>
#include <stddef.h>

#include "supervisor_memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Drives from `first` up to, but without, `end`. */
typedef struct {
    size_t first;
    size_t end;
} tb_drive_range;

static const tb_drive_range tb_all_drives = {0, TB_DRIVES};
static const tb_drive_range tb_cable_drives = {0, TB_CABLES};
static const tb_drive_range tb_base_drives = {TB_CABLES, TB_DRIVES};

/** Mode in which a drive works. */
tb_mode tb_working_mode(size_t drive);

/** Whether a drive follows a position at work. */
bool tb_follows_position(size_t drive);

/** Order a power state. Drives that had another one before get time to show the new one. */
void tb_order_goal(tb_supervisor *supervisor, tb_drive_range drives, tb_goal goal);

/** Order a task. */
void tb_order_task(tb_supervisor *supervisor, tb_drive_range drives, tb_task task);

/** Order one drive to switch to a mode. */
void tb_order_mode(tb_supervisor *supervisor, size_t drive, tb_mode mode);

/** Start or stop a drive's homing. */
void tb_order_homing(tb_supervisor *supervisor, size_t drive, bool run);

/** Note which drives have reached their power state; once a cycle, first. */
void tb_observe_power(tb_supervisor *supervisor, const tb_observation *seen);

/** Whether a power state is the one that a goal asks for. */
bool tb_is_power_of(tb_goal goal, tb_power power);

/** Whether every drive has reached its power state. */
bool tb_have_reached(const tb_supervisor *supervisor, tb_drive_range drives);

/** First drive that has not reached its power state, to blame it; call it when there is one. */
tb_blame tb_blame_stuck(const tb_supervisor *supervisor, const tb_observation *seen,
                        tb_drive_range drives);

/** Whether every drive's task is done; with a mode, that it is the ordered one. */
bool tb_have_done(const tb_supervisor *supervisor, const tb_observation *seen,
                  tb_drive_range drives);

/** A switch of modes by some drives: why it failed, else whether all have switched. */
tb_blame tb_await_mode(const tb_supervisor *supervisor, const tb_observation *seen,
                       tb_drive_range drives, bool *switched);

/** A power state of some drives: who has not reached it in time, else whether all have. */
tb_blame tb_await_power(const tb_supervisor *supervisor, const tb_observation *seen,
                        tb_drive_range drives, bool *reached);

/** Power for some drives that have switched to their mode. */
void tb_power_on(tb_supervisor *supervisor, tb_drive_range drives);

/** Why the ordered task failed, for the first drive whose did. */
tb_blame tb_find_failed_task(const tb_supervisor *supervisor, const tb_observation *seen,
                             tb_drive_range drives);

#ifdef __cplusplus
}
#endif

#endif
