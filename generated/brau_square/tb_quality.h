/* Regenerate: turnbuckle generate machines/brau_square.toml --out <this folder>
 * Machine 166f8b7fcb339437, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_QUALITY_H
#define TB_QUALITY_H

/* Tension factor and isotropic force of a pose of brau_square. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace  (Yoon
 *    eq. 12 with W = 0).
 *  pose [m] (2), rails [m] (0)  ->  tension [N] (4)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of tension: double at most 0.0e+00 N; float at most 0.0e+00 N.
 *  Cost, all branches: 134 add, 167 mul, 15 div, 6 sqrt, 39 compare, 109 select. */
tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[1], real_t tension[4]);

/** Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace  (Yoon eq. 13).
 *  pose [m] (2), rails [m] (0)  ->  factor [-] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_SINGULAR: T_min is 0, and so is every zero-wrench tension.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of factor: double at most 0.0e+00; float at most 0.0e+00.
 *  Cost, all branches: 110 add, 137 mul, 16 div, 6 sqrt, 17 compare, 76 select. */
tb_status tb_tension_factor(const real_t pose[2], const real_t rails[1], real_t factor[1]);

/** Isotropic force I_F: the largest force in every direction; 0 outside the workspace  (Yoon
 *    section III-A, exact by the facets of {S T}; eq. 17 is a lower bound of it).
 *  pose [m] (2), rails [m] (0)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 2.5e-14 N (worst found 6.2e-15 at pose (0.6235, 0.5)); float
 *    at most 1.3e-05 N (worst found 3.2e-06 at pose (0.4181, 0.5921)).
 *  Cost, all branches: 34 add, 38 mul, 4 div, 4 sqrt, 5 compare, 4 select. */
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
 *  Error of margin: double at most 0.0e+00 N; float at most 1.3e-05 N (worst found 3.2e-06 at
 *    pose (0.4181, 0.5921)).
 *  Error of factor: double at most 0.0e+00; float at most 0.0e+00.
 *  Error of force: double at most 0.0e+00 N; float at most 1.3e-05 N (worst found 3.2e-06 at
 *    pose (0.4181, 0.5921)).
 *  Cost, all branches: 39 add, 47 mul, 4 div, 4 sqrt, 6 compare, 5 select. */
tb_status tb_pose_quality(const real_t pose[2], const real_t rails[1], real_t margin[1],
    real_t factor[1], real_t force[1]);

/** Isotropic force as published: a circle in the parallelograms of adjacent cables  (Yoon eq.
 *    17; a lower bound of the true isotropic force).
 *  pose [m] (2), rails [m] (0)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 2.0e-14 N (worst found 4.9e-15 at pose (0.5, 0.4018)); float
 *    at most 1.1e-05 N (worst found 2.7e-06 at pose (0.5, 0.5578)).
 *  Cost, all branches: 134 add, 161 mul, 15 div, 6 sqrt, 46 compare, 117 select. */
tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[1], real_t force[1]);

#ifdef __cplusplus
}
#endif

#endif
