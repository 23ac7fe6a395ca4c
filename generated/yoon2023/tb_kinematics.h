/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine c2e26558649395a1, generator 0.1.0, casadi 3.8.2. Do not edit. */
#ifndef TB_KINEMATICS_H
#define TB_KINEMATICS_H

/* Where the cables are and how they move of yoon2023. */

#include "tb_types.h"

/** Pulley points b_i  (Yoon Fig. 9).
 *  rails [m] (4)  ->  points [m] (4 x 2)
 *  Domain: rails in [-0.7118, 1.4236] x [-0.4618, 0.9236] x [-0.7118, 1.4236] x [-0.4618,
 *    0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Error of points: double <= 0.0e+00 m (worst found 0.0e+00); float <= 4.2e-08 m (worst found
 *    2.1e-08).
 *  Cost, all branches: none. */
tb_status tb_base_points(const real_t rails[4], real_t points[8]);

/** Cable vectors l_i = b_i - c, from the platform to the pulley  (Yoon eq. 1).
 *  pose [m] (2), rails [m] (4)  ->  vectors [m] (4 x 2)
 *  Domain: pose in [-0.7118, 1.4236] x [-0.4618, 0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails in [-0.7118, 1.4236] x [-0.4618, 0.9236] x [-0.7118, 1.4236] x [-0.4618,
 *    0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Error of vectors: double <= 1.1e-16 m (worst found 5.6e-17); float <= 1.0e-07 m (worst found
 *    5.1e-08).
 *  Cost, all branches: 8 add. */
tb_status tb_cable_vectors(const real_t pose[2], const real_t rails[4], real_t vectors[8]);

/** Cable lengths l_i = |b_i - c|  (Yoon eq. 18).
 *  pose [m] (2), rails [m] (4)  ->  length [m] (4)
 *  Domain: pose in [-0.7118, 1.4236] x [-0.4618, 0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails in [-0.7118, 1.4236] x [-0.4618, 0.9236] x [-0.7118, 1.4236] x [-0.4618,
 *    0.9236] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of length: double <= 3.3e-16 m (worst found 1.7e-16); float <= 1.9e-07 m (worst found
 *    9.7e-08).
 *  Cost, all branches: 10 add, 8 mul, 4 sqrt, 4 compare. */
tb_status tb_cable_lengths(const real_t pose[2], const real_t rails[4], real_t length[4]);

/** Structure matrix S: column i is the unit vector along cable i, S T = W  (Yoon eq. 7, 21).
 *  pose [m] (2), rails [m] (4)  ->  structure [1] (2 x 4)
 *  Domain: pose in [-0.7118, 1.4236] x [-0.4618, 0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails in [-0.7118, 1.4236] x [-0.4618, 0.9236] x [-0.7118, 1.4236] x [-0.4618,
 *    0.9236] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of structure: double <= 5.4e-16 1 (worst found 2.7e-16); float <= 4.1e-04 1 (worst
 *    found 2.0e-04).
 *  Cost, all branches: 12 add, 16 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_structure_matrix(const real_t pose[2], const real_t rails[4], real_t structure[8]);

/** Length Jacobian dl/dx = -S'  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (4)  ->  jacobian [1] (4 x 2)
 *  Domain: pose in [-0.7118, 1.4236] x [-0.4618, 0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails in [-0.7118, 1.4236] x [-0.4618, 0.9236] x [-0.7118, 1.4236] x [-0.4618,
 *    0.9236] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double <= 5.4e-16 1 (worst found 2.7e-16); float <= 4.1e-04 1 (worst
 *    found 2.0e-04).
 *  Cost, all branches: 16 add, 16 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_length_jacobian(const real_t pose[2], const real_t rails[4], real_t jacobian[8]);

/** Platform velocity: least squares over the unit rows of dl/dx xdot = ldot - dl/ds sdot  (Yoon
 *    eq. 6, 20 with normalised rows).
 *  pose [m] (2), rails [m] (4), length_rates [m/s] (4), rail_rates [m/s] (4)  ->  velocity
 *    [m/s] (2)
 *  Domain: pose in [-0.7118, 1.4236] x [-0.4618, 0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails in [-0.7118, 1.4236] x [-0.4618, 0.9236] x [-0.7118, 1.4236] x [-0.4618,
 *    0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Domain: length_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  Domain: rail_rates with a sum of magnitudes of at most 400 m/s, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of velocity: double <= 2.2e-12 m/s (worst found 1.1e-12); float <= 4.5e-03 m/s (worst
 *    found 2.2e-03).
 *  Cost, all branches: 33 add, 46 mul, 6 div, 4 sqrt, 5 compare, 1 select. */
tb_status tb_task_velocity(const real_t pose[2], const real_t rails[4], const real_t
    length_rates[4], const real_t rail_rates[4], real_t velocity[2]);

/** Pose from lengths: closed form, then one Gauss-Newton step on the least-squares misfit
 *    (Yoon eq. 19).
 *  lengths [m] (4), rails [m] (4)  ->  pose [m] (2), residual [m] (scalar)
 *  Domain: lengths in [0, 4.6944] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails in [-0.7118, 1.4236] x [-0.4618, 0.9236] x [-0.7118, 1.4236] x [-0.4618,
 *    0.9236] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the bases lie on one line.
 *  TB_SINGULAR: the platform is at a pulley.
 *  Error of pose: double <= 2.2e-11 m (worst found 1.1e-11); float <= 3.8e-05 m (worst found
 *    1.9e-05).
 *  Error of residual: double <= 4.7e-11 m (worst found 2.4e-11); float <= 4.9e-05 m (worst
 *    found 2.5e-05).
 *  Cost, all branches: 96 add, 89 mul, 8 div, 9 sqrt, 2 compare, 4 select. */
tb_status tb_forward_kinematics(const real_t lengths[4], const real_t rails[4], real_t pose[2],
    real_t residual[1]);

/** Rail Jacobian dl/ds  (Yoon eq. 3, 20).
 *  pose [m] (2), rails [m] (4)  ->  jacobian [1] (4 x 4)
 *  Domain: pose in [-0.7118, 1.4236] x [-0.4618, 0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails in [-0.7118, 1.4236] x [-0.4618, 0.9236] x [-0.7118, 1.4236] x [-0.4618,
 *    0.9236] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of jacobian: double <= 4.4e-16 1 (worst found 2.2e-16); float <= 2.1e-05 1 (worst
 *    found 1.0e-05).
 *  Cost, all branches: 10 add, 8 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_rail_jacobian(const real_t pose[2], const real_t rails[4], real_t jacobian[16]);

#endif
