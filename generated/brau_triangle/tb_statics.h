/* Regenerate: turnbuckle generate machines/brau_triangle.toml --out <this folder>
 * Machine 62d2624dcb098eaa, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_STATICS_H
#define TB_STATICS_H

/* Forces between cables, platform and bases of brau_triangle. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Wrench of the cables on the platform W = S T  (Yoon eq. 7).
 *  structure [-] (2 x 3), tension [N] (3)  ->  wrench [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  Error of wrench: double at most 3.6e-14 N; float at most 2.1e-05 N.
 *  Cost, all branches: 4 add, 6 mul. */
tb_status tb_wrench(const real_t structure[6], const real_t tension[3], real_t wrench[2]);

/** L^2 S' (S L^2 S')^-1 W with L = diag(l_i): a solution of S T = W weighted by the lengths,
 *    but no tension: it may be negative, and is zero where W is  (Yoon eq. 10, to compare).
 *  pose [m] (2), rails [m] (0), wrench [N] (2)  ->  share [N] (3)
 *  Domain: pose with a sum of magnitudes of at most 4 m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 120000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of share: double at most 1.6e-13 N (worst found 4.1e-14 at pose (0.9648, 0.8401),
 *    wrench (-41.22, 28.73)); float at most 9.6e-05 N (worst found 2.4e-05 at pose (0.9541,
 *    0.8514), wrench (47.66, -41.52)).
 *  Cost, all branches: 25 add, 41 mul, 6 div, 3 sqrt, 5 compare, 1 select. */
tb_status tb_wrench_share_eq10(const real_t pose[2], const real_t rails[1],
    const real_t wrench[2], real_t share[3]);

#ifdef __cplusplus
}
#endif

#endif
