/* Regenerate: turnbuckle generate machines/yoon2023.toml --out <this folder>
 * Machine 499338192b9e5092, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_KINEMATICS_H
#define TB_KINEMATICS_H

/* Where the cables are and how they move of yoon2023. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Pulley points b_i  (Yoon Fig. 9).
 *  rails [m] (4)  ->  points [m] (4 x 2)
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  Error of points: double at most 0.0e+00 m; float at most 8.3e-08 m (worst found 2.1e-08 at
 *    rails (0.5291, 0.1342, 0.3559, 0.2604)).
 *  Cost, all branches: none. */
tb_status tb_base_points(const real_t rails[4], real_t points[8]);

/** Cable vectors l_i = b_i - c, from the platform to the pulley  (Yoon eq. 1).
 *  pose [m] (2), rails [m] (4)  ->  vectors [m] (4 x 2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  Error of vectors: double at most 2.2e-16 m (worst found 5.6e-17 at pose (0.1026, 0.4381),
 *    rails (0.0497, 0.2875, 0.4348, 0.3425)); float at most 2.0e-07 m (worst found 5.1e-08 at
 *    pose (0.202, 0.1451), rails (0.7118, 0.2116, 0.3526, 0.04854)).
 *  Cost, all branches: 8 add. */
tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[4], real_t vectors[8]);

/** Cable lengths l_i = |b_i - c|  (Yoon eq. 18).
 *  pose [m] (2), rails [m] (4)  ->  length [m] (4)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of length: double at most 6.7e-16 m (worst found 1.7e-16 at pose (0.002952, 0.221),
 *    rails (0.2131, 0.2687, 0.2257, 0.2527)); float at most 3.9e-07 m (worst found 9.7e-08 at
 *    pose (0.1536, 0.3883), rails (0.3363, 0.4365, 0.1118, 0.2309)).
 *  Cost, all branches: 10 add, 8 mul, 4 sqrt, 4 compare. */
tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[4], real_t length[4]);

/** Structure matrix S: column i is the unit vector along cable i, S T = W  (Yoon eq. 7, 21).
 *  pose [m] (2), rails [m] (4)  ->  structure [-] (2 x 4)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of structure: double at most 1.1e-15 (worst found 2.7e-16 at pose (0.2493, 0.1298),
 *    rails (0.2308, 0.1344, 0.2369, 0.2284)); float at most 8.1e-04 (worst found 2.0e-04 at
 *    pose (0.7118, 0.2625), rails (0.6377, 0.2626, 0.7118, 0.03664)).
 *  Cost, all branches: 12 add, 16 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[4], real_t structure[8]);

/** Length Jacobian dl/dx = -S'  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (4)  ->  jacobian [-] (4 x 2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 1.1e-15 (worst found 2.7e-16 at pose (0.2493, 0.1298),
 *    rails (0.2308, 0.1344, 0.2369, 0.2284)); float at most 8.1e-04 (worst found 2.0e-04 at
 *    pose (0.7118, 0.2625), rails (0.6377, 0.2626, 0.7118, 0.03664)).
 *  Cost, all branches: 16 add, 16 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[4], real_t jacobian[8]);

/** Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot  (Yoon
 *    eq. 6, 20 with normalised rows).
 *  pose [m] (2), rails [m] (4), length_rates [m/s] (4), rail_rates [m/s] (4)  ->  velocity
 *    [m/s] (2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  Domain: rail_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of velocity: double at most 4.3e-12 m/s; float at most 8.9e-03 m/s.
 *  Cost, all branches: 33 add, 47 mul, 6 div, 4 sqrt, 6 compare, 1 select. */
tb_status tb_task_velocity(const real_t pose[2], const real_t rails[4],
    const real_t length_rates[4], const real_t rail_rates[4], real_t velocity[2]);

/** Pose from lengths: closed form, then one Gauss-Newton step on the least-squares misfit
 *    (Yoon eq. 19).
 *  lengths [m] (4), rails [m] (4)  ->  pose [m] (2), residual [m] (scalar)
 *  Domain: lengths in [0, 4.6944] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  Error of pose: double at most 1.0e-12 m (worst found 2.6e-13 at lengths (0.6467, 0.3622,
 *    0.2061, 0.7392), rails (0, 0.4309, 0.6618, 0.0333)); float at most 9.1e-05 m (worst found
 *    2.3e-05 at lengths (0.3258, 0.6016, 0.6435, 0.4339), rails (0.08481, 0.3276, 0.7118,
 *    0.00682)).
 *  Error of residual: double at most 1.2e-12 m (worst found 3.0e-13 at lengths (0.6471, 0.3635,
 *    0.2061, 0.7389), rails (0, 0.4309, 0.6618, 0.03311)); float at most 6.5e-05 m (worst found
 *    1.6e-05 at lengths (0.3575, 0.5775, 0.6271, 0.2921), rails (0.01173, 0.3927, 0.7118,
 *    0.04809)).
 *  Cost, all branches: 96 add, 92 mul, 8 div, 9 sqrt, 10 compare, 1 select. */
tb_status tb_forward_kinematics(const real_t lengths[4], const real_t rails[4], real_t pose[2],
    real_t residual[1]);

/** Pose, residual, structure matrix and velocity at once: forward_kinematics, structure_matrix
 *    and task_velocity without their common work  (Yoon eq. 19, 21, 20 with normalised rows).
 *  lengths [m] (4), rails [m] (4), length_rates [m/s] (4), rail_rates [m/s] (4)  ->  pose [m]
 *    (2), residual [m] (scalar), structure [-] (2 x 4), velocity [m/s] (2)
 *  Domain: lengths in [0, 4.6944] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  Domain: rail_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of pose: double at most 3.7e-10 m; float at most 4.2e-04 m.
 *  Error of residual: double at most 8.9e-10 m; float at most 6.5e-04 m.
 *  Error of structure: double at most 4.8e-11; float at most 2.1e-03.
 *  Error of velocity: double at most 6.8e-07 m/s; float at most 4.1e-02 m/s.
 *  Cost, all branches: 121 add, 131 mul, 14 div, 9 sqrt, 12 compare, 2 select. */
tb_status tb_locate(const real_t lengths[4], const real_t rails[4],
    const real_t length_rates[4], const real_t rail_rates[4], real_t pose[2],
    real_t residual[1], real_t structure[8], real_t velocity[2]);

/** Rail Jacobian dl/ds  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (4)  ->  jacobian [-] (4 x 4)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double at most 8.9e-16 (worst found 2.2e-16 at pose (0.7118, 0.4225),
 *    rails (0.102, 0.1827, 0.1583, 0)); float at most 4.2e-05 (worst found 1.0e-05 at pose
 *    (0.7111, 0.1959), rails (0.253, 0.1952, 0.7103, 0.2306)).
 *  Cost, all branches: 10 add, 8 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_rail_jacobian(const real_t pose[2], const real_t rails[4], real_t jacobian[16]);

#ifdef __cplusplus
}
#endif

#endif
