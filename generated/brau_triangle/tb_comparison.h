/* Regenerate: turnbuckle generate machines/brau_triangle.toml --out <this folder>
 * Machine 62d2624dcb098eaa, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_COMPARISON_H
#define TB_COMPARISON_H

/* Published tension methods of brau_triangle. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Tensions by the kernel of S: the least of them is T_min; T_max is not looked at  (Brau eqs
 *    3-5).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  tension [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 120000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: the kernel has entries of both signs, or zero, and every cable holds T_min.
 *  Error of tension: double at most 4.1e-04 N (worst found 1.0e-04 at structure (-0.5006,
 *    0.8237, 0.454, -0.8183, -0.5004, 0.7422), wrench (-24.51, 14.01)); float at most 3.6e+04 N
 *    (worst found 8.9e+03 at structure (-0.9999, 0.9993, 0.1858, -0, -1.18e-05, 0.9155), wrench
 *    (3.972, -14.67)).
 *  Cost, all branches: 32 add, 43 mul, 7 div, 2 sqrt, 5 compare, 9 select. */
tb_status tb_kernel_tension(const real_t structure[6], const real_t wrench[2],
    real_t tension[3]);

/** Largest tension of every cable over all directions of a force that the two adjacent cables
 *    bear, T_min = 0  (Brau eqs 14, 17 with adjacent cables only).
 *  structure [-] (2 x 3), force [N] (scalar)  ->  tension [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 20000] N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: half the plane has no cable; 0.
 *  Error of tension: double at most 2.3e-04 N (worst found 5.8e-05 at structure (-0.5007,
 *    0.8526, 0.503, -0.866, -0.515, 0.8701), force (29.21)); float at most 9.5e+03 N (worst
 *    found 2.4e+03 at structure (-0.9239, 0.5222, -0.485, -0.3758, -0.9446, 0.8772), force
 *    (23.5)).
 *  Cost, all branches: 9 add, 16 mul, 6 div, 9 compare, 26 select. */
tb_status tb_largest_tensions_eq17(const real_t structure[6], const real_t force[1],
    real_t tension[3]);

/** Tensions of d cables that exert a wrench, T_min in the others: of all sets with tensions of
 *    T_min and above the one of lowest sum; T_max is not looked at  (Brau eqs 6, 7).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  tension [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 120000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no set of d cables exerts the wrench with T_min and above, and every cable
 *    holds T_min.
 *  Error of tension: double at most 5.5e-05 N (worst found 1.4e-05 at structure (-0.8817,
 *    0.5182, -0.5071, -0.08121, -0.8861, 0.867), wrench (12.46, 0)); float at most 1.0e+01 N
 *    (worst found 2.6e+00 at structure (-0.5986, 0.5151, -0.5268, -0.7146, -0.8598, 0.8803),
 *    wrench (24.91, 36.03)).
 *  Cost, all branches: 21 add, 23 mul, 3 div, 6 compare, 25 select. */
tb_status tb_reduced_matrix_tension(const real_t structure[6], const real_t wrench[2],
    real_t tension[3]);

/** Upper bound of every tension over all directions of a force and all sets of d cables, T_min
 *    = 0: tight for d + 1 cables all around, else far too high  (Brau eq. 12 with |Delta|; 14
 *    for 3 planar cables, 18 and 19 for 4 in space).
 *  structure [-] (2 x 3), force [N] (scalar)  ->  tension [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 20000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_SINGULAR: d of the cables are dependent, and the bound has no limit.
 *  Error of tension: double at most 2.5e-03 N (worst found 6.3e-04 at structure (-0.5034,
 *    0.9619, 0.5011, -0.8689, -0.2511, 0.8651), force (36.52)); float at most 3.0e+01 N (worst
 *    found 7.6e+00 at structure (-0.4958, 0.9129, 0.5029, -0.8414, -0.4054, 0.8545), force
 *    (39.5)).
 *  Visits 3 subsets of the cables.
 *  Cost, all branches and steps: 21 add, 49 mul, 13 div, 5 sqrt, 15 compare, 44 select. */
tb_status tb_largest_tensions_eq12(const real_t structure[6], const real_t force[1],
    real_t tension[3]);

/** Least T_max with which every force of a size is feasible; exact for any number of cables
 *    (facets of {S T}, in place of Brau eq. 20).
 *  structure [-] (2 x 3), force [N] (scalar)  ->  tension [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 20000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: no tension is enough for every direction; 0.
 *  Error of tension: double at most 8.4e-04 N (worst found 2.1e-04 at structure (-0.9764, 1,
 *    -0.1171, -2.592e-06, -0, 0.938), force (39.51)); float at most 3.5e+04 N (worst found
 *    8.9e+03 at structure (-0.9336, 0.5082, -0.4942, -0.3708, -0.893, 0.8685), force (30.63)).
 *  Visits 3 subsets of the cables.
 *  Cost, all branches and steps: 39 add, 54 mul, 10 div, 5 sqrt, 24 compare, 29 select. */
tb_status tb_largest_tension(const real_t structure[6], const real_t force[1],
    real_t tension[1]);

#ifdef __cplusplus
}
#endif

#endif
