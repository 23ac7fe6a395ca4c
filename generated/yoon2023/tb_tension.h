/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine c2e26558649395a1, generator 0.1.0, casadi 3.8.2. Do not edit. */
#ifndef TB_TENSION_H
#define TB_TENSION_H

/* Tension distribution of yoon2023. */

#include "tb_types.h"

/** Tensions of least norm within their bounds that exert a wrench, from cross products alone
 *    (Yoon eq. 12).
 *  structure [1] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32 1, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double <= 1.8e-13 N (worst found 9.0e-14); float <= 1.8e-04 N (worst found
 *    9.1e-05).
 *  Error of delivered: double <= 2.1e-14 N (worst found 1.1e-14); float <= 1.1e-05 N (worst
 *    found 5.7e-06).
 *  Error of kkt_residual: double <= 2.1e-14 N (worst found 1.1e-14); float <= 1.1e-05 N (worst
 *    found 5.7e-06).
 *  Cost, all branches: 116 add, 114 mul, 12 div, 1 sqrt, 25 compare, 89 select. */
tb_status tb_least_norm_tension_quick(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds that exert a wrench  (Yoon eq. 12).
 *  structure [1] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32 1, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double <= 4.3e-13 N (worst found 2.2e-13); float <= 2.2e-04 N (worst found
 *    1.1e-04).
 *  Error of delivered: double <= 4.5e-14 N (worst found 2.3e-14); float <= 2.3e-05 N (worst
 *    found 1.1e-05).
 *  Error of kkt_residual: double <= 4.5e-14 N (worst found 2.3e-14); float <= 2.3e-05 N (worst
 *    found 1.1e-05).
 *  Cost, all branches: 122 add, 145 mul, 15 div, 2 sqrt, 25 compare, 90 select. */
tb_status tb_least_norm_tension(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** The wrench that is served: an infeasible one keeps its direction and is scaled down to the
 *    largest feasible fraction  (facets of the zonotope {S T}).
 *  structure [1] (2 x 4), wrench [N] (2)  ->  served [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 32 1, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double <= 2.0e-13 N (worst found 1.0e-13); float <= 2.6e-04 N (worst found
 *    1.3e-04).
 *  Cost, all branches: 100 add, 108 mul, 8 div, 34 compare, 62 select. */
tb_status tb_served_wrench_scale(const real_t structure[8], const real_t wrench[2], real_t
    served[2]);

/** The wrench that is served: an infeasible one is replaced by the nearest feasible one
 *    (facets of the zonotope {S T}).
 *  structure [1] (2 x 4), wrench [N] (2)  ->  served [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 32 1, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double <= 1.3e-14 N (worst found 6.7e-15); float <= 6.7e-03 N (worst found
 *    3.4e-03).
 *  Cost, all branches: 84 add, 82 mul, 4 div, 28 compare, 37 select. */
tb_status tb_served_wrench_closest(const real_t structure[8], const real_t wrench[2], real_t
    served[2]);

/** Tensions of least norm above T_min, then clipped to T_max, which changes the wrench  (Yoon
 *    eq. 22, 23).
 *  structure [1] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32 1, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: a tension was clipped, or eq. 22 has no solution and every cable holds T_min.
 *  Error of tension: double <= 1.4e+01 N (worst found 7.0e+00); float <= 1.4e+01 N (worst found
 *    7.0e+00).
 *  Error of delivered: double <= 4.6e+00 N (worst found 2.3e+00); float <= 3.2e+00 N (worst
 *    found 1.6e+00).
 *  Error of kkt_residual: double <= 1.2e-12 N (worst found 5.8e-13); float <= 7.9e-04 N (worst
 *    found 3.9e-04).
 *  Cost, all branches: 130 add, 155 mul, 15 div, 2 sqrt, 29 compare, 99 select. */
tb_status tb_distribute_tension_paper(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench keeps its direction and is
 *    scaled down to the largest feasible fraction  (Yoon eq. 12).
 *  structure [1] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32 1, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double <= 9.6e-09 N (worst found 4.8e-09); float <= 4.4e-01 N (worst found
 *    2.2e-01).
 *  Error of delivered: double <= 3.7e-14 N (worst found 1.8e-14); float <= 2.5e-04 N (worst
 *    found 1.2e-04).
 *  Error of kkt_residual: double <= 2.3e-14 N (worst found 1.1e-14); float <= 1.7e-04 N (worst
 *    found 8.4e-05).
 *  Cost, all branches: 454 add, 481 mul, 47 div, 4 sqrt, 109 compare, 330 select. */
tb_status tb_distribute_tension_scale(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench is replaced by the nearest
 *    feasible one  (Yoon eq. 12).
 *  structure [1] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32 1, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double <= 6.8e-10 N (worst found 3.4e-10); float <= 8.0e-01 N (worst found
 *    4.0e-01).
 *  Error of delivered: double <= 5.1e-14 N (worst found 2.6e-14); float <= 8.0e-03 N (worst
 *    found 4.0e-03).
 *  Error of kkt_residual: double <= 5.2e-14 N (worst found 2.6e-14); float <= 2.5e-05 N (worst
 *    found 1.2e-05).
 *  Cost, all branches: 438 add, 455 mul, 43 div, 4 sqrt, 103 compare, 305 select. */
tb_status tb_distribute_tension_closest(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** What the machine file chooses for an infeasible wrench: tb_distribute_tension_scale. */
tb_status tb_distribute_tension(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

#endif
