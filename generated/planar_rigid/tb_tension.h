/* Regenerate: turnbuckle generate machines/planar_rigid.toml --out <this folder>
 * Machine 95fa38e7104ced7a, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_TENSION_H
#define TB_TENSION_H

/* Tension distribution of planar_rigid. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Tensions of least norm within their bounds that exert a wrench  (Yoon eq. 12, by active
 *    sets: Goldfarb, Idnani 1983).
 *  structure [1, m] (3 x 6), wrench [N, N m] (3)  ->  tension [N] (6), delivered [N] (3),
 *    kkt_residual [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 72 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 180000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 30 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 2.6e-13 N; float at most 1.7e-04 N.
 *  Error of delivered: double at most 4.3e-14 N; float at most 3.1e-05 N.
 *  Error of kkt_residual: double at most 4.3e-14 N; float at most 3.1e-05 N.
 *  At most 30 steps.
 *  Cost, all branches and steps: 4758 add, 5559 mul, 399 div, 96 sqrt, 2152 compare, 6495
 *    select. */
tb_status tb_least_norm_tension(const real_t structure[18], const real_t wrench[3],
    real_t tension[6], real_t delivered[3], real_t kkt_residual[1]);

/** Tensions of least norm above T_min, then clipped to T_max, which changes the wrench  (Yoon
 *    eq. 22, 23).
 *  structure [1, m] (3 x 6), wrench [N, N m] (3)  ->  tension [N] (6), delivered [N] (3),
 *    kkt_residual [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 72 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 180000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 30 steps.
 *  TB_INFEASIBLE: eq. 22 has no solution, and every cable holds T_min.
 *  TB_INFEASIBLE: eq. 23 clipped a tension.
 *  Error of tension: double at most 1.2e-13 N; float at most 2.8e-03 N.
 *  Error of delivered: double at most 8.5e-14 N; float at most 2.1e-03 N.
 *  Error of kkt_residual: double at most 2.1e-08 N; float at most 3.5e-02 N.
 *  At most 30 steps.
 *  Cost, all branches and steps: 4861 add, 5603 mul, 399 div, 96 sqrt, 2158 compare, 6512
 *    select. */
tb_status tb_distribute_tension_paper(const real_t structure[18], const real_t wrench[3],
    real_t tension[6], real_t delivered[3], real_t kkt_residual[1]);

/** The wrench that is served: an infeasible one is replaced by the nearest feasible one  (point
 *    of least norm of {S T - W}: Wolfe 1976).
 *  structure [1, m] (3 x 6), wrench [N, N m] (3)  ->  served [N] (3), inner [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 72 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 180000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_INACCURATE: not done after 160 steps.
 *  TB_INACCURATE: a feasible wrench is nearer than the one found.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 1.5e-13 N; float at most 2.9e-05 N.
 *  Error of inner: double at most 1.5e-13 N; float at most 3.4e-05 N.
 *  At most 160 steps.
 *  Cost, all branches and steps: 33878 add, 32110 mul, 6734 compare, 37775 select, 1920 div,
 *    801 sqrt. */
tb_status tb_served_wrench_closest(const real_t structure[18], const real_t wrench[3],
    real_t served[3], real_t inner[3]);

/** The wrench that is served: an infeasible one keeps its direction and is scaled down to the
 *    largest feasible fraction  (facets of the zonotope {S T}).
 *  structure [1, m] (3 x 6), wrench [N, N m] (3)  ->  served [N] (3), inner [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 72 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 180000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 160 steps.
 *  TB_INACCURATE: a feasible wrench is nearer than the one found.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 3.6e-13 N; float at most 8.3e-05 N.
 *  Error of inner: double at most 3.5e-13 N; float at most 8.2e-05 N.
 *  At most 160 steps.
 *  Visits 15 subsets of the cables.
 *  Cost, all branches and steps: 34594 add, 32917 mul, 1967 div, 819 sqrt, 6981 compare, 38069
 *    select. */
tb_status tb_served_wrench_scale(const real_t structure[18], const real_t wrench[3],
    real_t served[3], real_t inner[3]);

/** Tensions of least norm within their bounds; an infeasible wrench keeps its direction and is
 *    scaled down to the largest feasible fraction  (Yoon eq. 12).
 *  structure [1, m] (3 x 6), wrench [N, N m] (3)  ->  tension [N] (6), delivered [N] (3),
 *    kkt_residual [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 72 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 180000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 30 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INACCURATE: not done after 160 steps.
 *  TB_INACCURATE: a feasible wrench is nearer than the one found.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 1.2e-10 N; float at most 9.2e-02 N.
 *  Error of delivered: double at most 1.3e-13 N; float at most 9.7e-05 N.
 *  Error of kkt_residual: double at most 2.8e-14 N; float at most 1.2e-04 N.
 *  At most 250 steps.
 *  Visits 15 subsets of the cables.
 *  Cost, all branches and steps: 48868 add, 49594 mul, 3164 div, 1107 sqrt, 13437 compare,
 *    57554 select. */
tb_status tb_distribute_tension_scale(const real_t structure[18], const real_t wrench[3],
    real_t tension[6], real_t delivered[3], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench is replaced by the nearest
 *    feasible one  (Yoon eq. 12).
 *  structure [1, m] (3 x 6), wrench [N, N m] (3)  ->  tension [N] (6), delivered [N] (3),
 *    kkt_residual [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 72 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 180000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 30 steps.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INACCURATE: not done after 160 steps.
 *  TB_INACCURATE: a feasible wrench is nearer than the one found.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 1.1e-09 N; float at most 1.6e-02 N.
 *  Error of delivered: double at most 1.7e-13 N; float at most 1.2e-04 N.
 *  Error of kkt_residual: double at most 1.7e-13 N; float at most 2.9e-05 N.
 *  At most 250 steps.
 *  Cost, all branches and steps: 48152 add, 48787 mul, 3117 div, 1089 sqrt, 13190 compare,
 *    57260 select. */
tb_status tb_distribute_tension_closest(const real_t structure[18], const real_t wrench[3],
    real_t tension[6], real_t delivered[3], real_t kkt_residual[1]);

/** What the machine file chooses for an infeasible wrench: tb_distribute_tension_scale. */
tb_status tb_distribute_tension(const real_t structure[18], const real_t wrench[3],
    real_t tension[6], real_t delivered[3], real_t kkt_residual[1]);

#ifdef __cplusplus
}
#endif

#endif
