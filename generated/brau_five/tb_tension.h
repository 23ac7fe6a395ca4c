/* Regenerate: turnbuckle generate machines/brau_five.toml --out <this folder>
 * Machine b614899c8a021831, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_TENSION_H
#define TB_TENSION_H

/* Tension distribution of brau_five. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The wrench that is served: an infeasible one keeps its direction and is scaled down to the
 *    largest feasible fraction  (facets of the zonotope {S T}).
 *  structure [-] (2 x 5), wrench [N] (2)  ->  served [N] (2), inner [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 100000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 1.8e-13 N; float at most 1.0e-03 N.
 *  Error of inner: double at most 1.8e-13 N; float at most 1.0e-03 N.
 *  Cost, all branches: 183 add, 156 mul, 10 div, 71 compare, 119 select. */
tb_status tb_served_wrench_scale(const real_t structure[10], const real_t wrench[2],
    real_t served[2], real_t inner[2]);

/** The wrench that is served: an infeasible one is replaced by the nearest feasible one
 *    (facets of the zonotope {S T}).
 *  structure [-] (2 x 5), wrench [N] (2)  ->  served [N] (2), inner [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 100000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 3.1e-14 N; float at most 6.2e-03 N.
 *  Error of inner: double at most 3.8e-14 N; float at most 6.2e-03 N.
 *  Cost, all branches: 143 add, 118 mul, 5 div, 60 compare, 71 select. */
tb_status tb_served_wrench_closest(const real_t structure[10], const real_t wrench[2],
    real_t served[2], real_t inner[2]);

/** Tensions of least norm within their bounds that exert a wrench  (Yoon eq. 12, by active
 *    sets: Goldfarb, Idnani 1983).
 *  structure [-] (2 x 5), wrench [N] (2)  ->  tension [N] (5), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 100000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: not done after 25 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 2.5e-13 N; float at most 3.6e-04 N.
 *  Error of delivered: double at most 2.8e-14 N; float at most 1.5e-05 N.
 *  Error of kkt_residual: double at most 2.8e-14 N; float at most 1.5e-05 N.
 *  At most 25 steps.
 *  Cost, all branches and steps: 2214 add, 2513 mul, 256 div, 54 sqrt, 1388 compare, 3860
 *    select. */
tb_status tb_least_norm_tension(const real_t structure[10], const real_t wrench[2],
    real_t tension[5], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm above T_min, then clipped to T_max, which changes the wrench  (Yoon
 *    eq. 22, 23).
 *  structure [-] (2 x 5), wrench [N] (2)  ->  tension [N] (5), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 100000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: not done after 25 steps.
 *  TB_INFEASIBLE: eq. 22 has no solution, and every cable holds T_min.
 *  TB_INFEASIBLE: eq. 23 clipped a tension.
 *  Error of tension: double at most 7.5e-13 N; float at most 6.5e-05 N.
 *  Error of delivered: double at most 7.4e-13 N; float at most 6.6e-05 N.
 *  Error of kkt_residual: double at most 1.0e-10 N; float at most 9.8e-03 N.
 *  At most 25 steps.
 *  Cost, all branches and steps: 2248 add, 2550 mul, 256 div, 54 sqrt, 1393 compare, 3876
 *    select. */
tb_status tb_distribute_tension_paper(const real_t structure[10], const real_t wrench[2],
    real_t tension[5], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench keeps its direction and is
 *    scaled down to the largest feasible fraction  (Yoon eq. 12).
 *  structure [-] (2 x 5), wrench [N] (2)  ->  tension [N] (5), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 100000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: not done after 25 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 4.3e-10 N; float at most 1.5e-01 N.
 *  Error of delivered: double at most 6.5e-12 N; float at most 2.1e-04 N.
 *  Error of kkt_residual: double at most 2.3e-14 N; float at most 2.1e-04 N.
 *  At most 75 steps.
 *  Cost, all branches and steps: 6825 add, 7695 mul, 778 div, 162 sqrt, 4235 compare, 11699
 *    select. */
tb_status tb_distribute_tension_scale(const real_t structure[10], const real_t wrench[2],
    real_t tension[5], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench is replaced by the nearest
 *    feasible one  (Yoon eq. 12).
 *  structure [-] (2 x 5), wrench [N] (2)  ->  tension [N] (5), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 100000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: not done after 25 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 8.2e-11 N; float at most 4.4e-02 N.
 *  Error of delivered: double at most 3.1e-14 N; float at most 1.6e-04 N.
 *  Error of kkt_residual: double at most 1.4e-14 N; float at most 1.6e-04 N.
 *  At most 75 steps.
 *  Cost, all branches and steps: 6785 add, 7657 mul, 773 div, 162 sqrt, 4224 compare, 11651
 *    select. */
tb_status tb_distribute_tension_closest(const real_t structure[10], const real_t wrench[2],
    real_t tension[5], real_t delivered[2], real_t kkt_residual[1]);

/** What the machine file chooses for an infeasible wrench: tb_distribute_tension_closest. */
tb_status tb_distribute_tension(const real_t structure[10], const real_t wrench[2],
    real_t tension[5], real_t delivered[2], real_t kkt_residual[1]);

#ifdef __cplusplus
}
#endif

#endif
