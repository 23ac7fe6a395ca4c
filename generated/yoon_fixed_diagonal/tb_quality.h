/* Regenerate: turnbuckle generate machines/yoon_fixed_diagonal.toml --out <this folder>
 * Machine 7ea279c692dea1e9, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_QUALITY_H
#define TB_QUALITY_H

/* Tension factor and isotropic force of a pose of yoon_fixed_diagonal. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace  (Yoon
 *    eq. 12 with W = 0).
 *  pose [m] (2), rails [m] (0)  ->  tension [N] (4)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of tension: double at most 5.9e-14 N (worst found 1.5e-14 at pose (0.3354, 0.05174));
 *    float at most 3.9e-04 N (worst found 9.8e-05 at pose (0.5029, 0.2824)).
 *  Cost, all branches: 133 add, 178 mul, 17 div, 6 sqrt, 41 compare, 116 select. */
tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[1], real_t tension[4]);

/** Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace  (Yoon eq. 13).
 *  pose [m] (2), rails [m] (0)  ->  factor [-] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_SINGULAR: T_min is 0, and so is every zero-wrench tension.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of factor: double at most 3.5e-15 (worst found 8.8e-16 at pose (0.239, 0.1418)); float
 *    at most 1.2e-05 (worst found 3.0e-06 at pose (0.5033, 0.2821)).
 *  Cost, all branches: 109 add, 150 mul, 18 div, 6 sqrt, 18 compare, 82 select. */
tb_status tb_tension_factor(const real_t pose[2], const real_t rails[1], real_t factor[1]);

/** Isotropic force I_F: the largest force in every direction; 0 outside the workspace  (Yoon
 *    section III-A, exact by the facets of {S T}; eq. 17 is a lower bound of it).
 *  pose [m] (2), rails [m] (0)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 2.3e-14 N (worst found 5.8e-15 at pose (0.416, 0.09549));
 *    float at most 1.8e-04 N (worst found 4.4e-05 at pose (0.5045, 0.002092)).
 *  Cost, all branches: 34 add, 38 mul, 4 div, 4 sqrt, 5 compare, 4 select. */
tb_status tb_isotropic_force(const real_t pose[2], const real_t rails[1], real_t force[1]);

/** What a map shows of a pose: capacity margin, least distance of the zero wrench from a facet
 *    of the feasible forces, negative outside; TF = min(T0) / max(T0), 0 outside and for T_min
 *    = 0; I_F = max(0, margin). Every force up to F is feasible where margin >= F  (Yoon
 *    section III-A, eq. 13; Guay et al. 2014).
 *  pose [m] (2), rails [m] (0)  ->  margin [N] (scalar), factor [-] (scalar), force [N]
 *    (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions of T0 are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of margin: double at most 2.0e-14 N (worst found 5.1e-15 at pose (0.04522, 0.1449));
 *    float at most 7.0e-03 N (worst found 1.8e-03 at pose (0.506, 0.2839)).
 *  Error of factor: double at most 2.3e-15 (worst found 5.7e-16 at pose (0.1973, 0.1435));
 *    float at most 2.5e-04 (worst found 6.2e-05 at pose (0.5059, 0.2839)).
 *  Error of force: double at most 2.0e-14 N (worst found 5.1e-15 at pose (0.04522, 0.1449));
 *    float at most 3.7e-03 N (worst found 9.3e-04 at pose (0.5059, 0.2839)).
 *  Cost, all branches: 198 add, 255 mul, 23 div, 6 sqrt, 65 compare, 202 select. */
tb_status tb_pose_quality(const real_t pose[2], const real_t rails[1], real_t margin[1],
    real_t factor[1], real_t force[1]);

/** Isotropic force as published: a circle in the parallelograms of adjacent cables  (Yoon eq.
 *    17; a lower bound of the true isotropic force).
 *  pose [m] (2), rails [m] (0)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 2.9e-14 N (worst found 7.3e-15 at pose (0.04173, 0.1045));
 *    float at most 1.8e-04 N (worst found 4.4e-05 at pose (0.5033, 0.2821)).
 *  Cost, all branches: 133 add, 174 mul, 17 div, 6 sqrt, 47 compare, 123 select. */
tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[1], real_t force[1]);

#ifdef __cplusplus
}
#endif

#endif
