#include "torque_gate.h"

#include <float.h>
#include <stdbool.h>

#include "tb_machine.h"

#ifdef TB_REAL_FLOAT
#define REAL_MAX FLT_MAX
#else
#define REAL_MAX DBL_MAX
#endif

static const real_t minimum_tension_torque = TB_DRUM_RADIUS * TB_TENSION_MIN;

/* Written as two comparisons that a NaN fails, so that no library is needed. */
static bool is_within(real_t value, real_t low, real_t high)
{
    return (value >= low) && (value <= high);
}

static real_t within_limits(real_t command, uint32_t *flags)
{
    if (!is_within(command, -REAL_MAX, REAL_MAX)) {
        *flags |= TB_GATE_NOT_FINITE;
        return minimum_tension_torque;
    }
    if (command < TB_C(0.0)) {
        *flags |= TB_GATE_BELOW_ZERO;
        return TB_C(0.0);
    }
    if (command > TB_TORQUE_LIMIT) {
        *flags |= TB_GATE_ABOVE_LIMIT;
        return TB_TORQUE_LIMIT;
    }
    return command;
}

static real_t within_rate(real_t previous, real_t command, uint32_t *flags)
{
    if (command > previous + TB_TORQUE_STEP) {
        *flags |= TB_GATE_RATE;
        return previous + TB_TORQUE_STEP;
    }
    if (command < previous - TB_TORQUE_STEP) {
        *flags |= TB_GATE_RATE;
        return previous - TB_TORQUE_STEP;
    }
    return command;
}

uint32_t tb_torque_gate(real_t previous, real_t command, real_t *torque)
{
    uint32_t flags = TB_GATE_PASSED;
    if (!is_within(previous, TB_C(0.0), TB_TORQUE_LIMIT)) {
        flags = TB_GATE_BAD_PREVIOUS;
        previous = TB_C(0.0);
    }
    *torque = within_rate(previous, within_limits(command, &flags), &flags);
    return flags;
}
