/* Regenerate: turnbuckle generate machines/brau_five.toml --out <this folder>
 * Machine b614899c8a021831, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_STATICS_H
#define TB_STATICS_H

/* Forces between cables, platform and bases of brau_five. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Wrench of the cables on the platform W = S T  (Yoon eq. 7).
 *  structure [-] (2 x 5), tension [N] (5)  ->  wrench [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 40, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 50000 N, else TB_OUT_OF_DOMAIN.
 *  Error of wrench: double at most 3.2e-14 N; float at most 1.4e-05 N.
 *  Cost, all branches: 8 add, 10 mul. */
tb_status tb_wrench(const real_t structure[10], const real_t tension[5], real_t wrench[2]);

/** L^2 S' (S L^2 S')^-1 W with L = diag(l_i): a solution of S T = W weighted by the lengths,
 *    but no tension: it may be negative, and is zero where W is  (Yoon eq. 10, to compare).
 *  pose [m] (2), rails [m] (0), wrench [N] (2)  ->  share [N] (5)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 100000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of share: double at most 6.0e-14 N (worst found 1.5e-14 at pose (0.1076, 0.02613),
 *    wrench (-29.11, 20.24)); float at most 4.2e-05 N (worst found 1.1e-05 at pose (0.009545,
 *    0.01564), wrench (24.99, -23.68)).
 *  Cost, all branches: 41 add, 55 mul, 8 div, 5 sqrt, 7 compare, 1 select. */
tb_status tb_wrench_share_eq10(const real_t pose[2], const real_t rails[1],
    const real_t wrench[2], real_t share[5]);

#ifdef __cplusplus
}
#endif

#endif
