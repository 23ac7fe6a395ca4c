/* Regenerate: turnbuckle generate machines/yoon_synchronised.toml --out <this folder>
 * Machine 2674137f8fc00ebb, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_STATICS_H
#define TB_STATICS_H

/* Forces between cables, platform and bases of yoon_synchronised. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Wrench of the cables on the platform W = S T  (Yoon eq. 7).
 *  structure [-] (2 x 4), tension [N] (4)  ->  wrench [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 32, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 40000 N, else TB_OUT_OF_DOMAIN.
 *  Error of wrench: double at most 2.4e-14 N; float at most 1.5e-05 N.
 *  Cost, all branches: 6 add, 8 mul. */
tb_status tb_wrench(const real_t structure[8], const real_t tension[4], real_t wrench[2]);

/** L^2 S' (S L^2 S')^-1 W with L = diag(l_i): a solution of S T = W weighted by the lengths,
 *    but no tension: it may be negative, and is zero where W is  (Yoon eq. 10, to compare).
 *  pose [m] (2), rails [m] (2), wrench [N] (2)  ->  share [N] (4)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  TB_SINGULAR: the cables are parallel.
 *  Error of share: double at most 1.4e-13 N (worst found 3.4e-14 at pose (0.6702, 0.4334),
 *    rails (0.04879, 0.3309), wrench (-4.124, -27.6)); float at most 8.3e-05 N (worst found
 *    2.1e-05 at pose (0.01676, 0.441), rails (0.7118, 0.2954), wrench (-19.95, -21.01)).
 *  Cost, all branches: 34 add, 49 mul, 7 div, 4 sqrt, 6 compare, 1 select. */
tb_status tb_wrench_share_eq10(const real_t pose[2], const real_t rails[2],
    const real_t wrench[2], real_t share[4]);

/** Force of the cable on its base along the rail, -T_i lhat_i . e_i; the drive must hold it
 *    (Yoon eq. 8, the joint-space force of virtual work).
 *  pose [m] (2), rails [m] (2), tension [N] (4)  ->  force [N] (2)
 *  Domain: pose with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: rails with a sum of magnitudes of at most 2.8472 m, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 40000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the platform is nearer than 0.1 mm to a pulley.
 *  Error of force: double at most 2.0e-14 N (worst found 5.1e-15 at pose (0.009974, 0.2218),
 *    rails (0.5503, 0.2302), tension (9.388, 8.09, 9.994, 6.209)); float at most 1.5e-03 N
 *    (worst found 3.8e-04 at pose (0.3554, 0.4617), rails (0.3554, 0.3401), tension (6.874,
 *    6.351, 9.963, 9.968)).
 *  Cost, all branches: 12 add, 10 mul, 4 div, 4 sqrt, 4 compare. */
tb_status tb_rail_forces(const real_t pose[2], const real_t rails[2], const real_t tension[4],
    real_t force[2]);

#ifdef __cplusplus
}
#endif

#endif
