/* Regenerate: turnbuckle generate machines/yoon_fixed_orthogonal.toml --out <this folder>
 * Machine c858d0533419e597, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_KINEMATICS_H
#define TB_KINEMATICS_H

/* Where the cables are and how they move of yoon_fixed_orthogonal. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Pulley points b_i  (Yoon Fig. 9).
 *  rails [m] (0)  ->  points [m] (4 x 2)
 *  Error of points: double at most 0.0e+00 m; float at most 7.1e-08 m.
 *  Cost, all branches: none. */
tb_status tb_base_points(const real_t rails[1], real_t points[8]);

/** Cable vectors l_i = b_i - c, from the platform to the pulley  (Yoon eq. 1).
 *  pose [m] (2), rails [m] (0)  ->  vectors [m] (4 x 2)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  Error of vectors: double at most 2.2e-16 m (worst found 5.6e-17 at pose (0.00474, 0.2537));
 *    float at most 1.9e-07 m (worst found 4.7e-08 at pose (0.00471, 0.03395)).
 *  Cost, all branches: 6 add. */
tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[1], real_t vectors[8]);

/** Cable lengths l_i = |b_i - c|  (Yoon eq. 18).
 *  pose [m] (2), rails [m] (0)  ->  length [m] (4)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of length: double at most 6.1e-16 m (worst found 1.5e-16 at pose (0.004457, 0.07636));
 *    float at most 3.8e-07 m (worst found 9.6e-08 at pose (0.0004263, 0.07827)).
 *  Cost, all branches: 8 add, 6 mul, 4 sqrt, 4 compare. */
tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[1], real_t length[4]);

/** Structure matrix S: column i is the unit vector along cable i, S T = W  (Yoon eq. 7, 21).
 *  pose [m] (2), rails [m] (0)  ->  structure [-] (2 x 4)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of structure: double at most 1.2e-15 (worst found 2.9e-16 at pose (0.253, 0.1273));
 *    float at most 6.8e-04 (worst found 1.7e-04 at pose (0.506, 0.1419)).
 *  Cost, all branches: 10 add, 14 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[1], real_t structure[8]);

/** Length Jacobian dl/dx = -S'  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (0)  ->  jacobian [-] (4 x 2)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 1.2e-15 (worst found 2.9e-16 at pose (0.253, 0.1273));
 *    float at most 6.8e-04 (worst found 1.7e-04 at pose (0.506, 0.1419)).
 *  Cost, all branches: 14 add, 14 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[1], real_t jacobian[8]);

/** Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot  (Yoon
 *    eq. 6, 20 with normalised rows).
 *  pose [m] (2), rails [m] (0), length_rates [m/s] (4), rail_rates [m/s] (0)  ->  velocity
 *    [m/s] (2)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of velocity: double at most 3.8e-15 m/s (worst found 9.6e-16 at pose (0.0578, 0.1468),
 *    length_rates (-0.9993, -0.03762, 1, -0.7981)); float at most 4.0e-04 m/s (worst found
 *    9.9e-05 at pose (0.506, 0.1419), length_rates (-0.5917, 0.25, -1, -0.8816)).
 *  Cost, all branches: 27 add, 41 mul, 6 div, 4 sqrt, 6 compare, 1 select. */
tb_status tb_task_velocity(const real_t pose[2], const real_t rails[1],
    const real_t length_rates[4], const real_t rail_rates[1], real_t velocity[2]);

/** Pose from lengths: closed form, then one Gauss-Newton step on the least-squares misfit
 *    (Yoon eq. 19).
 *  lengths [m] (4), rails [m] (0)  ->  pose [m] (2), residual [m] (scalar)
 *  Domain: lengths in [0, 3.16] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  Error of pose: double at most 8.9e-15 m (worst found 2.2e-15 at lengths (0.3435, 0.09351,
 *    0.3444, 0.5144)); float at most 1.6e-05 m (worst found 3.9e-06 at lengths (0.309, 0.5223,
 *    0.3091, 0.1296)).
 *  Error of residual: double at most 3.5e-15 m (worst found 8.7e-16 at lengths (0.3435,
 *    0.09333, 0.3439, 0.5127)); float at most 5.4e-06 m (worst found 1.3e-06 at lengths
 *    (0.3129, 0.5175, 0.3125, 0.115)).
 *  Cost, all branches: 60 add, 65 mul, 6 div, 9 sqrt, 10 compare, 1 select. */
tb_status tb_forward_kinematics(const real_t lengths[4], const real_t rails[1], real_t pose[2],
    real_t residual[1]);

/** Pose, residual, structure matrix and velocity at once: forward_kinematics, structure_matrix
 *    and task_velocity without their common work  (Yoon eq. 19, 21, 20 with normalised rows).
 *  lengths [m] (4), rails [m] (0), length_rates [m/s] (4), rail_rates [m/s] (0)  ->  pose [m]
 *    (2), residual [m] (scalar), structure [-] (2 x 4), velocity [m/s] (2)
 *  Domain: lengths in [0, 3.16] m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of pose: double at most 3.4e-14 m (worst found 8.6e-15 at lengths (0.3198, 0.001678,
 *    0.3197, 0.506), length_rates (1, 0.8063, -0.5227, -0.01831)); float at most 8.5e-06 m
 *    (worst found 2.1e-06 at lengths (0.3313, 0.02869, 0.3314, 0.5065), length_rates (-0.7733,
 *    0.7702, -0.03265, -0.9779)).
 *  Error of residual: double at most 5.8e-15 m (worst found 1.5e-15 at lengths (0.287, 0.04598,
 *    0.2869, 0.5086), length_rates (0.2098, 0.4928, 0.1177, -0.6566)); float at most 3.4e-06 m
 *    (worst found 8.4e-07 at lengths (0.3313, 0.02869, 0.331, 0.5065), length_rates (-0.7732,
 *    0.7702, -0.03358, -0.9779)).
 *  Error of structure: double at most 1.7e-12 (worst found 4.2e-13 at lengths (0.3198,
 *    0.001678, 0.3197, 0.506), length_rates (1, 0.8063, -0.5227, -0.01831)); float at most
 *    1.3e-03 (worst found 3.1e-04 at lengths (0.2898, 0, 0.2902, 0.506), length_rates (-0.527,
 *    0.3477, -0.05067, -0.5098)).
 *  Error of velocity: double at most 1.4e-12 m/s (worst found 3.5e-13 at lengths (0.2875,
 *    0.0001936, 0.2876, 0.506), length_rates (-0.7757, -0.2943, -0.1678, -0.376)); float at
 *    most 8.9e-04 m/s (worst found 2.2e-04 at lengths (0.2898, 0, 0.2904, 0.5064), length_rates
 *    (-1, 0.3513, 0.1271, -0.434)).
 *  Cost, all branches: 81 add, 100 mul, 12 div, 9 sqrt, 12 compare, 2 select. */
tb_status tb_locate(const real_t lengths[4], const real_t rails[1],
    const real_t length_rates[4], const real_t rail_rates[1], real_t pose[2],
    real_t residual[1], real_t structure[8], real_t velocity[2]);

#ifdef __cplusplus
}
#endif

#endif
