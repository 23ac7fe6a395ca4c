/* Regenerate: turnbuckle generate machines/brau_tetrahedron.toml --out <this folder>
 * Machine 1c3579fddb96c4cf, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_TENSION_H
#define TB_TENSION_H

/* Tension distribution of brau_tetrahedron. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Tensions of least norm within their bounds that exert a wrench  (Yoon eq. 12, by active
 *    sets: Goldfarb, Idnani 1983).
 *  structure [-] (3 x 4), wrench [N] (3)  ->  tension [N] (4), delivered [N] (3), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 48, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 240000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 20 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 2.9e-13 N; float at most 4.5e-04 N.
 *  Error of delivered: double at most 5.7e-14 N; float at most 1.1e-04 N.
 *  Error of kkt_residual: double at most 5.7e-14 N; float at most 1.1e-04 N.
 *  At most 20 steps.
 *  Cost, all branches and steps: 2207 add, 2620 mul, 229 div, 66 sqrt, 912 compare, 3061
 *    select. */
tb_status tb_least_norm_tension(const real_t structure[12], const real_t wrench[3],
    real_t tension[4], real_t delivered[3], real_t kkt_residual[1]);

/** Tensions of least norm above T_min, then clipped to T_max, which changes the wrench  (Yoon
 *    eq. 22, 23).
 *  structure [-] (3 x 4), wrench [N] (3)  ->  tension [N] (4), delivered [N] (3), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 48, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 240000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 20 steps.
 *  TB_INFEASIBLE: eq. 22 has no solution, and every cable holds T_min.
 *  TB_INFEASIBLE: eq. 23 clipped a tension.
 *  Error of tension: double at most 3.1e-13 N; float at most 4.3e-04 N.
 *  Error of delivered: double at most 2.6e-13 N; float at most 3.1e-04 N.
 *  Error of kkt_residual: double at most 1.9e-08 N; float at most 5.9e-02 N.
 *  At most 20 steps.
 *  Cost, all branches and steps: 2258 add, 2654 mul, 229 div, 66 sqrt, 916 compare, 3075
 *    select. */
tb_status tb_distribute_tension_paper(const real_t structure[12], const real_t wrench[3],
    real_t tension[4], real_t delivered[3], real_t kkt_residual[1]);

/** The wrench that is served: an infeasible one is replaced by the nearest feasible one  (point
 *    of least norm of {S T - W}: Wolfe 1976).
 *  structure [-] (3 x 4), wrench [N] (3)  ->  served [N] (3), inner [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 48, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 240000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INACCURATE: not done after 160 steps.
 *  TB_INACCURATE: a feasible wrench is nearer than the one found.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 6.6e-14 N; float at most 2.9e-05 N.
 *  Error of inner: double at most 6.5e-14 N; float at most 3.6e-05 N.
 *  At most 160 steps.
 *  Cost, all branches and steps: 32246 add, 29031 mul, 6410 compare, 38747 select, 1920 div,
 *    801 sqrt. */
tb_status tb_served_wrench_closest(const real_t structure[12], const real_t wrench[3],
    real_t served[3], real_t inner[3]);

/** The wrench that is served: an infeasible one keeps its direction and is scaled down to the
 *    largest feasible fraction  (facets of the zonotope {S T}).
 *  structure [-] (3 x 4), wrench [N] (3)  ->  served [N] (3), inner [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 48, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 240000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 160 steps.
 *  TB_INACCURATE: a feasible wrench is nearer than the one found.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 9.5e-14 N; float at most 3.7e-05 N.
 *  Error of inner: double at most 9.3e-14 N; float at most 4.3e-05 N.
 *  At most 160 steps.
 *  Visits 6 subsets of the cables.
 *  Cost, all branches and steps: 32503 add, 29335 mul, 1940 div, 810 sqrt, 6489 compare, 38858
 *    select. */
tb_status tb_served_wrench_scale(const real_t structure[12], const real_t wrench[3],
    real_t served[3], real_t inner[3]);

/** Tensions of least norm within their bounds; an infeasible wrench keeps its direction and is
 *    scaled down to the largest feasible fraction  (Yoon eq. 12).
 *  structure [-] (3 x 4), wrench [N] (3)  ->  tension [N] (4), delivered [N] (3), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 48, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 240000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 20 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INACCURATE: not done after 160 steps.
 *  TB_INACCURATE: a feasible wrench is nearer than the one found.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 2.3e-10 N; float at most 2.4e-01 N.
 *  Error of delivered: double at most 7.4e-14 N; float at most 1.4e-04 N.
 *  Error of kkt_residual: double at most 2.8e-14 N; float at most 1.3e-04 N.
 *  At most 220 steps.
 *  Visits 6 subsets of the cables.
 *  Cost, all branches and steps: 39124 add, 37195 mul, 2627 div, 1008 sqrt, 9225 compare, 48041
 *    select. */
tb_status tb_distribute_tension_scale(const real_t structure[12], const real_t wrench[3],
    real_t tension[4], real_t delivered[3], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench is replaced by the nearest
 *    feasible one  (Yoon eq. 12).
 *  structure [-] (3 x 4), wrench [N] (3)  ->  tension [N] (4), delivered [N] (3), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 48, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 240000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 20 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INACCURATE: not done after 160 steps.
 *  TB_INACCURATE: a feasible wrench is nearer than the one found.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 7.0e-11 N; float at most 1.4e-02 N.
 *  Error of delivered: double at most 8.4e-14 N; float at most 3.5e-05 N.
 *  Error of kkt_residual: double at most 2.8e-14 N; float at most 1.5e-05 N.
 *  At most 220 steps.
 *  Cost, all branches and steps: 38867 add, 36891 mul, 2607 div, 999 sqrt, 9146 compare, 47930
 *    select. */
tb_status tb_distribute_tension_closest(const real_t structure[12], const real_t wrench[3],
    real_t tension[4], real_t delivered[3], real_t kkt_residual[1]);

/** What the machine file chooses for an infeasible wrench: tb_distribute_tension_closest. */
tb_status tb_distribute_tension(const real_t structure[12], const real_t wrench[3],
    real_t tension[4], real_t delivered[3], real_t kkt_residual[1]);

#ifdef __cplusplus
}
#endif

#endif
