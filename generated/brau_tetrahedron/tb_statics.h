/* Regenerate: turnbuckle generate machines/brau_tetrahedron.toml --out <this folder>
 * Machine 1c3579fddb96c4cf, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_STATICS_H
#define TB_STATICS_H

/* Forces between cables, platform and bases of brau_tetrahedron. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Wrench of the cables on the platform W = S T  (Yoon eq. 7).
 *  structure [-] (3 x 4), tension [N] (4)  ->  wrench [N] (3)
 *  Domain: structure with a sum of magnitudes of at most 48, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 80000 N, else TB_OUT_OF_DOMAIN.
 *  Error of wrench: double at most 4.4e-14 N; float at most 2.2e-05 N.
 *  Cost, all branches: 9 add, 12 mul. */
tb_status tb_wrench(const real_t structure[12], const real_t tension[4], real_t wrench[3]);

#ifdef __cplusplus
}
#endif

#endif
