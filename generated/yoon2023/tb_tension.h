/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine 771308446b34ef3a, generator 0.1.0, casadi 3.8.2. Do not edit. */
#ifndef TB_TENSION_H
#define TB_TENSION_H

/* Tension distribution of yoon2023. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

/** Tensions of least norm within their bounds that exert a wrench, from cross products alone
 *    (Yoon eq. 12).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 1.1e-13 N; float at most 3.5e-04 N.
 *  Error of delivered: double at most 2.2e-14 N; float at most 1.1e-05 N.
 *  Error of kkt_residual: double at most 2.2e-14 N; float at most 1.1e-05 N.
 *  Cost, all branches: 132 add, 126 mul, 16 div, 1 sqrt, 34 compare, 108 select. */
tb_status tb_least_norm_tension_quick(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds that exert a wrench  (Yoon eq. 12).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 4.3e-13 N; float at most 6.9e-04 N.
 *  Error of delivered: double at most 4.3e-14 N; float at most 2.1e-05 N.
 *  Error of kkt_residual: double at most 4.3e-14 N; float at most 2.1e-05 N.
 *  Cost, all branches: 136 add, 156 mul, 17 div, 2 sqrt, 35 compare, 109 select. */
tb_status tb_least_norm_tension(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** The wrench that is served: an infeasible one keeps its direction and is scaled down to the
 *    largest feasible fraction  (facets of the zonotope {S T}).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  served [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 1.9e-13 N; float at most 2.6e-04 N.
 *  Cost, all branches: 106 add, 125 mul, 8 div, 50 compare, 66 select. */
tb_status tb_served_wrench_scale(const real_t structure[8], const real_t wrench[2], real_t
    served[2]);

/** The wrench that is served: an infeasible one is replaced by the nearest feasible one
 *    (facets of the zonotope {S T}).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  served [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 1.3e-14 N; float at most 4.9e-03 N.
 *  Cost, all branches: 90 add, 99 mul, 4 div, 40 compare, 37 select. */
tb_status tb_served_wrench_closest(const real_t structure[8], const real_t wrench[2], real_t
    served[2]);

/** Tensions of least norm above T_min, then clipped to T_max, which changes the wrench  (Yoon
 *    eq. 22, 23).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: eq. 22 has no solution, and every cable holds T_min.
 *  TB_INFEASIBLE: eq. 23 clipped a tension.
 *  Error of tension: double at most 6.6e-13 N; float at most 1.7e-04 N.
 *  Error of delivered: double at most 5.1e-13 N; float at most 1.5e-04 N.
 *  Error of kkt_residual: double at most 4.8e-11 N; float at most 2.5e-02 N.
 *  Cost, all branches: 144 add, 166 mul, 17 div, 2 sqrt, 39 compare, 122 select. */
tb_status tb_distribute_tension_paper(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

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
 *  Error of tension: double at most 7.0e-08 N; float at most 1.2e-01 N.
 *  Error of delivered: double at most 1.1e-12 N; float at most 7.9e-05 N.
 *  Error of kkt_residual: double at most 8.0e-13 N; float at most 5.1e-05 N.
 *  Cost, all branches: 506 add, 533 mul, 57 div, 4 sqrt, 153 compare, 391 select. */
tb_status tb_distribute_tension_scale(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

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
 *  Error of tension: double at most 1.5e-07 N; float at most 1.2e-01 N.
 *  Error of delivered: double at most 3.2e-13 N; float at most 8.9e-03 N.
 *  Error of kkt_residual: double at most 3.2e-13 N; float at most 5.6e-05 N.
 *  Cost, all branches: 490 add, 507 mul, 53 div, 4 sqrt, 143 compare, 362 select. */
tb_status tb_distribute_tension_closest(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** What the machine file chooses for an infeasible wrench: tb_distribute_tension_scale. */
tb_status tb_distribute_tension(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

#endif
