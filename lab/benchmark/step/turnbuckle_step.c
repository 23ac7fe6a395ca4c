#include "controller.h"
#include "run_steps.h"

#define INPUTS (TB_CABLES + TB_RAILS + TB_DOF + TB_DOF)
#define OUTPUTS (TB_CABLES + TB_RAILS)

static const real_t *take(size_t count, const real_t from[], real_t to[])
{
    for (size_t i = 0; i < count; i++) {
        to[i] = from[i];
    }
    return from + count;
}

static void read_inputs(const real_t row[], tb_inputs *inputs)
{
    row = take(TB_CABLES, row, inputs->lengths);
    row = take(TB_RAILS, row, inputs->rails);
    row = take(TB_DOF, row, inputs->force);
    (void)take(TB_DOF, row, inputs->hand_force);
}

void run_steps(size_t cycles, const STEP_REAL inputs[], STEP_REAL outputs[])
{
    tb_controller controller;
    tb_inputs given = {.options = 0};
    tb_outputs result;
    read_inputs(inputs, &given);
    (void)tb_controller_start(&controller, given.lengths, given.rails);
    for (size_t i = 0; i < cycles; i++) {
        real_t *const row = &outputs[i * OUTPUTS];
        read_inputs(&inputs[i * INPUTS], &given);
        (void)tb_controller_step(&controller, &given, &result);
        (void)take(TB_CABLES, result.motor_torque, row);
        (void)take(TB_RAILS, result.rail_force, row + TB_CABLES);
    }
}
