/* Regenerate: turnbuckle generate machines/brau_five.toml --out <this folder>
 * Machine b614899c8a021831, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_MACHINE_H
#define TB_MACHINE_H

#include "tb_types.h"

#define TB_MACHINE_NAME "brau_five"
#define TB_MACHINE_HASH "b614899c8a021831"

#define TB_DOF 2 /* degrees of freedom of the platform */
#define TB_CABLES 5
#define TB_RAILS 0 /* movable bases */
#define TB_RAIL_SLOTS 1 /* entries of an array of rails */
#define TB_WALLS 0 /* virtual walls */

#define TB_PERIOD TB_C(0.001) /* s, one control cycle */
#define TB_VELOCITY_GAIN TB_C(0.4665119089088967) /* low-pass of the measured rates */

#define TB_TENSION_MIN TB_C(0.0) /* N */
#define TB_TENSION_MAX TB_C(10.0) /* N */
#define TB_DRUM_RADIUS TB_C(0.005) /* m */
#define TB_TORQUE_LIMIT TB_C(0.055) /* N m, most that a cable motor is asked for */
#define TB_TORQUE_STEP TB_C(0.02) /* N m, largest change of a torque in one cycle */

#define TB_HAS_OBSERVER 0
#define TB_HAND_FORCE_MEASURED 0

#define TB_FRAME TB_C(1.0) /* m, side of the frame */

#define TB_BASE_5_X TB_C(0.5) /* m, base of cable 5 */

#endif
