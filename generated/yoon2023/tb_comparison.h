/* Regenerate: turnbuckle generate machines/yoon2023.toml --out <this folder>
 * Machine 499338192b9e5092, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_COMPARISON_H
#define TB_COMPARISON_H

/* Published tension methods of yoon2023. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Tensions of least norm above T_min, as the kernel of S allows; T_max is not looked at  (Brau
 *    eqs 3-5, a quadratic program for more than one redundant cable).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  tension [N] (4)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: there is no solution, and every cable holds T_min.
 *  Error of tension: double at most 2.0e-05 N; float at most 1.3e+02 N.
 *  Cost, all branches: 138 add, 158 mul, 17 div, 2 sqrt, 36 compare, 119 select. */
tb_status tb_kernel_tension(const real_t structure[8], const real_t wrench[2],
    real_t tension[4]);

/** Largest tension of every cable over all directions of a force that the two adjacent cables
 *    bear, T_min = 0  (Brau eqs 14, 17 with adjacent cables only).
 *  structure [-] (2 x 4), force [N] (scalar)  ->  tension [N] (4)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 10000] N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: half the plane has no cable; 0.
 *  Error of tension: double at most 1.3e-05 N; float at most 8.7e+02 N.
 *  Cost, all branches: 18 add, 29 mul, 12 div, 18 compare, 51 select. */
tb_status tb_largest_tensions_eq17(const real_t structure[8], const real_t force[1],
    real_t tension[4]);

/** Tensions of d cables that exert a wrench, T_min in the others: of all sets with tensions of
 *    T_min and above the one of lowest sum; T_max is not looked at  (Brau eqs 6, 7).
 *  structure [-] (2 x 4), wrench [N] (2)  ->  tension [N] (4)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no set of d cables exerts the wrench with T_min and above, and every cable
 *    holds T_min.
 *  Error of tension: double at most 1.3e-05 N; float at most 1.8e+01 N.
 *  Cost, all branches: 58 add, 42 mul, 6 div, 12 compare, 53 select. */
tb_status tb_reduced_matrix_tension(const real_t structure[8], const real_t wrench[2],
    real_t tension[4]);

/** Upper bound of every tension over all directions of a force and all sets of d cables, T_min
 *    = 0: tight for d + 1 cables all around, else far too high  (Brau eq. 12 with |Delta|; 14
 *    for 3 planar cables, 18 and 19 for 4 in space).
 *  structure [-] (2 x 4), force [N] (scalar)  ->  tension [N] (4)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 10000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_SINGULAR: d of the cables are dependent, and the bound has no limit.
 *  Error of tension: double at most 3.2e-03 N; float at most 1.1e+01 N.
 *  Visits 4 subsets of the cables.
 *  Cost, all branches and steps: 33 add, 74 mul, 21 div, 6 sqrt, 23 compare, 74 select. */
tb_status tb_largest_tensions_eq12(const real_t structure[8], const real_t force[1],
    real_t tension[4]);

/** Least T_max with which every force of a size is feasible; exact for any number of cables
 *    (facets of {S T}, in place of Brau eq. 20).
 *  structure [-] (2 x 4), force [N] (scalar)  ->  tension [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 10000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: no tension is enough for every direction; 0.
 *  Error of tension: double at most 8.6e-05 N; float at most 2.0e+04 N.
 *  Visits 4 subsets of the cables.
 *  Cost, all branches and steps: 73 add, 89 mul, 13 div, 6 sqrt, 39 compare, 46 select. */
tb_status tb_largest_tension(const real_t structure[8], const real_t force[1],
    real_t tension[1]);

#ifdef __cplusplus
}
#endif

#endif
