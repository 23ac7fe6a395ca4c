/* Regenerate: turnbuckle generate machines/brau_tetrahedron.toml --out <this folder>
 * Machine 1c3579fddb96c4cf, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_COMPARISON_H
#define TB_COMPARISON_H

/* Published tension methods of brau_tetrahedron. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Tensions by the kernel of S: the least of them is T_min; T_max is not looked at  (Brau eqs
 *    3-5).
 *  structure [-] (3 x 4), wrench [N] (3)  ->  tension [N] (4)
 *  Domain: structure with a sum of magnitudes of at most 48, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 240000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INFEASIBLE: the kernel has entries of both signs, or zero, and every cable holds T_min.
 *  Error of tension: double at most 2.5e-02 N; float at most 6.9e+04 N.
 *  Cost, all branches: 69 add, 87 mul, 10 div, 3 sqrt, 7 compare, 12 select. */
tb_status tb_kernel_tension(const real_t structure[12], const real_t wrench[3],
    real_t tension[4]);

/** Tensions of d cables that exert a wrench, T_min in the others: of all sets with tensions of
 *    T_min and above the one of lowest sum; T_max is not looked at  (Brau eqs 6, 7).
 *  structure [-] (3 x 4), wrench [N] (3)  ->  tension [N] (4)
 *  Domain: structure with a sum of magnitudes of at most 48, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 240000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no set of d cables exerts the wrench with T_min and above, and every cable
 *    holds T_min.
 *  Error of tension: double at most 1.0e-05 N; float at most 1.4e+01 N.
 *  Visits 4 subsets of the cables.
 *  Cost, all branches and steps: 92 add, 144 mul, 4 div, 21 compare, 63 select. */
tb_status tb_reduced_matrix_tension(const real_t structure[12], const real_t wrench[3],
    real_t tension[4]);

/** Upper bound of every tension over all directions of a force and all sets of d cables, T_min
 *    = 0: tight for d + 1 cables all around, else far too high  (Brau eq. 12 with |Delta|; 14
 *    for 3 planar cables, 18 and 19 for 4 in space).
 *  structure [-] (3 x 4), force [N] (scalar)  ->  tension [N] (4)
 *  Domain: structure with a sum of magnitudes of at most 48, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 20000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_SINGULAR: d of the cables are dependent, and the bound has no limit.
 *  Error of tension: double at most 1.3e-03 N; float at most 3.1e+01 N.
 *  Visits 6 subsets of the cables.
 *  Cost, all branches and steps: 146 add, 242 mul, 38 div, 9 sqrt, 58 compare, 110 select. */
tb_status tb_largest_tensions_eq12(const real_t structure[12], const real_t force[1],
    real_t tension[4]);

/** Least T_max with which every force of a size is feasible; exact for any number of cables
 *    (facets of {S T}, in place of Brau eq. 20).
 *  structure [-] (3 x 4), force [N] (scalar)  ->  tension [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 48, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 20000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  TB_INFEASIBLE: no tension is enough for every direction; 0.
 *  Error of tension: double at most 1.7e-02 N; float at most 2.6e+04 N.
 *  Visits 6 subsets of the cables.
 *  Cost, all branches and steps: 194 add, 255 mul, 26 div, 9 sqrt, 76 compare, 62 select. */
tb_status tb_largest_tension(const real_t structure[12], const real_t force[1],
    real_t tension[1]);

#ifdef __cplusplus
}
#endif

#endif
