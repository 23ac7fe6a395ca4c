/* Regenerate: turnbuckle generate machines/yoon2023.toml --out generated/yoon2023
 * Machine 41fbf623dcdce700, generator 0.1.0, casadi 3.8.2. Do not edit. */
#ifndef TB_TENSION_H
#define TB_TENSION_H

/* Tension distribution of yoon2023. */

#include "tb_types.h"

/** Tensions of least norm within their bounds; an infeasible wrench keeps its direction and is
 *    scaled down to the largest fraction  (Yoon eq. 12).
 *  structure [1] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure in [-4, 4] 1, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench in [-40000, 40000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions are missed by more than rounding.
 *  TB_INFEASIBLE: no admissible tension exerts the wrench.
 *  Error of tension: double <= 1.3e-08 N (worst found 6.3e-09); float <= 8.1e-02 N (worst found
 *    4.1e-02).
 *  Error of delivered: double <= 4.5e-12 N (worst found 2.2e-12); float <= 4.3e-03 N (worst
 *    found 2.2e-03).
 *  Error of kkt_residual: double <= 4.5e-12 N (worst found 2.2e-12); float <= 2.4e-03 N (worst
 *    found 1.2e-03).
 *  Cost, all branches: 248 add, 252 mul, 24 div, 4 sqrt, 95 compare, 231 select. */
tb_status tb_distribute_tension_scale(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench is replaced by the nearest
 *    feasible one  (Yoon eq. 12).
 *  structure [1] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure in [-4, 4] 1, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench in [-40000, 40000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions are missed by more than rounding.
 *  TB_INFEASIBLE: no admissible tension exerts the wrench.
 *  Error of tension: double <= 5.9e-09 N (worst found 2.9e-09); float <= 8.2e-01 N (worst found
 *    4.1e-01).
 *  Error of delivered: double <= 4.5e-12 N (worst found 2.3e-12); float <= 2.4e-03 N (worst
 *    found 1.2e-03).
 *  Error of kkt_residual: double <= 4.5e-12 N (worst found 2.3e-12); float <= 2.4e-03 N (worst
 *    found 1.2e-03).
 *  Cost, all branches: 239 add, 242 mul, 20 div, 4 sqrt, 89 compare, 206 select. */
tb_status tb_distribute_tension_closest(const real_t structure[8], const real_t wrench[2],
    real_t tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm above T_min, then no upper bound while solving, then clipped to T_max
 *    (the wrench is not kept)  (Yoon eq. 22, 23).
 *  structure [1] (2 x 4), wrench [N] (2)  ->  tension [N] (4), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure in [-4, 4] 1, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench in [-40000, 40000] N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: the optimality conditions are missed by more than rounding.
 *  TB_INFEASIBLE: a tension was clipped, or eq. 22 has no solution and every cable holds T_min.
 *  Error of tension: double <= 3.6e-12 N (worst found 1.8e-12); float <= 2.8e-03 N (worst found
 *    1.4e-03).
 *  Error of delivered: double <= 3.4e-12 N (worst found 1.7e-12); float <= 2.8e-03 N (worst
 *    found 1.4e-03).
 *  Error of kkt_residual: double <= 2.2e-11 N (worst found 1.1e-11); float <= 8.8e-03 N (worst
 *    found 4.4e-03).
 *  Cost, all branches: 193 add, 198 mul, 16 div, 4 sqrt, 97 compare, 175 select. */
tb_status tb_distribute_tension_paper(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

/** What the machine file chooses for an infeasible wrench: tb_distribute_tension_scale. */
tb_status tb_distribute_tension(const real_t structure[8], const real_t wrench[2], real_t
    tension[4], real_t delivered[2], real_t kkt_residual[1]);

#endif
