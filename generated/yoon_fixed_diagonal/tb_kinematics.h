/* Regenerate: turnbuckle generate machines/yoon_fixed_diagonal.toml --out <this folder>
 * Machine 7ea279c692dea1e9, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_KINEMATICS_H
#define TB_KINEMATICS_H

/* Where the cables are and how they move of yoon_fixed_diagonal. Results are written last, so an array may be argument and result at once. */

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
 *  Cost, all branches: 4 add. */
tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[1], real_t vectors[8]);

/** Cable lengths l_i = |b_i - c|  (Yoon eq. 18).
 *  pose [m] (2), rails [m] (0)  ->  length [m] (4)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of length: double at most 6.1e-16 m (worst found 1.5e-16 at pose (8.868e-05, 0.1237));
 *    float at most 3.9e-07 m (worst found 9.8e-08 at pose (0.005258, 0.1351)).
 *  Cost, all branches: 6 add, 4 mul, 4 sqrt, 4 compare. */
tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[1], real_t length[4]);

/** Structure matrix S: column i is the unit vector along cable i, S T = W  (Yoon eq. 7, 21).
 *  pose [m] (2), rails [m] (0)  ->  structure [-] (2 x 4)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of structure: double at most 1.2e-15 (worst found 3.1e-16 at pose (0.506, 0.02459));
 *    float at most 6.9e-04 (worst found 1.7e-04 at pose (0.506, 0.0001028)).
 *  Cost, all branches: 10 add, 12 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[1], real_t structure[8]);

/** Length Jacobian dl/dx = -S'  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (0)  ->  jacobian [-] (4 x 2)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 1.2e-15 (worst found 3.1e-16 at pose (0.506, 0.02459));
 *    float at most 6.9e-04 (worst found 1.7e-04 at pose (0.506, 0.0001028)).
 *  Cost, all branches: 10 add, 12 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[1], real_t jacobian[8]);

/** Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot  (Yoon
 *    eq. 6, 20 with normalised rows).
 *  pose [m] (2), rails [m] (0), length_rates [m/s] (4), rail_rates [m/s] (0)  ->  velocity
 *    [m/s] (2)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of velocity: double at most 3.5e-15 m/s (worst found 8.7e-16 at pose (0.3707, 0.2498),
 *    length_rates (-0.5268, -0.9826, 0.9889, 0.9045)); float at most 3.6e-04 m/s (worst found
 *    8.9e-05 at pose (0.506, 0.0001036), length_rates (0.3067, -0.6861, -0.9998, 0.7742)).
 *  Cost, all branches: 25 add, 39 mul, 6 div, 4 sqrt, 6 compare, 1 select. */
tb_status tb_task_velocity(const real_t pose[2], const real_t rails[1],
    const real_t length_rates[4], const real_t rail_rates[1], real_t velocity[2]);

/** Pose from lengths: closed form, then one Gauss-Newton step on the least-squares misfit
 *    (Yoon eq. 19).
 *  lengths [m] (4), rails [m] (0)  ->  pose [m] (2), residual [m] (scalar)
 *  Domain: lengths in [0, 3.16] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  Error of pose: double at most 5.6e-15 m (worst found 1.4e-15 at lengths (0.2418, 0.5803,
 *    0.484, 0.004913)); float at most 7.1e-06 m (worst found 1.8e-06 at lengths (0.2293,
 *    0.5803, 0.4777, 6.133e-05)).
 *  Error of residual: double at most 1.5e-15 m (worst found 3.7e-16 at lengths (0.2418, 0.5803,
 *    0.484, 0.004913)); float at most 1.9e-06 m (worst found 4.8e-07 at lengths (0.2293,
 *    0.5803, 0.4777, 6.133e-05)).
 *  Cost, all branches: 62 add, 65 mul, 6 div, 9 sqrt, 10 compare, 1 select. */
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
 *  Error of pose: double at most 8.9e-15 m (worst found 2.2e-15 at lengths (0.5038, 0.02267,
 *    0.2806, 0.5803), length_rates (-0.4503, -0.09535, 0.2864, 0.6395)); float at most 6.8e-06
 *    m (worst found 1.7e-06 at lengths (0.5803, 0.2844, 0.01285, 0.5062), length_rates
 *    (-0.8194, 1, -0.1942, -1)).
 *  Error of residual: double at most 1.9e-15 m (worst found 4.7e-16 at lengths (0.506, 0.01755,
 *    0.2841, 0.5803), length_rates (-0.9979, 0.3655, 0.5147, 0.6479)); float at most 1.3e-06 m
 *    (worst found 3.2e-07 at lengths (0.5803, 0.2843, 0.01248, 0.5062), length_rates (-0.8533,
 *    1, -0.2305, -1)).
 *  Error of structure: double at most 2.7e-12 (worst found 6.7e-13 at lengths (0, 0.506,
 *    0.5801, 0.2837), length_rates (-0.4565, 0.4673, 0.8976, -0.8197)); float at most 1.7e-03
 *    (worst found 4.2e-04 at lengths (0.5803, 0.2844, 0.01282, 0.5062), length_rates (-0.8533,
 *    1, -0.199, -1)).
 *  Error of velocity: double at most 1.5e-12 m/s (worst found 3.7e-13 at lengths (0, 0.506,
 *    0.5801, 0.2837), length_rates (-0.478, 0.4673, 1, -0.8187)); float at most 1.3e-03 m/s
 *    (worst found 3.2e-04 at lengths (0.5803, 0.2844, 0.01282, 0.5062), length_rates (-0.8533,
 *    1, -0.2307, -1)).
 *  Cost, all branches: 85 add, 100 mul, 12 div, 9 sqrt, 12 compare, 2 select. */
tb_status tb_locate(const real_t lengths[4], const real_t rails[1],
    const real_t length_rates[4], const real_t rail_rates[1], real_t pose[2],
    real_t residual[1], real_t structure[8], real_t velocity[2]);

#ifdef __cplusplus
}
#endif

#endif
