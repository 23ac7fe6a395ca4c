/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_MACHINE_H
#define TB_MACHINE_H

#include "tb_types.h"

#define TB_MACHINE_NAME "spidar_g"
#define TB_MACHINE_HASH "4d479a9b3a2bb17c"

#define TB_DOF 6 /* degrees of freedom of the platform */
#define TB_CABLES 8
#define TB_RAILS 0 /* movable bases */
#define TB_RAIL_SLOTS 1 /* entries of an array of rails */
#define TB_WALLS 0 /* virtual walls */

#define TB_START_POSE {TB_C(0.3), TB_C(0.3), TB_C(0.3), TB_C(0.0), TB_C(0.0), TB_C(0.0)} /* the target's centre, upright: the first guess of the pose */

#define TB_SPACE 3 /* entries of a pose that are a position */
#define TB_LONGEST_ARM TB_C(0.07211102550927978) /* m, from the platform's centre to its farthest anchor */

#define TB_PERIOD TB_C(0.001) /* s, one control cycle */
#define TB_VELOCITY_GAIN TB_C(0.4665119089088967) /* low-pass of the measured rates */

#define TB_TENSION_MIN TB_C(0.5) /* N */
#define TB_TENSION_MAX TB_C(8.0) /* N */
#define TB_DRUM_RADIUS TB_C(0.005) /* m */
#define TB_TORQUE_LIMIT TB_C(0.044) /* N m, most that a cable motor is asked for */
#define TB_TORQUE_STEP TB_C(0.02) /* N m, largest change of a torque in one cycle */

#define TB_HAS_OBSERVER 0
#define TB_HAND_FORCE_MEASURED 0

#define TB_TENSION_MIDDLE TB_C(4.25) /* N, middle of the bounds */
#define TB_TENSION_HALF_RANGE TB_C(3.75) /* N, from the middle to a bound */

#define TB_FRAME TB_C(0.6) /* m, side of the frame */
#define TB_MOMENT_WEIGHT TB_C(13.86750490563073) /* 1/m, of moments in norms of wrenches */

#endif
