/* Regenerate: turnbuckle generate machines/planar_rigid.toml --out <this folder>
 * Machine 95fa38e7104ced7a, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_COMPARISON_H
#define TB_COMPARISON_H

/* Published tension methods of planar_rigid. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Tensions of least norm above T_min, as the kernel of S allows; T_max is not looked at  (Brau
 *    eqs 3-5, a quadratic program for more than one redundant cable).
 *  structure [1, m] (3 x 6), wrench [N, N m] (3)  ->  tension [N] (6)
 *  Domain: structure with a sum of magnitudes of at most 72 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 180000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INACCURATE: not done after 30 steps.
 *  TB_INFEASIBLE: there is no solution, and every cable holds T_min.
 *  Error of tension: double at most 2.8e-04 N; float at most 6.6e+01 N.
 *  At most 30 steps.
 *  Cost, all branches and steps: 4846 add, 5585 mul, 399 div, 96 sqrt, 2152 compare, 6505
 *    select. */
tb_status tb_kernel_tension(const real_t structure[18], const real_t wrench[3],
    real_t tension[6]);

/** Tensions of d cables that exert a wrench, T_min in the others: of all sets with tensions of
 *    T_min and above the one of lowest sum; T_max is not looked at  (Brau eqs 6, 7).
 *  structure [1, m] (3 x 6), wrench [N, N m] (3)  ->  tension [N] (6)
 *  Domain: structure with a sum of magnitudes of at most 72 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 180000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no set of d cables exerts the wrench with T_min and above, and every cable
 *    holds T_min.
 *  Error of tension: double at most 1.5e+02 N; float at most 1.5e+02 N.
 *  Visits 20 subsets of the cables.
 *  Cost, all branches and steps: 476 add, 730 mul, 20 div, 59 compare, 261 select. */
tb_status tb_reduced_matrix_tension(const real_t structure[18], const real_t wrench[3],
    real_t tension[6]);

/** Upper bound of every tension over all directions of a force without a moment and all sets of
 *    d cables, T_min = 0: tight for d + 1 cables all around, else far too high  (Brau eq. 12
 *    with |Delta|; 14 for 3 planar cables, 18 and 19 for 4 in space).
 *  structure [1, m] (3 x 6), force [N] (scalar)  ->  tension [N] (6)
 *  Domain: structure with a sum of magnitudes of at most 72 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 10000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_SINGULAR: d of the cables are dependent, and the bound has no limit.
 *  Error of tension: double at most 1.4e-03 N; float at most 2.4e+01 N.
 *  Visits 15 subsets of the cables.
 *  Cost, all branches and steps: 419 add, 695 mul, 122 div, 33 sqrt, 199 compare, 392 select. */
tb_status tb_largest_tensions_eq12(const real_t structure[18], const real_t force[1],
    real_t tension[6]);

/** Least T_max with which every force of a size without a moment is feasible; exact for any
 *    number of cables  (facets of {S T}, in place of Brau eq. 20).
 *  structure [1, m] (3 x 6), force [N] (scalar)  ->  tension [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 72 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 10000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INFEASIBLE: no tension is enough for every direction; 0.
 *  Error of tension: double at most 9.3e-05 N; float at most 3.9e+04 N.
 *  Visits 15 subsets of the cables.
 *  Cost, all branches and steps: 629 add, 778 mul, 62 div, 33 sqrt, 259 compare, 197 select. */
tb_status tb_largest_tension(const real_t structure[18], const real_t force[1],
    real_t tension[1]);

#ifdef __cplusplus
}
#endif

#endif
