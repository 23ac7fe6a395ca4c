/* Regenerate: turnbuckle generate machines/yoon2023.toml --out <this folder>
 * Machine 499338192b9e5092, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_TENSION_H
#define TB_TENSION_H

/* Tension distribution of yoon2023. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Tensions of least norm within their bounds that exert a wrench, from cross products alone
 *    (Yoon eq. 12).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 3.6e-12 N; float at most 1.2e-04 N.
 *  Error of delivered: double at most 4.4e-14 N; float at most 2.4e-05 N.
 *  Error of kkt_residual: double at most 4.4e-14 N; float at most 2.3e-05 N.
 *  Cost, all branches: 118 add, 133 mul, 12 div, 1 sqrt, 15 compare, 114 select. */
tb_status tb_least_norm_tension_quick(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds that exert a wrench  (Yoon eq. 12).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 6.8e-13 N; float at most 3.5e-04 N.
 *  Error of delivered: double at most 8.9e-14 N; float at most 4.3e-05 N.
 *  Error of kkt_residual: double at most 7.1e-14 N; float at most 4.3e-05 N.
 *  Cost, all branches: 136 add, 156 mul, 17 div, 2 sqrt, 36 compare, 112 select. */
tb_status tb_least_norm_tension(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** The wrench that is served: an infeasible one keeps its direction and is scaled down to the
 *    largest feasible fraction  (facets of the zonotope {S T}).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  served [N] (2), inner [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 3.5e-13 N; float at most 1.4e-04 N.
 *  Error of inner: double at most 3.4e-13 N; float at most 1.4e-04 N.
 *  Cost, all branches: 130 add, 135 mul, 8 div, 49 compare, 76 select. */
tb_status tb_served_wrench_scale(const real_t structure[8], const real_t wrench[2],
    real_t served[2], real_t inner[2]);

/** The wrench that is served: an infeasible one is replaced by the nearest feasible one
 *    (facets of the zonotope {S T}).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  served [N] (2), inner [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 3.3e-14 N; float at most 1.8e-05 N.
 *  Error of inner: double at most 3.7e-14 N; float at most 2.1e-05 N.
 *  Cost, all branches: 98 add, 104 mul, 4 div, 40 compare, 37 select. */
tb_status tb_served_wrench_closest(const real_t structure[8], const real_t wrench[2],
    real_t served[2], real_t inner[2]);

/** Tensions of least norm above T_min, then clipped to T_max, which changes the wrench  (Yoon
 *    eq. 22, 23).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: eq. 22 has no solution, and every cable holds T_min.
 *  TB_INFEASIBLE: eq. 23 clipped a tension.
 *  Error of tension: double at most 5.6e-13 N; float at most 1.7e-04 N.
 *  Error of delivered: double at most 4.4e-13 N; float at most 1.4e-04 N.
 *  Error of kkt_residual: double at most 2.4e-09 N; float at most 3.8e-02 N.
 *  Cost, all branches: 144 add, 166 mul, 17 div, 2 sqrt, 40 compare, 124 select. */
tb_status tb_distribute_tension_paper(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench keeps its direction and is
 *    scaled down to the largest feasible fraction  (Yoon eq. 12).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 9.5e-10 N; float at most 5.0e-01 N.
 *  Error of delivered: double at most 2.0e-13 N; float at most 4.2e-03 N.
 *  Error of kkt_residual: double at most 6.9e-14 N; float at most 7.5e-05 N.
 *  Cost, all branches: 756 add, 846 mul, 78 div, 7 sqrt, 166 compare, 642 select. */
tb_status tb_distribute_tension_scale(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench is replaced by the nearest
 *    feasible one  (Yoon eq. 12).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 4.0e-09 N; float at most 4.1e-01 N.
 *  Error of delivered: double at most 3.1e-13 N; float at most 2.3e-02 N.
 *  Error of kkt_residual: double at most 3.1e-13 N; float at most 3.6e-05 N.
 *  Cost, all branches: 724 add, 815 mul, 74 div, 7 sqrt, 157 compare, 603 select. */
tb_status tb_distribute_tension_closest(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** What the machine file chooses for an infeasible wrench: tb_distribute_tension_scale. */
tb_status tb_distribute_tension(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1]);

#ifdef __cplusplus
}
#endif

#endif
