/* Regenerate: turnbuckle generate machines/three_base_equilateral.toml --out <this folder>
 * Machine bf852767ce09ae7f, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_TENSION_H
#define TB_TENSION_H

/* Tension distribution of three_base_equilateral. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Tensions of least norm within their bounds that exert a wrench  (Yoon eq. 12).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  tension [N] (3), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 1.0e-11 N (worst found 2.5e-12 at structure (0.002521, 0,
 *    0.9986, 1, 0.9786, 0.182), wrench (10.01, 14.67)); float at most 2.4e-03 N (worst found
 *    5.9e-04 at structure (0.002521, 0, 0.9989, 1, 0.9786, 0.1852), wrench (10.01, 14.67)).
 *  Error of delivered: double at most 6.6e-14 N (worst found 1.7e-14 at structure (0.28,
 *    -0.8293, 0.9584, 0.9994, 0.4823, 0.2646), wrench (5.279, 16.6)); float at most 3.3e-05 N
 *    (worst found 8.2e-06 at structure (0.3858, -0.2494, 1, 1, 0.9404, -0.1722), wrench (7.679,
 *    16.56)).
 *  Error of kkt_residual: double at most 6.1e-14 N (worst found 1.5e-14 at structure (0.8095,
 *    0.9199, 0.9968, 0.5799, 0.5661, 0.1537), wrench (22.9, 9.941)); float at most 3.3e-05 N
 *    (worst found 8.2e-06 at structure (0.3858, -0.2494, 1, 1, 0.9404, -0.1722), wrench (7.679,
 *    16.56)).
 *  Cost, all branches: 49 add, 56 mul, 8 div, 2 sqrt, 6 compare, 29 select. */
tb_status tb_least_norm_tension(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1]);

/** The wrench that is served: an infeasible one keeps its direction and is scaled down to the
 *    largest feasible fraction  (facets of the zonotope {S T}).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  served [N] (2), inner [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 3.9e-13 N (worst found 9.7e-14 at structure (-0.7788,
 *    -0.973, 0.9077, 0.6787, 0.3117, 0.8455), wrench (-16.62, 13.85)); float at most 1.3e-04 N
 *    (worst found 3.2e-05 at structure (-0.6764, -0.7826, -0.2243, -0.3475, -0.7706, -0.9724),
 *    wrench (-20.43, -18.82)).
 *  Error of inner: double at most 3.9e-13 N (worst found 9.7e-14 at structure (-0.7788, -0.973,
 *    0.9077, 0.6787, 0.3117, 0.8455), wrench (-16.62, 13.85)); float at most 1.3e-04 N (worst
 *    found 3.2e-05 at structure (-0.6764, -0.7826, -0.2243, -0.3475, -0.7706, -0.9724), wrench
 *    (-20.43, -18.82)).
 *  Cost, all branches: 86 add, 92 mul, 6 div, 31 compare, 55 select. */
tb_status tb_served_wrench_scale(const real_t structure[6], const real_t wrench[2],
    real_t served[2], real_t inner[2]);

/** The wrench that is served: an infeasible one is replaced by the nearest feasible one
 *    (facets of the zonotope {S T}).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  served [N] (2), inner [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 2.9e-14 N (worst found 7.2e-15 at structure (0.07868,
 *    -0.7961, 0.8206, 0.9999, 0.6198, 0.8854), wrench (-3.829, 32.6)); float at most 4.5e-03 N
 *    (worst found 1.1e-03 at structure (1, -0.06833, 0.9993, -0.1513, -1, 0.08945), wrench
 *    (28.25, -11.23)).
 *  Error of inner: double at most 3.3e-14 N (worst found 8.2e-15 at structure (0.07868,
 *    -0.7961, 0.8206, 0.9999, 0.6198, 0.8854), wrench (-3.829, 32.6)); float at most 4.5e-03 N
 *    (worst found 1.1e-03 at structure (1, -0.06833, 0.9993, -0.1513, -1, 0.08945), wrench
 *    (28.25, -11.23)).
 *  Cost, all branches: 62 add, 68 mul, 3 div, 24 compare, 25 select. */
tb_status tb_served_wrench_closest(const real_t structure[6], const real_t wrench[2],
    real_t served[2], real_t inner[2]);

