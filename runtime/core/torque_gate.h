/* Torque gate: the only way from a computed torque to a cable motor.
 *
 * Whatever the controller computed, what leaves the gate is
 *   - finite,
 *   - within [0, TB_TORQUE_LIMIT]: a cable pulls, and its motor has a limit,
 *   - at most TB_TORQUE_STEP away from what left it in the previous cycle.
 * A command that is not finite is replaced by the torque of the minimum tension, which keeps the
 * cable taut; it too is reached no faster than TB_TORQUE_STEP a cycle.
 *
 * Pure: no memory, no input or output, no floating-point library. One call gates one motor. */
#ifndef TB_TORQUE_GATE_H
#define TB_TORQUE_GATE_H

#include <stdint.h>

#include "tb_types.h"

/* What the gate changed: the sum of these flags, TB_GATE_PASSED when it changed nothing. */
#define TB_GATE_PASSED ((uint32_t)0)
#define TB_GATE_NOT_FINITE ((uint32_t)1)   /* command not finite: minimum tension instead */
#define TB_GATE_BELOW_ZERO ((uint32_t)2)   /* command below 0: a cable cannot push */
#define TB_GATE_ABOVE_LIMIT ((uint32_t)4)  /* command above TB_TORQUE_LIMIT */
#define TB_GATE_RATE ((uint32_t)8)         /* change cut to TB_TORQUE_STEP */
#define TB_GATE_BAD_PREVIOUS ((uint32_t)16) /* previous outside the limits: memory was damaged */

/** Let a torque through to a motor, as far as the machine's limits allow.
 *  previous [N m]: what this gate let through to the same motor in the previous cycle, 0 before
 *      the first; a value the gate cannot have let through counts as 0 and is flagged.
 *  command [N m]: the wanted torque, any value, NaN and infinities included.
 *  torque [N m]: the torque to send.
 *  Returns the flags of what was changed. */
uint32_t tb_torque_gate(real_t previous, real_t command, real_t *torque);

#endif
