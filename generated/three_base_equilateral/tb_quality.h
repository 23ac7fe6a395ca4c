/* Regenerate: turnbuckle generate machines/three_base_equilateral.toml --out <this folder>
 * Machine bf852767ce09ae7f, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_QUALITY_H
#define TB_QUALITY_H

/* Tension factor and isotropic force of a pose of three_base_equilateral. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace  (Yoon
 *    eq. 12 with W = 0).
 *  pose [m] (2), rails [m] (6)  ->  tension [N] (3)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of tension: double at most 2.1e-13 N (worst found 5.3e-14 at pose (0.6579, 0.1683),
 *    rails (0.2737, 0, 0.482, 0.03741, 0.1224, 0.009918)); float at most 1.1e-02 N (worst found
 *    2.8e-03 at pose (0.7117, 0.4002), rails (0.6967, 0, 0.005403, 0, 0.4, 5.698e-06)).
 *  Cost, all branches: 54 add, 71 mul, 9 div, 5 sqrt, 10 compare, 33 select. */
tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[6], real_t tension[3]);

/** Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace  (Yoon eq. 13).
 *  pose [m] (2), rails [m] (6)  ->  factor [-] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_SINGULAR: T_min is 0, and so is every zero-wrench tension.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of factor: double at most 6.6e-14 (worst found 1.7e-14 at pose (0.7104, 0.3651), rails
 *    (0.7087, 0, 0.0007264, 4.308e-05, 0.3641, 0.0001777)); float at most 2.2e-04 (worst found
 *    5.5e-05 at pose (0.7117, 0.1943), rails (0.7114, 0, 0, 0.003382, 0.194, 0)).
 *  Cost, all branches: 50 add, 62 mul, 10 div, 5 sqrt, 10 compare, 33 select. */
tb_status tb_tension_factor(const real_t pose[2], const real_t rails[6], real_t factor[1]);

/** Isotropic force I_F: the largest force in every direction; 0 outside the workspace  (Yoon
 *    section III-A, exact by the facets of {S T}; eq. 17 is a lower bound of it).
 *  pose [m] (2), rails [m] (6)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 3.9e-13 N (worst found 9.8e-14 at pose (0.326, 0.698), rails
 *    (0.3227, 0.01171, 0.06108, 0.04577, 0.7118, 0.02663)); float at most 4.3e-03 N (worst
 *    found 1.1e-03 at pose (0.7116, 0.4278), rails (0.7114, 0, 0.009174, 0.003051, 0.4276,
 *    2.191e-05)).
 *  Cost, all branches: 27 add, 29 mul, 3 div, 3 sqrt, 4 compare, 3 select. */
tb_status tb_isotropic_force(const real_t pose[2], const real_t rails[6], real_t force[1]);

/** What a map shows of a pose: capacity margin, least distance of the zero wrench from a facet
 *    of the feasible forces, negative outside; TF = min(T0) / max(T0), 0 outside and for T_min
 *    = 0; I_F = max(0, margin). Every force up to F is feasible where margin >= F  (Yoon
 *    section III-A, eq. 13; Guay et al. 2014).
 *  pose [m] (2), rails [m] (6)  ->  margin [N] (scalar), factor [-] (scalar), force [N]
 *    (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions of T0 are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of margin: double at most 5.5e-13 N (worst found 1.4e-13 at pose (0.609, 0.6782),
 *    rails (0.6109, 0.03192, 0.4358, 0.0009131, 0.3517, 0.04424)); float at most 6.1e-03 N
 *    (worst found 1.5e-03 at pose (0.7117, 0.4002), rails (0.7118, 0, 1.171e-05, 0, 0.4,
 *    5.698e-06)).
 *  Error of factor: double at most 5.5e-14 (worst found 1.4e-14 at pose (0.609, 0.6782), rails
 *    (0.6109, 0.03192, 0.4358, 0.0009131, 0.3517, 0.04424)); float at most 6.1e-04 (worst found
 *    1.5e-04 at pose (0.7117, 0.4002), rails (0.7118, 0, 1.171e-05, 0, 0.4, 5.698e-06)).
 *  Error of force: double at most 5.5e-13 N (worst found 1.4e-13 at pose (0.609, 0.6782), rails
 *    (0.6109, 0.03192, 0.4358, 0.0009131, 0.3517, 0.04424)); float at most 6.1e-03 N (worst
 *    found 1.5e-03 at pose (0.7117, 0.4002), rails (0.7118, 0, 1.171e-05, 0, 0.4, 5.698e-06)).
 *  Cost, all branches: 97 add, 134 mul, 15 div, 5 sqrt, 28 compare, 97 select. */
tb_status tb_pose_quality(const real_t pose[2], const real_t rails[6], real_t margin[1],
    real_t factor[1], real_t force[1]);

/** Isotropic force as published: a circle in the parallelograms of adjacent cables  (Yoon eq.
 *    17; a lower bound of the true isotropic force).
 *  pose [m] (2), rails [m] (6)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 2.7e-13 N (worst found 6.7e-14 at pose (0.7046, 0.3931),
 *    rails (0.633, 0.000107, 0.0004259, 0, 0.3888, 0.003472)); float at most 4.3e-03 N (worst
 *    found 1.1e-03 at pose (0.7116, 0.4278), rails (0.7114, 0, 0.009174, 0.002732, 0.4276,
 *    2.191e-05)).
 *  Cost, all branches: 62 add, 74 mul, 9 div, 5 sqrt, 24 compare, 52 select. */
tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[6], real_t force[1]);

#ifdef __cplusplus
}
#endif

#endif
