/* Answers a machine's vectors: reads arguments, writes results, every number with all its bits.
 *
 * Two counts, of 32 bits, come first; then the arguments of so many tension distributions, of one
 * start of the controller, and of so many of its steps. sample.py has their order. */
#include "controller.h"
#include "stream.h"
#include "tb_tension.h"

#define TAKE(array) stream_take((array), sizeof(array))
#define GIVE(array) stream_give((array), sizeof(array))

static bool distribute(void)
{
    real_t structure[TB_DOF * TB_CABLES], wrench[TB_DOF];
    real_t tension[TB_CABLES], delivered[TB_DOF], residual[1];
    if (!TAKE(structure) || !TAKE(wrench)) {
        return false;
    }
    int32_t const status[] = {
        (int32_t)tb_distribute_tension(structure, wrench, tension, delivered, residual)};
    return GIVE(tension) && GIVE(delivered) && GIVE(residual) && GIVE(status);
}

static bool start(tb_controller *controller)
{
    real_t lengths[TB_CABLES], rails[TB_RAIL_SLOTS];
    if (!TAKE(lengths) || !TAKE(rails)) {
        return false;
    }
    int32_t const status[] = {(int32_t)tb_controller_start(controller, lengths, rails)};
    return GIVE(status);
}

static bool give_outputs(const tb_outputs *outputs)
{
    const real_t *const residual = &outputs->residual;
    const int32_t *const status = &outputs->status;
    return GIVE(outputs->pose) && GIVE(outputs->velocity) &&
           stream_give(residual, sizeof *residual) && GIVE(outputs->wanted_force) &&
           GIVE(outputs->delivered_force) && GIVE(outputs->tension) && GIVE(outputs->disturbance) &&
           GIVE(outputs->motor_torque) && GIVE(outputs->rail_target) && GIVE(outputs->rail_force) &&
           GIVE(outputs->rail_torque) && GIVE(outputs->gate) && stream_give(status, sizeof *status);
}

static bool step(tb_controller *controller)
{
    tb_inputs inputs;
    tb_outputs outputs;
    if (!TAKE(inputs.lengths) || !TAKE(inputs.rails) || !TAKE(inputs.force) ||
        !TAKE(inputs.hand_force) || !stream_take(&inputs.options, sizeof inputs.options)) {
        return false;
    }
    (void)tb_controller_step(controller, &inputs, &outputs);
    return give_outputs(&outputs);
}

int main(void)
{
    static tb_controller controller;
    uint32_t counts[2];
    bool answered = stream_open() && TAKE(counts);
    for (uint32_t i = 0; answered && (i < counts[0]); i++) {
        answered = distribute();
    }
    answered = answered && start(&controller);
    for (uint32_t i = 0; answered && (i < counts[1]); i++) {
        answered = step(&controller);
    }
    return answered ? 0 : 1;
}
