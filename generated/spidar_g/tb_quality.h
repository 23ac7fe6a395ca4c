/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_QUALITY_H
#define TB_QUALITY_H

/* Tension factor and isotropic force of a pose of spidar_g. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace  (Yoon
 *    eq. 12 with W = 0).
 *  pose [m, rad] (6), rails [m] (0)  ->  tension [N] (8)
 *  Domain: pose in [-1.2, 1.2] x [-1.2, 1.2] x [-1.2, 1.2] x [-1.5472, 1.5472] x [-1.5472,
 *    1.5472] x [-1.5472, 1.5472] m, rad, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  TB_INACCURATE: not done after 40 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 1.4e-13 N (worst found 3.6e-14 at pose (0.4613, 0.3134,
 *    0.1089, 0.6492, 0.1034, 0.2674)); float at most 6.7e-05 N (worst found 1.7e-05 at pose
 *    (0.3577, 0.4231, 0.1949, -0.747, 0.1373, 0.3365)).
 *  At most 40 steps.
 *  Visits 56 subsets of the cables.
 *  Cost, all branches and steps: 30528 add, 35424 mul, 1151 div, 546 sqrt, 6287 compare, 20684
 *    select. */
tb_status tb_zero_wrench_tension(const real_t pose[6], const real_t rails[1], real_t tension[8]);

/** Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace  (Yoon eq. 13).
 *  pose [m, rad] (6), rails [m] (0)  ->  factor [-] (scalar)
 *  Domain: pose in [-1.2, 1.2] x [-1.2, 1.2] x [-1.2, 1.2] x [-1.5472, 1.5472] x [-1.5472,
 *    1.5472] x [-1.5472, 1.5472] m, rad, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  TB_INACCURATE: not done after 40 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_SINGULAR: T_min is 0, and so is every zero-wrench tension.
 *  Error of factor: double at most 2.7e-15 (worst found 6.8e-16 at pose (0.365, 0.264, 0.1584,
 *    -0.8488, 0.7025, -0.2091)); float at most 1.1e-06 (worst found 2.8e-07 at pose (0.3789,
 *    0.3687, 0.4074, -0.4471, 0.8378, 0)).
 *  At most 40 steps.
 *  Visits 56 subsets of the cables.
 *  Cost, all branches and steps: 30528 add, 35424 mul, 1152 div, 546 sqrt, 6288 compare, 20692
 *    select. */
tb_status tb_tension_factor(const real_t pose[6], const real_t rails[1], real_t factor[1]);

/** Isotropic force I_F: the largest force in every direction without any moment; 0 outside the
 *    workspace  (Yoon section III-A, exact by the facets of {S T}).
 *  pose [m, rad] (6), rails [m] (0)  ->  force [N] (scalar)
 *  Domain: pose in [-1.2, 1.2] x [-1.2, 1.2] x [-1.2, 1.2] x [-1.5472, 1.5472] x [-1.5472,
 *    1.5472] x [-1.5472, 1.5472] m, rad, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 4.1e-14 N (worst found 1.0e-14 at pose (0.3504, 0.3008,
 *    0.1532, 0.4598, -0.8137, 0.5171)); float at most 3.3e-05 N (worst found 8.2e-06 at pose
 *    (0.3006, 0.2641, 0.2999, -0.07307, 0.759, 0.6126)).
 *  Visits 56 subsets of the cables.
 *  Cost, all branches and steps: 10810 add, 12625 mul, 349 div, 350 sqrt, 2591 compare, 675
 *    select. */
tb_status tb_isotropic_force(const real_t pose[6], const real_t rails[1], real_t force[1]);

#ifdef __cplusplus
}
#endif

#endif
