/* Regenerate: turnbuckle generate machines/brau_tetrahedron.toml --out <this folder>
 * Machine 1c3579fddb96c4cf, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#include "tb_comparison.h"
#include "tb_machine.h"

/* Refuses with a status: tension is 0 N. */
static tb_status tb_refuse_kernel_tension(tb_status status, real_t tension[4])
{
    tension[0] = TB_C(0.0);
    tension[1] = TB_C(0.0);
    tension[2] = TB_C(0.0);
    tension[3] = TB_C(0.0);
    return status;
}

tb_status tb_kernel_tension(const real_t structure[12], const real_t wrench[3],
    real_t tension[4])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) <= TB_C(48.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) <= TB_C(240000.0))) {
        return tb_refuse_kernel_tension(TB_OUT_OF_DOMAIN, tension);
    }
    const real_t t0 = TB_C(64.0) * TB_EPSILON;
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = TB_SQRT(t2);
    const real_t t4 = TB_COPYSIGN(t3, structure[0]);
    const real_t t5 = structure[0] + t4;
    const real_t t6 = t5 * structure[8] + structure[1] * structure[9] + structure[2] *
        structure[10];
    const real_t t7 = TB_C(1.0) / (t3 * (t3 + TB_ABS(structure[0])));
    const real_t t8 = (t6 + structure[3] * structure[11]) * t7;
    const real_t t9 = structure[11] - structure[3] * t8;
    const real_t t10 = t5 * structure[4] + structure[1] * structure[5] + structure[2] *
        structure[6];
    const real_t t11 = t7 * (t10 + structure[3] * structure[7]);
    const real_t t12 = structure[5] - structure[1] * t11;
    const real_t t13 = structure[6] - structure[2] * t11;
    const real_t t14 = structure[7] - structure[3] * t11;
    const real_t t15 = TB_SQRT(t12 * t12 + t13 * t13 + t14 * t14);
    const real_t t16 = TB_COPYSIGN(t15, t12);
    const real_t t17 = t12 + t16;
    const real_t t18 = structure[9] - structure[1] * t8;
    const real_t t19 = structure[10] - structure[2] * t8;
    const real_t t20 = TB_C(1.0) / (t15 * (t15 + TB_ABS(t12)));
    const real_t t21 = (t17 * t18 + t13 * t19 + t9 * t14) * t20;
    const real_t t22 = t9 - t14 * t21;
    const real_t t23 = t19 - t13 * t21;
    const real_t t24 = TB_SQRT(t23 * t23 + t22 * t22);
    const real_t t25 = TB_C(1.0) / (t24 * (t24 + TB_ABS(t23)));
    const real_t t26 = t22 * t25;
    const real_t t27 = TB_C(1.0) - t22 * t26;
    const real_t t28 = TB_COPYSIGN(t24, t23);
    const real_t t29 = t23 + t28;
    const real_t t30 = t26 * t29;
    const real_t t31 = t20 * (t14 * t27 - t13 * t30);
    const real_t t32 = t27 - t14 * t31;
    const real_t t33 = t17 * t31;
    const real_t t34 = t30 + t13 * t31;
    const real_t t35 = structure[3] * t32 - (structure[1] * t33 + structure[2] * t34);
    const real_t t36 = t7 * t35;
    const real_t t37 = t5 * t36;
    const real_t t38 = TB_COPYSIGN(TB_C(1.0), -t37);
    const real_t t39 = t37 * t38;
    const real_t t40 = t38 * (t33 + structure[1] * t36);
    const real_t t41 = t38 * (t34 + structure[2] * t36);
    const real_t t42 = t38 * (t32 - structure[3] * t36);
    const bool t43 = t0 < -t39 && t0 < -t40 && t0 < -t41 && t0 < t42;
    real_t tension_0, tension_1, tension_2, tension_3;
    if (t43) {
        const real_t t44 = wrench[0] / t4;
        const real_t t45 = (wrench[1] + t44 * (structure[4] - t5 * t11)) / t16;
        const real_t t46 = wrench[2] + t44 * (structure[8] - t5 * t8) + (t18 - t17 * t21) * t45;
        const real_t t47 = t46 / t28;
        const real_t t48 = t25 * (t29 * t47);
        const real_t t49 = t29 * t48 - t47;
        const real_t t50 = t22 * t48;
        const real_t t51 = t20 * (t13 * t49 - t17 * t45 + t14 * t50);
        const real_t t52 = t49 - t13 * t51;
        const real_t t53 = t45 + t17 * t51;
        const real_t t54 = structure[2] * t52 - (t5 * t44 + structure[1] * t53);
        const real_t t55 = t50 - t14 * t51;
        const real_t t56 = t7 * (t54 + structure[3] * t55);
        const real_t t57 = t44 + t5 * t56;
        const real_t t58 = t53 + structure[1] * t56;
        const real_t t59 = t52 - structure[2] * t56;
        const real_t t60 = tb_max(tb_max(-(t57 / t39), -(t58 / t40)), t59 / t41);
        const real_t t61 = t55 - structure[3] * t56;
        const real_t t62 = tb_max(t60, -(t61 / t42));
        tension_0 = tb_max(-(t57 + t39 * t62), TB_C(0.0));
        tension_1 = tb_max(-(t58 + t40 * t62), TB_C(0.0));
        tension_2 = tb_max(t59 - t41 * t62, TB_C(0.0));
        tension_3 = tb_max(t61 + t42 * t62, TB_C(0.0));
    } else {
        tension_0 = TB_C(0.0);
        tension_1 = TB_C(0.0);
        tension_2 = TB_C(0.0);
        tension_3 = TB_C(0.0);
    }
    const real_t t63 = tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const bool t64 = t63 < TB_ABS(t4) && t63 < TB_ABS(t16) && t63 < TB_ABS(t28);
    const bool t65 = !t64;
    const bool t66 = !t43;
    if (t65) {
        return tb_refuse_kernel_tension(TB_SINGULAR, tension);
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    return t66 ? TB_INFEASIBLE : TB_OK;
}

