/* Regenerate: turnbuckle generate machines/brau_tetrahedron.toml --out <this folder>
 * Machine 1c3579fddb96c4cf, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_KINEMATICS_H
#define TB_KINEMATICS_H

/* Where the cables are and how they move of brau_tetrahedron. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Pulley points b_i  (Yoon Fig. 9).
 *  rails [m] (0)  ->  points [m] (4 x 3)
 *  Error of points: double at most 0.0e+00 m; float at most 1.2e-07 m.
 *  Cost, all branches: none. */
tb_status tb_base_points(const real_t rails[1], real_t points[12]);

/** Cable vectors l_i = b_i - c, from the platform to the pulley  (Yoon eq. 1).
 *  pose [m] (3), rails [m] (0)  ->  vectors [m] (4 x 3)
 *  Domain: pose with a sum of magnitudes of at most 6 m, else TB_OUT_OF_DOMAIN.
 *  Error of vectors: double at most 2.2e-16 m (worst found 5.6e-17 at pose (0.5118, 0.8231,
 *    0.1177)); float at most 2.4e-07 m (worst found 6.0e-08 at pose (0.7199, 0.7236, 0.2302)).
 *  Cost, all branches: 8 add. */
tb_status tb_cable_vectors(const real_t pose[3], const real_t rails[1], real_t vectors[12]);

/** Cable lengths l_i = |b_i - c|  (Yoon eq. 18).
 *  pose [m] (3), rails [m] (0)  ->  length [m] (4)
 *  Domain: pose with a sum of magnitudes of at most 6 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of length: double at most 1.1e-15 m (worst found 2.7e-16 at pose (0.02625, 0.7878,
 *    0.7584)); float at most 6.0e-07 m (worst found 1.5e-07 at pose (0.4576, 0.07205, 0.7334)).
 *  Cost, all branches: 13 add, 8 mul, 4 sqrt, 4 compare. */
tb_status tb_cable_lengths(const real_t pose[3], const real_t rails[1], real_t length[4]);

/** Structure matrix S: column i is the unit vector along cable i, S T = W  (Yoon eq. 7, 21).
 *  pose [m] (3), rails [m] (0)  ->  structure [-] (3 x 4)
 *  Domain: pose with a sum of magnitudes of at most 6 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of structure: double at most 1.1e-15 (worst found 2.6e-16 at pose (0.753, 0.1676,
 *    0.0849)); float at most 5.8e-04 (worst found 1.4e-04 at pose (0.5, 0.2885, 0.8165)).
 *  Cost, all branches: 19 add, 20 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_structure_matrix(const real_t pose[3], const real_t rails[1], real_t structure[12]);

/** Length Jacobian dl/dx = -S'  (Yoon eq. 3, 20).
 *  pose [m] (3), rails [m] (0)  ->  jacobian [-] (4 x 3)
 *  Domain: pose with a sum of magnitudes of at most 6 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 1.1e-15 (worst found 2.6e-16 at pose (0.753, 0.1676,
 *    0.0849)); float at most 5.8e-04 (worst found 1.4e-04 at pose (0.5, 0.2885, 0.8165)).
 *  Cost, all branches: 19 add, 20 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_length_jacobian(const real_t pose[3], const real_t rails[1], real_t jacobian[12]);

/** Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot  (Yoon
 *    eq. 6, 20 with normalised rows).
 *  pose [m] (3), rails [m] (0), length_rates [m/s] (4), rail_rates [m/s] (0)  ->  velocity
 *    [m/s] (3)
 *  Domain: pose with a sum of magnitudes of at most 6 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  Error of velocity: double at most 7.1e-15 m/s (worst found 1.8e-15 at pose (0.7582, 0.862,
 *    0.7591), length_rates (0.9059, -1, 1, -0.4423)); float at most 1.3e-04 m/s (worst found
 *    3.2e-05 at pose (0.4999, 0.866, 0), length_rates (-0.3803, -0.2659, -0.9948, -0.9285)).
 *  Cost, all branches: 51 add, 76 mul, 7 div, 4 sqrt, 7 compare, 1 select. */
