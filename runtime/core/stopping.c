#include "drive_orders.h"
#include "states.h"
#include "transition.h"

/* Cycles of each of the two ramps of a soft stop. */
#define RAMP_CYCLES ((uint32_t)TB_STOP_CYCLES / 2)
/* Cycles that a drive may take to switch off; after them FAULT withholds the heartbeat. */
#define OFF_TIMEOUT ((uint32_t)TB_HEARTBEAT_TIMEOUT)

static void end_tasks(tb_supervisor *supervisor)
{
    tb_order_task(supervisor, tb_all_drives, TB_TASK_NONE);
    for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
        tb_order_homing(supervisor, i, false);
    }
}

/* A base that a state does not hold moves by itself, in its homing, or is off already. */
static void release_unguided_bases(tb_supervisor *supervisor)
{
    for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
        if (supervisor->guide.guided[i - TB_CABLES] == 0) {
            tb_order_goal(supervisor, (tb_drive_range){i, i + 1}, TB_GOAL_OFF);
        }
    }
}

void tb_begin_soft_stop(tb_supervisor *supervisor)
{
    end_tasks(supervisor);
    release_unguided_bases(supervisor);
    for (size_t i = 0; i < TB_CABLES; i++) {
        supervisor->drives[i].released = supervisor->drives[i].sent;
    }
    tb_enter(supervisor, TB_STATE_SOFT_STOP, TB_PHASE_RELAX);
}

/* What a cable keeps after the first ramp. */
static real_t relaxed(const tb_drive_memory *cable)
{
    return tb_min(cable->released, TB_DRUM_RADIUS * TB_TENSION_MIN);
}

static real_t share_done(const tb_supervisor *supervisor)
{
    return tb_min((real_t)supervisor->cycles / (real_t)RAMP_CYCLES, TB_C(1.0));
}

/* Bases are pushed no more: a force that was to move a carriage would go on to do so, and nothing
 * would end that motion. */
static void relax(tb_supervisor *supervisor)
{
    real_t const done = share_done(supervisor);
    for (size_t i = 0; i < TB_CABLES; i++) {
        tb_drive_memory *const cable = &supervisor->drives[i];
        real_t const excess = cable->released - relaxed(cable);
        cable->wanted.torque = cable->released - (done * excess);
    }
    if (supervisor->cycles >= RAMP_CYCLES) {
        tb_enter(supervisor, TB_STATE_SOFT_STOP, TB_PHASE_SLACKEN);
    }
}

static void slacken(tb_supervisor *supervisor)
{
    real_t const left = TB_C(1.0) - share_done(supervisor);
    for (size_t i = 0; i < TB_CABLES; i++) {
        tb_drive_memory *const cable = &supervisor->drives[i];
        cable->wanted.torque = left * relaxed(cable);
    }
    if (supervisor->cycles >= RAMP_CYCLES) {
        tb_order_goal(supervisor, tb_all_drives, TB_GOAL_OFF);
        tb_enter(supervisor, TB_STATE_SOFT_STOP, TB_PHASE_POWER_OFF);
    }
}

static tb_blame await_power_off(tb_supervisor *supervisor, const tb_observation *seen)
{
    if (tb_have_reached(supervisor, tb_all_drives)) {
        if (supervisor->first.cause == TB_CAUSE_REQUESTED) {
            tb_enter(supervisor, TB_STATE_CONFIGURE, TB_PHASE_READY);
        } else {
            tb_begin_fault(supervisor);
        }
    } else if (supervisor->cycles > OFF_TIMEOUT) {
        tb_blame const stuck = tb_blame_stuck(supervisor, seen, tb_all_drives);
        tb_begin_fault(supervisor);
        return stuck;
    }
    return tb_no_blame();
}

tb_blame tb_soft_stop(tb_supervisor *supervisor, const tb_observation *seen)
{
    switch (supervisor->phase) {
    case TB_PHASE_RELAX:
        relax(supervisor);
        return tb_no_blame();
    case TB_PHASE_SLACKEN:
        slacken(supervisor);
        return tb_no_blame();
    default:
        return await_power_off(supervisor, seen);
    }
}

void tb_begin_hard_stop(tb_supervisor *supervisor)
{
    end_tasks(supervisor);
    tb_order_goal(supervisor, tb_base_drives, TB_GOAL_OFF);
    tb_enter(supervisor, TB_STATE_HARD_STOP, TB_PHASE_SLACKEN);
}

static bool are_cables_slack(const tb_supervisor *supervisor)
{
    bool slack = true;
    for (size_t i = 0; i < TB_CABLES; i++) {
        slack = slack && !(supervisor->drives[i].sent > TB_C(0.0));
    }
    return slack;
}

void tb_hard_stop(tb_supervisor *supervisor)
{
    if (supervisor->phase == TB_PHASE_SLACKEN) {
        if (are_cables_slack(supervisor)) {
            tb_order_goal(supervisor, tb_all_drives, TB_GOAL_OFF);
            tb_enter(supervisor, TB_STATE_HARD_STOP, TB_PHASE_POWER_OFF);
        }
    } else if (tb_have_reached(supervisor, tb_all_drives) || (supervisor->cycles > OFF_TIMEOUT)) {
        tb_begin_fault(supervisor);
    }
}

void tb_begin_fault(tb_supervisor *supervisor)
{
    end_tasks(supervisor);
    tb_order_goal(supervisor, tb_all_drives, TB_GOAL_OFF);
    tb_enter(supervisor, TB_STATE_FAULT, TB_PHASE_NONE);
}
