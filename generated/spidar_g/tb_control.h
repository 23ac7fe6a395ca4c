/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_CONTROL_H
#define TB_CONTROL_H

/* Control laws around the tension distribution of spidar_g. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Motor torque tau = r_p T  (Yoon section III-E).
 *  tension [N] (8)  ->  torque [N m] (8)
 *  Domain: tension with a sum of magnitudes of at most 64000 N, else TB_OUT_OF_DOMAIN.
 *  Error of torque: double at most 1.4e-17 N m (worst found 3.5e-18 at tension (2.693, 6.781,
 *    7.644, 6.823, 5.838, 6.668, 3.353, 4.165)); float at most 1.1e-08 N m (worst found 2.7e-09
 *    at tension (3.112, 4.25, 7.862, 5.846, 4.954, 7.946, 1.729, 6.968)).
 *  Cost, all branches: 8 mul. */
tb_status tb_motor_torques(const real_t tension[8], real_t torque[8]);

/** Force of the virtual walls, max(0, k penetration - b v_n) along each normal  (Yoon eq. 26,
 *    27, never attractive).
 *  pose [m, rad] (6), velocity [m/s, rad/s] (6)  ->  force [N, N m] (6)
 *  Domain: pose in [-1.2, 1.2] x [-1.2, 1.2] x [-1.2, 1.2] x [-1.5472, 1.5472] x [-1.5472,
 *    1.5472] x [-1.5472, 1.5472] m, rad, else TB_OUT_OF_DOMAIN.
 *  Domain: velocity with a sum of magnitudes of at most 600 m/s, rad/s, else TB_OUT_OF_DOMAIN.
 *  Error of force: double at most 0.0e+00 N, N m; float at most 0.0e+00 N, N m.
 *  Cost, all branches: none. */
tb_status tb_wall_force(const real_t pose[6], const real_t velocity[6], real_t force[6]);

/** Tensions nearest the commanded ones that balance the measured force of the hand  (the F_h
 *    path of Yoon Fig. 11).
 *  structure [1, m] (6 x 8), tension [N] (8), hand_force [N, N m] (6)  ->  load [N] (8)
 *  Domain: structure with a sum of magnitudes of at most 192 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 64000 N, else TB_OUT_OF_DOMAIN.
 *  Domain: hand_force with a sum of magnitudes of at most 384000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  Error of load: double at most 1.3e-08 N; float at most 7.6e+01 N.
 *  Cost, all branches: 308 add, 412 mul, 6 div, 6 compare, 1 select. */
tb_status tb_load_tension(const real_t structure[48], const real_t tension[8],
    const real_t hand_force[6], real_t load[8]);

#ifdef __cplusplus
}
#endif

#endif
