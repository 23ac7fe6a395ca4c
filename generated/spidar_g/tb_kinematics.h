/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_KINEMATICS_H
#define TB_KINEMATICS_H

/* Where the cables are and how they move of spidar_g. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Pulley points b_i  (Yoon Fig. 9).
 *  rails [m] (0)  ->  points [m] (8 x 3)
 *  Error of points: double at most 0.0e+00 m; float at most 9.5e-08 m.
 *  Cost, all branches: none. */
tb_status tb_base_points(const real_t rails[1], real_t points[24]);

/** Cable vectors l_i = b_i - c - R p_i, from the anchor to the pulley  (Yoon eq. 1).
 *  pose [m, rad] (6), rails [m] (0)  ->  vectors [m] (8 x 3)
 *  Domain: pose in [-1.2, 1.2] x [-1.2, 1.2] x [-1.2, 1.2] x [-1.5472, 1.5472] x [-1.5472,
 *    1.5472] x [-1.5472, 1.5472] m, rad, else TB_OUT_OF_DOMAIN.
 *  Error of vectors: double at most 3.1e-16 m (worst found 7.8e-17 at pose (0.4049, 0.3269,
 *    0.4899, 0.9464, -0.3964, -0.6875)); float at most 2.7e-07 m (worst found 6.9e-08 at pose
 *    (0.02886, 0.1432, 0.5453, 0.5196, -0.8149, 0.4015)).
 *  Cost, all branches: 81 add, 66 mul. */
tb_status tb_cable_vectors(const real_t pose[6], const real_t rails[1], real_t vectors[24]);

/** Cable lengths l_i = |b_i - c - R p_i|  (Yoon eq. 1).
 *  pose [m, rad] (6), rails [m] (0)  ->  length [m] (8)
 *  Domain: pose in [-1.2, 1.2] x [-1.2, 1.2] x [-1.2, 1.2] x [-1.5472, 1.5472] x [-1.5472,
 *    1.5472] x [-1.5472, 1.5472] m, rad, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of length: double at most 1.1e-15 m (worst found 2.8e-16 at pose (0.5878, 0.05373, 0,
 *    -0.07404, -0.9609, -0.3846)); float at most 6.5e-07 m (worst found 1.6e-07 at pose (0, 0,
 *    0, 0.435, 0.4525, -0.7397)).
 *  Cost, all branches: 89 add, 82 mul, 8 sqrt, 8 compare. */
tb_status tb_cable_lengths(const real_t pose[6], const real_t rails[1], real_t length[8]);

/** Structure matrix S: column i is the unit vector u_i along cable i and its moment R p_i x
 *    u_i, S T = W  (Yoon eq. 7, 21).
 *  pose [m, rad] (6), rails [m] (0)  ->  structure [1, m] (6 x 8)
 *  Domain: pose in [-1.2, 1.2] x [-1.2, 1.2] x [-1.2, 1.2] x [-1.5472, 1.5472] x [-1.5472,
 *    1.5472] x [-1.5472, 1.5472] m, rad, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of structure: double at most 5.1e-14 1, m (worst found 1.3e-14 at pose (0.531, 0.5976,
 *    0.5859, 0.4763, -0.7675, 0.00628)); float at most 7.3e-05 1, m (worst found 1.8e-05 at
 *    pose (0.06241, 0.5643, 0.6, -0.1112, 0.6465, -0.6213)).
 *  Cost, all branches: 131 add, 154 mul, 8 div, 8 sqrt, 8 compare. */
tb_status tb_structure_matrix(const real_t pose[6], const real_t rails[1], real_t structure[48]);

/** Length Jacobian dl/dx = -S', x by the twist (dc, dw) in the fixed frame  (Yoon eq. 3, 20).
 *  pose [m, rad] (6), rails [m] (0)  ->  jacobian [1, m] (8 x 6)
 *  Domain: pose in [-1.2, 1.2] x [-1.2, 1.2] x [-1.2, 1.2] x [-1.5472, 1.5472] x [-1.5472,
 *    1.5472] x [-1.5472, 1.5472] m, rad, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 5.1e-14 1, m (worst found 1.3e-14 at pose (0.531, 0.5976,
 *    0.5859, 0.4763, -0.7675, 0.00628)); float at most 7.3e-05 1, m (worst found 1.8e-05 at
 *    pose (0.06241, 0.5643, 0.6, -0.1112, 0.6465, -0.6213)).
 *  Cost, all branches: 127 add, 186 mul, 16 div, 8 sqrt, 8 compare. */
