/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_TENSION_H
#define TB_TENSION_H

/* Tension distribution of spidar_g. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Tensions of least norm within their bounds that exert a wrench  (Yoon eq. 12, by active
 *    sets: Goldfarb, Idnani 1983).
 *  structure [1, m] (6 x 8), wrench [N, N m] (6)  ->  tension [N] (8), delivered [N] (6),
 *    kkt_residual [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 192 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 384000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_INACCURATE: not done after 40 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 3.0e-13 N; float at most 1.5e-04 N.
 *  Error of delivered: double at most 2.8e-14 N; float at most 1.5e-05 N.
 *  Error of kkt_residual: double at most 2.8e-14 N; float at most 1.5e-05 N.
 *  At most 40 steps.
 *  Cost, all branches and steps: 19830 add, 23023 mul, 858 div, 252 sqrt, 3751 compare, 20114
 *    select. */
tb_status tb_least_norm_tension(const real_t structure[48], const real_t wrench[6],
    real_t tension[8], real_t delivered[6], real_t kkt_residual[1]);

/** Tensions of least norm above T_min, then clipped to T_max, which changes the wrench  (Yoon
 *    eq. 22, 23).
 *  structure [1, m] (6 x 8), wrench [N, N m] (6)  ->  tension [N] (8), delivered [N] (6),
 *    kkt_residual [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 192 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 384000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_INACCURATE: not done after 40 steps.
 *  TB_INFEASIBLE: eq. 22 has no solution, and every cable holds T_min.
 *  TB_INFEASIBLE: eq. 23 clipped a tension.
 *  Error of tension: double at most 1.9e-13 N; float at most 9.5e-05 N.
 *  Error of delivered: double at most 1.6e-13 N; float at most 7.3e-05 N.
 *  Error of kkt_residual: double at most 2.5e-10 N; float at most 3.2e-02 N.
 *  At most 40 steps.
 *  Cost, all branches and steps: 20097 add, 23209 mul, 858 div, 252 sqrt, 3759 compare, 20137
 *    select. */
tb_status tb_distribute_tension_paper(const real_t structure[48], const real_t wrench[6],
    real_t tension[8], real_t delivered[6], real_t kkt_residual[1]);

/** The wrench that is served: an infeasible one is replaced by the nearest feasible one  (point
 *    of least norm of {S T - W}: Wolfe 1976).
 *  structure [1, m] (6 x 8), wrench [N, N m] (6)  ->  served [N] (6), inner [N] (6)
 *  Domain: structure with a sum of magnitudes of at most 192 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 384000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_INACCURATE: not done after 280 steps.
 *  TB_INACCURATE: a feasible wrench is nearer than the one found.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 6.2e-14 N; float at most 1.2e-02 N.
 *  Error of inner: double at most 6.1e-14 N; float at most 1.2e-02 N.
 *  At most 280 steps.
 *  Cost, all branches and steps: 246998 add, 213930 mul, 19898 compare, 228782 select, 5880
 *    div, 2241 sqrt. */
tb_status tb_served_wrench_closest(const real_t structure[48], const real_t wrench[6],
    real_t served[6], real_t inner[6]);

/** The wrench that is served: an infeasible one keeps its direction and is scaled down to the
 *    largest feasible fraction  (facets of the zonotope {S T}).
 *  structure [1, m] (6 x 8), wrench [N, N m] (6)  ->  served [N] (6), inner [N] (6)
 *  Domain: structure with a sum of magnitudes of at most 192 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 384000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_INACCURATE: not done after 280 steps.
 *  TB_INACCURATE: a feasible wrench is nearer than the one found.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 1.4e-13 N; float at most 2.9e-04 N.
 *  Error of inner: double at most 1.4e-13 N; float at most 2.9e-04 N.
 *  At most 280 steps.
 *  Visits 56 subsets of the cables.
 *  Cost, all branches and steps: 258247 add, 226765 mul, 6221 div, 2527 sqrt, 22596 compare,
 *    229973 select. */
tb_status tb_served_wrench_scale(const real_t structure[48], const real_t wrench[6],
    real_t served[6], real_t inner[6]);

/** Tensions of least norm within their bounds; an infeasible wrench keeps its direction and is
 *    scaled down to the largest feasible fraction  (Yoon eq. 12).
 *  structure [1, m] (6 x 8), wrench [N, N m] (6)  ->  tension [N] (8), delivered [N] (6),
 *    kkt_residual [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 192 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 384000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_INACCURATE: not done after 40 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INACCURATE: not done after 280 steps.
 *  TB_INACCURATE: a feasible wrench is nearer than the one found.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 4.2e-11 N; float at most 7.2e-02 N.
 *  Error of delivered: double at most 1.3e-13 N; float at most 4.5e-05 N.
 *  Error of kkt_residual: double at most 2.1e-14 N; float at most 3.9e-05 N.
 *  At most 400 steps.
 *  Visits 56 subsets of the cables.
 *  Cost, all branches and steps: 317737 add, 295834 mul, 8795 div, 3283 sqrt, 33849 compare,
 *    290315 select. */
tb_status tb_distribute_tension_scale(const real_t structure[48], const real_t wrench[6],
    real_t tension[8], real_t delivered[6], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench is replaced by the nearest
 *    feasible one  (Yoon eq. 12).
 *  structure [1, m] (6 x 8), wrench [N, N m] (6)  ->  tension [N] (8), delivered [N] (6),
 *    kkt_residual [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 192 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 384000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_INACCURATE: not done after 40 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INACCURATE: not done after 280 steps.
 *  TB_INACCURATE: a feasible wrench is nearer than the one found.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 2.5e-12 N; float at most 9.6e-01 N.
 *  Error of delivered: double at most 1.0e-13 N; float at most 1.3e-02 N.
 *  Error of kkt_residual: double at most 4.3e-14 N; float at most 1.5e-05 N.
 *  At most 400 steps.
 *  Cost, all branches and steps: 306488 add, 282999 mul, 8454 div, 2997 sqrt, 31151 compare,
 *    289124 select. */
tb_status tb_distribute_tension_closest(const real_t structure[48], const real_t wrench[6],
    real_t tension[8], real_t delivered[6], real_t kkt_residual[1]);

/** What the machine file chooses for an infeasible wrench: tb_distribute_tension_closest. */
tb_status tb_distribute_tension(const real_t structure[48], const real_t wrench[6],
    real_t tension[8], real_t delivered[6], real_t kkt_residual[1]);

#ifdef __cplusplus
}
#endif

#endif