/* Before the first subset. */
static tb_status tb_reduced_matrix_tension_begin(const real_t structure[12], const real_t wrench[3],
    real_t rest[3], real_t least[1], real_t best[3], real_t cables[3])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) <= TB_C(48.0)
          && TB_ABS(wrench[0]) + TB_ABS(wrench[1]) + TB_ABS(wrench[2]) <= TB_C(240000.0))) {
        rest[0] = TB_C(0.0);
        rest[1] = TB_C(0.0);
        rest[2] = TB_C(0.0);
        least[0] = TB_C(0.0);
        best[0] = TB_C(0.0);
        best[1] = TB_C(0.0);
        best[2] = TB_C(0.0);
        cables[0] = TB_C(0.0);
        cables[1] = TB_C(0.0);
        cables[2] = TB_C(0.0);
        return TB_OUT_OF_DOMAIN;
    }
    rest[0] = wrench[0];
    rest[1] = wrench[1];
    rest[2] = wrench[2];
    least[0] = TB_C(1e+30);
    best[0] = TB_C(0.0);
    best[1] = TB_C(0.0);
    best[2] = TB_C(0.0);
    cables[0] = -TB_C(1.0);
    cables[1] = -TB_C(1.0);
    cables[2] = -TB_C(1.0);
    return TB_OK;
}

