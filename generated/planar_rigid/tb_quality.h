/* Regenerate: turnbuckle generate machines/planar_rigid.toml --out <this folder>
 * Machine 95fa38e7104ced7a, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_QUALITY_H
#define TB_QUALITY_H

/* Tension factor and isotropic force of a pose of planar_rigid. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace  (Yoon
 *    eq. 12 with W = 0).
 *  pose [m, rad] (3), rails [m] (6)  ->  tension [N] (6)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  TB_INACCURATE: not done after 30 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 6.7e-12 N; float at most 2.2e-03 N.
 *  At most 30 steps.
 *  Visits 15 subsets of the cables.
 *  Cost, all branches and steps: 5401 add, 6330 mul, 437 div, 120 sqrt, 2358 compare, 6623
 *    select. */
tb_status tb_zero_wrench_tension(const real_t pose[3], const real_t rails[6], real_t tension[6]);

/** Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace  (Yoon eq. 13).
 *  pose [m, rad] (3), rails [m] (6)  ->  factor [-] (scalar)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  TB_INACCURATE: not done after 30 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_SINGULAR: T_min is 0, and so is every zero-wrench tension.
 *  Error of factor: double at most 5.2e-14; float at most 1.7e-04.
 *  At most 30 steps.
 *  Visits 15 subsets of the cables.
 *  Cost, all branches and steps: 5401 add, 6330 mul, 438 div, 120 sqrt, 2359 compare, 6629
 *    select. */
tb_status tb_tension_factor(const real_t pose[3], const real_t rails[6], real_t factor[1]);

/** Isotropic force I_F: the largest force in every direction without any moment; 0 outside the
 *    workspace  (Yoon section III-A, exact by the facets of {S T}).
 *  pose [m, rad] (3), rails [m] (6)  ->  force [N] (scalar)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 3.1e-12 N; float at most 6.6e-03 N.
 *  Visits 15 subsets of the cables.
 *  Cost, all branches and steps: 658 add, 816 mul, 53 div, 39 sqrt, 220 compare, 153 select. */
tb_status tb_isotropic_force(const real_t pose[3], const real_t rails[6], real_t force[1]);

#ifdef __cplusplus
}
#endif

#endif
