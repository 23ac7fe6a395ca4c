/* Regenerate: turnbuckle generate machines/brau_five.toml --out <this folder>
 * Machine b614899c8a021831, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_QUALITY_H
#define TB_QUALITY_H

/* Tension factor and isotropic force of a pose of brau_five. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Isotropic force I_F: the largest force in every direction; 0 outside the workspace  (Yoon
 *    section III-A, exact by the facets of {S T}; eq. 17 is a lower bound of it).
 *  pose [m] (2), rails [m] (0)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 2.9e-14 N (worst found 7.3e-15 at pose (0.5, 0.6825)); float
 *    at most 1.6e-05 N (worst found 4.1e-06 at pose (0.5273, 0.6276)).
 *  Cost, all branches: 51 add, 52 mul, 5 div, 5 sqrt, 6 compare, 5 select. */
tb_status tb_isotropic_force(const real_t pose[2], const real_t rails[1], real_t force[1]);

/** What a map shows of a pose: capacity margin, least distance of the zero wrench from a facet
 *    of the feasible forces, negative outside; TF = min(T0) / max(T0), 0 outside and for T_min
 *    = 0; I_F = max(0, margin). Every force up to F is feasible where margin >= F  (Yoon
 *    section III-A, eq. 13; Guay et al. 2014).
 *  pose [m] (2), rails [m] (0)  ->  margin [N] (scalar), factor [-] (scalar), force [N]
 *    (scalar)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions of T0 are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of margin: double at most 0.0e+00 N; float at most 1.6e-05 N (worst found 4.1e-06 at
 *    pose (0.5273, 0.6276)).
 *  Error of factor: double at most 0.0e+00; float at most 0.0e+00.
 *  Error of force: double at most 0.0e+00 N; float at most 1.6e-05 N (worst found 4.1e-06 at
 *    pose (0.5273, 0.6276)).
 *  Cost, all branches: 60 add, 65 mul, 5 div, 5 sqrt, 7 compare, 6 select. */
tb_status tb_pose_quality(const real_t pose[2], const real_t rails[1], real_t margin[1],
    real_t factor[1], real_t force[1]);

/** Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace  (Yoon
 *    eq. 12 with W = 0).
 *  pose [m] (2), rails [m] (0)  ->  tension [N] (5)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: not done after 25 steps.
 *  TB_INACCURATE: the optimality conditions are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of tension: double at most 0.0e+00 N; float at most 0.0e+00 N.
 *  At most 25 steps.
 *  Cost, all branches and steps: 2480 add, 2565 mul, 261 div, 59 sqrt, 1394 compare, 3869
 *    select. */
tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[1], real_t tension[5]);

/** Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace  (Yoon eq. 13).
 *  pose [m] (2), rails [m] (0)  ->  factor [-] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: not done after 25 steps.
 *  TB_SINGULAR: T_min is 0, and so is every zero-wrench tension.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of factor: double at most 0.0e+00; float at most 0.0e+00.
 *  At most 25 steps.
 *  Cost, all branches and steps: 2467 add, 2546 mul, 260 div, 59 sqrt, 1394 compare, 3860
 *    select. */
tb_status tb_tension_factor(const real_t pose[2], const real_t rails[1], real_t factor[1]);

/** Isotropic force as published: a circle in the parallelograms of adjacent cables  (Yoon eq.
 *    17; a lower bound of the true isotropic force).
 *  pose [m] (2), rails [m] (0)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: not done after 25 steps.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 1.8e-14 N (worst found 4.5e-15 at pose (0.4137, 0.5)); float
 *    at most 9.2e-06 N (worst found 2.3e-06 at pose (0.4783, 0.4987)).
 *  At most 25 steps.
 *  Cost, all branches and steps: 2502 add, 2586 mul, 259 div, 59 sqrt, 1443 compare, 3931
 *    select. */
tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[1], real_t force[1]);

#ifdef __cplusplus
}
#endif

#endif
