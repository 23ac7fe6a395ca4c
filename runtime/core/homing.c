#include "drive_orders.h"
#include "hold.h"
#include "states.h"
#include "transition.h"

/* While slack is wound in, a cable's torque falls with its speed and is gone at the first of these;
 * below the second it is tight, though a carriage that is free may glide towards the platform. */
#define TIGHTEN_SPEED (TB_CABLE_SPEED_LIMIT * TB_C(0.1))
#define TIGHT_SPEED (TB_CABLE_SPEED_LIMIT * TB_C(0.03))
#define TIGHT_CYCLES 100u

void tb_begin_home(tb_supervisor *supervisor)
{
    tb_guide_start(&supervisor->guide);
    for (size_t i = 0; i < TB_CABLES; i++) {
        tb_order_mode(supervisor, i, TB_MODE_TORQUE);
    }
    tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_CABLE_MODE);
}

static void power_on(tb_supervisor *supervisor, tb_drive_range drives, tb_phase next)
{
    tb_power_on(supervisor, drives);
    tb_enter(supervisor, TB_STATE_HOME, next);
}

static tb_blame switch_cables(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool switched;
    tb_blame const blame = tb_await_mode(supervisor, seen, tb_cable_drives, &switched);
    if (switched) {
        power_on(supervisor, tb_cable_drives, TB_PHASE_CABLE_POWER);
    }
    return blame;
}

static tb_blame power_cables(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool reached;
    tb_blame const blame = tb_await_power(supervisor, seen, tb_cable_drives, &reached);
    if (reached) {
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_TIGHTEN);
    }
    return blame;
}

void tb_begin_bases(tb_supervisor *supervisor)
{
    for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
        tb_order_mode(supervisor, i, TB_MODE_HOMING);
    }
    tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_BASE_MODE);
}

static real_t pace_of(const tb_supervisor *supervisor, size_t cable)
{
    return TB_ABS(tb_measured_speed(&supervisor->measurement, cable));
}

/* The cable that moves fastest: one that winds in has slack still, one that is let out by a motor which
 * ought to wind it in turns the wrong way. */
static tb_blame blame_fastest(const tb_supervisor *supervisor)
{
    size_t found = 0;
    for (size_t i = 1; i < TB_CABLES; i++) {
        found = (pace_of(supervisor, i) > pace_of(supervisor, found)) ? i : found;
    }
    bool const winds_in = tb_measured_speed(&supervisor->measurement, found) >= 0;
    return tb_blame_for(winds_in ? TB_CAUSE_CABLE_SLACK : TB_CAUSE_WRONG_WAY, found, 0);
}

static tb_blame tighten(tb_supervisor *supervisor)
{
    bool tight = true;
    for (size_t i = 0; i < TB_CABLES; i++) {
        real_t const pace = pace_of(supervisor, i);
        real_t const share = TB_C(1.0) - (pace / TIGHTEN_SPEED);
        tb_pull(supervisor, i, TB_TENSION_MIN * tb_max(share, TB_C(0.0)));
        tight = tight && (pace < TIGHT_SPEED);
    }
    supervisor->calm = tight ? (supervisor->calm + 1) : 0;
    if (supervisor->calm >= TIGHT_CYCLES) {
        tb_begin_directions(supervisor);
    } else if (supervisor->cycles > TB_STATE_TIMEOUT) {
        return blame_fastest(supervisor);
    }
    return tb_no_blame();
}

static tb_blame switch_to_homing(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool switched;
    tb_blame const blame = tb_await_mode(supervisor, seen, tb_base_drives, &switched);
    if (switched) {
        power_on(supervisor, tb_base_drives, TB_PHASE_BASE_POWER);
    }
    return blame;
}

static tb_blame power_homing(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool reached;
    tb_blame const blame = tb_await_power(supervisor, seen, tb_base_drives, &reached);
    if (reached) {
        for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
            supervisor->drives[i].ran = 0;
            tb_order_homing(supervisor, i, true);
        }
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_BASE_HOMING);
    }
    return blame;
}

/* How a base's homing is. Until the drive was seen running, it may show how its last one ended. */
static tb_homing follow_homing(tb_drive_memory *base, const tb_drive_report *report)
{
    base->ran = ((base->ran != 0) || (report->homing == TB_HOMING_RUNNING)) ? 1 : 0;
    return (base->ran != 0) ? (tb_homing)report->homing : TB_HOMING_RUNNING;
}

static void release_bases(tb_supervisor *supervisor)
{
    for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
        tb_order_homing(supervisor, i, false);
    }
    tb_order_goal(supervisor, tb_base_drives, TB_GOAL_OFF);
    tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_BASE_RELEASE);
}

/* A base that has found its stop holds there until all have. */
static tb_blame run_homing(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool homed = true;
    bool const late = supervisor->cycles > TB_HOMING_TIMEOUT;
    for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
        const tb_drive_report *const report = &seen->drives[i];
        tb_homing const homing = follow_homing(&supervisor->drives[i], report);
        if ((homing != TB_HOMING_DONE) && (late || (homing != TB_HOMING_RUNNING))) {
            return tb_blame_for(TB_CAUSE_HOMING, i, report->statusword);
        }
        homed = homed && (homing == TB_HOMING_DONE);
    }
    if (homed) {
        release_bases(supervisor);
    }
    return tb_no_blame();
}

static tb_blame await_release(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool reached;
    tb_blame const blame = tb_await_power(supervisor, seen, tb_base_drives, &reached);
    if (reached) {
        for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
            tb_measurement_forget(&supervisor->measurement, i);
            tb_order_mode(supervisor, i, tb_working_mode(i));
        }
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_BASE_WORK_MODE);
    }
    return blame;
}

static tb_blame switch_to_work(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool switched;
    tb_blame const blame = tb_await_mode(supervisor, seen, tb_base_drives, &switched);
    if (switched) {
        power_on(supervisor, tb_base_drives, TB_PHASE_BASE_WORK_POWER);
    }
    return blame;
}

static tb_blame power_work(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool reached;
    tb_blame const blame = tb_await_power(supervisor, seen, tb_base_drives, &reached);
    if (reached) {
        for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
            tb_guide_take(&supervisor->guide, i - TB_CABLES,
                          tb_measured_position(&supervisor->measurement, i));
        }
        tb_begin_sweep(supervisor);
    }
    return blame;
}

static tb_blame home_bases(tb_supervisor *supervisor, const tb_observation *seen)
{
    switch (supervisor->phase) {
    case TB_PHASE_BASE_MODE:
        return switch_to_homing(supervisor, seen);
    case TB_PHASE_BASE_POWER:
        return power_homing(supervisor, seen);
    case TB_PHASE_BASE_HOMING:
        return run_homing(supervisor, seen);
    case TB_PHASE_BASE_RELEASE:
        return await_release(supervisor, seen);
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
    case TB_PHASE_TRY_CABLES:
    case TB_PHASE_TRY_MODE:
    case TB_PHASE_TRY_POWER:
    case TB_PHASE_TRY_BASES:
    case TB_PHASE_TRY_RELEASE:
        return tb_try_directions(supervisor, seen);
    case TB_PHASE_GATHER:
    case TB_PHASE_SWEEP:
    case TB_PHASE_SOLVE:
        return tb_sweep(supervisor);
    default:
        tb_hold_cables(supervisor);
        return home_bases(supervisor, seen);
    }
}