/** Tensions of least norm above T_min, then clipped to T_max, which changes the wrench  (Yoon
 *    eq. 22, 23).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  tension [N] (3), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: eq. 22 has no solution, and every cable holds T_min.
 *  TB_INFEASIBLE: eq. 23 clipped a tension.
 *  Error of tension: double at most 3.0e-13 N (worst found 7.4e-14 at structure (-0.9123,
 *    -0.975, 0.8723, 0.4109, 0.568, -0.6267), wrench (-20, -28.53)); float at most 6.4e-04 N
 *    (worst found 1.6e-04 at structure (-0.04812, -1, 0.9785, 1, -0.005081, -0.0008894), wrench
 *    (-4.481, 2.945)).
 *  Error of delivered: double at most 2.8e-13 N (worst found 7.1e-14 at structure (-0.9123,
 *    -0.975, 0.8723, 0.4109, 0.568, -0.6267), wrench (-20, -28.53)); float at most 6.3e-04 N
 *    (worst found 1.6e-04 at structure (-0.01813, -1, 1, 1, -0.005081, -0.0008894), wrench
 *    (-5.986, 2.945)).
 *  Error of kkt_residual: double at most 6.0e-09 N (worst found 1.5e-09 at structure (-0.08754,
 *    -0.998, 0.9332, 0.975, 0.008966, -0.008385), wrench (4.529, -11.87)); float at most
 *    3.5e-02 N (worst found 8.8e-03 at structure (0.3873, -0.9789, 0.9451, 0.9971, 0.2831,
 *    -0.2734), wrench (-1.767, 0)).
 *  Cost, all branches: 55 add, 64 mul, 8 div, 2 sqrt, 9 compare, 38 select. */
tb_status tb_distribute_tension_paper(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench keeps its direction and is
 *    scaled down to the largest feasible fraction  (Yoon eq. 12).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  tension [N] (3), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 2.4e-09 N (worst found 6.1e-10 at structure (0.997, 0.1518,
 *    0.8545, -0.02285, -1, -0.01959), wrench (11.72, -19.65)); float at most 6.5e-01 N (worst
 *    found 1.6e-01 at structure (0.895, -0.9714, 1, 0.9193, 0.1004, -0.1034), wrench (1.971,
 *    -8.67)).
 *  Error of delivered: double at most 1.1e-13 N (worst found 2.8e-14 at structure (-0.6806,
 *    -0.7604, 0.7067, 0.7327, 0.6514, -0.7236), wrench (-5.621, 20.07)); float at most 3.8e-03
 *    N (worst found 9.5e-04 at structure (0.5679, -0.5915, 0.6718, 0.5891, -0.5721, -0.727),
 *    wrench (-0.1631, -0)).
 *  Error of kkt_residual: double at most 1.1e-13 N (worst found 2.7e-14 at structure (-0.6806,
 *    -0.7604, 0.7067, 0.7327, 0.6514, -0.7236), wrench (-5.621, 20.07)); float at most 2.1e-04
 *    N (worst found 5.4e-05 at structure (0.4841, 0.6631, 0.693, -0.7661, -0.9662, -1), wrench
 *    (14.1, -29.06)).
 *  Cost, all branches: 233 add, 260 mul, 30 div, 6 sqrt, 49 compare, 142 select. */
tb_status tb_distribute_tension_scale(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench is replaced by the nearest
 *    feasible one  (Yoon eq. 12).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  tension [N] (3), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 60000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 1.4e-08 N (worst found 3.6e-09 at structure (0.7242,
 *    0.001048, 0.9655, -0.1771, -0.9986, -0.2362), wrench (10.74, -16.52)); float at most
 *    4.7e-01 N (worst found 1.2e-01 at structure (-0.1498, -0.8708, -0.15, 0.9874, 0.5185,
 *    0.9885), wrench (-3.667, 14.3)).
 *  Error of delivered: double at most 4.0e-12 N (worst found 1.0e-12 at structure (0.6446,
 *    0.6633, 0.6886, -0.7661, -0.6926, -0.7162), wrench (15.96, -23.51)); float at most 8.3e-03
 *    N (worst found 2.1e-03 at structure (-0.1464, -0.154, 1, 0.9919, 0.9881, 0.5943), wrench
 *    (13.08, 19.61)).
 *  Error of kkt_residual: double at most 4.0e-12 N (worst found 1.0e-12 at structure (0.6446,
 *    0.6633, 0.6886, -0.7661, -0.6926, -0.7162), wrench (15.96, -23.51)); float at most 3.3e-04
 *    N (worst found 8.3e-05 at structure (0.9941, -0.9432, 0.9916, 0.1088, -0.1136, 0.1128),
 *    wrench (20.45, -10.69)).
 *  Cost, all branches: 209 add, 236 mul, 27 div, 6 sqrt, 42 compare, 112 select. */
tb_status tb_distribute_tension_closest(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1]);

/** What the machine file chooses for an infeasible wrench: tb_distribute_tension_scale. */
tb_status tb_distribute_tension(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1]);

#ifdef __cplusplus
}
#endif

#endif
