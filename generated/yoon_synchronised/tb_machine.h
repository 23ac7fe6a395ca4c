/* Regenerate: turnbuckle generate machines/yoon_synchronised.toml --out <this folder>
 * Machine 2674137f8fc00ebb, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_MACHINE_H
#define TB_MACHINE_H

#include "tb_types.h"

#define TB_MACHINE_NAME "yoon_synchronised"
#define TB_MACHINE_HASH "2674137f8fc00ebb"

#define TB_DOF 2 /* degrees of freedom of the platform */
#define TB_CABLES 4
#define TB_RAILS 2 /* movable bases */
#define TB_RAIL_SLOTS 2 /* entries of an array of rails */
#define TB_WALLS 0 /* virtual walls */

#define TB_PERIOD TB_C(0.001) /* s, one control cycle */
#define TB_VELOCITY_GAIN TB_C(0.4665119089088967) /* low-pass of the measured rates */

#define TB_TENSION_MIN TB_C(3.0) /* N */
#define TB_TENSION_MAX TB_C(10.0) /* N */
#define TB_DRUM_RADIUS TB_C(0.005) /* m */
#define TB_TORQUE_LIMIT TB_C(0.055) /* N m, most that a cable motor is asked for */
#define TB_TORQUE_STEP TB_C(0.02) /* N m, largest change of a torque in one cycle */

#define TB_PINION_RADIUS TB_C(0.015) /* m */
#define TB_RAIL_FORCE_LIMIT TB_C(60.0) /* N */

#define TB_HAS_OBSERVER 0
#define TB_HAND_FORCE_MEASURED 0

#define TB_TENSION_MIDDLE TB_C(6.5) /* N, middle of the bounds */
#define TB_TENSION_HALF_RANGE TB_C(3.5) /* N, from the middle to a bound */

#define TB_CONTROL_RATE TB_C(1000.0) /* Hz */

#define TB_RAIL_STIFFNESS TB_C(11000.0) /* N/m */
#define TB_RAIL_DAMPING TB_C(140.0) /* N s/m */
#define TB_RAIL_INTEGRAL_STEP TB_C(30.0) /* N/m, of one cycle */
#define TB_RAIL_SPEED_GAIN TB_C(0.7153904566639707) /* low-pass of a base's speed */

#define TB_FRAME_X TB_C(0.7118) /* m, side of the frame */
#define TB_FRAME_Y TB_C(0.4618) /* m, side of the frame */

#endif
