#include <stddef.h>
#include <string.h>

#include "controller.h"
#include "run_steps.h"

#define INPUTS (TB_CABLES + TB_RAILS + TB_DOF + TB_DOF)
#define OUTPUTS (TB_CABLES + TB_RAILS)

/* A row is laid out as the beginning of tb_inputs: copied as a whole, as a driver would fill it. */
_Static_assert(offsetof(tb_inputs, options) == INPUTS * sizeof(real_t),
               "a row must hold lengths, rails, force and hand force without gaps");

static void read_inputs(const real_t row[], tb_inputs *inputs)
{
    memcpy(inputs, row, INPUTS * sizeof(real_t));
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
        memcpy(row, result.motor_torque, sizeof result.motor_torque);
        memcpy(row + TB_CABLES, result.rail_force, TB_RAILS * sizeof(real_t));
    }
}
