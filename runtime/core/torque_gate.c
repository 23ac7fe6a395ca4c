#include "torque_gate.h"

#include <float.h>
#include <stdbool.h>

#include "tb_machine.h"

#ifdef TB_REAL_FLOAT
#define REAL_MAX FLT_MAX
#else
#define REAL_MAX DBL_MAX
#endif

const tb_gate_limits tb_cable_limits = {.low = TB_C(0.0),
                                        .high = TB_TORQUE_LIMIT,
                                        .step = TB_TORQUE_STEP,
                                        .safe = TB_DRUM_RADIUS * TB_TENSION_MIN,
                                        .rest = TB_C(0.0)};

/* Written as two comparisons that a NaN fails, so that no library is needed. */
static bool is_within(real_t value, real_t low, real_t high)
{
    return (value >= low) && (value <= high);
}

static real_t within_limits(const tb_gate_limits *limits, real_t command, uint32_t *flags)
{
    if (!is_within(command, -REAL_MAX, REAL_MAX)) {
        *flags |= TB_GATE_NOT_FINITE;
        return limits->safe;
    }
    if (command < limits->low) {
        *flags |= TB_GATE_BELOW_LIMIT;
        return limits->low;
    }
    if (command > limits->high) {
        *flags |= TB_GATE_ABOVE_LIMIT;
        return limits->high;
    }
    return command;
}

static real_t within_rate(real_t step, real_t previous, real_t command, uint32_t *flags)
{
    if (command > previous + step) {
        *flags |= TB_GATE_RATE;
        return previous + step;
    }
    if (command < previous - step) {
        *flags |= TB_GATE_RATE;
        return previous - step;
    }
    return command;
}

uint32_t tb_gate(const tb_gate_limits *limits, tb_permission permission, real_t previous,
                 real_t command, real_t *setpoint)
{
    uint32_t flags = TB_GATE_PASSED;
    if (!is_within(previous, limits->low, limits->high)) {
        flags = TB_GATE_BAD_PREVIOUS;
        previous = limits->rest;
    }
    if (permission != TB_PERMIT_COMMAND) {
        flags |= TB_GATE_NOT_PERMITTED;
        command = limits->rest;
    }
    if (permission == TB_PERMIT_NOTHING) {
        previous = limits->rest;
    }
    *setpoint = within_rate(limits->step, previous, within_limits(limits, command, &flags), &flags);
    return flags;
}

uint32_t tb_torque_gate(real_t previous, real_t command, real_t *torque)
{
    return tb_gate(&tb_cable_limits, TB_PERMIT_COMMAND, previous, command, torque);
}
