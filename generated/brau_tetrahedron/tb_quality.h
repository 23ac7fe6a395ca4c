/* Regenerate: turnbuckle generate machines/brau_tetrahedron.toml --out <this folder>
 * Machine 1c3579fddb96c4cf, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_QUALITY_H
#define TB_QUALITY_H

/* Tension factor and isotropic force of a pose of brau_tetrahedron. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace  (Yoon
 *    eq. 12 with W = 0).
 *  pose [m] (3), rails [m] (0)  ->  tension [N] (4)
 *  Domain: pose with a sum of magnitudes of at most 6 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  TB_INACCURATE: not done after 20 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 0.0e+00 N; float at most 0.0e+00 N.
 *  At most 20 steps.
 *  Visits 6 subsets of the cables.
 *  Cost, all branches and steps: 2414 add, 2889 mul, 247 div, 79 sqrt, 975 compare, 3103
 *    select. */
tb_status tb_zero_wrench_tension(const real_t pose[3], const real_t rails[1], real_t tension[4]);

/** Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace  (Yoon eq. 13).
 *  pose [m] (3), rails [m] (0)  ->  factor [-] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 6 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  TB_INACCURATE: not done after 20 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_SINGULAR: T_min is 0, and so is every zero-wrench tension.
 *  Error of factor: double at most 0.0e+00; float at most 0.0e+00.
 *  At most 20 steps.
 *  Visits 6 subsets of the cables.
 *  Cost, all branches and steps: 2414 add, 2889 mul, 248 div, 79 sqrt, 976 compare, 3107
 *    select. */
tb_status tb_tension_factor(const real_t pose[3], const real_t rails[1], real_t factor[1]);

/** Isotropic force I_F: the largest force in every direction; 0 outside the workspace  (Yoon
 *    section III-A, exact by the facets of {S T}).
 *  pose [m] (3), rails [m] (0)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 6 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 3.6e-14 N (worst found 9.0e-15 at pose (0.4481, 0.3099,
 *    0.1673)); float at most 2.1e-05 N (worst found 5.2e-06 at pose (0.5022, 0.2647, 0.7345)).
 *  Visits 6 subsets of the cables.
 *  Cost, all branches and steps: 207 add, 269 mul, 18 div, 13 sqrt, 62 compare, 51 select. */
tb_status tb_isotropic_force(const real_t pose[3], const real_t rails[1], real_t force[1]);

#ifdef __cplusplus
}
#endif

#endif
