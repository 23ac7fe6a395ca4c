/* Regenerate: turnbuckle generate machines/planar_rigid.toml --out <this folder>
 * Machine 95fa38e7104ced7a, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_CONTROL_H
#define TB_CONTROL_H

/* Control laws around the tension distribution of planar_rigid. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Motor torque tau = r_p T  (Yoon section III-E).
 *  tension [N] (6)  ->  torque [N m] (6)
 *  Domain: tension with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  Error of torque: double at most 1.4e-17 N m (worst found 3.5e-18 at tension (3.804, 6.903,
 *    8.186, 9.333, 5.477, 8.113)); float at most 1.2e-08 N m (worst found 3.0e-09 at tension
 *    (6.5, 5.101, 10, 3, 9.861, 7.888)).
 *  Cost, all branches: 6 mul. */
tb_status tb_motor_torques(const real_t tension[6], real_t torque[6]);

/** Force of the virtual walls, max(0, k penetration - b v_n) along each normal  (Yoon eq. 26,
 *    27, never attractive).
 *  pose [m, rad] (3), velocity [m/s, rad/s] (3)  ->  force [N, N m] (3)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: velocity with a sum of magnitudes of at most 300 m/s, rad/s, else TB_OUT_OF_DOMAIN.
 *  Error of force: double at most 0.0e+00 N, N m; float at most 0.0e+00 N, N m.
 *  Cost, all branches: none. */
tb_status tb_wall_force(const real_t pose[3], const real_t velocity[3], real_t force[3]);

/** Tensions nearest the commanded ones that balance the measured force of the hand  (the F_h
 *    path of Yoon Fig. 11).
 *  structure [1, m] (3 x 6), tension [N] (6), hand_force [N, N m] (3)  ->  load [N] (6)
 *  Domain: structure with a sum of magnitudes of at most 72 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  Domain: hand_force with a sum of magnitudes of at most 180000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  Error of load: double at most 1.7e-10 N; float at most 4.3e-02 N.
 *  Cost, all branches: 76 add, 99 mul, 3 div, 3 compare, 1 select. */
tb_status tb_load_tension(const real_t structure[18], const real_t tension[6],
    const real_t hand_force[3], real_t load[6]);

/** Rail coordinates of the orthogonal configuration: the foot of the anchor on each rail  (Yoon
 *    section III-B).
 *  pose [m, rad] (3)  ->  target [m] (6)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Error of target: double at most 2.8e-16 m (worst found 6.9e-17 at pose (0.4867, 0.2678,
 *    0.7404)); float at most 1.4e-07 m (worst found 3.6e-08 at pose (0.67, 0.009213, -0.6234)).
 *  Cost, all branches: 38 add, 41 mul, 12 select. */
tb_status tb_base_targets(const real_t pose[3], real_t target[6]);

/** Force on each base: PID on its rail coordinate, the integral held while saturated  (Yoon
 *    section III-E, Fig. 13).
 *  memory [N, m, m/s] (6 x 3), target [m] (6), measured [m] (6)  ->  next_memory [N, m, m/s] (6
 *    x 3), force [N] (6)
 *  TB_OUT_OF_DOMAIN: an argument is not finite, or leads beyond 1e+09.
 *  Error of next_memory: double at most 3.0e-13 N, m, m/s; float at most 1.7e-04 N, m, m/s.
 *  Error of force: double at most 1.8e-12 N; float at most 1.1e-03 N.
 *  Cost, all branches: 42 add, 30 mul, 30 compare, 18 select. */
tb_status tb_base_pid(const real_t memory[18], const real_t target[6], const real_t measured[6],
    real_t next_memory[18], real_t force[6]);

#ifdef __cplusplus
}
#endif

#endif
