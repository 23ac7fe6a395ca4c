/* Regenerate: turnbuckle generate machines/brau_tetrahedron.toml --out <this folder>
 * Machine 1c3579fddb96c4cf, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_CONTROL_H
#define TB_CONTROL_H

/* Control laws around the tension distribution of brau_tetrahedron. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Motor torque tau = r_p T  (Yoon section III-E).
 *  tension [N] (4)  ->  torque [N m] (4)
 *  Domain: tension with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  Error of torque: double at most 2.8e-17 N m (worst found 6.9e-18 at tension (11.29, 10, 0,
 *    18.67)); float at most 2.4e-08 N m (worst found 6.0e-09 at tension (9.388, 20, 14.64,
 *    10)).
 *  Cost, all branches: 4 mul. */
tb_status tb_motor_torques(const real_t tension[4], real_t torque[4]);

/** Force of the virtual walls, max(0, k penetration - b v_n) along each normal  (Yoon eq. 26,
 *    27, never attractive).
 *  pose [m] (3), velocity [m/s] (3)  ->  force [N] (3)
 *  Domain: pose with a sum of magnitudes of at most 6 m, else TB_OUT_OF_DOMAIN.
 *  Domain: velocity with a sum of magnitudes of at most 300 m/s, else TB_OUT_OF_DOMAIN.
 *  Error of force: double at most 0.0e+00 N; float at most 0.0e+00 N.
 *  Cost, all branches: none. */
tb_status tb_wall_force(const real_t pose[3], const real_t velocity[3], real_t force[3]);

/** Tensions nearest the commanded ones that balance the measured force of the hand  (the F_h
 *    path of Yoon Fig. 11).
 *  structure [-] (3 x 4), tension [N] (4), hand_force [N] (3)  ->  load [N] (4)
 *  Domain: structure with a sum of magnitudes of at most 48, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  Domain: hand_force with a sum of magnitudes of at most 240000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  Error of load: double at most 6.5e-13 N; float at most 2.7e-04 N.
 *  Cost, all branches: 52 add, 68 mul, 3 div, 3 compare, 1 select. */
tb_status tb_load_tension(const real_t structure[12], const real_t tension[4],
    const real_t hand_force[3], real_t load[4]);

#ifdef __cplusplus
}
#endif

#endif
