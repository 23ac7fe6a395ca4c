/* Regenerate: turnbuckle generate machines/yoon2023.toml --out <this folder>
 * Machine 499338192b9e5092, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_STATICS_H
#define TB_STATICS_H

/* Forces between cables, platform and bases of yoon2023. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Wrench of the cables on the platform W = S T  (Yoon eq. 7).
 *  structure [-] (2 x 4), tension [N] (4)  ->  wrench [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 40000 N, else TB_OUT_OF_DOMAIN.
 *  Error of wrench: double at most 2.5e-14 N; float at most 1.4e-05 N.
 *  Cost, all branches: 6 add, 8 mul. */
tb_status tb_wrench(const real_t structure[8], const real_t tension[4], real_t wrench[2]);

/** L^2 S' (S L^2 S')^-1 W with L = diag(l_i): a solution of S T = W weighted by the lengths,
 *    but no tension: it may be negative, and is zero where W is  (Yoon eq. 10, to compare).
 *  pose [m] (2), rails [m] (4), wrench [N] (2)  ->  share [N] (4)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of share: double at most 4.4e-11 N (worst found 1.1e-11 at pose (0.5327, 0.1146),
 *    rails (0.7011, 0.02011, 0.002247, 0.4147), wrench (-12.49, -8.114)); float at most 2.1e-02
 *    N (worst found 5.2e-03 at pose (0.008391, 0.004153), rails (0.01879, 0.4219, 0.7118,
 *    0.03505), wrench (12.43, -6.245)).
 *  Cost, all branches: 36 add, 53 mul, 7 div, 4 sqrt, 6 compare, 1 select. */
tb_status tb_wrench_share_eq10(const real_t pose[2], const real_t rails[4],
    const real_t wrench[2], real_t share[4]);

/** Force of the cable on its base along the rail, -T_i lhat_i . e_i; the drive must hold it
 *    (Yoon eq. 8, the joint-space force of virtual work).
 *  pose [m] (2), rails [m] (4), tension [N] (4)  ->  force [N] (4)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 5.6944 m, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 40000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of force: double at most 1.1e-14 N; float at most 3.1e-04 N.
 *  Cost, all branches: 14 add, 12 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_rail_forces(const real_t pose[2], const real_t rails[4], const real_t tension[4],
    real_t force[4]);

#ifdef __cplusplus
}
#endif

#endif