/* One subset. */
static tb_status tb_reduced_matrix_tension_visit(const real_t chosen[9], const real_t numbers[3],
    const real_t rest[3], real_t least[1], real_t best[3], real_t cables[3])
{
    const real_t t0 = chosen[4] * chosen[8] - chosen[7] * chosen[5];
    const real_t t1 = chosen[7] * chosen[2] - chosen[8] * chosen[1];
    const real_t t2 = chosen[5] * chosen[1] - chosen[4] * chosen[2];
    const real_t t3 = t0 * chosen[0] + t1 * chosen[3] + t2 * chosen[6];
    const real_t t4 = TB_C(1.0) / t3;
    const real_t t5 = (rest[0] * t0 + rest[1] * t1 + rest[2] * t2) * t4;
    const real_t t6 = rest[0] * (chosen[5] * chosen[6] - chosen[8] * chosen[3]);
    const real_t t7 = rest[1] * (chosen[8] * chosen[0] - chosen[2] * chosen[6]);
    const real_t t8 = rest[2] * (chosen[2] * chosen[3] - chosen[5] * chosen[0]);
    const real_t t9 = t4 * (t6 + t7 + t8);
    const real_t t10 = rest[0] * (chosen[7] * chosen[3] - chosen[4] * chosen[6]);
    const real_t t11 = rest[1] * (chosen[1] * chosen[6] - chosen[7] * chosen[0]);
    const real_t t12 = rest[2] * (chosen[4] * chosen[0] - chosen[1] * chosen[3]);
    const real_t t13 = t4 * (t10 + t11 + t12);
    const real_t t14 = t13 + (t5 + t9);
    const real_t t15 = tb_min(tb_min(t5, t9), t13) + TB_C(16.0) * TB_EPSILON * TB_ABS(t14);
    const real_t t16 = TB_ABS(t3) - tb_max(TB_C(1e-06), TB_EPSILON * TB_C(4096.0));
    const real_t t17 = TB_C(0.0) <= tb_min(t15, t16) ? t14 : TB_C(1e+30);
    const bool t18 = t17 < least[0];
    const real_t least_0 = t18 ? t17 : least[0];
    const real_t best_0 = t18 ? t5 : best[0];
    const real_t best_1 = t18 ? t9 : best[1];
    const real_t best_2 = t18 ? t13 : best[2];
    const real_t cables_0 = t18 ? numbers[0] : cables[0];
    const real_t cables_1 = t18 ? numbers[1] : cables[1];
    const real_t cables_2 = t18 ? numbers[2] : cables[2];
    least[0] = least_0;
    best[0] = best_0;
    best[1] = best_1;
    best[2] = best_2;
    cables[0] = cables_0;
    cables[1] = cables_1;
    cables[2] = cables_2;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_reduced_matrix_tension_finish(const real_t least[1], const real_t best[3],
    const real_t cables[3], real_t tension[4])
{
    const real_t t0 = tb_max(best[0], TB_C(0.0));
    const real_t t1 = tb_max(best[1], TB_C(0.0));
    const real_t t2 = (cables[0] == TB_C(0.0) ? t0 : TB_C(0.0)) + (TB_C(0.0) == cables[1] ? t1
        : TB_C(0.0));
    const real_t t3 = tb_max(best[2], TB_C(0.0));
    const real_t tension_0 = t2 + (TB_C(0.0) == cables[2] ? t3 : TB_C(0.0));
    const real_t t4 = (cables[0] == TB_C(1.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(1.0) ? t1
        : TB_C(0.0));
    const real_t tension_1 = t4 + (cables[2] == TB_C(1.0) ? t3 : TB_C(0.0));
    const real_t t5 = (cables[0] == TB_C(2.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(2.0) ? t1
        : TB_C(0.0));
    const real_t tension_2 = t5 + (cables[2] == TB_C(2.0) ? t3 : TB_C(0.0));
    const real_t t6 = (cables[0] == TB_C(3.0) ? t0 : TB_C(0.0)) + (cables[1] == TB_C(3.0) ? t1
        : TB_C(0.0));
    const real_t tension_3 = t6 + (cables[2] == TB_C(3.0) ? t3 : TB_C(0.0));
    const bool t7 = !(least[0] < TB_C(1e+30));
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    return t7 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_reduced_matrix_tension(const real_t structure[12], const real_t wrench[3],
    real_t tension[4])
{
    static const unsigned char subsets[4][3] = {{0,1,2}, {0,1,3}, {0,2,3}, {1,2,3}};
    real_t rest[3];
    real_t least[1];
    real_t best[3];
    real_t cables[3];
    const tb_status status = tb_reduced_matrix_tension_begin(structure, wrench, rest, least,
        best, cables);
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 4; k++) {
        real_t chosen[9];
        real_t numbers[3];
        for (int j = 0; j < 3; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 3; i++) {
                chosen[3 * i + j] = structure[4 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_reduced_matrix_tension_visit(chosen, numbers, rest, least, best, cables);
    }
    return tb_reduced_matrix_tension_finish(least, best, cables, tension);
}

/* Refuses with a status: most is 0; least is 0; size is 0 N. */
static tb_status tb_refuse_largest_tensions_eq12_begin(tb_status status, real_t most[4],
    real_t least[1], real_t size[1])
{
    most[0] = TB_C(0.0);
    most[1] = TB_C(0.0);
    most[2] = TB_C(0.0);
    most[3] = TB_C(0.0);
    least[0] = TB_C(0.0);
    size[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_largest_tensions_eq12_begin(const real_t structure[12], const real_t force[1],
    real_t most[4], real_t least[1], real_t size[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) <= TB_C(48.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(20000.0))) {
        return tb_refuse_largest_tensions_eq12_begin(TB_OUT_OF_DOMAIN, most, least, size);
    }
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = TB_SQRT(t2);
    const real_t t4 = TB_COPYSIGN(t3, structure[0]);
    const real_t t5 = structure[0] + t4;
    const real_t t6 = t5 * structure[4] + structure[1] * structure[5] + structure[2] *
        structure[6];
    const real_t t7 = TB_C(1.0) / (t3 * (t3 + TB_ABS(structure[0])));
    const real_t t8 = (t6 + structure[3] * structure[7]) * t7;
    const real_t t9 = structure[5] - structure[1] * t8;
    const real_t t10 = structure[6] - structure[2] * t8;
    const real_t t11 = structure[7] - structure[3] * t8;
    const real_t t12 = TB_SQRT(t9 * t9 + t10 * t10 + t11 * t11);
    const real_t t13 = TB_COPYSIGN(t12, t9);
    const real_t t14 = t5 * structure[8] + structure[1] * structure[9] + structure[2] *
        structure[10];
    const real_t t15 = t7 * (t14 + structure[3] * structure[11]);
    const real_t t16 = structure[10] - structure[2] * t15;
    const real_t t17 = (t9 + t13) * (structure[9] - structure[1] * t15) + t10 * t16;
    const real_t t18 = structure[11] - structure[3] * t15;
    const real_t t19 = (t17 + t11 * t18) / (t12 * (t12 + TB_ABS(t9)));
    const real_t t20 = t16 - t10 * t19;
    const real_t t21 = t18 - t11 * t19;
    const real_t t22 = TB_ABS(TB_COPYSIGN(TB_SQRT(t20 * t20 + t21 * t21), t20));
    const bool t23 = !(t0 < TB_ABS(t4) && t0 < TB_ABS(t13) && t0 < t22);
    if (t23) {
        return tb_refuse_largest_tensions_eq12_begin(TB_SINGULAR, most, least, size);
    }
    most[0] = TB_C(0.0);
    most[1] = TB_C(0.0);
    most[2] = TB_C(0.0);
    most[3] = TB_C(0.0);
    least[0] = TB_C(1e+30);
    size[0] = force[0];
    return TB_OK;
}

/* One subset. */
static tb_status tb_largest_tensions_eq12_visit(const real_t chosen[6], const real_t numbers[2],
    const real_t structure[12], real_t most[4], real_t least[1])
{
    const bool t0 = (numbers[0] == TB_C(0.0)) || (TB_C(0.0) == numbers[1]);
    const real_t t1 = chosen[2] * chosen[5] - chosen[4] * chosen[3];
    const real_t t2 = chosen[4] * chosen[1] - chosen[5] * chosen[0];
    const real_t t3 = chosen[3] * chosen[0] - chosen[2] * chosen[1];
    const real_t t4 = chosen[0] * chosen[0] + chosen[2] * chosen[2] + chosen[4] * chosen[4];
    const real_t t5 = (t1 * chosen[0] + chosen[2] * t2 + chosen[4] * t3) / t4;
    const real_t t6 = t1 - chosen[0] * t5;
    const real_t t7 = t2 - chosen[2] * t5;
    const real_t t8 = t3 - chosen[4] * t5;
    const real_t t9 = TB_SQRT(t6 * t6 + t7 * t7 + t8 * t8);
    const real_t t10 = TB_C(1.0) / t9;
    const real_t t11 = t6 * t10;
    const real_t t12 = t7 * t10;
    const real_t t13 = t8 * t10;
    const real_t t14 = t11 * structure[0] + t12 * structure[4] + t13 * structure[8];
    const real_t t15 = t0 ? TB_C(1e+30) : TB_ABS(t0 ? TB_C(0.0) : t14);
    const real_t most_0 = tb_max(most[0], TB_C(1.0) / t15);
    const bool t16 = (numbers[0] == TB_C(1.0)) || (numbers[1] == TB_C(1.0));
    const real_t t17 = t11 * structure[1] + t12 * structure[5] + t13 * structure[9];
    const real_t t18 = t16 ? TB_C(1e+30) : TB_ABS(t16 ? TB_C(0.0) : t17);
    const real_t most_1 = tb_max(most[1], TB_C(1.0) / t18);
    const bool t19 = (numbers[0] == TB_C(2.0)) || (numbers[1] == TB_C(2.0));
    const real_t t20 = t11 * structure[2] + t12 * structure[6] + t13 * structure[10];
    const real_t t21 = t19 ? TB_C(1e+30) : TB_ABS(t19 ? TB_C(0.0) : t20);
    const real_t most_2 = tb_max(most[2], TB_C(1.0) / t21);
    const bool t22 = (numbers[0] == TB_C(3.0)) || (numbers[1] == TB_C(3.0));
    const real_t t23 = t11 * structure[3] + t12 * structure[7] + t13 * structure[11];
    const real_t t24 = t22 ? TB_C(1e+30) : TB_ABS(t22 ? TB_C(0.0) : t23);
    const real_t most_3 = tb_max(most[3], TB_C(1.0) / t24);
    const bool t25 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON) < t9;
    const real_t t26 = t25 ? tb_min(tb_min(tb_min(t15, t18), t21), t24) : TB_C(0.0);
    const real_t least_0 = tb_min(least[0], t26);
    most[0] = most_0;
    most[1] = most_1;
    most[2] = most_2;
    most[3] = most_3;
    least[0] = least_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_largest_tensions_eq12_finish(const real_t most[4], const real_t least[1],
    const real_t size[1], real_t tension[4])
{
    const real_t tension_0 = size[0] * most[0];
    const real_t tension_1 = size[0] * most[1];
    const real_t tension_2 = size[0] * most[2];
    const real_t tension_3 = size[0] * most[3];
    const bool t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON) < least[0];
    const bool t1 = !t0;
    if (t1) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        return TB_SINGULAR;
    }
    tension[0] = tension_0;
    tension[1] = tension_1;
    tension[2] = tension_2;
    tension[3] = tension_3;
    return TB_OK;
}

tb_status tb_largest_tensions_eq12(const real_t structure[12], const real_t force[1],
    real_t tension[4])
{
    static const unsigned char subsets[6][2] = {{0,1}, {0,2}, {0,3}, {1,2}, {1,3}, {2,3}};
    real_t most[4];
    real_t least[1];
    real_t size[1];
    const tb_status status = tb_largest_tensions_eq12_begin(structure, force, most, least,
        size);
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        tension[1] = TB_C(0.0);
        tension[2] = TB_C(0.0);
        tension[3] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 6; k++) {
        real_t chosen[6];
        real_t numbers[2];
        for (int j = 0; j < 2; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 3; i++) {
                chosen[2 * i + j] = structure[4 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_largest_tensions_eq12_visit(chosen, numbers, structure, most, least);
    }
    return tb_largest_tensions_eq12_finish(most, least, size, tension);
}

/* Refuses with a status: most is 0 N; size is 0 N. */
static tb_status tb_refuse_largest_tension_begin(tb_status status, real_t most[1],
    real_t size[1])
{
    most[0] = TB_C(0.0);
    size[0] = TB_C(0.0);
    return status;
}

/* Before the first subset. */
static tb_status tb_largest_tension_begin(const real_t structure[12], const real_t force[1],
    real_t most[1], real_t size[1])
{
    if (!(TB_ABS(structure[0]) + TB_ABS(structure[1]) + TB_ABS(structure[2]) +
              TB_ABS(structure[3]) + TB_ABS(structure[4]) + TB_ABS(structure[5]) +
              TB_ABS(structure[6]) + TB_ABS(structure[7]) + TB_ABS(structure[8]) +
              TB_ABS(structure[9]) + TB_ABS(structure[10]) + TB_ABS(structure[11]) <= TB_C(48.0)
          && force[0] >= TB_C(0.0) && force[0] <= TB_C(20000.0))) {
        return tb_refuse_largest_tension_begin(TB_OUT_OF_DOMAIN, most, size);
    }
    const real_t t0 = tb_max(TB_C(1e-06), TB_C(4096.0) * TB_EPSILON);
    const real_t t1 = structure[0] * structure[0] + structure[1] * structure[1];
    const real_t t2 = t1 + structure[2] * structure[2] + structure[3] * structure[3];
    const real_t t3 = TB_SQRT(t2);
    const real_t t4 = TB_COPYSIGN(t3, structure[0]);
    const real_t t5 = structure[0] + t4;
    const real_t t6 = t5 * structure[4] + structure[1] * structure[5] + structure[2] *
        structure[6];
    const real_t t7 = TB_C(1.0) / (t3 * (t3 + TB_ABS(structure[0])));
    const real_t t8 = (t6 + structure[3] * structure[7]) * t7;
    const real_t t9 = structure[5] - structure[1] * t8;
    const real_t t10 = structure[6] - structure[2] * t8;
    const real_t t11 = structure[7] - structure[3] * t8;
    const real_t t12 = TB_SQRT(t9 * t9 + t10 * t10 + t11 * t11);
    const real_t t13 = TB_COPYSIGN(t12, t9);
    const real_t t14 = t5 * structure[8] + structure[1] * structure[9] + structure[2] *
        structure[10];
    const real_t t15 = t7 * (t14 + structure[3] * structure[11]);
    const real_t t16 = structure[10] - structure[2] * t15;
    const real_t t17 = (t9 + t13) * (structure[9] - structure[1] * t15) + t10 * t16;
    const real_t t18 = structure[11] - structure[3] * t15;
    const real_t t19 = (t17 + t11 * t18) / (t12 * (t12 + TB_ABS(t9)));
    const real_t t20 = t16 - t10 * t19;
    const real_t t21 = t18 - t11 * t19;
    const real_t t22 = TB_ABS(TB_COPYSIGN(TB_SQRT(t20 * t20 + t21 * t21), t20));
    const bool t23 = !(t0 < TB_ABS(t4) && t0 < TB_ABS(t13) && t0 < t22);
    if (t23) {
        return tb_refuse_largest_tension_begin(TB_SINGULAR, most, size);
    }
    most[0] = TB_C(0.0);
    size[0] = force[0];
    return TB_OK;
}

/* One subset. */
static tb_status tb_largest_tension_visit(const real_t chosen[6], const real_t numbers[2],
    const real_t structure[12], real_t most[1], const real_t size[1])
{
    const real_t t0 = chosen[2] * chosen[5] - chosen[4] * chosen[3];
    const real_t t1 = chosen[4] * chosen[1] - chosen[5] * chosen[0];
    const real_t t2 = chosen[3] * chosen[0] - chosen[2] * chosen[1];
    const real_t t3 = chosen[0] * chosen[0] + chosen[2] * chosen[2] + chosen[4] * chosen[4];
    const real_t t4 = (t0 * chosen[0] + chosen[2] * t1 + chosen[4] * t2) / t3;
    const real_t t5 = t0 - chosen[0] * t4;
    const real_t t6 = t1 - chosen[2] * t4;
    const real_t t7 = t2 - chosen[4] * t4;
    const real_t t8 = TB_SQRT(t5 * t5 + t6 * t6 + t7 * t7);
    real_t most_0;
    if (TB_C(16.0) * TB_EPSILON < t8) {
        const real_t t9 = TB_EPSILON * TB_C(64.0);
        const bool t10 = (numbers[0] == TB_C(0.0)) || (TB_C(0.0) == numbers[1]);
        const real_t t11 = TB_C(1.0) / t8;
        const real_t t12 = t5 * t11;
        const real_t t13 = t6 * t11;
        const real_t t14 = t7 * t11;
        const real_t t15 = t12 * structure[0] + t13 * structure[4] + t14 * structure[8];
        const real_t t16 = t10 ? TB_C(0.0) : t15;
        const bool t17 = (numbers[0] == TB_C(1.0)) || (numbers[1] == TB_C(1.0));
        const real_t t18 = t12 * structure[1] + t13 * structure[5] + t14 * structure[9];
        const real_t t19 = t17 ? TB_C(0.0) : t18;
        const bool t20 = (numbers[0] == TB_C(2.0)) || (numbers[1] == TB_C(2.0));
        const real_t t21 = t12 * structure[2] + t13 * structure[6] + t14 * structure[10];
        const real_t t22 = t20 ? TB_C(0.0) : t21;
        const bool t23 = (numbers[0] == TB_C(3.0)) || (numbers[1] == TB_C(3.0));
        const real_t t24 = t12 * structure[3] + t13 * structure[7] + t14 * structure[11];
        const real_t t25 = t23 ? TB_C(0.0) : t24;
        const real_t t26 = TB_ABS(t16) + TB_ABS(t19) + TB_ABS(t22) + TB_ABS(t25);
        const real_t t27 = t25 + (t22 + (t16 + t19));
        const real_t t28 = (t26 + t27) * TB_C(0.5);
        const real_t t29 = t9 < size[0] ? TB_C(1e+30) : TB_C(0.0);
        real_t t30;
        if (t9 < t28) {
            t30 = size[0] / t28;
        } else {
            t30 = t29;
        }
        const real_t t31 = TB_C(0.5) * (t26 - t27);
        real_t t32;
        if (t9 < t31) {
            t32 = size[0] / t31;
        } else {
            t32 = t29;
        }
        most_0 = tb_max(most[0], tb_max(t30, t32));
    } else {
        most_0 = most[0];
    }
    most[0] = most_0;
    return TB_OK;
}

/* After the last subset. */
static tb_status tb_largest_tension_finish(const real_t most[1], real_t tension[1])
{
    const bool t0 = most[0] < TB_C(1e+30);
    const real_t tension_0 = t0 ? most[0] : TB_C(0.0);
    const bool t1 = !t0;
    tension[0] = tension_0;
    return t1 ? TB_INFEASIBLE : TB_OK;
}

tb_status tb_largest_tension(const real_t structure[12], const real_t force[1],
    real_t tension[1])
{
    static const unsigned char subsets[6][2] = {{0,1}, {0,2}, {0,3}, {1,2}, {1,3}, {2,3}};
    real_t most[1];
    real_t size[1];
    const tb_status status = tb_largest_tension_begin(structure, force, most, size);
    if (status != TB_OK) {
        tension[0] = TB_C(0.0);
        return status;
    }
    for (int k = 0; k < 6; k++) {
        real_t chosen[6];
        real_t numbers[2];
        for (int j = 0; j < 2; j++) {
            const int number = subsets[k][j];
            for (int i = 0; i < 3; i++) {
                chosen[2 * i + j] = structure[4 * i + number];
            }
            numbers[j] = (real_t)number;
        }
        (void)tb_largest_tension_visit(chosen, numbers, structure, most, size);
    }
    return tb_largest_tension_finish(most, tension);
}

