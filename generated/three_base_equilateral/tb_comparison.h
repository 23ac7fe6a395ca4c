/* Regenerate: turnbuckle generate machines/three_base_equilateral.toml --out <this folder>
 * Machine bf852767ce09ae7f, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_COMPARISON_H
#define TB_COMPARISON_H

/* Published tension methods of three_base_equilateral. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Tensions by the kernel of S: the least of them is T_min; T_max is not looked at  (Brau eqs
 *    3-5).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  tension [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: the kernel has entries of both signs, or zero, and every cable holds T_min.
 *  Error of tension: double at most 4.3e-03 N (worst found 1.1e-03 at structure (0.9107,
 *    -0.931, 0.6797, 0.5688, -0.5815, -0.9576), wrench (2.622, 8.744)); float at most 7.6e+03 N
 *    (worst found 1.9e+03 at structure (0, -1, 0.9109, 1, -0.04561, 0.04153), wrench (8.265,
 *    -9.833)).
 *  Cost, all branches: 35 add, 43 mul, 7 div, 2 sqrt, 5 compare, 9 select. */
tb_status tb_kernel_tension(const real_t structure[6], const real_t wrench[2],
    real_t tension[3]);

/** Largest tension of every cable over all directions of a force that the two adjacent cables
 *    bear, T_min = 0  (Brau eqs 14, 17 with adjacent cables only).
 *  structure [-] (2 x 3), force [N] (scalar)  ->  tension [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 10000] N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: half the plane has no cable; 0.
 *  Error of tension: double at most 9.3e-03 N (worst found 2.3e-03 at structure (-0.2329,
 *    -0.9651, 0.9976, 0.9807, 0.3529, -0.3648), force (11.87)); float at most 3.0e+03 N (worst
 *    found 7.6e+02 at structure (-0.2113, -0.9473, 0.9901, 0.9707, 0.326, -0.3408), force
 *    (11.78)).
 *  Cost, all branches: 9 add, 16 mul, 6 div, 9 compare, 26 select. */
tb_status tb_largest_tensions_eq17(const real_t structure[6], const real_t force[1],
    real_t tension[3]);

/** Tensions of d cables that exert a wrench, T_min in the others: of all sets with tensions of
 *    T_min and above the one of lowest sum; T_max is not looked at  (Brau eqs 6, 7).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  tension [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no set of d cables exerts the wrench with T_min and above, and every cable
 *    holds T_min.
 *  Error of tension: double at most 6.3e-07 N (worst found 1.6e-07 at structure (0.003562,
 *    -0.9965, 0.9873, 0.9772, -0.3236, 0.3206), wrench (25.84, -16.3)); float at most 6.1e+00 N
 *    (worst found 1.5e+00 at structure (-0.6339, -0.9974, 0.8072, 0.7834, 0.07713, -0.9968),
 *    wrench (20, 0.3742)).
 *  Cost, all branches: 33 add, 25 mul, 3 div, 6 compare, 25 select. */
tb_status tb_reduced_matrix_tension(const real_t structure[6], const real_t wrench[2],
    real_t tension[3]);

/** Upper bound of every tension over all directions of a force and all sets of d cables, T_min
 *    = 0: tight for d + 1 cables all around, else far too high  (Brau eq. 12 with |Delta|; 14
 *    for 3 planar cables, 18 and 19 for 4 in space).
 *  structure [-] (2 x 3), force [N] (scalar)  ->  tension [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 10000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_SINGULAR: d of the cables are dependent, and the bound has no limit.
 *  Error of tension: double at most 3.8e-04 N (worst found 9.6e-05 at structure (-0.9949,
 *    -0.7061, 0.7186, 0.4502, -0.714, 0.7266), force (18.81)); float at most 1.1e+01 N (worst
 *    found 2.8e+00 at structure (0.5312, -0.6457, 0.505, 0.8972, 0.7094, 0.854), force
 *    (16.53)).
 *  Visits 3 subsets of the cables.
 *  Cost, all branches and steps: 21 add, 49 mul, 13 div, 5 sqrt, 15 compare, 44 select. */
tb_status tb_largest_tensions_eq12(const real_t structure[6], const real_t force[1],
    real_t tension[3]);

/** Least T_max with which every force of a size is feasible; exact for any number of cables
 *    (facets of {S T}, in place of Brau eq. 20).
 *  structure [-] (2 x 3), force [N] (scalar)  ->  tension [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: force in [0, 10000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: no tension is enough for every direction; 0.
 *  Error of tension: double at most 8.0e-05 N (worst found 2.0e-05 at structure (0, -0.9787, 1,
 *    0.9056, -0.05284, 0.05399), force (15.05)); float at most 5.1e+03 N (worst found 1.3e+03
 *    at structure (0.3575, -1, 1, 1, -0.006363, 0.006344), force (18.84)).
 *  Visits 3 subsets of the cables.
 *  Cost, all branches and steps: 45 add, 60 mul, 10 div, 5 sqrt, 27 compare, 32 select. */
tb_status tb_largest_tension(const real_t structure[6], const real_t force[1],
    real_t tension[1]);

#ifdef __cplusplus
}
#endif

#endif
