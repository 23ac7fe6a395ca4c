/* Regenerate: turnbuckle generate machines/brau_triangle.toml --out <this folder>
 * Machine 62d2624dcb098eaa, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_KINEMATICS_H
#define TB_KINEMATICS_H

/* Where the cables are and how they move of brau_triangle. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Pulley points b_i  (Yoon Fig. 9).
 *  rails [m] (0)  ->  points [m] (3 x 2)
 *  Error of points: double at most 0.0e+00 m; float at most 6.2e-08 m.
 *  Cost, all branches: none. */
tb_status tb_base_points(const real_t rails[1], real_t points[6]);

/** Cable vectors l_i = b_i - c, from the platform to the pulley  (Yoon eq. 1).
 *  pose [m] (2), rails [m] (0)  ->  vectors [m] (3 x 2)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  Error of vectors: double at most 2.2e-16 m (worst found 5.6e-17 at pose (0.134, 0.3491));
 *    float at most 1.8e-07 m (worst found 4.5e-08 at pose (0.2035, 0.2272)).
 *  Cost, all branches: 5 add. */
tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[1], real_t vectors[6]);

/** Cable lengths l_i = |b_i - c|  (Yoon eq. 18).
 *  pose [m] (2), rails [m] (0)  ->  length [m] (3)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of length: double at most 9.3e-16 m (worst found 2.3e-16 at pose (0.04331, 0.4049));
 *    float at most 5.0e-07 m (worst found 1.2e-07 at pose (0.1853, 0.716)).
 *  Cost, all branches: 6 add, 5 mul, 3 sqrt, 3 compare. */
tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[1], real_t length[3]);

/** Structure matrix S: column i is the unit vector along cable i, S T = W  (Yoon eq. 7, 21).
 *  pose [m] (2), rails [m] (0)  ->  structure [-] (2 x 3)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of structure: double at most 1.0e-15 (worst found 2.6e-16 at pose (0.5861, 0.01687));
 *    float at most 5.7e-04 (worst found 1.4e-04 at pose (0.4999, 0.866)).
 *  Cost, all branches: 9 add, 11 mul, 3 div, 3 sqrt, 3 compare. */
tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[1], real_t structure[6]);

/** Length Jacobian dl/dx = -S'  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (0)  ->  jacobian [-] (3 x 2)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 1.0e-15 (worst found 2.6e-16 at pose (0.5861, 0.01687));
 *    float at most 5.7e-04 (worst found 1.4e-04 at pose (0.4999, 0.866)).
 *  Cost, all branches: 9 add, 11 mul, 3 div, 3 sqrt, 3 compare. */
tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[1], real_t jacobian[6]);

/** Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot  (Yoon
 *    eq. 6, 20 with normalised rows).
 *  pose [m] (2), rails [m] (0), length_rates [m/s] (3), rail_rates [m/s] (0)  ->  velocity
 *    [m/s] (2)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 300 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of velocity: double at most 3.0e-15 m/s (worst found 7.6e-16 at pose (0.06912,
 *    0.07792), length_rates (0.4221, -0.9943, 0.9136)); float at most 2.5e-04 m/s (worst found
 *    6.2e-05 at pose (0.4999, 0.866), length_rates (-0.07688, 0.9856, -0.9907)).
 *  Cost, all branches: 20 add, 33 mul, 5 div, 3 sqrt, 5 compare, 1 select. */
tb_status tb_task_velocity(const real_t pose[2], const real_t rails[1],
    const real_t length_rates[3], const real_t rail_rates[1], real_t velocity[2]);

/** Pose from lengths: closed form, then one Gauss-Newton step on the least-squares misfit
 *    (Yoon eq. 19).
 *  lengths [m] (3), rails [m] (0)  ->  pose [m] (2), residual [m] (scalar)
 *  Domain: lengths in [0, 7.4641] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  Error of pose: double at most 2.1e-14 m (worst found 5.2e-15 at lengths (1.031, 1.033,
 *    0.2772)); float at most 1.6e-06 m (worst found 4.0e-07 at lengths (1.058, 1.046, 0.3576)).
 *  Error of residual: double at most 9.4e-15 m (worst found 2.3e-15 at lengths (1.031, 1.033,
 *    0.2772)); float at most 9.6e-07 m (worst found 2.4e-07 at lengths (1.058, 1.046, 0.3576)).
 *  Cost, all branches: 47 add, 50 mul, 5 div, 7 sqrt, 7 compare, 1 select. */
tb_status tb_forward_kinematics(const real_t lengths[3], const real_t rails[1], real_t pose[2],
    real_t residual[1]);

/** Pose, residual, structure matrix and velocity at once: forward_kinematics, structure_matrix
 *    and task_velocity without their common work  (Yoon eq. 19, 21, 20 with normalised rows).
 *  lengths [m] (3), rails [m] (0), length_rates [m/s] (3), rail_rates [m/s] (0)  ->  pose [m]
 *    (2), residual [m] (scalar), structure [-] (2 x 3), velocity [m/s] (2)
 *  Domain: lengths in [0, 7.4641] m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 300 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of pose: double at most 3.0e-14 m (worst found 7.4e-15 at lengths (0.01438, 1, 1),
 *    length_rates (0.6873, -0.4938, -1)); float at most 1.1e-05 m (worst found 2.8e-06 at
 *    lengths (0.01488, 1, 1), length_rates (-0.9853, -0.3597, -0.6454)).
 *  Error of residual: double at most 5.4e-15 m (worst found 1.3e-15 at lengths (0.02828,
 *    0.9999, 1), length_rates (-0.6684, -0.7129, -0.2188)); float at most 3.4e-06 m (worst
 *    found 8.5e-07 at lengths (1, 0.04057, 1), length_rates (0.9988, -0.5996, 0.3752)).
 *  Error of structure: double at most 5.1e-12 (worst found 1.3e-12 at lengths (0.01438, 1, 1),
 *    length_rates (0.6873, -0.4938, -1)); float at most 3.2e-03 (worst found 8.0e-04 at lengths
 *    (1, 1, 0), length_rates (0.02474, 0.7042, -1)).
 *  Error of velocity: double at most 3.5e-12 m/s (worst found 8.7e-13 at lengths (0, 1, 1),
 *    length_rates (0.7764, -0.9997, -0.1065)); float at most 5.4e-03 m/s (worst found 1.3e-03
 *    at lengths (1, 1, 0), length_rates (0.02474, 0.7042, -1)).
 *  Cost, all branches: 64 add, 78 mul, 10 div, 7 sqrt, 9 compare, 2 select. */
tb_status tb_locate(const real_t lengths[3], const real_t rails[1],
    const real_t length_rates[3], const real_t rail_rates[1], real_t pose[2],
    real_t residual[1], real_t structure[6], real_t velocity[2]);

#ifdef __cplusplus
}
#endif

#endif