tb_status tb_length_jacobian(const real_t pose[6], const real_t rails[1], real_t jacobian[48]);

/** Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot  (Yoon
 *    eq. 6, 20 with normalised rows).
 *  pose [m, rad] (6), rails [m] (0), length_rates [m/s] (8), rail_rates [m/s] (0)  ->  velocity
 *    [m/s, rad/s] (6)
 *  Domain: pose in [-1.2, 1.2] x [-1.2, 1.2] x [-1.2, 1.2] x [-1.5472, 1.5472] x [-1.5472,
 *    1.5472] x [-1.5472, 1.5472] m, rad, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 800 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  Error of velocity: double at most 1.9e-08 m/s, rad/s; float at most 1.9e+00 m/s, rad/s.
 *  Cost, all branches: 368 add, 518 mul, 14 div, 8 sqrt, 14 compare, 1 select. */
tb_status tb_task_velocity(const real_t pose[6], const real_t rails[1],
    const real_t length_rates[8], const real_t rail_rates[1], real_t velocity[6]);

/** Pose from lengths: Gauss-Newton on the least-squares misfit, from a guess of the pose, until
 *    a step changes the lengths by rounding or by 1e-09 of the residual  (Yoon eq. 19).
 *  guess [m, rad] (6), lengths [m] (8), rails [m] (0)  ->  pose [m, rad] (6), residual [m]
 *    (scalar)
 *  Domain: guess in [-1.2, 1.2] x [-1.2, 1.2] x [-1.2, 1.2] x [-1.5472, 1.5472] x [-1.5472,
 *    1.5472] x [-1.5472, 1.5472] m, rad, else TB_OUT_OF_DOMAIN.
 *  Domain: lengths in [0, 7.2] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_INACCURATE: not done after 16 steps.
 *  Error of pose: double at most 3.0e-14 m, rad; float at most 1.7e-04 m, rad.
 *  Error of residual: double at most 1.3e-15 m; float at most 7.7e-07 m.
 *  At most 16 steps.
 *  Cost, all branches and steps: 6886 add, 9527 mul, 301 div, 169 sqrt, 254 compare, 289
 *    select. */
tb_status tb_forward_kinematics(const real_t guess[6], const real_t lengths[8],
    const real_t rails[1], real_t pose[6], real_t residual[1]);

/** Pose, residual, structure matrix and velocity at once: forward_kinematics, structure_matrix
 *    and task_velocity without their common work  (Yoon eq. 19, 21, 20 with normalised rows).
 *  guess [m, rad] (6), lengths [m] (8), rails [m] (0), length_rates [m/s] (8), rail_rates [m/s]
 *    (0)  ->  pose [m, rad] (6), residual [m] (scalar), structure [1, m] (6 x 8), velocity
 *    [m/s, rad/s] (6)
 *  Domain: guess in [-1.2, 1.2] x [-1.2, 1.2] x [-1.2, 1.2] x [-1.5472, 1.5472] x [-1.5472,
 *    1.5472] x [-1.5472, 1.5472] m, rad, else TB_OUT_OF_DOMAIN.
 *  Domain: lengths in [0, 7.2] m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 800 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_INACCURATE: not done after 16 steps.
 *  Error of pose: double at most 5.0e-14 m, rad; float at most 1.2e-04 m, rad.
 *  Error of residual: double at most 1.3e-15 m; float at most 7.2e-07 m.
 *  Error of structure: double at most 3.0e-14 1, m; float at most 5.3e-05 1, m.
 *  Error of velocity: double at most 2.0e-10 m/s, rad/s; float at most 1.3e-01 m/s, rad/s.
 *  At most 16 steps.
 *  Cost, all branches and steps: 6977 add, 9614 mul, 302 div, 169 sqrt, 254 compare, 289
 *    select. */
tb_status tb_locate(const real_t guess[6], const real_t lengths[8], const real_t rails[1],
    const real_t length_rates[8], const real_t rail_rates[1], real_t pose[6],
    real_t residual[1], real_t structure[48], real_t velocity[6]);

#ifdef __cplusplus
}
#endif

#endif
