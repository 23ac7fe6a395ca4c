/* Regenerate: turnbuckle generate machines/brau_square.toml --out <this folder>
 * Machine 166f8b7fcb339437, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_CONTROL_H
#define TB_CONTROL_H

/* Control laws around the tension distribution of brau_square. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Motor torque tau = r_p T  (Yoon section III-E).
 *  tension [N] (4)  ->  torque [N m] (4)
 *  Domain: tension with a sum of magnitudes of at most 40000 N, else TB_OUT_OF_DOMAIN.
 *  Error of torque: double at most 1.4e-17 N m (worst found 3.5e-18 at tension (7.638, 9.333,
 *    6.834, 6.571)); float at most 1.2e-08 N m (worst found 3.0e-09 at tension (7.997, 3.508,
 *    5, 10)).
 *  Cost, all branches: 4 mul. */
tb_status tb_motor_torques(const real_t tension[4], real_t torque[4]);

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
 *  structure [-] (2 x 4), tension [N] (4), hand_force [N] (2)  ->  load [N] (4)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 40000 N, else TB_OUT_OF_DOMAIN.
 *  Domain: hand_force with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of load: double at most 3.8e-14 N; float at most 1.9e-05 N.
 *  Cost, all branches: 28 add, 35 mul, 2 div, 2 compare, 1 select. */
tb_status tb_load_tension(const real_t structure[8], const real_t tension[4],
    const real_t hand_force[2], real_t load[4]);

#ifdef __cplusplus
}
#endif

#endif
