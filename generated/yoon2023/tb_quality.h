/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine c2e26558649395a1, generator 0.1.0, casadi 3.8.2. Do not edit. */
#ifndef TB_QUALITY_H
#define TB_QUALITY_H

/* Tension factor and isotropic force of a pose of yoon2023. */

#include "tb_types.h"

/** Least-norm tensions T0 under zero wrench; T_min in every cable outside the workspace  (Yoon
 *    eq. 12 with W = 0).
 *  pose [m] (2), rails [m] (4)  ->  tension [N] (4)
 *  Domain: pose in [-0.7118, 1.4236] x [-0.4618, 0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails in [-0.7118, 1.4236] x [-0.4618, 0.9236] x [-0.7118, 1.4236] x [-0.4618,
 *    0.9236] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions are missed by more than rounding.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of tension: double <= 2.8e-13 N (worst found 1.4e-13); float <= 3.4e-05 N (worst found
 *    1.7e-05).
 *  Cost, all branches: 123 add, 171 mul, 17 div, 6 sqrt, 30 compare, 95 select. */
tb_status tb_zero_wrench_tension(const real_t pose[2], const real_t rails[4], real_t tension[4]);

/** Tension factor TF = min(T0) / max(T0); 0 outside the zero-wrench workspace  (Yoon eq. 13).
 *  pose [m] (2), rails [m] (4)  ->  factor [1] (scalar)
 *  Domain: pose in [-0.7118, 1.4236] x [-0.4618, 0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails in [-0.7118, 1.4236] x [-0.4618, 0.9236] x [-0.7118, 1.4236] x [-0.4618,
 *    0.9236] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of factor: double <= 3.9e-15 1 (worst found 1.9e-15); float <= 3.7e-06 1 (worst found
 *    1.8e-06).
 *  Cost, all branches: 111 add, 151 mul, 18 div, 6 sqrt, 15 compare, 76 select. */
tb_status tb_tension_factor(const real_t pose[2], const real_t rails[4], real_t factor[1]);

/** Isotropic force I_F: the largest force in every direction; 0 outside the workspace  (Yoon
 *    section III-A, exact by the facets of {S T}; eq. 17 is a lower bound of it).
 *  pose [m] (2), rails [m] (4)  ->  force [N] (scalar)
 *  Domain: pose in [-0.7118, 1.4236] x [-0.4618, 0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails in [-0.7118, 1.4236] x [-0.4618, 0.9236] x [-0.7118, 1.4236] x [-0.4618,
 *    0.9236] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double <= 1.2e-14 N (worst found 6.1e-15); float <= 4.2e-05 N (worst found
 *    2.1e-05).
 *  Cost, all branches: 38 add, 42 mul, 4 div, 4 sqrt, 5 compare, 4 select. */
tb_status tb_isotropic_force(const real_t pose[2], const real_t rails[4], real_t force[1]);

/** Isotropic force as published: a circle in the parallelograms of adjacent cables  (Yoon eq.
 *    17; a lower bound of the true isotropic force).
 *  pose [m] (2), rails [m] (4)  ->  force [N] (scalar)
 *  Domain: pose in [-0.7118, 1.4236] x [-0.4618, 0.9236] m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails in [-0.7118, 1.4236] x [-0.4618, 0.9236] x [-0.7118, 1.4236] x [-0.4618,
 *    0.9236] m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: the pose is outside the wrench-feasible workspace for zero wrench.
 *  Error of force: double <= 1.6e-14 N (worst found 8.2e-15); float <= 1.5e-05 N (worst found
 *    7.6e-06).
 *  Cost, all branches: 134 add, 175 mul, 17 div, 6 sqrt, 45 compare, 117 select. */
tb_status tb_isotropic_force_eq17(const real_t pose[2], const real_t rails[4], real_t force[1]);

#endif
