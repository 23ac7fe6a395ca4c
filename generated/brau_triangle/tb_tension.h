/* Regenerate: turnbuckle generate machines/brau_triangle.toml --out <this folder>
 * Machine 62d2624dcb098eaa, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_TENSION_H
#define TB_TENSION_H

/* Tension distribution of brau_triangle. Results are written last, so an array may be argument and result at once. */

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Tensions of least norm within their bounds that exert a wrench  (Yoon eq. 12).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  tension [N] (3), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 120000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  Error of tension: double at most 2.1e-12 N (worst found 5.4e-13 at structure (-0.745,
 *    0.5021, -0.4956, -0.667, -0.8648, 0.8686), wrench (6.193, -10.6)); float at most 1.5e-03 N
 *    (worst found 3.7e-04 at structure (-0.7846, 0.4892, -0.4571, -0.6211, -0.8825, 0.793),
 *    wrench (-10.74, -21.64)).
 *  Error of delivered: double at most 1.2e-13 N (worst found 3.1e-14 at structure (-0.8734,
 *    0.08911, -1, -0.569, -0.9999, 0.3464), wrench (-34.58, -18.15)); float at most 5.6e-05 N
 *    (worst found 1.4e-05 at structure (-0.6594, 0.2806, -0.999, -0.7518, -0.9598, 0.04358),
 *    wrench (-23.23, -26.78)).
 *  Error of kkt_residual: double at most 1.0e-13 N (worst found 2.5e-14 at structure (-0.5845,
 *    0.3983, -0.751, -0.8114, -0.8292, 0), wrench (-20.28, -28.88)); float at most 5.3e-05 N
 *    (worst found 1.3e-05 at structure (-0.2747, 0.7849, 1, -1, -0.6196, 0.4372), wrench (10.6,
 *    -30.16)).
 *  Cost, all branches: 46 add, 56 mul, 8 div, 2 sqrt, 6 compare, 29 select. */
tb_status tb_least_norm_tension(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1]);

/** The wrench that is served: an infeasible one keeps its direction and is scaled down to the
 *    largest feasible fraction  (facets of the zonotope {S T}).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  served [N] (2), inner [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 120000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 3.5e-12 N (worst found 8.8e-13 at structure (-0.3555,
 *    0.8346, 0.6622, -0.9347, -0.5497, 0.745), wrench (-9.651, -24.95)); float at most 1.7e-03
 *    N (worst found 4.3e-04 at structure (-0.2766, 0.905, 0.4932, -0.8637, -0.4367, 0.8263),
 *    wrench (-10.9, -33.48)).
 *  Error of inner: double at most 3.5e-12 N (worst found 8.8e-13 at structure (-0.3555, 0.8346,
 *    0.6622, -0.9347, -0.5497, 0.745), wrench (-9.651, -24.95)); float at most 1.7e-03 N (worst
 *    found 4.3e-04 at structure (-0.2766, 0.905, 0.4932, -0.8637, -0.4367, 0.8263), wrench
 *    (-10.9, -33.48)).
 *  Cost, all branches: 86 add, 86 mul, 6 div, 31 compare, 61 select. */
tb_status tb_served_wrench_scale(const real_t structure[6], const real_t wrench[2],
    real_t served[2], real_t inner[2]);

/** The wrench that is served: an infeasible one is replaced by the nearest feasible one
 *    (facets of the zonotope {S T}).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  served [N] (2), inner [N] (2)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 120000 N, else TB_OUT_OF_DOMAIN.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of served: double at most 5.4e-14 N (worst found 1.3e-14 at structure (-0.7757, 0,
 *    -0.9964, -0.6333, -1, 0.1008), wrench (-35.79, -35.69)); float at most 2.7e-05 N (worst
 *    found 6.7e-06 at structure (-0.001554, 0.8722, 0.8288, -1, -0.4781, 0.5503), wrench
 *    (34.46, -22.43)).
 *  Error of inner: double at most 5.8e-14 N (worst found 1.4e-14 at structure (-0.01531,
 *    0.8889, 0.9759, -0.9238, -0.6021, 0.2212), wrench (39.01, -15.89)); float at most 3.4e-05
 *    N (worst found 8.6e-06 at structure (-0.5477, 0.3278, -0.9938, -0.7989, -0.9428, 0.1075),
 *    wrench (-23.15, -34.31)).
 *  Cost, all branches: 62 add, 62 mul, 3 div, 24 compare, 31 select. */
tb_status tb_served_wrench_closest(const real_t structure[6], const real_t wrench[2],
    real_t served[2], real_t inner[2]);

