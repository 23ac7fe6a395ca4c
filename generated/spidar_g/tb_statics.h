/* Regenerate: turnbuckle generate machines/spidar_g.toml --out <this folder>
 * Machine 4d479a9b3a2bb17c, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_STATICS_H
#define TB_STATICS_H

/* Forces between cables, platform and bases of spidar_g. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Wrench of the cables on the platform W = S T  (Yoon eq. 7).
 *  structure [1, m] (6 x 8), tension [N] (8)  ->  wrench [N, N m] (6)
 *  Domain: structure with a sum of magnitudes of at most 192 1, m, else TB_OUT_OF_DOMAIN.
 *  Domain: tension with a sum of magnitudes of at most 64000 N, else TB_OUT_OF_DOMAIN.
 *  Error of wrench: double at most 3.5e-14 N, N m; float at most 1.9e-05 N, N m.
 *  Cost, all branches: 42 add, 48 mul. */
tb_status tb_wrench(const real_t structure[48], const real_t tension[8], real_t wrench[6]);

#ifdef __cplusplus
}
#endif

#endif
