/* The calibration sweep: the motion during which the poses are measured from which the cables' zeros
 * are computed (calibration.h). Users are told: hold the handle loosely; do not follow the bases.
 *
 * Every base swings about the middle of its rail. Neighbouring bases swing at different frequencies,
 * so that the geometry changes from pose to pose even if the handle stays in one place. A handle
 * that is not held settles, under equal tensions, where opposite cables are in line; there the zeros
 * are not observable, so each cable in turn is given some extra tension. On a machine without rails
 * the user moves the handle around: a pose is measured whenever the handle has moved far enough. */
#include "drive_orders.h"
#include "hold.h"
#include "states.h"
#include "transition.h"

#define SWEEP_CYCLES ((uint32_t)TB_CALIBRATION_SAMPLES * TB_CALIBRATION_CYCLES)
#define GATHER_SPEED (TB_RAIL_SPEED_LIMIT * TB_C(0.1))
#define GATHERED (TB_RAIL_LAG_LIMIT * TB_C(0.1))
#define EXTRA_TENSION ((TB_TENSION_MAX - TB_TENSION_MIN) * TB_C(0.2))
#define DIFFERENT_POSE (TB_CALIBRATION_TRAVEL * TB_C(0.2))
#define RHYTHMS 3u

void tb_begin_sweep(tb_supervisor *supervisor)
{
    tb_calibration_start(&supervisor->calibration);
    tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_GATHER);
}

static tb_blame blame_calibration(tb_calibration_progress progress)
{
    return tb_blame_for(TB_CAUSE_CALIBRATION, 0, (uint32_t)progress);
}

#if TB_RAILS > 0

/* Parabolas instead of a cosine: period 1, 1 at 0, slope 0 there. */
static real_t wave(real_t turns)
{
    real_t const whole = (real_t)(uint32_t)turns;
    real_t const from_middle = TB_ABS(turns - whole - TB_C(0.5));
    real_t const to_zero = from_middle - TB_C(0.25);
    return TB_C(16.0) * to_zero * (TB_C(0.5) - TB_ABS(to_zero));
}

/* share: of the sweep, from 0 to 1. */
static void find_targets(real_t share, real_t targets[])
{
    static const real_t lengths[TB_RAIL_SLOTS] = TB_RAIL_LENGTHS;
    for (size_t i = 0; i < TB_RAILS; i++) {
        real_t const middle = TB_C(0.5) * lengths[i];
        real_t const travel = tb_min(TB_CALIBRATION_TRAVEL, middle);
        real_t const rhythm = (real_t)((i % RHYTHMS) + 1u);
        targets[i] = middle + (travel * wave(rhythm * share));
    }
}

/* One cable after the other, from nothing to EXTRA_TENSION and back. */
static void pull_in_turn(tb_supervisor *supervisor, real_t share)
{
    for (size_t i = 0; i < TB_CABLES; i++) {
        real_t const turn = (share * (real_t)TB_CABLES) - (real_t)i;
        real_t const bump = tb_max(TB_C(4.0) * turn * (TB_C(1.0) - turn), TB_C(0.0));
        tb_pull(supervisor, i, TB_TENSION_MIN + (EXTRA_TENSION * bump));
    }
}

static bool is_time_for_sample(const tb_supervisor *supervisor)
{
    uint32_t const due = (supervisor->calibration.count + 1) * TB_CALIBRATION_CYCLES;
    return supervisor->cycles >= due;
}

static tb_blame gather(tb_supervisor *supervisor)
{
    real_t targets[TB_RAIL_SLOTS];
    real_t rails[TB_RAIL_SLOTS];
    find_targets(TB_C(0.0), targets);
    tb_measured_rails(&supervisor->measurement, rails);
    if (tb_guide_has_arrived(&supervisor->guide, rails, targets, GATHERED)) {
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_SWEEP);
    }
    tb_hold_cables(supervisor);
    return tb_guide_bases(supervisor, targets, GATHER_SPEED);
}

static tb_blame swing(tb_supervisor *supervisor)
{
    real_t targets[TB_RAIL_SLOTS];
    real_t const share = (real_t)supervisor->cycles / (real_t)SWEEP_CYCLES;
    find_targets(share, targets);
    pull_in_turn(supervisor, share);
    return tb_guide_bases(supervisor, targets, TB_RAIL_SPEED_LIMIT);
}

#else

static tb_blame gather(tb_supervisor *supervisor)
{
    tb_hold_cables(supervisor);
    tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_SWEEP);
    return tb_no_blame();
}

static tb_blame swing(tb_supervisor *supervisor)
{
    tb_hold_cables(supervisor);
    return tb_no_blame();
}

/* Whether some cable was wound in to another length when a pose was measured. */
static bool is_other_pose(const tb_supervisor *supervisor, size_t measured)
{
    const real_t *const then = &supervisor->calibration.wound[measured * (size_t)TB_CABLES];
    bool other = false;
    for (size_t i = 0; i < TB_CABLES; i++) {
        real_t const moved = tb_measured_position(&supervisor->measurement, i) - then[i];
        other = other || (TB_ABS(moved) > DIFFERENT_POSE);
    }
    return other;
}

/* Unlike every pose that was measured: poses one after the other along one way tell less. */
static bool is_time_for_sample(const tb_supervisor *supervisor)
{
    bool other = true;
    for (size_t k = 0; k < supervisor->calibration.count; k++) {
        other = other && is_other_pose(supervisor, k);
    }
    return other;
}

#endif

static void take_sample(tb_supervisor *supervisor)
{
    real_t wound[TB_CABLES];
    real_t rails[TB_RAIL_SLOTS];
    tb_measured_winding(&supervisor->measurement, wound);
    tb_measured_rails(&supervisor->measurement, rails);
    tb_calibration_add(&supervisor->calibration, wound, rails);
}

/* A pose is measured in a cycle in which every drive has answered the last SYNC of its bus: answers of
 * a slower bus need not come in one and the same cycle. */
static tb_blame measure(tb_supervisor *supervisor)
{
    tb_blame const blame = swing(supervisor);
    bool const complete = tb_measurement_is_complete(&supervisor->measurement);
    supervisor->calm = complete ? 0 : (supervisor->calm + 1);
    if (is_time_for_sample(supervisor) && complete) {
        take_sample(supervisor);
    }
    if (supervisor->calibration.count >= TB_CALIBRATION_SAMPLES) {
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_SOLVE);
    } else if (supervisor->calm > TB_STATE_TIMEOUT) {
        size_t const missing = tb_measurement_missing(&supervisor->measurement);
        return tb_blame_for(TB_CAUSE_ANSWERS_INCOMPLETE, missing, 0);
    } else if (supervisor->cycles > TB_HOMING_TIMEOUT) {
        return blame_calibration(TB_CALIBRATION_UNOBSERVABLE);
    }
    return blame;
}

static tb_blame solve(tb_supervisor *supervisor)
{
    tb_hold_cables(supervisor);
    tb_blame const blame = tb_hold_bases(supervisor);
    tb_calibration_progress const progress = tb_calibration_solve(&supervisor->calibration);
    if (progress == TB_CALIBRATION_DONE) {
        tb_begin_tension(supervisor);
    } else if (progress != TB_CALIBRATION_BUSY) { /* its steps are counted: no time-out */
        return blame_calibration(progress);
    }
    return blame;
}

tb_blame tb_sweep(tb_supervisor *supervisor)
{
    switch (supervisor->phase) {
    case TB_PHASE_GATHER:
        return gather(supervisor);
    case TB_PHASE_SWEEP:
        return measure(supervisor);
    default:
        return solve(supervisor);
    }
}
