#include "run_steps.h"

#include "casadi_step_model.h"

void run_steps(size_t cycles, const STEP_REAL inputs[], STEP_REAL outputs[])
{
    const STEP_REAL *arguments[SZ_ARG];
    STEP_REAL *results[SZ_RES];
    casadi_int integers[SZ_IW];
    STEP_REAL work[SZ_W];
    STEP_REAL memory[2][MEMORY] = {{0}};
    for (size_t i = 0; i < CABLES; i++) {
        memory[0][LENGTHS + i] = inputs[i];
        memory[0][OBSERVER + (i * 5)] = inputs[i];
    }
    for (size_t i = 0; i < RAILS; i++) {
        memory[0][RAIL + i] = inputs[CABLES + i];
        memory[0][BASE + (i * 3) + 1] = inputs[CABLES + i];
    }
    for (size_t i = 0; i < cycles; i++) {
        arguments[0] = &inputs[i * INPUTS];
        arguments[1] = memory[i % 2];
        results[0] = &outputs[i * (CABLES + RAILS)];
        results[1] = memory[(i + 1) % 2];
        (void)casadi_step_model(arguments, results, integers, work, 0);
    }
}
