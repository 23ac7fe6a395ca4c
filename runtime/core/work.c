#include "drive_orders.h"
#include "hold.h"
#include "states.h"
#include "transition.h"

#define APPROACH_SPEED (TB_RAIL_SPEED_LIMIT * TB_C(0.1))
/* How near the bases must be to where the controller wants them before it moves them itself. */
#define NEAR (TB_RAIL_LAG_LIMIT * TB_C(0.05))
/* Cycles in a row in which the lengths must agree. */
#define CLOSED_CYCLES 100u

/* A blame that comes later does not take the place of one before. */
static tb_blame earlier(tb_blame one, tb_blame other)
{
    return (one.cause != TB_CAUSE_NONE) ? one : other;
}

static void measure_lengths(const tb_supervisor *supervisor, real_t lengths[])
{
    for (size_t i = 0; i < TB_CABLES; i++) {
        lengths[i] =
            supervisor->calibration.zeros[i] - tb_measured_position(&supervisor->measurement, i);
    }
}

static void hand_over(tb_supervisor *supervisor)
{
    real_t torque[TB_CABLES];
    for (size_t i = 0; i < TB_CABLES; i++) {
        torque[i] = supervisor->drives[i].sent;
    }
    tb_controller_take_over(&supervisor->controller, torque, supervisor->guide.base);
}

void tb_begin_tension(tb_supervisor *supervisor)
{
    real_t lengths[TB_CABLES];
    real_t rails[TB_RAIL_SLOTS];
    measure_lengths(supervisor, lengths);
    tb_measured_rails(&supervisor->measurement, rails);
    (void)tb_controller_start(&supervisor->controller, lengths, rails); /* steps tell how it went */
    hand_over(supervisor);
    tb_watch_start(&supervisor->watch);
    supervisor->failed = 0;
    tb_enter(supervisor, TB_STATE_TENSION, TB_PHASE_APPROACH);
}

static void read_hand_force(const tb_observation *seen, tb_inputs *inputs)
{
    bool const fresh = seen->hand_force_fresh != 0;
    for (size_t i = 0; i < TB_DOF; i++) {
        inputs->hand_force[i] = fresh ? seen->hand_force[i] : TB_C(0.0);
    }
    inputs->options = fresh ? 0 : TB_OPTION_UNCOMPENSATED;
}

static void want_outputs(tb_supervisor *supervisor)
{
    for (size_t i = 0; i < TB_CABLES; i++) {
        supervisor->drives[i].wanted.torque = supervisor->outputs.motor_torque[i];
    }
    for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
        supervisor->drives[i].wanted.torque = supervisor->outputs.rail_torque[i - TB_CABLES];
        supervisor->drives[i].wanted.position = supervisor->outputs.rail_target[i - TB_CABLES];
    }
}

static tb_blame watch_cables(tb_supervisor *supervisor, const tb_inputs *inputs)
{
    bool const guided = supervisor->phase == TB_PHASE_APPROACH;
    tb_watched const watched = {
        .lengths = inputs->lengths,
        .length_rates = supervisor->controller.length_rates,
        .rails = inputs->rails,
        .rail_targets = guided ? supervisor->guide.reference : supervisor->outputs.rail_target,
        .pose = supervisor->outputs.pose,
        .residual = supervisor->outputs.residual,
    };
    tb_verdict const verdict = tb_watch_cables(&supervisor->watch, &watched, supervisor->slack);
    return tb_blame_for(verdict.cause, verdict.culprit, 0);
}

/* A failed step keeps the cables taut; what it knows of the pose is old, so nobody watches it. */
static tb_blame judge_step(tb_supervisor *supervisor, const tb_inputs *inputs, tb_status status)
{
    if ((status == TB_OK) || (status == TB_INFEASIBLE)) {
        supervisor->failed = 0;
        return watch_cables(supervisor, inputs);
    }
    supervisor->failed++;
    bool const too_often = supervisor->failed > TB_FAILED_LIMIT;
    return too_often ? tb_blame_for(TB_CAUSE_CONTROLLER, 0, (uint32_t)status) : tb_no_blame();
}

/* One step of the controller; force [N] (TB_DOF): the application's. */
static tb_blame control(tb_supervisor *supervisor, const tb_observation *seen,
                        const real_t force[TB_DOF])
{
    tb_inputs inputs;
    measure_lengths(supervisor, inputs.lengths);
    tb_measured_rails(&supervisor->measurement, inputs.rails);
    read_hand_force(seen, &inputs);
    for (size_t i = 0; i < TB_DOF; i++) {
        inputs.force[i] = force[i];
    }
    tb_status const status =
        tb_controller_step(&supervisor->controller, &inputs, &supervisor->outputs);
    want_outputs(supervisor);
    return judge_step(supervisor, &inputs, status);
}

/* The controller has the cables already; its bases would jump, so they are led to where it wants
 * them first. */
static tb_blame approach(tb_supervisor *supervisor)
{
    real_t rails[TB_RAIL_SLOTS];
    const real_t *const targets = supervisor->outputs.rail_target;
    tb_measured_rails(&supervisor->measurement, rails);
    tb_blame const blame = tb_guide_bases(supervisor, targets, APPROACH_SPEED);
    if ((supervisor->failed == 0) &&
        tb_guide_has_arrived(&supervisor->guide, rails, targets, NEAR)) {
        hand_over(supervisor);
        tb_enter(supervisor, TB_STATE_TENSION, TB_PHASE_CLOSE);
    } else if (supervisor->cycles > TB_HOMING_TIMEOUT) {
        return tb_blame_for(TB_CAUSE_BASE_LOST, TB_CABLES, 0);
    }
    return blame;
}

static tb_blame await_closure(tb_supervisor *supervisor)
{
    bool const closed =
        (supervisor->failed == 0) && (supervisor->outputs.residual <= TB_CLOSURE_LIMIT);
    supervisor->calm = closed ? (supervisor->calm + 1) : 0;
    if (supervisor->calm >= CLOSED_CYCLES) {
        tb_enter(supervisor, TB_STATE_RUN, TB_PHASE_NONE);
    } else if (supervisor->cycles > TB_STATE_TIMEOUT) {
        return tb_blame_for(TB_CAUSE_CLOSURE, 0, 0);
    }
    return tb_no_blame();
}

tb_blame tb_tension(tb_supervisor *supervisor, const tb_observation *seen)
{
    static const real_t no_force[TB_DOF];
    tb_blame const found = control(supervisor, seen, no_force);
    bool const guided = supervisor->phase == TB_PHASE_APPROACH;
    return earlier(found, guided ? approach(supervisor) : await_closure(supervisor));
}

tb_blame tb_run(tb_supervisor *supervisor, const tb_observation *seen)
{
    return control(supervisor, seen, seen->force);
}
