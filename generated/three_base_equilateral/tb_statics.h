/* Regenerate: turnbuckle generate machines/three_base_equilateral.toml --out <this folder>
 * Machine bf852767ce09ae7f, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_STATICS_H
#define TB_STATICS_H

/* Forces between cables, platform and bases of three_base_equilateral. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Wrench of the cables on the platform W = S T  (Yoon eq. 7).
 *  structure [-] (2 x 3), tension [N] (3)  ->  wrench [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 30000 N, else TB_OUT_OF_DOMAIN.
 *  Error of wrench: double at most 2.0e-14 N; float at most 1.1e-05 N.
 *  Cost, all branches: 4 add, 6 mul. */
tb_status tb_wrench(const real_t structure[6], const real_t tension[3], real_t wrench[2]);

/** L^2 S' (S L^2 S')^-1 W with L = diag(l_i): a solution of S T = W weighted by the lengths,
 *    but no tension: it may be negative, and is zero where W is  (Yoon eq. 10, to compare).
 *  pose [m] (2), rails [m] (6), wrench [N] (2)  ->  share [N] (3)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of share: double at most 2.0e-05 N; float at most 2.2e+03 N.
 *  Cost, all branches: 30 add, 42 mul, 6 div, 3 sqrt, 5 compare, 1 select. */
tb_status tb_wrench_share_eq10(const real_t pose[2], const real_t rails[6],
    const real_t wrench[2], real_t share[3]);

/** Force of the cable on its base along the rail, -T_i lhat_i . e_i; the drive must hold it
 *    (Yoon eq. 8, the joint-space force of virtual work).
 *  pose [m] (2), rails [m] (6), tension [N] (3)  ->  force [N] (6)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 30000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of force: double at most 4.6e-12 N; float at most 1.2e-02 N.
 *  Cost, all branches: 15 add, 18 mul, 3 div, 3 sqrt, 3 compare. */
tb_status tb_rail_forces(const real_t pose[2], const real_t rails[6], const real_t tension[3],
    real_t force[6]);

#ifdef __cplusplus
}
#endif

#endif
