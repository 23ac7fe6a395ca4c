#include "drive_orders.h"
#include "hold.h"
#include "states.h"

/* While slack is wound in, a cable's torque falls with its speed and is gone at the first of these;
 * below the second it is tight. */
#define TIGHTEN_SPEED (TB_CABLE_SPEED_LIMIT * TB_C(0.1))
#define TIGHT_SPEED (TB_CABLE_SPEED_LIMIT * TB_C(0.01))
#define TIGHT_CYCLES 100u

static tb_drive_range base_of(const tb_supervisor *supervisor)
{
    return (tb_drive_range){supervisor->base, (size_t)supervisor->base + 1};
}

void tb_begin_home(tb_supervisor *supervisor)
{
    tb_guide_start(&supervisor->guide);
    for (size_t i = 0; i < TB_CABLES; i++) {
        tb_order_mode(supervisor, i, TB_MODE_TORQUE);
    }
    tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_CABLE_MODE);
}

/* A switch of modes by some drives: why it failed, else whether all have switched. */
static tb_blame await_mode(const tb_supervisor *supervisor, const tb_observation *seen,
                           tb_drive_range drives, bool *switched)
{
    *switched = tb_have_done(supervisor, seen, drives);
    tb_blame const blame = tb_find_failed_task(supervisor, seen, drives);
    if ((blame.cause == TB_CAUSE_NONE) && !*switched && (supervisor->cycles > TB_STATE_TIMEOUT)) {
        return tb_blame_for(TB_CAUSE_DRIVE_STUCK, drives.first,
                            seen->drives[drives.first].statusword);
    }
    return blame;
}

/* A power state of some drives: who has not reached it in time, else whether all have. */
static tb_blame await_power(const tb_supervisor *supervisor, const tb_observation *seen,
                            tb_drive_range drives, bool *reached)
{
    *reached = tb_have_reached(supervisor, drives);
    if (!*reached && (supervisor->cycles > TB_STATE_TIMEOUT)) {
        return tb_blame_stuck(supervisor, seen, drives);
    }
    return tb_no_blame();
}

static void power_on(tb_supervisor *supervisor, tb_drive_range drives, tb_phase next)
{
    tb_order_task(supervisor, drives, TB_TASK_NONE);
    tb_order_goal(supervisor, drives, TB_GOAL_ENABLED);
    tb_enter(supervisor, TB_STATE_HOME, next);
}

static tb_blame switch_cables(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool switched;
    tb_blame const blame = await_mode(supervisor, seen, tb_cable_drives, &switched);
    if (switched) {
        power_on(supervisor, tb_cable_drives, TB_PHASE_CABLE_POWER);
    }
    return blame;
}

static tb_blame power_cables(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool reached;
    tb_blame const blame = await_power(supervisor, seen, tb_cable_drives, &reached);
    if (reached) {
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_TIGHTEN);
    }
    return blame;
}

/* The next base to its homing; after the last one the sweep. */
static void go_on_with(tb_supervisor *supervisor, uint16_t base)
{
    supervisor->base = base;
    if (base < TB_DRIVES) {
        tb_order_mode(supervisor, base, TB_MODE_HOMING);
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_BASE_MODE);
    } else {
        tb_begin_sweep(supervisor);
    }
}

/* The cable that winds in fastest. */
static size_t fastest(const tb_supervisor *supervisor)
{
    size_t found = 0;
    for (size_t i = 1; i < TB_CABLES; i++) {
        if (tb_measured_speed(&supervisor->measurement, i) >
            tb_measured_speed(&supervisor->measurement, found)) {
            found = i;
        }
    }
    return found;
}

static tb_blame tighten(tb_supervisor *supervisor)
{
    bool tight = true;
    for (size_t i = 0; i < TB_CABLES; i++) {
        real_t const speed = tb_measured_speed(&supervisor->measurement, i);
        real_t const share = TB_C(1.0) - (speed / TIGHTEN_SPEED);
        tb_pull(supervisor, i, TB_TENSION_MIN * tb_min(tb_max(share, TB_C(0.0)), TB_C(1.0)));
        tight = tight && (TB_ABS(speed) < TIGHT_SPEED);
    }
    supervisor->calm = tight ? (supervisor->calm + 1) : 0;
    if (supervisor->calm >= TIGHT_CYCLES) {
        go_on_with(supervisor, TB_CABLES);
    } else if (supervisor->cycles > TB_STATE_TIMEOUT) {
        return tb_blame_for(TB_CAUSE_CABLE_SLACK, fastest(supervisor), 0);
    }
    return tb_no_blame();
}

