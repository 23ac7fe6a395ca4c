/* Regenerate: turnbuckle generate machines/three_base_equilateral.toml --out <this folder>
 * Machine bf852767ce09ae7f, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_KINEMATICS_H
#define TB_KINEMATICS_H

/* Where the cables are and how they move of three_base_equilateral. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Pulley points b_i  (Yoon Fig. 9).
 *  rails [m] (6)  ->  points [m] (3 x 2)
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  Error of points: double at most 2.2e-16 m (worst found 5.6e-17 at rails (0.2932, 0.04123,
 *    0.2854, 0.04216, 0.6372, 0.025)); float at most 2.0e-07 m (worst found 5.1e-08 at rails
 *    (0.2479, 0.05, 0.03952, 0.0106, 0.1563, 0.03839)).
 *  Cost, all branches: 2 add. */
tb_status tb_base_points(const real_t rails[6], real_t points[6]);

/** Cable vectors l_i = b_i - c, from the platform to the pulley  (Yoon eq. 1).
 *  pose [m] (2), rails [m] (6)  ->  vectors [m] (3 x 2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  Error of vectors: double at most 4.4e-16 m (worst found 1.1e-16 at pose (0.263, 0.09263),
 *    rails (0.3559, 0.025, 0, 0.04847, 0.6545, 0.025)); float at most 3.2e-07 m (worst found
 *    8.0e-08 at pose (0.1537, 0.4307), rails (0.6416, 0.01456, 0.1458, 0.04449, 0.5717,
 *    0.02382)).
 *  Cost, all branches: 8 add. */
tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[6], real_t vectors[6]);

/** Cable lengths l_i = |b_i - c|  (Yoon eq. 18).
 *  pose [m] (2), rails [m] (6)  ->  length [m] (3)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of length: double at most 7.7e-16 m (worst found 1.9e-16 at pose (0.6663, 0.1975),
 *    rails (0.05702, 0.01143, 0.1847, 0.03667, 0.04879, 0.007059)); float at most 4.9e-07 m
 *    (worst found 1.2e-07 at pose (0.1748, 0.3274), rails (0.1842, 0.01759, 0.4426, 0.04361,
 *    0.2723, 0.03176)).
 *  Cost, all branches: 11 add, 6 mul, 3 sqrt, 3 compare. */
tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[6], real_t length[3]);

/** Structure matrix S: column i is the unit vector along cable i, S T = W  (Yoon eq. 7, 21).
 *  pose [m] (2), rails [m] (6)  ->  structure [-] (2 x 3)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of structure: double at most 9.0e-13 (worst found 2.3e-13 at pose (0.6661, 0.5269),
 *    rails (0.333, 0.004328, 0.2712, 0.01568, 0.5271, 0.0457)); float at most 1.3e-03 (worst
 *    found 3.4e-04 at pose (0.7118, 0.5682), rails (0.7013, 0.002779, 0.1703, 0, 0.5683,
 *    3.806e-05)).
 *  Cost, all branches: 11 add, 12 mul, 3 div, 3 sqrt, 3 compare. */
tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[6], real_t structure[6]);

/** Length Jacobian dl/dx = -S'  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (6)  ->  jacobian [-] (3 x 2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 9.0e-13 (worst found 2.3e-13 at pose (0.6661, 0.5269),
 *    rails (0.333, 0.004328, 0.2712, 0.01568, 0.5271, 0.0457)); float at most 1.3e-03 (worst
 *    found 3.4e-04 at pose (0.7118, 0.5682), rails (0.7013, 0.002779, 0.1703, 0, 0.5683,
 *    3.806e-05)).
 *  Cost, all branches: 17 add, 12 mul, 3 div, 3 sqrt, 3 compare. */
tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[6], real_t jacobian[6]);

/** Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot  (Yoon
 *    eq. 6, 20 with normalised rows).
 *  pose [m] (2), rails [m] (6), length_rates [m/s] (3), rail_rates [m/s] (6)  ->  velocity
 *    [m/s] (2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 300 m/s, else TB_OUT_OF_DOMAIN.
 *  Domain: rail_rates with a sum of magnitudes of at most 600 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of velocity: double at most 9.7e-07 m/s; float at most 1.6e-01 m/s.
 *  Cost, all branches: 31 add, 40 mul, 5 div, 3 sqrt, 5 compare, 1 select. */
tb_status tb_task_velocity(const real_t pose[2], const real_t rails[6],
    const real_t length_rates[3], const real_t rail_rates[6], real_t velocity[2]);

/** Pose from lengths: closed form, then one Gauss-Newton step on the least-squares misfit
 *    (Yoon eq. 19).
 *  lengths [m] (3), rails [m] (6)  ->  pose [m] (2), residual [m] (scalar)
 *  Domain: lengths in [0, 5.6944] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  Error of pose: double at most 3.7e-06 m; float at most 3.0e+00 m.
 *  Error of residual: double at most 7.1e-06 m; float at most 6.3e+00 m.
 *  Cost, all branches: 79 add, 74 mul, 7 div, 7 sqrt, 8 compare, 1 select. */
tb_status tb_forward_kinematics(const real_t lengths[3], const real_t rails[6], real_t pose[2],
    real_t residual[1]);

/** Pose, residual, structure matrix and velocity at once: forward_kinematics, structure_matrix
 *    and task_velocity without their common work  (Yoon eq. 19, 21, 20 with normalised rows).
 *  lengths [m] (3), rails [m] (6), length_rates [m/s] (3), rail_rates [m/s] (6)  ->  pose [m]
 *    (2), residual [m] (scalar), structure [-] (2 x 3), velocity [m/s] (2)
 *  Domain: lengths in [0, 5.6944] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 300 m/s, else TB_OUT_OF_DOMAIN.
 *  Domain: rail_rates with a sum of magnitudes of at most 600 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of pose: double at most 3.0e-08 m; float at most 2.6e-01 m.
 *  Error of residual: double at most 6.4e-08 m; float at most 3.9e-01 m.
 *  Error of structure: double at most 9.2e-10; float at most 4.8e+00.
 *  Error of velocity: double at most 3.3e-06 m/s; float at most 6.6e+00 m/s.
 *  Cost, all branches: 99 add, 108 mul, 12 div, 7 sqrt, 10 compare, 2 select. */
tb_status tb_locate(const real_t lengths[3], const real_t rails[6],
    const real_t length_rates[3], const real_t rail_rates[6], real_t pose[2],
    real_t residual[1], real_t structure[6], real_t velocity[2]);

/** Rail Jacobian dl/ds  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (6)  ->  jacobian [-] (3 x 6)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 9.0e-13 (worst found 2.3e-13 at pose (0.6661, 0.5269),
 *    rails (0.333, 0.004328, 0.2712, 0.01568, 0.5271, 0.0457)); float at most 1.3e-03 (worst
 *    found 3.4e-04 at pose (0.7118, 0.5682), rails (0.7013, 0.002779, 0.1703, 0, 0.5683,
 *    3.806e-05)).
 *  Cost, all branches: 13 add, 12 mul, 3 div, 3 sqrt, 3 compare. */
tb_status tb_rail_jacobian(const real_t pose[2], const real_t rails[6], real_t jacobian[18]);

#ifdef __cplusplus
}
#endif

#endif
