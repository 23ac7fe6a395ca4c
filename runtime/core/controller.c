#include "controller.h"

#include <stdbool.h>
#include <stddef.h>

#include "tb_control.h"
#include "tb_kinematics.h"
#include "tb_statics.h"
#include "tb_tension.h"

/* Rows of the memory that the generated filters keep; the rest of a row is their own. */
#define OBSERVER_PREVIOUS_LENGTH 0
#define OBSERVER_MOTOR_SPEED 1
#define BASE_PREVIOUS_RAIL 1
#define BASE_SPEED 2

static const tb_outputs nothing;
static const tb_controller at_rest;

static bool is_good(tb_status status)
{
    return (status == TB_OK) || (status == TB_INFEASIBLE);
}

static void copy(size_t count, const real_t from[restrict], real_t to[restrict])
{
    for (size_t i = 0; i < count; i++) {
        to[i] = from[i];
    }
}

static void fill(size_t count, real_t value, real_t to[])
{
    for (size_t i = 0; i < count; i++) {
        to[i] = value;
    }
}

/* Rates of this cycle; the controller remembers them when the cycle is good. */
typedef struct {
    real_t cables[TB_CABLES];
    real_t rails[TB_RAIL_SLOTS];
} tb_rates;

/* First-order low-pass on the backward difference. */
static void filter_rates(size_t count, const real_t measured[], const real_t previous[],
                         const real_t kept[], real_t rates[])
{
    for (size_t i = 0; i < count; i++) {
        real_t const rate = (measured[i] - previous[i]) * (TB_C(1.0) / TB_PERIOD);
        rates[i] = kept[i] + (TB_VELOCITY_GAIN * (rate - kept[i]));
    }
}

/* After an interruption the kept rates stand until there is a previous measurement again. */
static void find_rates(const tb_controller *controller, const tb_inputs *inputs, tb_rates *rates)
{
#if TB_RAILS == 0
    rates->rails[0] = 0; /* the slot of an array that nobody fills or reads */
#endif
    if (controller->interrupted != 0) {
        copy(TB_CABLES, controller->length_rates, rates->cables);
        copy(TB_RAILS, controller->rail_rates, rates->rails);
    } else {
        filter_rates(TB_CABLES, inputs->lengths, controller->lengths, controller->length_rates,
                     rates->cables);
        filter_rates(TB_RAILS, inputs->rails, controller->rails, controller->rail_rates,
                     rates->rails);
    }
}

#ifdef TB_START_POSE

/* The pose has no closed form: its search begins where the platform was. */
static tb_status locate_platform(const tb_controller *controller, const tb_inputs *inputs,
                                 const tb_rates *rates, real_t structure[], tb_outputs *outputs)
{
    return tb_locate(controller->pose, inputs->lengths, inputs->rails, rates->cables, rates->rails,
                     outputs->pose, &outputs->residual, structure, outputs->velocity);
}

static tb_status find_start(const real_t lengths[], const real_t rails[], real_t pose[])
{
    static const real_t start[TB_DOF] = TB_START_POSE;
    real_t found[TB_DOF];
    real_t residual[1];
    tb_status const status = tb_forward_kinematics(start, lengths, rails, found, residual);
    copy(TB_DOF, (status == TB_OK) ? found : start, pose);
    return status;
}

#else

static tb_status locate_platform(const tb_controller *controller, const tb_inputs *inputs,
                                 const tb_rates *rates, real_t structure[], tb_outputs *outputs)
{
    (void)controller;
    return tb_locate(inputs->lengths, inputs->rails, rates->cables, rates->rails, outputs->pose,
                     &outputs->residual, structure, outputs->velocity);
}

static tb_status find_start(const real_t lengths[], const real_t rails[], real_t pose[])
{
    real_t residual[1];
    return tb_forward_kinematics(lengths, rails, pose, residual);
}

#endif

static tb_status render_force(const tb_inputs *inputs, tb_outputs *outputs)
{
    tb_status const status = tb_wall_force(outputs->pose, outputs->velocity, outputs->wanted_force);
    for (size_t i = 0; i < TB_DOF; i++) {
        outputs->wanted_force[i] += inputs->force[i];
    }
    return status;
}

static tb_status distribute_force(const real_t structure[], tb_outputs *outputs)
{
    real_t kkt_residual[1];
    return tb_distribute_tension(structure, outputs->wanted_force, outputs->tension,
                                 outputs->delivered_force, kkt_residual);
}

/* Place the previous lengths where the kept speeds came from, so that no filter sees a jump. */
static void resume_observer(tb_controller *controller, const real_t lengths[])
{
    for (size_t i = 0; i < TB_CABLES; i++) {
        real_t *const observer = &controller->observer[i * TB_OBSERVER_MEMORY];
        real_t const winding_rate = TB_DRUM_RADIUS * observer[OBSERVER_MOTOR_SPEED];
        observer[OBSERVER_PREVIOUS_LENGTH] = lengths[i] - (winding_rate * TB_PERIOD);
    }
}

