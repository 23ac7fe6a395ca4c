/* Regenerate: turnbuckle generate machines/yoon_synchronised.toml --out <this folder>
 * Machine 2674137f8fc00ebb, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_QUALITY_H
#define TB_QUALITY_H

/* Tension factor and isotropic force of a pose of yoon_synchronised. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace  (Yoon
 *    eq. 12 with W = 0).
 *  pose [m] (2), rails [m] (2)  ->  tension [N] (4)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of tension: double at most 6.5e-14 N (worst found 1.6e-14 at pose (0.5185, 0.06186),
 *    rails (0.1683, 0.03623)); float at most 1.8e-03 N (worst found 4.6e-04 at pose (0.6779,
 *    0.1858), rails (0.7118, 0.001367)).
 *  Cost, all branches: 133 add, 180 mul, 17 div, 6 sqrt, 41 compare, 116 select. */
tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[2], real_t tension[4]);

/** Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace  (Yoon eq. 13).
 *  pose [m] (2), rails [m] (2)  ->  factor [-] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_SINGULAR: T_min is 0, and so is every zero-wrench tension.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of factor: double at most 5.8e-15 (worst found 1.4e-15 at pose (0.3559, 0.1893), rails
 *    (0.3559, 0.1961)); float at most 1.4e-05 (worst found 3.6e-06 at pose (0.7109, 0.2123),
 *    rails (0.5392, 0.2119)).
 *  Cost, all branches: 109 add, 152 mul, 18 div, 6 sqrt, 18 compare, 82 select. */
tb_status tb_tension_factor(const real_t pose[2], const real_t rails[2], real_t factor[1]);

/** Isotropic force I_F: the largest force in every direction; 0 outside the workspace  (Yoon
 *    section III-A, exact by the facets of {S T}; eq. 17 is a lower bound of it).
 *  pose [m] (2), rails [m] (2)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 2.4e-14 N (worst found 5.9e-15 at pose (0.1464, 0.2041),
 *    rails (0.3028, 0.1756)); float at most 1.9e-04 N (worst found 4.7e-05 at pose (0.7101,
 *    0.1208), rails (0.6994, 0.1227)).
 *  Cost, all branches: 36 add, 40 mul, 4 div, 4 sqrt, 5 compare, 4 select. */
tb_status tb_isotropic_force(const real_t pose[2], const real_t rails[2], real_t force[1]);

/** What a map shows of a pose: capacity margin, least distance of the zero wrench from a facet
 *    of the feasible forces, negative outside; TF = min(T0) / max(T0), 0 outside and for T_min
 *    = 0; I_F = max(0, margin). Every force up to F is feasible where margin >= F  (Yoon
 *    section III-A, eq. 13; Guay et al. 2014).
 *  pose [m] (2), rails [m] (2)  ->  margin [N] (scalar), factor [-] (scalar), force [N]
 *    (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions of T0 are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of margin: double at most 3.1e-14 N (worst found 7.8e-15 at pose (0.7015, 0.4618),
 *    rails (0.3145, 0.09565)); float at most 3.4e-03 N (worst found 8.4e-04 at pose (0.7118,
 *    0.3818), rails (0.7118, 0.3817)).
 *  Error of factor: double at most 1.4e-15 (worst found 3.6e-16 at pose (0.3267, 0.3505), rails
 *    (0.3559, 0.2178)); float at most 2.3e-04 (worst found 5.8e-05 at pose (0.7117, 0.2306),
 *    rails (0.7111, 0.2306)).
 *  Error of force: double at most 1.9e-14 N (worst found 4.7e-15 at pose (0.1969, 0.2309),
 *    rails (0.3559, 0.1976)); float at most 3.2e-03 N (worst found 7.9e-04 at pose (0.7117,
 *    0.2306), rails (0.7111, 0.2306)).
 *  Cost, all branches: 195 add, 257 mul, 23 div, 6 sqrt, 65 compare, 202 select. */
tb_status tb_pose_quality(const real_t pose[2], const real_t rails[2], real_t margin[1],
    real_t factor[1], real_t force[1]);

/** Isotropic force as published: a circle in the parallelograms of adjacent cables  (Yoon eq.
 *    17; a lower bound of the true isotropic force).
 *  pose [m] (2), rails [m] (2)  ->  force [N] (scalar)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double at most 3.9e-14 N (worst found 9.8e-15 at pose (0.4109, 0.2295),
 *    rails (0.3267, 0.3773)); float at most 6.6e-05 N (worst found 1.6e-05 at pose (0.7084,
 *    0.3757), rails (0.7118, 0.3683)).
 *  Cost, all branches: 132 add, 176 mul, 17 div, 6 sqrt, 47 compare, 123 select. */
tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[2], real_t force[1]);

#ifdef __cplusplus
}
#endif

#endif
