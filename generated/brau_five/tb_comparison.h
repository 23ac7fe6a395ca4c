/* Regenerate: turnbuckle generate machines/brau_five.toml --out <this folder>
 * Machine b614899c8a021831, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_COMPARISON_H
#define TB_COMPARISON_H

/* Published tension methods of brau_five. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Largest tension of every cable over all directions of a force that the two adjacent cables
 *    bear, T_min = 0  (Brau eqs 14, 17 with adjacent cables only).
 *  structure [-] (2 x 5), force [N] (scalar)  ->  tension [N] (5)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 10000] N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: half the plane has no cable; 0.
 *  Error of tension: double at most 2.0e-09 N; float at most 4.8e-01 N.
 *  Cost, all branches: 30 add, 46 mul, 20 div, 30 compare, 84 select. */
tb_status tb_largest_tensions_eq17(const real_t structure[10], const real_t force[1],
    real_t tension[5]);

/** Tensions of d cables that exert a wrench, T_min in the others: of all sets with tensions of
 *    T_min and above the one of lowest sum; T_max is not looked at  (Brau eqs 6, 7).
 *  structure [-] (2 x 5), wrench [N] (2)  ->  tension [N] (5)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 100000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no set of d cables exerts the wrench with T_min and above, and every cable
 *    holds T_min.
 *  Error of tension: double at most 1.5e-10 N; float at most 4.1e+04 N.
 *  Cost, all branches: 65 add, 62 mul, 10 div, 20 compare, 95 select. */
tb_status tb_reduced_matrix_tension(const real_t structure[10], const real_t wrench[2],
    real_t tension[5]);

/** Tensions of least norm above T_min, as the kernel of S allows; T_max is not looked at  (Brau
 *    eqs 3-5, a quadratic program for more than one redundant cable).
 *  structure [-] (2 x 5), wrench [N] (2)  ->  tension [N] (5)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 100000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: not done after 25 steps.
 *  TB_INFEASIBLE: there is no solution, and every cable holds T_min.
 *  Error of tension: double at most 1.2e-09 N; float at most 4.3e-02 N.
 *  At most 25 steps.
 *  Cost, all branches and steps: 2240 add, 2540 mul, 256 div, 54 sqrt, 1388 compare, 3868
 *    select. */
tb_status tb_kernel_tension(const real_t structure[10], const real_t wrench[2],
    real_t tension[5]);

/** Upper bound of every tension over all directions of a force and all sets of d cables, T_min
 *    = 0: tight for d + 1 cables all around, else far too high  (Brau eq. 12 with |Delta|; 14
 *    for 3 planar cables, 18 and 19 for 4 in space).
 *  structure [-] (2 x 5), force [N] (scalar)  ->  tension [N] (5)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 10000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_SINGULAR: d of the cables are dependent, and the bound has no limit.
 *  Error of tension: double at most 1.7e-03 N; float at most 1.7e+01 N.
 *  Visits 5 subsets of the cables.
 *  Cost, all branches and steps: 47 add, 102 mul, 31 div, 7 sqrt, 33 compare, 112 select. */
tb_status tb_largest_tensions_eq12(const real_t structure[10], const real_t force[1],
    real_t tension[5]);

/** Least T_max with which every force of a size is feasible; exact for any number of cables
 *    (facets of {S T}, in place of Brau eq. 20).
 *  structure [-] (2 x 5), force [N] (scalar)  ->  tension [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 10000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: no tension is enough for every direction; 0.
 *  Error of tension: double at most 1.1e-01 N; float at most 2.0e+04 N.
 *  Visits 5 subsets of the cables.
 *  Cost, all branches and steps: 97 add, 111 mul, 16 div, 7 sqrt, 48 compare, 57 select. */
tb_status tb_largest_tension(const real_t structure[10], const real_t force[1],
    real_t tension[1]);

#ifdef __cplusplus
}
#endif

#endif