static tb_blame switch_to_homing(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool switched;
    tb_blame const blame = await_mode(supervisor, seen, base_of(supervisor), &switched);
    if (switched) {
        power_on(supervisor, base_of(supervisor), TB_PHASE_BASE_POWER);
    }
    return blame;
}

static tb_blame power_homing(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool reached;
    tb_blame const blame = await_power(supervisor, seen, base_of(supervisor), &reached);
    if (reached) {
        supervisor->ran = 0;
        tb_order_homing(supervisor, supervisor->base, true);
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_BASE_HOMING);
    }
    return blame;
}

/* Until the drive was seen running, it may show how its last homing ended. */
static tb_blame run_homing(tb_supervisor *supervisor, const tb_observation *seen)
{
    const tb_drive_report *const report = &seen->drives[supervisor->base];
    if (report->homing == TB_HOMING_RUNNING) {
        supervisor->ran = 1;
    }
    bool const ran = supervisor->ran != 0;
    if (ran && (report->homing == TB_HOMING_DONE)) {
        tb_order_homing(supervisor, supervisor->base, false);
        tb_order_goal(supervisor, base_of(supervisor), TB_GOAL_OFF);
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_BASE_RELEASE);
    } else if ((ran && (report->homing != TB_HOMING_RUNNING)) ||
               (supervisor->cycles > TB_HOMING_TIMEOUT)) {
        return tb_blame_for(TB_CAUSE_HOMING, supervisor->base, report->statusword);
    }
    return tb_no_blame();
}

static tb_blame release_base(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool reached;
    tb_blame const blame = await_power(supervisor, seen, base_of(supervisor), &reached);
    if (reached) {
        tb_measurement_forget(&supervisor->measurement, supervisor->base);
        tb_order_mode(supervisor, supervisor->base, tb_working_mode(supervisor->base));
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_BASE_WORK_MODE);
    }
    return blame;
}

static tb_blame switch_to_work(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool switched;
    tb_blame const blame = await_mode(supervisor, seen, base_of(supervisor), &switched);
    if (switched) {
        power_on(supervisor, base_of(supervisor), TB_PHASE_BASE_WORK_POWER);
    }
    return blame;
}

static tb_blame power_work(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool reached;
    tb_blame const blame = await_power(supervisor, seen, base_of(supervisor), &reached);
    if (reached) {
        uint16_t const base = supervisor->base;
        tb_guide_take(&supervisor->guide, (size_t)base - TB_CABLES,
                      tb_measured_position(&supervisor->measurement, base));
        go_on_with(supervisor, (uint16_t)(base + 1));
    }
    return blame;
}

static tb_blame home_base(tb_supervisor *supervisor, const tb_observation *seen)
{
    switch (supervisor->phase) {
    case TB_PHASE_BASE_MODE:
        return switch_to_homing(supervisor, seen);
    case TB_PHASE_BASE_POWER:
        return power_homing(supervisor, seen);
    case TB_PHASE_BASE_HOMING:
        return run_homing(supervisor, seen);
    case TB_PHASE_BASE_RELEASE:
        return release_base(supervisor, seen);
    case TB_PHASE_BASE_WORK_MODE:
        return switch_to_work(supervisor, seen);
    default:
        return power_work(supervisor, seen);
    }
}

tb_blame tb_home(tb_supervisor *supervisor, const tb_observation *seen)
{
    switch (supervisor->phase) {
    case TB_PHASE_CABLE_MODE:
        return switch_cables(supervisor, seen);
    case TB_PHASE_CABLE_POWER:
        return power_cables(supervisor, seen);
    case TB_PHASE_TIGHTEN:
        return tighten(supervisor);
    case TB_PHASE_GATHER:
    case TB_PHASE_SWEEP:
    case TB_PHASE_SOLVE:
        return tb_sweep(supervisor, seen);
    default:
        tb_hold_cables(supervisor);
        tb_blame const lost = tb_hold_bases(supervisor);
        tb_blame const blame = home_base(supervisor, seen);
        return (lost.cause == TB_CAUSE_NONE) ? blame : lost;
    }
}
