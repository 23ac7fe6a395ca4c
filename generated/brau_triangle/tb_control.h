/* Regenerate: turnbuckle generate machines/brau_triangle.toml --out <this folder>
 * Machine 62d2624dcb098eaa, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_CONTROL_H
#define TB_CONTROL_H

/* Control laws around the tension distribution of brau_triangle. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Motor torque tau = r_p T  (Yoon section III-E).
 *  tension [N] (3)  ->  torque [N m] (3)
 *  Domain: tension with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  Error of torque: double at most 2.8e-17 N m (worst found 6.9e-18 at tension (20, 18.67,
 *    1.642)); float at most 2.4e-08 N m (worst found 6.0e-09 at tension (20, 1.396, 12.45)).
 *  Cost, all branches: 3 mul. */
tb_status tb_motor_torques(const real_t tension[3], real_t torque[3]);

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
 *  structure [-] (2 x 3), tension [N] (3), hand_force [N] (2)  ->  load [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  Domain: hand_force with a sum of magnitudes of at most 120000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of load: double at most 1.7e-13 N; float at most 9.8e-05 N.
 *  Cost, all branches: 21 add, 28 mul, 2 div, 2 compare, 1 select. */
tb_status tb_load_tension(const real_t structure[6], const real_t tension[3],
    const real_t hand_force[2], real_t load[3]);

#ifdef __cplusplus
}
#endif

#endif
