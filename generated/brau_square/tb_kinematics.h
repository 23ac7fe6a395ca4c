/* Regenerate: turnbuckle generate machines/brau_square.toml --out <this folder>
 * Machine 166f8b7fcb339437, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_KINEMATICS_H
#define TB_KINEMATICS_H

/* Where the cables are and how they move of brau_square. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Pulley points b_i  (Yoon Fig. 9).
 *  rails [m] (0)  ->  points [m] (4 x 2)
 *  Error of points: double at most 0.0e+00 m; float at most 0.0e+00 m.
 *  Cost, all branches: none. */
tb_status tb_base_points(const real_t rails[1], real_t points[8]);

/** Cable vectors l_i = b_i - c, from the platform to the pulley  (Yoon eq. 1).
 *  pose [m] (2), rails [m] (0)  ->  vectors [m] (4 x 2)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  Error of vectors: double at most 2.2e-16 m (worst found 5.6e-17 at pose (0, 0.3111)); float
 *    at most 1.2e-07 m (worst found 3.0e-08 at pose (0.3118, 0.4233)).
 *  Cost, all branches: 4 add. */
tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[1], real_t vectors[8]);

/** Cable lengths l_i = |b_i - c|  (Yoon eq. 18).
 *  pose [m] (2), rails [m] (0)  ->  length [m] (4)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of length: double at most 9.1e-16 m (worst found 2.3e-16 at pose (0.2675, 0.2637));
 *    float at most 5.6e-07 m (worst found 1.4e-07 at pose (0.4111, 0.145)).
 *  Cost, all branches: 6 add, 4 mul, 4 sqrt, 4 compare. */
tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[1], real_t length[4]);

/** Structure matrix S: column i is the unit vector along cable i, S T = W  (Yoon eq. 7, 21).
 *  pose [m] (2), rails [m] (0)  ->  structure [-] (2 x 4)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of structure: double at most 1.1e-15 (worst found 2.7e-16 at pose (0.7265, 0.9806));
 *    float at most 5.7e-07 (worst found 1.4e-07 at pose (0.0814, 0.2926)).
 *  Cost, all branches: 10 add, 12 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[1], real_t structure[8]);

/** Length Jacobian dl/dx = -S'  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (0)  ->  jacobian [-] (4 x 2)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 1.1e-15 (worst found 2.7e-16 at pose (0.7265, 0.9806));
 *    float at most 5.7e-07 (worst found 1.4e-07 at pose (0.0814, 0.2926)).
 *  Cost, all branches: 10 add, 12 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[1], real_t jacobian[8]);

/** Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot  (Yoon
 *    eq. 6, 20 with normalised rows).
 *  pose [m] (2), rails [m] (0), length_rates [m/s] (4), rail_rates [m/s] (0)  ->  velocity
 *    [m/s] (2)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of velocity: double at most 3.0e-15 m/s (worst found 7.6e-16 at pose (0.6208, 0.4997),
 *    length_rates (0.7608, 1, -1, -0.9812)); float at most 1.4e-06 m/s (worst found 3.6e-07 at
 *    pose (0.056, 0.1272), length_rates (0.5665, -0.9525, -1, 0.3706)).
 *  Cost, all branches: 25 add, 39 mul, 6 div, 4 sqrt, 6 compare, 1 select. */
tb_status tb_task_velocity(const real_t pose[2], const real_t rails[1],
    const real_t length_rates[4], const real_t rail_rates[1], real_t velocity[2]);

/** Pose from lengths: closed form, then one Gauss-Newton step on the least-squares misfit
 *    (Yoon eq. 19).
 *  lengths [m] (4), rails [m] (0)  ->  pose [m] (2), residual [m] (scalar)
 *  Domain: lengths in [0, 8] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  Error of pose: double at most 3.0e-15 m (worst found 7.5e-16 at lengths (0.9111, 1.414,
 *    0.9061, 0.08599)); float at most 1.7e-05 m (worst found 4.2e-06 at lengths (0.8563,
 *    0.01759, 0.855, 1.414)).
 *  Error of residual: double at most 1.4e-15 m (worst found 3.5e-16 at lengths (0.515, 1.009,
 *    1.009, 0.515)); float at most 1.7e-06 m (worst found 4.2e-07 at lengths (0.8521, 0.03354,
 *    0.8519, 1.414)).
 *  Cost, all branches: 62 add, 60 mul, 6 div, 9 sqrt, 9 compare, 1 select. */
tb_status tb_forward_kinematics(const real_t lengths[4], const real_t rails[1], real_t pose[2],
    real_t residual[1]);

/** Pose, residual, structure matrix and velocity at once: forward_kinematics, structure_matrix
 *    and task_velocity without their common work  (Yoon eq. 19, 21, 20 with normalised rows).
 *  lengths [m] (4), rails [m] (0), length_rates [m/s] (4), rail_rates [m/s] (0)  ->  pose [m]
 *    (2), residual [m] (scalar), structure [-] (2 x 4), velocity [m/s] (2)
 *  Domain: lengths in [0, 8] m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of pose: double at most 2.3e-14 m (worst found 5.8e-15 at lengths (0.7976, 0.04714,
 *    0.795, 1.414), length_rates (-0.9748, 0.1147, 0.08045, -0.5321)); float at most 1.6e-05 m
 *    (worst found 3.9e-06 at lengths (1.414, 0.9303, 0.004505, 0.93), length_rates (-0.8654,
 *    -0.9058, -0.3793, -0.0183)).
 *  Error of residual: double at most 4.7e-15 m (worst found 1.2e-15 at lengths (1, 1.414, 1,
 *    0.01537), length_rates (-0.02117, -0.541, 0.8906, -0.992)); float at most 2.2e-06 m (worst
 *    found 5.5e-07 at lengths (1.039, 1.414, 1.038, 0.01624), length_rates (-0.5406, -0.4612,
 *    -0.9954, 1)).
 *  Error of structure: double at most 3.6e-12 (worst found 9.0e-13 at lengths (0.9996, 0, 1,
 *    1.414), length_rates (0.7641, 0.7973, 0.4052, 0.8359)); float at most 1.6e-03 (worst found
 *    4.0e-04 at lengths (1, 0.01729, 1, 1.414), length_rates (-0.1954, -0.4985, 1, -0.6662)).
 *  Error of velocity: double at most 2.0e-12 m/s (worst found 5.1e-13 at lengths (0.9996,
 *    1.414, 1, 0), length_rates (-0.04723, -0.6097, 0.769, -0.9882)); float at most 6.1e-04 m/s
 *    (worst found 1.5e-04 at lengths (0.9995, 1.414, 1, 0.0001251), length_rates (-0.4397,
 *    -0.5525, 0.8911, -0.6911)).
 *  Cost, all branches: 85 add, 95 mul, 12 div, 9 sqrt, 11 compare, 2 select. */
tb_status tb_locate(const real_t lengths[4], const real_t rails[1],
    const real_t length_rates[4], const real_t rail_rates[1], real_t pose[2],
    real_t residual[1], real_t structure[8], real_t velocity[2]);

#ifdef __cplusplus
}
#endif

#endif