#if TB_HAS_OBSERVER

#if TB_HAND_FORCE_MEASURED

/* The most that all cables together can pull along or about an axis. */
static real_t largest_pull(size_t axis)
{
    real_t const force = (real_t)TB_CABLES * TB_TENSION_MAX;
#ifdef TB_LONGEST_ARM
    return (axis < TB_SPACE) ? force : (force * TB_LONGEST_ARM);
#else
    (void)axis;
    return force;
#endif
}

/* More than all cables together can pull is a broken sensor, not a hand; a NaN fails too. */
static bool is_believable(const real_t hand_force[])
{
    bool believable = true;
    for (size_t i = 0; i < TB_DOF; i++) {
        real_t const bound = largest_pull(i);
        believable = believable && (hand_force[i] >= -bound) && (hand_force[i] <= bound);
    }
    return believable;
}

static tb_status find_hand_force(const tb_inputs *inputs, const tb_outputs *outputs,
                                 real_t hand_force[])
{
    (void)outputs;
    copy(TB_DOF, inputs->hand_force, hand_force);
    return is_believable(hand_force) ? TB_OK : TB_OUT_OF_DOMAIN;
}

#else

/* A hand without a sensor is taken to hold against the force that was asked of the cables. */
static tb_status find_hand_force(const tb_inputs *inputs, const tb_outputs *outputs,
                                 real_t hand_force[])
{
    (void)inputs;
    for (size_t i = 0; i < TB_DOF; i++) {
        hand_force[i] = -outputs->delivered_force[i];
    }
    return TB_OK;
}

#endif

/* What the cables carry. The hand tells their wrench; what they carry against each other nobody
 * measures, so it is taken to be what the motors were asked for. Were it taken from the tension
 * command instead, the observer would integrate its own errors there without end. */
static tb_status find_load(const tb_controller *controller, const tb_inputs *inputs,
                           const real_t structure[], const tb_outputs *outputs, real_t load[])
{
    real_t hand_force[TB_DOF];
    real_t applied_tension[TB_CABLES];
    for (size_t i = 0; i < TB_CABLES; i++) {
        applied_tension[i] = controller->torque[i] * (TB_C(1.0) / TB_DRUM_RADIUS);
    }
    tb_status const status = find_hand_force(inputs, outputs, hand_force);
    if (status != TB_OK) {
        return status;
    }
    return tb_load_tension(structure, applied_tension, hand_force, load);
}

static tb_status estimate_disturbance(tb_controller *controller, const tb_inputs *inputs,
                                      const real_t structure[], tb_outputs *outputs)
{
    real_t load[TB_CABLES];
    tb_status const status = find_load(controller, inputs, structure, outputs, load);
    if (status != TB_OK) {
        return status;
    }
    if (controller->interrupted != 0) {
        resume_observer(controller, inputs->lengths);
    }
    return tb_observe_disturbance(controller->observer, inputs->lengths, load, controller->torque,
                                  controller->observer, outputs->disturbance);
}

#else

static tb_status estimate_disturbance(tb_controller *controller, const tb_inputs *inputs,
                                      const real_t structure[], tb_outputs *outputs)
{
    (void)controller;
    (void)inputs;
    (void)structure;
    fill(TB_CABLES, TB_C(0.0), outputs->disturbance);
    return TB_OK;
}

#endif

#if TB_RAILS > 0

static void resume_bases(tb_controller *controller, const real_t rails[])
{
    for (size_t i = 0; i < TB_RAILS; i++) {
        real_t *const base = &controller->base[i * TB_BASE_MEMORY];
        base[BASE_PREVIOUS_RAIL] = rails[i] - (base[BASE_SPEED] * TB_PERIOD);
    }
}

static tb_status move_bases(tb_controller *controller, const tb_inputs *inputs, tb_outputs *outputs)
{
    if (controller->interrupted != 0) {
        resume_bases(controller, inputs->rails);
    }
    tb_status status = tb_base_targets(outputs->pose, outputs->rail_target);
    if (status == TB_OK) {
        status = tb_base_pid(controller->base, outputs->rail_target, inputs->rails,
                             controller->base, outputs->rail_force);
    }
    for (size_t i = 0; i < TB_RAILS; i++) {
        outputs->rail_torque[i] = TB_PINION_RADIUS * outputs->rail_force[i];
    }
    return status;
}

#else

static tb_status move_bases(tb_controller *controller, const tb_inputs *inputs, tb_outputs *outputs)
{
    (void)controller;
    (void)inputs;
    fill(TB_RAIL_SLOTS, TB_C(0.0), outputs->rail_target);
    fill(TB_RAIL_SLOTS, TB_C(0.0), outputs->rail_force);
    fill(TB_RAIL_SLOTS, TB_C(0.0), outputs->rail_torque);
    return TB_OK;
}

static void resume_bases(tb_controller *controller, const real_t rails[])
{
    (void)controller;
    (void)rails;
}

#endif

