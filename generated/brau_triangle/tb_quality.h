/* Regenerate: turnbuckle generate machines/brau_triangle.toml --out <this folder>
 * Machine 62d2624dcb098eaa, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_QUALITY_H
#define TB_QUALITY_H

/* Tension factor and isotropic force of a pose of brau_triangle. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace  (Yoon
 *    eq. 12 with W = 0).
 *  pose [m] (2), rails [m] (0)  ->  tension [N] (3)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of tension: double at most 0.0e+00 N; float at most 0.0e+00 N.
 *  Cost, all branches: 49 add, 70 mul, 9 div, 5 sqrt, 10 compare, 33 select. */
tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[1], real_t tension[3]);

/** Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace  (Yoon eq. 13).
 *  pose [m] (2), rails [m] (0)  ->  factor [-] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_SINGULAR: T_min is 0, and so is every zero-wrench tension.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of factor: double at most 0.0e+00; float at most 0.0e+00.
 *  Cost, all branches: 45 add, 61 mul, 10 div, 5 sqrt, 10 compare, 33 select. */
tb_status tb_tension_factor(const real_t pose[2], const real_t rails[1], real_t factor[1]);

/** Isotropic force I_F: the largest force in every direction; 0 outside the workspace  (Yoon
 *    section III-A, exact by the facets of {S T}; eq. 17 is a lower bound of it).
 *  pose [m] (2), rails [m] (0)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 4.1e-14 N (worst found 1.0e-14 at pose (0.4671, 0.3004));
 *    float at most 2.2e-04 N (worst found 5.4e-05 at pose (0.501, 0.8639)).
 *  Cost, all branches: 22 add, 28 mul, 3 div, 3 sqrt, 4 compare, 3 select. */
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
 *  Error of margin: double at most 0.0e+00 N; float at most 7.4e-04 N (worst found 1.8e-04 at
 *    pose (0.5004, 0.8653)).
 *  Error of factor: double at most 0.0e+00; float at most 0.0e+00.
 *  Error of force: double at most 0.0e+00 N; float at most 7.4e-04 N (worst found 1.8e-04 at
 *    pose (0.5004, 0.8653)).
 *  Cost, all branches: 24 add, 34 mul, 3 div, 3 sqrt, 5 compare, 4 select. */
tb_status tb_pose_quality(const real_t pose[2], const real_t rails[1], real_t margin[1],
    real_t factor[1], real_t force[1]);

/** Isotropic force as published: a circle in the parallelograms of adjacent cables  (Yoon eq.
 *    17; a lower bound of the true isotropic force).
 *  pose [m] (2), rails [m] (0)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 3.5e-14 N (worst found 8.7e-15 at pose (0.07465, 0.2581));
 *    float at most 1.1e-04 N (worst found 2.7e-05 at pose (0.4994, 0.8636)).
 *  Cost, all branches: 58 add, 73 mul, 9 div, 5 sqrt, 24 compare, 52 select. */
tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[1], real_t force[1]);

#ifdef __cplusplus
}
#endif

#endif