tb_status tb_task_velocity(const real_t pose[3], const real_t rails[1],
    const real_t length_rates[4], const real_t rail_rates[1], real_t velocity[3]);

/** Pose from lengths: closed form, then one Gauss-Newton step on the least-squares misfit
 *    (Yoon eq. 19).
 *  lengths [m] (4), rails [m] (0)  ->  pose [m] (3), residual [m] (scalar)
 *  Domain: lengths in [0, 10.7301] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one plane.
 *  TB_SINGULAR: the platform is at a pulley.
 *  Error of pose: double at most 3.5e-15 m (worst found 8.8e-16 at lengths (1.025, 1.014,
 *    1.013, 0.3423)); float at most 2.4e-06 m (worst found 6.1e-07 at lengths (1.072, 1.048,
 *    1.063, 0.3615)).
 *  Error of residual: double at most 1.5e-15 m (worst found 3.9e-16 at lengths (1.015, 1.028,
 *    1.015, 0.3433)); float at most 1.2e-06 m (worst found 3.1e-07 at lengths (0.1111, 1.555,
 *    0.9677, 0.6026)).
 *  Cost, all branches: 99 add, 108 mul, 7 div, 9 sqrt, 10 compare, 1 select. */
tb_status tb_forward_kinematics(const real_t lengths[4], const real_t rails[1], real_t pose[3],
    real_t residual[1]);

/** Pose, residual, structure matrix and velocity at once: forward_kinematics, structure_matrix
 *    and task_velocity without their common work  (Yoon eq. 19, 21, 20 with normalised rows).
 *  lengths [m] (4), rails [m] (0), length_rates [m/s] (4), rail_rates [m/s] (0)  ->  pose [m]
 *    (3), residual [m] (scalar), structure [-] (3 x 4), velocity [m/s] (3)
 *  Domain: lengths in [0, 10.7301] m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one plane.
 *  TB_SINGULAR: the platform is at a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  Error of pose: double at most 1.0e-14 m (worst found 2.5e-15 at lengths (0.1066, 1.001,
 *    1.001, 1.002), length_rates (-0.002875, 0.4373, 0.7438, -0.8159)); float at most 3.3e-06 m
 *    (worst found 8.2e-07 at lengths (1, 1, 0.01001, 1), length_rates (0.5085, -0.267, 0.3563,
 *    -0.01283)).
 *  Error of residual: double at most 4.1e-15 m (worst found 1.0e-15 at lengths (0.1066, 1.001,
 *    1.001, 1.002), length_rates (-0.002875, 0.4373, 0.7438, -0.8159)); float at most 8.0e-07 m
 *    (worst found 2.0e-07 at lengths (0.2578, 1.033, 1.033, 0.8034), length_rates (0.5461,
 *    -0.4127, -0.6004, 0.9949)).
 *  Error of structure: double at most 1.3e-12 (worst found 3.2e-13 at lengths (1, 1, 0,
 *    0.9987), length_rates (0.6404, 0.1316, 0.3674, 0.001074)); float at most 4.5e-04 (worst
 *    found 1.1e-04 at lengths (1, 1, 0.01001, 1), length_rates (0.5085, -0.267, 0.3563,
 *    -0.01283)).
 *  Error of velocity: double at most 5.8e-13 m/s (worst found 1.4e-13 at lengths (1.002, 1.001,
 *    0, 1), length_rates (-0.3319, -0.08538, -0.882, -0.8075)); float at most 2.9e-04 m/s
 *    (worst found 7.4e-05 at lengths (0.9974, 0.998, 0.004063, 0.9975), length_rates (-0.3891,
 *    -0.1283, -0.6824, -0.913)).
 *  Cost, all branches: 143 add, 176 mul, 14 div, 9 sqrt, 13 compare, 2 select. */
tb_status tb_locate(const real_t lengths[4], const real_t rails[1],
    const real_t length_rates[4], const real_t rail_rates[1], real_t pose[3],
    real_t residual[1], real_t structure[12], real_t velocity[3]);

#ifdef __cplusplus
}
#endif

#endif
