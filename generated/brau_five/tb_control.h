/* Regenerate: turnbuckle generate machines/brau_five.toml --out <this folder>
 * Machine b614899c8a021831, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_CONTROL_H
#define TB_CONTROL_H

/* Control laws around the tension distribution of brau_five. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Motor torque tau = r_p T  (Yoon section III-E).
 *  tension [N] (5)  ->  torque [N m] (5)
 *  Domain: tension with a sum of magnitudes of at most 50000 N, else TB_OUT_OF_DOMAIN.
 *  Error of torque: double at most 1.4e-17 N m (worst found 3.5e-18 at tension (0.1186, 6.667,
 *    5.968, 6.523, 8.625)); float at most 1.2e-08 N m (worst found 3.0e-09 at tension (7.434,
 *    2.906, 7.815, 10, 0.6982)).
 *  Cost, all branches: 5 mul. */
tb_status tb_motor_torques(const real_t tension[5], real_t torque[5]);

/** Force of the virtual walls, max(0, k penetration - b v_n) along each normal  (Yoon eq. 26,
 *    27, never attractive).
 *  pose [m] (2), velocity [m/s] (2)  ->  force [N] (2)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  Domain: velocity with a sum of magnitudes of at most 200 m/s, else TB_OUT_OF_DOMAIN.
 *  Error of force: double at most 0.0e+00 N; float at most 0.0e+00 N.
 *  Cost, all branches: none. */
tb_status tb_wall_force(const real_t pose[2], const real_t velocity[2], real_t force[2]);

/** Tensions nearest the commanded ones that balance the measured force of the hand  (the F_h
 *    path of Yoon Fig. 11).
 *  structure [-] (2 x 5), tension [N] (5), hand_force [N] (2)  ->  load [N] (5)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 50000 N, else TB_OUT_OF_DOMAIN.
 *  Domain: hand_force with a sum of magnitudes of at most 100000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of load: double at most 3.9e-14 N; float at most 2.2e-05 N.
 *  Cost, all branches: 35 add, 42 mul, 2 div, 2 compare, 1 select. */
tb_status tb_load_tension(const real_t structure[10], const real_t tension[5],
    const real_t hand_force[2], real_t load[5]);

#ifdef __cplusplus
}
#endif

#endif
