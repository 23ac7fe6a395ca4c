#include "direction.h"

#include "drive_orders.h"
#include "hold.h"
#include "states.h"
#include "transition.h"

/* Of a cable: a round is a half in which it is pulled harder, and one in which it is not. */
#define CABLE_HALF ((uint32_t)(TB_C(0.04) / TB_PERIOD))
#define CABLE_ROUNDS 5u
#define EXTRA_TENSION ((TB_TENSION_MAX - TB_TENSION_MIN) * TB_C(0.3))
/* Speed that all rounds together may show the wrong way round: a hand moves the handle. */
#define CABLE_DOUBT (TB_CABLE_SPEED_LIMIT * TB_C(0.02))

/* Of the carriages: a round is a half pushed forward and one pushed back, twice as hard as the round
 * before, for those that have not answered yet. */
#define BASE_HALF ((uint32_t)(TB_C(0.02) / TB_PERIOD))
#define BASE_ROUNDS 4u
#define FIRST_PUSH (TB_RAIL_TORQUE_LIMIT * TB_C(0.0625))
#define BASE_ANSWER (TB_RAIL_SPEED_LIMIT * TB_C(0.02))

static const tb_trial untried;

/* Where a trial is: its round, the cycle in that round from 0, and the cycles of one of its halves. */
typedef struct {
    uint32_t round;
    uint32_t cycle;
    uint32_t half;
} tb_round;

static tb_round find_round(uint32_t cycles, uint32_t half)
{
    uint32_t const passed = cycles - 1u;
    return (tb_round){passed / (2u * half), passed % (2u * half), half};
}

static bool is_first_half(const tb_round *round)
{
    return round->cycle < round->half;
}

/* Speed gained in the first half counts for the drive, in the second against it. The round's last
 * cycle ends the second half. */
static void measure_round(tb_supervisor *supervisor, size_t drive, const tb_round *round)
{
    tb_trial *const trial = &supervisor->trial;
    real_t const speed = tb_measured_speed(&supervisor->measurement, drive);
    real_t const gained = speed - trial->speed[drive];
    if (round->cycle == round->half) {
        trial->answer[drive] += gained;
    } else if (round->cycle == (2u * round->half) - 1u) {
        trial->answer[drive] -= gained;
    } else if (round->cycle != 0) {
        return;
    } else {
        /* the first half begins */
    }
    trial->speed[drive] = speed;
}

void tb_begin_directions(tb_supervisor *supervisor)
{
    supervisor->trial = untried;
    tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_TRY_CABLES);
}

static bool can_try_bases(void)
{
    bool can = TB_RAILS > 0;
    for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
        can = can && !tb_follows_position(i);
    }
    return can;
}

static void go_on_to_bases(tb_supervisor *supervisor)
{
    if (can_try_bases()) {
        for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
            tb_order_mode(supervisor, i, TB_MODE_TORQUE);
        }
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_TRY_MODE);
    } else if (TB_RAILS > 0) {
        tb_begin_bases(supervisor);
    } else {
        tb_begin_sweep(supervisor);
    }
}

/* The last cycle of a cable's last round. */
static bool is_over(const tb_round *round)
{
    bool const is_last = (round->round % CABLE_ROUNDS) == (CABLE_ROUNDS - 1u);
    return is_last && (round->cycle == (2u * round->half) - 1u);
}

static tb_blame try_cables(tb_supervisor *supervisor)
{
    tb_round const round = find_round(supervisor->cycles, CABLE_HALF);
    size_t const cable = round.round / CABLE_ROUNDS;
    tb_hold_cables(supervisor);
    if (cable == TB_CABLES) {
        go_on_to_bases(supervisor);
        return tb_no_blame();
    }
    tb_pull(supervisor, cable,
            TB_TENSION_MIN + (is_first_half(&round) ? EXTRA_TENSION : TB_C(0.0)));
    measure_round(supervisor, cable, &round);
    bool const is_wrong = is_over(&round) && (supervisor->trial.answer[cable] < -CABLE_DOUBT);
    return is_wrong ? tb_blame_for(TB_CAUSE_WRONG_WAY, cable, 0) : tb_no_blame();
}

static tb_blame switch_to_torque(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool switched;
    tb_blame const blame = tb_await_mode(supervisor, seen, tb_base_drives, &switched);
    if (switched) {
        tb_power_on(supervisor, tb_base_drives);
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_TRY_POWER);
    }
    return blame;
}

static tb_blame power_bases(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool reached;
    tb_blame const blame = tb_await_power(supervisor, seen, tb_base_drives, &reached);
    if (reached) {
        tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_TRY_BASES);
    }
    return blame;
}

static void release_bases(tb_supervisor *supervisor)
{
    tb_order_goal(supervisor, tb_base_drives, TB_GOAL_OFF);
    tb_enter(supervisor, TB_STATE_HOME, TB_PHASE_TRY_RELEASE);
}

/* Between rounds: who has answered the wrong way, or not at all; whether there is more to try. */
static tb_blame judge_bases(tb_trial *trial, uint32_t round, bool *all_answered)
{
    tb_blame blame = tb_no_blame();
    *all_answered = true;
    for (size_t i = TB_CABLES; (i < TB_DRIVES) && (blame.cause == TB_CAUSE_NONE); i++) {
        trial->answered[i] = (trial->answer[i] > BASE_ANSWER) ? 1 : 0;
        *all_answered = *all_answered && (trial->answered[i] != 0);
        if (trial->answer[i] < -BASE_ANSWER) {
            blame = tb_blame_for(TB_CAUSE_WRONG_WAY, i, 0);
        } else if ((round == BASE_ROUNDS) && (trial->answered[i] == 0)) {
            blame = tb_blame_for(TB_CAUSE_BASE_BLOCKED, i, 0);
        } else {
            /* it counts the right way, or there is a harder push to come */
        }
    }
    return blame;
}

static void push_base(tb_supervisor *supervisor, size_t drive, const tb_round *round)
{
    real_t const push = FIRST_PUSH * (real_t)(1u << round->round);
    if (supervisor->trial.answered[drive] == 0) {
        supervisor->drives[drive].wanted.torque = is_first_half(round) ? push : -push;
    }
    measure_round(supervisor, drive, round);
}

static tb_blame try_bases(tb_supervisor *supervisor)
{
    tb_round const round = find_round(supervisor->cycles, BASE_HALF);
    if (round.cycle == 0) {
        bool all_answered;
        tb_blame const blame = judge_bases(&supervisor->trial, round.round, &all_answered);
        if ((blame.cause != TB_CAUSE_NONE) || all_answered) {
            release_bases(supervisor);
            return blame;
        }
    }
    for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
        push_base(supervisor, i, &round);
    }
    return tb_no_blame();
}

static tb_blame await_release(tb_supervisor *supervisor, const tb_observation *seen)
{
    bool reached;
    tb_blame const blame = tb_await_power(supervisor, seen, tb_base_drives, &reached);
    if (reached) {
        tb_begin_bases(supervisor);
    }
    return blame;
}

tb_blame tb_try_directions(tb_supervisor *supervisor, const tb_observation *seen)
{
    if (supervisor->phase == TB_PHASE_TRY_CABLES) {
        return try_cables(supervisor);
    }
    tb_hold_cables(supervisor);
    switch (supervisor->phase) {
    case TB_PHASE_TRY_MODE:
        return switch_to_torque(supervisor, seen);
    case TB_PHASE_TRY_POWER:
        return power_bases(supervisor, seen);
    case TB_PHASE_TRY_BASES:
        return try_bases(supervisor);
    default:
        return await_release(supervisor, seen);
    }
}
