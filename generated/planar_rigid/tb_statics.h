/* Regenerate: turnbuckle generate machines/planar_rigid.toml --out <this folder>
 * Machine 95fa38e7104ced7a, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_STATICS_H
#define TB_STATICS_H

/* Forces between cables, platform and bases of planar_rigid. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Wrench of the cables on the platform W = S T  (Yoon eq. 7).
 *  structure [1, m] (3 x 6), tension [N] (6)  ->  wrench [N, N m] (3)
 *  Domain: structure with a sum of magnitudes of at most 72 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  Error of wrench: double at most 4.9e-14 N, N m; float at most 2.6e-05 N, N m.
 *  Cost, all branches: 15 add, 18 mul. */
tb_status tb_wrench(const real_t structure[18], const real_t tension[6], real_t wrench[3]);

/** L^2 S' (S L^2 S')^-1 W with L = diag(l_i): a solution of S T = W weighted by the lengths,
 *    but no tension: it may be negative, and is zero where W is  (Yoon eq. 10, to compare).
 *  pose [m, rad] (3), rails [m] (6), wrench [N, N m] (3)  ->  share [N] (6)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 180000 N, N m, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables pull in fewer than 3 directions.
 *  Error of share: double at most 1.0e-09 N; float at most 9.8e-02 N.
 *  Cost, all branches: 155 add, 210 mul, 11 div, 6 sqrt, 9 compare, 1 select. */
tb_status tb_wrench_share_eq10(const real_t pose[3], const real_t rails[6],
    const real_t wrench[3], real_t share[6]);

/** Force of the cable on its base along the rail, -T_i lhat_i . e_i; the drive must hold it
 *    (Yoon eq. 8, the joint-space force of virtual work).
 *  pose [m, rad] (3), rails [m] (6), tension [N] (6)  ->  force [N] (6)
 *  Domain: pose in [-1.4236, 1.4236] x [-1.4236, 1.4236] x [-1.2854, 1.2854] m, rad, else
 *    TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 8.5416 m, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of force: double at most 7.9e-12 N; float at most 7.2e-03 N.
 *  Cost, all branches: 69 add, 65 mul, 6 div, 6 sqrt, 6 compare. */
tb_status tb_rail_forces(const real_t pose[3], const real_t rails[6], const real_t tension[6],
    real_t force[6]);

#ifdef __cplusplus
}
#endif

#endif
