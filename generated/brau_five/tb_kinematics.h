/* Regenerate: turnbuckle generate machines/brau_five.toml --out <this folder>
 * Machine b614899c8a021831, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_KINEMATICS_H
#define TB_KINEMATICS_H

/* Where the cables are and how they move of brau_five. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Pulley points b_i  (Yoon Fig. 9).
 *  rails [m] (0)  ->  points [m] (5 x 2)
 *  Error of points: double at most 0.0e+00 m; float at most 0.0e+00 m.
 *  Cost, all branches: none. */
tb_status tb_base_points(const real_t rails[1], real_t points[10]);

/** Cable vectors l_i = b_i - c, from the platform to the pulley  (Yoon eq. 1).
 *  pose [m] (2), rails [m] (0)  ->  vectors [m] (5 x 2)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  Error of vectors: double at most 2.2e-16 m (worst found 5.6e-17 at pose (0, 0.3111)); float
 *    at most 1.2e-07 m (worst found 3.0e-08 at pose (0.3118, 0.4233)).
 *  Cost, all branches: 5 add. */
tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[1], real_t vectors[10]);

/** Cable lengths l_i = |b_i - c|  (Yoon eq. 18).
 *  pose [m] (2), rails [m] (0)  ->  length [m] (5)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of length: double at most 8.9e-16 m (worst found 2.2e-16 at pose (0.006569, 0.6322));
 *    float at most 5.6e-07 m (worst found 1.4e-07 at pose (0.4111, 0.145)).
 *  Cost, all branches: 8 add, 5 mul, 5 sqrt, 5 compare. */
tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[1], real_t length[5]);

/** Structure matrix S: column i is the unit vector along cable i, S T = W  (Yoon eq. 7, 21).
 *  pose [m] (2), rails [m] (0)  ->  structure [-] (2 x 5)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of structure: double at most 1.1e-15 (worst found 2.7e-16 at pose (0.7265, 0.9806));
 *    float at most 5.8e-07 (worst found 1.4e-07 at pose (0.6207, 0.939)).
 *  Cost, all branches: 12 add, 15 mul, 5 div, 5 sqrt, 5 compare. */
tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[1], real_t structure[10]);

/** Length Jacobian dl/dx = -S'  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (0)  ->  jacobian [-] (5 x 2)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 1.1e-15 (worst found 2.7e-16 at pose (0.7265, 0.9806));
 *    float at most 5.8e-07 (worst found 1.4e-07 at pose (0.6207, 0.939)).
 *  Cost, all branches: 14 add, 15 mul, 5 div, 5 sqrt, 5 compare. */
tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[1], real_t jacobian[10]);

/** Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot  (Yoon
 *    eq. 6, 20 with normalised rows).
 *  pose [m] (2), rails [m] (0), length_rates [m/s] (5), rail_rates [m/s] (0)  ->  velocity
 *    [m/s] (2)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 500 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of velocity: double at most 2.9e-15 m/s (worst found 7.2e-16 at pose (0.9925,
 *    0.01759), length_rates (-0.8429, -0.9939, 0.03619, 0.7459, -0.5902)); float at most
 *    1.9e-06 m/s (worst found 4.8e-07 at pose (0.9584, 0.08435), length_rates (0.9819, 0.9994,
 *    -0.599, -0.9986, -0.0517)).
 *  Cost, all branches: 32 add, 47 mul, 7 div, 5 sqrt, 7 compare, 1 select. */
tb_status tb_task_velocity(const real_t pose[2], const real_t rails[1],
    const real_t length_rates[5], const real_t rail_rates[1], real_t velocity[2]);

/** Pose from lengths: closed form, then one Gauss-Newton step on the least-squares misfit
 *    (Yoon eq. 19).
 *  lengths [m] (5), rails [m] (0)  ->  pose [m] (2), residual [m] (scalar)
 *  Domain: lengths in [0, 8] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  Error of pose: double at most 2.4e-14 m (worst found 6.1e-15 at lengths (0.03492, 0.8696,
 *    1.414, 0.8715, 0.359)); float at most 3.5e-06 m (worst found 8.8e-07 at lengths (0.8449,
 *    0.1556, 0.8762, 1.414, 1.118)).
 *  Error of residual: double at most 5.4e-15 m (worst found 1.3e-15 at lengths (0.03492,
 *    0.8696, 1.414, 0.8715, 0.359)); float at most 1.6e-06 m (worst found 4.1e-07 at lengths
 *    (0.8449, 0.1556, 0.8762, 1.414, 1.118)).
 *  Cost, all branches: 77 add, 75 mul, 7 div, 11 sqrt, 12 compare, 1 select. */
tb_status tb_forward_kinematics(const real_t lengths[5], const real_t rails[1], real_t pose[2],
    real_t residual[1]);

/** Pose, residual, structure matrix and velocity at once: forward_kinematics, structure_matrix
 *    and task_velocity without their common work  (Yoon eq. 19, 21, 20 with normalised rows).
 *  lengths [m] (5), rails [m] (0), length_rates [m/s] (5), rail_rates [m/s] (0)  ->  pose [m]
 *    (2), residual [m] (scalar), structure [-] (2 x 5), velocity [m/s] (2)
 *  Domain: lengths in [0, 8] m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 500 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of pose: double at most 3.3e-14 m; float at most 1.4e-05 m.
 *  Error of residual: double at most 1.1e-14 m; float at most 3.3e-06 m.
 *  Error of structure: double at most 2.8e-12; float at most 8.1e-03.
 *  Error of velocity: double at most 1.1e-12 m/s; float at most 8.8e-04 m/s.
 *  Cost, all branches: 105 add, 117 mul, 14 div, 11 sqrt, 14 compare, 2 select. */
tb_status tb_locate(const real_t lengths[5], const real_t rails[1],
    const real_t length_rates[5], const real_t rail_rates[1], real_t pose[2],
    real_t residual[1], real_t structure[10], real_t velocity[2]);

#ifdef __cplusplus
}
#endif

#endif
