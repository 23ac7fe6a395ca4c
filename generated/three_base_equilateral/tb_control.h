/* Regenerate: turnbuckle generate machines/three_base_equilateral.toml --out <this folder>
 * Machine bf852767ce09ae7f, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_CONTROL_H
#define TB_CONTROL_H

/* Control laws around the tension distribution of three_base_equilateral. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Motor torque tau = r_p T  (Yoon section III-E).
 *  tension [N] (3)  ->  torque [N m] (3)
 *  Domain: tension with a sum of magnitudes of at most 30000 N, else TB_OUT_OF_DOMAIN.
 *  Error of torque: double at most 1.4e-17 N m (worst found 3.5e-18 at tension (4.593, 4.722,
 *    9.333)); float at most 1.2e-08 N m (worst found 3.0e-09 at tension (9.901, 6.202, 10)).
 *  Cost, all branches: 3 mul. */
tb_status tb_motor_torques(const real_t tension[3], real_t torque[3]);

/** Force of the virtual walls, max(0, k penetration - b v_n) along each normal  (Yoon eq. 26,
 *    27, never attractive).
 *  pose [m] (2), velocity [m/s] (2)  ->  force [N] (2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: velocity with a sum of magnitudes of at most 200 m/s, else TB_OUT_OF_DOMAIN.
 *  Error of force: double at most 0.0e+00 N; float at most 0.0e+00 N.
 *  Cost, all branches: none. */
tb_status tb_wall_force(const real_t pose[2], const real_t velocity[2], real_t force[2]);

/** Tensions nearest the commanded ones that balance the measured force of the hand  (the F_h
 *    path of Yoon Fig. 11).
 *  structure [-] (2 x 3), tension [N] (3), hand_force [N] (2)  ->  load [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 30000 N, else TB_OUT_OF_DOMAIN.
 *  Domain: hand_force with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of load: double at most 3.4e-06 N; float at most 1.4e+00 N.
 *  Cost, all branches: 21 add, 28 mul, 2 div, 2 compare, 1 select. */
tb_status tb_load_tension(const real_t structure[6], const real_t tension[3],
    const real_t hand_force[2], real_t load[3]);

/** Rail coordinates of the orthogonal configuration: the foot of the pose on each rail  (Yoon
 *    section III-B).
 *  pose [m] (2)  ->  target [m] (6)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Error of target: double at most 7.2e-16 m (worst found 1.8e-16 at pose (0.6993, 0.7076));
 *    float at most 5.2e-07 m (worst found 1.3e-07 at pose (0.7023, 0.707)).
 *  Cost, all branches: 3 add, 5 mul, 6 select. */
tb_status tb_base_targets(const real_t pose[2], real_t target[6]);

/** Force on each base: PID on its rail coordinate, the integral held while saturated  (Yoon
 *    section III-E, Fig. 13).
 *  memory [N, m, m/s] (6 x 3), target [m] (6), measured [m] (6)  ->  next_memory [N, m, m/s] (6
 *    x 3), force [N] (6)
 *  TB_OUT_OF_DOMAIN: an argument is not finite, or leads beyond 1e+09.
 *  Error of next_memory: double at most 2.8e-13 N, m, m/s; float at most 1.3e-04 N, m, m/s.
 *  Error of force: double at most 2.0e-12 N; float at most 1.3e-03 N.
 *  Cost, all branches: 42 add, 30 mul, 30 compare, 18 select. */
tb_status tb_base_pid(const real_t memory[18], const real_t target[6], const real_t measured[6],
    real_t next_memory[18], real_t force[6]);

#ifdef __cplusplus
}
#endif

#endif
