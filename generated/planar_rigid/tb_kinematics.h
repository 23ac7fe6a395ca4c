/* Regenerate: turnbuckle generate machines/planar_rigid.toml --out <this folder>
 * Machine 95fa38e7104ced7a, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_KINEMATICS_H
#define TB_KINEMATICS_H

/* Where the cables are and how they move of planar_rigid. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Pulley points b_i  (Yoon Fig. 9).
 *  rails [m] (6)  ->  points [m] (6 x 2)
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  Error of points: double at most 0.0e+00 m; float at most 8.3e-08 m (worst found 2.1e-08 at
 *    rails (0, 0.04644, 0.2514, 0.02779, 0, 0.2104)).
 *  Cost, all branches: none. */
tb_status tb_base_points(const real_t rails[6], real_t points[12]);

/** Cable vectors l_i = b_i - c - R p_i, from the anchor to the pulley  (Yoon eq. 1).
 *  pose [m, rad] (3), rails [m] (6)  ->  vectors [m] (6 x 2)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  Error of vectors: double at most 4.9e-16 m; float at most 2.6e-07 m.
 *  Cost, all branches: 60 add, 47 mul. */
tb_status tb_cable_vectors(const real_t pose[3], const real_t rails[6], real_t vectors[12]);

/** Cable lengths l_i = |b_i - c - R p_i|  (Yoon eq. 1).
 *  pose [m, rad] (3), rails [m] (6)  ->  length [m] (6)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of length: double at most 8.6e-16 m; float at most 4.3e-07 m.
 *  Cost, all branches: 63 add, 59 mul, 6 sqrt, 6 compare. */
tb_status tb_cable_lengths(const real_t pose[3], const real_t rails[6], real_t length[6]);

/** Structure matrix S: column i is the unit vector u_i along cable i and its moment R p_i x
 *    u_i, S T = W  (Yoon eq. 7, 21).
 *  pose [m, rad] (3), rails [m] (6)  ->  structure [1, m] (3 x 6)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of structure: double at most 1.7e-12 1, m; float at most 1.2e-03 1, m.
 *  Cost, all branches: 74 add, 83 mul, 6 div, 6 sqrt, 6 compare. */
tb_status tb_structure_matrix(const real_t pose[3], const real_t rails[6], real_t structure[18]);

/** Length Jacobian dl/dx = -S', x by the twist (dc, dw) in the fixed frame  (Yoon eq. 3, 20).
 *  pose [m, rad] (3), rails [m] (6)  ->  jacobian [1, m] (6 x 3)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 1.7e-12 1, m; float at most 1.2e-03 1, m.
 *  Cost, all branches: 79 add, 101 mul, 12 div, 6 sqrt, 6 compare. */
tb_status tb_length_jacobian(const real_t pose[3], const real_t rails[6], real_t jacobian[18]);

/** Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot  (Yoon
 *    eq. 6, 20 with normalised rows).
 *  pose [m, rad] (3), rails [m] (6), length_rates [m/s] (6), rail_rates [m/s] (6)  ->  velocity
 *    [m/s, rad/s] (3)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 600 m/s, else TB_OUT_OF_DOMAIN.
 *  Domain: rail_rates with a sum of magnitudes of at most 600 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  Error of velocity: double at most 3.7e-10 m/s, rad/s; float at most 1.0e-01 m/s, rad/s.
 *  Cost, all branches: 131 add, 170 mul, 9 div, 6 sqrt, 9 compare, 1 select. */
tb_status tb_task_velocity(const real_t pose[3], const real_t rails[6],
    const real_t length_rates[6], const real_t rail_rates[6], real_t velocity[3]);

/** Rail Jacobian dl/ds  (Yoon eq. 3, 20).
 *  pose [m, rad] (3), rails [m] (6)  ->  jacobian [-] (6 x 6)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 1.3e-12; float at most 1.2e-03.
 *  Cost, all branches: 63 add, 59 mul, 6 div, 6 sqrt, 6 compare. */
tb_status tb_rail_jacobian(const real_t pose[3], const real_t rails[6], real_t jacobian[36]);

/** Pose from lengths: Gauss-Newton on the least-squares misfit, from a guess of the pose, until
 *    a step changes the lengths by rounding or by 1e-09 of the residual  (Yoon eq. 19).
 *  guess [m, rad] (3), lengths [m] (6), rails [m] (6)  ->  pose [m, rad] (3), residual [m]
 *    (scalar)
 *  Domain: guess in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: lengths in [0, 4.6944] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 16 steps.
 *  Error of pose: double at most 2.1e-14 m, rad; float at most 1.3e-04 m, rad.
 *  Error of residual: double at most 8.6e-16 m; float at most 5.1e-07 m.
 *  At most 16 steps.
 *  Cost, all branches and steps: 2386 add, 3070 mul, 184 div, 119 sqrt, 169 compare, 177
 *    select. */
tb_status tb_forward_kinematics(const real_t guess[3], const real_t lengths[6],
    const real_t rails[6], real_t pose[3], real_t residual[1]);

/** Pose, residual, structure matrix and velocity at once: forward_kinematics, structure_matrix
 *    and task_velocity without their common work  (Yoon eq. 19, 21, 20 with normalised rows).
 *  guess [m, rad] (3), lengths [m] (6), rails [m] (6), length_rates [m/s] (6), rail_rates [m/s]
 *    (6)  ->  pose [m, rad] (3), residual [m] (scalar), structure [1, m] (3 x 6), velocity
 *    [m/s, rad/s] (3)
 *  Domain: guess in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: lengths in [0, 4.6944] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 600 m/s, else TB_OUT_OF_DOMAIN.
 *  Domain: rail_rates with a sum of magnitudes of at most 600 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 16 steps.
 *  Error of pose: double at most 2.2e-14 m, rad; float at most 1.4e-04 m, rad.
 *  Error of residual: double at most 8.3e-16 m; float at most 5.1e-07 m.
 *  Error of structure: double at most 8.0e-13 1, m; float at most 2.2e-03 1, m.
 *  Error of velocity: double at most 1.2e-11 m/s, rad/s; float at most 2.2e-02 m/s, rad/s.
 *  At most 16 steps.
 *  Cost, all branches and steps: 2419 add, 3104 mul, 185 div, 119 sqrt, 169 compare, 177
 *    select. */
tb_status tb_locate(const real_t guess[3], const real_t lengths[6], const real_t rails[6],
    const real_t length_rates[6], const real_t rail_rates[6], real_t pose[3],
    real_t residual[1], real_t structure[18], real_t velocity[3]);

#ifdef __cplusplus
}
#endif

#endif
