/* Regenerate: turnbuckle generate machines/yoon2023.toml --out <this folder>
 * Machine 499338192b9e5092, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_QUALITY_H
#define TB_QUALITY_H

/* Tension factor and isotropic force of a pose of yoon2023. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace  (Yoon
 *    eq. 12 with W = 0).
 *  pose [m] (2), rails [m] (4)  ->  tension [N] (4)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of tension: double at most 5.0e-13 N (worst found 1.2e-13 at pose (0.6173, 0.1638),
 *    rails (0.001394, 0.1636, 0.7118, 0.011)); float at most 1.2e-04 N (worst found 3.0e-05 at
 *    pose (0.5058, 0.4588), rails (0.4468, 0.4475, 0.5083, 0.2343)).
 *  Cost, all branches: 135 add, 182 mul, 17 div, 6 sqrt, 41 compare, 116 select. */
tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[4], real_t tension[4]);

/** Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace  (Yoon eq. 13).
 *  pose [m] (2), rails [m] (4)  ->  factor [-] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_SINGULAR: T_min is 0, and so is every zero-wrench tension.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of factor: double at most 1.2e-14 (worst found 2.9e-15 at pose (0.2148, 0.3364), rails
 *    (0.579, 0.1904, 0, 0.4618)); float at most 7.1e-06 (worst found 1.8e-06 at pose (0.3569,
 *    0.4606), rails (0.3873, 0.4385, 0.3585, 0.4435)).
 *  Cost, all branches: 111 add, 154 mul, 18 div, 6 sqrt, 18 compare, 82 select. */
tb_status tb_tension_factor(const real_t pose[2], const real_t rails[4], real_t factor[1]);

/** Isotropic force I_F: the largest force in every direction; 0 outside the workspace  (Yoon
 *    section III-A, exact by the facets of {S T}; eq. 17 is a lower bound of it).
 *  pose [m] (2), rails [m] (4)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 2.4e-14 N (worst found 6.1e-15 at pose (0.2382, 0.2421),
 *    rails (0.7118, 0.004908, 0.3132, 0.1427)); float at most 8.5e-05 N (worst found 2.1e-05 at
 *    pose (0.7081, 0.2188), rails (0.7118, 0.2154, 0.6728, 0.2235)).
 *  Cost, all branches: 38 add, 42 mul, 4 div, 4 sqrt, 5 compare, 4 select. */
tb_status tb_isotropic_force(const real_t pose[2], const real_t rails[4], real_t force[1]);

/** What a map shows of a pose: capacity margin, least distance of the zero wrench from a facet
 *    of the feasible forces, negative outside; TF = min(T0) / max(T0), 0 outside and for T_min
 *    = 0; I_F = max(0, margin). Every force up to F is feasible where margin >= F  (Yoon
 *    section III-A, eq. 13; Guay et al. 2014).
 *  pose [m] (2), rails [m] (4)  ->  margin [N] (scalar), factor [-] (scalar), force [N]
 *    (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions of T0 are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of margin: double at most 2.9e-14 N (worst found 7.3e-15 at pose (0.08069, 0.3825),
 *    rails (0.5879, 0.2002, 0.5769, 0.02838)); float at most 3.1e-03 N (worst found 7.8e-04 at
 *    pose (0.7118, 0.001063), rails (0.7118, 0.00125, 0.6931, 0)).
 *  Error of factor: double at most 6.9e-15 (worst found 1.7e-15 at pose (0.212, 0.3364), rails
 *    (0.6127, 0.1311, 0, 0.4618)); float at most 9.8e-05 (worst found 2.4e-05 at pose (0.7116,
 *    0.008881), rails (0.7118, 0.008615, 0.6855, 0.003297)).
 *  Error of force: double at most 1.9e-14 N (worst found 4.7e-15 at pose (0.1262, 0.3798),
 *    rails (0.2244, 0.2827, 0.2232, 0.4534)); float at most 1.4e-03 N (worst found 3.5e-04 at
 *    pose (0.7116, 0.008881), rails (0.7115, 0.008615, 0.6876, 0.003297)).
 *  Cost, all branches: 197 add, 259 mul, 23 div, 6 sqrt, 65 compare, 202 select. */
tb_status tb_pose_quality(const real_t pose[2], const real_t rails[4], real_t margin[1],
    real_t factor[1], real_t force[1]);

/** Isotropic force as published: a circle in the parallelograms of adjacent cables  (Yoon eq.
 *    17; a lower bound of the true isotropic force).
 *  pose [m] (2), rails [m] (4)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 2.6e-14 N (worst found 6.5e-15 at pose (0.09283, 0.115),
 *    rails (0.00928, 0.1739, 0.1225, 0.3412)); float at most 4.0e-05 N (worst found 1.0e-05 at
 *    pose (0.2132, 0.4584), rails (0.3332, 0.1484, 0.2112, 0.4344)).
 *  Cost, all branches: 134 add, 178 mul, 17 div, 6 sqrt, 47 compare, 123 select. */
tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[4], real_t force[1]);

#ifdef __cplusplus
}
#endif

#endif
