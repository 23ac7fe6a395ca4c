/* Regenerate: turnbuckle generate machines/yoon_synchronised.toml --out <this folder>
 * Machine 2674137f8fc00ebb, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_KINEMATICS_H
#define TB_KINEMATICS_H

/* Where the cables are and how they move of yoon_synchronised. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Pulley points b_i  (Yoon Fig. 9).
 *  rails [m] (2)  ->  points [m] (4 x 2)
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Error of points: double at most 0.0e+00 m; float at most 8.3e-08 m (worst found 2.1e-08 at
 *    rails (0.5291, 0.1342)).
 *  Cost, all branches: none. */
tb_status tb_base_points(const real_t rails[2], real_t points[8]);

/** Cable vectors l_i = b_i - c, from the platform to the pulley  (Yoon eq. 1).
 *  pose [m] (2), rails [m] (2)  ->  vectors [m] (4 x 2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Error of vectors: double at most 2.2e-16 m (worst found 5.6e-17 at pose (0.1026, 0.4381),
 *    rails (0.1026, 0.4381)); float at most 2.0e-07 m (worst found 5.1e-08 at pose (0.202,
 *    0.1451), rails (0.202, 0.1451)).
 *  Cost, all branches: 6 add. */
tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[2], real_t vectors[8]);

/** Cable lengths l_i = |b_i - c|  (Yoon eq. 18).
 *  pose [m] (2), rails [m] (2)  ->  length [m] (4)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of length: double at most 6.2e-16 m (worst found 1.5e-16 at pose (0.7118, 0.1613),
 *    rails (0.003916, 0.05252)); float at most 4.0e-07 m (worst found 9.9e-08 at pose (0.1761,
 *    0.3839), rails (0.6808, 0.2487)).
 *  Cost, all branches: 8 add, 6 mul, 4 sqrt, 4 compare. */
tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[2], real_t length[4]);

/** Structure matrix S: column i is the unit vector along cable i, S T = W  (Yoon eq. 7, 21).
 *  pose [m] (2), rails [m] (2)  ->  structure [-] (2 x 4)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of structure: double at most 1.0e-15 (worst found 2.6e-16 at pose (0.6744, 0), rails
 *    (0.3503, 0.3776)); float at most 8.1e-04 (worst found 2.0e-04 at pose (0.7118, 0.3857),
 *    rails (0.6433, 0.3858)).
 *  Cost, all branches: 10 add, 14 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[2], real_t structure[8]);

/** Length Jacobian dl/dx = -S'  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (2)  ->  jacobian [-] (4 x 2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 1.0e-15 (worst found 2.6e-16 at pose (0.6744, 0), rails
 *    (0.3503, 0.3776)); float at most 8.1e-04 (worst found 2.0e-04 at pose (0.7118, 0.3857),
 *    rails (0.6433, 0.3858)).
 *  Cost, all branches: 14 add, 14 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[2], real_t jacobian[8]);

/** Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot  (Yoon
 *    eq. 6, 20 with normalised rows).
 *  pose [m] (2), rails [m] (2), length_rates [m/s] (4), rail_rates [m/s] (2)  ->  velocity
 *    [m/s] (2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  Domain: rail_rates with a sum of magnitudes of at most 200 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of velocity: double at most 6.9e-15 m/s; float at most 7.5e-04 m/s.
 *  Cost, all branches: 31 add, 45 mul, 6 div, 4 sqrt, 6 compare, 1 select. */
tb_status tb_task_velocity(const real_t pose[2], const real_t rails[2],
    const real_t length_rates[4], const real_t rail_rates[2], real_t velocity[2]);

/** Pose from lengths: closed form, then one Gauss-Newton step on the least-squares misfit
 *    (Yoon eq. 19).
 *  lengths [m] (4), rails [m] (2)  ->  pose [m] (2), residual [m] (scalar)
 *  Domain: lengths in [0, 4.6944] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  Error of pose: double at most 3.4e-14 m (worst found 8.5e-15 at lengths (0.7106, 0.6762,
 *    0.745, 0.203), rails (0.5867, 0.1004)); float at most 1.2e-05 m (worst found 3.0e-06 at
 *    lengths (0.6573, 0.7418, 0.4839, 0.2041), rails (0.4818, 0.4206)).
 *  Error of residual: double at most 2.3e-14 m (worst found 5.7e-15 at lengths (0.7122, 0.6769,
 *    0.7461, 0.2052), rails (0.5862, 0.09982)); float at most 6.3e-06 m (worst found 1.6e-06 at
 *    lengths (0.6573, 0.7419, 0.4849, 0.2016), rails (0.4832, 0.4206)).
 *  Cost, all branches: 90 add, 86 mul, 8 div, 9 sqrt, 10 compare, 1 select. */
tb_status tb_forward_kinematics(const real_t lengths[4], const real_t rails[2], real_t pose[2],
    real_t residual[1]);

/** Pose, residual, structure matrix and velocity at once: forward_kinematics, structure_matrix
 *    and task_velocity without their common work  (Yoon eq. 19, 21, 20 with normalised rows).
 *  lengths [m] (4), rails [m] (2), length_rates [m/s] (4), rail_rates [m/s] (2)  ->  pose [m]
 *    (2), residual [m] (scalar), structure [-] (2 x 4), velocity [m/s] (2)
 *  Domain: lengths in [0, 4.6944] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  Domain: rail_rates with a sum of magnitudes of at most 200 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of pose: double at most 2.6e-14 m; float at most 8.8e-06 m.
 *  Error of residual: double at most 3.9e-15 m; float at most 2.5e-06 m.
 *  Error of structure: double at most 1.8e-12; float at most 1.6e-03.
 *  Error of velocity: double at most 2.6e-12 m/s; float at most 1.6e-03 m/s.
 *  Cost, all branches: 115 add, 125 mul, 14 div, 9 sqrt, 12 compare, 2 select. */
tb_status tb_locate(const real_t lengths[4], const real_t rails[2],
    const real_t length_rates[4], const real_t rail_rates[2], real_t pose[2],
    real_t residual[1], real_t structure[8], real_t velocity[2]);

/** Rail Jacobian dl/ds  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (2)  ->  jacobian [-] (4 x 2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 9.2e-16 (worst found 2.3e-16 at pose (0.4585, 0.4197),
 *    rails (0.7108, 0.4617)); float at most 1.3e-04 (worst found 3.2e-05 at pose (0.3697,
 *    0.4617), rails (0.3696, 0.01501)).
 *  Cost, all branches: 8 add, 6 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_rail_jacobian(const real_t pose[2], const real_t rails[2], real_t jacobian[8]);

#ifdef __cplusplus
}
#endif

#endif
