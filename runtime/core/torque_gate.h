/* Torque gate: the only way from a computed setpoint to a motor.
 *
 * Whatever was computed, what leaves the gate is
 *   - finite and within the motor's limits,
 *   - at most one step away from what left it in the previous cycle,
 *   - at rest while the motor may not follow: at once where its power stage is off, else no faster
 *     than the step allows.
 * A command that is not finite is replaced by a safe one, which too is reached no faster than the
 * step allows.
 *
 * tb_torque_gate is the gate of the cable motors: a torque within [0, TB_TORQUE_LIMIT], because a
 * cable only pulls; steps of TB_TORQUE_STEP; the torque of the minimum tension as the safe one, which
 * keeps the cable taut. The limits of base drives are in setpoints.c.
 *
 * Pure: no memory, no input or output, no floating-point library. One call gates one motor. */
#ifndef TB_TORQUE_GATE_H
#define TB_TORQUE_GATE_H

#include <stdint.h>

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What the gate changed: the sum of these flags, TB_GATE_PASSED when it changed nothing. */
#define TB_GATE_PASSED ((uint32_t)0)
#define TB_GATE_NOT_FINITE ((uint32_t)1)     /* command not finite: the safe one instead */
#define TB_GATE_BELOW_LIMIT ((uint32_t)2)    /* command below the lower limit; a cable's is 0 */
#define TB_GATE_ABOVE_LIMIT ((uint32_t)4)    /* command above the upper limit */
#define TB_GATE_RATE ((uint32_t)8)           /* change cut to one step */
#define TB_GATE_BAD_PREVIOUS ((uint32_t)16)  /* previous outside the limits: memory was damaged */
#define TB_GATE_NOT_PERMITTED ((uint32_t)32) /* the motor may not follow: to rest instead */

/** What a motor may be asked for, all in the unit of its setpoint, N m or m. */
typedef struct {
    real_t low;
    real_t high;
    real_t step; /* largest change in one cycle */
    real_t safe; /* within [low, high]; instead of a command that is not finite */
    real_t rest; /* within [low, high]; where a motor goes that may not follow */
} tb_gate_limits;

/** What a motor may do in this cycle. */
typedef enum {
    TB_PERMIT_COMMAND = 0, /* follow: power on, right mode, fresh measurements */
    TB_PERMIT_REST,        /* powered, but it may not follow: to rest at the gate's rate */
    TB_PERMIT_NOTHING      /* without power: at rest */
} tb_permission;

/** Let a setpoint through to a motor, as far as limits and permission allow.
 *  previous: what this gate let through to the same motor in the previous cycle, `rest` before the
 *      first; a value the gate cannot have let through counts as `rest` and is flagged.
 *  command: the wanted setpoint, any value, NaN and infinities included.
 *  setpoint: what to send.
 *  Returns the flags of what was changed. */
uint32_t tb_gate(const tb_gate_limits *limits, tb_permission permission, real_t previous,
                 real_t command, real_t *setpoint);

/** Let a torque [N m] through to a cable motor that may follow; else as tb_gate. */
uint32_t tb_torque_gate(real_t previous, real_t command, real_t *torque);

/** Limits of every cable motor. */
extern const tb_gate_limits tb_cable_limits;

#ifdef __cplusplus
}
#endif

#endif
