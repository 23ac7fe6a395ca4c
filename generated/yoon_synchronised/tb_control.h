/* Regenerate: turnbuckle generate machines/yoon_synchronised.toml --out <this folder>
 * Machine 2674137f8fc00ebb, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_CONTROL_H
#define TB_CONTROL_H

/* Control laws around the tension distribution of yoon_synchronised. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Motor torque tau = r_p T  (Yoon section III-E).
 *  tension [N] (4)  ->  torque [N m] (4)
 *  Domain: tension with a sum of magnitudes of at most 40000 N, else TB_OUT_OF_DOMAIN.
 *  Error of torque: double at most 1.4e-17 N m (worst found 3.5e-18 at tension (6.667, 4.588,
 *    3.671, 6.786)); float at most 1.2e-08 N m (worst found 3.0e-09 at tension (9.186, 10,
 *    3.113, 6.258)).
 *  Cost, all branches: 4 mul. */
tb_status tb_motor_torques(const real_t tension[4], real_t torque[4]);

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
 *  structure [-] (2 x 4), tension [N] (4), hand_force [N] (2)  ->  load [N] (4)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 40000 N, else TB_OUT_OF_DOMAIN.
 *  Domain: hand_force with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of load: double at most 1.2e-13 N; float at most 3.1e-05 N.
 *  Cost, all branches: 28 add, 35 mul, 2 div, 2 compare, 1 select. */
tb_status tb_load_tension(const real_t structure[8], const real_t tension[4],
    const real_t hand_force[2], real_t load[4]);

/** Rail coordinates of the orthogonal configuration: the foot of the pose on each rail  (Yoon
 *    section III-B).
 *  pose [m] (2)  ->  target [m] (2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Error of target: double at most 0.0e+00 m; float at most 3.6e-08 m (worst found 9.0e-09 at
 *    pose (0.1364, 0.4618)).
 *  Cost, all branches: 4 select. */
tb_status tb_base_targets(const real_t pose[2], real_t target[2]);

/** Force on each base: PID on its rail coordinate, the integral held while saturated  (Yoon
 *    section III-E, Fig. 13).
 *  memory [N, m, m/s] (2 x 3), target [m] (2), measured [m] (2)  ->  next_memory [N, m, m/s] (2
 *    x 3), force [N] (2)
 *  TB_OUT_OF_DOMAIN: an argument is not finite, or leads beyond 1e+09.
 *  Error of next_memory: double at most 2.7e-13 N, m, m/s; float at most 1.5e-04 N, m, m/s.
 *  Error of force: double at most 3.0e-12 N; float at most 6.4e-04 N.
 *  Cost, all branches: 14 add, 10 mul, 10 compare, 6 select. */
tb_status tb_base_pid(const real_t memory[6], const real_t target[2], const real_t measured[2],
    real_t next_memory[6], real_t force[2]);

#ifdef __cplusplus
}
#endif

#endif