/* The share of its torque that a motor keeps for the observer. */
static const real_t compensation_limit = TB_TORQUE_LIMIT - (TB_DRUM_RADIUS * TB_TENSION_MAX);

static real_t limit_compensation(real_t disturbance)
{
    return tb_min(tb_max(disturbance, -compensation_limit), compensation_limit);
}

/* What is asked of the cable motors, before the gate. */
static tb_status command_torques(const tb_inputs *inputs, tb_outputs *outputs)
{
    bool const compensated = (inputs->options & TB_OPTION_UNCOMPENSATED) == 0;
    tb_status const status = tb_motor_torques(outputs->tension, outputs->motor_torque);
    for (size_t i = 0; (i < TB_CABLES) && compensated; i++) {
        outputs->motor_torque[i] += limit_compensation(outputs->disturbance[i]);
    }
    return status;
}

/* Tension from the wanted force; torques from tension and disturbance. */
static tb_status pull_cables(tb_controller *controller, const tb_inputs *inputs,
                             const real_t structure[], tb_outputs *outputs)
{
    tb_status const distributed = distribute_force(structure, outputs);
    if (!is_good(distributed)) {
        return distributed;
    }
    tb_status status = estimate_disturbance(controller, inputs, structure, outputs);
    if (status == TB_OK) {
        status = command_torques(inputs, outputs);
    }
    return (status == TB_OK) ? distributed : status;
}

/* What a good cycle leaves; the filters of observer and bases have kept theirs already. */
static void remember(tb_controller *controller, const tb_inputs *inputs, const tb_rates *rates,
                     const tb_outputs *outputs)
{
    copy(TB_DOF, outputs->pose, controller->pose);
    copy(TB_CABLES, inputs->lengths, controller->lengths);
    copy(TB_CABLES, rates->cables, controller->length_rates);
    copy(TB_RAILS, inputs->rails, controller->rails);
    copy(TB_RAILS, rates->rails, controller->rail_rates);
    controller->interrupted = 0;
}

/* Whatever can fail comes before the filters, whose memory only a good cycle may change. */
static tb_status run_cycle(tb_controller *controller, const tb_inputs *inputs, tb_outputs *outputs)
{
    tb_rates rates;
    real_t structure[TB_DOF * TB_CABLES];
    find_rates(controller, inputs, &rates);
    tb_status status = locate_platform(controller, inputs, &rates, structure, outputs);
    if (status == TB_OK) {
        status = render_force(inputs, outputs);
    }
    if (status == TB_OK) {
        status = pull_cables(controller, inputs, structure, outputs);
    }
    if (is_good(status)) {
        tb_status const moved = move_bases(controller, inputs, outputs);
        status = (moved == TB_OK) ? status : moved;
    }
    if (is_good(status)) {
        remember(controller, inputs, &rates, outputs);
    }
    return status;
}

/* The outputs of a failed cycle: cables just taut, carriages free. */
static void hold_safe(const tb_controller *controller, tb_outputs *outputs)
{
    *outputs = nothing;
    copy(TB_DOF, controller->pose, outputs->pose);
    copy(TB_RAILS, controller->rails, outputs->rail_target);
    fill(TB_CABLES, TB_TENSION_MIN, outputs->tension);
    fill(TB_CABLES, TB_DRUM_RADIUS * TB_TENSION_MIN, outputs->motor_torque);
}

/* No torque leaves the step but through here. */
static void pass_gate(tb_controller *controller, tb_outputs *outputs)
{
    for (size_t i = 0; i < TB_CABLES; i++) {
        real_t const command = outputs->motor_torque[i];
        outputs->gate[i] =
            tb_torque_gate(controller->torque[i], command, &outputs->motor_torque[i]);
    }
    copy(TB_CABLES, outputs->motor_torque, controller->torque);
}

tb_status tb_controller_start(tb_controller *controller, const real_t lengths[TB_CABLES],
                              const real_t rails[TB_RAIL_SLOTS])
{
    *controller = at_rest;
    controller->interrupted = 1;
    tb_status const status = find_start(lengths, rails, controller->pose);
    if (status == TB_OK) {
        copy(TB_CABLES, lengths, controller->lengths);
        copy(TB_RAILS, rails, controller->rails);
        resume_observer(controller, lengths);
        resume_bases(controller, rails);
        controller->interrupted = 0;
    }
    return status;
}

void tb_controller_take_over(tb_controller *controller, const real_t torque[TB_CABLES],
                             const real_t base[TB_RAIL_SLOTS * TB_BASE_MEMORY])
{
    copy(TB_CABLES, torque, controller->torque);
    copy(TB_RAIL_SLOTS * TB_BASE_MEMORY, base, controller->base);
}

tb_status tb_controller_step(tb_controller *controller, const tb_inputs *inputs,
                             tb_outputs *outputs)
{
    tb_status const status = run_cycle(controller, inputs, outputs);
    if (!is_good(status)) {
        controller->interrupted = 1;
        hold_safe(controller, outputs);
    }
    pass_gate(controller, outputs);
    outputs->status = (int32_t)status;
    return status;
}
