#include "watch.h"

#include <stdbool.h>
#include <stddef.h>

#include "pose_space.h"
#include "tb_kinematics.h"

#define EXPLAINS TB_C(0.25) /* most that the culprit leaves of the closure error */
#define FAILS TB_C(0.5)     /* least of it that a cable beyond suspicion leaves */

/* A cable with less redundancy than this hardly shows in the closure: no delta is made of it. */
#define LEAST_REDUNDANCY TB_C(0.01)

#define FARTHEST                                                                                   \
    TB_C(1e6) /* m; an error beyond it is no length, and its square is finite in float */

static const tb_watch nothing;
static const tb_verdict fine = {TB_CAUSE_NONE, 0};

/* Every comparison is written so that a NaN fails it. */
static bool is_within(real_t value, real_t bound)
{
    return (value >= -bound) && (value <= bound);
}

static void count_cycle(bool good, uint16_t *cycles)
{
    if (good) {
        *cycles = 0;
    } else if (*cycles < UINT16_MAX) {
        (*cycles)++;
    } else {
        /* it has been long enough */
    }
}

static tb_verdict find_runaway(const tb_watched *seen)
{
    for (size_t i = 0; i < TB_CABLES; i++) {
        if (!is_within(seen->length_rates[i], TB_CABLE_SPEED_LIMIT)) {
            return (tb_verdict){TB_CAUSE_RUNAWAY, (uint16_t)i};
        }
    }
    return fine;
}

/* The cables whose fault, alone, could have opened the closure. */
typedef struct {
    bool explained; /* one of them at least explains it */
    bool slack;     /* one that is longer than the platform is far could be it */
    bool broken;    /* one that was wound in without the platform could be it */
    size_t culprit; /* of those that explain it, the one that moves most as its fault lets it */
    real_t speed;   /* m/s, of the culprit that way */
} tb_suspicion;

static void suspect(tb_suspicion *suspicion, size_t cable, real_t slack, real_t length_rate)
{
    real_t const speed = (slack > 0) ? length_rate : -length_rate;
    if (!suspicion->explained || (speed > suspicion->speed)) {
        suspicion->explained = true;
        suspicion->culprit = cable;
        suspicion->speed = speed;
    }
}

static real_t square_of(const real_t error[])
{
    real_t square = 0;
    for (size_t i = 0; i < TB_CABLES; i++) {
        square += error[i] * error[i];
    }
    return square;
}

static tb_suspicion compare_cables(const tb_pose_space *space, const tb_watched *seen,
                                   const real_t error[], real_t slack[])
{
    tb_suspicion suspicion = {false, false, false, 0, 0};
    real_t const whole = square_of(error);
    for (size_t i = 0; i < TB_CABLES; i++) {
        real_t left[TB_CABLES];
        tb_pose_space_unexplained(space, (uint32_t)i, left);
        slack[i] = (left[i] > LEAST_REDUNDANCY) ? (error[i] / left[i]) : TB_C(0.0);
        real_t const rest = whole - (slack[i] * error[i]);
        bool const possible = rest <= (FAILS * FAILS * whole);
        suspicion.slack = suspicion.slack || (possible && (slack[i] > 0));
        suspicion.broken = suspicion.broken || (possible && (slack[i] < 0));
        if (rest <= (EXPLAINS * EXPLAINS * whole)) {
            suspect(&suspicion, i, slack[i], seen->length_rates[i]);
        }
    }
    return suspicion;
}

/* Cables in one line explain the same error alike, and in the same way: one of them is slack, or one
 * of them is broken, even where it is not told which. */
static tb_verdict accuse(const tb_suspicion *suspicion)
{
    tb_verdict verdict = {TB_CAUSE_CLOSURE, (uint16_t)suspicion->culprit};
    if (suspicion->explained && (suspicion->slack != suspicion->broken)) {
        verdict.cause = suspicion->slack ? TB_CAUSE_CABLE_SLACK : TB_CAUSE_CABLE_BREAK;
    }
    return verdict;
}

/* By how much the measured lengths miss those of the pose; false where there is no telling. */
static bool find_error(const tb_watched *seen, real_t error[])
{
    bool known = tb_cable_lengths(seen->pose, seen->rails, error) == TB_OK;
    for (size_t i = 0; i < TB_CABLES; i++) {
        error[i] = seen->lengths[i] - error[i];
        known = known && is_within(error[i], FARTHEST);
    }
    return known;
}

static tb_verdict explain_closure(const tb_watched *seen, real_t slack[])
{
    tb_pose_space space;
    real_t error[TB_CABLES];
    tb_suspicion suspicion = {false, false, false, 0, 0};
    if (find_error(seen, error) && (tb_pose_space_find(&space, seen->pose, seen->rails) == TB_OK)) {
        real_t motion[TB_DOF];
        tb_pose_space_take(&space, error, motion);
        suspicion = compare_cables(&space, seen, error, slack);
    }
    return accuse(&suspicion);
}

static tb_verdict find_opening(tb_watch *watch, const tb_watched *seen, real_t slack[])
{
    bool const closed = is_within(seen->residual, TB_CLOSURE_LIMIT);
    count_cycle(closed, &watch->open);
    if (closed) {
        return fine;
    }
    tb_verdict const verdict = explain_closure(seen, slack);
    return (watch->open > TB_CLOSURE_CYCLES) ? verdict : fine;
}

static tb_verdict find_lost_base(tb_watch *watch, const tb_watched *seen)
{
    tb_verdict verdict = fine;
    for (size_t i = 0; i < TB_RAIL_SLOTS; i++) {
        bool const near = is_within(seen->rails[i] - seen->rail_targets[i], TB_RAIL_LAG_LIMIT);
        count_cycle(near, &watch->lagging[i]);
        if ((watch->lagging[i] > TB_RAIL_LAG_CYCLES) && (verdict.cause == TB_CAUSE_NONE)) {
            verdict = (tb_verdict){TB_CAUSE_BASE_LOST, (uint16_t)(TB_CABLES + i)};
        }
    }
    return verdict;
}

void tb_watch_start(tb_watch *watch)
{
    *watch = nothing;
}

tb_verdict tb_watch_cables(tb_watch *watch, const tb_watched *seen, real_t slack[TB_CABLES])
{
    for (size_t i = 0; i < TB_CABLES; i++) {
        slack[i] = 0;
    }
    tb_verdict const runaway = find_runaway(seen);
    tb_verdict const opening = find_opening(watch, seen, slack);
    tb_verdict const lost = find_lost_base(watch, seen);
    if (runaway.cause != TB_CAUSE_NONE) {
        return runaway;
    }
    return (opening.cause != TB_CAUSE_NONE) ? opening : lost;
}