/** Tensions of least norm above T_min, then clipped to T_max, which changes the wrench  (Yoon
 *    eq. 22, 23).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  tension [N] (3), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 120000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INFEASIBLE: eq. 22 has no solution, and every cable holds T_min.
 *  TB_INFEASIBLE: eq. 23 clipped a tension.
 *  Error of tension: double at most 6.6e-12 N (worst found 1.6e-12 at structure (-0.3853,
 *    0.5447, 0.4353, -0.7922, -0.9078, 0.9179), wrench (-8.915, -18.05)); float at most 1.1e-03
 *    N (worst found 2.8e-04 at structure (-0.5049, 1, 0.4973, -0.8086, -0.3467, 0.8676), wrench
 *    (-21.21, -32.57)).
 *  Error of delivered: double at most 6.0e-12 N (worst found 1.5e-12 at structure (-0.3853,
 *    0.5447, 0.4353, -0.7922, -0.9078, 0.9179), wrench (-8.915, -18.05)); float at most 9.7e-04
 *    N (worst found 2.4e-04 at structure (-0.5049, 1, 0.4973, -0.8086, -0.3467, 0.8676), wrench
 *    (-21.21, -32.57)).
 *  Error of kkt_residual: double at most 9.1e-08 N (worst found 2.3e-08 at structure (-0.9587,
 *    0.9783, -0.2995, -6.428e-07, -0, 0.883), wrench (22, -40.02)); float at most 7.9e-02 N
 *    (worst found 2.0e-02 at structure (-0.5013, 0.8658, 0.4987, -0.8623, -0.5008, 0.8581),
 *    wrench (-28.3, 13.98)).
 *  Cost, all branches: 51 add, 64 mul, 8 div, 2 sqrt, 9 compare, 40 select. */
tb_status tb_distribute_tension_paper(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench keeps its direction and is
 *    scaled down to the largest feasible fraction  (Yoon eq. 12).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  tension [N] (3), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 120000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 2.5e-09 N (worst found 6.3e-10 at structure (-0.8863,
 *    0.5458, -0.4997, -0.001818, -0.8761, 0.8022), wrench (-20.32, -3.105)); float at most
 *    5.2e-01 N (worst found 1.3e-01 at structure (-0.9488, 0.9933, -0.797, -6.046e-06, -0,
 *    0.8212), wrench (7.618, -12.82)).
 *  Error of delivered: double at most 4.4e-12 N (worst found 1.1e-12 at structure (-0.9177, 0,
 *    -0.7476, -0.3974, -1, 0.6547), wrench (-45.45, 40)); float at most 2.6e-01 N (worst found
 *    6.4e-02 at structure (-0.5297, 0.904, 0.5337, -0.8481, -0.7686, 0.8318), wrench (-4.762,
 *    -7.623)).
 *  Error of kkt_residual: double at most 9.7e-14 N (worst found 2.4e-14 at structure (-0.9823,
 *    0.4819, -0.5047, -0.2274, -0.8647, 0.9006), wrench (-28.21, -20.81)); float at most
 *    4.8e-05 N (worst found 1.2e-05 at structure (-0.5727, 0.8773, 0.628, -0.9095, -0.7773,
 *    0.9068), wrench (12.59, -40)).
 *  Cost, all branches: 224 add, 254 mul, 30 div, 6 sqrt, 49 compare, 148 select. */
tb_status tb_distribute_tension_scale(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1]);

/** Tensions of least norm within their bounds; an infeasible wrench is replaced by the nearest
 *    feasible one  (Yoon eq. 12).
 *  structure [-] (2 x 3), wrench [N] (2)  ->  tension [N] (3), delivered [N] (2), kkt_residual
 *    [N] (scalar)
 *  Domain: structure with a sum of magnitudes of at most 24, else TB_OUT_OF_DOMAIN.
 *  Domain: wrench with a sum of magnitudes of at most 120000 N, else TB_OUT_OF_DOMAIN.
 *  TB_SINGULAR: the cables are parallel.
 *  TB_INACCURATE: no admissible tension exerts the wrench, or the optimality conditions are
 *    missed.
 *  TB_INFEASIBLE: no admissible tension exerts it.
 *  Error of tension: double at most 2.0e-08 N (worst found 4.9e-09 at structure (-0.4932,
 *    0.6866, 0.541, -0.8717, -0.7241, 0.9561), wrench (17.25, -21.11)); float at most 1.3e+00 N
 *    (worst found 3.3e-01 at structure (-0.801, 0.5913, -0.5221, -0.2239, -0.9652, 0.8522),
 *    wrench (-25.09, -26)).
 *  Error of delivered: double at most 1.4e-13 N (worst found 3.4e-14 at structure (-0.8935,
 *    0.5271, -0.5422, -0.6908, -0.8843, 0.8402), wrench (-11.2, -30.57)); float at most 6.2e-05
 *    N (worst found 1.6e-05 at structure (-0.4963, 0.9161, 0.531, -0.943, -0.3954, 0.8644),
 *    wrench (23.06, -26.63)).
 *  Error of kkt_residual: double at most 1.3e-13 N (worst found 3.4e-14 at structure (-0.5652,
 *    0.4251, -1, -0.825, -0.9052, 0), wrench (-14.39, -38.44)); float at most 5.4e-05 N (worst
 *    found 1.3e-05 at structure (-0.9427, 0.4797, -0.5358, -0.3365, -0.8835, 0.9726), wrench
 *    (-40.06, -10.59)).
 *  Cost, all branches: 200 add, 230 mul, 27 div, 6 sqrt, 42 compare, 118 select. */
tb_status tb_distribute_tension_closest(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1]);

/** What the machine file chooses for an infeasible wrench: tb_distribute_tension_closest. */
tb_status tb_distribute_tension(const real_t structure[6], const real_t wrench[2],
    real_t tension[3], real_t delivered[2], real_t kkt_residual[1]);

#ifdef __cplusplus
}
#endif

#endif
