/* Regenerate: turnbuckle generate machines/yoon_fixed_diagonal.toml --out <this folder>
 * Machine 7ea279c692dea1e9, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_STATICS_H
#define TB_STATICS_H

/* Forces between cables, platform and bases of yoon_fixed_diagonal. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Wrench of the cables on the platform W = S T  (Yoon eq. 7).
 *  structure [-] (2 x 4), tension [N] (4)  ->  wrench [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 40000 N, else TB_OUT_OF_DOMAIN.
 *  Error of wrench: double at most 1.9e-14 N; float at most 1.2e-05 N.
 *  Cost, all branches: 6 add, 8 mul. */
tb_status tb_wrench(const real_t structure[8], const real_t tension[4], real_t wrench[2]);

/** L^2 S' (S L^2 S')^-1 W with L = diag(l_i): a solution of S T = W weighted by the lengths,
 *    but no tension: it may be negative, and is zero where W is  (Yoon eq. 10, to compare).
 *  pose [m] (2), rails [m] (0), wrench [N] (2)  ->  share [N] (4)
 *  Domain: pose with a sum of magnitudes of at most 2.024 m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of share: double at most 7.0e-14 N (worst found 1.8e-14 at pose (9.13e-05, 0.2579),
 *    wrench (-26.19, -16.54)); float at most 4.1e-05 N (worst found 1.0e-05 at pose (0.005639,
 *    0.005797), wrench (21.49, -15.04)).
 *  Cost, all branches: 32 add, 46 mul, 7 div, 4 sqrt, 6 compare, 1 select. */
tb_status tb_wrench_share_eq10(const real_t pose[2], const real_t rails[1],
    const real_t wrench[2], real_t share[4]);

#ifdef __cplusplus
}
#endif

#endif
