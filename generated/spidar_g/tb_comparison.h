/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_COMPARISON_H
#define TB_COMPARISON_H

/* Published tension methods of spidar_g. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Tensions of least norm above T_min, as the kernel of S allows; T_max is not looked at  (Brau
 *    eqs 3-5, a quadratic program for more than one redundant cable).
 *  structure [1, m] (6 x 8), wrench [N, N m] (6)  ->  tension [N] (8)
 *  Domain: structure with a sum of magnitudes of at most 192 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 384000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_INACCURATE: not done after 40 steps.
 *  TB_INFEASIBLE: there is no solution, and every cable holds T_min.
 *  Error of tension: double at most 1.8e-06 N; float at most 5.6e+00 N.
 *  At most 40 steps.
 *  Cost, all branches and steps: 20055 add, 23161 mul, 858 div, 252 sqrt, 3751 compare, 20128
 *    select. */
tb_status tb_kernel_tension(const real_t structure[48], const real_t wrench[6],
    real_t tension[8]);

/** Tensions of d cables that exert a wrench, T_min in the others: of all sets with tensions of
 *    T_min and above the one of lowest sum; T_max is not looked at  (Brau eqs 6, 7).
 *  structure [1, m] (6 x 8), wrench [N, N m] (6)  ->  tension [N] (8)
 *  Domain: structure with a sum of magnitudes of at most 192 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 384000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no set of d cables exerts the wrench with T_min and above, and every cable
 *    holds T_min.
 *  Error of tension: double at most 5.0e-05 N; float at most 2.6e+03 N.
 *  Visits 28 subsets of the cables.
 *  Cost, all branches and steps: 6116 add, 6977 mul, 336 div, 140 sqrt, 105 compare, 782
 *    select. */
tb_status tb_reduced_matrix_tension(const real_t structure[48], const real_t wrench[6],
    real_t tension[8]);

/** Upper bound of every tension over all directions of a force without a moment and all sets of
 *    d cables, T_min = 0: tight for d + 1 cables all around, else far too high  (Brau eq. 12
 *    with |Delta|; 14 for 3 planar cables, 18 and 19 for 4 in space).
 *  structure [1, m] (6 x 8), force [N] (scalar)  ->  tension [N] (8)
 *  Domain: structure with a sum of magnitudes of at most 192 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 8000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_SINGULAR: d of the cables are dependent, and the bound has no limit.
 *  Error of tension: double at most 5.0e-05 N; float at most 2.8e+01 N.
 *  Visits 56 subsets of the cables.
 *  Cost, all branches and steps: 9839 add, 12312 mul, 733 div, 342 sqrt, 2527 compare, 1906
 *    select. */
tb_status tb_largest_tensions_eq12(const real_t structure[48], const real_t force[1],
    real_t tension[8]);

/** Least T_max with which every force of a size without a moment is feasible; exact for any
 *    number of cables  (facets of {S T}, in place of Brau eq. 20).
 *  structure [1, m] (6 x 8), force [N] (scalar)  ->  tension [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 192 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 8000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 6 directions.
 *  TB_INFEASIBLE: no tension is enough for every direction; 0.
 *  Error of tension: double at most 7.3e-07 N; float at most 2.5e+03 N.
 *  Visits 56 subsets of the cables.
 *  Cost, all branches and steps: 10847 add, 12639 mul, 397 div, 342 sqrt, 2751 compare, 842
 *    select. */
tb_status tb_largest_tension(const real_t structure[48], const real_t force[1],
    real_t tension[1]);

#ifdef __cplusplus
}
#endif

#endif
